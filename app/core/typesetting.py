"""PDFs by Typst, in a child process under limits: what people wrote decides what a document costs."""

import threading
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import cache

import structlog

from app.core.errors import Refused
from audio_checks import Sandbox, SandboxFailed, SandboxTimedOut

TIMEOUT_S = 60.0  # the PDF of 10,000 cues takes 8 s of a processor, and 1.3 GiB of address space
MEMORY_BYTES = 3 << 29
PDF_BYTES = 64 << 20
AT_ONCE = 1  # children of one process
MAX_IN_HAND = 2  # being made, or waiting: who waits keeps one of the four slots of requests that read
MAX_WAIT_S = 20.0
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


def compile_pdf(source: str, inputs: dict[str, str]) -> bytes:
    """Run in the child, with the fonts that come with Typst and no others: those of machines differ."""
    import typst  # only the child's server loads it: its fonts and caches take some 50 MiB

    return bytes(typst.compile(source.encode(), format="pdf", sys_inputs=inputs, ignore_system_fonts=True))


def compile_archival_pdf(source: str, inputs: dict[str, str]) -> bytes:
    """Run in the child: PDF/A-2b where the fonts have every letter, else a plain PDF."""
    import typst

    try:
        return bytes(
            typst.compile(
                source.encode(), format="pdf", sys_inputs=inputs, ignore_system_fonts=True, pdf_standards="a-2b"
            )
        )
    except typst.TypstError:
        return compile_pdf(source, inputs)


@cache
def _sandbox() -> Sandbox:
    return Sandbox(
        timeout_s=TIMEOUT_S,
        memory_bytes=MEMORY_BYTES,
        file_bytes=0,
        result_bytes=PDF_BYTES,
        preload=(__name__, "typst"),
    )
