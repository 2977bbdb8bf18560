"""PDFs are made in a child under limits: what people wrote costs the web process nothing."""

import resource
import threading

import pytest

from app.core import typesetting
from app.core.typesetting import DocumentTooLarge, TypesettingBusy, typeset
from audio_checks import Sandbox
from audio_checks.audio.sandbox import confinement_gaps


@pytest.fixture
def small_child(monkeypatch: pytest.MonkeyPatch) -> None:
    """Give the child 5 s and 400 MiB of address space, of which the interpreter takes some 200."""
    sandbox = Sandbox(timeout_s=5, memory_bytes=400 << 20, file_bytes=0, preload=("app.core.typesetting", "typst"))
    monkeypatch.setattr(typesetting, "_sandbox", lambda: sandbox)
    yield
    sandbox.close()


def test_a_document_becomes_a_pdf():
    source, inputs = "#set document(date: none)\n#sys.inputs.name", {"name": "Shield Wing"}
    pdf = typeset(source, inputs)
    assert pdf.startswith(b"%PDF-")
    assert typeset(source, inputs) == pdf, "the same source is the same bytes"


@pytest.mark.slow
@pytest.mark.usefixtures("small_child")
@pytest.mark.parametrize(
    "source",
    ["#while true {}", "#par(range(3000000).map(str).join(\" \"))", "#lorem(5000000)", "#panic()"],
    ids=["endless loop", "a text of 20 MB", "5,000,000 words", "an error"],
)  # fmt: skip
def test_a_hostile_document_is_refused_and_costs_this_process_nothing(source: str):
    before_kib = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with pytest.raises(DocumentTooLarge):
        typeset(source)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before_kib < 20 << 10
    assert typeset("After it").startswith(b"%PDF-")


@pytest.mark.slow
@pytest.mark.usefixtures("small_child")
@pytest.mark.skipif(bool(confinement_gaps()), reason="this kernel cannot confine a child: it says so at start")
def test_a_document_reads_no_file():
    with pytest.raises(DocumentTooLarge):
        typeset('#read("/etc/passwd")')


def test_more_documents_than_children_wait_and_are_refused(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(typesetting, "_free", threading.BoundedSemaphore(1))
    monkeypatch.setattr(typesetting, "MAX_WAIT_S", 0.1)
    with typesetting._free, pytest.raises(TypesettingBusy) as busy:
        typeset("Text")
    assert (busy.value.status, busy.value.retry_after_s) == (503, 5)
    assert typeset("Text").startswith(b"%PDF-")


def test_a_third_document_is_refused_at_once(monkeypatch: pytest.MonkeyPatch):
    """A document that waits keeps one of the four slots that read, which others need."""
    monkeypatch.setattr(typesetting, "_in_hand", threading.BoundedSemaphore(2))
    monkeypatch.setattr(typesetting, "MAX_WAIT_S", 60.0)
    with typesetting._in_hand, typesetting._in_hand, pytest.raises(TypesettingBusy):
        typeset("Text")
    assert typeset("Text").startswith(b"%PDF-")
