"""The writer: what it writes is read back to the bit, by us and by libsndfile; a failure leaves nothing."""

import io
import os
import struct

import numpy as np
import pytest
import soundfile

from audio_checks.wav import blocks, chunk_payload, read_layout, write_wav
from tests.support.waves import noise


def whole_numbers(bits, frames=1_001, channels=2, seed=4):
    limit = 2 ** (bits - 1)
    values = np.random.default_rng(seed).integers(-limit, limit, (frames, channels))
    values[0], values[1] = -limit, limit - 1
    return values


def read_back(content):
    file = io.BytesIO(content)
    layout = read_layout(file)
    return layout, np.concatenate(list(blocks(file, layout)))


def written(parts, **kinds):
    file = io.BytesIO()
    write_wav(file, parts, **kinds)
    return file.getvalue()


@pytest.mark.parametrize("bits", [8, 12, 16, 20, 24, 32])
@pytest.mark.parametrize("channels", [1, 2, 6])
def test_pcm_comes_back_to_the_bit(bits, channels):
    values = whole_numbers(bits, channels=channels)
    kinds = {"sample_rate_hz": 44_100, "bit_depth": bits, "channels": channels, "frames": len(values)}
    layout, samples = read_back(written([values[:500], values[500:]], **kinds))
    assert np.array_equal(samples, values / 2 ** (bits - 1))
    assert (layout.bit_depth, layout.channels, layout.sample_rate_hz) == (bits, channels, 44_100)
    assert layout.extensible == (channels > 2 or bits % 8 > 0)
    assert not layout.warnings


@pytest.mark.parametrize("bits", [32, 64])
def test_float_comes_back(bits):
    samples = noise(channels=2, seconds=0.01, dbfs=3).astype(np.float32)
    kinds = {"sample_rate_hz": 96_000, "bit_depth": bits, "encoding": "float", "channels": 2, "frames": len(samples)}
    layout, back = read_back(written([samples], **kinds))
    assert np.array_equal(back, samples)
    assert [chunk.id for chunk in layout.chunks] == ["fmt ", "fact", "data"]


@pytest.mark.parametrize(
    ("bits", "encoding", "channels"), [(8, "pcm", 1), (16, "pcm", 2), (24, "pcm", 6), (32, "float", 1)]
)
def test_libsndfile_reads_the_same(bits, encoding, channels):
    values = whole_numbers(bits if encoding == "pcm" else 24, channels=channels)
    samples = values / 2 ** (bits - 1) if encoding == "pcm" else values / 2**23
    kinds = {"sample_rate_hz": 48_000, "bit_depth": bits, "encoding": encoding, "channels": channels}
    content = written([values if encoding == "pcm" else samples], frames=len(values), **kinds)
    theirs, rate = soundfile.read(io.BytesIO(content), always_2d=True)
    assert rate == 48_000
    assert np.array_equal(theirs, samples)


def test_chunks_are_kept_in_their_places():
    values = np.array([[-5]])  # 3 bytes of sound: a pad byte follows
    content = written(
        [values],
        sample_rate_hz=48_000,
        bit_depth=24,
        channels=1,
        frames=1,
        chunks=[("bext", b"odd")],
        chunks_after=[("LIST", b"INFO"), ("smpl", bytes(36))],
    )
    layout, _ = read_back(content)
    assert [(chunk.id, chunk.size) for chunk in layout.chunks] == [
        ("fmt ", 16),
        ("bext", 3),
        ("data", 3),
        ("LIST", 4),
        ("smpl", 36),
    ]
    assert not layout.warnings
    assert chunk_payload(io.BytesIO(content), layout.chunks[1]) == b"odd"
    assert struct.unpack("<I", content[4:8])[0] == len(content) - 8


def test_a_channel_mask_asks_for_an_extensible_header():
    content = written(
        [whole_numbers(16, channels=4)],
        sample_rate_hz=48_000,
        bit_depth=16,
        channels=4,
        frames=1_001,
        channel_mask=0x33,
    )
    assert read_back(content)[0].channel_mask == 0x33


def test_a_file_of_5_gib_is_read_back(tmp_path):
    frames = (5 << 30) // 4
    head = io.BytesIO()
    with pytest.raises(ValueError, match="announced"):
        write_wav(head, [], sample_rate_hz=48_000, bit_depth=16, channels=2, frames=frames)
    (tmp_path / "long.wav").write_bytes(head.getvalue())
    os.truncate(tmp_path / "long.wav", len(head.getvalue()) + 4 * frames)
    with open(tmp_path / "long.wav", "rb") as file:
        layout = read_layout(file)
    assert (layout.container, layout.frames, layout.warnings) == ("rf64", frames, ())


REFUSED = [
    ([np.zeros((5, 1), np.int16)], {"frames": 6}),
    ([np.zeros((7, 1), np.int16)], {"frames": 6}),
    ([np.zeros((6, 2), np.int16)], {"frames": 6}),
    ([np.zeros(6, np.int16)], {"frames": 6}),
    ([np.zeros((6, 1))], {"frames": 6}),
    ([np.full((6, 1), 32_768)], {"frames": 6}),
    ([np.full((6, 1), -32_769)], {"frames": 6}),
    ([np.zeros((6, 1), np.int16)], {"frames": 6, "bit_depth": 33}),
    ([np.zeros((6, 1))], {"frames": 6, "encoding": "float"}),
    ([np.zeros((6, 1), np.int16)], {"frames": 6, "chunks": [("long name", b"")]}),
]


@pytest.mark.parametrize(("parts", "kinds"), REFUSED)
def test_what_does_not_fit_is_refused_and_leaves_nothing(tmp_path, parts, kinds):
    (tmp_path / "hit.wav").write_bytes(b"the earlier file")
    with pytest.raises(ValueError, match=r"."):
        write_wav(tmp_path / "hit.wav", parts, **{"sample_rate_hz": 48_000, "bit_depth": 16, "channels": 1, **kinds})
    assert [path.name for path in tmp_path.iterdir()] == ["hit.wav"]
    assert (tmp_path / "hit.wav").read_bytes() == b"the earlier file"


def test_a_path_is_replaced_whole(tmp_path):
    path = tmp_path / "hit.wav"
    path.write_bytes(b"the earlier file")

    def parts():
        yield np.zeros((3, 1), np.int16)
        assert path.read_bytes() == b"the earlier file"
        yield np.ones((3, 1), np.int16)

    write_wav(path, parts(), sample_rate_hz=48_000, bit_depth=16, channels=1, frames=6)
    _, samples = read_back(path.read_bytes())
    assert samples[:, 0].tolist() == [0, 0, 0, *[1 / 32_768] * 3]
    assert list(tmp_path.iterdir()) == [path]


def test_one_umask_rules_the_new_file(tmp_path):
    write_wav(
        tmp_path / "a.wav", [np.zeros((1, 1), np.int16)], sample_rate_hz=8_000, bit_depth=16, channels=1, frames=1
    )
    (tmp_path / "b.wav").write_bytes(b"")
    assert (tmp_path / "a.wav").stat().st_mode == (tmp_path / "b.wav").stat().st_mode
