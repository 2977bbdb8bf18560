"""What a verdict does, what it leaves alone, and what two tabs at once come to."""

from concurrent.futures import ThreadPoolExecutor
from typing import Any
from uuid import UUID

import pytest
from sqlalchemy import func, select, update
from sqlalchemy.exc import IntegrityError

from app.core.db import new_id
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.projects.models import ApproverChange
from app.reviews.models import Verdict
from app.reviews.queries import accepted_takes
from tests.app.reviews.making import Stage, add_take, body_of, refused
from tests.support.server import World


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


@pytest.mark.slow
def test_approving_an_alternate_sets_the_others_aside(stage: Stage) -> None:
    cue = stage.cue()
    a, b, c = (stage.take(cue) for _ in range(3))
    elsewhere = stage.take(stage.cue("other"))
    answer = stage.approve(b, note="this one")
    assert answer["cue_accepted"] is True
    assert set(answer["set_aside"]) == {str(a), str(c)}
    assert stage.states(a, b, c, elsewhere) == ["set_aside", "approved", "set_aside", "conforming"]
    assert stage.waiting() == {str(elsewhere)}


def test_a_take_still_in_check_is_left_alone(stage: Stage) -> None:
    cue = stage.cue()
    picked, checking = stage.take(cue), stage.take(cue, state=TakeState.RECEIVED)
    stage.approve(picked)
    assert stage.states(checking) == ["received"]


@pytest.mark.slow
def test_a_set_aside_take_can_be_picked_later(stage: Stage) -> None:
    cue = stage.cue()
    first, second = stage.take(cue), stage.take(cue)
    stage.approve(first)
    answer = stage.approve(second, seen_state="set_aside")
    assert answer["set_aside"] == [str(first)]
    assert stage.states(first, second) == ["set_aside", "approved"]


@pytest.mark.slow
def test_a_newer_version_takes_the_place_of_the_approved_one(stage: Stage) -> None:
    cue = stage.cue()
    first = stage.take(cue)
    stage.approve(first)
    second = stage.take(cue)
    assert stage.approve(second)["set_aside"] == [str(first)]


@pytest.mark.slow
def test_a_set_is_accepted_when_every_variation_has_its_take(stage: Stage) -> None:
    cue = stage.cue(variations=2)
    one, two = stage.take(cue, 1), stage.take(cue, 2)
    assert stage.approve(one)["cue_accepted"] is False
    assert stage.queue()[0]["approved_variations"] == [1]
    assert stage.approve(two)["cue_accepted"] is True


@pytest.mark.slow
def test_only_the_approver_decides(stage: Stage) -> None:
    world = stage.world
    take = stage.take(stage.cue())
    path, body = f"/v1/takes/{take}/verdict", {"kind": "approve"}
    assert world.nobody.post(path, json=body).status_code == 401
    for who in (world.producer, world.reviewer, world.designer):
        answer = who.post(path, json=body)
        assert refused(answer) == (403, "approver-needed")
        assert "approver decides" in answer.json()["detail"]
        assert refused(who.delete(path)) == (403, "approver-needed")
    for stranger in (world.stranger, world.other_designer):
        assert refused(stranger.post(path, json=body)) == (404, "take-not-found")
        assert refused(stranger.delete(path)) == (404, "take-not-found")
    assert refused(world.approver.post(f"/v1/takes/{new_id()}/verdict", json=body)) == (404, "take-not-found")
    assert stage.states(take) == ["conforming"]


def approver_becomes(stage: Stage, person_id: UUID) -> None:
    world = stage.world
    change = ApproverChange(
        studio_id=world.studio_id,
        project_id=world.project_id,
        person_id=person_id,
        reason="the audio director is away",
        changed_by=world.producer_id,
    )
    world.server.in_database(lambda session: session.add(change))


def test_a_producer_decides_by_becoming_the_approver(stage: Stage) -> None:
    world = stage.world
    take = stage.take(stage.cue())
    approver_becomes(stage, world.producer_id)
    body = {"kind": "approve"}
    assert refused(world.approver.post(f"/v1/takes/{take}/verdict", json=body)) == (403, "approver-needed")
    assert world.producer.post(f"/v1/takes/{take}/verdict", json=body).status_code == 200


@pytest.mark.parametrize("kind", ["approve", "request_change", "set_aside"])
@pytest.mark.parametrize("state", [s for s in TakeState if s is not TakeState.CONFORMING])
def test_a_page_that_is_out_of_date_decides_nothing(stage: Stage, kind: str, state: TakeState) -> None:
    take = stage.take(stage.cue(), state=state)
    answer = stage.verdict(take, kind, note="duller")
    assert refused(answer) == (409, "stale-view")
    assert "since you opened this page" in answer.json()["detail"]
    assert stage.states(take) == [state.value]


@pytest.mark.parametrize(
    ("state", "kind"),
    [
        (TakeState.RECEIVED, "approve"),
        (TakeState.RETURNED, "approve"),
        (TakeState.UNJUDGED, "set_aside"),
        (TakeState.APPROVED, "approve"),
        (TakeState.APPROVED, "set_aside"),
        (TakeState.SET_ASIDE, "set_aside"),
        (TakeState.SET_ASIDE, "request_change"),
        (TakeState.CHANGE_REQUESTED, "approve"),
        (TakeState.CHANGE_REQUESTED, "request_change"),
    ],
)
def test_what_no_state_allows_is_refused(stage: Stage, state: TakeState, kind: str) -> None:
    take = stage.take(stage.cue(), state=state)
    assert stage.verdict(take, kind, note="duller", seen_state=state.value).status_code == 409
    assert stage.states(take) == [state.value]


def verdicts_on(stage: Stage, cue: UUID) -> int:
    counted = select(func.count()).where(Verdict.cue_id == cue)
    return stage.world.server.in_database(lambda session: session.scalar(counted)) or 0


def test_two_tabs_at_once_approve_once(stage: Stage) -> None:
    """The same take four times, from pages that show it waiting."""
    cue = stage.cue()
    take, other = stage.take(cue), stage.take(cue)
    with ThreadPoolExecutor(4) as tabs:
        answers = list(tabs.map(lambda _: body_of(stage.verdict(take, "approve")), range(4)))
    assert {(answer["state"], *answer["set_aside"]) for answer in answers} == {("approved", str(other))}
    assert verdicts_on(stage, cue) == 2
    assert stage.states(take, other) == ["approved", "set_aside"]


def test_ones_own_decision_is_no_conflict_and_that_of_another_is(stage: Stage) -> None:
    cue = stage.cue()
    a, b = stage.take(cue), stage.take(cue)
    stage.approve(a)
    assert stage.approve(b)["set_aside"] == [str(a)], "the page showed B waiting: its own pick of A had set it aside"
    assert stage.draft(b, "longer")["reverses"] is True
    assert stage.states(a, b) == ["set_aside", "approved"]
    approver_becomes(stage, stage.world.producer_id)
    for take in (a, b):
        answer = stage.world.producer.post(f"/v1/takes/{take}/verdict", json={"kind": "approve"})
        assert refused(answer) == (409, "stale-view")


def test_a_decision_that_was_taken_back_can_be_made_again(stage: Stage) -> None:
    take = stage.take(stage.cue())
    for _ in range(2):
        stage.approve(take)
        body_of(stage.undo(take))
    assert stage.states(take) == ["conforming"]


def test_a_set_is_judged_in_parts_and_as_a_whole_in_any_order(stage: Stage) -> None:
    """As a browser sends it that has not read what its first verdict did."""
    cue = stage.cue(variations=3)
    takes = [stage.take(cue, variation) for variation in (1, 2, 3)]
    path, body = f"/v1/cues/{cue}/accept-set", {"take_ids": [str(take) for take in takes]}
    stage.approve(takes[0])
    accepted = body_of(stage.world.approver.post(path, json=body))
    stage.approve(takes[0])
    stage.approve(takes[2])
    again = body_of(stage.world.approver.post(path, json=body))
    assert {**again, "undo_until": ""} == {**accepted, "undo_until": ""}
    assert verdicts_on(stage, cue) == 3
    approver_becomes(stage, stage.world.producer_id)
    assert refused(stage.world.producer.post(path, json=body)) == (409, "already-accepted")


def test_the_database_itself_allows_one_approved_take(stage: Stage) -> None:
    cue = stage.cue()
    takes = [stage.take(cue), stage.take(cue)]
    with pytest.raises(IntegrityError):
        stage.world.server.in_database(
            lambda session: session.execute(update(Take).where(Take.id.in_(takes)).values(state=TakeState.APPROVED))
        )


@pytest.mark.slow
def test_unmatched_files_and_cut_cues_cannot_be_judged(stage: Stage) -> None:
    unmatched = stage.world.server.in_database(
        lambda session: add_take(session, stage.world, stage.delivery_id, None, 1)
    )
    assert refused(stage.verdict(unmatched, "approve")) == (409, "not-reviewable")
    cue = stage.cue()
    take = stage.take(cue)
    body_of(stage.world.approver.post(f"/v1/cues/{cue}/cut", json={"reason": "no shields any more"}))
    assert refused(stage.verdict(take, "approve")) == (409, "cue-is-cut")
    assert refused(stage.undo(take)) == (409, "cue-is-cut")


@pytest.mark.slow
def test_a_change_is_a_draft_that_can_be_reworded(stage: Stage) -> None:
    take = stage.take(stage.cue())
    draft = stage.draft(take, "less shimmer", start_s=0.1, end_s=0.2)
    assert (draft["text"], draft["sent_at"], draft["reverses"]) == ("less shimmer", None, False)
    again = stage.draft(take, "much less shimmer", start_s=0.3)
    assert again["id"] == draft["id"]
    assert (again["text"], again["start_s"], again["end_s"]) == ("much less shimmer", 0.3, None)
    assert stage.states(take) == ["conforming"]
    assert stage.queue()[0]["takes"][0]["draft_change"]["text"] == "much less shimmer"


@pytest.mark.parametrize(
    ("more", "code"),
    [
        ({"note": " "}, "note-needed"),
        ({"note": "x", "start_s": 0.9}, "range-invalid"),
        ({"note": "x", "start_s": 0.5, "end_s": 0.4}, "range-invalid"),
        ({"note": "x", "end_s": 0.4}, "range-invalid"),
        ({"note": "x", "start_s": -1}, "invalid-request"),
        ({"note": "x\0"}, "unstorable"),
        ({"note": "x" * 10_001}, "invalid-request"),
        ({"note": "x", "colour": "blue"}, "invalid-request"),
        ({"note": "x", "seen_state": "gone"}, "invalid-request"),
    ],
)
def test_a_change_request_is_checked(stage: Stage, more: dict[str, Any], code: str) -> None:
    take = stage.take(stage.cue())  # 0.84 s long
    assert refused(stage.verdict(take, "request_change", **more)) == (422, code)
    assert stage.queue()[0]["takes"][0]["draft_change"] is None


@pytest.mark.slow
def test_a_change_noted_on_another_alternate_is_kept(stage: Stage) -> None:
    cue = stage.cue()
    picked, other = stage.take(cue), stage.take(cue)
    stage.draft(other, "shorter", start_s=0.2)
    stage.approve(picked)
    drafts = {take["id"]: take["draft_change"] for take in stage.review(cue)["takes"] if take["draft_change"]}
    assert (drafts[str(other)]["text"], drafts[str(other)]["start_s"]) == ("shorter", 0.2)
    answer = stage.world.approver.post(f"/v1/projects/{stage.world.project_id}/feedback", json={})
    assert refused(answer) == (409, "nothing-to-send")
    assert "was set aside; its draft is kept" in answer.json()["detail"]
    stage.undo(picked)
    assert [one["text"] for one in stage.send()["change_requests"]] == ["shorter"]


@pytest.mark.slow
def test_a_set_is_accepted_at_once_and_taken_back_at_once(stage: Stage) -> None:
    cue = stage.cue(variations=3)
    older = stage.take(cue, 1)
    takes = [stage.take(cue, variation) for variation in (1, 2, 3)]
    answer = body_of(stage.world.approver.post(f"/v1/cues/{cue}/accept-set", json={"note": "good steps"}))
    assert answer["cue_accepted"] is True
    assert [take["id"] for take in answer["approved"]] == [str(take) for take in takes]
    assert answer["set_aside"] == [str(older)]
    body_of(stage.undo(takes[2]))
    assert stage.states(older, *takes) == ["conforming"] * 4


@pytest.mark.slow
def test_the_takes_of_a_set_can_be_named(stage: Stage) -> None:
    cue = stage.cue(variations=2)
    older, newer, second = stage.take(cue, 1), stage.take(cue, 1), stage.take(cue, 2)
    body = {"take_ids": [str(older)]}
    body_of(stage.world.approver.post(f"/v1/cues/{cue}/accept-set", json=body))
    assert stage.states(older, newer, second) == ["approved", "set_aside", "approved"]


def test_an_incomplete_set_is_not_accepted_in_part(stage: Stage) -> None:
    cue = stage.cue(variations=4)
    takes = [stage.take(cue, 1), stage.take(cue, 3), stage.take(cue, 4, state=TakeState.RETURNED)]
    answer = stage.world.approver.post(f"/v1/cues/{cue}/accept-set", json={})
    assert refused(answer) == (409, "set-incomplete")
    assert "for 2, 4;" in answer.json()["detail"]
    assert stage.states(*takes) == ["conforming", "conforming", "returned"]


@pytest.mark.slow
def test_a_set_names_its_own_takes_once_and_only_the_approver_accepts(stage: Stage) -> None:
    cue, other = stage.cue(variations=2), stage.cue("other")
    one, twin, two = stage.take(cue, 1), stage.take(cue, 1), stage.take(cue, 2)
    foreign, returned = stage.take(other), stage.take(cue, 2, state=TakeState.RETURNED)
    path = f"/v1/cues/{cue}/accept-set"

    def accept(*take_ids: UUID) -> Any:
        return stage.world.approver.post(path, json={"take_ids": [str(take) for take in take_ids]})

    assert refused(accept(foreign)) == (422, "not-of-this-cue")
    assert refused(accept(new_id())) == (422, "not-of-this-cue")
    assert refused(accept(one, twin)) == (422, "not-of-this-cue")
    assert refused(accept(returned)) == (409, "not-reviewable")
    assert refused(stage.world.reviewer.post(path, json={})) == (403, "approver-needed")
    assert refused(stage.world.stranger.post(path, json={})) == (404, "cue-not-found")
    assert stage.states(one, twin, two) == ["conforming"] * 3


@pytest.mark.slow
def test_what_is_accepted_is_known_to_packs(stage: Stage) -> None:
    whole, half, cut = stage.cue("whole", variations=2), stage.cue("half", variations=2), stage.cue("cut")
    picked = [stage.take(whole, 2), stage.take(whole, 1)]
    for take in (*picked, stage.take(half, 1), stage.take(cut)):
        stage.approve(take)
    body_of(stage.world.approver.post(f"/v1/cues/{cut}/cut", json={"reason": "no longer needed"}))
    found = stage.world.server.in_database(lambda session: accepted_takes(session, stage.world.project_id))
    assert [(cue.name, variation, take.id) for cue, variation, take in found] == [
        ("whole", 1, picked[1]),
        ("whole", 2, picked[0]),
    ]
