"""The thresholds of the detectors in words, for RESULTS.md."""

from audio_checks.measure import (
    abrupt,
    clicks,
    cuts,
    dropouts,
    flat_tops,
    hum,
    in_phase,
    lulls,
    noise_floor,
    onsets,
    repeats,
    straight_tops,
)
from audio_checks.measure import click_rules as rules
from audio_checks.measure.decibels import decibels, power_decibels


def thresholds() -> dict[str, str]:
    """Return each check's thresholds in words."""
    return {
        "click": f"the sixth difference of a half-millisecond is {clicks.STANDS_OUT:g} times, its largest step"
        f" {clicks.STEPS_OUT:g} times, or its bend below 1 kHz {clicks.BENDS_OUT:g} times the largest within"
        f" {clicks.REACH / 2:g} ms before and after. What is {clicks.CANDIDATE:g} times as sharp, or so large a step,"
        f" or {clicks.BENDS_DOUBTFUL:g} times as bent, is a click where {rules.ALONE[0].cells / 2:g} ms there can be"
        f" predicted neither from the {clicks.CONTEXT / 2:g} ms before nor from those after,"
        f" {rules.HARDER_THAN_BESIDE:g} times as badly as that sound itself, and {rules.HARDER_THAN_AROUND:g} times"
        f" as badly both ways as any other place so near; from {rules.DULL_DOUBTFUL:g} times on also where it is"
        f" predicted {rules.DULL_HARDER_THAN_BESIDE:g} and {rules.DULL_HARDER_THAN_AROUND:g} times as badly without"
        f" the highs, at a quarter of the rate or so. Steady sounds throughout (the peak of their sixth differences,"
        f" but for the {clicks.CLICKED} sharpest of {clicks.SEGMENT} cells, under {clicks.STEADY:g} times the"
        f" RMS) are predicted"
        f" from {clicks.ORDER} samples, and {clicks.STANDS_OUT:g} times are wanted of what cannot be. Where the largest"
        f" step changes by less than {100 * clicks.GLIDES:g} % from one half-millisecond to the next, a tone glides:"
        f" there what is {clicks.GLIDE_DOUBTFUL:g} times as hard to predict as the {clicks.GLIDED / 2:g} ms before and"
        f" after is looked at so too, and {rules.GLIDE_HARDER:g} times as badly as the sound on either side is enough."
        f" Several within {rules.IN_BURSTS[0].cells / 2:g} ms are one event where one is"
        f" {clicks.BURST_STANDS_OUT:g} times as sharp as all that lies {rules.BURST / 2:g} to {clicks.REACH / 2:g} ms"
        f" before and after, and is predicted {rules.BURST_HARDER_THAN_BESIDE:g} and"
        f" {rules.BURST_HARDER_THAN_AROUND:g} times as badly, in a sound whose sixth differences have there the same"
        f" power before as after, within {power_decibels(clicks.BURST_GOES_ON):.1f} dB."
        f" It stands {clicks.HEARD_DB:g} dB over what the 20 ms before and after mask, in a critical band above 1 kHz."
        f" What stands out less than {onsets.ISOLATED_DB:g} dB of the 3 ms on both sides is none where the highs are"
        f" {onsets.LOUDER_DB:g} dB louder after it, where the sound begins there, {onsets.SILENT_DB:g} dB over the"
        f" {(onsets.LEAD[1] - onsets.LEAD[0]) / 2:g} ms of silence before, or where {onsets.ALIKE} moments of the file"
        f" are as sharp within {onsets.ALIKE_DB:g} dB. What lies {-decibels(clicks.BELOW_PEAK):.0f} dB under the"
        f" file's peak, or under {decibels(clicks.AUDIBLE):.0f} dBFS, counts for nothing.",
        "dropout": f"a hole is {dropouts.SHORTEST / 2:g} to {dropouts.LONGEST / 2:g} ms in which no step exceeds"
        f" {dropouts.STILL * 2**15:.1f} units of 16 bit, or nothing but a value that leaks away or a straight"
        f" line, or that lie {power_decibels(lulls.UNDER):.0f} dB under the sound and are level, within"
        f" {power_decibels(lulls.HALVES):.0f} dB from half to half; with sound up to both its edges, as loud within"
        f" {power_decibels(dropouts.ALIKE):.0f} dB; holes that are alike and come on a beat are a gate; a repeat is a"
        f" buffer of"
        f" {1000 * repeats.SHORTEST_S:g} to {1000 * repeats.LONGEST_S:g} ms that comes again, bit by bit, up to"
        f" {repeats.MOST_TIMES:g} times, or"
        f" once after no more than {repeats.RING - 1} others.",
        "cut-start, cut-tail": f"the outermost sample reaches {cuts.EDGE_SHARE:g} of the largest within"
        f" {1000 * abrupt.NEAR_S:g} ms, lies less than {-decibels(cuts.BELOW_PEAK):.0f} dB under the file's peak, and"
        f" the wave, followed on, does not pass through zero; or so where the sample to which it rises within"
        f" {cuts.STEP + 1:g} is the outermost, but for what rings at {cuts.RING_HZ:g} of the rate or faster and"
        f" {cuts.RING_SHARE:g} as high. Or the sound rises from {abrupt.REST:g} of the largest to {abrupt.REACHES:g}"
        f" within a sample (of 48 kHz) or, by a ramp, {1000 * abrupt.RAMP_S:g} ms, and is as loud there as"
        f" {abrupt.LOUD:g} of what follows; unless it can be predicted (within {abrupt.PREDICTED:g} of the largest)"
        f" from what follows, and is there within {abrupt.OTHERWISE:g}. At a start level and slope are, from 10 to 40"
        f" ms after it, {abrupt.DIES:g} to {abrupt.GROWS:g} times those of the first 5 ms, or it is an attack; at an"
        f" end a low cut's smooth answer does not count.",
        "clipping": f"{flat_tops.SHORTEST_RUN} samples in a row at full scale; or {flat_tops.FEWEST} crests at the"
        f" file's own ceiling (within {100 * flat_tops.CEILING:g} %), each with {flat_tops.SHORTEST_RUN} samples or"
        f" more on one level and a corner at both ends; or {100 * flat_tops.SOFT_SHARE:.0f} % of the highest crests of"
        f" a channel's side, {flat_tops.SOFT_FEWEST} at least, less than {flat_tops.SOFT_RATIO:g} times as wide"
        f" at {flat_tops.SOFT_WIDE:g} of their height as at {flat_tops.SOFT_FLAT:g}; or, where one of the"
        f" {flat_tops.HIGHEST} highest crests of a channel's side is so, {straight_tops.FEWEST} crests or more, over"
        f" {straight_tops.HIGH:g} of the highest, that are straight between two corners: these bend 16 times as much as"
        f" anything between them (64 times where two samples lie between, 4096 times where one does); or, seen over two"
        f" samples, 10 times as much as what lies between, among ripples that bend twice as much as that. They are over"
        f" {straight_tops.SHARE:g} of all that lie as high near by, and steps are at most"
        f" {straight_tops.MOST_STEPPED:g} times as many.",
        "dc-offset": "the limit of the spec, here 1 % of full scale.",
        "hum": f"{hum.LINES} multiples of 50 or 60 Hz, within {100 * hum.OFF:g} %, in tune within"
        f" {100 * hum.IN_TUNE:.2g} %"
        f" ({hum.LINES + 1} lines: {100 * hum.LOOSER * hum.IN_TUNE:.2g} %), "
        f"{power_decibels(hum.PROMINENT):.0f} dB over what lies beside them in the quietest"
        f" quarter of windows of {hum.WINDOWS_S[0]:g} or {hum.WINDOWS_S[1]:g} s. Where fewer do, in the first"
        f" {in_phase.LONGEST_S:g} s, as many that add up in phase over windows of {in_phase.WINDOW_S:g} s, weighted by"
        f" the noise beside them, to {power_decibels(in_phase.PROMINENT):.0f} dB over what that noise adds up to; they"
        f" are there in {100 * in_phase.CONSTANT:.0f} % of the windows that could show them, and in each half of the"
        f" sound; of multiples {', '.join(map(str, hum.NEUTRAL))}, too, the first among them."
        f" {power_decibels(hum.LEAST):.0f} dBFS or more together.",
        "noise-floor": "the limit of the spec, here -60 dBFS, on the quietest"
        f" {noise_floor.PAUSE / 100:g} s, where it is steady, does not die away and lies"
        f" {power_decibels(noise_floor.DEEP):.0f} dB or more under the loudest; what stays within"
        f" {noise_floor.PLATEAU_DB:g} dB for {2 * noise_floor.PAUSE / 100:g} s does not die away.",
    }
