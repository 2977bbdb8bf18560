"""Text as the chunks of strangers hold it."""

from __future__ import annotations


def text_of(raw: bytes) -> str:
    """Return the text before the first zero byte, without space around it.

    Parameters
    ----------
    raw : bytes
        UTF-8, or else what Windows wrote in Western Europe; ASCII is both.

    Returns
    -------
    str
        Empty where there is none. Bytes that are not characters become U+FFFD.
    """
    text = raw.partition(b"\0")[0]
    try:
        return text.decode("utf-8").strip()
    except UnicodeDecodeError:
        return text.decode("cp1252", "replace").strip()
