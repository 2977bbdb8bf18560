"""The strict reader: what it refuses and by which rule, what it tolerates, and what the samples are."""

import io
import os
import resource
import socket
import struct
import subprocess
import sys

import numpy as np
import pytest

from audio_checks.errors import Unreadable
from audio_checks.wav import blocks, open_regular, read_layout
from tests.support.mutants import DATA, FMT, GOOD, SOUND, ds64, mutant, rf64
from tests.support.waves import (
    FLOAT_GUID,
    chunk,
    extensible,
    float_bytes,
    fmt,
    noise,
    pcm_bytes,
    riff,
    smpl,
    wav_bytes,
    write_wav,
)


def layout_of(content):
    return read_layout(io.BytesIO(content))


def samples_of(content, block_frames=65_536):
    file = io.BytesIO(content)
    return np.concatenate(list(blocks(file, read_layout(file), block_frames)))


def with_format(**kinds):
    return riff(chunk(b"fmt ", fmt(**kinds)), DATA)


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


def test_a_plain_header():
    layout = layout_of(wav_bytes(noise(seconds=0.1, channels=2), rate=96_000, bits=24))
    assert (layout.container, layout.encoding, layout.codec_tag, layout.extensible) == ("wav", "pcm", 1, False)
    assert (layout.sample_rate_hz, layout.bit_depth, layout.container_bits, layout.channels) == (96_000, 24, 24, 2)
    assert (layout.frames, layout.data_offset, layout.data_size) == (4_800, 44, 4_800 * 6)
    assert [(part.id, part.offset, part.size) for part in layout.chunks] == [("fmt ", 20, 16), ("data", 44, 28_800)]
    assert layout.channel_mask is None


def test_an_extensible_header_with_24_bits_in_32():
    values = np.array([[1], [-1], [2**23 - 1], [-(2**23)]])
    data = (values << 8).astype("<i4").tobytes()
    content = riff(chunk(b"fmt ", extensible(mask=4)), chunk(b"data", data))
    layout = layout_of(content)
    assert (layout.bit_depth, layout.container_bits, layout.channel_mask, layout.extensible) == (24, 32, 4, True)
    assert np.array_equal(samples_of(content), values / 2**23)


def test_extensible_float():
    header = extensible(container_bits=32, valid_bits=32, guid=FLOAT_GUID)
    content = riff(chunk(b"fmt ", header), chunk(b"data", float_bytes(np.array([0.5, -2.0]))))
    assert layout_of(content).encoding == "float"
    assert samples_of(content)[:, 0].tolist() == [0.5, -2.0]


def test_rf64():
    layout = layout_of(rf64())
    assert (layout.container, layout.frames, layout.data_size) == ("rf64", 480, 960)
    assert layout_of(rf64(frames=0)).frames == 480
    assert np.array_equal(samples_of(rf64()), samples_of(GOOD))


@pytest.mark.parametrize("bits", [8, 16, 24, 32])
@pytest.mark.parametrize("channels", [1, 2, 5])
def test_pcm_is_decoded_exactly(bits, channels):
    scale = 2 ** (bits - 1)
    edges = np.array([-scale, scale - 1, 0, 1, -1])
    whole = np.concatenate([edges, np.random.default_rng(bits).integers(-scale, scale, 995)]).reshape(-1, 1)
    samples = np.repeat(whole / scale, channels, axis=1) * np.where(np.arange(channels) % 2, 0.5, 1)
    samples = np.floor(samples * scale) / scale
    content = wav_bytes(samples, bits=bits)
    for block_frames in (1, 7, 65_536):
        assert np.array_equal(samples_of(content, block_frames), samples)


@pytest.mark.parametrize("bits", [32, 64])
def test_float_is_decoded_exactly(bits):
    samples = noise(dbfs=3, channels=2, seconds=0.01).astype(np.float32).astype(np.float64)
    assert np.array_equal(samples_of(wav_bytes(samples, bits=bits, encoding="float"), 100), samples)


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("place", [0, 479])
def test_samples_that_are_no_numbers(bad, place):
    samples = np.zeros((480, 2))
    samples[place, 1] = bad
    with pytest.raises(Unreadable, match="channel 2") as refusal:
        samples_of(wav_bytes(samples, bits=32, encoding="float"))
    assert refusal.value.rule == "R7"
    assert refusal.value.code == "structure:not-finite"


@pytest.mark.parametrize("bits", [32, 64])
@pytest.mark.parametrize("place", [0, 479])
def test_samples_that_no_sound_has(bits, place):
    samples = np.zeros((480, 2))
    samples[place, 1] = -(2.0**64)
    with pytest.raises(Unreadable, match="channel 2 holds samples over 385 dBFS") as refusal:
        samples_of(wav_bytes(samples, bits=bits, encoding="float"))
    assert (refusal.value.rule, refusal.value.code) == ("R7", "structure:too-large")
    samples[place, 1] = np.nextafter(np.float32(2.0**64), np.float32(0))
    assert samples_of(wav_bytes(samples, bits=bits, encoding="float"))[place, 1] == samples[place, 1]


def test_loops():
    content = wav_bytes(noise(seconds=0.01), after=[smpl([(0, 479), (100, 200)])])
    assert [(loop.start, loop.end, loop.kind) for loop in layout_of(content).loops] == [
        (0, 479, "forward"),
        (100, 200, "forward"),
    ]


def test_loops_beyond_the_end_are_kept_apart():
    layout = layout_of(wav_bytes(noise(seconds=0.01), after=[smpl([(0, 480), (0, 479)])]))
    assert [(loop.start, loop.end) for loop in layout.loops] == [(0, 479)]
    assert [(loop.start, loop.end) for loop in layout.loops_outside] == [(0, 480)]
    assert layout.warnings == ()


@pytest.mark.parametrize(
    "broken",
    [smpl([(9, 3)]), chunk(b"smpl", bytes(10)), chunk(b"smpl", smpl([(0, 9)])[8:-24])],
    ids=["backwards", "short", "announced but absent"],
)
def test_a_damaged_loop_is_a_warning(broken):
    layout = layout_of(wav_bytes(noise(seconds=0.01), after=[broken]))
    assert layout.loops == ()
    assert [warning.code for warning in layout.warnings] == ["structure:smpl"]


def test_a_file_that_shrinks_while_it_is_read(tmp_path):
    path = write_wav(tmp_path / "wind.wav", noise(seconds=1))
    with open_regular(path) as file:
        layout = read_layout(file)
        os.truncate(path, 5_000)
        with pytest.raises(Unreadable) as refusal:
            list(blocks(file, layout, 1_000))
    assert refusal.value.rule == "R1"


def test_only_regular_files_are_opened(tmp_path):
    # Where a FIFO without a writer were opened, this would wait without end.
    os.mkfifo(tmp_path / "fifo.wav")
    (tmp_path / "folder.wav").mkdir()
    (tmp_path / "dangling.wav").symlink_to(tmp_path / "nowhere")
    (tmp_path / "circle.wav").symlink_to(tmp_path / "circle.wav")
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind(str(tmp_path / "socket.wav"))
        for name in ("fifo.wav", "folder.wav", "dangling.wav", "circle.wav", "socket.wav", "absent.wav", "nul\0.wav"):
            with pytest.raises(Unreadable) as refusal:
                open_regular(f"{tmp_path}/{name}")
            assert refusal.value.rule == "R11"
        with pytest.raises(Unreadable):
            open_regular("/dev/zero")


def test_a_link_to_a_file_is_opened(tmp_path):
    write_wav(tmp_path / "rain.wav", noise(seconds=0.01))
    (tmp_path / "link.wav").symlink_to(tmp_path / "rain.wav")
    with open_regular(tmp_path / "link.wav") as file:
        assert read_layout(file).frames == 480


def sparse(path, head, size):
    path.write_bytes(head)
    os.truncate(path, size)
    return path


def test_two_gigabytes_take_little_memory_and_time(tmp_path):
    size = 2 << 30
    header = riff(chunk(b"fmt ", fmt(channels=2)), b"data" + struct.pack("<I", size - 44), size=size - 8)
    sparse(tmp_path / "sound.wav", header, size)
    sparse(tmp_path / "padded.wav", GOOD, size // 8)
    sparse(tmp_path / "junk.wav", riff(FMT, DATA, b"JUNK" + struct.pack("<I", 0xFFFFFF00), size=size - 8), size)
    script = f"""
import itertools
from audio_checks.errors import Unreadable
from audio_checks.wav import blocks, open_regular, read_layout
for name in ("sound", "padded", "junk"):
    with open_regular({str(tmp_path)!r} + "/" + name + ".wav") as file:
        try:
            layout = read_layout(file)
            for block in itertools.islice(blocks(file, layout), 50):
                pass
            print(name, layout.frames)
        except Unreadable as refusal:
            print(name, refusal.rule)
print(open("/proc/self/status").read().partition("VmHWM:")[2].split()[0])
"""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    *lines, peak_kib = done.stdout.splitlines()
    assert lines == [f"sound {(size - 44) // 4}", "padded 480", "junk R1"]
    assert int(peak_kib) < 256 * 1_024
    assert after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime < 10


def test_a_header_of_many_channels_takes_little_memory():
    content = riff(chunk(b"fmt ", fmt(channels=1_024)), chunk(b"data", bytes(2_048 * 4_096)))
    file = io.BytesIO(content)
    layout = read_layout(file)
    sizes = [block.nbytes for block in blocks(file, layout)]
    assert max(sizes) <= 4 << 20
    assert sum(sizes) == 1_024 * 4_096 * 8


def test_thousands_of_mutants_are_read_or_refused():
    rng = np.random.default_rng(20261121)
    outcomes, unclear = {"read": 0}, 0
    for _ in range(20_000):
        content = mutant(rng)
        try:
            samples = samples_of(content)
        except Unreadable as refusal:
            unclear += not (refusal.fix and str(refusal).isprintable())
            outcomes[refusal.rule] = outcomes.get(refusal.rule, 0) + 1
        else:
            assert np.isfinite(samples).all()
            assert samples.nbytes <= 16 * len(content)
            outcomes["read"] += 1
    assert set(outcomes) >= {"read", "R1", "R2", "R3", "R4", "R5", "R7", "R11", "R12"}
    assert outcomes["read"] > 300
    assert not unclear


@pytest.mark.parametrize("bits", [12, 20])
def test_sample_sizes_that_are_no_whole_bytes_are_read_with_a_warning(bits):
    whole = (bits + 7) // 8 * 8
    content = riff(chunk(b"fmt ", fmt(bits=bits)), chunk(b"data", pcm_bytes(noise(seconds=0.01), whole)))
    layout = layout_of(content)
    assert [warning.code for warning in layout.warnings] == ["structure:sample-bytes"]
    assert (layout.container_bits, layout.frames) == (whole, 480)
