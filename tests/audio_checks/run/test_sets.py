"""Checks over files together: who takes part, what it weighs, and whose fault a crash is."""

import unicodedata

import pytest

from audio_checks import check_files
from audio_checks.checks import naming
from audio_checks.cli import main
from audio_checks.errors import SpecError
from audio_checks.report.findings import FileReport
from audio_checks.report.judged import JudgedFile
from audio_checks.run import sets as sets_module
from audio_checks.run.sets import offset_from_set_lu, set_findings, with_set_findings
from audio_checks.spec.delivery_spec import CueFacts, parse_spec, schema
from tests.support.waves import noise, write_wav

SPEC = parse_spec("format = 1\nnaming.portable = true")


def judged(path, spec=SPEC, **more):
    return JudgedFile(FileReport(path, "conforming", facts={"duration_s": 1.0}, **more), spec)


def codes(files):
    return [[finding.code for finding in findings] for findings in set_findings(files)]


NFC = "tür.wav"


@pytest.mark.parametrize(
    ("names", "twins"),
    [
        (("laser.wav", "Laser.wav"), True),
        (("a/laser.wav", "b/Laser.wav"), False),
        (("a/laser.wav", "A/laser.wav"), True),
        ((NFC, unicodedata.normalize("NFD", NFC)), True),
        (("STRASSE.wav", "straße.wav"), True),
        (("laser.wav", "laser_2.wav"), False),
        (("laser.wav", "laser.WAV"), True),
        (("laser.wav", "./laser.wav"), False),
    ],
)
def test_name_twins(names, twins):
    assert codes([judged(name) for name in names]) == ([["naming:twins"], ["naming:twins"]] if twins else [[], []])


def test_a_twin_is_named_and_fails_where_names_do():
    first, second = set_findings([judged("laser.wav"), judged("Laser.wav")])
    assert first[0].message.startswith("Laser.wav in the same folder")
    assert second[0].severity == "error"
    reports = with_set_findings([judged("laser.wav"), judged("Laser.wav")])
    assert {report.verdict for report in reports} == {"rejected"}


def test_only_names_that_are_to_be_portable_are_asked():
    loose = parse_spec("format = 1")
    assert codes([judged("laser.wav", loose), judged("Laser.wav", loose)]) == [[], []]
    off = parse_spec("format = 1\nnaming.portable = true\nchecks.naming = 'off'")
    assert codes([judged("laser.wav", off), judged("Laser.wav")]) == [[], []]


def test_severity_is_each_files_own(tmp_path):
    paths = [write_wav(tmp_path / f"{name}.wav", noise(seconds=0.1)) for name in ("a", "vo_b")]
    spec = parse_spec(
        'format = 1\nchecks.duplicate = "off"\nchecks.cut-start = "off"\nchecks.cut-tail = "off"\n'
        '[files]\n"vo_*" = "vo"\n[categories.vo]\nchecks.duplicate = "warning"'
    )
    paths.append(write_wav(tmp_path / "vo_c.wav", noise(seconds=0.1)))
    assert [[finding.severity for finding in entry.findings] for entry in check_files(paths, spec).files] == [
        [],
        [],
        ["warning"],
    ]


@pytest.mark.parametrize("check", ["duplicate", "variation-set", "reverb-set"])
@pytest.mark.parametrize("table", ["checks", "categories.vo.checks"])
def test_what_is_found_over_files_together_returns_none_of_them(check, table):
    with pytest.raises(SpecError, match="found over files together") as refusal:
        parse_spec(f'format = 1\n[{table}]\n{check} = "error"')
    assert refusal.value.where == f"spec.toml: {table}.{check}"
    assert schema()["properties"]["checks"]["properties"][check] == {"enum": ["warning", "off"]}


def test_findings_over_a_set_change_no_other_verdict():
    unreadable = JudgedFile(FileReport("Laser.wav", "unreadable"), SPEC)
    assert codes([judged("laser.wav"), unreadable]) == [[], []]
    rejected = JudgedFile(FileReport("Laser.wav", "rejected", facts={"duration_s": 1.0}), SPEC)
    assert [report.verdict for report in with_set_findings([judged("laser.wav"), rejected])] == ["rejected"] * 2


def test_a_check_that_breaks_leaves_its_files_unjudged(monkeypatch):
    def broken(files):
        yield 0, naming.Finding("naming:twins", "found before it broke", "none")
        raise ZeroDivisionError("by zero")

    monkeypatch.setattr(naming, "check_set", broken)
    reports = with_set_findings([judged("a.wav"), judged("b.wav")])
    assert {report.verdict for report in reports} == {"unjudged"}
    assert [finding.code for finding in reports[1].findings] == ["naming:crashed"]
    assert "nothing is known to be wrong with the file" in reports[1].findings[0].message


def test_how_far_each_file_is_from_its_set():
    def step(variation, level, **more):
        cue = CueFacts("SW-1", variations=4)
        report = FileReport("a.wav", "conforming", facts={"duration_s": 1.0}, measurements={"integrated_lufs": level})
        return JudgedFile(report, SPEC, cue, variation, **more)

    files = [step(1, -20.0), step(2, -20.5), step(3, -16.0), step(3, -19.0, is_alternate=True), step(4, None)]
    unreadable = JudgedFile(FileReport("b.wav", "unreadable"), SPEC)
    assert offset_from_set_lu([*files, unreadable]) == [-1.75, -2.5, 4.25, 1.25, None, None]
    assert offset_from_set_lu(files[:1]) == [None]


@pytest.mark.slow
def test_processes_say_the_same_as_one(tmp_path):
    paths = [write_wav(tmp_path / f"{name}.wav", noise(seconds=0.1)) for name in "abcd"]
    assert check_files(paths, SPEC, jobs=2) == check_files(paths, SPEC)


def test_the_order_of_checks_is_that_of_the_format():
    assert [check for check in sets_module.all_checks() if check in ("naming", "duplicate", "variation-set")] == [
        "naming",
        "duplicate",
        "variation-set",
    ]


def test_the_command_line_says_so_too(tmp_path, capsys, monkeypatch):
    for name in "ab":
        write_wav(tmp_path / f"{name}.wav", noise(seconds=0.1))
    spec = tmp_path / "spec.toml"
    spec.write_text("format = 1\nnaming.portable = true\n")
    check = ["check", "--spec", str(spec), "--no-cache", str(tmp_path)]
    assert main(check) == 0
    assert "the same samples as a.wav" in capsys.readouterr().out
    assert main([*check, "--fail-level", "warning"]) == 1
    monkeypatch.setattr(naming, "check_set", lambda _files: 1 / 0)
    assert main(check) == 2  # a fault of the tool outranks what it found
