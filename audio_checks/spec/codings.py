"""The encodings that a target may have besides plain samples: their container, ending, rates and channels."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Coding:
    """The storage of game files of one encoding.

    Attributes
    ----------
    label : str
        Its name in sentences.
    container, ending : str
        What `check` finds ("ogg", "flac"), and what file names end in.
    is_lossy : bool
        Whether the codec changes the sound. Then a file has a quality and no bit depth.
    lowest_hz, highest_hz : int
        Sample rates that are made.
    most_channels : int
        Ogg orders more than two channels in another way than WAV, and engines do not agree on it.
    """

    label: str
    container: str
    ending: str
    is_lossy: bool
    lowest_hz: int
    highest_hz: int
    most_channels: int


CODINGS = {
    "vorbis": Coding("Ogg Vorbis", "ogg", ".ogg", True, 8_000, 192_000, 2),  # above, libvorbis has no settings
    "opus": Coding("Opus", "ogg", ".opus", True, 48_000, 48_000, 2),  # what every decoder plays it at
    "flac": Coding("FLAC", "flac", ".flac", False, 1_000, 655_350, 8),
}
LOSSY_ENCODINGS = tuple(name for name, coding in CODINGS.items() if coding.is_lossy)
MP3 = "mp3"  # read and handed on, never made
QUALITY = 0.5  # where a target says none
DECODED_BITS = 32  # of the float samples that a lossy codec decodes to


def label_of(encoding: str) -> str:
    """Return the name of an encoding in sentences."""
    return CODINGS[encoding].label if encoding in CODINGS else encoding.upper()


def ending_of(encoding: str) -> str:
    """Return the ending of names of game files of an encoding."""
    if encoding == MP3:
        return ".mp3"
    return CODINGS[encoding].ending if encoding in CODINGS else ".wav"


def is_lossy(encoding: str) -> bool:
    """Whether a codec changes the sound of files of an encoding."""
    return encoding == MP3 or encoding in LOSSY_ENCODINGS
