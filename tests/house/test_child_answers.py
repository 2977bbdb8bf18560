"""What each function that runs in a throw-away child declares, and what happens to an answer that lies."""

import typing
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from structlog.testing import capture_logs

from app import registry
from app.accounts.pictures.drawing import draw_square
from app.agreements.clauses.template_files import parse_toml
from app.conformance import fixing
from app.core import typesetting
from app.core.errors import Invalid
from app.core.parsing import Parsers
from app.references.drawing import draw_previews
from app.renders import drawing
from app.renders.reels import sound as reel_sound
from app.renders.timbre import rules as timbre
from app.scenes import listening
from app.sound_lists.sheets.rules import parse_bytes, parse_text
from app.sound_lists.spoken_placeholders.rules import read_said
from audio_checks import (
    FileReport,
    FixedMaster,
    SandboxCrashed,
    check_file,
    compare_reverb_of_takes,
    ensure_declared,
    export_master,
    fingerprint_files,
    parse_spec,
    sound_signature,
)
from audio_checks.audio.flac import unpack
from audio_checks.audio.sandbox import returned_type
from audio_checks.audit.fingerprinted import decode

DOORS: tuple[Callable[..., Any], ...] = (
    check_file, decode, draw_square, drawing.draw, drawing.prepare, export_master, fingerprint_files, fixing.fix,
    sound_signature, parse_bytes, parse_spec, parse_text, parse_toml, reel_sound.make_reel, compare_reverb_of_takes,
    timbre.measure, draw_previews, typesetting.compile_pdf, unpack, listening.compare, listening.measure_preview,
    listening.prepare_part, read_said,
)  # fmt: skip
PLAIN = {int, float, str, bytes, bool, type(None), None}
UNDECLARED: tuple[Any, ...] = (Any, object, dict, list, tuple, set)
REPORT = FileReport("a.wav", "conforming")
DRAWN = {
    "duration_s": 1.0,
    "facts": {
        "container": "wav", "encoding": "pcm", "sample_rate_hz": 48_000, "bit_depth": 24, "channels": 1, "frames": 9,
    },
    "thumb": {"points": 1, "min": [-1], "max": [1], "rms": [0]},
    "plays_itself": False,
    "preview_of": "",
    "has_light": False,
}  # fmt: skip
FIXED = FixedMaster(None, "a.wav", (), (), REPORT, None)


def inside(wanted: Any) -> Iterator[Any]:
    """Yield the types of which a declared type is made, down to those of its TypedDicts."""
    arguments = [one for one in typing.get_args(wanted) if one is not Ellipsis]
    if hasattr(wanted, "__required_keys__"):
        arguments = list(typing.get_type_hints(wanted).values())
    if not arguments:
        yield wanted
    for argument in arguments:
        yield from inside(argument)


@pytest.mark.parametrize("function", DOORS, ids=lambda function: function.__qualname__)
def test_every_function_of_a_child_declares_its_answer(function: Callable[..., Any]):
    for wanted in inside(returned_type(function)):
        assert wanted in PLAIN or (isinstance(wanted, type) and wanted not in UNDECLARED)


@pytest.mark.parametrize(
    ("function", "lie"),
    [
        (check_file, {"verdict": "conforming"}),
        (decode, ("pcm", "48000")),
        (drawing.draw, DRAWN | {"duration_s": "long"}),
        (drawing.draw, {key: value for key, value in DRAWN.items() if key != "thumb"}),
        (drawing.draw, DRAWN | {"thumb": DRAWN["thumb"] | {"rms": [None]}}),
        (drawing.draw, DRAWN | {"script": "<b>"}),
        (drawing.prepare, {"pc": {"rendered": {"sha256": "0"}, "drawing": DRAWN}}),
        (draw_previews, {"width": 1, "height": 1, "problem": ["<b>"]}),
        (drawing.prepare, {"pc": "made"}),
        (export_master, "out.wav"),
        (fingerprint_files, ["heard"]),
        (fixing.fix, FIXED),
        (fixing.fix, (FIXED, ({"kind": "gain"},))),
        (parse_bytes, (1, ["Name"], [])),
        (parse_spec, {"name": "x"}),
        (parse_text, (1, ("Name",), [(2, [b"Door"])])),
        (parse_toml, ("name", "single", [{"key": "a"}], {})),
        (parse_toml, ("name", "single", [], {"rounds": [1]})),
        (reel_sound.make_reel, {"duration_s": 1.0, "starts_s": ["0"]}),
        (compare_reverb_of_takes, {"rt60_s": 1.0}),
        (timbre.measure, {"timbre": [1.0]}),
        (typesetting.compile_pdf, "%PDF-"),
        (unpack, "out.wav"),
        (listening.measure_preview, {"duration_s": 1.0}),
        (listening.compare, {"lag_s": 0.0}),
    ],
)
def test_an_undeclared_answer_of_a_child_is_refused(function: Callable[..., Any], lie: object):
    with pytest.raises(SandboxCrashed, match="answer"):
        ensure_declared(lie, function)


def test_honest_answers_pass():
    ensure_declared(DRAWN, drawing.draw)
    ensure_declared({"pc": SandboxCrashed("no"), "": DRAWN}, drawing.prepare)
    ensure_declared((FIXED, ()), fixing.fix)
    ensure_declared(("name", "single", [{"key": "a", "title": "A", "text": "", "stands": True}], {"a": 1}), parse_toml)


def lie_to_parsers(text: str) -> list[int]:
    """Declare numbers and return text, as a child whose parser was taken over might."""
    return [text]  # type: ignore[list-item]


class Unreadable(Invalid):
    """Of these tests."""


@pytest.mark.slow
def test_a_parser_that_lies_is_refused_and_recorded_as_the_childs_fault():
    parsers = Parsers()
    parsers.connect((*registry.PARSERS, __name__))
    try:
        with capture_logs() as lines, pytest.raises(Unreadable, match="this is damaged"):
            parsers.call(lie_to_parsers, "text", refusal=Unreadable)
    finally:
        parsers.close()
    (line,) = lines
    assert (line["event"], line["function"]) == ("a parser failed", "lie_to_parsers")
    assert "an entry of the answer is not <class 'int'>" in line["error"]
