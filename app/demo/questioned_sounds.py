"""Sounds of "Shield Wing" that judgements ask about: of a lower rate than the file, reversed, and in a hall."""

import numpy as np

from app.demo.synth import (
    TURN,
    Clock,
    Signal,
    at_true_peak,
    burst,
    faded,
    gain,
    metal,
    mono,
    noise,
    rumble_off,
    struck,
    swirl,
    tone,
    wide,
)

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


def warp_in(clock: Clock) -> Signal:
    """Return own ship's arrival, 1.2 s of suction and blow, in a hall of 1.8 s that its list did not ask for."""
    hall = _in_hall(_arrival(clock), clock, rt60_s=1.8, wet_db=-4.0)
    return at_true_peak(np.stack([faded(channel, clock, 0.12) for channel in hall.T], axis=1), -1.5)


def warp_in_dry(clock: Clock) -> Signal:
    """Return own ship's arrival as it was before the hall."""
    return at_true_peak(mono(faded(_arrival(clock), clock, 0.12)), -1.5)


def _arrival(clock: Clock) -> Signal:
    times = clock.times()
    arrival_s = 0.62
    pull = np.where(
        times < arrival_s, 0.03 + 0.97 * (times / arrival_s) ** 3, np.exp(-np.maximum(times - arrival_s, 0.0) / 0.006)
    )
    suction = (noise(clock, 1, 500, 5_000, -2) + 0.6 * tone(clock, 180 + 900 * (times / arrival_s) ** 2)) * pull * 0.5
    blow = burst(clock, 2, arrival_s, [(50, 300, 0, 0.06), (300, 2_500, -4, 0.03), (2_500, 9_000, -9, 0.015)])
    hull = metal(clock, 30, arrival_s + 0.18, [(240, -8, 0.05), (610, -12, 0.04), (1_480, -16, 0.03)])
    return suction + 1.4 * blow + hull


def _in_hall(dry: Signal, clock: Clock, *, rt60_s: float, wet_db: float) -> Signal:
    """Return two channels of a sound and its reverb: noise that falls by 60 dB in a time, highs a third sooner."""
    times = clock.times(0.018)
    sides = []
    for channel in (40, 50):
        response = noise(clock, channel, 80, 2_500) * np.exp(-6.91 * times / rt60_s)
        response += 0.6 * noise(clock, channel + 1, 2_500, 9_000) * np.exp(-6.91 * times / (rt60_s / 1.5))
        response[times < 0] = 0.0
        size = 2 * clock.frames
        wet = np.fft.irfft(np.fft.rfft(dry, size) * np.fft.rfft(response, size), size)[: clock.frames]
        sides.append(dry + gain(wet_db) * wet * float(np.sqrt(np.sum(dry**2) / np.sum(wet**2))))
    return np.stack(sides, axis=1)
