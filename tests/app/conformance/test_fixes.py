"""A fix is made ready for what came back, heard before it is used, and used by its own designer alone."""

from typing import Any
from uuid import UUID

import pytest
from sqlalchemy import select

import audio_checks
from app.conformance import checking, jobs
from app.conformance.fixes import OUR_FAULT
from app.conformance.jobs import make_fix
from app.conformance.models import Fix
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from tests.support.deliver import add_cues, checked, deliver, open_delivery
from tests.support.server import World
from tests.support.waves import join, silence, sine, swelling, wav_bytes


def loud(hz: float = 440.0, *, rate: int = 48_000) -> bytes:
    """A sound that starts late and peaks at full scale: a fix is enough."""
    tone = swelling(sine(hz=hz, dbfs=0.0, seconds=0.2, rate=rate, phase=1.0))
    return wav_bytes(join(silence(seconds=0.05, rate=rate), tone), rate=rate)


def returned(world: World, content: bytes | None = None, name: str = "airlock_cycle.wav") -> dict[str, Any]:
    """Deliver a sound for a cue of its name, and wait until everything about it is done."""
    take = deliver(world, name, loud() if content is None else content)
    world.server.wait_for_jobs()
    return take


def fix_of(world: World, take: dict[str, Any], by: Any = None) -> dict[str, Any]:
    answer = (by or world.designer).get(f"/v1/takes/{take['id']}/fix")
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


@pytest.fixture
def take(world: World) -> dict[str, Any]:
    add_cues(world, {"name": "Airlock cycle"})
    return returned(world)


def test_what_came_back_finds_its_fix_made(world: World, take: dict[str, Any]) -> None:
    fix = fix_of(world, take)
    assert (fix["state"], fix["left"], fix["becomes"]) == ("made", [], 2)
    assert fix["says"] == "45.0 ms trimmed from the start, level lowered by 1.00 dB."
    assert [repair["kind"] for repair in fix["repairs"]] == ["head", "gain"]
    assert fix["before"]["sample_peak_dbfs"] == pytest.approx(0.0, abs=0.01)
    assert fix["after"]["true_peak_dbtp"] == pytest.approx(-1.0, abs=0.06)
    assert (fix["cut_head_s"], fix["cut_tail_s"]) == (pytest.approx(0.045), 0.0)
    assert fix["duration_s"] == pytest.approx(0.205)
    [head, gain] = fix["spots"]
    assert (head["kind"], gain["kind"]) == ("head", "gain")
    assert max(gain["before"]["max"]) > max(gain["after"]["max"])


@pytest.mark.slow
def test_both_versions_can_be_heard_and_seen_by_both_sides_and_no_one_else(world: World, take: dict[str, Any]) -> None:
    sounds = world.designer.get(f"/v1/takes/{take['id']}/sounds").json()
    assert sounds["fix"]["duration_s"] == pytest.approx(0.205)
    for client in (world.designer, world.approver):
        assert client.get(sounds["fix"]["preview_url"]).status_code == 200
        assert client.get(sounds["fix"]["peaks_url"]).json()["points"] > 0
    for client in (world.other_designer, world.stranger):
        assert client.get(sounds["fix"]["preview_url"]).status_code == 404
    assert fix_of(world, take, by=world.approver)["state"] == "made"  # the approver sees that a fix is offered


@pytest.mark.slow
def test_findings_say_what_a_fix_does_about_each(world: World, take: dict[str, Any]) -> None:
    reported = {one["code"]: one for one in checked(world, take["id"])["findings"]}
    assert reported["head-silence:over"]["auto_fix"] == "trims 45.0 ms from the start"
    assert reported["sample-peak:over"]["auto_fix"] == "lowers the level by 0.10 dB"
    assert reported["sample-peak:over"]["no_auto_fix"] is None


@pytest.mark.slow
def test_with_consent_it_becomes_a_version_and_no_round_counts(world: World, take: dict[str, Any]) -> None:
    used = world.designer.post(f"/v1/takes/{take['id']}/fix/use")
    assert used.status_code == 201, used.text
    new = used.json()
    assert (new["number"], new["fix_of_id"], new["state"]) == (2, take["id"], "received")
    assert (new["delivery_id"], new["file_name"]) == (take["delivery_id"], take["file_name"])
    found = checked(world, new["id"])
    assert (found["verdict"], found["state"]) == ("conforming", "conforming")
    old = world.designer.get(f"/v1/takes/{take['id']}").json()
    assert (old["state"], old["master_sha256"]) == ("returned", take["master_sha256"])
    master = world.designer.get(f"/v1/takes/{take['id']}/master")
    assert master.content == loud()
    review = world.approver.get(f"/v1/cues/{take['cue']['id']}/review").json()
    assert review["rounds"] == []
    [queued] = world.approver.get("/v1/review-queue", params={"project_id": str(world.project_id)}).json()["items"]
    assert (queued["rounds_so_far"], [one["id"] for one in queued["takes"]]) == (0, [new["id"]])


@pytest.mark.slow
def test_who_agreed_and_to_what_stays_on_record(world: World, take: dict[str, Any]) -> None:
    new = world.designer.post(f"/v1/takes/{take['id']}/fix/use").json()
    world.server.wait_for_jobs()
    old = fix_of(world, take, by=world.approver)
    assert (old["state"], old["new_take_id"], old["becomes"]) == ("used", new["id"], 2)
    assert old["used_by"]["name"] == "Sound designer"
    origin = fix_of(world, new, by=world.approver)["fixed_from"]
    assert (origin["take_id"], origin["number"], origin["used_by"]["name"]) == (take["id"], 1, "Sound designer")
    assert [repair["words"] for repair in origin["repairs"]] == [
        "45.0 ms trimmed from the start",
        "level lowered by 1.00 dB",
    ]
    history = world.approver.get(f"/v1/takes/{new['id']}/history").json()
    assert "fix of version 1" in history[0]["text"]


@pytest.mark.slow
def test_consent_given_twice_is_given_once(world: World, take: dict[str, Any]) -> None:
    first = world.designer.post(f"/v1/takes/{take['id']}/fix/use")
    again = world.designer.post(f"/v1/takes/{take['id']}/fix/use")
    assert (first.status_code, again.status_code) == (201, 200)
    assert again.json()["id"] == first.json()["id"]
    assert again.json()["already_here"] is True


@pytest.mark.slow
def test_no_one_else_can_use_it(world: World, take: dict[str, Any]) -> None:
    for client, status in (
        (world.approver, 403),
        (world.producer, 403),
        (world.reviewer, 403),
        (world.other_designer, 404),
        (world.stranger, 404),
        (world.nobody, 401),
    ):
        for path in ("fix", "fix/use"):
            assert client.post(f"/v1/takes/{take['id']}/{path}").status_code == status


@pytest.mark.slow
def test_a_fix_that_is_not_enough_is_not_made(world: World) -> None:
    add_cues(world, {"name": "Laser fire"})
    take = returned(world, loud(rate=32_000), "laser_fire.wav")
    fix = fix_of(world, take)
    assert fix["state"] == "none"
    assert "would not be enough" in fix["says"]
    reported = {one["code"]: one for one in checked(world, take["id"])["findings"]}
    assert "never changes the sample rate" in reported["sample-rate:not-accepted"]["no_auto_fix"]
    refused = world.designer.post(f"/v1/takes/{take['id']}/fix")
    assert (refused.status_code, refused.json()["code"]) == (409, "nothing-to-fix")
    refused = world.designer.post(f"/v1/takes/{take['id']}/fix/use")
    assert (refused.status_code, refused.json()["code"]) == (409, "fix-not-ready")


@pytest.mark.slow
def test_a_warning_is_fixed_when_asked(world: World) -> None:
    add_cues(world, {"name": "Door"})
    late = wav_bytes(join(silence(seconds=0.05), sine(hz=440, dbfs=-6.0, seconds=0.2, phase=0.15)))
    take = returned(world, late, "door.wav")
    assert fix_of(world, take)["state"] == "offered"
    assert fix_of(world, take)["says"] == "Trims 45.0 ms from the start."
    asked = world.designer.post(f"/v1/takes/{take['id']}/fix")
    assert (asked.status_code, asked.json()["state"]) == (202, "making")
    world.server.wait_for_jobs()
    assert fix_of(world, take)["state"] == "made"
    assert world.designer.post(f"/v1/takes/{take['id']}/fix").json()["state"] == "made"
    new = world.designer.post(f"/v1/takes/{take['id']}/fix/use").json()
    assert checked(world, new["id"])["findings"] == []


@pytest.mark.slow
def test_a_take_that_is_decided_upon_is_not_fixed(world: World) -> None:
    add_cues(world, {"name": "Door"})
    late = wav_bytes(join(silence(seconds=0.05), sine(hz=440, dbfs=-6.0, seconds=0.2, phase=0.15)))
    take = returned(world, late, "door.wav")
    given = world.approver.post(f"/v1/takes/{take['id']}/verdict", json={"kind": "approve"})
    assert given.status_code in (200, 201), given.text
    assert fix_of(world, take)["state"] == "none"
    assert world.designer.post(f"/v1/takes/{take['id']}/fix").status_code == 409


@pytest.mark.slow
def test_an_unmatched_file_waits_for_its_cue(world: World) -> None:
    take = returned(world, name="what is this.wav")
    assert take["cue"] is None
    assert fix_of(world, take)["state"] == "none"
    [cue] = add_cues(world, {"name": "Airlock cycle"})
    matched = world.designer.put(f"/v1/takes/{take['id']}/match", json={"cue_id": cue["id"]})
    assert matched.status_code == 200
    world.server.wait_for_jobs()
    assert fix_of(world, take)["state"] == "made"


@pytest.mark.slow
def test_an_ending_that_is_put_right_names_the_new_version(world: World) -> None:
    add_cues(world, {"name": "Door"})
    take = returned(world, wav_bytes(sine(hz=440, seconds=0.2)), "door.WAV")
    assert fix_of(world, take)["says"] == "Renamed to door.wav."
    new = world.designer.post(f"/v1/takes/{take['id']}/fix/use").json()
    assert (new["file_name"], checked(world, new["id"])["verdict"]) == ("door.wav", "conforming")


@pytest.mark.slow
def test_a_variation_and_its_alternate_stay_what_they_are(world: World) -> None:
    add_cues(world, {"name": "Step", "variations": 3})
    take = returned(world, loud(), "step_02_altB.wav")
    new = world.designer.post(f"/v1/takes/{take['id']}/fix/use").json()
    assert (new["variation"], new["alternate"], new["number"]) == (2, 2, 2)


@pytest.mark.slow
def test_a_closed_delivery_does_not_make_a_fix_late(world: World) -> None:
    add_cues(world, {"name": "Airlock cycle"})
    delivery_id = open_delivery(world)
    take = deliver(world, "airlock_cycle.wav", loud(), delivery_id=delivery_id)
    assert world.designer.post(f"/v1/deliveries/{delivery_id}/close").status_code == 200
    world.server.wait_for_jobs()
    new = world.designer.post(f"/v1/takes/{take['id']}/fix/use").json()
    assert (new["late"], new["delivery_id"]) == (False, delivery_id)


@pytest.mark.slow
def test_a_new_spec_makes_a_new_fix(world: World, take: dict[str, Any]) -> None:
    path = f"/v1/projects/{world.project_id}/spec"
    now = world.producer.get(path).json()
    stricter = now["toml"].replace("true_peak_dbtp = -1.0", "true_peak_dbtp = -3.0")
    body = {"toml": stricter, "note": "", "based_on_version": now["version"]}
    assert world.producer.put(path, json=body).status_code == 200
    world.server.wait_for_jobs()
    assert "level lowered by 3.00 dB" in fix_of(world, take)["says"]


@pytest.mark.slow
def test_a_fix_whose_process_dies_three_times_is_our_fault(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    def dead(*_: Any, **__: Any) -> Any:
        raise audio_checks.SandboxCrashed("the child was ended by SIGSEGV", signal=11)

    add_cues(world, {"name": "Airlock cycle"})
    with monkeypatch.context() as broken:
        broken.setattr(jobs.fixing, "fix", dead)
        broken.setattr(jobs, "_fixed", lambda *_: None)
        take = returned(world)
        fix = fix_of(world, take)
        assert (fix["state"], fix["says"], fix["is_our_fault"]) == ("refused", OUR_FAULT, True)
    asked = world.designer.post(f"/v1/takes/{take['id']}/fix")
    assert asked.json()["state"] == "making"
    world.server.wait_for_jobs()
    assert fix_of(world, take)["state"] == "made"


@pytest.mark.slow
def test_a_child_that_dies_is_tried_three_times(world: World, take: dict[str, Any], monkeypatch: Any) -> None:
    tries = []

    class Dying(audio_checks.SandboxChild):
        def call(self, *_: Any, **__: Any) -> Any:
            tries.append(1)
            raise audio_checks.SandboxCrashed("the child was ended by SIGSEGV", signal=11)

    class Deadly(audio_checks.Sandbox):
        def child(self, *, timeout_s: float | None = None, **files: Any) -> Dying:
            return Dying(self, timeout_s=timeout_s or self.timeout_s, **files)

    def again(session: Any) -> UUID:
        fix = session.scalar(select(Fix).where(Fix.take_id == UUID(take["id"])))
        fix.state, fix.sha256, fix.fixed_bytes, fix.made = "making", None, None, {}
        return fix.id

    fix_id = world.server.in_database(again)
    monkeypatch.setattr(checking, "sandbox", Deadly)
    make_fix(world.server.runtime, {"fix_id": str(fix_id)})
    assert len(tries) == 3
    assert fix_of(world, take)["state"] == "refused"


@pytest.mark.slow
def test_the_same_job_twice_writes_once(world: World, take: dict[str, Any]) -> None:
    def fixes(session: Any) -> list[Any]:
        return [(one.id, one.sha256, one.made_at) for one in session.scalars(select(Fix))]

    before = world.server.in_database(fixes)
    for fix_id, *_ in before:
        make_fix(world.server.runtime, {"fix_id": str(fix_id)})
    assert world.server.in_database(fixes) == before


@pytest.mark.slow
def test_a_take_that_moved_on_is_not_fixed(world: World, take: dict[str, Any]) -> None:
    def approve(session: Any) -> None:
        session.get(Take, UUID(take["id"])).state = TakeState.CHANGE_REQUESTED

    world.server.in_database(approve)
    refused = world.designer.post(f"/v1/takes/{take['id']}/fix/use")
    assert (refused.status_code, refused.json()["code"]) == (409, "nothing-to-fix")


@pytest.mark.slow
def test_a_fix_made_twice_of_the_same_sound_is_one_version(world: World, take: dict[str, Any]) -> None:
    fixed = world.designer.post(f"/v1/takes/{take['id']}/fix/use").json()
    again = returned(world, loud() + bytes(512))  # the same sound with padding after it: its fix has the same bytes
    assert again["number"] == 3
    used = world.designer.post(f"/v1/takes/{again['id']}/fix/use")
    assert (used.status_code, used.json()["id"]) == (200, fixed["id"])


@pytest.mark.slow
def test_a_cut_that_would_click_is_faded(world: World) -> None:
    add_cues(world, {"name": "Rain"})
    # At 0.295 s, where it is cut, the hum is at its crest.
    rain = join(sine(hz=50, dbfs=-70.0, seconds=0.3), sine(hz=440, dbfs=0.0, seconds=0.3, phase=0.15))
    fix = fix_of(world, returned(world, wav_bytes(rain), "rain.wav"))
    assert "with a fade of 5.0 ms" in fix["says"]


@pytest.mark.slow
def test_what_a_fix_would_answer_is_listed_for_its_designer_and_the_team(world: World, take: dict[str, Any]) -> None:
    add_cues(world, {"name": "Door"}, {"name": "Laser"}, {"name": "Fine"})
    late = wav_bytes(join(silence(seconds=0.05), sine(hz=440, dbfs=-6.0, seconds=0.2, phase=0.15)))
    warned = returned(world, late, "door.wav")
    returned(world, loud(rate=32_000), "laser.wav")
    returned(world, wav_bytes(sine(hz=440, seconds=0.2)), "fine.wav")
    path = f"/v1/projects/{world.project_id}/fixes"
    for client in (world.designer, world.approver):
        listed = client.get(path).json()
        assert [(one["take_id"], one["take_state"], one["state"]) for one in listed] == [
            (take["id"], "returned", "made"),
            (warned["id"], "conforming", "offered"),
        ]
    assert listed[1]["says"] == "Trims 45.0 ms from the start."
    assert listed[1]["cue"]["name"] == "Door"
    world.designer.post(f"/v1/takes/{take['id']}/fix/use")
    world.server.wait_for_jobs()
    assert [one["take_id"] for one in world.designer.get(path).json()] == [warned["id"]]
    assert world.stranger.get(path).status_code == 404


@pytest.mark.slow
def test_the_review_room_says_what_a_fix_would_do(world: World) -> None:
    [cue] = add_cues(world, {"name": "Door"})
    late = wav_bytes(join(silence(seconds=0.05), sine(hz=440, dbfs=-6.0, seconds=0.2, phase=0.15)))
    returned(world, late, "door.wav")
    [shown] = world.approver.get(f"/v1/cues/{cue['id']}/review").json()["takes"]
    assert [finding["auto_fix"] for finding in shown["findings"]] == ["trims 45.0 ms from the start"]
    assert shown["fix_of_id"] is None


@pytest.mark.slow
def test_an_offset_is_taken_out_and_its_start_shown(world: World) -> None:
    add_cues(world, {"name": "Airlock cycle"})
    fix = fix_of(world, returned(world, wav_bytes(sine(hz=440, dbfs=-32.0, seconds=0.5) + 0.05)))
    assert (fix["state"], fix["left"]) == ("made", [])
    assert fix["says"] == "DC offset of 5.00 % taken out."
    assert (fix["before"]["dc_offset_percent"], fix["after"]["dc_offset_percent"]) == pytest.approx(
        (5.0, 0.0), abs=0.01
    )
    assert [spot["kind"] for spot in fix["spots"]] == ["offset"]


@pytest.mark.slow
def test_all_that_came_back_with_an_offset_are_fixed_in_one_go(world: World) -> None:
    names = ("airlock", "hatch", "reactor")
    add_cues(world, *({"name": name} for name in names))
    for place, name in enumerate(names):
        tone = sine(hz=440 + 110 * place, dbfs=-50.0, seconds=0.5) + 0.05 * (-1) ** place
        deliver(world, f"{name}.wav", wav_bytes(tone))
    world.server.wait_for_jobs()
    path = f"/v1/projects/{world.project_id}/fixes"
    offers = world.designer.get(path).json()
    assert [(offer["take_state"], offer["state"]) for offer in offers] == [("returned", "made")] * 3
    used = [world.designer.post(f"/v1/takes/{offer['take_id']}/fix/use") for offer in offers]
    assert [(one.status_code, one.json()["number"]) for one in used] == [(201, 2)] * 3
    world.server.wait_for_jobs()
    found = [checked(world, one.json()["id"]) for one in used]
    assert [one["state"] for one in found] == ["conforming"] * 3
    assert not [one for take in found for one in take["findings"] if one["code"] == "dc-offset:over"]
    assert world.designer.get(path).json() == []
    queued = world.approver.get("/v1/review-queue", params={"project_id": str(world.project_id)}).json()["items"]
    assert [one["rounds_so_far"] for one in queued] == [0] * 3


@pytest.mark.slow
def test_the_reason_why_an_uneven_offset_stays_is_given(world: World) -> None:
    add_cues(world, {"name": "Airlock cycle"})
    uneven = join(sine(hz=440, dbfs=-20.0, seconds=1.0) + 0.06, sine(hz=440, dbfs=-20.0, seconds=1.0))
    fix = fix_of(world, returned(world, wav_bytes(uneven)))
    assert fix["state"] == "refused"
    assert fix["says"].startswith("Even fixed it would be returned. The offset is not the same throughout the sound")
