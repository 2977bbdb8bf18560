"""The delivery spec as a page: every rule of it in words, and what people wrote never as markup."""

import io
from typing import Any

import pytest
from pypdf import PdfReader

import audio_checks
from app.projects.specs import pdf as spec_pdf
from tests.support.server import World


@pytest.fixture
def content() -> dict[str, Any]:
    """Return what the page of a new spec says."""
    return spec_pdf.spec_content(audio_checks.parse_spec(audio_checks.new_spec()), title="Game", version=2)


def text_of(pdf: bytes) -> str:
    """Return what is printed, its lines joined."""
    return " ".join(" ".join(page.extract_text() for page in PdfReader(io.BytesIO(pdf)).pages).split())


def test_every_rule_is_named_with_its_unit(content: dict[str, Any]) -> None:
    rules = dict(content["rules"])
    assert rules["Sample rate"] == "44,100, 48,000 or 96,000 Hz"
    assert rules["Bit depth"] == "16 or 24 bit"
    assert rules["Length"] == "at least 0.01, at most 30 s"
    assert rules["True peak"] == "\N{MINUS SIGN}1 dBTP"
    assert rules["A warning only"] == "true peak, head silence, tail silence"


def test_a_category_says_what_differs_and_nothing_else(content: dict[str, Any]) -> None:
    categories = dict(content["categories"])
    assert categories["ambience"] == "Length: at least 0.01, at most 300 s"
    assert "ui" not in categories


def test_targets_are_named(content: dict[str, Any]) -> None:
    targets = dict(content["targets"])
    assert targets["game"] == "44,100 Hz, 16 bit, pcm, channels of the master"
    assert targets["handheld"] == "22,050 Hz, 16 bit, mono"


def test_the_page_has_each_rule_category_and_target(content: dict[str, Any]) -> None:
    said = text_of(spec_pdf.spec_pdf(audio_checks.parse_spec(audio_checks.new_spec()), title="Game", version=2))
    assert "Game, version 2" in said
    for name, value in (*content["rules"], *content["categories"], *content["targets"]):
        assert f"{name} {value}" in said


@pytest.mark.parametrize("title", ['#import "/etc/passwd"', "*bold* $x$ `", "#panic()"])
def test_a_title_is_no_markup(title: str) -> None:
    spec = audio_checks.parse_spec(audio_checks.new_spec())
    assert f"{title}, version 1" in text_of(spec_pdf.spec_pdf(spec, title=title, version=1))


@pytest.mark.parametrize("title", ["x" * 5_000, ""])
def test_the_same_spec_gives_the_same_bytes(title: str) -> None:
    spec = audio_checks.parse_spec(audio_checks.new_spec())
    made = spec_pdf.spec_pdf(spec, title=title, version=1)
    assert len(PdfReader(io.BytesIO(made)).pages) >= 1
    assert made == spec_pdf.spec_pdf(spec, title=title, version=1)


@pytest.mark.slow
def test_designer_and_team_read_it_and_a_stranger_does_not(world: World) -> None:
    url = f"/v1/projects/{world.project_id}/spec.pdf"
    for client in (world.designer, world.producer):
        answer = client.get(url)
        assert (answer.status_code, answer.headers["content-type"]) == (200, "application/pdf")
        assert "Each master" in text_of(answer.content)
    assert world.stranger.get(url).status_code == 404
