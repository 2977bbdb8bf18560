"""A master that is handed out says where it comes from, and is the same sound."""

import hashlib
import struct

import pytest

from audio_checks import AudioFile, Provenance, RenderRefused, export_master, wav
from audio_checks.cli import main
from tests.support.waves import chunk, noise, placeholder_mark, smpl, write_wav

KNOWN = Provenance(
    project="Shield Wing & Co",
    studio="Two Rivers",
    originator="Foley House",
    number="SW-014",
    name="Door, heavy",
    notes="when the gate falls\n",
    made_on="2026-11-21",
    contract="SW contract 2",
    state="approved",
    fields={"catId": "DOORWood", "isLoop": "false"},
)


def exported(tmp_path, provenance=KNOWN, **more):
    master = write_wav(tmp_path / "door.wav", noise(seconds=0.1, channels=2), **more)
    before = master.read_bytes()
    made = export_master(master, tmp_path / "out.wav", provenance)
    assert master.read_bytes() == before
    with AudioFile(made.path) as file:
        return made, file.metadata.fields, file.layout


def test_bext_and_ixml_say_what_is_known(tmp_path):
    _, reported, layout = exported(tmp_path)
    assert layout.warnings == ()
    assert {name: text for name, text in reported.items() if name.startswith("bext.")} == {
        "bext.Description": "SW-014 Door, heavy; Shield Wing & Co; SW contract 2; approved",
        "bext.Originator": "Foley House",
        "bext.OriginatorReference": "SW-014",
        "bext.OriginationDate": "2026-11-21",
        "bext.TimeReference": "0",
        "bext.Version": "2",
        "bext.CodingHistory": "A=PCM,F=48000,W=24,M=stereo",
    }
    assert (reported["iXML.PROJECT"], reported["iXML.NOTE"]) == ("Shield Wing & Co", "when the gate falls")
    assert {name.removeprefix("iXML.ASWG."): text for name, text in reported.items() if ".ASWG." in name} == {
        "project": "Shield Wing & Co",
        "originator": "Foley House",
        "originatorStudio": "Two Rivers",
        "fxName": "Door, heavy",
        "orderRef": "SW-014",
        "notes": "when the gate falls",
        "originationDate": "2026-11-21",
        "billingCode": "SW contract 2",
        "state": "approved",
        "catId": "DOORWood",
        "isLoop": "false",
    }


@pytest.mark.parametrize("bits", [8, 16, 24, 32])
def test_the_sound_is_the_same_byte_for_byte(tmp_path, bits):
    made, _, layout = exported(tmp_path, bits=bits)
    with wav.open_regular(tmp_path / "door.wav") as file:
        old = wav.read_layout(file)
    ours = made.path.read_bytes()[layout.data_offset :][: layout.data_size]
    assert ours == (tmp_path / "door.wav").read_bytes()[old.data_offset :][: old.data_size]
    assert made.pcm_sha256 == hashlib.sha256(ours).hexdigest()
    assert made.sha256 == hashlib.sha256(made.path.read_bytes()).hexdigest()
    assert made.master_sha256 == hashlib.sha256((tmp_path / "door.wav").read_bytes()).hexdigest()


def test_what_the_file_says_already_stays_but_for_what_is_known_better(tmp_path):
    bext = b"My words".ljust(256, b"\0") + b"Nobody".ljust(82, b"\0") + struct.pack("<QH", 77, 1) + bytes(254)
    ixml = b"<BWFXML><PROJECT>Old</PROJECT><TAPE>7</TAPE><ASWG><catId>GUNAuto</catId><mixer>M</mixer></ASWG></BWFXML>\0"
    chunks = {
        "before": [chunk(b"bext", bext + b"A=PCM,F=96000\r\n"), smpl([(0, 99)])],
        "after": [chunk(b"iXML", ixml), chunk(b"xYz1", b"unknown"), placeholder_mark("SW-1")],
    }
    _, reported, layout = exported(tmp_path, **chunks)
    assert [one.id for one in layout.chunks] == ["fmt ", "bext", "smpl", "data", "iXML", "xYz1", "LIST"]
    assert (reported["bext.Description"], reported["bext.Originator"]) == ("My words", "Foley House")
    assert (reported["bext.TimeReference"], reported["bext.CodingHistory"]) == ("77", "A=PCM,F=96000")
    assert (reported["iXML.PROJECT"], reported["iXML.TAPE"]) == ("Shield Wing & Co", "7")
    assert (reported["iXML.ASWG.catId"], reported["iXML.ASWG.mixer"]) == ("DOORWood", "M")


def test_what_is_not_known_is_not_said(tmp_path):
    _, reported, _ = exported(tmp_path, Provenance())
    assert set(reported) == {
        *("bext.TimeReference", "bext.Version", "bext.CodingHistory"),
        *("iXML.IXML_VERSION", "iXML.SPEED.FILE_SAMPLE_RATE", "iXML.SPEED.AUDIO_BIT_DEPTH"),
    }


def test_the_same_knowledge_gives_the_same_bytes(tmp_path):
    first = exported(tmp_path)[0]
    assert exported(tmp_path)[0].sha256 == first.sha256


# What would grow to a billion laughs, or read another file, once its entities were expanded.
LAUGHS = "".join(f'<!ENTITY a{n} "{f"&a{n - 1};" * 10}">' for n in range(1, 10))
ELSEWHERE = '<!ENTITY a9 SYSTEM "file:///etc/passwd">'


@pytest.mark.parametrize("entities", [f'<!ENTITY a0 "ha">{LAUGHS}', ELSEWHERE, '<!ENTITY a9 "c">'])
def test_entities_are_refused_before_anything_expands_them(tmp_path, monkeypatch, entities):
    ixml = f"<!DOCTYPE BWFXML [{entities}]><BWFXML><NOTE>&a9;</NOTE></BWFXML>".encode()
    monkeypatch.setattr(
        "audio_checks.render.provenance.ET.fromstring", lambda *_: pytest.fail("entities reached the parser")
    )
    made, _, _ = exported(tmp_path, after=[chunk(b"iXML", ixml)])
    assert made.left == ('the "iXML" chunk declares a document type, which iXML never does; it is left as it is',)
    assert ixml in made.path.read_bytes()


@pytest.mark.parametrize("ixml", [b"<BWFXML><PROJECT>", b"<BWFXML>&b;</BWFXML>"])
def test_an_ixml_that_cannot_be_read_is_left_and_said(tmp_path, ixml):
    made, _, _ = exported(tmp_path, after=[chunk(b"iXML", ixml)])
    assert len(made.left) == 1
    assert made.left[0].endswith("it is left as it is")
    assert ixml in made.path.read_bytes()


def test_long_texts_are_cut_between_characters(tmp_path):
    _, reported, _ = exported(tmp_path, Provenance(originator="é" * 20))
    assert reported["bext.Originator"] == "é" * 16
    assert reported["iXML.ASWG.originator"] == "é" * 20


def test_a_master_is_not_its_own_copy(tmp_path):
    master = write_wav(tmp_path / "door.wav", noise(seconds=0.1))
    with pytest.raises(RenderRefused) as refused:
        export_master(master, master, KNOWN)
    assert refused.value.code == "export:over-master"


@pytest.mark.parametrize("wrong", [{"fields": {"colour": "red"}}, {"made_on": "yesterday"}])
def test_what_is_no_field_and_no_day(wrong):
    with pytest.raises(ValueError, match=r"colour|yesterday"):
        Provenance(**wrong)


def test_command(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "sounds.csv").write_text("number,name,file_name,loop,description\nSW-014,Door,door,yes,falls shut\n")
    (tmp_path / "in").mkdir()
    write_wav(tmp_path / "in" / "door__alt2.wav", noise(seconds=0.1))
    (tmp_path / "in" / "broken.wav").write_bytes(b"RIFF")
    asked = ["export-master", "--project", "Shield Wing", "--list", "sounds.csv", "--out", "out", "in"]
    assert main([*asked, "--field", "catId=DOORWood"]) == 1
    assert capsys.readouterr().out.splitlines()[1] == "in/door__alt2.wav -> out/door__alt2.wav"
    with AudioFile(tmp_path / "out" / "door__alt2.wav") as file:
        reported = file.metadata.fields
    assert (reported["iXML.ASWG.catId"], reported["iXML.ASWG.isLoop"]) == ("DOORWood", "true")
    assert (reported["iXML.ASWG.orderRef"], reported["iXML.NOTE"]) == ("SW-014", "falls shut")
    assert main([*asked, "--field", "colour=red"]) == 2
    assert main([*asked, "--field", "catId"]) == 2
