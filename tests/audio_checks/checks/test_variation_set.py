"""`variation-set`: level, length and likeness within one set."""

import itertools

import numpy as np
import pytest

from audio_checks import check_files, read_sound_list
from audio_checks.audio.audio_file import AudioFile
from audio_checks.checks.variation_set import LEAST_UNLIKE_DB, VARIED
from audio_checks.measure.likeness import unlikeness_db
from audio_checks.spec.delivery_spec import parse_spec
from tests.support.waves import noise, silence, sine, write_wav

SPEC = parse_spec("format = 1\naccept.channels = 'any'")


def steps(tmp_path, levels_db, *, seconds=0.5, lengths=None, wanted=None, channels=1):
    """Write a set of noises, and return what is found in each file, its other findings left out."""
    lengths = lengths or [seconds] * len(levels_db)
    paths = [
        write_wav(
            tmp_path / f"step_{place:02}.wav", noise(seconds=length, seed=place, dbfs=level - 20, channels=channels)
        )
        for place, (level, length) in enumerate(zip(levels_db, lengths, strict=True), start=1)
    ]
    return found_in(paths, wanted or len(paths))


def found_in(paths, wanted, spec=SPEC):
    sounds = read_sound_list(f"number,file_name,variations\nSW-1,step,{wanted}\n")
    return [
        [finding for finding in entry.findings if finding.check == "variation-set"]
        for entry in check_files(paths, spec, sound_list=sounds).files
    ]


def codes(found):
    return [[finding.code.partition(":")[2] for finding in findings] for findings in found]


@pytest.mark.parametrize("channels", [1, 2])
@pytest.mark.parametrize(
    ("levels_db", "named"),
    [
        ([0, 0, 4, 0], [3]),
        ([0, 0, -4, 0], [3]),
        ([0, 0, 1.8, 0], []),
        ([0, 0, 2.3, 0], [3]),
        ([0, 0.9, 1.5, 2.6], [4]),  # none is 2 LU from the middle of the others, but the set spreads over 2.6
        ([0, 4], [1, 2]),
    ],
)
def test_levels(tmp_path, levels_db, named, channels):
    found = codes(steps(tmp_path, levels_db, channels=channels))
    assert [place for place, one in enumerate(found, start=1) if one == ["level"]] == named


def footsteps(tmp_path, levels_db, tables):
    spec = parse_spec(f"format = 1\naccept.channels = 'any'\n[files]\n'*' = 'footsteps'\n{tables}")
    steps(tmp_path, levels_db)
    return codes(found_in(sorted(tmp_path.glob("*.wav")), len(levels_db), spec))


@pytest.mark.parametrize(
    ("category", "varies"),
    [("footsteps", True), ("metal hits", True), ("gunshots", True), ("white_noise", False), ("one-shot", False)],
)
def test_some_categories_vary_on_purpose(category, varies):
    assert (VARIED.search(category) is not None) == varies


@pytest.mark.parametrize(
    ("off_db", "tables", "named"),
    [
        (3.8, "", False),
        (4.3, "", True),
        (3.8, "[categories.footsteps]\nlimits.variation_level_lu = 3", True),
        (4.8, "[categories.footsteps]\nlimits.variation_level_lu = 5", False),
    ],
)
def test_footsteps_may_vary_more(tmp_path, off_db, tables, named):
    assert footsteps(tmp_path, [0, 0, off_db, 0], tables)[2] == (["level"] if named else [])


def test_a_set_that_spreads_on_purpose_is_level(tmp_path):
    assert codes(steps(tmp_path, [0, 1, 2, 3, 4, 5])) == [[]] * 6  # 1.5 LU from the middle in the middle: up to 5.25
    assert codes(steps(tmp_path, [0, 1, 2, 3, 4, 15]))[5] == ["level"]


def test_the_distance_to_the_middle_of_the_others_is_reported(tmp_path):
    found = steps(tmp_path, [0, 0, 4, 0])[2][0]
    assert found.measured == pytest.approx(4, abs=0.1)
    assert found.message == "_03 is 4.0 LU louder than the rest of its set, limit 2 LU"
    assert found.fix.startswith("lower its level by 4.0 dB, to -")
    under = steps(tmp_path, [0, 0, -3, 0])[2][0]
    assert under.message == "_03 is 3.0 LU quieter than the rest of its set, limit 2 LU"


def test_sounds_under_400_ms_have_a_loudness_too(tmp_path):
    assert codes(steps(tmp_path, [0, 0, 4], seconds=0.2))[2] == ["level"]
    mixed = steps(tmp_path, [0, 0, 4], lengths=[0.39, 0.41, 0.4])
    assert mixed[2][0].measured == pytest.approx(4, abs=0.3)


@pytest.mark.parametrize(("seconds", "named"), [(0.62, False), (0.63, True), (0.38, False), (0.37, True)])
def test_lengths(tmp_path, seconds, named):
    found = steps(tmp_path, [0, 0, 0], lengths=[0.5, 0.5, seconds])
    assert codes(found)[2] == (["length"] if named else [])
    if named:
        assert (found[2][0].measured, found[2][0].limit) == (pytest.approx(seconds, abs=1e-3), pytest.approx(0.5))


def test_two_that_are_alike(tmp_path):
    steps(tmp_path, [0, 0, 0])
    copied = noise(seconds=0.5, seed=1, dbfs=-20.5)
    write_wav(tmp_path / "step_03.wav", copied)
    found = found_in(sorted(tmp_path.glob("*.wav")), 3)
    assert codes(found) == [[], [], ["alike"]]
    assert found[2][0].message.startswith("_03 is nearly identical to _01, 0.")


def test_an_exact_copy_is_for_the_duplicate_check(tmp_path):
    paths = [write_wav(tmp_path / f"step_{place:02}.wav", noise(seconds=0.5)) for place in (1, 2)]
    assert codes(found_in(paths, 2)) == [[], []]


def test_nothing_is_said_before_the_set_is_whole(tmp_path):
    assert codes(steps(tmp_path, [0, 0, 9], wanted=4)) == [[], [], []]


def test_an_alternate_is_held_against_the_set_and_moves_nothing(tmp_path):
    paths = [write_wav(tmp_path / f"step_{place:02}.wav", noise(seconds=0.5, seed=place)) for place in (1, 2, 3)]
    paths.append(write_wav(tmp_path / "step_02__alt2.wav", noise(seconds=0.5, seed=7, dbfs=-10)))
    assert codes(found_in(paths, 3)) == [[], [], [], ["level"]]


@pytest.mark.parametrize("samples", [silence(seconds=0.5), np.array([[0.5]]), sine(hz=997, seconds=0.5)])
def test_silence_and_one_frame_break_nothing(tmp_path, samples):
    paths = [write_wav(tmp_path / f"step_{place:02}.wav", samples * (place / 3)) for place in (1, 2, 3)]
    assert len(found_in(paths, 3)) == 3


def test_a_file_that_cannot_be_read_leaves_the_set_unfinished(tmp_path):
    paths = [write_wav(tmp_path / f"step_{place:02}.wav", noise(seconds=0.5, dbfs=-9.0 * place)) for place in (1, 2)]
    (tmp_path / "step_03.wav").write_bytes(b"RIFF")
    assert codes(found_in([*paths, tmp_path / "step_03.wav"], 3)) == [[], [], []]


def test_single_cues_and_files_without_a_cue_are_no_set(tmp_path):
    paths = [write_wav(tmp_path / f"step_{place:02}.wav", noise(seconds=0.5, dbfs=-9.0 * place)) for place in (1, 2)]
    assert codes(found_in(paths, 1)) == [[], []]
    found = [finding.check for entry in check_files(paths, SPEC).files for finding in entry.findings]
    assert "variation-set" not in found


def test_no_two_real_recordings_are_alike(recordings):
    prints = []
    for path in recordings:
        with AudioFile(path) as file:
            file.prepare(["likeness_print"])
            prints.append(file.measurements.likeness_print)
    apart = [unlikeness_db(one, other) for one, other in itertools.combinations(filter(None, prints), 2)]
    assert min(one for one in apart if one is not None) > 2.5 * LEAST_UNLIKE_DB
