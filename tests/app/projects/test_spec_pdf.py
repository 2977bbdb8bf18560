"""The delivery spec as a page: every rule of it in words, and what people wrote never as markup."""

import json
from typing import Any

import pytest

import audio_checks
from app.projects import spec_pdf
from tests.support.server import World


@pytest.fixture
def content(monkeypatch: pytest.MonkeyPatch) -> Any:
    """Return what is laid out for a spec's text; the typesetting itself is tried over HTTP below."""

    def of(toml: str, title: str = "Game") -> dict[str, Any]:
        said: list[str] = []
        monkeypatch.setattr(spec_pdf, "typeset", lambda _, inputs: said.append(inputs["spec"]) or b"")
        spec_pdf.spec_pdf(audio_checks.parse_spec(toml), title=title, version=2)
        return dict(json.loads(said[0]))

    return of


def test_every_rule_is_named_with_its_unit(content: Any) -> None:
    rules = dict(content(audio_checks.new_spec())["rules"])
    assert rules["Sample rate"] == "44,100, 48,000 or 96,000 Hz"
    assert rules["Bit depth"] == "16 or 24 bit"
    assert rules["Length"] == "at least 0.01, at most 30 s"
    assert rules["True peak"] == "\N{MINUS SIGN}1 dBTP"
    assert rules["A warning only"] == "true peak, head silence, tail silence"


def test_a_category_says_what_differs_and_nothing_else(content: Any) -> None:
    categories = dict(content(audio_checks.new_spec())["categories"])
    assert categories["ambience"] == "Length: at least 0.01, at most 300 s"
    assert "ui" not in categories


def test_targets_are_named(content: Any) -> None:
    targets = dict(content(audio_checks.new_spec())["targets"])
    assert targets["game"] == "44,100 Hz, 16 bit, pcm, channels of the master"
    assert targets["handheld"] == "22,050 Hz, 16 bit, mono"


@pytest.mark.parametrize("title", ['#import "/etc/passwd"', "*bold* $x$ \\ `", "x" * 5_000, ""])
def test_a_page_is_made_and_a_title_is_no_markup(title: str) -> None:
    spec = audio_checks.parse_spec(audio_checks.new_spec())
    made = spec_pdf.spec_pdf(spec, title=title, version=1)
    assert made.startswith(b"%PDF")
    assert made == spec_pdf.spec_pdf(spec, title=title, version=1)


def test_designer_and_team_read_it_and_a_stranger_does_not(world: World) -> None:
    url = f"/v1/projects/{world.project_id}/spec.pdf"
    for client in (world.designer, world.producer):
        answer = client.get(url)
        assert (answer.status_code, answer.headers["content-type"]) == (200, "application/pdf")
        assert answer.content.startswith(b"%PDF")
    assert world.stranger.get(url).status_code == 404
