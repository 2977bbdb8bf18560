"""LIST, cue, smpl and inst: what they say, and what of them is damaged."""

import struct

import pytest

from audio_checks.metadata.lists import MOST_ENTRIES, read_info, read_labels
from audio_checks.metadata.points import CuePoint, Instrument, read_cue, read_inst, read_smpl
from tests.support import chunks
from tests.support.waves import chunk, smpl


def payload(whole):
    return whole[8 : 8 + struct.unpack_from("<I", whole, 4)[0]]


def test_info():
    read = read_info(payload(chunks.info(INAM="Laser", ICOP="2026", ICMT="")))
    assert read == {"INAM": "Laser", "ICOP": "2026"}
    assert read_info(payload(chunks.labels({1: "x"}))) == {}
    assert read_info(b"INFO" + bytes(6)) == {}  # padded with zeros


def test_labels():
    assert read_labels(payload(chunks.labels({1: "start", 2: "hit"}))) == {1: "start", 2: "hit"}
    both = payload(chunks.labels({1: "said"}, kind=b"note")) + chunk(b"labl", b"\1\0\0\0named\0")
    assert read_labels(both) == {1: "named"}
    assert read_labels(payload(chunks.info(INAM="x"))) == {}


@pytest.mark.parametrize("size", [5, 0xFFFFFFFF])
def test_an_entry_beyond_its_list(size):
    with pytest.raises(ValueError, match="beyond the chunk"):
        read_info(b"INFO" + chunk(b"INAM", b"abcd", size=size))


def test_too_many_entries():
    read_info(b"INFO" + chunk(b"INAM", b"") * MOST_ENTRIES)
    with pytest.raises(ValueError, match="more than"):
        read_info(b"INFO" + chunk(b"INAM", b"") * (MOST_ENTRIES + 1))


def test_cue_points():
    read = read_cue(payload(chunks.cue({1: 0, 7: 48_000})), {7: "hit"})
    assert read == (CuePoint(1, 0), CuePoint(7, 48_000, "hit"))
    assert read_cue(payload(chunks.cue({})), {}) == ()


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"\1\0\0",
        struct.pack("<I", 2) + bytes(24),
        struct.pack("<I", 2) + bytes(47),  # a byte short
        struct.pack("<I", 0xFFFFFFFF),
    ],
)
def test_a_damaged_cue_chunk(content):
    with pytest.raises(ValueError, match='"cue "'):
        read_cue(content, {})


def test_a_note_beyond_midi_is_none():
    def of(note: int) -> bytes:
        return struct.pack("<9I", 0, 0, 0, note, 0, 0, 0, 0, 0)

    assert read_smpl(of(127)).unity_note == 127
    assert read_smpl(of(128)).unity_note is None
    assert read_inst(bytes([127, *bytes(6)])).unity_note == 127
    assert read_inst(bytes([128, *bytes(6)])).unity_note is None


def test_half_of_a_pitch_fraction_is_50_cents():
    # The sampler chunk counts a semitone in parts of 2**32.
    content = struct.pack("<9I", 0, 0, 0, 60, 0x8000_0000, 0, 0, 0, 0)
    assert read_smpl(content) == Instrument(unity_note=60, fine_tune_cents=50.0)


def test_notes():
    assert read_smpl(payload(smpl([(0, 9)]))) == Instrument(unity_note=60, fine_tune_cents=0.0)
    assert read_inst(payload(chunks.inst(48, -12, -6, (40, 60), (1, 100)))) == Instrument(
        48, -12.0, -6, (40, 60), (1, 100)
    )
    for read, content in ((read_smpl, bytes(35)), (read_inst, bytes(6))):
        with pytest.raises(ValueError, match="wanted"):
            read(content)
