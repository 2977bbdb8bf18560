"""The encodings that a target may have besides plain samples: their container, ending, rates and channels."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Coding:
    """How game files of one encoding are kept.

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
QUALITY = 0.5  # where a target says none
DECODED_BITS = 32  # of the float samples that a lossy codec decodes to
