"""A list that contradicts its spec: said on the list's side, and no fault of whoever delivers."""

import numpy as np
import pytest

from audio_checks import CueFacts, check_file, check_name, new_spec, parse_spec, pattern_admitting, refused_name
from tests.support.waves import write_wav

SPEC = parse_spec(new_spec())
PATTERN = "[a-z0-9]+(_[a-z0-9]+)*"
CLICK = CueFacts("SW-001", "Button click", "UI_Button_Click", "ui")


@pytest.mark.parametrize(
    ("name", "file_name", "variations", "proposed"),
    [
        ("Button click", "UI_Button_Click", 1, "ui_button_click"),
        ("Step", "Step", 3, "step"),
        ("Émile 1", "fr_émile_001", 1, "fr_emile_001"),
        ("Hit", "hit-a", 1, "hit_a"),
    ],
)
def test_a_refused_name_comes_with_one_that_the_spec_accepts(name, file_name, variations, proposed):
    refusal = refused_name(name, file_name, variations, SPEC)
    assert (refusal.rule, refusal.proposed) == ("pattern", proposed)
    assert refused_name(name, proposed, variations, SPEC) is None


def test_an_accepted_name_is_no_contradiction():
    assert refused_name("Button click", "", 2, SPEC) is None


@pytest.mark.parametrize(
    ("names", "refuses"),
    [
        (["UI_Button_Click", "door"], ["UI Button", "a__b"]),
        (["hit-a", "hit_b"], ["HIT", "hit a"]),
        (["fr_émile_001"], ["fr_Émile"]),
    ],
)
def test_a_pattern_admits_all_names_and_not_everything(names, refuses):
    proposed = pattern_admitting(PATTERN, names)
    spec = parse_spec(new_spec().replace(PATTERN, proposed))
    assert [refused_name("", name, 1, spec) for name in [*names, "still_ok_01"]] == [None] * (len(names) + 1)
    assert all(check_name(f"{name}.wav", spec) for name in refuses)


def test_no_pattern_is_offered_for_names_with_spaces():
    assert pattern_admitting(PATTERN, ["UI Button"]) is None


def test_a_file_under_the_lists_own_name_is_not_advised_away(tmp_path):
    path = tmp_path / "UI_Button_Click.wav"
    write_wav(path, 0.1 * np.ones(4_800))
    listed = check_file(path, SPEC, cue=CLICK)
    assert [(finding.code, finding.severity) for finding in listed.findings if finding.check == "naming"] == [
        ("naming:listed", "warning")
    ]
    other = check_file(path, SPEC, cue=CueFacts("SW-002", "Other", "other"))
    assert [finding.code for finding in other.findings if finding.check == "naming"] == ["naming:pattern"]
    strict = parse_spec(new_spec().replace("[checks]", '[checks]\nnaming = "error"'))
    assert [one.severity for one in check_name(path.name, strict, CLICK)] == ["warning"]
