"""What a file carries beside its sound stays with it, and points where it pointed."""

import struct

import pytest

from audio_checks import FixRefused, fix_master, parse_spec, wav
from audio_checks.fixing import fix_master as fix
from tests.support.waves import chunk, join, silence, sine, write_wav

SPEC = parse_spec("format = 1\n[limits]\nhead_silence_ms = 0\ntail_silence_ms = 0\nsample_peak_dbfs = -1.0\n")
HEAD, SOUND, TAIL = 9_600, 4_800, 14_400  # frames: 9600 and 14400 are cut


def cue(*points):
    body = b"".join(struct.pack("<II4sIII", number, at, b"data", 0, 0, at) for number, at in enumerate(points, 1))
    return chunk(b"cue ", struct.pack("<I", len(points)) + body)


def region(point, length):
    ltxt = chunk(b"ltxt", struct.pack("<II4sHHHH", point, length, b"rgn ", 0, 0, 0, 0))
    return chunk(b"LIST", b"adtl" + chunk(b"labl", struct.pack("<I", point) + b"hit\0") + ltxt)


def bext(began, version=2):
    head = b"Door".ljust(338, b"\0") + struct.pack("<QH", began, version) + bytes(64)
    return chunk(b"bext", head + struct.pack("<5h", -2300, 500, -100, -2000, -2200) + bytes(180))


def ixml(began):
    text = (
        f"<BWFXML><AUDIO_BIT_DEPTH>24</AUDIO_BIT_DEPTH><NOTE>caf\u00e9</NOTE><SPEED>"
        f"<TIMESTAMP_SAMPLES_SINCE_MIDNIGHT_HI>{began >> 32}</TIMESTAMP_SAMPLES_SINCE_MIDNIGHT_HI>"
        f"<TIMESTAMP_SAMPLES_SINCE_MIDNIGHT_LO>{began & 0xFFFFFFFF}</TIMESTAMP_SAMPLES_SINCE_MIDNIGHT_LO>"
        "</SPEED></BWFXML>"
    )
    return chunk(b"iXML", text.encode())


def fixed(tmp_path, *, before=(), after=(), dbfs=-6.0, spec=SPEC, **more):
    sound = join(
        silence(seconds=HEAD / 48_000), sine(hz=1_000, dbfs=dbfs, seconds=SOUND / 48_000, phase=1.0),
        silence(seconds=TAIL / 48_000),
    )  # fmt: skip
    master = write_wav(tmp_path / "door.wav", sound, before=before, after=after, **more)
    out = tmp_path / "out"
    out.mkdir(exist_ok=True)
    made = fix_master(master, spec, out)
    with wav.open_regular(made.path) as file:
        layout = wav.read_layout(file)
        return made, {one.id: wav.chunk_payload(file, one) for one in layout.chunks}, layout


def test_cue_points_move_with_the_sound(tmp_path):
    _, kept, _ = fixed(tmp_path, after=[cue(0, HEAD, HEAD + 1_000, HEAD + SOUND + 2_000)])
    points = [struct.unpack_from("<I", kept["cue "], 4 + 24 * place + 20)[0] for place in range(4)]
    assert points == [0, 0, 1_000, SOUND - 1]


def test_a_region_keeps_what_is_left_of_it(tmp_path):
    _, kept, _ = fixed(tmp_path, before=[cue(HEAD - 100)], after=[region(1, 600)])
    assert kept["LIST"].endswith(struct.pack("<II4sHHHH", 1, 500, b"rgn ", 0, 0, 0, 0))
    assert b"hit" in kept["LIST"]


def test_the_sound_begins_later_in_the_day(tmp_path):
    began = (3 << 32) - 100
    _, kept, _ = fixed(tmp_path, before=[bext(began)], after=[ixml(began)])
    assert struct.unpack_from("<Q", kept["bext"], 338)[0] == began + HEAD
    assert b"SINCE_MIDNIGHT_HI>3</" in kept["iXML"]
    assert f"SINCE_MIDNIGHT_LO>{HEAD - 100}</".encode() in kept["iXML"]
    assert "café".encode() in kept["iXML"]
    assert kept["bext"][412:422] == struct.pack("<5h", -2300, 500, -100, -2000, -2200)  # no level was moved


def test_what_was_measured_of_the_old_level_is_taken_back(tmp_path):
    _, kept, _ = fixed(tmp_path, before=[bext(0), chunk(b"PEAK", bytes(16)), chunk(b"levl", bytes(120))], dbfs=0.0)
    assert kept["bext"][412:422] == struct.pack("<5h", *[0x7FFF] * 5)
    assert not {"PEAK", "levl"} & kept.keys()


def test_a_peak_record_of_unchanged_samples_stays(tmp_path):
    _, kept, _ = fixed(tmp_path, before=[chunk(b"PEAK", b"p" * 16)])
    assert kept["PEAK"] == b"p" * 16


def test_an_old_bext_has_no_loudness_to_take_back(tmp_path):
    _, kept, _ = fixed(tmp_path, before=[bext(0, version=1)], dbfs=0.0)
    assert kept["bext"][412:422] == struct.pack("<5h", -2300, 500, -100, -2000, -2200)


def test_everything_else_is_carried_byte_for_byte_in_its_place(tmp_path):
    info = chunk(b"LIST", b"INFO" + chunk(b"IART", b"Designer\0"))
    others = {b"inst": b"i" * 7, b"acid": b"a" * 24, b"XyZ1": b"x" * 33, b"id3 ": b"3" * 10}
    _, kept, layout = fixed(
        tmp_path, before=[chunk(b"inst", others[b"inst"]), info], after=[chunk(*item) for item in others.items()][1:]
    )
    assert {name.decode(): payload for name, payload in others.items()}.items() <= kept.items()
    assert kept["LIST"] == info[8:]
    assert [one.id for one in layout.chunks] == ["fmt ", "inst", "LIST", "data", "acid", "XyZ1", "id3 "]


def test_the_new_depth_is_stated(tmp_path):
    spec = parse_spec("format = 1\n[accept]\nbit_depths = [16]\n")
    _, kept, _ = fixed(tmp_path, after=[ixml(0)], spec=spec)
    assert b"<AUDIO_BIT_DEPTH>16<" in kept["iXML"]


def test_broken_chunks_are_carried_as_far_as_they_go(tmp_path):
    torn = [
        chunk(b"cue ", struct.pack("<I", 1_000_000) + bytes(30)),
        chunk(b"smpl", bytes(20)),
        chunk(b"bext", b"short"),
        chunk(b"LIST", b"adtl" + b"ltxt" + struct.pack("<I", 0xFFFFFFF0) + bytes(4)),
        chunk(b"iXML", b"<TIMESTAMP_SAMPLES_SINCE_MIDNIGHT_LO>" + b"9" * 30),
    ]
    made, kept, _ = fixed(tmp_path, after=torn)
    assert made.conforms
    assert [len(kept[name]) for name in ("cue ", "smpl", "bext")] == [34, 20, 5]


def test_more_than_can_be_held_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(fix, "MOST_BYTES", 1_000)
    with pytest.raises(FixRefused) as refused:
        fixed(tmp_path, after=[chunk(b"XyZ1", bytes(1_001))])
    assert refused.value.code == "fix:large-chunks"
    assert list((tmp_path / "out").iterdir()) == []
