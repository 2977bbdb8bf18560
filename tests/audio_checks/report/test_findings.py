"""The report: what it counts, what its JSON says, and that nothing raw is ever printed."""

import json
import math
from dataclasses import replace

import jsonschema_rs
import pytest

from audio_checks.report.findings import FileReport, Finding, Report, SpecRef, dumps, printable, schema, with_waivers

OVER = Finding(
    "true-peak:over", "true peak -0.20 dBTP, limit -1 dBTP", "lower it", "error", -0.2, -1.0, "dBTP", 1.2, 1.3
)
SILENT = Finding("silence:file", "digital silence", "unmute", "error", -math.inf, -90.0, "dBFS")
LATE = Finding("head-silence:over", "9 ms", "trim", "warning")
FACTS = {"container": "wav", "encoding": "pcm", "sample_rate_hz": 48_000, "bit_depth": 24, "effective_bits": 24}
FACTS |= {"channels": 2, "frames": 48_000, "duration_s": 1.0, "chunks": ["fmt ", "data"]}
ENTRY = FileReport(
    "shield.wav",
    "rejected",
    "a" * 64,
    "b" * 64,
    "weapon",
    FACTS,
    {"true_peak_dbtp": -math.inf},
    {},
    (OVER, SILENT, LATE),
)
REPORT = Report(
    files=(ENTRY, FileReport("a.wav", "conforming"), FileReport("b.wav", "unreadable")),
    specs=(SpecRef("Shield Wing", "c" * 64),),
    not_run=("baked-reverb",),
    tool_version="1.2.3",
)


def test_the_check_is_the_code_before_the_colon():
    assert OVER.check == "true-peak"


def test_the_summary_counts_files_and_findings():
    assert REPORT.summary == {
        "files": 3,
        "conforming": 1,
        "rejected": 1,
        "unreadable": 1,
        "unjudged": 0,
        "errors": 2,
        "warnings": 1,
        "waived": 0,
    }


def test_the_json_holds_to_its_schema():
    document = json.loads(dumps(REPORT.to_dict()))
    jsonschema_rs.validator_for(schema()).validate(document)
    assert document["files"][0]["findings"][0] == {
        "check": "true-peak",
        "code": "true-peak:over",
        "severity": "error",
        "message": "true peak -0.20 dBTP, limit -1 dBTP",
        "fix": "lower it",
        "measured": -0.2,
        "limit": -1.0,
        "unit": "dBTP",
        "start_s": 1.2,
        "end_s": 1.3,
    }
    assert document["spec"] == {"name": "Shield Wing", "sha256": "c" * 64}
    assert "specs" not in document
    assert document["not_run"] == ["baked-reverb"]


def test_several_specs_are_listed_and_none_is_the_spec():
    two = (SpecRef("Shield Wing", "c" * 64), SpecRef("Shield Wing: UI", "d" * 64))
    document = json.loads(dumps(replace(REPORT, specs=two).to_dict()))
    jsonschema_rs.validator_for(schema()).validate(document)
    assert document["spec"] is None
    assert [spec["name"] for spec in document["specs"]] == ["Shield Wing", "Shield Wing: UI"]
    assert Report.from_dict(document).specs == two


@pytest.mark.parametrize("wrong", [{"schema_version": 2}, {"files": [{}]}, {"summary": {"files": -1}}])
def test_the_schema_refuses(wrong):
    assert not jsonschema_rs.validator_for(schema()).is_valid({**REPORT.to_dict(), **wrong})


def test_minus_infinity_is_null():
    entry = ENTRY.to_dict()
    assert entry["findings"][1]["measured"] is None
    assert entry["measurements"] == {"true_peak_dbtp": None}


def test_a_report_comes_back_from_its_json():
    document = json.loads(dumps(REPORT.to_dict()))
    assert Report.from_dict(document).to_dict() == document


def test_what_is_no_report():
    for wrong in ({}, {"schema_version": 1}, {"schema_version": 1, "files": 3, "tool": {"version": ""}}):
        with pytest.raises(ValueError, match="not a report"):
            Report.from_dict(wrong)


def test_measured_entries_carry_no_verdict():
    assert {"verdict", "findings"}.isdisjoint(ENTRY.to_measured())
    assert ENTRY.to_measured()["facts"] == FACTS


def test_a_waiver_marks_its_codes_and_changes_no_verdict():
    entry = with_waivers(ENTRY, {"b" * 64: frozenset({"true-peak:over"})})
    assert [finding.waived for finding in entry.findings] == [True, False, False]
    assert entry.verdict == "rejected"
    assert (entry.count("error"), entry.count("error", waived=False)) == (2, 1)
    assert entry.to_dict()["findings"][0]["waived"] is True
    assert with_waivers(ENTRY, {"d" * 64: frozenset({"true-peak:over"})}) is ENTRY


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("laser.wav", "laser.wav"),
        ("a\nb", "a\\nb"),
        ("a\x1b[31m", "a\\x1b[31m"),
        ("\u202egnp.wav", "\\u202egnp.wav"),
        ("\x7f", "\\x7f"),
        ("\u2028", "\\u2028"),
        ("\ud800", "\\ud800"),
        ("größe 大.wav", "größe 大.wav"),
    ],
)
def test_what_does_not_print_is_shown_escaped(text, shown):
    assert printable(text) == shown


def test_json_has_no_raw_control_characters():
    text = dumps({"path": "".join(map(chr, range(0xA0))) + "\u202e\u2066\ud800"})
    assert text.isascii()
    assert text.isprintable()
