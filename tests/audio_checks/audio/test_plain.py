"""Answers as bytes: honest ones come back as they were, and no bytes run code, import modules or fill the memory."""

import json
import math
import resource
import sys
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from audio_checks import FileReport, Finding, SandboxCrashed, Unreadable, check_file
from audio_checks.audio.sandbox.answers import ensure_declared, ensure_expected
from audio_checks.audio.sandbox.messages import RAISED, RETURNED, resolved
from audio_checks.audio.sandbox.plain import LENGTH, NotPlain, decode, encode
from audio_checks.render.provenance import Provenance
from tests.support.waves import sine, write_wav

FINDING = Finding("true-peak:over", "found", "lower it", measured=-math.inf)
LEAVES = st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text() | st.binary()
VALUES = st.recursive(
    LEAVES,
    lambda inside: (
        st.lists(inside, max_size=5)
        | st.lists(inside, max_size=5).map(tuple)
        | st.dictionaries(st.text() | st.integers(), inside, max_size=5)
        | st.frozensets(LEAVES, max_size=5)
    ),
    max_leaves=20,
)


def lie(said, blobs=b""):
    """Return the bytes of an answer that no `encode` writes."""
    text = said if isinstance(said, bytes) else json.dumps(said).encode()
    return LENGTH.pack(len(text)) + text + blobs


@pytest.mark.slow
@given(VALUES)
def test_plain_values_come_back_as_they_were(value):
    found = decode(encode(value))
    assert found == value
    assert type(found) is type(value)


@pytest.mark.parametrize(
    "value",
    [
        np.arange(6.0).reshape(2, 3),
        np.zeros(0, np.float32),
        np.array(7, np.int16),
        np.array([[1 + 2j]]),
        np.array([True, False]),
    ],
)
def test_arrays_come_back_as_they_were(value):
    found = decode(encode({"before": b"x", "array": value, "after": b"y"}))
    assert (found["before"], found["after"]) == (b"x", b"y")
    assert found["array"].dtype == value.dtype
    assert found["array"].shape == value.shape
    assert np.array_equal(found["array"], value)
    found["array"].fill(0)  # its own memory


def test_data_classes_paths_and_errors_come_back(tmp_path):
    report = check_file(write_wav(tmp_path / "a.wav", sine(hz=997, dbfs=0)), all_figures=True)
    assert decode(encode([report, FINDING, tmp_path])) == [report, FINDING, tmp_path]
    error = decode(encode(Unreadable("broken", "R1", "structure:x", "save it again")))
    assert (type(error), error.args, error.code) == (
        Unreadable,
        ("broken", "R1", "structure:x", "save it again"),
        "structure:x",
    )
    assert decode(encode(np.float64(1.5))) == 1.5


@pytest.mark.parametrize("value", [object(), len, print, np.array([{}], dtype=object), 1 + 2j, sys])
def test_nothing_else_is_written(value):
    with pytest.raises(NotPlain):
        encode(value)


def nested(depth):
    value = ["list"]
    for _ in range(depth):
        value = ["list", value]
    return value


NO_FIELDS = ["dict", ["list"], ["list"]]
SANDBOX = "audio_checks.audio.sandbox.calls"
HOSTILE = {
    "a module that runs a program when it is imported": lie(["enum", "audio_checks.cli.__main__", "x", "y"]),
    "a class of another package": lie(["data", "subprocess", "Popen", NO_FIELDS]),
    "an error of another package": lie(["error", "builtins", "SystemExit", ["list", ["tuple"], NO_FIELDS]]),
    "a class that is not a data class": lie(["data", SANDBOX, "Sandbox", NO_FIELDS]),
    "a function": lie(["data", "audio_checks.run", "check_file", NO_FIELDS]),
    "a module that is not loaded": lie(["data", "audio_checks.nowhere", "X", NO_FIELDS]),
    "more fields than a class has": lie(["data", Finding.__module__, "Finding", *["x"] * 100]),
    "too few fields": lie(["data", Finding.__module__, "Finding", "a:b"]),
    "a member that there is not": lie(["enum", "audio_checks.wav", "X", "y"]),
    "an array of objects": lie(["array", "|O", [1], 8], bytes(8)),
    "an array larger than its bytes": lie(["array", "<f8", [1 << 40], 8], bytes(8)),
    "an array of a negative shape": lie(["array", "<f8", [-1], 8], bytes(8)),
    "an array of records": lie(["array", "f8,O", [1], 16], bytes(16)),
    "bytes that are not there": lie(["bytes", 1 << 60], b"x"),
    "bytes before the first": lie(["bytes", -5], b"x"),
    "a kind that there is not": lie(["module", "os"]),
    "a list of no kind": lie([]),
    "a mapping of no kind": lie({"a": 1}),
    "more keys than values": lie(["dict", ["list", "a"], ["list"]]),
    "a key that cannot be one": lie(["dict", ["list", ["list"]], ["list", 1]]),
    "a hundred lists in one another": lie(nested(100)),
    "a million brackets": lie(b"[" * 1_000_000),
    "a number of 10,000 digits": lie(b"9" * 10_000),
    "no JSON": lie(b"nonsense"),
    "JSON in another code": lie('["list"]'.encode("utf-16")),
    "nothing": b"",
    "a length beyond the end": LENGTH.pack(1 << 60) + b"[]",
}  # fmt: skip


@pytest.mark.parametrize("content", HOSTILE.values(), ids=HOSTILE)
@pytest.mark.parametrize("kind", [RETURNED, RAISED])
def test_a_hostile_answer_is_the_childs_failure(content, kind):
    with pytest.raises(SandboxCrashed):
        resolved((kind, content), len)
    assert "audio_checks.cli.__main__" not in sys.modules


def test_reading_an_answer_calls_nothing_of_its_classes(monkeypatch):
    monkeypatch.setattr(Provenance, "__post_init__", lambda _self: pytest.fail("it was called"))
    monkeypatch.setattr(Finding, "__init__", lambda _self: pytest.fail("it was called"))
    values = [None] * len(Provenance.__dataclass_fields__)
    assert isinstance(decode(lie(["data", Provenance.__module__, "Provenance", *values])), Provenance)
    assert decode(encode(FINDING)) == FINDING


@pytest.mark.slow
@pytest.mark.parametrize("one", [b'["list"],', b"{},", b'"",'])
def test_64_mib_of_small_values_are_refused_before_they_are_made(one):
    content = lie(b"[" + one * ((64 << 20) // len(one)) + b"0]")
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with pytest.raises(SandboxCrashed, match="more than 2,000,000 values"):
        resolved((RETURNED, content), len)
    grown_kib = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    assert grown_kib < 300 << 10  # the answer itself twice; as values it takes 1 to 4 GiB


@pytest.mark.slow
@pytest.mark.parametrize("text", [b'"' + b'\\\\"' * (4 << 20), b'"\\\\' * (4 << 20), b'"' * (8 << 20)])
def test_texts_that_never_end_are_read_once(text):
    # Where each quote looks for its end, this takes days.
    with pytest.raises(SandboxCrashed):
        resolved((RETURNED, lie(text)), len)


@pytest.mark.slow
def test_commas_and_brackets_in_a_text_are_no_values():
    text = '[,"\\' * 1_000_000
    assert decode(encode([text])) == [text]


def test_a_reports_answer_is_what_its_function_declares(tmp_path):
    report = decode(encode(check_file(write_wav(tmp_path / "a.wav", sine(hz=997, dbfs=0)))))
    ensure_expected(report)
    ensure_declared(report, check_file)
    assert isinstance(report, FileReport)
    assert isinstance(decode(encode(Path("a"))), Path)
