"""Languages, states, lengths and orders, without a server."""

from datetime import UTC, date, datetime, timedelta

import pytest

from app.core.db import new_id
from app.deliveries.rules import TakeState
from app.voice_lines.rules import (
    LineState,
    TakeFacts,
    TextFrom,
    Validity,
    file_statuses,
    is_covered,
    is_known_language,
    is_length_off,
    is_stale,
    key_for,
    language_tag,
    length_percent,
    line_status,
    merged_order,
)

START = datetime(2026, 11, 2, 9, tzinfo=UTC)
FIRST = TextFrom("Go.", START)


def hours(count: int) -> datetime:
    return START + timedelta(hours=count)


def take(number: int, state: TakeState, at: int, variation: int = 1) -> TakeFacts:
    return TakeFacts(new_id(), variation, number, state, hours(at), 1.0)


@pytest.mark.parametrize(
    ("text", "tag"),
    [
        ("de", "de"), ("DE", "de"), ("German", "de"), ("Deutsch", "de"), ("pt_br", "pt-BR"), ("zh-hans", "zh-Hans"),
        ("es-419", "es-419"), ("Chinese (Simplified)", "zh-Hans"), ("日本語", "ja"), ("direction", None), ("", None),
        ("d", None), ("de/at", None), ("../en", None), ("en" * 5_000, None),
    ],
)  # fmt: skip
def test_a_language_is_its_tag_whatever_it_is_called(text: str, tag: str | None) -> None:
    assert language_tag(text) == tag


def test_an_id_is_made_of_the_name() -> None:
    assert key_for("Old Tom, the cook", 7) == "old_tom_the_cook_007"
    assert key_for("!!!", 1) == "line_001"


@pytest.mark.parametrize(
    ("texts", "stale"),
    [
        ([FIRST], False),
        ([FIRST, TextFrom("Stay.", hours(2))], True),
        ([FIRST, TextFrom("Stay.", hours(2)), TextFrom("Go.", hours(3))], False),
        ([FIRST, TextFrom("Go!", hours(2), takes_fit=True)], False),
        ([FIRST, TextFrom("Go!", hours(2), takes_fit=True), TextFrom("Stay.", hours(3))], True),
        ([TextFrom("Stay.", hours(-1)), TextFrom("Go.", hours(0))], False),
    ],
    ids=["never changed", "changed", "changed back", "said to fit", "changed after", "changed before the take"],
)
def test_a_take_is_stale_by_the_text_of_its_time(texts: list[TextFrom], *, stale: bool) -> None:
    assert is_stale(texts, hours(1)) is stale


@pytest.mark.parametrize(
    ("takes", "state"),
    [
        ([], LineState.NO_TAKE),
        ([(1, TakeState.SET_ASIDE, 1)], LineState.NO_TAKE),
        ([(1, TakeState.RECEIVED, 3)], LineState.IN_REVIEW),
        ([(1, TakeState.CONFORMING, 3)], LineState.IN_REVIEW),
        ([(1, TakeState.RETURNED, 3)], LineState.RETURNED),
        ([(1, TakeState.CHANGE_REQUESTED, 3)], LineState.CHANGE_REQUESTED),
        ([(1, TakeState.CHANGE_REQUESTED, 3), (2, TakeState.CONFORMING, 4)], LineState.IN_REVIEW),
        ([(1, TakeState.APPROVED, 3), (2, TakeState.RETURNED, 4)], LineState.APPROVED),
        ([(1, TakeState.APPROVED, 1)], LineState.STALE),
        ([(1, TakeState.APPROVED, 1), (2, TakeState.CONFORMING, 3)], LineState.IN_REVIEW),
        ([(1, TakeState.APPROVED, 1), (2, TakeState.APPROVED, 3)], LineState.APPROVED),
    ],
)
def test_the_state_of_a_line(takes: list[tuple[int, TakeState, int]], state: LineState) -> None:
    texts = [FIRST, TextFrom("Stay.", hours(2))]
    status = line_status(file_statuses([take(*one) for one in takes], texts, variations=1, is_cut=False))
    assert status.state is state
    assert status.recorded_text == ("Go." if state is LineState.STALE else None)
    assert {status.state for status in file_statuses([], texts, variations=2, is_cut=True)} == {LineState.CUT}


@pytest.mark.parametrize(
    ("second", "state"),
    [
        ([], LineState.NO_TAKE),
        ([(1, TakeState.APPROVED, 1, 2)], LineState.STALE),
        ([(1, TakeState.RETURNED, 3, 2)], LineState.RETURNED),
        ([(1, TakeState.CONFORMING, 3, 2)], LineState.IN_REVIEW),
        ([(1, TakeState.APPROVED, 3, 2)], LineState.APPROVED),
    ],
)
def test_a_line_of_two_files_is_as_far_as_the_one_behind(
    second: list[tuple[int, TakeState, int, int]], state: LineState
) -> None:
    texts = [FIRST, TextFrom("Stay.", hours(2))]
    takes = [take(1, TakeState.APPROVED, 3), *(take(*facts) for facts in second)]
    statuses = file_statuses(takes, texts, variations=2, is_cut=False)
    assert [status.state for status in statuses] == [LineState.APPROVED, state]
    assert line_status(statuses).state is state


@pytest.mark.parametrize(
    ("take_s", "original_s", "percent", "off"),
    [(1.1, 1.0, 10.0, False), (1.11, 1.0, 11.0, True), (0.8, 1.0, -20.0, True), (None, 1.0, None, False),
     (1.0, None, None, False), (1.0, 0.0, None, False)],
)  # fmt: skip
def test_a_length_against_the_original(
    take_s: float | None, original_s: float | None, percent: float | None, *, off: bool
) -> None:
    found = length_percent(take_s, original_s)
    assert (found, is_length_off(found, 10)) == (percent, off)


def test_a_release_counts_on_its_first_and_last_day() -> None:
    year = Validity(date(2026, 1, 1), date(2026, 12, 31))
    days = [date(2025, 12, 31), date(2026, 1, 1), date(2026, 12, 31), date(2027, 1, 1)]
    assert [is_covered([year], day) for day in days] == [False, True, True, False]
    assert is_covered([year, Validity(date(2027, 1, 1), None)], date(2040, 1, 1))
    assert not is_covered([], date(2026, 1, 1))


@pytest.mark.parametrize(
    ("present", "script", "order"),
    [
        ("", "abc", "abc"),
        ("abc", "cab", "cab"),  # the script has them all, and so gives the order
        ("abc", "cxab", "cxab"),
        ("abcd", "bxy", "abxycd"),  # a part of a script adds its lines where they belong
        ("abc", "x", "abcx"),
        ("abc", "c", "abc"),
    ],
)
def test_the_order_after_an_import(present: str, script: str, order: str) -> None:
    assert "".join(merged_order(present, script)) == order


@pytest.mark.parametrize(
    ("text", "known"),
    [
        ("de", True),
        ("de-AT", True),
        ("zh-Hans", True),
        ("German", True),
        ("xx-DE", False),
        ("Deck", False),
        ("", False),
    ],
)
def test_a_language_is_known_by_its_own_code(text: str, known: bool) -> None:
    assert is_known_language(text) is known
