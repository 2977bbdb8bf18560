"""PDFs by Typst, in a child process under limits: what people wrote decides what a document costs."""

import threading
import unicodedata
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import cache
from importlib.util import find_spec
from typing import TYPE_CHECKING, Literal

import structlog

from app.core.errors import Refused
from audio_checks import Sandbox, SandboxFailed, SandboxTimedOut

if TYPE_CHECKING:
    import typst

TIMEOUT_S = 60.0  # the PDF of 10,000 cues takes 8 s of a processor, and 1.3 GiB of address space
MEMORY_BYTES = 3 << 29
PDF_BYTES = 64 << 20
AT_ONCE = 1  # children of one process
MAX_IN_HAND = 2  # being made, or waiting: who waits keeps one of the four slots of requests that read
MAX_WAIT_S = 20.0
FONT_PACKAGES = ("cvttf_NotoSansCJK_Regular", "fontpkg_noto_sans_arabic")  # besides the fonts that come with Typst
# Before each source, so that a letter has the same font on every page.
FONTS = """
#let serif = ("Libertinus Serif", "Noto Sans Arabic", "Noto Sans CJK TC")
#let mono = ("DejaVu Sans Mono", "Noto Sans Arabic", "Noto Sans CJK TC")
"""
# Scripts whose letters these fonts have, as Unicode names begin.
DRAWN_SCRIPTS = (
    *("LATIN", "GREEK", "CYRILLIC", "ARMENIAN", "HEBREW", "ARABIC"),
    *("CJK", "HIRAGANA", "KATAKANA", "HANGUL", "HALFWIDTH", "FULLWIDTH", "IDEOGRAPHIC", "VERTICAL", "KANGXI"),
    *("MODIFIER", "COMBINING", "MICRO", "FEMININE", "MASCULINE", "OHM", "KELVIN"),
)
FIRST_RARE_IDEOGRAPH, FIRST_EMOJI = 0x9FD1, 0x1F000
FIX = "shorten the document, or split it into several"

log = structlog.get_logger(__name__)
_free = threading.BoundedSemaphore(AT_ONCE)
_in_hand = threading.BoundedSemaphore(MAX_IN_HAND)


class DocumentTooLarge(Refused):
    """No PDF could be made of a document within the limits."""

    status = 422


class TypesettingBusy(Refused):
    """The process makes as many PDFs as it can at once."""

    status = 503
    retry_after_s = 5


def typeset(source: str, inputs: Mapping[str, str] | None = None, *, is_archival: bool = False) -> bytes:
    """Return the PDF of a Typst source; where it sets no date, the same bytes on any machine.

    The source names the fonts `serif` and `mono`.

    An archival one is PDF/A-2b, but where the fonts lack a letter of it: the standard allows no such text.

    Raises DocumentTooLarge where it takes too much time or memory, and TypesettingBusy where others wait already.
    """
    with _turn():
        return _typeset(source, inputs, is_archival=is_archival)


@contextmanager
def _turn() -> Iterator[None]:
    if not _in_hand.acquire(blocking=False):
        raise _busy()
    try:
        if not _free.acquire(timeout=MAX_WAIT_S):
            raise _busy()
        try:
            yield
        finally:
            _free.release()
    finally:
        _in_hand.release()


def _busy() -> TypesettingBusy:
    return TypesettingBusy("the server is making other PDFs; nothing was done", fix="try again in a few seconds")


def _typeset(source: str, inputs: Mapping[str, str] | None, *, is_archival: bool) -> bytes:
    try:
        return _sandbox().call(compile_archival_pdf if is_archival else compile_pdf, source, dict(inputs or {}))
    except SandboxTimedOut:
        raise DocumentTooLarge(f"the PDF takes longer than {TIMEOUT_S:g} s to make", fix=FIX) from None
    except SandboxFailed as error:  # a library that is out of memory may crash too
        log.warning("a PDF could not be made", error=str(error))
        message = f"the PDF takes more than {MEMORY_BYTES >> 20:,} MiB of memory to make"
        raise DocumentTooLarge(message, fix=FIX) from None


def undrawn_scripts(text: str) -> list[str]:
    """Return the scripts of a text that no font of PDFs is made for, in words."""
    scripts = set()
    for letter in set(text):
        name, kind = unicodedata.name(letter, ""), unicodedata.category(letter)
        if kind == "So" and ord(letter) >= FIRST_EMOJI:
            scripts.add("emoji")
        elif kind[0] not in "LM":
            continue
        elif name.startswith("CJK") and ord(letter) >= FIRST_RARE_IDEOGRAPH:
            scripts.add("rare Chinese")
        elif not name.startswith(DRAWN_SCRIPTS):
            scripts.add(name.partition(" ")[0].capitalize() or "unknown")
    return sorted(scripts)


def compile_pdf(source: str, inputs: dict[str, str]) -> bytes:
    """Run in the child, with the fonts installed with this software and no others: those of machines differ."""
    return _compile(source, inputs)


def compile_archival_pdf(source: str, inputs: dict[str, str]) -> bytes:
    """Run in the child: PDF/A-2b where the fonts have every letter, else a plain PDF."""
    import typst  # only the child's server loads it: its fonts and caches take some 50 MiB

    try:
        return _compile(source, inputs, "a-2b")
    except typst.TypstError:
        return compile_pdf(source, inputs)


def _compile(source: str, inputs: dict[str, str], standard: Literal["a-2b"] | None = None) -> bytes:
    import typst

    text = (FONTS + source).encode()
    pdf = typst.compile(text, format="pdf", sys_inputs=inputs, font_paths=load_fonts(), pdf_standards=standard)
    return bytes(pdf)


@cache
def load_fonts() -> "typst.Fonts":
    """Return the fonts; the child's server finds them once for all its children."""
    import typst

    specs = filter(None, map(find_spec, FONT_PACKAGES))
    folders = [folder for spec in specs for folder in spec.submodule_search_locations or ()]
    return typst.Fonts(include_system_fonts=False, font_paths=folders)


@cache
def _sandbox() -> Sandbox:
    return Sandbox(
        timeout_s=TIMEOUT_S,
        memory_bytes=MEMORY_BYTES,
        file_bytes=0,
        result_bytes=PDF_BYTES,
        preload=(__name__, "typst"),
        rehearsal=load_fonts,
    )
