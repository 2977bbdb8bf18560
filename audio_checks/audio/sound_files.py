"""Opens a sound to be read as WAV, whether it is WAV, RF64 or FLAC, or what a codec keeps."""

from __future__ import annotations

import hashlib
import os
from dataclasses import dataclass
from io import FileIO
from pathlib import PurePath
from types import TracebackType
from typing import TYPE_CHECKING, BinaryIO, Self

from audio_checks import wav
from audio_checks.errors import Unreadable

if TYPE_CHECKING:
    from audio_checks.audio.coded import Coded
    from audio_checks.audio.flac import FlacLayout

FLAC_ENDING = ".flac"
CODED_ENDINGS = (".ogg", ".oga", ".opus", ".mp3")
CODED = ("container:ogg", "container:mp3")
READ_BYTES = 1 << 20


@dataclass(frozen=True)
class OpenSound:
    """A sound, open for reading.

    Attributes
    ----------
    file : binary file
        A WAV file of the sound: the file itself, or what a FLAC was unpacked to.
    layout : WavLayout
        Of `file`.
    original : binary file
        The file itself.
    flac : FlacLayout or None
        What the header of a FLAC says.
    coded : Coded or None
        What a file is that a codec keeps.
    """

    file: FileIO
    layout: wav.WavLayout
    original: BinaryIO
    flac: FlacLayout | None = None
    coded: Coded | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self.close()

    def original_sha256(self) -> str:
        """Return the SHA-256 of the file itself, in hexadecimal; reads it whole."""
        digest = hashlib.sha256()
        self.original.seek(0)
        while piece := self.original.read(READ_BYTES):
            digest.update(piece)
        return digest.hexdigest()

    def close(self) -> None:
        """Close it, and delete the file to which a FLAC was unpacked."""
        self.file.close()
        self.original.close()


def open_sound(
    path: str | os.PathLike[str], *, name: str | None = None, flac: bool = True, coded: bool = False
) -> OpenSound:
    """Open a sound and judge the structure of its header.

    Parameters
    ----------
    path : path
        A regular file.
    name : str, optional
        The file name as delivered. FLAC is read under a name in .flac; a stored file may have no ending at all.
    flac : bool
        Whether FLAC is read.
    coded : bool
        Whether Ogg Vorbis, Opus and MP3 are decoded, under names that end so, or none; see `flac`.

    Raises
    ------
    Unreadable
        When a rule of structure is broken, or a FLAC does not decode.
    SandboxFailed
        When a FLAC could not be unpacked: for want of time, memory or disk, or because its decoder broke.
    """
    original = wav.open_regular(path)
    try:
        try:
            return OpenSound(original, wav.read_layout(original), original)
        except Unreadable as refusal:
            if coded and _may_be_coded(path, name) and refusal.code in CODED:
                return _open_coded(path, original)
            if refusal.code != "container:flac" or not flac or not _may_be_flac(path, name):
                raise
        from audio_checks.audio.flac import opened_as_wav, read_layout  # loads what no WAV needs

        header = read_layout(original)
        file = opened_as_wav(path)
        try:
            return OpenSound(file, wav.read_layout(file), original, header)
        except BaseException:
            file.close()
            raise
    except BaseException:
        original.close()
        raise


def _open_coded(path: str | os.PathLike[str], original: FileIO) -> OpenSound:
    from audio_checks.audio.coded import opened_as_wav  # loads what no WAV needs

    file, coded = opened_as_wav(path)
    try:
        return OpenSound(file, wav.read_layout(file), original, coded=coded)
    except BaseException:
        file.close()
        raise


def _may_be_coded(path: str | os.PathLike[str], name: str | None) -> bool:
    ending = PurePath(os.fspath(path) if name is None else name).suffix.lower()
    return ending in CODED_ENDINGS or (name is None and not ending)


def _may_be_flac(path: str | os.PathLike[str], name: str | None) -> bool:
    ending = PurePath(os.fspath(path) if name is None else name).suffix.lower()
    return ending == FLAC_ENDING or (name is None and not ending)
