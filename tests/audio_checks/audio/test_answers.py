"""An answer that lies is refused in words before anything of it is used."""

import math
from typing import NotRequired, TypedDict

import numpy as np
import pytest
from numpy.typing import NDArray

from audio_checks import FileReport, Finding, SandboxCrashed, Unreadable, check_file
from audio_checks.audio.sandbox.messages import RAISED, RETURNED, resolved
from audio_checks.audio.sandbox.plain import encode
from tests.support.waves import sine, write_wav

FINDING = Finding("true-peak:over", "found", "lower it", measured=-math.inf)


def anything():
    """Replace a function that declares nothing."""


def answered(value, kind=RETURNED, function=anything):
    return resolved((kind, encode(value)), function)


@pytest.mark.parametrize(
    ("lie", "why"),
    [
        (FileReport(path=7, verdict="conforming"), "FileReport.path is not"),
        (FileReport("a.wav", "approved"), "FileReport.verdict is not"),
        (FileReport("a.wav", "conforming", findings=[FINDING]), "FileReport.findings is not"),
        (FileReport("a.wav", "conforming", findings=("over",)), "FileReport.findings is not"),
        (FileReport("a.wav", "conforming", findings=(FINDING,) * 60_000), "60,000 entries"),
        (FileReport("a.wav", "conforming", measurements=[1]), "FileReport.measurements is not"),
        (Finding("a:b", "found", "lower it", measured=math.nan), "Finding.measured is not"),
        (Finding("a:b", "found", "lower it", measured="loud"), "Finding.measured is not"),
        (Finding("a:b", "x" * (5 << 20), "lower it"), "5,242,880 characters"),
        pytest.param([[]] * 3_000_000, "more than 2,000,000 values", marks=pytest.mark.slow),
        (np.zeros(200_000), "an array of 200,000 numbers; 100,000 are allowed"),
    ],
)
def test_a_lie_is_refused(lie, why):
    with pytest.raises(SandboxCrashed, match="cannot be read") as refusal:
        answered(lie)
    assert why in str(refusal.value)


class Points(TypedDict):
    hz: list[float]
    name: str
    note: NotRequired[str | None]


def declares() -> dict[str, Points]: ...


def declares_rows() -> tuple[int | None, tuple[str, ...], list[tuple[int, list[str]]]]: ...


def declares_bytes() -> bytes: ...


def declares_array() -> NDArray[np.float64]: ...


POINTS = {"hz": [20.0, -math.inf, 7], "name": "a"}


@pytest.mark.parametrize(
    ("function", "lie", "why"),
    [
        (declares, [POINTS], "the answer is not dict"),
        (declares, {1: POINTS}, "a key of the answer is not"),
        (declares, {"a": [1]}, "a value of the answer is not"),
        (declares, {"a": {"hz": []}}, "a value of the answer lacks name"),
        (declares, {"a": POINTS | {"more": 1}}, "a value of the answer has no more"),
        (declares, {"a": POINTS | {"hz": [1.0, math.nan]}}, "an entry of a value of the answer.hz is not"),
        (declares, {"a": POINTS | {"hz": ["loud"]}}, "an entry of a value of the answer.hz is not"),
        (declares, {"a": POINTS | {"hz": [True]}}, "an entry of a value of the answer.hz is not"),
        (declares, {"a": POINTS | {"note": 7}}, "a value of the answer.note is not"),
        (declares_rows, (1, ("Name",)), "the answer has 2 values; 3 are wanted"),
        (declares_rows, (1, ("Name", 2), []), "an entry of the answer[1] is not"),
        (declares_rows, (1, ("Name",), [(1, [2])]), "an entry of an entry of the answer[2][1] is not"),
        (declares_bytes, "text", "the answer is not <class 'bytes'>"),
        (declares_array, [1.0], "the answer is not"),
        (check_file, "conforming", "the answer is not"),
        (check_file, FINDING, "the answer is not"),
    ],
)
def test_an_answer_that_the_function_does_not_declare_is_refused(function, lie, why):
    with pytest.raises(SandboxCrashed, match="cannot be read") as refusal:
        answered(lie, function=function)
    assert why in str(refusal.value)


def test_an_answer_that_the_function_declares_passes():
    assert answered({"a": POINTS, "b": POINTS | {"note": None}}, function=declares)["a"] == POINTS
    rows = (None, ("Name",), [(2, ["Door"])])
    assert answered(rows, function=declares_rows) == rows
    assert answered({"a": POINTS | {"hz": [np.float64(1.5)]}}, function=declares)["a"]["hz"] == [1.5]
    assert answered(b"bytes", function=declares_bytes) == b"bytes"
    assert answered(np.zeros(3), function=declares_array).size == 3


@pytest.mark.parametrize("lie", [("x" * (5 << 20), "R1", "a:b", "f"), ("x", "R1", "a:b", ["x"] * 3_000_000)])
def test_so_is_an_error_of_another_size(lie):
    with pytest.raises(SandboxCrashed, match="cannot be read"):
        answered(Unreadable(*lie), RAISED)


def test_an_honest_answer_passes(tmp_path):
    report = check_file(write_wav(tmp_path / "a.wav", sine(hz=997, dbfs=0)), all_figures=True)
    assert answered(report) == report
    assert answered(FINDING) == FINDING
    assert answered({"thumb": [1, 2], "bands": [None, 1.5]}) == {"thumb": [1, 2], "bands": [None, 1.5]}
