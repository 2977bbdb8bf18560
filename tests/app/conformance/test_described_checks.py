"""The checks as forms show them: nothing of a check is stated outside its own file."""

import json
from pathlib import Path

import pytest

import audio_checks
from tests.support.added_check import copy_with_check, run
from tests.support.described_checks import described
from tests.support.server import World

ROOT = Path(__file__).resolve().parents[3]


def test_everyone_reads_them(world: World):
    answer = world.server.browser().get("/v1/checks")
    assert answer.status_code == 200
    checks = {check["name"]: check for check in answer.json()}
    assert list(checks) == list(audio_checks.all_checks())
    assert checks["true-peak"]["limits"] == [
        {
            "key": "true_peak_dbtp",
            "label": "True peak",
            "unit": "dBTP",
            "least": -200.0,
            "greatest": 60.0,
            "is_range": False,
            "usual": None,
        }
    ]
    assert checks["duplicate"]["may_return"] is False
    assert checks["loudness"]["limits"][0]["is_range"] is True


def test_every_limit_of_a_spec_is_one_checks():
    limits = [limit for check in audio_checks.all_checks().values() for limit in check.limits]
    keys = [limit.key for limit in limits]
    assert len(set(keys)) == len(keys)
    assert set(vars(audio_checks.parse_spec("format = 1").limits)) - {"others"} == set(keys)
    assert all(limit.unit for limit in limits)


def test_the_tests_of_pages_are_given_what_the_server_says():
    given = json.loads((ROOT / "frontend/src/test/checks.json").read_text())
    assert given == json.loads(described()), "run: make openapi"


@pytest.mark.slow
def test_a_check_that_is_added_is_in_the_form_of_the_spec(tmp_path: Path):
    copy_with_check(tmp_path)
    said = run(tmp_path, "-c", "from tests.support.described_checks import described; print(described())")
    assert said.returncode == 0, said.stderr
    added = next(check for check in json.loads(said.stdout) if check["name"] == "long-crest")
    assert (added["label"], added["severity"], added["may_return"]) == ("Tall peaks", "warning", True)
    assert added["how_to_fix"] == "use a limiter."
    assert added["limits"] == [
        {
            "key": "crest_db",
            "label": "Crest factor",
            "unit": "dB",
            "least": 0.0,
            "greatest": 60.0,
            "is_range": False,
            "usual": None,
        }
    ]
