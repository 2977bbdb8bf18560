"""The strict reader: headers, samples and loops as they are read, and files that change or are huge."""

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
from tests.support.mutants import DATA, FMT, GOOD, mutant, rf64
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


@pytest.mark.slow
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
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=300, check=True)
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


@pytest.mark.slow
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
