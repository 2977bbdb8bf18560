"""How a take lies among what was approved, asked over HTTP."""

from typing import Any
from uuid import UUID

import pytest
from sqlalchemy import select, update
from sqlalchemy.orm import Session

from app.conformance.models import CheckRun
from app.core.db import new_id
from app.deliveries.models import Delivery, Take
from app.deliveries.rules import TakeState
from app.projects.models import Engagement, Project
from app.projects.rules import DesignersHear, EngagementKind
from app.renders.models import Timbre
from tests.app.reviews.making import Stage, add_take
from tests.support.server import World


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


def sounding(stage: Stage, take_id: UUID, loudness_lufs: float, timbre: float | None = None) -> UUID:
    """Give a take its loudness, a dry judgement, and its timbre where one is given."""

    def write(session: Session) -> None:
        report = session.scalar(select(CheckRun.report).where(CheckRun.take_id == take_id))
        measured = {"measurements": {"integrated_lufs": loudness_lufs, "short_loudness_lufs": None}}
        judged = {"judgements": {"reverb": {"verdict": "dry", "score": 0.1}}}
        session.execute(update(CheckRun).where(CheckRun.take_id == take_id).values(report=report | measured | judged))
        if timbre is not None:
            take = session.get_one(Take, take_id)
            session.add(
                Timbre(
                    studio_id=take.studio_id,
                    sound_sha256=take.master_sha256,
                    timbre=[timbre, 0.0],
                    bands_db=[0.0, -timbre],
                )
            )

    stage.world.server.in_database(write)
    return take_id


def approved(stage: Stage, loudness_lufs: float, timbre: float, **cue: Any) -> UUID:
    """Put an approved sound of the palette on record, and return its cue."""
    cue_id = stage.cue(**{"name": f"tone{loudness_lufs}", "category": "ui", "palette": True} | cue)
    sounding(stage, stage.take(cue_id, state=TakeState.APPROVED), loudness_lufs, timbre)
    return cue_id


def palette(stage: Stage) -> list[UUID]:
    return [approved(stage, loudness, timbre) for loudness, timbre in ((-20.0, 1.0), (-18.0, 2.0), (-17.0, 3.0))]


def fit_of(stage: Stage, take_id: UUID) -> dict[str, Any]:
    answer = stage.world.reviewer.get(f"/v1/takes/{take_id}/fit")
    assert answer.status_code == 200, answer.text
    found: dict[str, Any] = answer.json()
    return found


def test_a_take_lies_among_the_approved_sounds_of_its_category(stage: Stage) -> None:
    cues = palette(stage)
    approved(stage, -3.0, 30.0, category="weapon")  # of no account here
    mine = sounding(stage, stage.take(stage.cue("ui_new", category="ui")), -13.0, 9.0)
    fit = fit_of(stage, mine)
    assert (fit["basis"], fit["category"], fit["is_apart"]) == ("category", "ui", True)
    assert fit["says"].startswith("Stands apart: louder than all of them, by 4.0 LU, ")
    loudness, spectrum, dryness, timbre = fit["measures"]
    assert [one["measure"] for one in fit["measures"]] == ["loudness", "spectrum", "dryness", "timbre"]
    assert (loudness["value"], loudness["middle"], loudness["stands"]) == (-13.0, -18.0, "above")
    assert [(one["cue"]["id"], one["value"]) for one in loudness["others"]] == [
        (str(cue), level) for cue, level in zip(cues, (-20.0, -18.0, -17.0), strict=True)
    ]
    assert all(one["is_palette"] for one in loudness["others"])
    assert dryness["stands"] == "within"
    assert (timbre["value"], timbre["stands"]) == (7.0, "above")  # from 2.0, the middle
    assert (spectrum["value"], spectrum["stands"]) == (pytest.approx(7 / 2**0.5), "above")


def test_a_take_sounds_like_the_nearest_cues_by_timbre(stage: Stage) -> None:
    one, two, three = palette(stage)
    far = approved(stage, -18.0, 30.0, category="weapon", palette=False, variations=2)
    sounding(stage, stage.take(far, 2, state=TakeState.APPROVED), -18.0, 2.5)  # a variation that is nearer
    fit = fit_of(stage, sounding(stage, stage.take(stage.cue("ui_new", category="ui")), -18.0, 2.8))
    alike = [(sound["cue"]["id"], round(sound["distance_db"], 1)) for sound in fit["sounds_like"]]
    assert alike == [(str(three), 0.2), (str(far), 0.3), (str(two), 0.8), (str(one), 1.8)]
    silent = fit_of(stage, sounding(stage, stage.take(stage.cue("ui_off", category="ui")), -18.0))
    assert silent["sounds_like"] == []


def test_the_palette_stands_in_where_a_category_is_too_young(stage: Stage) -> None:
    palette(stage)
    fit = fit_of(stage, sounding(stage, stage.take(stage.cue("boom", category="impact")), -18.0, 2.0))
    assert (fit["basis"], fit["is_apart"]) == ("palette", False)
    assert fit["says"] == "Within their range in everything measured."


def test_its_own_cue_is_not_among_those_it_is_compared_with(stage: Stage) -> None:
    first, *_ = palette(stage)
    approved(stage, -19.0, 2.0)
    fit = fit_of(stage, sounding(stage, stage.take(first), -18.0, 2.0))
    assert str(first) not in {one["cue"]["id"] for one in fit["measures"][0]["others"]}


@pytest.mark.slow
def test_the_variations_of_a_cue_are_one_sound(stage: Stage) -> None:
    palette(stage)
    cue_id = stage.cue("steps", category="ui", variations=3)
    for variation, loudness in enumerate((-30.0, -24.0, -23.0), start=1):
        sounding(stage, stage.take(cue_id, variation, state=TakeState.APPROVED), loudness)
    (loudness, *_) = fit_of(stage, sounding(stage, stage.take(stage.cue("a", category="ui")), -18.0))["measures"]
    assert [one["value"] for one in loudness["others"]] == [-20.0, -18.0, -17.0, -24.0]


def test_the_reason_why_nothing_is_compared_is_given(stage: Stage) -> None:
    mine = sounding(stage, stage.take(stage.cue("ui_new", category="ui")), -18.0)
    assert fit_of(stage, mine)["says"].startswith("No cue is marked as palette.")
    approved(stage, -18.0, 1.0)
    assert fit_of(stage, mine)["says"].startswith("Fewer than 3 other cues are approved")
    palette(stage)
    unheard = fit_of(stage, mine)
    assert [one["measure"] for one in unheard["measures"]] == ["loudness", "dryness"]
    assert unheard["says"].endswith("Spectrum and timbre are still being measured.")
    unmatched = stage.world.server.in_database(
        lambda session: add_take(session, stage.world, stage.delivery_id, None, 1, state=TakeState.RECEIVED)
    )
    assert fit_of(stage, unmatched)["says"].startswith("This version has not been checked")


def test_designers_compare_their_own_takes_and_the_team_deliveries(stage: Stage) -> None:
    take_id = stage.take(stage.cue())
    for address, status in ((f"/v1/takes/{take_id}/fit", 200), (f"/v1/deliveries/{stage.delivery_id}/fit", 403)):
        assert stage.world.designer.get(address).status_code == status
        assert stage.world.other_designer.get(address).status_code == 404
        assert stage.world.stranger.get(address).status_code == 404


@pytest.mark.parametrize(("choice", "others"), [(DesignersHear.OWN, 0), (DesignersHear.APPROVED, 3)])
def test_a_designer_is_compared_with_what_they_may_hear(stage: Stage, choice: DesignersHear, others: int) -> None:
    world = stage.world
    palette(stage)
    mine = sounding(stage, stage.take(stage.cue("ui_new", category="ui")), -13.0, 9.0)

    def given_to_another(session: Session) -> None:
        session.execute(update(Take).where(Take.id != mine).values(designer_id=world.other_designer_id))
        session.get_one(Project, world.project_id).designers_hear = choice

    world.server.in_database(given_to_another)
    fit = world.designer.get(f"/v1/takes/{mine}/fit").json()
    assert [len(measure["others"]) for measure in fit["measures"][:1]] == [others] * bool(others)
    assert len(fit["sounds_like"]) == others
    assert fit["first_delivery_id"] is None
    assert len(fit_of(stage, mine)["measures"][0]["others"]) == 3


def taken_over(stage: Stage) -> tuple[UUID, UUID]:
    """Return the first delivery of another designer, who takes over, and its one take."""
    world, delivery_id = stage.world, new_id()

    def write(session: Session) -> UUID:
        of = {"studio_id": world.studio_id, "project_id": world.project_id, "designer_id": world.other_designer_id}
        session.add(Engagement(**of, kind=EngagementKind.CONTRACT))
        session.add(Delivery(**of, id=delivery_id, number=2))
        session.flush()
        return add_take(session, world, delivery_id, cue_id, 1, designer_id=world.other_designer_id)

    cue_id = stage.cue("ui_alert", category="ui")
    return delivery_id, sounding(stage, world.server.in_database(write), -12.0, 2.0)


def test_a_replacement_designers_first_delivery_is_compared_with_the_work_before(stage: Stage) -> None:
    palette(stage)
    delivery_id, take_id = taken_over(stage)
    assert fit_of(stage, take_id)["first_delivery_id"] == str(delivery_id)
    answer = stage.world.reviewer.get(f"/v1/deliveries/{delivery_id}/fit").json()
    assert (answer["is_first"], answer["made_before_by"], answer["designer"]["name"]) == (
        True,
        ["Sound designer"],
        "Another sound designer",
    )
    (take,) = answer["takes"]
    assert (take["take_id"], take["cue"]["name"], take["is_apart"]) == (str(take_id), "ui_alert", True)
    assert take["file_name"] == "shield_hit.wav"
    loudness = answer["shifts"][0]
    assert (loudness["measure"], loudness["compared"], loudness["apart"], loudness["shift"]) == ("loudness", 1, 1, 6.0)


def test_what_came_back_is_not_compared_and_ones_own_work_is_not_the_work_before(stage: Stage) -> None:
    palette(stage)
    own = stage.world.reviewer.get(f"/v1/deliveries/{stage.delivery_id}/fit").json()
    assert (own["made_before_by"], own["shifts"]) == ([], [])
    assert {take["basis"] for take in own["takes"]} == {None}
    mine = stage.take(stage.cue("again", category="ui"), state=TakeState.RETURNED)
    after = stage.world.reviewer.get(f"/v1/deliveries/{stage.delivery_id}/fit").json()
    assert str(mine) not in {take["take_id"] for take in after["takes"]}
