"""Types by bytes, addresses, and ranges."""

import pytest

from app.references.errors import ReferenceInvalid
from app.references.rules import HEAD_BYTES, ReferenceKind, ensure_range, host_of, text_in, type_of

MP4 = b"\0\0\0\x18ftyp"
TYPES = [
    (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", "picture", "image/png"),
    (b"\xff\xd8\xff\xe0\0\x10JFIF", "picture", "image/jpeg"),
    (b"GIF89a\1\0\1\0", "picture", "image/gif"),
    (b"RIFF\x10\0\0\0WEBPVP8 ", "picture", "image/webp"),
    (b"%PDF-1.7\n%\xe2\xe3", "pdf", "application/pdf"),
    (b"RIFF\x10\0\0\0WAVEfmt ", "audio", "audio/wav"),
    (b"RF64\xff\xff\xff\xffWAVEds64", "audio", "audio/wav"),
    (b"fLaC\0\0\0\x22", "audio", "audio/flac"),
    (b"OggS\0\2" + bytes(22) + b"\1vorbis", "audio", "audio/ogg"),
    (b"ID3\4\0\0\0\0\0\0", "audio", "audio/mpeg"),
    (b"\xff\xfb\x90\x44\0", "audio", "audio/mpeg"),
    (MP4 + b"M4A \0\0\0\0", "audio", "audio/mp4"),
    (MP4 + b"isom\0\0\2\0", "video", "video/mp4"),
    (MP4 + b"qt  \0\0\2\0", "video", "video/quicktime"),
    (b"\x1a\x45\xdf\xa3\x9fB\x86\x81\1B\xf7\x81\1B\xf2\x81\4B\xf3\x81\x08B\x82\x84webm", "video", "video/webm"),
    ("A wet splash — deep, short.\n".encode(), "text", "text/plain; charset=utf-8"),
    (b"\xef\xbb\xbfWith a mark", "text", "text/plain; charset=utf-8"),
]
UNKNOWN = [
    b"",
    b"   \n",
    b"\0\1\2\3",
    b"PK\3\4",
    b"MZ\x90\0",
    b"RIFF\x10\0\0\0AVI LIST",
    MP4 + b"avif\0\0\0\0",
    b"OggS\0\2" + bytes(22) + b"\x80theora",
    b"\x1a\x45\xdf\xa3\x9fB\x82\x88matroska",
    b"\xff\xfe\x41\0",  # UTF-16, which looks like a frame of MPEG audio, layer I
    b"\xff\xfb\xf0\x44",  # a bit rate that there is not
    "caf\u00e9".encode("latin-1"),
    b'<svg xmlns="http://www.w3.org/2000/svg"><script>alert(1)</script></svg>',
    b"<!DOCTYPE html><p>hello",
    b"plain at first\n<script>alert(1)</script>",
    b'<?xml version="1.0"?><a/>',
]


@pytest.mark.parametrize(("head", "kind", "media_type"), TYPES)
def test_the_bytes_say_what_a_file_is(head: bytes, kind: str, media_type: str):
    found = type_of(head)
    assert (found.kind.value, found.media_type) == (kind, media_type)


@pytest.mark.parametrize("head", UNKNOWN)
def test_what_is_not_known_or_might_run_is_for_download(head: bytes):
    assert (type_of(head).kind, type_of(head).media_type) == (ReferenceKind.FILE, "application/octet-stream")


def test_a_text_may_be_cut_inside_a_character():
    head = ("x" * (HEAD_BYTES - 1) + "é").encode()[:HEAD_BYTES]
    assert type_of(head).kind is ReferenceKind.TEXT
    assert text_in(head) == "x" * (HEAD_BYTES - 1)


@pytest.mark.parametrize(
    ("url", "host"),
    [
        ("https://example.test/a?b=1#c", "example.test"),
        ("https://EXAMPLE.test", "example.test"),
        ("https://example.test:443/", "example.test"),
        ("https://example.test:8443/", "example.test:8443"),
        ("https://b\u00fccher.test/", "xn--bcher-kva.test"),
    ],
)
def test_a_link_is_shown_by_its_host(url: str, host: str):
    assert host_of(url) == host


@pytest.mark.parametrize(
    "url",
    [
        "http://example.test/",
        "javascript:alert(1)",
        "data:text/html,x",
        "https://",
        "https:///path",
        "//example.test/",
        "example.test",
        "https://example.test/a b",
        "https://example.test\\@evil.test/",
        "https://user:secret@example.test/",
        "https://example.test@evil.test/",
        "https://example.test:port/",
        "https://[::1/",
        "https://example.test/" + "x" * 2_000,
        "https://" + "\u00fc" * 80 + ".test/",
        "",
    ],
)
def test_what_is_no_plain_https_address_is_refused(url: str):
    with pytest.raises(ReferenceInvalid) as refused:
        host_of(url)
    assert refused.value.errors[0]["where"] == "url"


@pytest.mark.parametrize("kind", [ReferenceKind.AUDIO, ReferenceKind.VIDEO, ReferenceKind.LINK])
def test_a_part_of_what_plays_has_a_beginning_and_perhaps_an_end(kind: ReferenceKind):
    ensure_range(kind, None, None)
    ensure_range(kind, 0.0, None)
    ensure_range(kind, 41.2, 43.0)
    for start_s, end_s, where in ((None, 1.0, "start_s"), (1.0, 1.0, "end_s"), (2.0, 1.0, "end_s")):
        with pytest.raises(ReferenceInvalid) as refused:
            ensure_range(kind, start_s, end_s)
        assert refused.value.errors[0]["where"] == where


@pytest.mark.parametrize("kind", [ReferenceKind.PICTURE, ReferenceKind.PDF, ReferenceKind.TEXT, ReferenceKind.FILE])
def test_what_does_not_play_has_no_part(kind: ReferenceKind):
    ensure_range(kind, None, None)
    with pytest.raises(ReferenceInvalid):
        ensure_range(kind, 0.0, 1.0)
