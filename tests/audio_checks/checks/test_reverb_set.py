"""`reverb-set`: what several sounds show together that none of them shows alone."""

import pytest

from audio_checks import check_files
from audio_checks.checks.reverb_set import REVERB_FROM, REVERB_FROM_OF_MANY, score_together
from audio_checks.report.findings import FileReport
from audio_checks.report.judged import JudgedFile
from audio_checks.run.sets import set_findings
from audio_checks.spec.delivery_spec import CueFacts, parse_spec
from tests.support.rooms import hits, in_a_room
from tests.support.waves import write_wav

DRY_WANTED = parse_spec('format = 1\n[engine]\nadds = ["reverb"]')


SIDES = (("wet", 0.93, 30), ("dry", 0.5, 10))


def judged(name, score, verdict="cannot tell", spec=DRY_WANTED, cue=None):
    judgements = {} if score is None else {"reverb": {"verdict": verdict, "score": score}}
    return JudgedFile(FileReport(name, "conforming", facts={"duration_s": 1.0}, judgements=judgements), spec, cue)


def codes(files):
    return [[finding.code for finding in findings] for findings in set_findings(files)]


def test_four_undecided_sounds_show_it_together():
    (first, *_) = found = set_findings([judged(f"step_{number}.wav", 0.88) for number in range(4)])
    assert [[finding.code for finding in findings] for findings in found] == [["reverb-set:heard"]] * 4
    assert first[0].severity == "warning"
    assert first[0].measured == pytest.approx(0.88)
    assert "these 4 sounds have reverb together (score 0.88 of 1)" in first[0].message


def test_of_eight_sounds_less_is_enough():
    for score, heard in ((REVERB_FROM_OF_MANY - 0.01, []), (REVERB_FROM_OF_MANY + 0.01, ["reverb-set:heard"])):
        assert codes([judged(f"{number}.wav", score) for number in range(8)]) == [heard] * 8
    assert codes([judged(f"{number}.wav", REVERB_FROM_OF_MANY + 0.01) for number in range(7)]) == [[]] * 7


def test_three_are_too_few_and_four_below_the_limit_no_reverb():
    assert codes([judged(f"{number}.wav", 0.9) for number in range(3)]) == [[]] * 3
    assert codes([judged(f"{number}.wav", REVERB_FROM - 0.01) for number in range(4)]) == [[]] * 4


def test_what_is_decided_alone_counts_and_is_not_named_again():
    others = [judged("a.wav", 0.99, "reverb"), judged("b.wav", 0.4, "dry"), judged("c.wav", 0.98, "reverb")]
    assert codes([*others, judged("d.wav", 0.97)]) == [[], [], [], ["reverb-set:heard"]]


def test_one_sound_does_not_outweigh_three():
    assert score_together([0.999999, 0.2, 0.2, 0.2]) < 0.5
    assert score_together([1.0, 0.0]) == pytest.approx(0.5)


def test_only_those_are_named_whose_own_score_agrees():
    """Six of twelve in a room: none of the dry ones is accused, and the message says how many."""
    company = [judged(f"{number}.wav", 0.9 if number < 6 else 0.1) for number in range(12)]
    found = set_findings(company)
    assert [bool(findings) for findings in found] == [True] * 6 + [False] * 6
    assert found[0][0].message.startswith("6 of these 12 sounds have reverb together")


def test_neighbours_do_not_convict():
    """Ten dry sounds in a folder with thirty wet ones."""
    wet, dry = ([judged(f"{name}_{number}.wav", score) for number in range(count)] for name, score, count in SIDES)
    found = codes([*wet, *dry])
    assert found == [["reverb-set:heard"]] * 30 + [[]] * 10


def test_a_few_high_scores_among_many_are_chance():
    assert codes([judged(f"{number}.wav", 0.92 if number < 3 else 0.3) for number in range(12)]) == [[]] * 12


def test_categories_of_a_folder_are_apart():
    spec = {name: DRY_WANTED.for_category(name) for name in ("impact", "ui")}
    hits = [judged(f"hit_{number}.wav", 0.92, spec=spec["impact"]) for number in range(4)]
    clicks = [judged(f"click_{number}.wav", 0.92, spec=spec["ui"]) for number in range(2)]
    assert codes([*hits, *clicks]) == [["reverb-set:heard"]] * 4 + [[]] * 2


def test_folders_are_apart():
    assert codes([judged(f"{folder}/{number}.wav", 0.9) for folder in "ab" for number in range(3)]) == [[]] * 6


def test_only_where_the_spec_wants_dry_sounds_and_the_list_no_tail():
    plain, off = (
        parse_spec("format = 1"),
        parse_spec('format = 1\n[engine]\nadds = ["reverb"]\n[checks]\nreverb-set = "off"'),
    )
    for spec in (plain, off):
        assert codes([judged(f"{number}.wav", 0.9, spec=spec) for number in range(5)]) == [[]] * 5
    tail = CueFacts("SW-001", name="bell", reverb="designed-tail")
    assert codes([judged(f"{number}.wav", 0.9, cue=tail) for number in range(5)]) == [[]] * 5
    assert codes([judged(f"{number}.wav", None) for number in range(5)]) == [[]] * 5


@pytest.mark.slow
def test_dry_hits_and_the_same_in_a_room(tmp_path):
    for folder, made in (("dry", lambda sound: sound), ("wet", in_a_room)):
        (tmp_path / folder).mkdir()
        for number in range(5):
            write_wav(tmp_path / folder / f"hit_{number}.wav", made(hits(channels=1)) * 0.9**number)
    found = {entry.path: entry for entry in check_files([tmp_path], DRY_WANTED).files}
    for path, entry in found.items():
        heard = {finding.code for finding in entry.findings} & {"reverb-set:heard", "baked-reverb:heard"}
        assert bool(heard) == ("wet" in path), path
