"""`encoding`: the samples are stored the way the project accepts.

Why: integer and floating-point samples need different handling in a game's build, and a float
file can hold levels above full scale that the next tool clips. In a game's own files a codec may
keep the samples; too low a bit rate is heard, too high a one takes memory.
How to fix: export with integer (PCM) samples, or with float ones where the spec asks for them;
encode the game's file again from its WAV with the codec and the bit rate that the spec names.
Source: the delivery spec, `[accept] encodings` and `bit_rate_kbps`, or the target's encoding.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "error"
LABEL = "Encoding"
IN_CATEGORIES = True
FIGURES = ()
WORDS = {"pcm": "integer (PCM)", "float": "float", "vorbis": "Vorbis", "opus": "Opus", "mp3": "MP3"}
CODECS = ("vorbis", "opus", "mp3")


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply only where the spec lists encodings, or bounds bit rates."""
    return spec.accept.encodings is not None or bool(spec.accept.bit_rate_kbps)


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `encoding:not-accepted` for another encoding than listed, `encoding:bit-rate-low` and `-high`."""
    encodings = spec.accept.encodings or ()
    encoding = file.facts.encoding
    if encodings and encoding not in encodings:
        yield Finding(
            code="encoding:not-accepted",
            message=f"{WORDS[encoding]} samples, accepted {' or '.join(WORDS[name] for name in encodings)}",
            fix=f"encode it again as {WORDS[encodings[0]]}"
            if encodings[0] in CODECS
            else f"export with {WORDS[encodings[0]]} samples",
        )
    rate_kbps, accepted = file.facts.bit_rate_kbps, spec.accept.bit_rate_kbps
    for end, limit, is_over in (("low", accepted.min, False), ("high", accepted.max, True)):
        if rate_kbps is not None and limit is not None and (rate_kbps > limit if is_over else rate_kbps < limit):
            yield Finding(
                code=f"encoding:bit-rate-{end}",
                message=f"{rate_kbps:.1f} kbit/s, at {'most' if is_over else 'least'} {limit:g} kbit/s accepted",
                fix="encode it again from its WAV with another quality",
                measured=rate_kbps,
                limit=limit,
                unit="kbit/s",
            )
