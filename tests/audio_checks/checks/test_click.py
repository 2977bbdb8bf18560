"""`click`: what is far sharper than all around it, in a sound that goes on."""

import numpy as np
import pytest
from scipy.signal import butter, sosfilt

from tests.support.waves import join, noise, silence, sine

AT = 24_000  # half a second


def tone(channels=1):
    return sine(hz=300, dbfs=-6, channels=channels, phase=np.pi / 2)[:47_880]


def clicked(samples, height, at=AT, channel=-1):
    samples = samples.copy()
    samples[at, channel] += height
    return samples


@pytest.mark.parametrize("channels", [1, 2])
def test_one_sample_is_found_where_it_is(found_by, channels):
    (finding,) = found_by("click", clicked(tone(channels), 0.05))
    assert (finding.code, finding.measured) == ("click:isolated", 1.0)
    assert finding.start_s == pytest.approx(0.5, abs=0.001)
    assert finding.end_s == pytest.approx(0.501, abs=0.001)
    assert "-26.0 dBFS" in finding.message  # 0.05 of full scale


# The tone's peak is -6 dBFS: 44 dB under it is -50 dBFS, a height of 0.0032.
@pytest.mark.parametrize(("height", "codes"), [(0.0035, ["click:isolated"]), (0.0028, [])])
def test_what_lies_44_db_under_the_peak_is_too_small(codes_of, height, codes):
    assert codes_of("click", clicked(tone(), height)) == codes


# In 20 ms this noise has the energy of a sample of 0.031: one 18 dB over that is heard, and one 12 dB over it is not.
@pytest.mark.parametrize(("height", "codes"), [(0.25, ["click:isolated"]), (0.12, [])])
def test_it_must_be_heard_over_a_noisy_sound(codes_of, height, codes):
    assert codes_of("click", clicked(noise(dbfs=-60), height)) == codes


def test_small_clicks_in_bright_steady_tones(codes_of):
    bright = sum(sine(hz=hz, dbfs=-20, seconds=0.5, phase=hz) for hz in (1_700, 5_100, 11_900, 18_700))
    assert codes_of("click", bright) == []
    assert codes_of("click", clicked(bright, 0.04, at=12_000)) == ["click:isolated"]


def test_a_step_under_a_bright_sound(codes_of):
    # The tone and the breath over it are far sharper than the step; a cell of half a millisecond holds three whole
    # cycles of the one and little of the other, and there the step is alone.
    breath = np.diff(noise(seconds=0.5, dbfs=-34), n=2, axis=0, prepend=np.zeros((2, 1))) / 2
    bright = sine(hz=6_000, dbfs=-6, seconds=0.5) + breath
    step = np.zeros_like(bright)
    step[12_000:, 0] = 0.06 * np.exp(-np.arange(12_000) / 960)
    assert codes_of("click", bright) == []
    assert codes_of("click", bright + step) == ["click:isolated"]
    assert codes_of("click", bright + step / 1.5) == ["click:isolated"]  # in doubt there, and predicted by nothing


def test_a_small_click_in_a_tone_that_sweeps(codes_of):
    # Nothing here is steady, and the click is too little sharper than the air: what cannot be predicted shows it.
    times = np.arange(24_000) / 48_000
    air = noise(seconds=0.5, dbfs=-90)
    call = 0.5 * np.sin(2 * np.pi * (3_000 * times + 2_000 * times**2))[:, np.newaxis] + air
    assert codes_of("click", call) == []
    assert codes_of("click", clicked(call, 0.025, at=12_000)) == ["click:isolated"]


def test_a_dull_click_in_a_call(codes_of):
    # The air is sharper than the click and the call steeper; but the call can be predicted, and the click not.
    times = np.arange(24_000) / 48_000
    rising = np.sin(2 * np.pi * (3_000 * times + 3_000 * times**2)) * (1 + 0.5 * np.sin(2 * np.pi * 9 * times))
    call = 0.3 * rising[:, np.newaxis] + noise(seconds=0.5, dbfs=-50)
    dull = np.zeros_like(call)
    dull[11_994:12_006, 0] = 0.1 * np.hanning(12)
    assert codes_of("click", call) == []
    assert codes_of("click", call + dull) == ["click:isolated"]
    assert codes_of("click", call + dull / 10) == []


def test_a_splice_in_a_whistle(codes_of):
    # No cell is much sharper than the breath; but from the sound on either side nobody expects the other.
    times = np.arange(24_000) / 48_000
    whistle = (0.5 * np.sin(2 * np.pi * 1_500 * times) * (1 + 0.5 * np.sin(2 * np.pi * 7 * times)))[:, np.newaxis]
    whistle += noise(seconds=0.5, dbfs=-50)
    assert codes_of("click", whistle) == []
    assert codes_of("click", np.delete(whistle, slice(12_000, 12_016), axis=0)) == ["click:isolated"]


def test_ticks_that_are_the_sound_itself(codes_of):
    # Every other one is a quarter louder, and none is predicted from the 12 ms beside it; but there are others nearby.
    ticks = noise(seconds=0.5, dbfs=-45)
    for number, at in enumerate(range(2_400, 21_600, 672)):  # 14 ms apart
        ticks[at : at + 40, 0] += (0.4 + 0.1 * (number % 2)) * np.hanning(40) * np.sin(1.3 * np.arange(40))
    assert codes_of("click", ticks) == []


def with_contacts(samples, at):
    """Three short bands of noise within 2.5 ms, as a plug gives that moves in its socket."""
    samples = samples.copy()
    shapes = noise(dbfs=-26, seed=9)[:180].reshape(3, 60, 1)
    for shape, start in zip(shapes, (at, at + 40, at + 90), strict=True):
        samples[start : start + 32] += shape[:32] * np.exp(-np.arange(32) / 8)[:, np.newaxis]
    return samples


def test_contacts_of_a_plug(codes_of):
    # Each has another beside it that is as sharp, but within 20 ms there is nothing else, and the sound goes on.
    hum = sine(hz=400, dbfs=-10, seconds=0.5) + noise(seconds=0.5, dbfs=-60)
    assert codes_of("click", hum) == []
    assert codes_of("click", with_contacts(hum, 12_000)) == ["click:isolated"]
    rattle = hum
    for at in range(2_400, 21_600, 672):  # every 14 ms
        rattle = with_contacts(rattle, at)
    assert codes_of("click", rattle) == []
    stroke = with_contacts(hum, 12_000)  # and what was struck goes on to sound
    stroke[12_130:14_000] += noise(seconds=0.5, dbfs=-38)[:1_870] * np.exp(-np.arange(1_870) / 500)[:, np.newaxis]
    assert codes_of("click", stroke) == []


def test_a_block_from_elsewhere(codes_of):
    # It is joined twice, 1 ms apart: after the first joint there is another near, and before the second.
    times = np.arange(24_000) / 48_000
    whistle = (0.5 * np.sin(2 * np.pi * 1_500 * times) * (1 + 0.5 * np.sin(2 * np.pi * 7 * times)))[:, np.newaxis]
    whistle += noise(seconds=0.5, dbfs=-50)
    wrong = whistle.copy()
    wrong[12_000:12_048] = whistle[5_003:5_051]
    assert codes_of("click", wrong) == ["click:isolated"]


def test_a_dull_pulse_under_hiss(codes_of):
    # The hiss lies in the highs and hides what cannot be predicted of the pulse; without the highs it is alone.
    hiss = np.diff(noise(seconds=0.5, dbfs=-40), n=2, axis=0, prepend=np.zeros((2, 1)))
    hissing = sine(hz=150, dbfs=-10.5, seconds=0.5) + hiss
    pulse = np.zeros_like(hissing)
    pulse[12_002:12_026, 0] = 0.25 * np.hanning(24)
    assert codes_of("click", hissing) == []
    assert codes_of("click", hissing + pulse) == ["click:isolated"]
    assert codes_of("click", hissing + pulse / 3) == []


def test_a_step_and_a_splice_are_clicks(found_by):
    stepped = tone()
    stepped[AT:] += 0.05
    assert [finding.code for finding in found_by("click", stepped)] == ["click:isolated"]
    spliced = np.delete(tone(), slice(AT, AT + 40), axis=0)
    assert [finding.code for finding in found_by("click", spliced)] == ["click:isolated"]


def test_strokes_are_no_clicks(codes_of):
    times = np.arange(9_600) / 48_000
    stroke = noise(seconds=0.2, dbfs=-10) * np.exp(-times / 0.02)[:, np.newaxis]
    assert codes_of("click", join(noise(seconds=0.5, dbfs=-50), stroke, stroke)) == []


def test_several_are_counted_and_the_sharpest_is_shown(found_by):
    samples = tone(2)
    for at, height in ((9_600, 0.02), (19_200, 0.08), (28_800, 0.03), (38_400, 0.02)):
        samples[at, 0] += height
    (finding,) = found_by("click", samples)
    assert finding.message.startswith("4 clicks (0.200 s, 0.400 s, 0.600 s, ...)")
    assert finding.start_s == pytest.approx(0.4, abs=0.001)


@pytest.mark.parametrize("samples", [silence(), silence(seconds=1 / 48_000) + 0.5, tone(), noise(channels=2)])
def test_sounds_without_clicks_pass(codes_of, samples):
    assert codes_of("click", samples) == []


def struck(at_s, *, seed, seconds=0.5):
    """A stroke of 2 ms on a low body that dies away, from its first frame on."""
    times = np.arange(round(seconds * 48_000)) / 48_000
    draws = np.random.default_rng(seed)
    low, bright = (
        sosfilt(butter(2, hz, fs=48_000, output="sos"), draws.standard_normal(len(times))) for hz in (300, 8_000)
    )
    body = 0.1 * low * np.minimum(1.0, times / 0.002) * np.exp(-times / 0.15)
    return (body + 0.2 * bright * np.exp(-(((times - at_s) / 0.0008) ** 2)))[:, np.newaxis]


@pytest.mark.parametrize("at_s", [0.003, 0.006, 0.012])
def test_the_attack_of_a_sound_is_no_click(codes_of, at_s):
    assert [codes_of("click", struck(at_s, seed=seed)) for seed in range(6)] == [[]] * 6


def test_a_click_on_an_attack_is_found_where_it_stands_out(codes_of):
    dull = np.sin(2 * np.pi * 120 * np.arange(24_000) / 48_000) * np.exp(-np.arange(24_000) / 9_600)
    assert codes_of("click", dull[:, np.newaxis]) == []
    assert codes_of("click", clicked(dull[:, np.newaxis], 0.2, at=480)) == ["click:isolated"]


def test_crackle_that_is_the_sound_is_no_click(codes_of):
    # 120 strokes of about one height in two seconds of hiss, as leather creaks and fire burns.
    draws = np.random.default_rng(5)
    crackle = 0.02 * draws.standard_normal(96_000)
    for at in draws.integers(2_000, 94_000, 120):
        crackle[at : at + 48] += 0.2 * draws.uniform(0.7, 1.0) * draws.standard_normal(48) * np.exp(-np.arange(48) / 6)
    assert codes_of("click", crackle[:, np.newaxis]) == []


def test_clicks_that_no_one_hears_are_not_named(codes_of):
    quiet = 10 ** (-40 / 20) * tone()  # its peak is at -46 dBFS
    assert codes_of("click", clicked(quiet, 10 ** (-56 / 20))) == []
    assert codes_of("click", clicked(quiet, 10 ** (-48 / 20))) == ["click:isolated"]
