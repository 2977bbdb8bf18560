"""When a link opens, which take is heard, whose keys they are and where the playhead stands."""

from datetime import UTC, datetime, timedelta
from typing import Any
from uuid import UUID, uuid4

import pytest

from app.deliveries.rules import TakeState
from app.shares.guests import plain_name
from app.shares.rules import (
    VISIT_LASTS,
    Candidate,
    LinkState,
    heard_takes,
    holder_now,
    link_secret,
    link_state,
    playhead_s,
    present_now,
    visit_is_over,
)

NOW = datetime(2026, 11, 26, 12, tzinfo=UTC)
SECOND = timedelta(seconds=1)
OPEN: dict[str, Any] = {"revoked_at": None, "expires_at": None, "max_openings": None, "openings": 7}


@pytest.mark.parametrize(
    ("facts", "state"),
    [
        ({}, LinkState.OPEN),
        ({"expires_at": NOW + SECOND}, LinkState.OPEN),
        ({"expires_at": NOW}, LinkState.EXPIRED),
        ({"max_openings": 8}, LinkState.OPEN),
        ({"max_openings": 7}, LinkState.FULL),
        ({"max_openings": 1}, LinkState.FULL),
        ({"revoked_at": NOW - SECOND, "expires_at": NOW + SECOND}, LinkState.REVOKED),
        ({"revoked_at": NOW, "expires_at": NOW, "max_openings": 1}, LinkState.REVOKED),
    ],
)
def test_link_state(facts: dict[str, Any], state: LinkState) -> None:
    assert link_state(NOW, **(OPEN | facts)) is state


def test_a_visit_goes_on_although_its_link_is_full_and_ends_with_it() -> None:
    assert not visit_is_over(NOW, NOW - VISIT_LASTS + SECOND, revoked_at=None, expires_at=None)
    assert visit_is_over(NOW, NOW - VISIT_LASTS, revoked_at=None, expires_at=None)
    assert visit_is_over(NOW, NOW, revoked_at=NOW, expires_at=None)
    assert visit_is_over(NOW, NOW - SECOND, revoked_at=None, expires_at=NOW)


def test_the_secret_follows_from_key_and_id_and_from_both() -> None:
    one, other = uuid4(), uuid4()
    assert link_secret("key", one) == link_secret("key", one)
    assert len({link_secret("key", one), link_secret("key", other), link_secret("another", one)}) == 3
    assert len(link_secret("key", one)) == 43  # 256 bits


def test_the_approved_take_of_a_variation_is_heard_else_the_newest() -> None:
    cue = UUID(int=1)
    a1, a2, b1, b2 = (UUID(int=number) for number in (11, 12, 21, 22))
    takes = [
        Candidate(a1, cue, 1, 1, TakeState.APPROVED),
        Candidate(a2, cue, 1, 2, TakeState.CONFORMING),
        Candidate(b1, cue, 2, 1, TakeState.CONFORMING),
        Candidate(b2, cue, 2, 2, TakeState.CONFORMING),
    ]
    assert heard_takes(takes) == [a1, b2]
    assert heard_takes([]) == []


def test_the_keys_fall_free_when_their_holder_was_not_heard_of_for_ten_seconds() -> None:
    ada, ben = uuid4(), uuid4()
    seen = [(ada, NOW - 9.9 * SECOND), (ben, NOW - 10 * SECOND)]
    assert set(present_now(NOW, seen)) == {ada}
    assert holder_now(NOW, ada, seen) == ada
    assert holder_now(NOW, ben, seen) is None
    assert holder_now(NOW, None, seen) is None
    assert holder_now(NOW, ada, []) is None


def test_a_playhead_moves_on_while_it_plays() -> None:
    assert playhead_s(NOW, 1.5, NOW - 2 * SECOND, is_playing=True) == pytest.approx(3.5)
    assert playhead_s(NOW, 1.5, NOW - 2 * SECOND, is_playing=False) == 1.5


@pytest.mark.parametrize(
    ("typed", "name"),
    [
        ("  Ada\tLovelace\n", "Ada Lovelace"),
        ("Ada\u202e", "Ada"),  # a sign that turns the direction of what follows
        ("\u200b\u200b", "without a name"),
        ("Zoë 日本", "Zoë 日本"),
    ],
)
def test_a_typed_name_stands_on_one_line(typed: str, name: str) -> None:
    assert plain_name(typed) == name
