"""A file of several sounds is split at its regions, markers or silences, sample for sample."""

import struct

import numpy as np
import pytest

from audio_checks import SplitRefused, split_master, wav
from tests.audio_checks.fixing.test_chunks import bext, cue
from tests.support.waves import chunk, join, noise, silence, sine, smpl, swelling, write_wav

RATE = 48_000
STEP, GAP = 9_600, 48_000  # frames


def steps(count, *, gap=GAP, channels=1):
    """Return steps, each higher than the one before it, with silence after each."""
    parts = []
    for number in range(count):
        tone = sine(hz=300 + 100 * number, seconds=STEP / RATE, phase=1.0, channels=channels)
        parts += [swelling(tone, 48), silence(seconds=gap / RATE, channels=channels)]
    return join(*parts)


def regions(lengths, texts):
    body = b"".join(
        chunk(b"labl", struct.pack("<I", number) + text + b"\0")
        + chunk(b"ltxt", struct.pack("<II4sHHHH", number, length, b"rgn ", 0, 0, 0, 0))
        for number, (length, text) in enumerate(zip(lengths, texts, strict=True), 1)
    )
    return chunk(b"LIST", b"adtl" + body)


def split(tmp_path, samples, **more):
    pause = {"shortest_pause_s": more.pop("pause_s")} if "pause_s" in more else {}
    master = write_wav(tmp_path / "steps.wav", samples, **more)
    out = tmp_path / "out"
    out.mkdir()
    return master, split_master(master, out, **pause), out


def raw(path):
    """Return the layout of a file, and the bytes of its sound."""
    with wav.open_regular(path) as file:
        layout = wav.read_layout(file)
        return layout, b"".join(wav.raw_blocks(file, layout))


def payloads(path):
    with wav.open_regular(path) as file:
        return {one.id: wav.chunk_payload(file, one) for one in wav.read_layout(file).chunks}


@pytest.mark.parametrize("form", [{}, {"bits": 16}, {"encoding": "float", "bits": 32}])
def test_silence_parts_six_steps_sample_for_sample(tmp_path, form):
    master, made, out = split(tmp_path, steps(6, channels=2), **form)
    assert (made.found_by, made.sample_rate_hz, len(made.parts)) == ("silence", RATE, 6)
    whole, content = raw(master)
    for number, part in enumerate(made.parts):
        layout, sound = raw(out / part.file_name)
        start = number * (STEP + GAP)
        assert max(start - 96, 0) <= part.first <= start + 16  # 2 ms before the first frame above the threshold
        assert start + STEP - 16 <= part.end - 960 <= start + STEP  # 20 ms after the last
        assert sound == content[part.first * whole.frame_bytes : part.end * whole.frame_bytes]
        assert payloads(out / part.file_name)["fmt "] == payloads(master)["fmt "]
        assert (layout.frames, layout.warnings) == (part.end - part.first, ())


def test_a_shorter_pause_counts_where_it_is_asked_for(tmp_path):
    samples = steps(4, gap=14_400)  # 0.3 s
    with pytest.raises(SplitRefused, match=r"no silence of 0\.6 s") as refused:
        split(tmp_path, samples)
    assert refused.value.code == "split:one-sound"
    (tmp_path / "out").rmdir()
    assert len(split(tmp_path, samples, pause_s=0.25)[1].parts) == 4


def test_markers_come_before_silence_and_leave_it_out(tmp_path):
    starts = [STEP + GAP, 2 * (STEP + GAP)]  # between the sounds: the first part has none
    labels = chunk(b"LIST", b"adtl" + chunk(b"labl", struct.pack("<I", 2) + b"heel\0"))
    _, made, out = split(tmp_path, steps(4), after=[cue(*starts), labels])
    assert (made.found_by, [part.label for part in made.parts]) == ("markers", ["", "", "heel"])
    assert [part.first for part in made.parts][1:] == starts  # a sound that begins at its marker keeps its start
    assert made.parts[0].end < starts[0] - GAP + 1_000
    assert made.parts[2].end > 3 * (STEP + GAP) + STEP  # both steps after the last marker
    kept = payloads(out / made.parts[2].file_name)
    assert struct.unpack_from("<I", kept["cue "]) == (1,)
    assert struct.unpack_from("<I", kept["cue "], 24) == (0,)
    assert b"heel" in kept["LIST"]
    assert not {"cue ", "LIST"} & payloads(out / made.parts[0].file_name).keys()


def test_regions_are_cut_where_they_are_marked(tmp_path):
    marks = [cue(100, 60_000), regions([5_000, 7_000], [b"left", b"right"])]
    _, made, out = split(tmp_path, noise(seconds=2.0), after=marks)  # no silence at all
    assert made.found_by == "regions"
    assert [(part.first, part.end, part.label) for part in made.parts] == [
        (100, 5_100, "left"),
        (60_000, 67_000, "right"),
    ]
    kept = payloads(out / made.parts[1].file_name)["LIST"]
    assert b"right" in kept
    assert b"left" not in kept
    assert kept.endswith(struct.pack("<II4sHHHH", 2, 7_000, b"rgn ", 0, 0, 0, 0))


def test_what_the_master_carries_goes_along_and_points_where_it_did(tmp_path):
    before = [bext(1_000), chunk(b"LIST", b"INFO" + chunk(b"IART", b"Designer\0")), chunk(b"PEAK", bytes(16))]
    loop = STEP + GAP + 100
    _, made, out = split(tmp_path, steps(2), before=before, after=[smpl([(10, 20), (loop, loop + 50)])])
    second = made.parts[1]
    kept = payloads(out / second.file_name)
    assert struct.unpack_from("<Q", kept["bext"], 338)[0] == 1_000 + second.first
    assert kept["bext"][412:422] == struct.pack("<5h", *[0x7FFF] * 5)  # the loudness was that of the whole
    assert b"Designer" in kept["LIST"]
    assert "PEAK" not in kept
    layout, _ = raw(out / second.file_name)
    assert [(one.start, one.end) for one in layout.loops] == [(loop - second.first, loop - second.first + 50)]


@pytest.mark.parametrize(
    ("samples", "after", "code"),
    [
        (silence(seconds=3.0), [], "split:one-sound"),
        (sine(hz=440), [cue(100)], "split:one-sound"),
        (np.zeros((0, 1)), [], "split:unreadable"),
        (sine(hz=440, seconds=1.0), [cue(*range(0, 48_000, 400))], "split:too-many"),
    ],
)
def test_what_cannot_be_split_is_refused(tmp_path, samples, after, code):
    with pytest.raises(SplitRefused) as refused:
        split(tmp_path, samples, after=after)
    assert refused.value.code == code
    assert list((tmp_path / "out").iterdir()) == []


def test_another_file_than_wav_is_refused(tmp_path):
    (tmp_path / "steps.wav").write_bytes(b"fLaC" + bytes(100))
    with pytest.raises(SplitRefused) as refused:
        split_master(tmp_path / "steps.wav", tmp_path)
    assert refused.value.code == "split:unreadable"


@pytest.mark.parametrize(
    "torn", [b"", b"\xff\xff\xff\xff" + bytes(20), b"adtlltxt\xf0\xff\xff\xff" + bytes(4), bytes(3)]
)
def test_broken_chunks_do_no_harm(tmp_path, torn):
    _, made, _ = split(tmp_path, steps(2), after=[chunk(b"cue ", torn), chunk(b"LIST", torn), chunk(b"smpl", torn)])
    assert len(made.parts) == 2
