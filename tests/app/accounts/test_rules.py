from typing import Any

import pytest
import zxcvbn

from app.accounts import common_passwords
from app.accounts.errors import BadAddress, LastProducer, PasswordTooWeak
from app.accounts.rules import Role, ensure_address, ensure_producer_remains, ensure_strong_password

PRODUCER, REVIEWER, NOBODY = frozenset({Role.PRODUCER}), frozenset({Role.REVIEWER}), frozenset[Role]()


@pytest.mark.parametrize(
    ("typed", "kept"),
    [
        ("name@studio.example", "name@studio.example"),
        ("  Name.Surname+games@Studio.Example ", "name.surname+games@studio.example"),
        ("o'neil@localhost", "o'neil@localhost"),
    ],
)
def test_addresses_are_kept_in_one_form(typed: str, kept: str) -> None:
    assert ensure_address(typed) == kept


@pytest.mark.parametrize(
    "typed",
    [
        "",
        "name",
        "@studio.example",
        "name@",
        "a@b@c.example",
        "name@studio..example",
        "name@-studio.example",
        "two words@studio.example",
        "name@studio.example\nBcc: everyone@studio.example",
        "Name <name@studio.example>",
        "name@studio.example, other@studio.example",
        "näme@studio.example",
        "x" * 65 + "@studio.example",
        "name@" + "s" * 250 + ".example",
    ],
)
def test_text_that_is_not_an_address_is_refused_with_a_reason(typed: str) -> None:
    with pytest.raises(BadAddress) as refused:
        ensure_address(typed)
    assert refused.value.errors[0]["where"] == "email"


@pytest.mark.parametrize(
    ("password", "is_good"),
    [
        (None, False),
        ("", False),
        ("ninechars", False),
        ("kqzvbnwpth", True),
        ("1234567890", False),
        ("qwertyuiop", False),
        ("asdfghjkl;", False),
        ("Password123!", False),
        ("abcdefghijkl", False),
        ("soundlist2026", False),
        ("studioexample", False),
        ("SurnameAda1", False),
        ("16.07.1969", False),
        ("aaaaaaaaaaaa", False),
        ("ababababcbab", False),
        ("Name.Surname@studio.example", False),
        ("name.surname", False),
        ("correct horse battery", True),
        ("correct horse battery staple", False),  # a common one, however it is spelt
        ("Correct-Horse-Battery-Staple!", False),
        ("correcthorsebatterystaple2026", False),
        ("welcome2026now", False),
        ("letmein2026please", False),
        ("iloveyou123456", False),
        ("Glasshouse2026!", False),  # the studio's name
        ("x9" * 20, False),  # two different characters
        ("a quiet room, four chairs. " * 7, True),
        ("a quiet room, four chairs. " * 8, False),
    ],
)
def test_passwords(password: str | None, is_good: bool) -> None:
    if is_good:
        assert ensure_strong_password(password, "name.surname@studio.example") == password
        return
    with pytest.raises(PasswordTooWeak) as refused:
        ensure_strong_password(password, "name.surname@studio.example", "Ada Surname", "Glasshouse Audio")
    assert refused.value.errors[0]["where"] == "password"


def test_the_list_holds_the_most_common_hundred_thousand() -> None:
    assert common_passwords._listed().count(b"\n") > 100_000
    assert common_passwords.is_common("ThisIsAPassword")
    assert not common_passwords.is_common("thisisapasswor")


def test_names_of_three_letters_count_as_known_and_shorter_ones_do_not(monkeypatch: pytest.MonkeyPatch) -> None:
    known: list[str] = []
    guess = zxcvbn.zxcvbn

    def recorded(password: str, user_inputs: list[str]) -> dict[str, Any]:
        known.extend(user_inputs)
        return guess(password, user_inputs=user_inputs)

    monkeypatch.setattr(zxcvbn, "zxcvbn", recorded)
    ensure_strong_password("four chairs in a quiet room", "jo@studio.example", "Bo", "Ada")
    assert "Ada" in known
    assert {"Bo", "jo"}.isdisjoint(known)


@pytest.mark.parametrize(
    ("others", "wanted", "is_allowed"),
    [
        ([PRODUCER], NOBODY, True),
        ([REVIEWER, PRODUCER], REVIEWER, True),
        ([], PRODUCER, True),
        ([], REVIEWER, False),
        ([REVIEWER], NOBODY, False),
        ([], NOBODY, False),
    ],
)
def test_a_studio_keeps_a_producer(others: list[frozenset[Role]], wanted: frozenset[Role], is_allowed: bool) -> None:
    if is_allowed:
        ensure_producer_remains(others, wanted)
        return
    with pytest.raises(LastProducer):
        ensure_producer_remains(others, wanted)
