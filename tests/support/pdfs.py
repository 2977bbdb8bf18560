"""What a PDF says."""

import io

from pypdf import PdfReader

BREAK_HERE = "\u200b"  # lets a long path go on in the next line


def text_of(pdf: bytes) -> str:
    """Return the words of all pages, with single spaces."""
    return " ".join(" ".join(page.extract_text() for page in PdfReader(io.BytesIO(pdf)).pages).split())


def letters_of(pdf: bytes) -> str:
    """Return the text of all pages without spaces and breaks, for words that a narrow column cuts."""
    return text_of(pdf).replace(" ", "").replace(BREAK_HERE, "")
