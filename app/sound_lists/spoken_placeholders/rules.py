"""Work in the child that parses: a recording of a stranger, made into the sound of a placeholder."""

from app.sound_lists.errors import RecordingInvalid
from audio_checks import RenderRefused, Unreadable, tidy_recording


def read_said(content: bytes) -> tuple[bytes, float]:
    """Return a recording trimmed, at one level, with its length; raise RecordingInvalid where that cannot be."""
    try:
        return tidy_recording(content)
    except (Unreadable, RenderRefused) as error:
        raise RecordingInvalid(str(error), fix=error.fix) from None
