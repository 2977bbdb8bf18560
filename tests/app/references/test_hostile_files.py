"""What strangers send: known by its bytes, drawn only in a child, and sent so that nothing in it runs."""

import io
import zlib
from typing import Any

import pytest
from PIL import Image

from app.references import drawing, jobs
from audio_checks import Sandbox
from tests.support.references import added, board, opened, picture, png
from tests.support.server import World
from tests.support.waves import sine, wav_bytes

WAV = wav_bytes(sine(hz=440, seconds=0.1), rate=48_000, bits=16)
SVG = b'<svg xmlns="http://www.w3.org/2000/svg"><script>alert(1)</script></svg>'
HTML = b"<!doctype html><script>fetch('/v1/me')</script>"
PDF = b"%PDF-1.7\n1 0 obj<</OpenAction<</S/JavaScript/JS(app.alert(1))>>>>endobj\n%%EOF"


def shown(world: World, reference: dict[str, Any]) -> dict[str, Any]:
    world.server.wait_for_jobs()
    [found] = [one for one in board(world) if one["id"] == reference["id"]]
    return dict(found["version"])


def decoded(content: bytes) -> Image.Image:
    return Image.open(io.BytesIO(content))


@pytest.mark.slow
@pytest.mark.parametrize("form", ["PNG", "JPEG", "GIF", "WEBP"])
def test_a_picture_is_drawn_again_at_two_sizes(world: World, form: str) -> None:
    reference = added(world, "no ending", picture(form, (2_000, 1_000)))
    assert reference["version"]["preview"] == "pending"
    version = shown(world, reference)
    assert (version["preview"], version["problem"]) == ("made", "")
    assert (version["width_px"], version["height_px"]) == (2_000, 1_000)
    view = opened(world, reference, "view", world.designer)
    thumb = world.designer.get(f"/v1/reference-versions/{version['id']}/thumb")
    for answer, size in ((view, (1_600, 800)), (thumb, (480, 240))):
        assert (answer.status_code, answer.headers["content-type"]) == (200, "image/webp")
        assert answer.headers["x-content-type-options"] == "nosniff"
        assert answer.headers["content-security-policy"] == "default-src 'none'; sandbox"
        assert (decoded(answer.content).format, decoded(answer.content).size) == ("WEBP", size)
    red, green, blue = decoded(view.content).convert("RGB").getpixel((10, 10))
    assert red > 180 > 90 > green > blue


@pytest.mark.slow
def test_a_small_picture_keeps_its_size(world: World) -> None:
    reference = added(world, "a.png", png(3, 2))
    shown(world, reference)
    assert decoded(opened(world, reference, "view").content).size == (3, 2)


@pytest.mark.slow
def test_a_picture_stands_as_its_camera_held_it_and_carries_nothing_else(world: World) -> None:
    exif = Image.Exif()
    exif[0x0112], exif[0x010E] = 6, "taken at home"  # turned by a quarter; a description
    reference = added(world, "a.jpg", picture("JPEG", (40, 30), exif=exif))
    shown(world, reference)
    view = opened(world, reference, "view").content
    assert decoded(view).size == (30, 40)
    assert b"taken at home" not in view


@pytest.mark.slow
def test_transparency_and_16_bits_of_grey_survive(world: World) -> None:
    out = io.BytesIO()
    Image.new("RGBA", (4, 4), (255, 0, 0, 0)).save(out, "PNG")
    clear = added(world, "clear.png", out.getvalue())
    deep = io.BytesIO()
    Image.new("I;16", (4, 4), 0x8000).save(deep, "PNG")
    grey = added(world, "grey.png", deep.getvalue())
    shown(world, grey)
    assert decoded(opened(world, clear, "view").content).convert("RGBA").getpixel((1, 1))[3] == 0
    assert abs(decoded(opened(world, grey, "view").content).convert("L").getpixel((1, 1)) - 128) <= 2


@pytest.mark.slow
@pytest.mark.parametrize(("width", "height"), [(60_000, 60_000), (30_001, 1), (8_001, 8_000)])
def test_a_picture_of_too_many_pixels_is_refused_in_words_and_kept_for_download(
    world: World, width: int, height: int
) -> None:
    bomb = png(width, height, bytes(1_000))
    reference = added(world, "bomb.png", bomb)
    version = shown(world, reference)
    assert version["preview"] == "refused"
    assert version["problem"] == (
        f"this picture has {width:,} × {height:,} pixels; at most 64,000,000 are drawn, and 30,000 on a side"
    )
    for part in ("view", "thumb"):
        answer = opened(world, reference, part)
        assert (answer.status_code, answer.json()["code"]) == (404, "no-preview")
    file = opened(world, reference)
    assert (file.content, file.headers["content-disposition"]) == (bomb, 'attachment; filename="bomb.png"')


@pytest.mark.parametrize(
    "content",
    [
        png(40, 30)[:45],
        png(40, 30, b"\7" * 9),
        b"\x89PNG\r\n\x1a\n" + bytes(100),
        b"\xff\xd8\xff" + bytes(100),
        b"GIF89a" + b"\xff" * 100,
        b"RIFF\x64\0\0\0WEBP" + bytes(92),
        picture("JPEG", (400, 300))[:700],
        zlib.compress(b"") + b"\xff\xd8\xff",
    ],
)
def test_a_damaged_picture_is_no_picture(world: World, content: bytes) -> None:
    version = shown(world, added(world, "a.png", content))
    if version["kind"] == "picture":
        assert (version["preview"], version["problem"]) == (
            "refused",
            "this picture is damaged: its pixels cannot be read",
        )
    else:
        assert version["kind"] == "file"


@pytest.mark.slow
def test_what_takes_too_much_to_draw_says_so(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    cramped = Sandbox(memory_bytes=1 << 20, preload=(drawing.__name__,))
    monkeypatch.setattr(jobs, "_sandbox", lambda: cramped)
    version = shown(world, added(world, "a.png", picture("PNG")))
    cramped.close()
    assert version["preview"] == "refused"
    assert version["problem"] == "this picture takes more than 30 s or 1,024 MiB to draw"


def test_a_second_run_of_the_job_changes_nothing(world: World) -> None:
    reference = added(world, "a.png", picture("PNG"))
    before = shown(world, reference)
    jobs.draw_preview(world.server.runtime, {"version_id": before["id"]})
    assert shown(world, reference) == before


def test_a_sound_that_is_named_as_a_picture_is_a_sound(world: World) -> None:
    reference = added(world, "splash.png", WAV)
    version = shown(world, reference)
    assert (version["kind"], version["media_type"], version["preview"]) == ("audio", "audio/wav", "none")
    answer = opened(world, reference)
    assert (answer.headers["content-type"], answer.headers["x-content-type-options"]) == ("audio/wav", "nosniff")


@pytest.mark.parametrize(
    ("name", "content", "kind", "media_type"),
    [
        ("logo.svg", SVG, "file", "application/octet-stream"),
        ("logo.png", SVG, "file", "application/octet-stream"),
        ("page.txt", HTML, "file", "application/octet-stream"),
        ("story.pdf", PDF, "pdf", "application/pdf"),
        ("build.exe", b"MZ\x90\0" + bytes(60), "file", "application/octet-stream"),
    ],
)
def test_what_might_run_is_kept_for_download_only(
    world: World, name: str, content: bytes, kind: str, media_type: str
) -> None:
    reference = added(world, name, content)
    version = shown(world, reference)
    assert (version["kind"], version["excerpt"], version["preview"]) == (kind, "", "none")
    answer = opened(world, reference, by=world.designer)
    assert answer.content == content
    assert answer.headers["content-type"] == media_type
    assert answer.headers["content-disposition"] == f'attachment; filename="{name}"'
    assert answer.headers["x-content-type-options"] == "nosniff"
    assert answer.headers["content-security-policy"] == "default-src 'none'; sandbox"


@pytest.mark.slow
def test_the_original_of_a_picture_is_kept_for_download(world: World) -> None:
    polyglot = picture("JPEG") + HTML
    reference = added(world, "a.jpg", polyglot)
    answer = opened(world, reference)
    assert answer.content == polyglot
    assert answer.headers["content-disposition"].startswith("attachment")
    shown(world, reference)
    assert b"script" not in opened(world, reference, "view").content


def test_a_text_is_shown_as_text(world: World) -> None:
    reference = added(world, "story.md", b"Gischt & <b>Wind</b>")
    answer = opened(world, reference)
    assert answer.headers["content-type"] == "text/plain; charset=utf-8"
    assert "content-disposition" not in answer.headers
    assert answer.headers["content-security-policy"] == "default-src 'none'; sandbox"
    kept = world.producer.get(f"/v1/reference-versions/{reference['version']['id']}/file?download=true")
    assert kept.headers["content-disposition"] == 'attachment; filename="story.md"'


def test_a_clip_comes_in_ranges_as_it_came(world: World) -> None:
    clip = b"\0\0\0\x18ftypisom\0\0\2\0isomiso2" + bytes(range(256)) * 8
    reference = added(world, "walkway.mp4", clip)
    assert reference["version"]["media_type"] == "video/mp4"
    assert opened(world, reference).content == clip
    url = f"/v1/reference-versions/{reference['version']['id']}/file"
    part = world.producer.get(url, headers={"Range": "bytes=100-199"})
    assert (part.status_code, part.content) == (206, clip[100:200])
    assert part.headers["content-range"] == f"bytes 100-199/{len(clip)}"
    assert part.headers["cache-control"] == "private, no-cache"
    assert world.producer.get(url, headers={"Range": f"bytes={len(clip)}-"}).status_code == 416
