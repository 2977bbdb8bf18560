"""Sizes that follow from the file itself are put right; what is cut short stays refused."""

import struct

import pytest

from audio_checks import Unreadable, wav
from audio_checks.fixing.header import with_right_sizes
from tests.support.mutants import DATA, FMT, GOOD, SOUND
from tests.support.waves import chunk, fmt, riff

INFO = chunk(b"LIST", b"INFO" + chunk(b"IART", b"Designer\0"))
OPEN = struct.pack("<I", 0xFFFFFFFF)


def fix_in_place(tmp_path, content):
    master, copy = tmp_path / "a.wav", tmp_path / "b.wav"
    master.write_bytes(content)
    words, _ = with_right_sizes(master, copy)
    assert master.read_bytes() == content
    with wav.open_regular(copy) as file:
        layout = wav.read_layout(file)
        sound = b"".join(wav.raw_blocks(file, layout))
    return words, sound, copy.read_bytes()


@pytest.mark.parametrize(
    ("content", "words"),
    [
        pytest.param(b"RIFF\0\0\0\0" + GOOD[8:], ["RIFF size set to 996 bytes"], id="a recorder that lost power"),
        pytest.param(riff(FMT, DATA, size=5_000), ["RIFF size set to 996 bytes"], id="a size that is too large"),
        pytest.param(
            riff(FMT, b"data" + OPEN + SOUND, size=0xFFFFFFFF),
            ["data size set to 960 bytes", "RIFF size set to 996 bytes"],
            id="a pipe",
        ),
        pytest.param(
            riff(FMT, b"data\0\0\0\0" + SOUND, size=36),
            ["data size set to 960 bytes", "RIFF size set to 996 bytes"],
            id="a header that was never filled in",
        ),
        pytest.param(GOOD + b"ID3 trailer", ["11 bytes after the sound's file cut off"], id="bytes after the end"),
        pytest.param(
            riff(chunk(b"fmt ", fmt(byte_rate=1)), DATA),
            ["byte rate set to 96000, as rate and frame size make"],
            id="a byte rate of another format",
        ),
    ],
)
def test_sizes_follow_from_the_file(tmp_path, content, words):
    found, sound, _ = fix_in_place(tmp_path, content)
    assert list(found) == words
    assert sound == SOUND


def test_chunks_around_the_sound_stay(tmp_path):
    _, sound, copy = fix_in_place(tmp_path, riff(FMT, INFO, DATA, INFO, size=7) + b"")
    assert copy == riff(FMT, INFO, DATA, INFO)
    assert sound == SOUND


NOTE = chunk(b"note", b"odd")
UNPADDED = NOTE[:-1]


@pytest.mark.parametrize(
    ("parts", "whole", "words"),
    [
        pytest.param(
            (FMT, DATA, UNPADDED, INFO),
            (FMT, DATA, NOTE, INFO),
            "the missing pad byte added",
            id="after the sound",
        ),
        pytest.param(
            (FMT, UNPADDED, INFO, UNPADDED, DATA, INFO),
            (FMT, NOTE, INFO, NOTE, DATA, INFO),
            "2 missing pad bytes added",
            id="before it, twice",
        ),
        pytest.param(
            (FMT, UNPADDED, DATA, UNPADDED),
            (FMT, NOTE, DATA, NOTE),
            "2 missing pad bytes added",
            id="at the end too",
        ),
    ],
)
def test_a_missing_pad_byte_costs_no_chunk(tmp_path, parts, whole, words):
    found, sound, copy = fix_in_place(tmp_path, riff(*parts))
    assert copy == riff(*whole)
    assert sound == SOUND
    assert list(found) == [f"RIFF size set to {len(copy) - 8} bytes", words]


def test_sizes_are_written_where_they_stand_after_a_pad_byte(tmp_path):
    found, sound, copy = fix_in_place(tmp_path, riff(UNPADDED, FMT, b"data" + OPEN + SOUND, size=0xFFFFFFFF))
    assert copy == riff(NOTE, FMT, DATA)
    assert sound == SOUND
    assert found[0] == "data size set to 960 bytes"


def test_a_right_header_is_copied_byte_for_byte(tmp_path):
    assert fix_in_place(tmp_path, GOOD) == ((), SOUND, GOOD)


@pytest.mark.parametrize(
    "content",
    [
        pytest.param(GOOD[:-100], id="sound is missing"),
        pytest.param(riff(FMT), id="no sound at all"),
        pytest.param(riff(FMT, b"data" + OPEN, size=0xFFFFFFFF), id="a pipe that closed at once"),
        pytest.param(b"RIFF\0\0\0\0WAVE", id="nothing but its first bytes"),
        pytest.param(b"ID3" + bytes(200), id="another kind of file"),
        pytest.param(riff(chunk(b"fmt ", fmt(block_align=3)), DATA), id="a frame size that may be either"),
    ],
)
def test_what_no_size_puts_right_is_refused_and_leaves_nothing(tmp_path, content):
    master, copy = tmp_path / "a.wav", tmp_path / "b.wav"
    master.write_bytes(content)
    with pytest.raises(Unreadable):
        with_right_sizes(master, copy)
    assert not copy.exists()
