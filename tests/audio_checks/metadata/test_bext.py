"""bext: every field of the standard, and what is left out."""

import pytest

from audio_checks.metadata.bext import FIELDS, read_bext
from tests.support.chunks import bext_payload


def test_every_field_of_version_2():
    payload = bext_payload(
        description="Door, oak",
        originator="Mara Lind",
        reference="ML0001",
        time_reference=2_418_000_123,
        umid=bytes(range(1, 33)),
        levels=(-2345, 310, -102, -1800, -1950),
        history="A=PCM,F=48000,W=24,M=stereo,T=Recorder\r\n",
    )
    fields = read_bext(payload)
    assert tuple(fields) == FIELDS
    assert fields == {
        "Description": "Door, oak",
        "Originator": "Mara Lind",
        "OriginatorReference": "ML0001",
        "OriginationDate": "2026-11-21",
        "OriginationTime": "14:05:00",
        "TimeReference": "2418000123",
        "Version": "2",
        "UMID": bytes(range(1, 33)).hex(),
        "LoudnessValue": "-23.45",
        "LoudnessRange": "3.10",
        "MaxTruePeakLevel": "-1.02",
        "MaxMomentaryLoudness": "-18.00",
        "MaxShortTermLoudness": "-19.50",
        "CodingHistory": "A=PCM,F=48000,W=24,M=stereo,T=Recorder",
    }


def test_what_is_empty_or_unset_is_left_out():
    fields = read_bext(bext_payload(date="", time=""))
    assert fields == {"TimeReference": "0", "Version": "2"}


@pytest.mark.parametrize(("version", "known"), [(0, set()), (1, {"UMID"}), (2, {"UMID", "LoudnessValue"})])
def test_a_field_counts_from_the_version_that_brought_it(version, known):
    payload = bext_payload(version=version, umid=b"\x01" * 64, levels=(-2300, 0x7FFF, 0x7FFF, 0x7FFF, 0x7FFF))
    assert {"UMID", "LoudnessValue"} & set(read_bext(payload)) == known


def test_text_ends_at_its_first_zero_and_may_be_what_windows_wrote():
    payload = bytearray(bext_payload(description="Tür\0left over"))
    assert read_bext(bytes(payload))["Description"] == "Tür"
    payload[:256] = "Schuß".encode("cp1252").ljust(256, b"\0")
    assert read_bext(bytes(payload))["Description"] == "Schuß"


def test_a_full_field_has_no_zero():
    assert read_bext(bext_payload(originator="x" * 32, reference="y"))["Originator"] == "x" * 32


def test_a_short_chunk_is_refused():
    assert "CodingHistory" not in read_bext(bext_payload())
    with pytest.raises(ValueError, match="601 bytes; 602 or more"):
        read_bext(bext_payload()[:601])


@pytest.mark.parametrize("cut", [1, 2])
@pytest.mark.parametrize("zero", [b"", b"\0"])
def test_a_letter_that_was_cut_is_left_out(cut, zero):
    letters = "アイウエオカキクケコ".encode()  # three bytes each
    field = (b"x" * (256 - len(zero) - 3 * 9 - cut) + letters)[: 256 - len(zero)] + zero
    payload = bytearray(bext_payload())
    payload[:256] = field
    assert read_bext(bytes(payload))["Description"] == "x" * (256 - len(zero) - 27 - cut) + "アイウエオカキクケ"


def test_a_cut_letter_after_plain_ones():
    payload = bytearray(bext_payload())
    payload[256:288] = b"y" * 31 + "ü".encode()[:1]
    assert read_bext(bytes(payload))["Originator"] == "y" * 31


def test_an_accent_of_windows_at_the_end_is_no_cut_letter():
    payload = bytearray(bext_payload())
    payload[256:288] = "café".encode("cp1252").ljust(32, b"\0")
    assert read_bext(bytes(payload))["Originator"] == "café"
