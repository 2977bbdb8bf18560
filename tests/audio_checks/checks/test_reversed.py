"""`reversed`: a warning only where the spec names it, and never for a loop."""

import pytest

from audio_checks.spec.delivery_spec import CueFacts
from tests.support.rooms import knell
from tests.support.waves import noise, silence

ASKED = "checks.reversed = 'warning'"
HEARD = ["reversed:heard"]
FORWARDS, BACKWARDS = knell(), knell()[::-1]


@pytest.mark.parametrize(
    ("samples", "codes"),
    [
        (BACKWARDS, HEARD),
        (FORWARDS, []),
        (knell(channels=2)[::-1], HEARD),
        (noise(), []),
        (silence(), []),
        (silence(seconds=1 / 48_000) + 0.5, []),
    ],
    ids=["backwards", "forwards", "stereo", "noise", "silence", "one frame"],
)
def test_only_what_is_turned_round(codes_of, samples, codes):
    assert codes_of("reversed", samples, ASKED) == codes


@pytest.mark.parametrize(("tables", "codes"), [("", []), (ASKED, HEARD), ("engine.adds = ['reverb']", [])])
def test_only_where_the_spec_asks(codes_of, tables, codes):
    assert codes_of("reversed", BACKWARDS, tables) == codes


def test_a_loop_has_no_beginning(codes_of):
    assert codes_of("reversed", BACKWARDS, ASKED, cue=CueFacts("SW-001", loop=True)) == []
    assert codes_of("reversed", BACKWARDS, ASKED, cue=CueFacts("SW-001")) == HEARD


def test_it_asks(found_by):
    (finding,) = found_by("reversed", BACKWARDS, ASKED)
    assert finding.message.endswith("is it meant so?")
    assert finding.measured > 0.5
