"""The strict reader: what it refuses and by which rule, and what it tolerates with a warning."""

import struct

import numpy as np
import pytest

from audio_checks.errors import Unreadable
from tests.audio_checks.wav.test_reader import layout_of, samples_of, with_format
from tests.support.mutants import DATA, FMT, GOOD, SOUND, ds64, rf64
from tests.support.waves import (
    chunk,
    extensible,
    fmt,
    riff,
)

STREAM = 0xFFFFFFFF


def fact(frames):
    return chunk(b"fact", struct.pack("<I", frames))


def rf64_with_fact(reported, frames=480):
    """An RF64 file whose fact chunk and ds64 chunk each count frames."""
    counts = ds64(4 + 36 + len(FMT) + len(fact(reported)) + len(DATA), 960, frames)
    return riff(counts, FMT, fact(reported), b"data" + struct.pack("<I", STREAM) + SOUND, magic=b"RF64", size=STREAM)


REFUSED = {
    "empty file": (b"", "R11", "container:empty"),
    "three bytes": (b"RIF", "R11", "container:unknown"),
    "text": (b"hello, this is a note about the sound", "R11", "container:unknown"),
    "zeros": (bytes(4_000), "R11", "container:zeros"),
    "header alone": (b"RIFF\x04\0\0\0", "R1", "structure:truncated"),
    "git-lfs pointer": (
        b"version https://git-lfs.github.com/spec/v1\noid sha256:00\n",
        "R11",
        "container:git-lfs-pointer",
    ),
    "mp3 with tag": (b"ID3\x04\0\0\0\0\0\0" + bytes(50), "R11", "container:mp3"),
    "mp3 frames": (b"\xff\xfb\x90\x64" + bytes(50), "R11", "container:mp3"),
    "flac": (b"fLaC" + bytes(50), "R11", "container:flac"),
    "ogg": (b"OggS" + bytes(50), "R11", "container:ogg"),
    "aiff": (b"FORM\0\0\0\x20AIFF" + bytes(50), "R11", "container:aiff"),
    "au": (b".snd" + bytes(50), "R11", "container:au"),
    "caf": (b"caff" + bytes(50), "R11", "container:caf"),
    "w64": (b"riff\x2e\x91\xcf\x11\xa5\xd6\x28\xdb" + bytes(50), "R11", "container:w64"),
    "rifx": (riff(FMT, DATA, magic=b"RIFX"), "R11", "container:rifx"),
    "bw64": (riff(FMT, DATA, magic=b"BW64"), "R11", "container:bw64"),
    "avi": (riff(FMT, DATA, form=b"AVI "), "R11", "container:not-wave"),
    "stream sizes": (riff(FMT, DATA, size=0xFFFFFFFF), "R11", "structure:stream-header"),
    "stream data size": (riff(FMT, chunk(b"data", SOUND, size=0xFFFFFFFF)), "R11", "structure:stream-header"),
    "data cut short": (GOOD[:-100], "R1", "structure:truncated"),
    "data size too large": (riff(FMT, chunk(b"data", SOUND, size=2_000)), "R1", "structure:truncated"),
    "other chunk too large": (riff(FMT, DATA, chunk(b"LIST", b"INFO", size=900)), "R1", "structure:truncated"),
    "garbage for a chunk": (riff(FMT, DATA, b"\x01\x02\x03\x04\x05\x06\x07\x08"), "R1", "structure:no-chunk"),
    "stray bytes": (riff(FMT, DATA, b"abc"), "R1", "structure:no-chunk"),
    "half a frame": (riff(FMT, chunk(b"data", SOUND[:-1])), "R1", "structure:partial-frame"),
    "too many chunks": (riff(FMT, DATA, chunk(b"JUNK", b"") * 10_001), "R1", "structure:too-many-chunks"),
    "riff size too small": (riff(FMT, DATA, size=400), "R2", "structure:riff-size"),
    "riff size too large": (riff(FMT, DATA, size=len(GOOD) - 8 + 50), "R2", "structure:riff-size"),
    "riff size 0": (riff(FMT, DATA, size=0), "R2", "structure:riff-size"),
    "riff size off by 4": (riff(FMT, DATA, size=len(GOOD) - 8 + 4), "R2", "structure:riff-size"),
    "no fmt": (riff(DATA), "R3", "structure:no-fmt"),
    "two fmt": (riff(FMT, FMT, DATA), "R3", "structure:several-fmt"),
    "fmt again after data": (riff(FMT, DATA, FMT), "R3", "structure:several-fmt"),
    "no data": (riff(FMT), "R3", "structure:no-data"),
    "two data": (riff(FMT, DATA, DATA), "R3", "structure:several-data"),
    "data first": (riff(DATA, FMT), "R3", "structure:fmt-after-data"),
    "short fmt": (riff(chunk(b"fmt ", fmt()[:14]), DATA), "R4", "structure:fmt-size"),
    "no channels": (with_format(channels=0, block_align=2), "R4", "structure:channels"),
    "too many channels": (with_format(channels=2_000), "R4", "structure:channels"),
    "rate 0": (with_format(rate=0), "R4", "structure:sample-rate"),
    "rate 999": (with_format(rate=999), "R4", "structure:sample-rate"),
    "rate 768001": (with_format(rate=768_001), "R4", "structure:sample-rate"),
    "block align": (with_format(block_align=4), "R4", "structure:block-align"),
    "byte rate": (with_format(byte_rate=1), "R4", "structure:byte-rate"),
    "no bits": (with_format(bits=0, block_align=2), "R4", "structure:bit-depth"),
    "64-bit pcm": (with_format(bits=64), "R4", "structure:bit-depth"),
    "16-bit float": (with_format(tag=3), "R4", "structure:bit-depth"),
    "24 in 32 without extensible": (with_format(bits=24, block_align=4), "R4", "structure:block-align"),
    "valid bits beyond container": (
        riff(chunk(b"fmt ", extensible(container_bits=16, valid_bits=24)), DATA),
        "R4",
        "structure:bit-depth",
    ),
    "no valid bits": (
        riff(chunk(b"fmt ", extensible(container_bits=16, valid_bits=0)), DATA),
        "R4",
        "structure:bit-depth",
    ),
    "short extensible": (riff(chunk(b"fmt ", fmt(tag=0xFFFE)), DATA), "R4", "structure:fmt-size"),
    "ima adpcm": (with_format(tag=0x11, bits=4, block_align=256), "R5", "encoding:codec"),
    "mu-law": (with_format(tag=7, bits=8), "R5", "encoding:codec"),
    "mp3 in wav": (with_format(tag=0x55), "R5", "encoding:codec"),
    "unknown guid": (
        riff(chunk(b"fmt ", extensible(guid=bytes(range(16)), container_bits=16, valid_bits=16)), DATA),
        "R5",
        "encoding:codec",
    ),
    "no frames": (riff(FMT, chunk(b"data", b"")), "R6", "structure:no-frames"),
    "rf64 without ds64": (riff(FMT, DATA, magic=b"RF64"), "R11", "structure:ds64"),
    "rf64 short ds64": (riff(chunk(b"ds64", bytes(20)), FMT, DATA, magic=b"RF64"), "R11", "structure:ds64"),
    "rf64 table too long": (rf64(entries=7), "R11", "structure:ds64"),
    "rf64 frames": (rf64_with_fact(STREAM, frames=481), "R11", "structure:ds64"),
    "rf64 data beyond file": (rf64(data_size=1 << 40, frames=0), "R1", "structure:truncated"),
    "rf64 riff beyond file": (rf64(riff_size=1 << 40), "R2", "structure:riff-size"),
    "bytes after the end": (GOOD + b"\0\0\0\0hidden", "R12", "structure:trailing-bytes"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_refusals_name_their_rule(name):
    content, rule, code = REFUSED[name]
    with pytest.raises(Unreadable) as refusal:
        layout_of(content)
    assert (refusal.value.rule, refusal.value.code) == (rule, code)
    assert str(refusal.value).isprintable()
    assert refusal.value.fix


TOLERATED = {
    "more speakers than channels": (
        riff(chunk(b"fmt ", extensible(container_bits=16, valid_bits=16, mask=0x3)), DATA),
        ["structure:channel-mask"],
    ),
    "as it should be": (GOOD, []),
    "unknown chunks in any place": (
        riff(chunk(b"JUNK", bytes(28)), FMT, chunk(b"bext", bytes(602)), DATA, chunk(b"id3 ", bytes(7))),
        [],
    ),
    "riff size counts its header": (riff(FMT, DATA, size=len(GOOD)), ["structure:riff-size"]),
    "riff size 8 too small": (riff(FMT, DATA, size=len(GOOD) - 16), ["structure:riff-size"]),
    "last pad byte missing": (riff(FMT, DATA, chunk(b"note", b"odd", pad=False)), ["structure:pad-byte"]),
    "last pad byte counted but missing": (
        riff(FMT, DATA, chunk(b"note", b"odd"))[:-1],
        ["structure:pad-byte"],
    ),
    "last pad byte not counted": (
        riff(FMT, DATA, chunk(b"note", b"odd", pad=False)) + b"\0",
        ["structure:riff-size"],
    ),
    "inner pad byte missing": (riff(FMT, chunk(b"note", b"odd", pad=False), DATA), ["structure:pad-byte"]),
    "zeros after the end": (GOOD + bytes(3_000), ["structure:padding"]),
    "zeros inside at the end": (riff(FMT, DATA, bytes(100)), ["structure:padding"]),
    "two zeros inside": (riff(FMT, DATA, bytes(2)), ["structure:padding"]),
    "zeros after the end, one of them its pad byte": (
        riff(FMT, DATA, chunk(b"note", b"odd", pad=False)) + bytes(9),
        ["structure:padding"],
    ),
    "riff size leaves out an empty chunk": (
        riff(FMT, DATA, chunk(b"note", b""), size=len(GOOD) - 8),
        ["structure:riff-size"],
    ),
    "pad byte is not zero": (
        riff(FMT, chunk(b"note", b"odd", pad=False) + b"x", DATA),
        ["structure:pad-value"],
    ),
    "last pad byte is not zero": (
        riff(FMT, DATA, chunk(b"note", b"odd", pad=False) + b"x"),
        ["structure:pad-value"],
    ),
    "fact is right": (riff(FMT, fact(480), DATA), []),
    "fact is wrong": (riff(FMT, fact(481), DATA), ["structure:fact"]),
    "fact is left open": (riff(FMT, fact(STREAM), DATA), ["structure:fact"]),
    "fact is short": (riff(FMT, chunk(b"fact", b"\xe0\x01"), DATA), ["structure:fact"]),
    "two facts": (riff(FMT, fact(480), fact(480), DATA), ["structure:fact"]),
    "a ds64 in a RIFF file": (riff(FMT, ds64(1, 2, 3), DATA), ["structure:ds64-size"]),
    "fmt announces an extension that it lacks": (
        riff(chunk(b"fmt ", fmt(extra=b"\x16\0")), DATA),
        ["structure:fmt-extension"],
    ),
    "fmt has bytes that it does not announce": (
        riff(chunk(b"fmt ", fmt(extra=bytes(6))), DATA),
        ["structure:fmt-extension"],
    ),
    "fmt of 17 bytes": (riff(chunk(b"fmt ", fmt(extra=b"\0")), DATA), ["structure:fmt-extension"]),
    "fmt with an empty extension": (riff(chunk(b"fmt ", fmt(extra=b"\0\0")), DATA), []),
    "extensible fmt with more": (
        riff(chunk(b"fmt ", extensible(container_bits=16, valid_bits=16) + b"\0\0"), DATA),
        ["structure:fmt-extension"],
    ),
    "reserved speakers": (
        riff(chunk(b"fmt ", extensible(container_bits=16, valid_bits=16, mask=1 << 20)), DATA),
        ["structure:channel-mask"],
    ),
    "all speakers": (
        riff(chunk(b"fmt ", extensible(container_bits=16, valid_bits=16, mask=1 << 31)), DATA),
        [],
    ),
    "rf64": (rf64(), []),
    "rf64, fact defers to ds64": (rf64_with_fact(STREAM), []),
    "rf64, fact counts": (rf64_with_fact(480), []),
    "rf64, fact counts and ds64 is wrong": (rf64_with_fact(480, frames=481), ["structure:ds64-count"]),
    "rf64, fact counts and ds64 is empty": (rf64_with_fact(480, frames=0), ["structure:ds64-count"]),
    "rf64, fact defers and ds64 is empty": (rf64_with_fact(STREAM, frames=0), ["structure:ds64-count"]),
    "rf64, fact is wrong": (rf64_with_fact(481), ["structure:fact"]),
    "rf64 without fact, ds64 is wrong": (rf64(frames=481), ["structure:ds64-count"]),
    "rf64 with a 32-bit data size, 64-bit is wrong": (
        riff(ds64(4 + 36 + len(FMT) + len(DATA), 7, 480), FMT, DATA, magic=b"RF64", size=STREAM),
        ["structure:ds64-size"],
    ),
    "rf64 with a 32-bit riff size, 64-bit is wrong": (
        riff(ds64(7, 960, 480), FMT, b"data\xff\xff\xff\xff" + SOUND, magic=b"RF64"),
        ["structure:ds64-size"],
    ),
    "rf64 whose ds64 is longer than its table": (
        riff(
            chunk(b"ds64", struct.pack("<QQQI", 4 + 40 + len(FMT) + len(DATA), 960, 480, 0) + bytes(4)),
            FMT,
            DATA,
            magic=b"RF64",
            size=STREAM,
        ),
        ["structure:ds64-size"],
    ),
}


@pytest.mark.parametrize("name", TOLERATED)
def test_what_is_odd_and_harmless_is_read_with_a_warning(name):
    content, codes = TOLERATED[name]
    layout = layout_of(content)
    assert [warning.code for warning in layout.warnings] == codes
    assert (layout.frames, layout.sample_rate_hz, layout.bit_depth) == (480, 48_000, 16)
    assert np.array_equal(samples_of(content)[:, 0], np.frombuffer(SOUND, "<i2") / 32_768)
