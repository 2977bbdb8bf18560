import json
from typing import Any
from uuid import UUID

import pytest
from httpx import Response
from sqlalchemy.orm import Session

import audio_checks
from app.accounts.rules import Scope
from app.core.events import publish
from app.projects import service, tokens
from app.projects.errors import ProjectNotFound
from tests.support.server import RunningServer, World


def spec_path(world: World, rest: str = "") -> str:
    return f"/v1/projects/{world.project_id}/spec{rest}"


def current(world: World) -> dict[str, Any]:
    answer: dict[str, Any] = world.producer.get(spec_path(world)).json()
    return answer


def save(world: World, toml: str, based_on_version: int = 1) -> Response:
    return world.producer.put(spec_path(world), json={"toml": toml, "based_on_version": based_on_version})


@pytest.fixture
def published(monkeypatch: pytest.MonkeyPatch) -> list[tuple[str, dict[str, Any]]]:
    """The events that the room published; they are still published."""
    reported: list[tuple[str, dict[str, Any]]] = []

    def record_event(session: Session, event: str, **facts: Any) -> UUID:
        reported.append((event, facts))
        return publish(session, event, **facts)

    monkeypatch.setattr(service, "publish", record_event)
    return reported


def test_the_spec_comes_as_text_as_tables_and_resolved(world: World) -> None:
    spec = current(world)
    assert spec["version"] == 1
    assert spec["author"]["name"] == "Producer"
    assert spec["tables"]["limits"]["head_silence_ms"] == 5
    assert spec["resolved"]["limits"]["loudness_lufs"] == {"min": None, "max": None}
    assert spec["resolved"]["targets"]["handheld"] == {
        "name": "handheld",
        "sample_rate_hz": 22_050,
        "bit_depth": 16,
        "encoding": "pcm",
        "quality": None,
        "channels": 1,
        "dither": "tpdf",
        "over_peak": "attenuate",
    }
    assert spec["resolved"]["checks"]["true-peak"] == "warning"
    assert "vo" in spec["resolved"]["categories"]
    assert spec["warnings"] == []
    assert spec["sha256"] == audio_checks.parse_spec(spec["toml"]).sha256


def test_the_designer_reads_it_and_does_not_write_it(world: World) -> None:
    assert world.designer.get(spec_path(world)).status_code == 200
    body = {"toml": current(world)["toml"], "based_on_version": 1}
    assert world.designer.put(spec_path(world), json=body).json()["code"] == "team-needed"
    assert world.reviewer.put(spec_path(world), json=body).json()["code"] == "team-needed"
    assert world.approver.put(spec_path(world), json=body).status_code == 200  # an audio lead acts for the team
    for browser in (world.stranger, world.other_designer):
        assert browser.get(spec_path(world)).status_code == 404
        assert browser.put(spec_path(world), json=body).status_code == 404


def test_a_new_version_is_kept_beside_the_old(world: World, published: list[tuple[str, dict[str, Any]]]) -> None:
    first = current(world)
    toml = first["toml"].replace("tail_silence_ms = 250 ", "tail_silence_ms = 400 ")
    body = {"toml": toml, "note": "Longer tails.", "based_on_version": 1}
    saved = world.producer.put(spec_path(world), json=body).json()
    assert (saved["version"], saved["note"]) == (2, "Longer tails.")
    assert saved["resolved"]["limits"]["tail_silence_ms"] == 400
    assert saved["toml"] == toml  # to the letter, comments too
    assert world.producer.get(spec_path(world, "/versions/1")).json()["toml"] == first["toml"]
    versions = world.designer.get(spec_path(world, "/versions")).json()
    assert [version["version"] for version in versions["items"]] == [2, 1]
    assert world.producer.get(spec_path(world, "/versions/3")).json()["code"] == "spec-version-not-found"
    assert world.producer.get(spec_path(world, "/versions/0")).status_code == 422
    assert world.producer.get(spec_path(world, "/versions/99999999999999999999")).status_code == 422
    reported = {"studio_id": world.studio_id, "project_id": world.project_id, "version": 2}
    reported["person_id"] = world.producer_id
    assert published == [("spec.changed", reported)]


def test_what_says_the_same_asks_nobody_to_check_again(
    world: World, published: list[tuple[str, dict[str, Any]]]
) -> None:
    toml = current(world)["toml"]
    assert save(world, toml).json()["version"] == 1  # nothing changed: no version
    assert save(world, toml + "\n# A remark.\n").json()["version"] == 2
    assert published == []


CATEGORY = """
[categories.c{number}]
kind = 'voice'
accept = {{ channels = [1], duration_s = {{ max = {number}.5 }} }}
limits = {{ true_peak_dbtp = -3.0, head_silence_ms = {number}, tail_silence_ms = 100 }}
naming.pattern = 'c{number}_[a-z0-9]+(_[a-z0-9]+)*'
targets.game.channels = 1
checks = {{ true-peak = 'error', head-silence = 'warning' }}
"""


@pytest.mark.slow
def test_60_categories_are_saved_as_text_and_by_the_form(world: World) -> None:
    toml = "format = 1\nname = 'Large'\n[targets.game]\nsample_rate_hz = 44100\nbit_depth = 16\n[files]\n"
    toml += "".join(f"'c{number}/**' = 'c{number}'\n" for number in range(1, 61))
    toml += "".join(CATEGORY.format(number=number) for number in range(1, 61))
    answer = save(world, toml)
    assert answer.status_code == 200, answer.text
    tables = current(world)["tables"]
    tables["categories"]["c60"]["limits"]["head_silence_ms"] = 61
    body = {"tables": tables, "based_on_version": 2}
    assert world.producer.post(spec_path(world, "/form"), json=body).status_code == 200
    saved = current(world)
    assert len(saved["resolved"]["categories"]) == 60
    assert audio_checks.parse_spec(saved["toml"]).for_category("c60").limits.head_silence_ms == 61


def test_two_editors_notice_each_other(world: World) -> None:
    toml = current(world)["toml"]
    assert save(world, toml.replace("head_silence_ms = 5", "head_silence_ms = 9")).status_code == 200
    answer = save(world, toml.replace("head_silence_ms = 5", "head_silence_ms = 7"))
    assert (answer.status_code, answer.json()["code"]) == (409, "spec-changed")
    assert current(world)["resolved"]["limits"]["head_silence_ms"] == 9


@pytest.mark.parametrize(
    ("toml", "where"),
    [
        ("", "format"),
        ("format = 2", "format"),
        ("format = 1\n[limits]\nsample_peak_dbfs = 'loud'", "limits.sample_peak_dbfs"),
        ("format = 1\n[limits]\nsample_peek_dbfs = -1.0", "limits.sample_peek_dbfs"),
        ("format = 1\n[targets.game]\nsample_rate_hz = 44100", "targets.game.bit_depth"),
        ("format = 1\n[categories.vo.limits]\nhead_silence_ms = 'x'", "categories.vo.limits.head_silence_ms"),
        ("format = 1\nextend = '/etc/passwd'", "extend"),
        ("format = ", ""),
        ("format = 1\n[limits]\nsample_peak_dbfs = " + "9" * 400, ""),
        ("format = 1\n[limits]\nsample_peak_dbfs = " + "9" * 5000, ""),
        ("format = 1\n[limits]\ntrue_peak_dbtp = nan", "limits.true_peak_dbtp"),
    ],
)
def test_an_invalid_spec_is_refused_with_its_place(world: World, toml: str, where: str) -> None:
    answer = save(world, toml)
    assert (answer.status_code, answer.json()["code"]) == (422, "bad-spec")
    assert answer.json()["errors"][0]["where"] == where
    assert current(world)["version"] == 1
    tried = world.producer.post(spec_path(world, "/check-toml"), json={"toml": toml})
    assert tried.json()["errors"] == answer.json()["errors"]


def test_the_form_says_the_same_as_the_text(world: World) -> None:
    spec = current(world)
    tables = spec["tables"]
    tables["limits"]["loudness_lufs"] = {"min": None, "max": -12.0}
    tables["limits"]["dc_offset_percent"] = None  # left empty: not limited
    tables["naming"]["pattern"] = '[a-z]+(_"\\d+")?'
    body = {"tables": tables, "note": "By form.", "based_on_version": 1}
    saved = world.producer.post(spec_path(world, "/form"), json=body).json()
    assert saved["version"] == 2
    assert saved["resolved"]["limits"]["loudness_lufs"] == {"min": None, "max": -12.0}
    assert saved["resolved"]["limits"]["dc_offset_percent"] is None
    assert saved["resolved"]["naming"]["pattern"] == '[a-z]+(_"\\d+")?'
    assert saved["resolved"]["targets"] == spec["resolved"]["targets"]
    assert audio_checks.parse_spec(saved["toml"]).sha256 == saved["sha256"]


def deep(levels: int) -> dict[str, Any]:
    tables: dict[str, Any] = {}
    for _ in range(levels):
        tables = {"a": tables}
    return tables


@pytest.mark.parametrize(
    "tables",
    [
        {},
        {"format": 1, "limits": {"sample_peak_dbfs": True}},
        {"format": 1, "limits": {"sample_peak_dbfs": 10**400}},
        {"format": 1, "limits": [1, 2]},
        {"format": 1, "accept": {"duration_s": {"min": "long"}}},
        {"format": 1, "name": "a\x00b\n[limits]\nhead_silence_ms = 1"},
        {"format": 1, 'x"]\n[limits': {"head_silence_ms": 1}},
        {"format": 1, "name": "\ud800"},
        {"format": 1, "accept": {"containers": [None, {"a": None}]}},
        {"format": 1, "a": deep(80)},
    ],
    ids=range(10),
)
def test_a_form_without_a_valid_spec_is_refused_with_a_reason(world: World, tables: dict[str, Any]) -> None:
    answer = world.producer.post(
        spec_path(world, "/form"),
        content=json.dumps({"tables": tables, "based_on_version": 1}),
        headers={"Content-Type": "application/json"},
    )
    assert answer.status_code in (200, 422)
    if answer.status_code == 200:  # a control character in a name is quoted, and stays a name
        assert answer.json()["tables"]["name"] == tables["name"]
        assert "head_silence_ms" not in answer.json()["tables"].get("limits", {})
        return
    assert answer.json()["code"] in ("bad-spec", "invalid-request", "unstorable")


def test_a_try_saves_nothing(world: World) -> None:
    toml = "format = 1\n[accept]\nsample_rates_hz = [22050]\n[targets.game]\nsample_rate_hz = 44100\nbit_depth = 16\n"
    tried = world.designer.post(spec_path(world, "/check-toml"), json={"toml": toml}).json()
    assert "22050 Hz" in tried["warnings"][0]
    again = world.designer.post(spec_path(world, "/check-toml"), json={"tables": tried["tables"]}).json()
    assert again["sha256"] == tried["sha256"]
    assert world.designer.post(spec_path(world, "/check-toml"), json={}).status_code == 422
    assert world.stranger.post(spec_path(world, "/check-toml"), json={"toml": toml}).status_code == 404
    assert current(world)["version"] == 1


def test_ci_fetches_the_spec_with_its_token(server: RunningServer, world: World) -> None:
    build = server.browser()
    made = world.producer.post(
        f"/v1/projects/{world.project_id}/tokens", json={"name": "CI", "scopes": ["spec:read"]}
    ).json()
    build.headers["Authorization"] = f"Bearer {made['secret']}"
    answer = build.get(spec_path(world, ".toml"))
    assert answer.headers["content-type"].startswith("text/plain")
    assert answer.text == current(world)["toml"]
    unchanged = build.get(spec_path(world, ".toml"), headers={"If-None-Match": f'"other", {answer.headers["ETag"]}'})
    assert (unchanged.status_code, unchanged.content) == (304, b"")
    save(world, answer.text.replace("head_silence_ms = 5", "head_silence_ms = 9"))
    changed = build.get(spec_path(world, ".toml"), headers={"If-None-Match": answer.headers["ETag"]})
    assert changed.status_code == 200
    assert "head_silence_ms = 9" in changed.text


def test_a_token_opens_its_own_project_and_scope_only(server: RunningServer, world: World) -> None:
    another = World(server)
    build = server.browser()
    tokens = f"/v1/projects/{world.project_id}/tokens"
    made = world.producer.post(tokens, json={"name": "CI", "scopes": ["list:read"]}).json()
    build.headers["Authorization"] = f"Bearer {made['secret']}"
    assert build.get(spec_path(world, ".toml")).json()["code"] == "scope-missing"
    made = world.producer.post(tokens, json={"name": "CI", "scopes": ["spec:read"]}).json()
    build.headers["Authorization"] = f"Bearer {made['secret']}"
    assert build.get(spec_path(another, ".toml")).status_code == 404
    assert build.get(f"/v1/projects/{world.project_id}").json()["code"] == "person-needed"
    assert build.get("/v1/projects").json()["code"] == "person-needed"


@pytest.mark.slow
def test_tokens_are_the_producers_and_shown_once(world: World) -> None:
    tokens = f"/v1/projects/{world.project_id}/tokens"
    body = {"name": "CI", "scopes": ["spec:read", "list:read", "spec:read"]}
    made = world.producer.post(tokens, json=body, headers={"Idempotency-Key": "one"}).json()
    assert made["secret"].startswith("slt_")
    assert made["scopes"] == ["list:read", "spec:read"]
    (listed,) = world.producer.get(tokens).json()
    assert "secret" not in listed
    assert (listed["name"], listed["creator"]["name"], listed["last_used_at"]) == ("CI", "Producer", None)
    assert world.approver.get(tokens).status_code == world.designer.post(tokens, json=body).status_code == 403
    assert world.stranger.get(tokens).status_code == 404
    assert world.producer.post(tokens, json={"name": "CI", "scopes": []}).status_code == 422
    another = World(world.server)
    assert another.producer.delete(f"/v1/projects/{another.project_id}/tokens/{made['id']}").status_code == 404
    assert world.producer.delete(f"{tokens}/{made['id']}").status_code == 204
    assert world.producer.get(tokens).json()[0]["revoked_at"] is not None


def test_the_command_line_issues_a_token_too(server: RunningServer, world: World) -> None:
    with server.runtime.database.writing() as session:
        secret = tokens.issue_token(session, world.project_id, name="CI", scopes=[Scope.SPEC_READ])
        with pytest.raises(ProjectNotFound):
            tokens.issue_token(session, world.studio_id, name="CI", scopes=[Scope.SPEC_READ])
    build = server.browser()
    build.headers["Authorization"] = f"Bearer {secret}"
    assert build.get(spec_path(world)).json()["version"] == 1
