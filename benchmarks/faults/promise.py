"""What each detector promises to find, described by what happened to the sound, and the ways outside the promise."""

PROMISED = {
    "click": "an event of up to 3 ms, or several within 4 ms, that stands out of the sound around it by 20 dB and is as"
    " sharp as one sample 40 dB under the sound's peak, where the sound goes on.",
    "dropout": "for 1 to 250 ms the sound is gone, and goes on before and after: silence, a value that stands still or"
    " leaks away, a level hiss 30 dB or more under the sound, fades of at most 3 ms beside it, in one channel or all,"
    " dithered or not, up to four times in a row;"
    " or a buffer of 64 to 2048 frames that plays again bit by bit, at once or after three others at most.",
    "cut-start, cut-tail": "the sound begins or ends in mid-wave, at the file's edge or beside silence: within 34 dB of"
    " the peak and high on its wave, an end with a fade of at most 0.2 ms; lowered, dithered, converted to another rate"
    " or gently filtered afterwards.",
    "clipping": "five crests are cut off at a rail for three samples each; rails may be unequal, on one side or in one"
    " channel; lowered, dithered, slowly ridden or sent through a coupling's low cut afterwards.",
    "dc-offset": "the mean of a channel lies beyond the limit.",
    "hum": "three lines on multiples of 50 or 60 Hz, the mains or twice the mains among them, the mains within 1 %, the"
    " third strongest as loud as what the sound has around it in its quietest quarter, throughout the sound.",
    "noise-floor": "a steady noise beyond the limit, 15 dB or more under the sound, alone for half a second.",
}
BEYOND = {  # ways that were tried and are not promised, and why: by check and name
    ("cut-start", "start point of a sampler"): "a fade-in of a tenth of a millisecond into what dies away or grows is"
    " the attack of a percussive sound: four of the real masters begin so",
    ("clipping", "clipped, then resampled"): "the steep filter of a converter leaves of a top of under five samples"
    " nothing but its rounded corners, as a low-passed square or a saturated tone has them",
    ("hum", "multiples of three"): "without the mains and its double it is a tone of 150 or 180 Hz with its harmonics,"
    " which a designer may have meant",
}
