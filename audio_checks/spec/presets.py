"""Delivery specs to start from: the defaults that do not return good work, commented line by line."""

import json
from collections.abc import Sequence

from audio_checks.spec import target_presets

PRESETS = ("44k1", "48k")

_ACCEPT = {
    "44k1": """\
sample_rates_hz = [44100, 48000, 96000]   # or "any"
bit_depths = [16, 24]                     # or "any"
""",
    "48k": """\
sample_rates_hz = [48000, 96000]          # or "any"
bit_depths = [24]                         # or "any"
""",
}

_TARGETS = {
    "44k1": """\
[targets.game]                      # what renders are made to; several may be named
sample_rate_hz = 44100
bit_depth = 16                      # 8, 16, 24; 32 and 64 with encoding = "float"
encoding = "pcm"
channels = "master"                 # "master", 1, 2
dither = "tpdf"                     # "tpdf", "shaped", "none"
over_peak = "attenuate"             # "attenuate", "refuse"

[targets.handheld]
sample_rate_hz = 22050
bit_depth = 16
channels = 1
""",
    "48k": """\
[targets.game]                      # what renders are made to; several may be named
sample_rate_hz = 48000
bit_depth = 16                      # 8, 16, 24; 32 and 64 with encoding = "float"
encoding = "pcm"
channels = "master"                 # "master", 1, 2
dither = "tpdf"                     # "tpdf", "shaped", "none"
over_peak = "attenuate"             # "attenuate", "refuse"
""",
}

_TEXT = """\
format = 1
name = {name}

[accept]                            # what a delivered file may be
containers = ["wav"]                # "wav", "rf64", "flac"
encodings = ["pcm"]                 # "pcm", "float"
{accept}channels = [1, 2]                         # or "any"; and layouts = ["stereo", "quad", "5.1", "ambisonic-1"]
duration_s = {{ min = 0.01, max = 30.0 }}

[limits]                            # what is absent is not limited
sample_peak_dbfs = -0.1
true_peak_dbtp = -1.0               # a warning; an error for music, voice and cinematics, below
dc_offset_percent = 1.0
silence_below_dbfs = -90.0          # a file that never exceeds this is silent
low_level_dbfs = -40.0              # and one that never exceeds this too quiet
head_silence_ms = 5
tail_silence_ms = 250               # of digital silence: a natural decay is none
edge_silence_below_dbfs = -60.0     # what counts as silence at the head, or 60 dB under the file's peak
tolerance_db = 0.05                 # a level fails when it is more than this beyond its limit
mono_loss_db = 6.0                  # what a stereo sound may lose in mono; channels that have nothing in common lose 3
# loudness_lufs = {{ min = -40.0, max = -10.0 }}

[naming]
pattern = '[a-z0-9]+(_[a-z0-9]+)*'  # ASCII; the whole name before the ending must match
extension = ".wav"

# [metadata]
# required = ["bext.Originator", "iXML.ASWG.catId", "INFO.ICOP"]

[engine]
adds = ["reverb"]                   # what the game adds ("reverb", "occlusion", "pitch", "doppler"): files come without

{targets}
[checks]                            # per check: "error", "warning", "off"
true-peak = "warning"
head-silence = "warning"
tail-silence = "warning"

# The same tables again, for one category: what is said here replaces what is said above.
[categories.ambience]
kind = "ambience"                   # "event", "natural-decay", "ambience", "voice", "music"
accept.duration_s = {{ max = 300.0 }}

[categories.music]
kind = "music"
accept.duration_s = {{ max = 300.0 }}
checks.true-peak = "error"

[categories.cinematic]
accept.duration_s = {{ max = 300.0 }}
checks.true-peak = "error"

[categories.vo]
kind = "voice"
limits.head_silence_ms = 50
checks.true-peak = "error"

[categories.narration]
kind = "voice"
limits.head_silence_ms = 50
checks.true-peak = "error"

[categories.ui]
kind = "event"

[categories.foley]
kind = "event"

[categories.weapon]
kind = "natural-decay"

[categories.impact]
kind = "natural-decay"

[categories.creature]

[categories.vehicle]
"""


def new_spec(preset: str = "44k1", *, name: str = "New project", targets: Sequence[str] = ()) -> str:
    """Return a commented spec to start from, as TOML.

    `44k1` accepts 44.1, 48 and 96 kHz at 16 and 24 bit, and renders to 44.1 kHz/16 bit and to
    22,050 Hz/16 bit mono; `48k` accepts 48 and 96 kHz at 24 bit, and renders to 48 kHz/16 bit.
    `targets` names engines to render for in place of these: wwise, fmod, unreal, unity, raw.

    Raises
    ------
    ValueError
        For any other preset or target.
    """
    if preset not in PRESETS:
        raise ValueError(f"no preset {preset!r}; presets: {', '.join(PRESETS)}")
    if unknown := [target for target in targets if target not in target_presets.TARGET_PRESETS]:
        raise ValueError(f"no target {unknown[0]!r}; targets: {', '.join(target_presets.TARGET_PRESETS)}")
    made = (
        "\n".join(target_presets.TARGET_PRESETS[fromkey].to_toml() for fromkey in dict.fromkeys(targets))
        or _TARGETS[preset]
    )
    quoted = json.dumps(name, ensure_ascii=False).replace("\x7f", "\\u007f")
    return _TEXT.format(name=quoted, accept=_ACCEPT[preset], targets=made)
