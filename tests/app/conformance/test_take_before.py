"""A take's reverb is judged beside the designer's take before it, where there is one to be read."""

from typing import Any

import pytest

from app.conformance.rules import with_reverb_before
from tests.support.deliver import add_cues, checked, deliver
from tests.support.rooms import hits, in_a_room
from tests.support.server import World
from tests.support.waves import Samples, wav_bytes

DRY = hits()
WET = in_a_room(DRY, rt60_s=0.8, wet_db=-6.0)


@pytest.fixture
def judged_before(world: World):
    """Deliver sounds one after the other for one cue, and return what the last one is beside the one before."""
    add_cues(world, {"name": "knock", "category": "foley"})

    def judged_before(*sounds: bytes, name: str = "knock.wav") -> tuple[dict[str, Any], Any]:
        takes = []
        for sound in sounds:
            takes.append(deliver(world, name, sound))
            judged = checked(world, takes[-1]["id"])["judgements"]
        return takes[-2] if len(takes) > 1 else takes[0], judged.get("reverb", {}).get("before")

    return judged_before


def master(samples: Samples) -> bytes:
    return wav_bytes(samples)


@pytest.mark.slow
def test_a_first_take_has_none_before_it(judged_before) -> None:
    assert judged_before(master(DRY))[1] is None


@pytest.mark.slow
@pytest.mark.parametrize(("sounds", "verdict"), [((DRY, WET), "more reverb"), ((WET, DRY), "less reverb")])
def test_the_second_says_whether_it_has_more_than_the_first(judged_before, sounds, verdict) -> None:
    first, before = judged_before(*(master(samples) for samples in sounds))
    assert (before["verdict"], before["take_id"], before["number"]) == (verdict, first["id"], 1)
    assert before["rt60_s"] == pytest.approx(0.8, rel=0.15)
    assert before["evidence"]["bands"]


@pytest.mark.slow
def test_the_third_is_judged_beside_the_second(judged_before) -> None:
    second, before = judged_before(master(WET), master(DRY), master(0.5 * DRY))
    assert (before["verdict"], before["take_id"], before["number"]) == ("as much reverb", second["id"], 2)


@pytest.mark.slow
def test_an_alternate_is_another_idea_and_no_earlier_take(world: World, judged_before) -> None:
    judged_before(master(DRY))
    other = deliver(world, "knock_altB.wav", master(WET))
    assert "before" not in checked(world, other["id"])["judgements"]["reverb"]


@pytest.mark.slow
def test_what_could_not_be_read_is_passed_over(judged_before) -> None:
    assert judged_before(b"no sound", master(DRY))[1] is None


def test_a_known_report_loses_the_comparison_of_another_take() -> None:
    known = {"judgements": {"reverb": {"verdict": "dry", "before": {"number": 1}}, "lossy": {"verdict": "clean"}}}
    assert with_reverb_before(known, None)["judgements"]["reverb"] == {"verdict": "dry"}
    assert with_reverb_before(known, {"number": 2})["judgements"]["reverb"]["before"] == {"number": 2}
    assert with_reverb_before({"judgements": {}}, {"number": 2}) == {"judgements": {}}
