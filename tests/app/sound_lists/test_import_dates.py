"""Due dates in spreadsheets as people write them."""

from datetime import date

import pytest

from tests.app.sound_lists.test_imports import cues, send, workbook
from tests.support.server import World


@pytest.mark.parametrize(
    ("head", "cells", "days"),
    [
        ("Due date", ["2026-12-04", ""], ["2026-12-04", None]),
        ("Fällig am", ["4.12.2026", "04.12.26"], ["2026-12-04", "2026-12-04"]),
        ("Deadline", ["31/5/2026", "4/5/2026"], ["2026-05-31", "2026-05-04"]),  # the first shows the order of all
        ("Needed by", ["5/31/2026", "5/4/2026"], ["2026-05-31", "2026-05-04"]),
        ("Due", ["Dec 4, 2026", "4 December 2026"], ["2026-12-04", "2026-12-04"]),
        ("Liefertermin", ["4. März 2027", "tbd"], ["2027-03-04", None]),
    ],
)
def test_due_dates_as_people_write_them(world: World, head: str, cells: list[str], days: list[str | None]) -> None:
    rows = "\n".join(f"cue_{place}\t{cell}" for place, cell in enumerate(cells))
    read = send(world, f"Name\t{head}\n{rows}", format="paste")
    assert read["columns"][1]["field"] == "due_on"
    assert [cue["due_on"] for cue in cues(world)] == days


def test_a_day_that_could_be_two_is_asked_for(world: World) -> None:
    read = send(world, "Name\tDue\ndoor\t4/5/2026", format="paste")
    [error] = read["errors"]
    assert error["message"] == '"4/5/2026" could be 04 May or 05 April; write 2026-05-04'
    assert not read["imported"]


def test_days_in_a_workbook_come_in_and_go_out(world: World) -> None:
    send(world, workbook([["Name", "Due date"], ["door", date(2026, 12, 4)]]), format="xlsx")
    assert [cue["due_on"] for cue in cues(world)] == ["2026-12-04"]
    exported = world.producer.get(f"/v1/projects/{world.project_id}/sound-list.csv").text
    assert "due_on" in exported.splitlines()[0]
    assert "2026-12-04" in exported.splitlines()[1]


def test_a_due_date_is_changed_and_the_change_is_kept(world: World) -> None:
    send(world, "Name\tDue\ndoor\t2026-12-04", format="paste")
    [cue] = cues(world)
    answer = world.producer.patch(f"/v1/cues/{cue['id']}", json={"edition": cue["edition"], "due_on": "2026-12-11"})
    assert answer.status_code == 200, answer.text
    address = f"/v1/projects/{world.project_id}/sound-list/revisions/compare"
    [change] = world.producer.get(address, params={"from": 1, "to": 2}).json()["changed"][0]["changes"]
    assert (change["field"], change["before"], change["after"]) == ("due_on", "2026-12-04", "2026-12-11")
