"""A valid name, made from the one that a file has."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import PurePath
from typing import TYPE_CHECKING, cast

from audio_checks.checks import naming
from audio_checks.spec.delivery_spec import DeliverySpec
from audio_checks.spec.format_suffixes import without_format_suffix
from audio_checks.spec.sound_names import parse_file_name, slug, word_slug

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

WAV_ENDINGS = frozenset({".wav", ".wave", ".bwf", ".rf64"})  # of one kind of file, under several names


def valid_name(name: str, spec: DeliverySpec) -> str | None:
    """Return the name that the naming check of a spec passes and that is nearest to the one given.

    Parameters
    ----------
    name : str
        A file's name, without folders.
    spec : DeliverySpec
        The view that the file is judged by.

    Returns
    -------
    str or None
        The name itself where it is valid; None where none can be made of its letters and digits.
        The mark of an alternate is kept, except in renders, whose names carry none; a typed version
        goes, for versions are counted by the server.
    """
    if _is_valid(name, spec):
        return name
    return next((candidate for candidate in _candidates(name, spec) if _is_valid(candidate, spec)), None)


@dataclass(frozen=True)
class _Named:
    """All of a file that its naming check reads."""

    name: str

    @property
    def stem(self) -> str:
        return PurePath(self.name).stem


def _is_valid(name: str, spec: DeliverySpec) -> bool:
    findings = naming.check(cast("AudioFile", _Named(name)), spec)
    return next(iter(findings), None) is None


def _candidates(name: str, spec: DeliverySpec) -> Iterator[str]:
    stem, alternate, _, extension = parse_file_name(name)
    wanted_extension = spec.naming.extension
    is_wav = wanted_extension is not None and {wanted_extension.lower(), extension.lower()} <= WAV_ENDINGS
    ending = (
        wanted_extension
        if wanted_extension is not None and (is_wav or wanted_extension.lower() == extension.lower())
        else extension
    )
    mark = f"__alt{alternate}" if alternate is not None and spec.target is None else ""
    lower = word_slug(stem)
    joined = "_".join(re.findall(r"[A-Za-z0-9]+", without_format_suffix(stem)))
    for made in dict.fromkeys((stem, lower, joined, lower.upper(), lower.replace("_", "-"), slug(stem))):
        if made:
            yield f"{made}{mark}{ending}"
