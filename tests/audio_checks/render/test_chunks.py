"""What a master carries beside its sound: kept where asked, moved with the sound, taken back where untrue."""

import io
import struct
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from audio_checks import RenderRefused, check_file, is_placeholder, parse_spec, wav
from audio_checks.metadata.moving import Move, carried
from audio_checks.render import carried_chunks
from audio_checks.render.render import render_master
from audio_checks.spec.delivery_spec import Target
from tests.support.steps import at_most
from tests.support.waves import chunk, join, noise, placeholder_mark, silence, sine, wav_bytes, write_wav

HALF = Target("half", 48_000, 16, chunks="all")
RATE, FRAMES = 96_000, 96_000
SHORT = noise(seconds=0.01, rate=RATE)


def cue(*points):
    body = b"".join(struct.pack("<II4sIII", number, at, b"data", 0, 0, at) for number, at in enumerate(points, 1))
    return chunk(b"cue ", struct.pack("<I", len(points)) + body)


def labels(point, length):
    ltxt = chunk(b"ltxt", struct.pack("<II4sHHHH", point, length, b"rgn ", 0, 0, 0, 0))
    return chunk(b"LIST", b"adtl" + chunk(b"labl", struct.pack("<I", point) + b"hit\0") + ltxt)


def info():
    return chunk(b"LIST", b"INFO" + chunk(b"IART", b"Somebody\0") + chunk(b"ICMT", b"take two\0"))


def smpl(*loops, kind=0):
    head = struct.pack("<9I", 7, 8, round(1e9 / RATE), 62, 1 << 31, 0, 0, len(loops), 4)
    body = b"".join(struct.pack("<6I", number, kind, *loop, 0, 0) for number, loop in enumerate(loops))
    return chunk(b"smpl", head + body + b"more")


def bext(began, levels=(-2300, 500, -100, -2000, -2200)):
    head = b"Door".ljust(256, b"\0") + b"A Studio".ljust(82, b"\0") + struct.pack("<QH", began, 2) + bytes(64)
    return chunk(
        b"bext",
        head + struct.pack("<5h", *levels) + bytes(180) + b"A=PCM,F=96000,W=24,M=mono\r\n\0",
    )


def ixml(began):
    text = (
        "<BWFXML><PROJECT>Shield Wing</PROJECT><SPEED><FILE_SAMPLE_RATE>96000</FILE_SAMPLE_RATE>"
        "<DIGITIZER_SAMPLE_RATE>96000</DIGITIZER_SAMPLE_RATE><TIMESTAMP_SAMPLE_RATE>96000</TIMESTAMP_SAMPLE_RATE>"
        f"<TIMESTAMP_SAMPLES_SINCE_MIDNIGHT_HI>{began >> 32}</TIMESTAMP_SAMPLES_SINCE_MIDNIGHT_HI>"
        f"<TIMESTAMP_SAMPLES_SINCE_MIDNIGHT_LO>{began & 0xFFFFFFFF}</TIMESTAMP_SAMPLES_SINCE_MIDNIGHT_LO></SPEED>"
        "<SYNC_POINT_LIST><SYNC_POINT><SYNC_POINT_LOW>1001</SYNC_POINT_LOW><SYNC_POINT_HIGH>0</SYNC_POINT_HIGH>"
        "</SYNC_POINT><SYNC_POINT><SYNC_POINT_LOW>5000</SYNC_POINT_LOW><SYNC_POINT_HIGH>0</SYNC_POINT_HIGH>"
        "</SYNC_POINT></SYNC_POINT_LIST><AUDIO_BIT_DEPTH>24</AUDIO_BIT_DEPTH>"
        "<TRACK_LIST><TRACK_COUNT>2</TRACK_COUNT></TRACK_LIST>"
        "<ASWG><project>Shield Wing</project><loudness>-23</loudness></ASWG></BWFXML>"
    )
    return chunk(b"iXML", text.encode())


def acid(tempo):
    return chunk(b"acid", struct.pack("<IHHfIHHf", 0, 60, 0x8000, 0.0, 8, 4, 4, tempo))


def everything(began=1 << 33):
    before = [bext(began), ixml(began), acid(120.0), chunk(b"xYz1", b"unknown")]
    after = [cue(0, 9_601, 95_999), smpl((9_600, 86_399)), chunk(b"inst", bytes([62, 0, 0, 0, 127, 1, 127, 0]))]
    return {"before": before, "after": [*after, labels(2, 1_001), info()]}


def rendered(tmp_path, target=HALF, *, samples=None, chunks=None, **more):
    samples = noise(seconds=FRAMES / RATE, rate=RATE) if samples is None else samples
    master = write_wav(tmp_path / "a.wav", samples, rate=RATE, **(everything() if chunks is None else chunks))
    made = render_master(master, target, tmp_path / "game.wav", **more)
    with wav.open_regular(made.path) as file:
        layout = wav.read_layout(file)
        kept = [(one.id, wav.chunk_payload(file, one)) for one in layout.chunks if one.id != "data"]
    assert layout.warnings == ()
    return made, kept


def one(kept, name):
    (payload,) = [payload for found, payload in kept if found == name]
    return payload


def test_all_of_them_survive_in_their_order_and_around_the_sound(tmp_path):
    _, kept = rendered(tmp_path)
    names = [name for name, _ in kept]
    assert names == ["fmt ", "bext", "iXML", "acid", "xYz1", "cue ", "smpl", "inst", "LIST", "LIST"]
    assert one(kept, "xYz1") == b"unknown"
    assert one(kept, "inst") == bytes([62, 0, 0, 0, 127, 1, 127, 0])
    assert kept[-1][1] == b"INFO" + chunk(b"IART", b"Somebody\0") + chunk(b"ICMT", b"take two\0")


def test_cues_regions_and_sync_points_lie_where_they_lay(tmp_path):
    _, kept = rendered(tmp_path)
    frames = [struct.unpack_from("<I", one(kept, "cue "), 4 + 24 * place + 20)[0] for place in range(3)]
    assert frames == [0, 4_801, 47_999]  # 4800.5 rounds up, and 47,999.5 stays inside
    ltxt = kept[-2][1].index(b"ltxt")
    assert struct.unpack_from("<I", kept[-2][1], ltxt + 12) == (5_301 - 4_801,)
    assert b"<SYNC_POINT_LOW>501</SYNC_POINT_LOW>" in one(kept, "iXML")  # 500.5 rounds up
    assert b"<SYNC_POINT_LOW>2500</SYNC_POINT_LOW>" in one(kept, "iXML")


def test_the_time_of_day_is_the_same_time_in_frames_of_the_new_rate(tmp_path):
    began = (1 << 33) + 1
    _, kept = rendered(tmp_path, chunks={"before": [bext(began), ixml(began)]})
    assert struct.unpack_from("<Q", one(kept, "bext"), 338) == ((1 << 32) + 1,)
    reported = one(kept, "iXML")
    assert b"_HI>1</TIMESTAMP" in reported
    assert b"_LO>1</TIMESTAMP" in reported
    assert reported.count(b"_SAMPLE_RATE>48000<") == 2
    assert b"<DIGITIZER_SAMPLE_RATE>96000<" in reported  # how it was recorded stays true


def test_a_sampler_keeps_its_notes_and_gets_its_period(tmp_path):
    _, kept = rendered(tmp_path)
    payload = one(kept, "smpl")
    assert struct.unpack_from("<9I", payload) == (7, 8, 20_833, 62, 1 << 31, 0, 0, 1, 4)
    assert struct.unpack_from("<6I", payload, 36) == (0, 0, 4_800, 43_199, 0, 0)
    assert payload.endswith(b"more")


def test_given_points_replace_the_loops_and_leave_the_notes(tmp_path):
    _, kept = rendered(tmp_path, loop_points=(100, 199))
    payload = one(kept, "smpl")
    assert struct.unpack_from("<2I", payload, 12) == (62, 1 << 31)
    assert struct.unpack_from("<6I", payload, 36) == (0, 0, 50, 99, 0, 0)


def test_what_became_untrue_is_taken_back(tmp_path):
    stereo = noise(seconds=1, rate=RATE, channels=2)
    _, kept = rendered(tmp_path, replace(HALF, channels=1), samples=stereo)
    history = one(kept, "bext")[602:]
    assert history == b"A=PCM,F=96000,W=24,M=mono\r\nA=PCM,F=48000,W=16,M=mono\r\n"
    reported = one(kept, "iXML")
    assert b"<AUDIO_BIT_DEPTH>16</AUDIO_BIT_DEPTH>" in reported
    assert b"loudness" not in reported
    assert b"TRACK_LIST" not in reported
    assert b"<project>Shield Wing</project>" in reported


def loudness_written(tmp_path, samples, levels):
    made, kept = rendered(tmp_path, samples=samples, chunks={"before": [bext(0, levels)]})
    return made.measurements, struct.unpack_from("<5h", one(kept, "bext"), 412)


@pytest.mark.slow
def test_loudness_is_stated_as_it_is_now_where_it_was_stated(tmp_path):
    # A tone of 997 Hz at -20 dBFS reads -23.01 LUFS in mono (BS.1770), at any rate: the master lied.
    tone = sine(hz=997, dbfs=-20, rate=RATE, seconds=4)
    figures, levels = loudness_written(tmp_path, tone, (-1000, 500, 0x7FFF, -900, -800))
    assert levels == (-2301, 0, 0x7FFF, -2301, -2301)
    assert figures["true_peak_dbtp"] == pytest.approx(-20, abs=0.1)  # known, but not written: it was not asked for
    assert loudness_written(tmp_path, tone, (0x7FFF,) * 5)[1] == (0x7FFF,) * 5


def test_loudness_of_silence_is_not_stated(tmp_path):
    _, levels = loudness_written(tmp_path, silence(seconds=1, rate=RATE), (-1000, 500, -100, -900, -800))
    assert levels == (0x7FFF,) * 5


def test_what_is_still_true_stays(tmp_path):
    master = write_wav(tmp_path / "a.wav", noise(seconds=2), **everything())
    render_master(master, Target("same", 48_000, 24, chunks="all"), tmp_path / "game.wav")
    with wav.open_regular(master) as one_file, wav.open_regular(tmp_path / "game.wav") as other:
        ours, theirs = wav.read_layout(one_file), wav.read_layout(other)
        for before, after in zip(ours.chunks, theirs.chunks, strict=True):
            reported = wav.chunk_payload(other, after)
            assert reported.startswith(wav.chunk_payload(one_file, before).rstrip(b"\0"))


def test_a_fitted_loop_keeps_its_beats(tmp_path):
    # 641 frames become 147 where 147.23 were wanted: the loop is shorter, so its tempo is higher.
    made, kept = rendered(
        tmp_path,
        Target("old", 22_050, 16, chunks="all"),
        samples=noise(seconds=641 / RATE, rate=RATE),
        chunks={"before": [acid(120.0)]},
        loop=True,
    )
    assert made.frames == 147
    (tempo,) = struct.unpack_from("<f", one(kept, "acid"), 20)
    assert tempo == pytest.approx(120 * (641 * 22_050 / 96_000) / 147, rel=1e-6)


def test_without_being_asked_only_what_describes_the_sound_goes_along(tmp_path):
    made, kept = rendered(tmp_path, replace(HALF, chunks="sound"))
    assert [name for name, _ in kept] == ["fmt ", "acid", "cue ", "smpl", "inst", "LIST"]
    assert kept[-1][1].startswith(b"adtl")
    whole = made.path.read_bytes()
    assert not any(word in whole for word in (b"A Studio", b"Shield", b"Somebody", b"unknown", b"A=PCM"))


@pytest.mark.parametrize("chunks", ["sound", "all"])
def test_a_placeholder_stays_marked(tmp_path, chunks):
    marked = {"after": [placeholder_mark("SW-014")]}
    made, _ = rendered(tmp_path, replace(HALF, chunks=chunks), chunks=marked)
    assert is_placeholder(made.path)
    spec = parse_spec("format = 1\n[targets.half]\nsample_rate_hz = 48000\nbit_depth = 16\n")
    (finding,) = check_file(made.path, spec, target="half", checks=["placeholder"]).findings
    assert "SW-014" in finding.message


def test_more_than_can_be_held_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(carried_chunks, "MOST_BYTES", 100)
    with pytest.raises(RenderRefused) as refused:
        rendered(tmp_path, chunks={"after": [chunk(b"pict", bytes(200))]})
    assert refused.value.code == "render:large-chunks"


def test_points_move_with_what_is_trimmed(tmp_path):
    quiet = silence(seconds=0.1, rate=RATE)
    sound = join(quiet, sine(hz=1_000, rate=RATE, seconds=0.1, phase=1.0), quiet)
    made, kept = rendered(
        tmp_path,
        replace(HALF, trim_below_dbfs=-60.0),
        samples=sound,
        chunks={"before": [bext(1_000)], "after": [cue(0, 9_600, 14_400, 28_000)]},
    )
    assert made.frames == 4_800
    frames = [struct.unpack_from("<I", one(kept, "cue "), 4 + 24 * place + 20)[0] for place in range(4)]
    assert frames == [0, 0, 2_400, 4_799]
    assert struct.unpack_from("<Q", one(kept, "bext"), 338) == ((1_000 + 9_600) // 2,)


@pytest.mark.parametrize(
    "text",
    [
        b"<BWFXML>" + b" " * 6_000_000,
        b"<TRACK_LIST>" * 450_000,
        b"<loudness>" * 450_000,
        b"<FILE_SAMPLE_RATE>" * 300_000 + b" " * 1_500_000,
        b"<SYNC_POINT_LOW>1</SYNC_POINT_LOW>" * 20_000,
        b"\xff\xfe" + bytes(50_000),
    ],
)
def test_a_document_is_read_a_few_times_whatever_is_in_it(tmp_path, text):
    # An expression that takes the square of these never ends; the most that one takes is 150,000 lines of Python.
    with at_most(1_000_000):
        rendered(
            tmp_path,
            replace(HALF, channels=1),
            samples=noise(seconds=0.05, channels=2),
            chunks={"before": [chunk(b"iXML", text)]},
        )


CHUNKS_OF_STRANGERS = st.sampled_from(["bext", "iXML", "cue ", "smpl", "LIST", "acid", "inst", "xYz1"])
BEGINNINGS = st.sampled_from([b"", b"adtlltxt\x40\0\0\0", struct.pack("<I", 9), bytes(28) + struct.pack("<I", 1 << 31)])


@pytest.mark.slow
@given(name=CHUNKS_OF_STRANGERS, beginning=BEGINNINGS, rest=st.binary(max_size=700))
@settings(max_examples=200)
def test_no_chunk_of_a_stranger_stops_a_render(name, beginning, rest):
    reported = chunk(name.encode(), beginning + rest)
    file = io.BytesIO(wav_bytes(SHORT, rate=RATE, before=[reported]))
    move = Move(cut=10, frames=475, changed=True, new_depth=16, sample_rate_hz=96_000, to_hz=48_000, new_channels=True)
    ((kept, payload),), after = carried(file, wav.read_layout(file), replace(move, history="A=PCM", stretch=1.01))
    assert (kept, after) == (name, [])
    assert len(payload) >= len(beginning + rest) or name == "iXML"
