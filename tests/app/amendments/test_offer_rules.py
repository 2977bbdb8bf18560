"""Change orders that are offered, as plain rules: facts in words, days that moved."""

from datetime import UTC, datetime, timedelta
from typing import Any
from uuid import UUID

import pytest

from app.amendments.offer_rules import ListChange, day_after_answer, earlier_day, facts_in_words, net_change

AT = datetime(2026, 11, 20, 14, tzinfo=UTC)
CUE = UUID(int=1)


def change(revision: int, before: dict[str, Any], after: dict[str, Any]) -> ListChange:
    return ListChange(CUE, revision, AT, "Producer", before, after)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ([change(1, {"loop": False}, {"loop": True})], "loop yes instead of no"),
        ([change(1, {"loop": False}, {"loop": True}), change(2, {"loop": True}, {"loop": False})], ""),
        ([change(1, {"duration_s": None}, {"duration_s": 1.5})], "length 1.5 s instead of none"),
        ([change(1, {"trigger": ""}, {"trigger": "on hit"})], ""),
        ([change(1, {"description": "a"}, {"description": "b"})], "description"),
    ],
)
def test_facts_in_words(changes: list[ListChange], words: str) -> None:
    assert facts_in_words(net_change(changes, ["description", "duration_s", "loop"])) == words


@pytest.mark.parametrize(
    ("before", "after", "agreed", "moved"),
    [
        (None, "2026-11-10", "2026-11-20", ("2026-11-20", "2026-11-10")),
        ("2026-11-15", "2026-11-10", "2026-11-20", ("2026-11-15", "2026-11-10")),
        ("2026-11-15", "2026-11-18", "2026-11-20", None),
        (None, "2026-11-20", "2026-11-20", None),
        (None, "2026-11-10", None, None),
        ("2026-11-10", None, "2026-11-20", None),
    ],
)
def test_an_earlier_day(before: str | None, after: str | None, agreed: str | None, moved: Any) -> None:
    found = earlier_day(
        [change(1, {"due_on": before}, {"due_on": after})], datetime.fromisoformat(agreed).date() if agreed else None
    )
    assert (found and tuple(one.isoformat() for one in found)) == moved


@pytest.mark.parametrize(
    ("asked", "due", "answered", "moved"),
    [(-4, -1, 0, 3), (-4, 0, 0, None), (-1, -2, 0, None), (-2, -2, -1, -1)],
)
def test_the_day_after_a_late_answer(asked: int, due: int, answered: int, moved: int | None) -> None:
    found = day_after_answer(
        (AT + timedelta(days=due)).date(), AT + timedelta(days=asked), AT + timedelta(days=answered)
    )
    assert found == (None if moved is None else (AT + timedelta(days=moved)).date())
