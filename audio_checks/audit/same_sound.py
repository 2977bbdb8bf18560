"""Whether two fingerprints are of the same sound, and what was changed between them."""

from __future__ import annotations

from dataclasses import dataclass, replace

from audio_checks.audit.fingerprint import RATE_HZ, wave_of
from audio_checks.audit.fingerprinted import fingerprint_file
from audio_checks.audit.likeness import Waves, likeness
from audio_checks.audit.manifest import parse_manifest
from audio_checks.audit.moments import candidates, moments_of
from audio_checks.errors import Unreadable

TRIMMED_S = 0.005  # as `audit` says it


@dataclass(frozen=True)
class SoundSignature:
    """A file's marks of recognition.

    Attributes
    ----------
    pcm_sha256 : str
        Of its samples.
    sample_rate_hz : int
        Frames per second.
    fingerprint : bytes or None
        See `audio_checks.audit.fingerprint`; None for silence, and where there is next to nothing in its band.
    moments : bytes
        Its loudest moments, for finding it among thousands; empty without a fingerprint.
    """

    pcm_sha256: str
    sample_rate_hz: int
    fingerprint: bytes | None
    moments: bytes


@dataclass(frozen=True)
class Difference:
    """The difference of one sound from another that holds the same.

    Attributes
    ----------
    score : float
        0..1: how the two waves agree.
    gain_db : float
        By how much the second is louder, over the part that both have.
    is_trimmed : bool
        One of them begins or ends 5 ms or more from where the other does.
    """

    score: float
    gain_db: float
    is_trimmed: bool


def sound_signature(path: str) -> SoundSignature:
    """Return a file's marks of recognition; Unreadable where it cannot be read.

    Parameters
    ----------
    path : str
        Any file that `audit` reads.
    """
    fingerprinted = fingerprint_file(path, path)
    if fingerprinted.trouble or fingerprinted.pcm_sha256 is None:
        raise Unreadable(fingerprinted.trouble, "R1", "recognise:unreadable", "deliver it as WAV or FLAC")
    moments = moments_of(wave_of(fingerprinted.fingerprint)) if fingerprinted.fingerprint else b""
    return SoundSignature(fingerprinted.pcm_sha256, fingerprinted.sample_rate_hz, fingerprinted.fingerprint, moments)


def sounds_of_manifest(text: str) -> list[tuple[str, SoundSignature]]:
    """Return path and recognisable facts of each sound of a manifest; SpecError where it is none.

    Parameters
    ----------
    text : str
        All of a file that `audio-checks manifest` wrote. Sounds without a fingerprint, and those too short to be found
        among others, are left out.
    """
    files = [(file, file.fingerprint) for file in parse_manifest(text) if file.fingerprint is not None]
    fingerprinted = [(file, packed, moments_of(wave_of(packed))) for file, packed in files]
    return [
        (file.path, SoundSignature(file.pcm_sha256 or "", file.sample_rate_hz, packed, moments))
        for file, packed, moments in fingerprinted
        if moments
    ]


def likely_sounds(fingerprint: bytes, moments: list[bytes]) -> list[int]:
    """Return the places of the sounds that are worth comparing with a fingerprint, the likeliest first.

    Parameters
    ----------
    fingerprint : bytes
        Of the sound that is looked for.
    moments : list of bytes
        Of the others; none of them empty.
    """
    return candidates(wave_of(fingerprint), moments)


def difference_of(first: bytes, second: bytes) -> Difference | None:
    """Return the difference of two fingerprints of the same sound; None if they are of different sounds.

    Parameters
    ----------
    first, second : bytes
        Either may be the longer one.
    """
    first_waves, other = Waves(first), Waves(second)
    if (difference := _match_within(first_waves, other)) is not None:
        return difference
    turned = _match_within(
        other, first_waves
    )  # a cut may take the loudest part, so the length does not say which is the whole one
    return None if turned is None else replace(turned, gain_db=-turned.gain_db)


def _match_within(whole: Waves, part: Waves) -> Difference | None:
    like = likeness(whole, part)
    if like is None or not like.is_same_sound:
        return None
    after_s = (len(whole.wave) - len(part.wave)) / RATE_HZ - like.offset_s
    is_trimmed = max(abs(like.offset_s), abs(after_s)) >= TRIMMED_S
    return Difference(round(like.score, 3), round(like.gain_db, 1), is_trimmed)
