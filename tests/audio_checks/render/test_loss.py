"""What a render cost, in figures that theory gives."""

import json

import numpy as np
import pytest

from audio_checks import wav
from audio_checks.render.render import render_master
from audio_checks.spec.delivery_spec import Target
from tests.support.waves import join, noise, silence, sine, swelling, write_wav

OLD = Target("old", 22_050, 16)


def samples_of(path):
    with wav.open_regular(path) as file:
        return np.concatenate(list(wav.blocks(file, wav.read_layout(file))))


def rendered(tmp_path, samples, target=OLD, rate=48_000, **more):
    master = write_wav(tmp_path / "a.wav", samples, rate=rate, **more)
    return render_master(master, target, tmp_path / "game.wav")


def level_db(samples, hz, rate):
    turns = np.exp(-2j * np.pi * hz * np.arange(len(samples)) / rate)
    return 20 * np.log10(2 * abs(np.mean(samples * turns)))


class TestHighs:
    def test_energy_above_the_new_nyquist_frequency(self, tmp_path):
        # Two tones: what is lost is a tenth of the power of what stays, so a eleventh of all.
        sound = sine(hz=1_000, dbfs=-10) + sine(hz=15_000, dbfs=-20)
        made = rendered(tmp_path, sound)
        assert made.loss.above_nyquist_db == pytest.approx(-10 * np.log10(11), abs=0.01)

    def test_nothing_is_lost_where_the_rate_stays_and_none_of_silence(self, tmp_path):
        assert rendered(tmp_path, noise(), Target("film", 48_000, 16)).loss.above_nyquist_db == -np.inf
        assert rendered(tmp_path, silence()).loss.above_nyquist_db == -np.inf

    def test_spectra_lie_over_each_other(self, tmp_path):
        spectra = rendered(tmp_path, noise(dbfs=-20, seconds=4, rate=96_000), rate=96_000).loss.spectra
        assert len(spectra.hz) == len(spectra.master_dbfs) == len(spectra.render_dbfs)
        kept = [(a, b) for hz, a, b in zip(*vars(spectra).values(), strict=True) if 100 < hz < 9_000]
        assert len(kept) > 30
        assert max(abs(master - render) for master, render in kept) < 1.0
        lost = [b for hz, b in zip(spectra.hz, spectra.render_dbfs, strict=True) if hz > 13_000]
        assert lost == [-np.inf] * len(lost)
        assert len(lost) > 5


class TestLevels:
    def test_before_and_after(self, tmp_path):
        loss = rendered(tmp_path, sine(hz=997, dbfs=-12, seconds=2)).loss
        for figures in (loss.before, loss.after):
            assert figures["sample_peak_dbfs"] == pytest.approx(-12, abs=0.05)
            assert figures["true_peak_dbtp"] == pytest.approx(-12, abs=0.05)
            assert figures["integrated_lufs"] == pytest.approx(-15.01 + 0.0, abs=0.1)

    @pytest.mark.parametrize(("bits", "dbfs"), [(16, -96.33), (8, -48.16)])
    def test_requantisation_is_what_dither_costs(self, tmp_path, bits, dbfs):
        loss = rendered(tmp_path, noise(dbfs=-20, seconds=2), Target("t", 22_050, bits)).loss
        assert loss.requantisation_dbfs == pytest.approx(dbfs, abs=0.1)

    def test_rounding_alone_costs_a_twelfth_of_a_step(self, tmp_path):
        loss = rendered(tmp_path, noise(dbfs=-20, seconds=2), Target("t", 22_050, 24)).loss
        assert loss.requantisation_dbfs == pytest.approx(-20 * np.log10(2**23) - 10 * np.log10(12), abs=0.1)

    def test_what_is_exact_costs_nothing(self, tmp_path):
        assert rendered(tmp_path, noise(), Target("t", 48_000, 24)).loss.requantisation_dbfs == -np.inf
        assert (
            rendered(tmp_path, noise(), Target("t", 48_000, 32, encoding="float")).loss.requantisation_dbfs == -np.inf
        )
        assert rendered(tmp_path, silence()).loss.requantisation_dbfs == -np.inf

    def test_8_bit_to_8_bit_is_exact(self, tmp_path):
        made = rendered(tmp_path, noise(), Target("t", 48_000, 8), bits=8)
        assert np.array_equal(samples_of(tmp_path / "game.wav"), samples_of(tmp_path / "a.wav"))
        assert (made.dither, made.loss.requantisation_dbfs) == ("none", -np.inf)


class TestMono:
    def test_what_phase_eats_is_warned_of_with_its_place(self, tmp_path):
        left = join(sine(hz=440, dbfs=-12), sine(hz=440, dbfs=-12))
        right = join(sine(hz=440, dbfs=-12), -sine(hz=440, dbfs=-12))
        right[-1] *= 0.5  # not to the last bit
        made = rendered(tmp_path, np.concatenate([left, right], axis=1), Target("t", 22_050, 16, channels=1))
        assert made.loss.mono_loss_db == pytest.approx(3.01, abs=0.01)
        assert made.warnings == ()
        made = rendered(
            tmp_path, np.concatenate([left, right], axis=1)[48_000 - 4_800 :], Target("t", 22_050, 16, channels=1)
        )
        (warning,) = made.warnings
        assert (warning.code, warning.severity, warning.unit) == ("render:mono-loss", "warning", "dB")
        assert warning.measured == pytest.approx(10 * np.log10(11), abs=0.1)
        assert (warning.start_s, warning.end_s) == (pytest.approx(0.1), pytest.approx(1.1))
        assert "mono_gains" in warning.fix

    def test_no_such_figure_where_nothing_is_mixed(self, tmp_path):
        stereo = noise(channels=2)
        assert rendered(tmp_path, stereo).loss.mono_loss_db is None
        assert rendered(tmp_path, noise(), Target("t", 22_050, 16, channels=2)).loss.mono_loss_db is None

    def test_gains_of_the_target(self, tmp_path):
        both = np.concatenate([sine(hz=441, dbfs=-6), sine(hz=882, dbfs=-6)], axis=1)
        rendered(tmp_path, both, Target("t", 44_100, 24, channels=1, mono_gains=(0.8, 0.2)))
        mono = samples_of(tmp_path / "game.wav")[:44_100, 0]
        assert level_db(mono, 441, 44_100) == pytest.approx(-6 + 20 * np.log10(0.8), abs=0.01)
        assert level_db(mono, 882, 44_100) == pytest.approx(-6 + 20 * np.log10(0.2), abs=0.01)


class TestShelf:
    @pytest.mark.parametrize(("hz", "gain_db"), [(100, 0.0), (2_000, 0.0), (9_000, 3.0), (10_400, 3.0)])
    def test_the_top_octave_is_lifted_and_nothing_else(self, tmp_path, hz, gain_db):
        rendered(tmp_path, sine(hz=hz, dbfs=-20), Target("t", 22_050, 24, shelf_db=3.0))
        middle = samples_of(tmp_path / "game.wav")[4_410:17_640, 0]
        wave = 20 * np.log10(np.sqrt(2 * np.mean(middle**2)))
        assert wave == pytest.approx(-20 + gain_db, abs=0.01)

    def test_it_delays_nothing(self, tmp_path):
        impulse = np.zeros((4_801, 1))
        impulse[2_400] = 0.5
        rendered(tmp_path, impulse, Target("t", 24_000, 24, shelf_db=6.0))
        got = samples_of(tmp_path / "game.wav")[:, 0]
        assert np.argmax(np.abs(got)) == 1_200
        assert np.abs(got[1_200 - 500 : 1_200] - got[1_700:1_200:-1]).max() <= 1.0 / 2**23

    def test_by_itself_it_gives_back_what_is_lost(self, tmp_path):
        # As much above the new Nyquist frequency as in the octave below: half the energy, so 3.01 dB.
        sound = sine(hz=1_000, dbfs=-10) + sine(hz=8_000, dbfs=-30) + sine(hz=15_000, dbfs=-30)
        made = rendered(tmp_path, sound, Target("t", 22_050, 24, shelf_db="auto"))
        assert made.loss.shelf_db == pytest.approx(3.01, abs=0.02)

    @pytest.mark.parametrize("rate", [22_050, 48_000])
    def test_by_itself_it_leaves_what_lost_nothing(self, tmp_path, rate):
        made = rendered(tmp_path, sine(hz=1_000, dbfs=-10), Target("t", rate, 16, shelf_db="auto"))
        assert made.loss.shelf_db == 0.0

    def test_never_more_than_6_db(self, tmp_path):
        made = rendered(tmp_path, sine(hz=15_000, dbfs=-10), Target("t", 22_050, 16, shelf_db="auto"))
        assert made.loss.shelf_db == pytest.approx(6.0)

    def test_the_level_is_checked_again(self, tmp_path):
        made = rendered(tmp_path, swelling(sine(hz=10_000, dbfs=-1.0)), Target("t", 24_000, 16, shelf_db=6.0))
        assert made.attenuation_db == pytest.approx(5.0, abs=0.1)
        assert made.loss.attenuation_db == made.attenuation_db


class TestTrimAndFades:
    TRIMMED = Target("t", 48_000, 16, trim_below_dbfs=-60.0)
    SOUND = join(silence(seconds=0.1), sine(hz=1_000, seconds=0.2, phase=1.0), silence(seconds=0.3))

    def test_silence_is_cut_to_the_frame(self, tmp_path):
        made = rendered(tmp_path, self.SOUND, self.TRIMMED)
        assert made.frames == 9_600
        assert made.loss.trimmed_s == (pytest.approx(0.1), pytest.approx(0.3, abs=1e-4))
        assert not made.recalculated

    def test_silence_alone_is_left(self, tmp_path):
        made = rendered(tmp_path, silence(seconds=0.1), self.TRIMMED)
        assert (made.frames, made.loss.trimmed_s) == (4_800, (0.0, 0.0))

    def test_what_loops_is_neither_cut_nor_faded(self, tmp_path):
        write_wav(tmp_path / "a.wav", self.SOUND)
        target = Target("t", 48_000, 24, trim_below_dbfs=-60.0, fade_in_ms=10.0, fade_out_ms=10.0)
        made = render_master(tmp_path / "a.wav", target, tmp_path / "game.wav", loop=True)
        assert np.array_equal(samples_of(tmp_path / "game.wav"), samples_of(tmp_path / "a.wav"))
        assert not made.recalculated

    def test_fades_are_half_a_turn_of_a_cosine(self, tmp_path):
        level = np.full((4_800, 2), 0.5)
        made = rendered(tmp_path, level, Target("t", 48_000, 24, fade_in_ms=10.0, fade_out_ms=20.0))
        got = samples_of(tmp_path / "game.wav")
        rise = (1 - np.cos(np.pi * np.arange(1, 481) / 481)) / 4
        fall = (1 - np.cos(np.pi * np.arange(960, 0, -1) / 961)) / 4
        assert got[:480, 0] == pytest.approx(rise, abs=2e-7)
        assert got[-960:, 1] == pytest.approx(fall, abs=2e-7)
        assert (got[480:-960] == 0.5).all()
        assert made.recalculated

    def test_fades_longer_than_the_sound(self, tmp_path):
        made = rendered(tmp_path, np.full((48, 1), 0.5), Target("t", 48_000, 24, fade_in_ms=10.0, fade_out_ms=10.0))
        assert made.frames == 48
        assert np.abs(samples_of(tmp_path / "game.wav")).max() < 0.05


def test_it_is_plain_json(tmp_path):
    made = rendered(tmp_path, silence(seconds=0.1, channels=2), Target("t", 22_050, 16, channels=1))
    plain = json.loads(json.dumps(made.to_dict(), allow_nan=False))
    assert plain["loss"]["after"]["sample_peak_dbfs"] is None
    assert set(plain["loss"]["spectra"]) == {"hz", "master_dbfs", "render_dbfs"}
    assert plain["warnings"] == []
