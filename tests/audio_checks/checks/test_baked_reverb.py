"""`baked-reverb`: a finding only where the spec asks, the verdict is positive, and the list wants no tail."""

import numpy as np
import pytest

from audio_checks import check_file, parse_spec
from audio_checks.audio import figures
from audio_checks.judge import Judgement
from audio_checks.spec.delivery_spec import CueFacts, new_spec
from tests.support.rooms import hits, in_a_room
from tests.support.waves import silence, sine, write_wav

ADDS = "engine.adds = ['reverb']"
HEARD, LIKELY = ["baked-reverb:heard"], ["baked-reverb:likely"]
DRY, WET = hits(channels=2), in_a_room(hits(channels=2))


@pytest.mark.parametrize(
    ("samples", "codes"),
    [(WET, HEARD), (WET[:, :1], LIKELY), (DRY, []), (silence(), []), (silence(seconds=1 / 48_000) + 0.5, [])],
    ids=["stereo", "mono", "dry", "silence", "one frame"],
)
def test_only_what_is_heard(codes_of, samples, codes):
    assert codes_of("baked-reverb", samples, ADDS) == codes


@pytest.mark.parametrize(
    ("tables", "codes"),
    [
        ("", []),
        ("engine.adds = ['doppler']", []),
        (ADDS, HEARD),
        ("checks.baked-reverb = 'warning'", HEARD),
    ],
)
def test_only_where_the_spec_asks(codes_of, tables, codes):
    assert codes_of("baked-reverb", WET, tables) == codes


@pytest.mark.parametrize(
    ("word", "codes"), [(None, HEARD), ("dry", HEARD), ("separate-tail", HEARD), ("designed-tail", [])]
)
def test_the_list_is_respected(codes_of, word, codes):
    assert codes_of("baked-reverb", WET, ADDS, cue=CueFacts("SW-001", reverb=word)) == codes


def test_a_cue_that_is_to_be_dry_is_judged_in_any_project(codes_of):
    assert codes_of("baked-reverb", WET, "", cue=CueFacts("SW-001", reverb="dry")) == HEARD
    assert codes_of("baked-reverb", WET, "", cue=CueFacts("SW-001", reverb="separate-tail")) == []


def test_what_is_likely_is_information_that_no_spec_raises(tmp_path, monkeypatch):
    likely = Judgement("likely reverb", 0.87, {"rt60_s": 1.2})
    monkeypatch.setattr("audio_checks.judge.reverb.judge_decay", lambda *_: likely)
    path = write_wav(tmp_path / "hit.wav", WET)
    for level in ("warning", "error"):
        entry = check_file(path, parse_spec(f"format = 1\n{ADDS}\nchecks.baked-reverb = '{level}'"))
        (finding,) = entry.findings
        assert (finding.code, finding.severity, entry.verdict) == ("baked-reverb:likely", "information", "conforming")
        assert finding.message == "sounds as if it has a room, RT60 about 1.2 s, score 0.87 of 1: listen"
    assert check_file(path, parse_spec(f"format = 1\n{ADDS}\nchecks.baked-reverb = 'off'")).findings == ()


@pytest.mark.parametrize("preset", ["44k1", "48k"])
def test_a_new_project_judges_reverb(preset):
    assert parse_spec(new_spec(preset)).asks_for_dry_sound(None)


def test_what_it_says(found_by):
    (finding,) = found_by("baked-reverb", WET, ADDS, cue=CueFacts("SW-001", reverb="separate-tail"))
    assert finding.measured == pytest.approx(1.5, rel=0.3)
    assert finding.unit == "s"
    assert "the game adds its own" in finding.message
    assert "layer of its own" in finding.fix


class TestInTheReport:
    def judged(self, tmp_path, samples, tables, **options):
        path = write_wav(tmp_path / "hit.wav", samples)
        return check_file(path, parse_spec(f"format = 1\n{tables}"), **options)

    def test_it_warns_and_the_judgement_is_there(self, tmp_path):
        entry = self.judged(tmp_path, WET, ADDS)
        assert (entry.verdict, [finding.severity for finding in entry.findings]) == ("conforming", ["warning"])
        assert entry.judgements["reverb"]["verdict"] == "reverb"

    def test_it_rejects_where_the_spec_says_so(self, tmp_path):
        tables = f"{ADDS}\nchecks.baked-reverb = 'error'"
        assert self.judged(tmp_path, WET, tables).verdict == "rejected"
        assert self.judged(tmp_path, DRY, tables).verdict == "conforming"

    def test_turned_off(self, tmp_path):
        entry = self.judged(tmp_path, WET, f"{ADDS}\nchecks.baked-reverb = 'off'")
        assert (entry.findings, entry.judgements) == ((), {})

    def test_who_does_not_ask_does_not_pay(self, tmp_path, monkeypatch):
        monkeypatch.setitem(figures.MAKERS, "decay", lambda *_: pytest.fail("the tail was measured"))
        entry = self.judged(tmp_path, WET, "limits.true_peak_dbtp = 0.0")
        assert entry.judgements == {}

    def test_a_judgement_that_breaks_is_the_tools_fault(self, tmp_path, monkeypatch):
        monkeypatch.setattr("audio_checks.judge.reverb.features_of", lambda _: 1 / 0)
        entry = self.judged(tmp_path, sine(hz=997), ADDS)
        assert entry.verdict == "unjudged"
        assert [finding.code for finding in entry.findings] == ["baked-reverb:crashed"]
        assert [one.check for one in entry.unjudged] == ["baked-reverb"]


def test_channels_in_opposite_phase(codes_of):
    opposite = np.concatenate((WET[:, :1], -WET[:, :1]), axis=1)
    assert codes_of("baked-reverb", opposite, ADDS) in ([], HEARD)
