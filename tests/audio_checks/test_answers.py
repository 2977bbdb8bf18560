"""An answer that lies is refused in words before anything of it is used."""

import math
import pickle

import numpy as np
import pytest

from audio_checks import FileReport, Finding, SandboxCrashed, Unreadable, check_file
from audio_checks.sandbox.messages import RAISED, RETURNED, resolved
from tests.support.waves import sine, write_wav

FINDING = Finding("true-peak:over", "found", "lower it", measured=-math.inf)


def answered(value, kind=RETURNED):
    return resolved((kind, pickle.dumps(value, protocol=5)))


def with_field(value, name, lie):
    object.__setattr__(value, name, lie)
    return value


def nested(depth):
    value = []
    for _ in range(depth):
        value = [value]
    return value


@pytest.mark.parametrize(
    ("lie", "why"),
    [
        (FileReport(path=7, verdict="conforming"), "FileReport.path is not"),
        (FileReport("a.wav", "approved"), "FileReport.verdict is not"),
        (FileReport("a.wav", "conforming", findings=[FINDING]), "FileReport.findings is not"),
        (FileReport("a.wav", "conforming", findings=("over",)), "FileReport.findings is not"),
        (FileReport("a.wav", "conforming", findings=(FINDING,) * 1_000_000), "1,000,000 entries"),
        (FileReport("a.wav", "conforming", measurements=[1]), "FileReport.measurements is not"),
        (Finding("a:b", "found", "lower it", measured=math.nan), "Finding.measured is not"),
        (Finding("a:b", "found", "lower it", measured="loud"), "Finding.measured is not"),
        (Finding("a:b", "x" * (5 << 20), "lower it"), "5,242,880 characters"),
        (with_field(Finding("a:b", "found", "lower it"), "to_dict", 1), "Finding has no to_dict"),
        (nested(100), "deeper than 64"),
        ([[]] * 3_000_000, "more than 2,000,000 values"),
        (np.array([{}], dtype=object), "an array of objects"),
    ],
)
def test_a_lie_is_refused(lie, why):
    with pytest.raises(SandboxCrashed, match="cannot be read") as refusal:
        answered(lie)
    assert why in str(refusal.value)


def test_so_is_an_error_of_another_kind():
    with pytest.raises(SandboxCrashed):
        answered(Unreadable("x" * (5 << 20), "R1", "a:b", "f"), RAISED)


def test_an_honest_answer_passes(tmp_path):
    report = check_file(write_wav(tmp_path / "a.wav", sine(hz=997, dbfs=0)), all_figures=True)
    assert answered(report) == report
    assert answered(FINDING) == FINDING
    assert answered({"thumb": [1, 2], "bands": [None, 1.5]}) == {"thumb": [1, 2], "bands": [None, 1.5]}
