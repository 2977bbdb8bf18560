"""Recipes of the sounds of "Shield Wing", made from noise, tones and struck metal."""

import numpy as np

from app.demo.synth import (
    TURN,
    Clock,
    Signal,
    around,
    at_rms,
    at_true_peak,
    burst,
    driven,
    faded,
    fall,
    gain,
    metal,
    mono,
    noise,
    panned,
    ramp,
    rumble_off,
    struck,
    swirl,
    tone,
    wide,
)


def two_notes(clock: Clock, first_hz: float, second_hz: float) -> Signal:
    """Return two glassy notes, the second a little to the right: a choice taken, or left."""

    def note(hz: float, start_s: float, decay_s: float) -> Signal:
        times = clock.times(start_s)
        glass = 1.8 * np.exp(-np.maximum(times, 0.0) / 0.012) * np.sin(TURN * 3.51 * hz * times)
        body = np.sin(TURN * hz * times + glass) + 0.3 * np.sin(TURN * 2.003 * hz * times)
        return body * struck(times, 0.0015, decay_s)

    tick = noise(clock, 1, 2_500, 11_000) * struck(clock.times(), 0.0003, 0.0018) * 0.14
    first, second = note(first_hz, 0.0, 0.022), 0.95 * note(second_hz, 0.048, 0.026)
    both = panned(first + tick, -0.25) + panned(second, 0.25)
    return at_true_peak(_faded(both, clock, 0.022), -7.0)


def _faded(samples: Signal, clock: Clock, out_s: float) -> Signal:
    return np.stack([faded(channel, clock, out_s) for channel in samples.T], axis=1)


def laser_fire(clock: Clock, variation: int) -> Signal:
    """Return a turret's bolt: a crack, a ringing dive of a modulated tone, and a short kick below."""
    draws = clock.draws(50)
    pitch = 1 + 0.09 * (variation - 2.5) / 1.5 + 0.02 * draws.standard_normal()
    times = clock.times()
    dive = fall(times, 3_400 * pitch, 300 * pitch, 0.048 + 0.006 * draws.random())
    ratio = (1.414, 1.5, 1.382, 1.618)[variation - 1]
    wobble = tone(clock, dive * ratio) * (3.2 * np.exp(-times / 0.06) + 0.25)
    ring = tone(clock, dive, 0.4) * 0.25
    bolt = np.sin(TURN * np.cumsum(dive) / clock.sample_rate_hz + wobble) * struck(times, 0.0008, 0.062)
    echo = np.sin(TURN * np.cumsum(dive * 0.5) / clock.sample_rate_hz + 0.5 * wobble) * struck(times, 0.012, 0.075)
    crack = burst(clock, 1, 0.0, [(2_500, 9_000, -9, 0.006), (9_000, 30_000, -15, 0.0025), (500, 2_500, -14, 0.02)])
    kick = tone(clock, fall(times, 190, 62, 0.03)) * struck(times, 0.001, 0.05)
    mixed = bolt + 0.45 * echo + ring * struck(times, 0.002, 0.04) + crack + 0.7 * kick
    return at_true_peak(mono(faded(rumble_off(driven(mixed, 1.6), clock), clock, 0.05)), -1.6)


def engine_idle(clock: Clock) -> Signal:
    """Return own ship at rest: a firing order of low harmonics, a turbine far aft, warm air, in whole cycles."""
    beat = 165  # 41.25 Hz over four seconds
    formants = {1: 0.0, 2: -3, 3: -2, 4: -8, 5: -9, 6: -6, 8: -12, 9: -15, 12: -14, 16: -20, 18: -22, 24: -26}

    def side(channel: int) -> Signal:
        draws = clock.draws(3 + channel)
        breath = 1 + 0.16 * swirl(clock, 6, channel * 0.7) + 0.07 * swirl(clock, 10, 1.0)
        order = np.zeros(clock.frames)
        for harmonic, level_db in formants.items():
            lean = 1 + 0.25 * swirl(clock, 2 + harmonic % 5, TURN * draws.random())
            order += gain(level_db) * lean * swirl(clock, beat * harmonic, TURN * draws.random())
        loping = 1 + 0.45 * swirl(clock, 55, 0.3 * channel)
        air = noise(clock, 10 + channel, 90, 700, -3) * 0.5 * loping + noise(clock, 20 + channel, 700, 5_000, -5) * 0.09
        sway = 5.0 * swirl(clock, 3, 0.4 * channel)
        turbine = np.sin(TURN * 4_950 * np.arange(clock.frames) / clock.frames + sway)
        upper = np.sin(TURN * 7_432 * np.arange(clock.frames) / clock.frames + 1.5 * sway)
        return breath * (order + air) + 0.035 * turbine + 0.014 * upper

    return at_true_peak(wide(side), -9.0)


def bridge(clock: Clock) -> Signal:
    """Return the bridge between orders: air, a low hum, consoles that answer each other, and once a distant relay."""

    def bed(channel: int) -> Signal:
        air = noise(clock, 10 + channel, 45, 1_400, -4.5) * (1 + 0.22 * swirl(clock, 3, channel * 1.1))
        vents = noise(clock, 20 + channel, 1_500, 9_000, -4) * 0.1 * (1 + 0.5 * swirl(clock, 5, 2.0 + channel))
        hum = sum(
            gain(level_db) * swirl(clock, cycles, channel * 0.3 + cycles)
            for cycles, level_db in ((1_176, -4.0), (1_177, -9.0), (2_352, -11.0), (3_530, -17.0), (7_056, -24.0))
        )
        return (air + vents) * 0.5 * (1 + 0.3 * swirl(clock, 12, 0.5 * channel)) + 0.35 * hum

    def chirp(hz: float, notes: int) -> Signal:
        total = np.zeros(clock.frames)
        for number in range(notes):
            times = clock.times(0.085 * number)
            total += np.sin(TURN * hz * (1.0, 1.26, 0.94, 1.5)[number % 4] * times) * struck(times, 0.006, 0.03)
        return total

    samples = wide(bed)
    calls = [
        (1.9, 1_180, 2, -0.6, -13), (4.6, 1_570, 3, 0.5, -16), (7.2, 940, 2, 0.1, -15), (10.8, 1_400, 4, -0.4, -17),
        (13.1, 1_180, 2, -0.6, -14), (16.7, 1_870, 3, 0.7, -18), (19.4, 1_050, 4, 0.3, -15), (22.9, 1_570, 2, 0.5, -14),
    ]  # fmt: skip
    for start_s, hz, notes, pan, level_db in calls:
        call = around(chirp(hz, notes), start_s, clock)
        samples += gain(level_db + 16) * (panned(call, pan) + 0.35 * panned(around(call, 0.173, clock), -pan))
    relay = metal(clock, 70, 0.0, [(310, -9, 0.12), (752, -14, 0.08), (1_420, -20, 0.05)])
    samples += panned(around(relay, 11.9, clock), -0.8) * 0.8
    return at_rms(samples, -33.0)


def hull_impact(clock: Clock, variation: int) -> Signal:
    """Return debris on the hull: a hard blow, a plate that rings, and crumbs that follow."""
    size = (1.0, 0.86, 1.13)[variation - 1]
    times = clock.times()
    blow = burst(
        clock,
        1,
        0.0,
        [(60, 240, -2, 0.11), (240, 900, -5, 0.07), (900, 3_500, -7, 0.03), (3_500, 12_000, -11, 0.012)],
    )
    thump = tone(clock, fall(times, 165 / size, 47 / size, 0.05)) * struck(times, 0.0015, 0.17)
    plate = [
        (183, -8, 0.34), (271, -10, 0.30), (408, -11, 0.26), (633, -12, 0.24), (958, -15, 0.18),
        (1_420, -17, 0.15), (2_215, -20, 0.11), (3_380, -24, 0.07), (5_060, -29, 0.05),
    ]  # fmt: skip
    ring = metal(clock, 20, 0.002, [(hz / size, level_db, decay_s) for hz, level_db, decay_s in plate])
    draws = clock.draws(40)
    crumbs = np.zeros(clock.frames)
    for number in range(9):
        start_s = 0.06 + 0.5 * draws.random() ** 1.4
        level_db = -17 - 14 * draws.random() - 12 * start_s
        modes = [
            (hz * (0.8 + 0.5 * draws.random()), -6.0 * mode, 0.014) for mode, hz in enumerate((1_900, 3_300, 5_600))
        ]
        crumbs += gain(level_db) * metal(clock, 60 + number, start_s, modes)
        crumbs += (
            gain(level_db - 3) * noise(clock, 80 + number, 2_000, 14_000) * struck(clock.times(start_s), 0.0005, 0.006)
        )
    mixed = driven(blow + 1.5 * thump + 0.9 * ring, 2.2) + 0.9 * crumbs
    return at_true_peak(mono(faded(rumble_off(mixed, clock), clock, 0.09)), -1.4)


def _shield(
    clock: Clock,
    hz: float,
    dive_hz: float,
    decay_s: float,
    flutter_hz: float,
    grit: float,
    late_s: float,
    flutter: float,
) -> Signal:
    """Return an enemy shot on the shield: a crack of current, a tone that sinks, and a field that shivers after it."""
    times = clock.times()
    crack = burst(clock, 1, 0.0, [(700, 4_000, -4, 0.012), (4_000, 14_000, -8, 0.007), (14_000, 34_000, -15, 0.004)])
    gritty = noise(clock, 10, 150, 1_800, -2) * grit * struck(times, 0.010, decay_s * 0.5) * 0.5
    sinking = hz - dive_hz * np.clip(times, 0.0, 0.7)
    body = tone(clock, sinking) + 0.45 * tone(clock, 1.996 * sinking, 0.8)
    shiver = (1 - flutter) + flutter * np.sin(TURN * flutter_hz * times + 1.0)
    faster = (1 - flutter) + flutter * np.sin(TURN * 1.6 * flutter_hz * times)
    ringing = 2.2 * np.exp(-times / (0.6 * decay_s)) * tone(clock, 1.37 * sinking)
    field = np.sin(TURN * 2.76 * np.cumsum(sinking) / clock.sample_rate_hz + ringing)
    veil = noise(clock, 12, 1_800, 7_500, -3) * 0.32
    glass = tone(clock, 5.4 * sinking, 0.3) + 0.5 * tone(clock, 8.93 * sinking, 1.9)
    mixed = (
        1.1 * crack
        + gritty
        + 0.85 * body * struck(times, 0.004, decay_s)
        + (0.55 * field + veil) * struck(clock.times(late_s), 0.045, decay_s * 0.95) * shiver
        + 0.30 * glass * struck(clock.times(2.2 * late_s), 0.06, decay_s * 0.8) * faster
    )
    return rumble_off(driven(mixed, 2.0), clock, 40.0)


def shield_glass(clock: Clock) -> Signal:
    """Return alternate A, whose curve between the samples is higher than all of them."""
    spark = 0.15 * noise(clock, 98, 12_000, 30_000) * struck(clock.times(), 0.001, 0.03)
    sound = faded(_shield(clock, 310, 160, 0.20, 17, 0.7, 0.03, 0.38) + spark, clock, 0.14)
    return at_true_peak(mono(sound), -0.6)


def shield_deep(clock: Clock) -> Signal:
    """Return alternate B, which is lower and lasts longer."""
    sound = faded(_shield(clock, 172, 60, 0.27, 8, 0.4, 0.14, 0.52), clock, 0.16)
    return at_true_peak(mono(sound), -3.0)


def shield_crackle(clock: Clock) -> Signal:
    """Return alternate C, which is higher, shorter and rougher."""
    sound = faded(_shield(clock, 560, 420, 0.15, 34, 1.2, 0.02, 0.55), clock, 0.14)
    return at_true_peak(mono(sound), -1.3)


def step_on_deck(clock: Clock, variation: int) -> Signal:
    """Return a boot on steel grating: heel, the plate below it, toe, and a scrape between."""
    draws = clock.draws(50)
    toe_s = 0.105 + 0.022 * draws.random()
    weight = 1 + 0.14 * draws.standard_normal()
    times = clock.times()
    heel = burst(clock, 1, 0.0, [(90, 420, -3, 0.022), (420, 1_900, -7, 0.012), (1_900, 7_500, -13, 0.006)])
    thud = tone(clock, fall(times, 120, 74, 0.02)) * struck(times, 0.003, 0.045) * 1.1
    plate = [
        (236, -10, 0.07),
        (391, -11, 0.062),
        (688, -13, 0.06),
        (1_130, -17, 0.05),
        (1_940, -22, 0.035),
        (3_100, -27, 0.03),
    ]
    lean = 1 + 0.08 * (variation - 3.5) / 2.5
    ring = metal(clock, 20, 0.001, [(hz * lean, level_db, decay_s * 1.25) for hz, level_db, decay_s in plate])
    toe = burst(clock, 30, toe_s, [(140, 600, -9, 0.02), (600, 3_000, -12, 0.014), (3_000, 9_000, -17, 0.007)])
    toe_ring = metal(
        clock, 40, toe_s, [(hz * lean * 1.04, level_db - 8, decay_s * 1.2) for hz, level_db, decay_s in plate[1:]]
    )
    scrape = noise(clock, 60, 900, 6_000, -4) * 0.035 * struck(clock.times(0.012), 0.02, 0.09)
    mixed = weight * (heel + thud) + ring + toe + toe_ring + scrape
    level_db = (-25.0, -25.7, -24.9, -25.4, -26.2, -25.2)[variation - 1]
    return at_rms(mono(faded(rumble_off(driven(mixed, 1.5), clock, 40.0), clock, 0.06)), level_db)


def airlock_cycle(clock: Clock) -> Signal:
    """Return the inner door as it should not be sent: it starts late, and it clips."""
    start_s, lock_s = 0.412, 1.692
    times = clock.times(start_s)
    open_s = clock.times(start_s + 0.06)
    valve = burst(clock, 1, start_s, [(1_500, 8_000, -6, 0.06), (300, 1_500, -6, 0.05), (80, 300, -3, 0.06)])
    hiss = noise(clock, 10, 900, 9_000, -3) * 0.55 * struck(open_s, 0.10, 0.42)
    hum_hz = 118 + 70 * ramp(times, 0.25, 1.28)
    running = ramp(times, 0.2, 0.42) * ramp(times, 1.31, 1.27)
    motor = sum(gain(-4.0 * number) * tone(clock, hum_hz * number, 0.9 * number) for number in range(1, 8))
    cogs = 0.6 + 0.4 * np.sign(np.sin(TURN * 23 * times))
    thump = tone(clock, fall(times, 95, 52, 0.06)) * struck(times, 0.004, 0.15)
    modes = [
        (148, -4, 0.16),
        (263, -6, 0.17),
        (421, -8, 0.15),
        (760, -11, 0.12),
        (1_290, -15, 0.09),
        (2_180, -19, 0.06),
    ]
    lock = metal(clock, 40, lock_s, modes) + burst(clock, 50, lock_s, [(70, 500, 0, 0.05), (500, 4_000, -5, 0.02)])
    bolt = metal(
        clock, 60, lock_s + 0.085, [(hz * 1.31, level_db - 6, decay_s * 0.8) for hz, level_db, decay_s in modes]
    )
    release = noise(clock, 70, 1_200, 8_000, -4) * 0.16 * struck(clock.times(lock_s + 0.1), 0.04, 0.2)
    mixed = valve + hiss + 1.5 * thump + 0.20 * running * motor * cogs + 1.25 * lock + bolt + release
    room = noise(clock, 80, 60, 2_000, -4) * gain(-84)
    loud = faded(rumble_off(mixed * (times >= 0), clock), clock, 0.07) * 0.68 + room
    return mono(np.clip(loud, -1.0, 1.0))


def suit_hit(clock: Clock, clank_db: float | None) -> Signal:
    """Return a shot on a pressure suit: cloth, air and the body under it, with a dull metallic clank if asked."""
    times = clock.times()
    slap = burst(clock, 1, 0.0, [(250, 1_100, -3, 0.022), (1_100, 5_000, -9, 0.010), (5_000, 13_000, -17, 0.005)])
    thump = tone(clock, fall(times, 128, 66, 0.03)) * struck(times, 0.003, 0.085) * 1.3
    cloth = noise(clock, 10, 300, 2_600, -3) * 0.30 * struck(clock.times(0.008), 0.008, 0.055)
    air = noise(clock, 11, 1_400, 6_500, -3) * 0.07 * struck(clock.times(0.05), 0.05, 0.085)
    mixed = slap + thump + cloth + air
    if clank_db is not None:
        dull = [(312, 0, 0.10), (410, -2, 0.11), (633, -4, 0.085), (871, -9, 0.06), (1_268, -14, 0.04)]
        mixed = mixed + gain(clank_db + 6) * metal(clock, 30, 0.018, dull)
    return at_true_peak(mono(faded(rumble_off(driven(mixed, 1.7), clock, 35.0), clock, 0.07)), -2.0)


def thruster_burst(clock: Clock, variation: int) -> Signal:
    """Return a side thruster's short push: valve, a fluttering jet, and its end; the third is 4 dB over its set."""
    draws = clock.draws(50)
    times = clock.times()
    flutter_hz = 27 + 2.5 * draws.standard_normal()
    push = ramp(times, -0.002, 0.055) * np.exp(-np.maximum(times - 0.55, 0.0) / 0.075)
    flutter = 1 + 0.34 * np.sin(TURN * flutter_hz * times + TURN * draws.random())
    jet = noise(clock, 10, 110, 1_100, -2.5) + 0.28 * noise(clock, 11, 1_100, 7_000, -4)
    throat = tone(clock, 78 * (1 + 0.05 * draws.standard_normal()) + 14 * push, 0.4) * 0.8
    valve = burst(clock, 20, 0.0, [(400, 2_500, -7, 0.012), (2_500, 9_000, -12, 0.02)])
    shut = metal(clock, 30, 0.585 + 0.02 * draws.random(), [(522, -16, 0.03), (1_180, -19, 0.022), (2_350, -24, 0.016)])
    mixed = driven((jet + throat) * push * flutter, 1.8) + 0.35 * valve + 0.6 * shut
    level_db = -15.5 if variation == 3 else -19.5
    return at_rms(mono(faded(rumble_off(mixed, clock, 40.0), clock, 0.06)), level_db)


def victory_sting(clock: Clock) -> Signal:
    """Return the fanfare of a won sector: three rising calls and a held chord, brass over a drum and a shimmer."""
    roots = [(0.0, 1.0, 0.17), (0.32, 1.0, 0.17), (0.64, 1.1225, 0.20), (1.10, 1.4983, 0.62)]
    voices = (130.81, 261.63, 329.63, 392.00, 523.25)

    def side(channel: int) -> Signal:
        draws = clock.draws(channel)
        total = np.zeros(clock.frames)
        for start_s, root, decay_s in roots:
            times = clock.times(start_s)
            envelope = struck(times, 0.022, decay_s) * np.clip(np.exp(-np.maximum(times - 1.2, 0) / 0.3), 0, 1)
            bright = 2.2 + 7.5 * struck(times, 0.05, 0.8 * decay_s)
            vibrato = 0.0016 * ramp(times, 0.25, 0.6) * np.sin(TURN * 5.4 * times)
            for voice in voices:
                hz = voice * root * (1 + 0.0016 * draws.standard_normal())
                turning = np.exp(1j * TURN * hz * (times + 6 * vibrato / (5.4 * TURN)))
                harmonic = np.exp(0.5j * channel) * turning
                fading = np.exp(-1 / bright)
                level = envelope * fading / len(voices)
                for _ in range(12):
                    total += level * harmonic.imag
                    harmonic *= turning
                    level = level * fading
        last = clock.times(1.10)
        shimmer = noise(clock, 30 + channel, 5_000, 22_000, -2) * 0.085 * struck(last, 0.02, 0.38)
        drum = sum(
            level * tone(clock, fall(clock.times(start_s), 110, 65, 0.04)) * struck(clock.times(start_s), 0.003, 0.16)
            for start_s, level in ((0.0, 0.35), (0.32, 0.35), (0.64, 0.45), (1.10, 0.75))
        )
        return faded(rumble_off(driven(total, 1.2) + shimmer + drum, clock, 35.0), clock, 0.10)

    return at_true_peak(wide(side), -1.5)


def alarm(clock: Clock) -> Signal:
    """Return the placeholder file for a red alert: four plain pulses on two tones, in whole cycles."""
    times = clock.times()
    part = times % 0.5
    pulse = ramp(part, 0.0, 0.004) * ramp(part, 0.322, 0.316)
    hz = np.where(times % 1.0 < 0.5, 620.0, 780.0)
    voice = sum(np.sin(TURN * hz * number * part) / number for number in (1, 3, 5))
    return at_true_peak(mono(voice * pulse), -8.0)


def mine_arm(clock: Clock) -> Signal:
    """Return a mine that wakes: a latch, a servo that rises, and pips that come faster."""
    times = clock.times()
    latch = metal(clock, 1, 0.0, [(830, -8, 0.03), (1_490, -10, 0.022), (2_730, -14, 0.014)])
    servo_hz = 240 + 560 * ramp(times, 0.02, 0.36)
    servo = (tone(clock, servo_hz) + 0.5 * tone(clock, 2.02 * servo_hz) + 0.3 * tone(clock, 5.1 * servo_hz)) * 0.14
    servo *= ramp(times, 0.02, 0.08) * ramp(times, 0.37, 0.33)
    pips = np.zeros(clock.frames)
    for start_s, hz in ((0.12, 1_560), (0.23, 1_560), (0.31, 1_560), (0.37, 2_080)):
        since = clock.times(start_s)
        pips += np.sin(TURN * hz * since) * struck(since, 0.002, 0.024 if hz < 2_000 else 0.034)
    mixed = latch + servo + 0.5 * pips
    return at_true_peak(mono(faded(rumble_off(mixed, clock, 60.0), clock, 0.03)), -4.0)


def radar_ping(clock: Clock) -> Signal:
    """Return a sweep's find: one glassy ping with a short tail."""
    times = clock.times()
    ring = np.sin(TURN * 1_460 * times + 0.8 * np.exp(-times / 0.03) * np.sin(TURN * 2_920 * times))
    tail = noise(clock, 1, 1_100, 3_800) * 0.05 * struck(times, 0.01, 0.12)
    return at_true_peak(mono(_rounded(ring * struck(times, 0.002, 0.13) + tail, clock, 0.06)), -6.0)


def dock_clamp(clock: Clock) -> Signal:
    """Return two clamps that take the hull, the second heavier."""
    modes = [(318, 0, 0.10), (527, -4, 0.09), (861, -8, 0.07), (1_530, -13, 0.05)]
    light = metal(clock, 1, 0.0, modes) + burst(clock, 2, 0.0, [(90, 700, 0, 0.04), (700, 5_000, -8, 0.015)])
    heavy = metal(clock, 10, 0.26, [(hz * 0.62, level_db + 2, decay_s * 1.2) for hz, level_db, decay_s in modes])
    heavy += 1.6 * burst(clock, 20, 0.26, [(45, 420, 0, 0.07), (420, 3_600, -7, 0.02)])
    return at_true_peak(mono(_rounded(driven(light + heavy, 1.6), clock, 0.07)), -2.5)


def explosion_far(clock: Clock) -> Signal:
    """Return a ship that dies far off: low and wide, without a crack."""

    def side(channel: int) -> Signal:
        times = clock.times()
        swell = ramp(times, -0.01, 0.09) * np.exp(-np.maximum(times - 0.1, 0.0) / 0.42)
        low = noise(clock, 1 + channel, 32, 260, -3.5) * swell
        rubble = noise(clock, 11 + channel, 180, 1_300, -4) * 0.22 * swell * ramp(times, 0.1, 0.5)
        body = 0.8 * tone(clock, fall(times, 74, 38, 0.3)) * swell
        return _rounded(driven(low + rubble + body, 1.4), clock, 0.25)

    return at_true_peak(wide(side), -4.0)


def missile_launch(clock: Clock, thrust_s: float) -> Signal:
    """Return a missile that leaves: release, then ignition and departure from `thrust_s` on."""
    times, since = clock.times(), clock.times(thrust_s)
    release = metal(clock, 1, 0.0, [(402, -3, 0.06), (977, -8, 0.04), (1_850, -13, 0.03)])
    hiss = noise(clock, 5, 900, 7_500, -3) * 0.10 * struck(times, 0.01, 0.16)
    going = ramp(since, -0.005, 0.06) * np.exp(-np.maximum(since - 0.06, 0.0) / 0.26)
    thrust = noise(clock, 10, 60, 1_800, -2.5) * going * (1 + 0.3 * np.sin(TURN * 31 * times))
    kick = burst(clock, 20, thrust_s, [(50, 500, 2, 0.06), (500, 6_000, -6, 0.03)])
    return at_true_peak(mono(_rounded(driven(0.5 * release + hiss + thrust + kick, 1.5), clock, 0.10)), -2.0)


def _rounded(signal: Signal, clock: Clock, out_s: float) -> Signal:
    return faded(rumble_off(signal, clock, 30.0), clock, out_s)
