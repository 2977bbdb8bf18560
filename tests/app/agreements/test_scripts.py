"""Names in Chinese, Japanese, Korean, Arabic and Hebrew are drawn in PDFs; scripts without a font are named."""

import io
from datetime import UTC, date, datetime
from types import SimpleNamespace
from zoneinfo import ZoneInfo

import pytest
from pypdf import PdfReader

from app.agreements.drafts.documents import archival_pdf_of, pdf_of
from app.agreements.rules import Party
from app.agreements.signing.certificates import signature_part
from app.core.typesetting import undrawn_scripts

ARCHIVAL_MARK = b"pdfaid:part"
NOTO_CJK, NOTO_ARABIC, LIBERTINUS = "NotoSansCJKtc", "NotoSansArabic", "LibertinusSerif"


def page_of(pdf: bytes) -> tuple[str, str]:
    """Return the text of the first page, and the names of its fonts."""
    [page] = PdfReader(io.BytesIO(pdf)).pages
    fonts = page["/Resources"]["/Font"].values()
    return page.extract_text(), " ".join(str(font.get_object()["/BaseFont"]) for font in fonts)


@pytest.mark.parametrize(
    ("name", "font"),
    [
        ("王小明", NOTO_CJK), ("山田やまだ", NOTO_CJK), ("김철수", NOTO_CJK), ("محمد العربي", NOTO_ARABIC),
        ("דוד כהן", LIBERTINUS),
    ],
)  # fmt: skip
def test_a_name_has_its_glyphs(name: str, font: str) -> None:
    pdf = archival_pdf_of("Contract", f"Between **{name}** and *{name}*.\n\n{name}", dated=date(2026, 12, 1))
    assert ARCHIVAL_MARK in pdf, "the standard allows no letter without a glyph"
    text, fonts = page_of(pdf)
    assert set(name) - set(" ") <= set(text)
    assert font in fonts
    assert "no font" not in text


def test_a_script_without_a_font_is_named() -> None:
    pdf = pdf_of("Contract", "Between สมชาย and 王小明.")
    assert "This PDF has no font made for Thai: such letters may show as boxes." in page_of(pdf)[0]
    signed = SimpleNamespace(
        party=Party.DESIGNER, name="สมชาย", email="a@example.test", email_proof=None, address="", agent="",
        code_entered_at=None, drawing=None, accepted_at=datetime(2026, 12, 1, tzinfo=UTC),
    )  # fmt: skip
    assert "no font made for Thai" in signature_part(signed, ZoneInfo("UTC")).markdown
    signed.name = "דוד כהן"
    assert "no font" not in signature_part(signed, ZoneInfo("UTC")).markdown


@pytest.mark.parametrize(
    ("text", "scripts"),
    [
        ("Ångström Ωμέγα Кириллица 王小明 やまだ 김철수 محمد דוד, 12 € – “x” → ✓", []),
        ("नमस्ते 😀 \U0002a6d6", ["Devanagari", "emoji", "rare Chinese"]),
    ],
)
def test_scripts_without_a_font(text: str, scripts: list[str]) -> None:
    assert undrawn_scripts(text) == scripts


def test_a_paragraph_runs_as_its_first_letter_does() -> None:
    def edges(text: str) -> list[float]:
        [page] = PdfReader(io.BytesIO(pdf_of("Contract", text))).pages
        moves = [operands for operands, operator in page.get_contents().operations if operator == b"cm"]
        return [float(move[4]) for move in moves]

    text, *_, footer, _page_number = edges("x דוד")
    assert text == footer < 100
    text, *_, footer, _page_number = edges("דוד x")
    assert footer < 100 < 400 < text
