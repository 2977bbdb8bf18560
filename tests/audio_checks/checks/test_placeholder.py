"""`placeholder`: placeholders are known by their mark."""

import pytest

from audio_checks.audio.audio_file import AudioFile
from audio_checks.run.runner import is_placeholder
from tests.support.chunks import ixml
from tests.support.waves import chunk, placeholder_mark, silence, sine, write_wav

TARGET = "targets.game = { sample_rate_hz = 48000, bit_depth = 24 }"


def bext(text):
    return chunk(b"bext", text.encode().ljust(602, b"\0"))


def comment(text):
    return chunk(b"LIST", b"INFO" + chunk(b"ISFT", b"odd") + chunk(b"ICMT", text))


@pytest.mark.parametrize("mark", [placeholder_mark("SW-014"), bext("SOUNDLIST:PLACEHOLDER SW-014")])
@pytest.mark.parametrize("channels", [1, 2])
def test_both_marks_are_found_before_and_after_the_samples(found_by, mark, channels):
    for place in ("before", "after"):
        (finding,) = found_by("placeholder", sine(hz=440, channels=channels), **{place: [mark]})
        assert finding.code == "placeholder:marked"
        assert "cue SW-014" in finding.message
        assert finding.severity is None


@pytest.mark.parametrize(
    "other",
    [bext("A SOUNDLIST:PLACEHOLDER once"), comment(b"laser, take 3\0"), chunk(b"LIST", b"adtl"), chunk(b"LIST", b"")],
)
def test_other_texts_are_no_mark(codes_of, other):
    assert codes_of("placeholder", silence(), before=[other]) == []


def test_a_mark_among_other_comments(codes_of):
    assert codes_of("placeholder", silence(), after=[comment(b"SOUNDLIST:PLACEHOLDER SW-1\0")]) == [
        "placeholder:marked"
    ]


def test_the_state_that_other_tools_write(found_by):
    (finding,) = found_by("placeholder", silence(), before=[ixml("<ASWG><state>placeholder</state></ASWG>")])
    assert finding.message == "this is a placeholder, not the final sound"
    assert found_by("placeholder", silence(), before=[ixml("<ASWG><state>mastered</state></ASWG>")]) == []


def test_one_among_renders_is_an_error(found_by):
    (finding,) = found_by("placeholder", silence(), TARGET, target="game", after=[placeholder_mark("SW-014")])
    assert finding.severity == "error"


def test_the_front_door(tmp_path):
    real = write_wav(tmp_path / "real.wav", sine(hz=440))
    marked = write_wav(tmp_path / "beep.wav", sine(hz=440), after=[placeholder_mark("SW-014")])
    assert not is_placeholder(real)
    assert is_placeholder(marked)
    with AudioFile(marked) as file:
        assert file.facts.chunks == ("fmt ", "data", "LIST")
