"""All of it together: names, order, damage, bounds."""

import numpy as np
import pytest

from audio_checks.metadata import SHOWN_CHARACTERS, SHOWN_FIELDS, CuePoint, Instrument, read_metadata
from tests.support import chunks
from tests.support.mutants import damaged
from tests.support.waves import smpl


def payloads(*wholes):
    return [(whole[:4].decode(), whole[8:]) for whole in wholes]


ALL = (
    chunks.bext(originator="Mara Lind"),
    chunks.ixml("<PROJECT>Shield Wing</PROJECT><ASWG><catId>GUNAuto</catId></ASWG>"),
    chunks.labels({1: "hit"}),
    chunks.info(ICMT="layered"),
    chunks.cue({1: 480}),
    smpl([(10, 99)]),
    chunks.inst(gain=-3),
)


def test_every_kind_by_its_name():
    found = read_metadata(payloads(*ALL))
    assert (
        found.fields.items()
        >= {
            "bext.Originator": "Mara Lind",
            "iXML.PROJECT": "Shield Wing",
            "iXML.ASWG.catId": "GUNAuto",
            "INFO.ICMT": "layered",
        }.items()
    )
    assert found.cue_points == (CuePoint(1, 480, "hit"),)
    assert found.instrument == Instrument(60, 0.0, -3, (0, 127), (1, 127))
    assert found.damaged == ()
    assert found.to_dict()["cue_points"] == [{"frame": 480, "label": "hit"}]


def test_nothing():
    found = read_metadata([])
    assert (found.fields, found.cue_points, found.instrument, found.to_dict()) == ({}, (), None, {})


def test_damage_is_said_once_and_hides_nothing_else():
    broken = payloads(chunks.info(ICMT="kept"))
    found = read_metadata([("bext", b"short"), ("LIST", b"INFO" + b"ICMT\xff\0\0\0"), *broken, ("iXML", b"<x")])
    assert found.fields == {"INFO.ICMT": "kept"}
    assert len(found.damaged) == 3
    assert all(sentence.isprintable() for sentence in found.damaged)


def test_what_a_report_shows_is_bounded():
    many = "".join(f"<N{number}>{'x' * 1_000}</N{number}>" for number in range(250))
    shown = read_metadata(payloads(chunks.ixml(many))).to_dict()["fields"]
    assert len(shown) == SHOWN_FIELDS
    assert max(map(len, shown.values())) == SHOWN_CHARACTERS


@pytest.mark.slow
def test_thousands_of_mutants_are_read_or_named_as_damaged():
    rng = np.random.default_rng(20261121)
    outcomes = {"whole": 0, "damaged": 0}
    for _ in range(20_000):
        name, payload = payloads(ALL[rng.integers(len(ALL))])[0]
        found = read_metadata([(name, damaged(rng, payload))])
        assert all(isinstance(text, str) for text in found.fields.values())
        assert all(sentence.isprintable() for sentence in found.damaged)
        outcomes["damaged" if found.damaged else "whole"] += 1
    assert min(outcomes.values()) > 2_000
