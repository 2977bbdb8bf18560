"""Text as the chunks of strangers hold it."""

from __future__ import annotations


def text_of(raw: bytes, *, is_fixed: bool = False) -> str:
    """Return the text before the first zero byte, without space around it.

    Parameters
    ----------
    raw : bytes
        UTF-8, or else what Windows wrote in Western Europe; ASCII is both.
    is_fixed : bool
        The field has no room for more: a writer may have cut the text, and in UTF-8 its last letter with it.

    Returns
    -------
    str
        Empty where there is none. Bytes that are not characters become U+FFFD; a letter that was cut is left out.
    """
    text = raw.partition(b"\0")[0]
    try:
        return text.decode("utf-8").strip()
    except UnicodeDecodeError as error:
        whole = text[: error.start]
        is_full = is_fixed and len(text) >= len(raw) - 1  # with or without a zero at the end
        if error.reason == "unexpected end of data" and (is_full or not whole.isascii()):
            return whole.decode("utf-8").strip()
        return text.decode("cp1252", "replace").strip()
