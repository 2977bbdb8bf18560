"""Every take is judged once against what the spec asks, whatever the file does to its checker."""

from collections.abc import Callable
from pathlib import Path
from typing import Any
from uuid import UUID

import pytest
from sqlalchemy import func, select

import audio_checks
from app.conformance import checking, queries
from app.conformance.jobs import recheck_takes
from app.conformance.models import CheckRun
from app.conformance.workspaces import SandboxPool
from app.core import kill_points
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.deliveries.take_states import change_state
from app.renders import take_jobs
from app.renders.take_jobs import prepare_take
from tests.support import hostile
from tests.support.blobs import blob_file
from tests.support.deliver import add_cues, checked, deliver
from tests.support.server import World
from tests.support.waves import join, silence, sine, wav_bytes


def tone(dbfs: float = -6.0, hz: float = 440.0) -> bytes:
    """A sound that conforms to a new project's spec, where it is not too loud."""
    return wav_bytes(sine(hz=hz, dbfs=dbfs, seconds=0.1))


def codes(check: dict[str, Any], severity: str = "error") -> list[str]:
    return [finding["code"] for finding in check["findings"] if finding["severity"] == severity]


def save_spec(world: World, change: Callable[[str], str]) -> int:
    """Save a new version of the spec as its producer, and return its number."""
    path = f"/v1/projects/{world.project_id}/spec"
    now = world.producer.get(path).json()
    body = {"toml": change(now["toml"]), "note": "", "based_on_version": now["version"]}
    saved = world.producer.put(path, json=body)
    assert saved.status_code == 200, saved.text
    world.server.wait_for_jobs()
    return int(saved.json()["version"])


def runs(world: World, take_id: str) -> list[CheckRun]:
    with world.server.runtime.database.reading() as session:
        found = session.scalars(select(CheckRun).where(CheckRun.take_id == UUID(take_id)).order_by(CheckRun.id)).all()
        session.expunge_all()
        return list(found)


@pytest.fixture
def tried(monkeypatch: pytest.MonkeyPatch) -> list[Callable[..., Any]]:
    """Every call that was made in a child."""
    call, calls = audio_checks.SandboxChild.call, list[Callable[..., Any]]()

    def counted(child: audio_checks.SandboxChild, work: Callable[..., Any], *given: Any, **options: Any) -> Any:
        calls.append(work)
        return call(child, work, *given, **options)

    monkeypatch.setattr(audio_checks.SandboxChild, "call", counted)
    return calls


@pytest.mark.slow
def test_a_conforming_take(world: World) -> None:
    [cue] = add_cues(world, {"name": "Laser fire", "duration_s": 0.1})
    take = deliver(world, "laser_fire.wav", tone())
    found = checked(world, take["id"], by=world.approver)
    assert (found["state"], found["verdict"], codes(found)) == ("conforming", "conforming", [])
    assert found["facts"]["sample_rate_hz"] == 48_000
    assert found["measurements"]["sample_peak_dbfs"] == pytest.approx(-6.0, abs=0.01)
    assert (found["spec_version"], found["is_newest_spec"], found["waiver"]) == (1, True, None)
    assert cue["id"] == take["cue"]["id"]


@pytest.mark.slow
def test_a_returned_take_says_what_where_and_how_to_fix_it(world: World) -> None:
    add_cues(world, {"name": "Airlock cycle"})
    late_start = join(silence(seconds=0.05), sine(hz=440, dbfs=0.0, seconds=0.2))
    found = checked(world, deliver(world, "airlock_cycle.wav", wav_bytes(late_start))["id"])
    assert (found["state"], found["verdict"]) == ("returned", "rejected")
    [peak] = [finding for finding in found["findings"] if finding["check"] == "sample-peak"]
    assert (peak["limit"], peak["unit"], peak["waived"]) == (-0.1, "dBFS", False)
    assert peak["measured"] == pytest.approx(0.0, abs=0.01)
    assert peak["fix"]
    assert peak["start_s"] >= 0.05
    assert any(finding["check"] == "head-silence" for finding in found["findings"])


@pytest.mark.slow
def test_before_the_check_there_is_nothing_to_show(world: World) -> None:
    take = deliver(world, "laser.wav", tone())
    world.server.wait_for_jobs()

    def forget(session: Any) -> None:
        session.query(CheckRun).filter_by(take_id=UUID(take["id"])).delete()

    world.server.in_database(forget)
    answer = world.designer.get(f"/v1/takes/{take['id']}/check")
    assert (answer.status_code, answer.json()["code"]) == (404, "check-not-found")


@pytest.mark.slow
def test_a_file_dropped_on_a_cue_is_judged_under_the_cues_name(world: World) -> None:
    [cue] = add_cues(world, {"name": "Laser fire"})
    stray = checked(world, deliver(world, "My Laser (final).wav", tone())["id"])
    assert (stray["state"], codes(stray)) == ("conforming", [])  # it is named once a person says which cue it is for
    dropped = checked(world, deliver(world, "My Laser (final).wav", tone(), cue_id=cue["id"])["id"])
    assert (dropped["state"], codes(dropped)) == ("conforming", [])


@pytest.mark.slow
@pytest.mark.parametrize("what", [hostile.crash, hostile.hang, hostile.eat_memory])
def test_what_its_checker_cannot_survive_is_unjudged_after_three_tries(
    world: World,
    monkeypatch: pytest.MonkeyPatch,
    tried: list[Callable[..., Any]],
    what: Callable[..., Any],
) -> None:
    monkeypatch.setattr(audio_checks, "check_file", what)
    sandbox = audio_checks.Sandbox(preload=("numpy", "audio_checks", hostile.__name__))
    children = SandboxPool(sandbox)
    monkeypatch.setattr(take_jobs, "children", lambda: children)
    monkeypatch.setattr(checking, "time_for", lambda _bytes: 1.0)
    take = deliver(world, "laser.wav", tone(hz=200 + len(what.__name__)))
    found = checked(world, take["id"])
    assert tried.count(what) == 3
    assert (found["state"], found["verdict"]) == ("unjudged", "unjudged")
    [finding] = found["findings"]
    assert "that is not the file's fault" in finding["message"]
    assert "our fault" in finding["fix"]
    monkeypatch.undo()
    again = world.designer.post(f"/v1/takes/{take['id']}/recheck")
    assert (again.status_code, again.json()["state"]) == (202, "received")
    assert checked(world, take["id"])["verdict"] == "conforming"
    sandbox.close()


def test_a_check_that_works_at_the_third_try_counts(
    world: World, monkeypatch: pytest.MonkeyPatch, tried: list[Callable[..., Any]]
) -> None:
    call, check_file = audio_checks.SandboxChild.call, audio_checks.check_file

    def crash_twice(child: audio_checks.SandboxChild, work: Callable[..., Any], *given: Any, **options: Any) -> Any:
        is_to_crash = work is check_file and tried.count(hostile.crash) < 2
        return call(child, hostile.crash if is_to_crash else work, *given, **options)

    monkeypatch.setattr(audio_checks.SandboxChild, "call", crash_twice)
    take = deliver(world, "laser.wav", tone(hz=300))
    assert checked(world, take["id"])["state"] == "conforming"
    assert tried[:3] == [hostile.crash, hostile.crash, check_file]


def altered(file: Path) -> None:
    file.write_bytes(file.read_bytes()[::-1])


@pytest.mark.slow
@pytest.mark.parametrize("spoil", [Path.unlink, pytest.param(altered, marks=pytest.mark.on_s3)])
def test_a_master_that_the_store_lost_is_our_fault(world: World, spoil: Callable[[Path], None]) -> None:
    take = deliver(world, "laser.wav", tone(hz=310))
    world.server.wait_for_jobs()
    spoil(blob_file(world.server.runtime.store, world.studio_id, take["master_sha256"]))

    def again(session: Any) -> None:
        row = session.get(Take, UUID(take["id"]))
        row.state, row.file_name = TakeState.RECEIVED, "another.wav"  # so that no earlier check says the same

    world.server.in_database(again)
    prepare_take(world.server.runtime, {"take_id": take["id"]})
    found = world.designer.get(f"/v1/takes/{take['id']}/check").json()
    assert (found["state"], found["verdict"]) == ("unjudged", "unjudged")


@pytest.mark.slow
def test_a_job_that_comes_twice_judges_once(world: World) -> None:
    take = deliver(world, "laser.wav", tone())
    world.server.wait_for_jobs()
    for _ in range(2):
        prepare_take(world.server.runtime, {"take_id": take["id"]})
    assert len(runs(world, take["id"])) == 1


def test_a_verdict_that_comes_too_late_is_dropped(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    """While its check runs, the take is asked to be checked as something else."""
    take = deliver(world, "laser_fire.wav", tone(hz=320))
    world.server.wait_for_jobs()
    before = len(runs(world, take["id"]))

    def receive(session: Any) -> None:
        change_state(session, session.get(Take, UUID(take["id"])), TakeState.RECEIVED)

    def overtaken(point: str) -> None:
        if point == "conformance.after_check":

            def move_on(session: Any) -> None:
                session.get(Take, UUID(take["id"])).edition += 1

            world.server.in_database(move_on)

    world.server.in_database(receive)
    with monkeypatch.context() as patched:
        patched.setattr(kill_points, "point", overtaken)
        prepare_take(world.server.runtime, {"take_id": take["id"]})
    assert len(runs(world, take["id"])) == before
    assert world.designer.get(f"/v1/takes/{take['id']}").json()["state"] == "received"


@pytest.mark.slow
def test_what_would_say_the_same_is_not_computed_again(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    take = deliver(world, "laser.wav", tone(hz=330))
    before = checked(world, take["id"])
    monkeypatch.setattr(audio_checks, "check_file", hostile.crash)
    assert world.approver.post(f"/v1/takes/{take['id']}/recheck").status_code == 202
    after = checked(world, take["id"])
    assert (after["state"], after["measurements"]) == ("conforming", before["measurements"])
    kept = runs(world, take["id"])
    assert ([run.is_current for run in kept], len({run.key for run in kept})) == ([False, True], 1)


@pytest.mark.slow
def test_a_new_spec_rechecks_undecided_takes(world: World) -> None:
    undecided = deliver(world, "undecided.wav", tone(dbfs=-3.0))
    quiet = deliver(world, "quiet.wav", tone(dbfs=-20.0))
    approved = deliver(world, "approved.wav", tone(dbfs=-3.1))
    world.server.wait_for_jobs()

    def approve(session: Any) -> None:
        change_state(session, session.get(Take, UUID(approved["id"])), TakeState.APPROVED)

    world.server.in_database(approve)
    version = save_spec(world, lambda toml: toml.replace("sample_peak_dbfs = -0.1", "sample_peak_dbfs = -6.0"))
    assert version == 2
    found = checked(world, undecided["id"])
    assert (found["state"], found["spec_version"], found["is_newest_spec"]) == ("returned", 2, True)
    assert codes(found) == ["sample-peak:over"]
    assert checked(world, quiet["id"])["spec_version"] == 2
    kept = checked(world, approved["id"])
    assert (kept["state"], kept["spec_version"], kept["is_newest_spec"]) == ("approved", 1, False)
    refused = world.approver.post(f"/v1/takes/{approved['id']}/recheck")
    assert (refused.status_code, refused.json()["code"]) == (409, "wrong-state")


@pytest.mark.slow
def test_a_new_spec_that_asks_the_same_of_a_take_leaves_it_alone(world: World) -> None:
    take = deliver(world, "laser.wav", tone(hz=340))
    world.server.wait_for_jobs()
    since = world.designer.get(f"/v1/takes/{take['id']}").json()["state_since"]
    save_spec(world, lambda toml: f"{toml}\n[categories.whispers]\nlimits.sample_peak_dbfs = -12.0\n")
    found = checked(world, take["id"])
    assert (found["spec_version"], found["is_newest_spec"]) == (2, True)
    assert len(runs(world, take["id"])) == 1
    assert world.designer.get(f"/v1/takes/{take['id']}").json()["state_since"] == since


@pytest.mark.slow
def test_a_changed_cue_rechecks_its_takes(world: World) -> None:
    laser, _ = add_cues(world, {"name": "Laser fire", "duration_s": 0.1}, {"name": "Shield hit"})
    take = deliver(world, "laser_fire.wav", tone(hz=350))
    other = deliver(world, "shield_hit.wav", tone(hz=351))
    assert codes(checked(world, take["id"]), "warning") == []
    changed = world.producer.patch(f"/v1/cues/{laser['id']}", json={"edition": laser["edition"], "duration_s": 2.0})
    assert changed.status_code == 200, changed.text
    assert any(code.startswith("duration:") for code in codes(checked(world, take["id"]), "warning"))
    assert len(runs(world, other["id"])) == 1


@pytest.mark.slow
def test_a_cue_that_is_stereo_returns_mono_files(world: World) -> None:
    [cue] = add_cues(world, {"name": "laser_fire", "channels": "mono"})
    take = deliver(world, "laser_fire.wav", tone())
    assert checked(world, take["id"])["verdict"] == "conforming"
    changed = world.producer.patch(f"/v1/cues/{cue['id']}", json={"edition": cue["edition"], "channels": "stereo"})
    assert changed.status_code == 200, changed.text
    assert codes(checked(world, take["id"])) == ["channels:cue"]
    head, row = world.designer.get(f"/v1/projects/{world.project_id}/sound-list.csv").text.splitlines()[:2]
    assert dict(zip(head.split(","), row.split(","), strict=True))["channels"] == "stereo"


@pytest.mark.slow
def test_a_recheck_overtakes_the_check_that_still_waits(world: World) -> None:
    take = deliver(world, "laser.wav", tone(hz=352))
    recheck_takes(world.server.runtime, {"project_id": str(world.project_id)})
    world.server.wait_for_jobs()
    assert checked(world, take["id"])["state"] == "conforming"
    with world.server.runtime.database.reading() as session:
        current = session.scalar(select(func.count()).where(CheckRun.take_id == UUID(take["id"]), CheckRun.is_current))
    assert current == 1


@pytest.mark.slow
def test_who_sees_a_check(world: World) -> None:
    take = deliver(world, "laser.wav", tone())
    world.server.wait_for_jobs()
    for who, status in {
        "designer": 200,
        "reviewer": 200,
        "other_designer": 404,
        "stranger": 404,
        "nobody": 401,
    }.items():
        assert getattr(world, who).get(f"/v1/takes/{take['id']}/check").status_code == status
    for who, status in {"other_designer": 404, "stranger": 404, "nobody": 401}.items():
        assert getattr(world, who).post(f"/v1/takes/{take['id']}/recheck").status_code == status


class TestWaiver:
    def waive(self, world: World, take: dict[str, Any], who: str = "approver") -> Any:
        return getattr(world, who).post(
            f"/v1/takes/{take['id']}/waiver", json={"reason": "it is meant to hit the ceiling"}
        )

    def loud(self, world: World, hz: float = 440) -> dict[str, Any]:
        take = deliver(world, f"loud_{hz:.0f}.wav", tone(dbfs=0.0, hz=hz))
        assert checked(world, take["id"])["state"] == "returned"
        return take

    @pytest.mark.slow
    def test_the_approver_lets_a_returned_take_through(self, world: World) -> None:
        take = self.loud(world)
        waived = self.waive(world, take)
        assert waived.status_code == 201, waived.text
        found = waived.json()
        assert (found["state"], found["verdict"]) == ("conforming", "rejected")
        assert found["waiver"]["codes"] == ["sample-peak:over"]
        assert found["waiver"]["waived_by"] == {
            "id": str(world.approver_id),
            "name": "Audio director",
            "picture": None,
        }
        marked = {finding["code"]: finding["waived"] for finding in found["findings"]}
        assert marked.pop("sample-peak:over") is True
        assert not any(marked.values())
        with world.server.runtime.database.reading() as session:
            [(waiver, run, row)] = queries.waivers_in(session, world.project_id)
            assert (waiver.reason, row.id) == ("it is meant to hit the ceiling", UUID(take["id"]))
            assert run.pcm_sha256 == found_pcm(world, take)
        assert self.waive(world, take).json()["code"] == "nothing-to-waive"

    @pytest.mark.slow
    def test_only_the_approver_may(self, world: World) -> None:
        take = self.loud(world)
        statuses = {
            who: self.waive(world, take, who).status_code
            for who in ("reviewer", "producer", "designer", "other_designer", "stranger", "nobody")
        }
        assert statuses == {
            "reviewer": 403, "producer": 403, "designer": 403, "other_designer": 404, "stranger": 404, "nobody": 401,
        }  # fmt: skip
        assert world.designer.get(f"/v1/takes/{take['id']}").json()["state"] == "returned"

    @pytest.mark.slow
    def test_it_wants_a_reason(self, world: World) -> None:
        take = self.loud(world)
        answer = world.approver.post(f"/v1/takes/{take['id']}/waiver", json={"reason": "   "})
        assert answer.status_code == 422

    @pytest.mark.slow
    def test_what_cannot_be_read_cannot_be_let_through(self, world: World) -> None:
        take = deliver(world, "laser.wav", b"no sound")
        world.server.wait_for_jobs()
        assert self.waive(world, take).json()["code"] == "nothing-to-waive"

    @pytest.mark.slow
    def test_it_holds_at_a_new_spec_for_what_it_waived(self, world: World) -> None:
        take = self.loud(world)
        self.waive(world, take)
        save_spec(world, lambda toml: toml.replace("sample_peak_dbfs = -0.1", "sample_peak_dbfs = -0.5"))
        assert checked(world, take["id"])["state"] == "conforming"
        save_spec(world, lambda toml: toml.replace("bit_depths = [16, 24]", "bit_depths = [16]"))
        found = checked(world, take["id"])
        assert found["state"] == "returned"
        assert {finding["code"]: finding["waived"] for finding in found["findings"] if finding["severity"] == "error"}[
            "sample-peak:over"
        ]


def found_pcm(world: World, take: dict[str, Any]) -> str | None:
    return runs(world, take["id"])[-1].pcm_sha256
