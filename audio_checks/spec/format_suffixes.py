"""Parts of names that say how a file was exported, not what it is: `48k24`, `44.1_16`, `32bit_float`, `5.1`."""

import re

_RATE_K = r"(?:8|11|12|16|22|24|32|44[._]?1|44|48|88[._]?2|88|96|176[._]?4|176|192)\s?k(?:hz)?"
_RATE_HZ = r"(?:8000|11025|16000|22050|24000|32000|44100|48000|88200|96000|176400|192000)(?:\s?hz)?"
_RATE_BARE = r"(?:44[._]?1|44|48|88[._]?2|88|96|192)"
_DEPTH_BARE = r"(?:16|24|32)"
_FLOAT = r"[-_ .]?(?:float|fp|int|pcm)"
_DEPTH_WITH_UNIT = rf"(?:8|16|20|24|32|64)(?:[-_ ]?bits?(?:{_FLOAT})?|b(?:f|it)?|fp?|{_FLOAT})"
_DEPTH = rf"(?:{_DEPTH_WITH_UNIT}|{_DEPTH_BARE})"
_JOIN = r"[-_ .x]?"
_PATTERNS = tuple(
    re.compile(rf"(?<![0-9]){before}(?:{pattern})(?![0-9a-z])", re.IGNORECASE)
    for before, pattern in (
        ("", rf"{_RATE_K}(?:{_JOIN}{_DEPTH})?"),
        ("", rf"{_RATE_HZ}(?:{_JOIN}{_DEPTH})?"),
        ("", rf"{_DEPTH_WITH_UNIT}{_JOIN}(?:{_RATE_K}|{_RATE_HZ}|{_RATE_BARE})"),
        ("(?<![a-z])", rf"{_DEPTH_BARE}[-_x]?(?:{_RATE_K}|{_RATE_BARE})"),
        ("(?<![a-z])", rf"{_RATE_BARE}{_JOIN}{_DEPTH}"),
        ("(?<![a-z])", _DEPTH_WITH_UNIT),
        ("(?<![a-z])", r"l?pcm[-_ ]?(?:[suf]?(?:16|24|32)(?:le|be)?)?|[suf](?:16|24|32)(?:le|be)|f(?:32|64)"),
        ("(?<![a-z.])", r"[57]\.1(?:\.[24])?"),
    )
)


def format_spans(stem: str) -> list[tuple[int, int]]:
    """Return the places of a sample rate, a bit depth or a layout of channels in a name without its ending.

    A bare number counts only as a rate in Hz (`48000`), or as a rate beside a depth (`48_24`, `4416`).
    """
    spans: list[tuple[int, int]] = []
    for pattern in _PATTERNS:
        for match in pattern.finditer(stem):
            start, end = match.span()
            if not any(start < other_end and other_start < end for other_start, other_end in spans):
                spans.append((start, end))
    return sorted(spans)


def without_format_suffix(stem: str) -> str:
    """Return a name without the format that it ends in; unchanged where nothing else is left."""
    spans = format_spans(stem)
    if spans and not stem[spans[-1][1] :].strip("-_ .)]"):
        bare = stem[: spans[-1][0]].rstrip("-_ .([")
        if any(letter.isalpha() for letter in bare):
            return without_format_suffix(bare)
    return stem
