"""The documentation key as a PDF: the same bytes for the same rows, and nothing that people wrote is markup."""

import io
from dataclasses import replace

from pypdf import PdfReader

from app.builds.packs.documentation_key import KeyRow
from app.builds.packs.key_pdf import key_pdf

BREAK_HERE = "\u200b"  # lets a long path go on in the next line
ROW = KeyRow(
    file="Assets/laser_fire_01.wav",
    cue="SW-001",
    name="Laser fire",
    category="weapon",
    variation=1,
    variations=2,
    description="bright, thin",
    use="the player's gun",
    trigger="on fire",
    loop="no",
    duration_s=0.25,
    sample_rate_hz=44_100,
    bit_depth=16,
    channels=1,
    attenuation_db=0.0,
    version=1,
    note="",
    sources="made from scratch",
    originator="Foley House",
    contract="SW contract 2",
    state="approved",
    master="laser_fire_01.wav",
    file_sha256="0" * 64,
    master_sha256="0" * 64,
)


def test_the_same_rows_are_the_same_bytes() -> None:
    made = key_pdf([ROW], title="Shield Wing, game")
    assert made.startswith(b"%PDF-")
    assert key_pdf([ROW], title="Shield Wing, game") == made
    assert key_pdf([replace(ROW, note="alternate B")], title="Shield Wing, game") != made


def test_what_people_wrote_is_text() -> None:
    hostile = '#read("/etc/passwd") #panic() $x_1$ *bold* `raw` <label> @missing // comment \\ [#] " ]'
    row = replace(ROW, name=hostile, description=hostile, note=hostile, file=hostile)
    pdf = PdfReader(io.BytesIO(key_pdf([row], title=hostile)))
    shown = "".join(page.extract_text() for page in pdf.pages)
    shown = shown.replace(BREAK_HERE, "").replace("\n", "").replace(" ", "")
    as_typed = hostile.replace(" ", "")
    assert shown.count(as_typed) == 6, "the title and the footer; the file, the name, the description, the note"


def test_an_empty_key_and_a_sound_without_a_file_are_valid() -> None:
    bare = replace(ROW, file="", duration_s=None, sample_rate_hz=None, bit_depth=None, channels=None, note="refused")
    assert key_pdf([], title="t") != key_pdf([bare], title="t")
