"""A chain shows what was done to it, whatever that was."""

import random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.core.record import START, Entry, canonical, faults, link

AT = "2026-11-21T10:00:00.000000+00:00"


def chain(*kinds: str, of: str = "a contract") -> list[Entry]:
    entries: list[Entry] = []
    for seq, kind in enumerate(kinds, start=1):
        previous = entries[-1].sha256 if entries else START
        entries.append(link(previous, of=of, seq=seq, at=AT, kind=kind, payload=canonical({"seq": seq})))
    return entries


def found(entries: list[Entry], whole: list[Entry], of: str = "a contract") -> list[str]:
    last = whole[-1].sha256 if whole else START
    return list(faults(entries, of=of, length=len(whole), last_sha256=last))


def test_a_whole_chain_has_no_faults():
    for length in range(4):
        whole = chain(*"abcd"[:length])
        assert found(whole, whole) == []


def test_canonical_text_does_not_depend_on_order():
    assert canonical({"b": 1, "a": "ß"}) == canonical({"a": "ß", "b": 1}) == '{"a":"ß","b":1}'
    with pytest.raises(ValueError, match="not JSON compliant"):
        canonical({"a": float("nan")})


def test_the_end_is_known():
    whole = chain("a", "b", "c")
    assert found(whole[:2], whole) == ["the last 1 of 3 entries is missing"]
    assert found(whole, whole[:2]) == ["1 entry was added past the end"]


def test_a_chain_is_of_one_contract():
    whole = chain("a", "b")
    assert found(whole, whole, of="another contract") == ["entry 1 was altered", "entry 2 was altered"]


def test_rewriting_the_rest_shows_at_the_end():
    whole = chain("a", "b", "c")
    assert found(chain("a", "B", "c"), whole) == ["entry 3 is not the one that was written last"]


@pytest.mark.slow
@given(st.integers(2, 12), st.integers(0, 2**32), st.sampled_from(["alter", "delete", "swap", "payload", "time"]))
def test_whatever_is_done_to_one_entry_shows(length: int, seed: int, deed: str):
    whole = chain(*(f"kind {place}" for place in range(length)))
    rng = random.Random(seed)
    entries, place = whole[:], rng.randrange(length)
    entry = entries[place]
    match deed:
        case "alter":
            entries[place] = Entry(**{**vars(entry), "kind": "paid"})
        case "payload":
            entries[place] = Entry(**{**vars(entry), "payload": canonical({"seq": -1})})
        case "time":
            entries[place] = Entry(**{**vars(entry), "at": AT.replace("10:", "11:")})
        case "delete":
            del entries[place]
        case "swap":  # as rows would be: the numbers stay, what they say changes places
            other = rng.choice([each for each in range(length) if each != place])
            entries[place] = Entry(**{**vars(whole[other]), "seq": whole[place].seq})
            entries[other] = Entry(**{**vars(whole[place]), "seq": whole[other].seq})
    assert found(entries, whole)
