"""Text files that people write: specs and sound lists."""

from pathlib import Path

from audio_checks.errors import SpecError


def read_text(path: Path, *, fix: str = "") -> str:
    """Return the text of a UTF-8 file, without a byte order mark.

    Raises
    ------
    SpecError
        The file cannot be read, or is no UTF-8; `fix` then says how to make it so.
    """
    try:
        return path.read_text(encoding="utf-8-sig")
    except OSError as error:
        raise SpecError(f"cannot be read: {error.strerror or error}", where=str(path)) from None
    except UnicodeDecodeError:
        raise SpecError("; ".join(["is not UTF-8 text", *([fix] if fix else [])]), where=str(path)) from None
