"""Two sounds of "Shield Wing" that judgements ask about: one of a lower rate than its file, one that runs backwards."""

import numpy as np

from app.demo.synth import TURN, Clock, Signal, at_true_peak, faded, mono, noise, rumble_off, struck, swirl, tone, wide

OLD_RECORDER_HZ = 11_000.0  # what one of 22.05 kHz keeps
# Formants of the vowels that are sung, in Hz.
VOWELS = {"a": (730, 1_090, 2_440), "e": (530, 1_840, 2_480), "i": (280, 2_250, 2_890), "o": (500, 900, 2_410)}


def drone_swarm(clock: Clock) -> Signal:
    """Return forty small rotors in whole cycles, as an old recorder would have kept them: nothing over 11 kHz."""

    def side(channel: int) -> Signal:
        draws = clock.draws(2 + channel)
        total = np.zeros(clock.frames)
        for _ in range(40):
            blades = round(clock.duration_s * (150 + 170 * draws.random()))
            phase, near = TURN * draws.random(), 0.3 + 0.7 * draws.random()
            sway = (2 + 3 * draws.random()) * swirl(clock, 1 + int(draws.integers(6)), phase)
            turns = TURN * blades * np.arange(clock.frames) / clock.frames + sway
            for harmonic in (1, 2, 3, 5):
                total += near * np.sin(harmonic * turns + phase) / harmonic**1.4
        air = noise(clock, 60 + channel, 600, 20_000, -2) * (1 + 0.3 * swirl(clock, 9, 1.5 * channel))
        return _band_limited(total / 12 + 0.25 * air, clock, OLD_RECORDER_HZ)

    return at_true_peak(wide(side), -9.0)


def _band_limited(signal: Signal, clock: Clock, hz: float) -> Signal:
    """Return the signal with its spectrum cut off, as a steep resampler does; a loop keeps its seam."""
    spectrum = np.fft.rfft(signal)
    spectrum[np.fft.rfftfreq(clock.frames, 1 / clock.sample_rate_hz) > hz] = 0.0
    return np.fft.irfft(spectrum, clock.frames)


def oath_backwards(clock: Clock) -> Signal:
    """Return eleven syllables of a low voice, which begin sooner than they end, turned round."""
    draws = clock.draws(1)
    total, start_s = np.zeros(clock.frames), 0.002
    for syllable, vowel in enumerate("aioaeaoeiao"):
        times = clock.times(start_s)
        length_s = 0.20 + 0.12 * draws.random()
        hz = (118 - 3 * syllable) * (1 - 0.25 * np.clip(times / 0.6, 0.0, 1.0))
        voice = np.zeros(clock.frames)
        for harmonic in range(1, 33):
            level = sum(1 / (1 + ((110.0 * harmonic - formant) / 90.0) ** 2) for formant in VOWELS[vowel])
            decay_s = 0.4 * length_s / (1 + harmonic / 16)  # highs die first
            voice += level / harmonic**0.3 * tone(clock, harmonic * hz) * struck(times, 0.004, decay_s)
        consonant = 0.9 * noise(clock, 10 + syllable, 1_500, 12_000) * struck(times, 0.0005, 0.025)
        total += np.exp(-start_s / 2.0) * (voice + consonant)  # the breath gives out
        start_s += length_s + 0.16 + (0.25 if syllable in (3, 7) else 0.0)
    forwards = faded(rumble_off(total, clock, 70.0), clock, 0.10)
    return at_true_peak(mono(forwards[::-1].copy()), -3.0)
