"""The names by which files find their cues: one code for server and command line."""

import re
import unicodedata
from typing import NamedTuple

from audio_checks.spec.format_suffixes import without_format_suffix

AUDIO_SUFFIXES = frozenset(
    {".wav", ".wave", ".bwf", ".rf64", ".bw64", ".w64", ".flac", ".aif", ".aiff", ".aifc", ".au", ".snd", ".caf"}
    | {".mp3", ".mp2", ".m4a", ".aac", ".wma", ".ogg", ".oga", ".opus"}
)

WORD_STARTS = re.compile(r"(?<=[a-z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])")  # in a run of letters: DoorWood, UIClick

_ALTERNATE = re.compile(r"(?<=[^_])(?:__alt([1-9][0-9]?)|__?alt([A-Z]))$")
_DRY_STEM = re.compile(r"(?<=[^_])__dry$")
_TYPED_VERSION = re.compile(r"(?<=[^_])_+[vV]([0-9]{1,4})$")


class TakeName(NamedTuple):
    """The parts of a delivered file's name: `laser_fire_02__alt2.wav` is alternate 2 of the stem `laser_fire_02`."""

    stem: str
    alternate: int | None
    typed_version: int | None
    extension: str


def parse_file_name(file_name: str) -> TakeName:
    """Return the parts of a file's name, in NFC; folders before it are dropped.

    `__alt2` and `_altB` say that it is the second alternate; a typed `_v03` is read and dropped.
    """
    whole = unicodedata.normalize("NFC", re.split(r"[/\\]", file_name)[-1])
    stem, extension = _split(whole)
    alternate = version = None
    for _ in range(2):  # the two may come in either order
        if alternate is None and (match := _ALTERNATE.search(stem)):
            alternate = int(match[1]) if match[1] else ord(match[2]) - ord("A") + 1
            stem = stem[: match.start()]
        if version is None and (match := _TYPED_VERSION.search(stem)):
            version = int(match[1])
            stem = stem[: match.start()]
    return TakeName(stem, alternate, version, extension)


def _split(whole: str) -> tuple[str, str]:
    stem, dot, ending = whole.rpartition(".")
    return (stem, dot + ending) if stem else (whole, "")


def _without_ending(name: str) -> str:
    stem, extension = _split(name)
    return stem if extension.lower() in AUDIO_SUFFIXES else name


def dry_stem_name(file_name: str) -> str | None:
    """Return the stem, in NFC, of the file that this one is the dry stem of, by its name; None for any other name.

    `warp_in__dry.wav` is that of `warp_in.wav`, and `warp_in__alt2__dry.wav` that of `warp_in__alt2.wav`.
    """
    stem = stem_of_file(file_name)
    return stem[: match.start()] if (match := _DRY_STEM.search(stem)) else None


def stem_of_file(file_name: str) -> str:
    """Return a file's name without its ending, in NFC and with all its marks; folders before it are dropped."""
    return _split(unicodedata.normalize("NFC", re.split(r"[/\\]", file_name)[-1]))[0]


def slug(name: str) -> str:
    """Return a name as a stem: lower-case letters and digits joined by `_`; empty when there is neither.

    Accents go; a name in another script keeps its letters.
    """
    plain = unicodedata.normalize("NFKD", name.replace("ß", "ss")).encode("ascii", "ignore").decode("ascii").lower()
    words = re.findall(r"[a-z0-9]+", plain) or re.findall(r"[^\W_]+", unicodedata.normalize("NFC", name).lower())
    return "_".join(words)


def word_slug(name: str) -> str:
    """Return a name as a stem with the words of CamelCase apart, and without the format that it ends in.

    It is how files are matched to cues: `DoorWoodClose-01_48k24` is `door_wood_close_01`.
    """
    decomposed = unicodedata.normalize("NFKD", without_format_suffix(unicodedata.normalize("NFC", name)))
    plain = "".join(letter for letter in decomposed if not unicodedata.combining(letter))
    words = re.sub(r"(?<=[0-9])(?=[A-Z][a-z])|(?<=[A-Za-z])(?=0[0-9]*$)", "_", WORD_STARTS.sub("_", plain))
    return slug(words)


def stems_of(name: str, file_name: str, variations: int = 1) -> list[str]:
    """Return the stems a cue owns: that of its file name (its name slugged if empty), and `_01 …` for a set.

    The ending of a sound file is part of neither. Empty when the cue has neither a file name nor a name that makes one.
    """
    stem = _without_ending(unicodedata.normalize("NFC", file_name.strip())) or slug(_without_ending(name.strip()))
    if not stem:
        return []
    if variations <= 1:
        return [stem]
    width = max(2, len(str(variations)))
    return [f"{stem}_{number:0{width}}" for number in range(1, variations + 1)]
