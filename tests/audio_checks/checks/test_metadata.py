"""`metadata`: required fields, in any chunk that holds them."""

import numpy as np
import pytest

from audio_checks.audio.audio_file import AudioFile
from tests.support.chunks import bext, info, ixml
from tests.support.waves import chunk, noise, silence, sine

REQUIRED = 'metadata.required = ["bext.Originator", "iXML.ASWG.catId", "INFO.ICOP"]'
ALL = [
    bext(originator="Mara Lind"),
    ixml("<ASWG><catId>GUNAuto</catId><state>mastered</state></ASWG>"),
    info(ICOP="2026 Shield Wing"),
]


@pytest.mark.parametrize("samples", [sine(hz=997), noise(channels=2), silence(), np.array([[0.5]])])
@pytest.mark.parametrize("place", ["before", "after"])
def test_everything_is_there(codes_of, samples, place):
    assert codes_of("metadata", samples, REQUIRED, **{place: ALL}) == []


def test_what_is_missing_is_named(found_by):
    (finding,) = found_by("metadata", sine(hz=997), REQUIRED, before=[bext(originator=""), ALL[1]])
    assert finding.code == "metadata:missing"
    assert finding.message == "2 of 3 required fields hold nothing: bext.Originator, INFO.ICOP"
    assert finding.measured == 2


def test_without_any_chunk(found_by):
    (finding,) = found_by("metadata", sine(hz=997), REQUIRED)
    assert finding.measured == 3


def test_a_damaged_chunk_is_named_too(codes_of, found_by):
    broken = chunk(b"iXML", b"<BWFXML><ASWG>")
    assert codes_of("metadata", silence(), REQUIRED, before=[broken]) == ["metadata:damaged", "metadata:missing"]
    finding = found_by("metadata", silence(), REQUIRED, before=[broken])[0]
    assert "not XML" in finding.message


def test_without_required_fields_it_is_not_asked(codes_of):
    assert codes_of("metadata", silence(), before=[chunk(b"iXML", b"<x")]) == []
    assert codes_of("metadata", silence(), 'metadata.required = "any"') == []


def test_real_recordings_say_nothing_of_themselves(recordings):
    for path in recordings[::12]:
        with AudioFile(path) as file:
            assert file.metadata.damaged == ()
