"""Which findings a fix answers, from the report alone."""

from dataclasses import replace
from pathlib import Path

import pytest

from audio_checks import FileReport, Finding, fix_in_words, fix_offer, parse_spec
from audio_checks.checks import all_checks
from audio_checks.fixing import offers
from audio_checks.spec import check_names

SPEC = parse_spec("""
format = 1
[accept]
encodings = ["pcm"]
bit_depths = [16, 24]
[limits]
sample_peak_dbfs = -0.1
true_peak_dbtp = -1.0
[naming]
pattern = '[a-z_]+'
""")
REPORT = FileReport(
    "deliveries/Laser Fire.wav",
    "rejected",
    facts={"container": "wav", "encoding": "pcm", "sample_rate_hz": 48_000, "bit_depth": 24, "frames": 48_000,
           "channels": 1},
    measurements={"sample_peak_dbfs": -4.0, "true_peak_dbtp": -3.0},
)  # fmt: skip


def finding(code, measured=None, limit=None):
    return Finding(code, "what was found", "what to do", measured=measured, limit=limit)


@pytest.mark.parametrize(
    ("found", "repair", "words"),
    [
        (finding("sample-peak:over", 0.0, -0.1), "gain", "lowers the level by 0.10 dB"),
        (finding("true-peak:over", 0.7, -1.0), "gain", "lowers the level by 1.70 dB"),
        (finding("loudness:over", -12.0, -16.0), "gain", "lowers the level by 4.00 dB"),
        (finding("loudness:under", -20.0, -18.0), "gain", "raises the level by 2.00 dB"),
        (finding("head-silence:over", 412.0, 5.0), "head", "trims 407.0 ms from the start"),
        (finding("tail-silence:over", 500.0, 100.0), "tail", "trims 400.0 ms from the end"),
        (finding("naming:pattern"), "name", "names it laser_fire.wav"),
        (finding("structure:padding"), "header", "rewrites the sizes in the header"),
        (finding("structure:stream-header"), "header", "rewrites the sizes in the header"),
    ],
)
def test_what_a_fix_does(found, repair, words):
    offer = fix_offer(found, REPORT, SPEC)
    assert (offer.repair, offer.words, bool(offer)) == (repair, words, True)


def test_depth_goes_down_only():
    too_deep = replace(REPORT, facts={**REPORT.facts, "bit_depth": 32})
    assert fix_offer(finding("bit-depth:not-accepted"), too_deep, SPEC).words == "brings it to 24 bit"
    floats = replace(too_deep, facts={**too_deep.facts, "encoding": "float"})
    assert fix_offer(finding("encoding:not-accepted"), floats, SPEC).repair == "depth"
    shallow = replace(REPORT, facts={**REPORT.facts, "bit_depth": 8})
    assert not fix_offer(finding("bit-depth:not-accepted"), shallow, SPEC)
    only_float = parse_spec("format = 1\n[accept]\nencodings = ['float']\n")
    assert not fix_offer(finding("encoding:not-accepted"), REPORT, only_float)


def test_a_level_rises_only_as_far_as_the_peaks_allow():
    offer = fix_offer(finding("loudness:under", -20.0, -17.9), REPORT, SPEC)
    assert not offer
    assert "2.0 dB" in offer.words


@pytest.mark.parametrize("name", [one for one in check_names.DEFAULT_SEVERITY if one in all_checks()])
def test_every_check_has_a_fix_or_says_why_not(name):
    if name in {"sample-peak", "true-peak", "loudness", "head-silence", "tail-silence", "structure", "naming",
                "bit-depth", "encoding", "container", "dc-offset"}:  # fmt: skip
        return
    offer = fix_offer(finding(f"{name}:anything"), REPORT, SPEC)
    assert not offer
    assert offer.words.endswith(".")


def test_a_whole_fix_in_words():
    found = [
        finding("sample-peak:over", 0.0, -0.1),
        finding("naming:pattern"),
        finding("true-peak:over", 0.7, -1.0),
        finding("dc-offset:over", 2.0, 1.0),
        finding("head-silence:over", 412.0, 5.0),
    ]
    offers_made = [fix_offer(one, REPORT, SPEC) for one in found]
    sound = "trims 407.0 ms from the start, takes out the DC offset, lowers the level by 1.70 dB"
    assert fix_in_words(offers_made) == f"{sound} and names it laser_fire.wav"
    assert fix_in_words(offers_made[:1]) == "lowers the level by 0.10 dB"
    assert fix_in_words([]) == ""


def test_a_name_that_is_valid_by_itself_is_not_offered_again():
    named = replace(REPORT, path="deliveries/laser_fire.wav")
    assert not fix_offer(finding("naming:twins"), named, SPEC)
    assert not fix_offer(finding("naming:ucs"), named, SPEC)


def test_another_kind_of_file_is_not_fixed():
    flac = replace(REPORT, facts={**REPORT.facts, "container": "flac"})
    assert "export it as WAV" in fix_offer(finding("sample-peak:over", 0.0, -0.1), flac, SPEC).words


def test_the_guide_names_every_finding_that_a_fix_answers():
    reported = (Path(__file__).parents[3] / "docs/reference/command-line.md").read_text(encoding="utf-8")
    assert [code for code in offers._OFFERS if f"`{code}`" not in reported] == []
