"""Hours before a contract: from the rows, from logged hours, and held against the dates that are asked for."""

from datetime import date, timedelta
from typing import Any

import pytest
import sqlalchemy as sa
from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.rules import AddressProof
from app.agreements.models import ContractCue
from app.agreements.rules import AcceptedBy
from app.core import clock
from app.dashboards.effort.rules import (
    NO_HOURS,
    Basis,
    Fit,
    Hours,
    Logged,
    Work,
    effort,
    finish_on,
    fit_of,
    size_of_game,
    usual_hours,
)
from app.hiring.roster.rules import Busy, BusyKind
from app.money.models import WorkLog
from app.sound_lists.kits.rules import Kit, all_kits
from tests.app.money.agreed import Agreed, milestone
from tests.support.server import World

MONDAY = date(2026, 11, 23)


def test_variations_and_length_add_to_the_usual_hours() -> None:
    assert usual_hours(Work("impact", 1, 2.0)) == Hours(0.8, 1.4)
    assert usual_hours(Work("impact", 6, None)) == Hours(pytest.approx(0.8 * 1.5), pytest.approx(1.4 * 2))
    assert usual_hours(Work("ambience_cave", 1, 90.0)) == Hours(2.8, 5.2)  # a minute beyond the first half: twice
    assert usual_hours(Work("ambience", 1, 3600.0)) == Hours(pytest.approx(1.4 * 6), pytest.approx(2.6 * 6))
    assert usual_hours(Work("", 1, None)) == usual_hours(Work("unheard of", 1, 0.2)) == Hours(0.8, 2.0)


@pytest.mark.parametrize(
    ("ucs", "ours"),
    [
        ("user-interface", "ui"),
        ("FEETHmn", "footsteps"),
        ("FOLYClth", "foley"),
        ("weapswrd", "weapon"),
        ("explreal", "explosion"),
        ("magspel", "magic"),
        ("creabeast", "creature"),
        ("vehcar", "vehicle"),
        ("muscloop", "music"),
    ],
)
def test_categories_of_the_universal_category_system_take_the_hours_of_our_words(ucs: str, ours: str) -> None:
    assert usual_hours(Work(ucs, 1, None)) == usual_hours(Work(ours, 1, None)) != usual_hours(Work("", 1, None))


@pytest.mark.parametrize("kit", all_kits(), ids=lambda kit: kit.key)
def test_usual_hours_agree_with_those_of_the_starter_kits(kit: Kit) -> None:
    lines = effort([Work(cue.category, cue.variations, cue.duration_s) for cue in kit.cues], [])
    ours = sum((line.hours for line in lines), NO_HOURS)
    low, high = (kit.usual_hours[end] / kit.usual_cues[end] for end in (0, 1))
    assert ours.low_h / len(kit.cues) <= high
    assert ours.high_h / len(kit.cues) >= low


def test_logged_hours_replace_the_usual_ones_from_three_cues_on() -> None:
    impact = Work("impact", 1, None)  # 1.1 h in the middle
    logged = [Logged(impact, round(60 * 1.1 * factor)) for factor in (1, 2, 3, 4, 5)]
    (line,) = effort([impact] * 10, [(Basis.DESIGNER, logged[:2]), (Basis.STUDIO, logged)])
    assert (line.basis, line.based_on, line.cues) == (Basis.STUDIO, 5, 10)
    assert (line.hours.low_h, line.hours.high_h) == (pytest.approx(22.0), pytest.approx(44.0))  # twice to four times
    (line,) = effort([impact], [(Basis.DESIGNER, logged[:3]), (Basis.STUDIO, logged)])
    assert (line.basis, line.based_on) == (Basis.DESIGNER, 3)
    (line,) = effort([Work("music", 1, 60.0)], [(Basis.STUDIO, logged)])  # of all kinds, where none is of its kind
    assert (line.basis, line.based_on) == (Basis.STUDIO, 5)
    ambiences = [Logged(Work("ambience", 1, None), 60 * 2)] * 3  # 2 h is their usual middle
    lines = effort([impact, Work("ambience", 1, None), Work("vo", 1, None)], [(Basis.STUDIO, logged + ambiences)])
    assert {line.category: (line.based_on, line.hours.low_h) for line in lines} == {
        "impact": (5, pytest.approx(1.1 * 2)),  # each by the cues of its kind
        "ambience": (3, pytest.approx(2.0)),
        "vo": (8, pytest.approx(0.35)),  # by all eight: 1, 1, 1, 1, 2, 3, 4 and 5 times the usual
    }
    (line,) = effort([impact], [(Basis.STUDIO, logged[:2])])
    assert (line.basis, line.hours) == (Basis.USUAL, Hours(0.8, 1.4))


def test_an_estimate_of_the_plan_is_taken_as_it_is() -> None:
    (line,) = effort([Work("ui", 3, None, estimate_min=90)], [])
    assert (line.basis, line.files, line.hours) == (Basis.PLAN, 3, Hours(1.5, 1.5))


def test_work_ends_on_working_days_that_are_not_taken() -> None:
    assert finish_on(30, MONDAY, 30) == MONDAY + timedelta(days=4)  # a whole week ends on Friday
    assert finish_on(30.1, MONDAY, 30) == MONDAY + timedelta(days=7)
    assert finish_on(1, MONDAY + timedelta(days=5), 30) == MONDAY + timedelta(days=7)  # begun on a Saturday
    booked = Busy(MONDAY, MONDAY + timedelta(days=2))
    half = Busy(MONDAY + timedelta(days=3), MONDAY + timedelta(days=4), BusyKind.HALF_DAYS)
    assert finish_on(6, MONDAY, 30, [booked, half]) == MONDAY + timedelta(days=4)
    assert finish_on(0, MONDAY, 30) == MONDAY
    assert finish_on(100_000, MONDAY, 1) is None


def test_a_due_day_before_the_earliest_is_impossible() -> None:
    early, late = MONDAY, MONDAY + timedelta(days=10)
    assert fit_of(None, early, late) is None
    assert fit_of(early - timedelta(days=1), early, late) is Fit.IMPOSSIBLE
    assert fit_of(early, early, late) is Fit.TIGHT
    assert fit_of(late, early, late) is Fit.FITS
    assert fit_of(late, None, None) is Fit.IMPOSSIBLE


def test_a_brief_leads_to_cues_by_scene_and_category() -> None:
    scenes = [
        {"scene": "Harbour", "ambience": "gulls", "music": True},
        {"scene": "Menu", "ambience": "", "music": True},
    ]
    lines = size_of_game(["ambience", "ui", "weapon", "cinematic"], scenes, all_kits())
    assert [(line.scene, line.category, line.low_cues, line.high_cues) for line in lines[:3]] == [
        ("Harbour", "ambience", 1, 2),
        ("Harbour", "music", 1, 1),
        ("Menu", "music", 1, 1),
    ]
    assert [line.category for line in lines[3:]] == ["ui", "weapon"]  # no kit has cinematics; scenes have the ambiences
    (only,) = size_of_game(["ui"], [], [kit for kit in all_kits() if kit.key == "card-game"])
    assert (only.low_cues, only.high_cues) == (18, 51)  # 11 of 30 rows, of 50 to 140 cues


@pytest.fixture
def agreed(world: World) -> Agreed:
    return Agreed(world)


def read(world: World, by: str = "producer", **params: Any) -> Any:
    return getattr(world, by).get(f"/v1/projects/{world.project_id}/effort", params=params)


def test_a_posting_says_which_dates_are_impossible(world: World) -> None:
    project = f"/v1/projects/{world.project_id}"
    world.producer.post(f"{project}/cues", json={"cues": [{"name": "Boom", "category": "impact", "variations": 6}]})
    posting = {"title": "Sounds", "phase": "production", "currency": "USD", "scope": "all"}
    made = world.producer.post(f"{project}/postings", json=posting).json()
    tomorrow = str(clock.now().date() + timedelta(days=1))
    answer = read(world, posting_id=made["id"], due_on=tomorrow, weekly_hours=1).json()
    assert (answer["cues"], answer["files"], answer["concepts"], answer["fit"]) == (1, 6, 1, "impossible")
    assert (round(answer["low_h"], 2), round(answer["high_h"], 2)) == (1.2, 2.8)
    assert answer["lines"][0]["basis"] == "usual"
    assert answer["earliest_on"] > tomorrow
    later = read(world, posting_id=made["id"], due_on=str(clock.now().date() + timedelta(days=60))).json()
    assert (later["fit"], later["weekly_hours"], later["weekly_hours_from"]) == ("fits", 30.0, "assumed")
    for by, status in (("designer", 403), ("reviewer", 403), ("stranger", 404)):
        assert read(world, by, posting_id=made["id"]).status_code == status
    assert read(world, posting_id=str(world.project_id)).status_code == 404


def test_a_cue_with_bounds_alone_is_as_long_as_they_allow(world: World) -> None:
    wind = {"name": "Wind", "category": "ambience", "duration_min_s": 60, "duration_max_s": 90}
    made = world.producer.post(f"/v1/projects/{world.project_id}/cues", json={"cues": [wind]})
    assert made.status_code == 201, made.text
    answer = read(world).json()
    assert (answer["low_h"], answer["high_h"]) == (2.8, 5.2)  # of 90 s: twice the usual


@pytest.mark.slow
@pytest.mark.both_databases
def test_a_contract_counts_by_its_designers_logged_hours_and_week(world: World, agreed: Agreed) -> None:
    done = [agreed.cue(f"done {number}", category="ui", duration_max_s=90.0) for number in range(3)]
    agreed.agree(milestone("Alpha", *done, amount_minor=10_000))
    agreed.cue("next", category="ui")

    def log(session: Session) -> str:
        for covered in session.scalars(sa.select(ContractCue).where(ContractCue.cue_id.in_(done))):
            covered.accepted_at, covered.accepted_by = clock.now(), AcceptedBy.VERDICT
            of = {"studio_id": world.studio_id, "project_id": world.project_id, "logged_by": world.designer_id}
            session.add(
                WorkLog(**of, contract_id=covered.contract_id, cue_id=covered.cue_id, minutes=120, worked_on=MONDAY)
            )
        person = session.get_one(Person, world.designer_id)
        person.email_proof, person.email_verified_at = next(iter(AddressProof)), clock.now()
        return person.email

    email = world.server.in_database(log)
    entry = {"name": "Sound designer", "email": email, "weekly_hours": 4}
    assert world.producer.post(f"/v1/studios/{world.studio_id}/roster", json=entry).status_code == 201
    whole = read(world).json()
    assert (whole["cues"], whole["lines"][0]["basis"], whole["low_h"]) == (1, "studio", 1.0)  # of 90 s they took 2 h
    assert read(world, "approver").json()["lines"][0]["basis"] == "usual"  # logged hours are for producers
    answer = read(world, contract_id=str(agreed.contract_id)).json()
    assert (answer["weekly_hours"], answer["weekly_hours_from"]) == (4.0, "roster")
    assert answer["lines"][0]["basis"] == "designer"


def test_the_team_reads_the_size_that_the_brief_leads_to(world: World) -> None:
    path = f"/v1/projects/{world.project_id}/size-estimate"
    empty = world.producer.get(path).json()
    assert (empty["low_cues"], empty["lines"]) == (0, [])
    answers = {
        "categories": {"value": ["ui", "cinematic"]},
        "scenes": {"value": [{"scene": "Cave", "ambience": "drips", "music": False}]},
    }
    sent = world.producer.patch(f"/v1/projects/{world.project_id}/brief", json={"revision": 0, "answers": answers})
    assert sent.status_code == 200, sent.text
    size = world.reviewer.get(path, params={"kit": "card-game"}).json()
    assert (size["low_cues"], size["high_cues"], size["unknown"]) == (19, 53, ["cinematic"])
    assert [line["scene"] for line in size["lines"]] == ["Cave", ""]
    assert world.producer.get(path, params={"kit": "none"}).status_code == 404
    assert world.designer.get(path).status_code == 403
    assert world.stranger.get(path).status_code == 404


def test_a_day_beyond_the_calendar_is_refused(world: World) -> None:
    for name in ("begin_on", "due_on"):
        answer = read(world, **{name: "9999-12-31"})
        assert answer.status_code == 422
        assert name in answer.json()["errors"][0]["where"]
