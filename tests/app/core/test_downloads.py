"""What an answer says of the file that it is."""

import pytest

from app.core.web.downloads import content_disposition, downloads


@pytest.mark.parametrize(
    ("file_name", "disposition"),
    [
        ("laser 01.wav", 'attachment; filename="laser 01.wav"'),
        ("Bö laser.wav", "attachment; filename=\"B_ laser.wav\"; filename*=UTF-8''B%C3%B6%20laser.wav"),
        ('a"b.wav', "attachment; filename=\"a_b.wav\"; filename*=UTF-8''a%22b.wav"),
        ("a\\b.wav", "attachment; filename=\"a_b.wav\"; filename*=UTF-8''a%5Cb.wav"),
        ("a\r\nX: y.wav", "attachment; filename=\"a__X: y.wav\"; filename*=UTF-8''a%0D%0AX%3A%20y.wav"),
    ],
)
def test_any_name_is_one_header_and_reads_back_whole(file_name: str, disposition: str) -> None:
    assert content_disposition(file_name) == disposition


def test_a_file_is_declared_by_its_types_without_parameters() -> None:
    declared = downloads(("text/csv; charset=utf-8", "application/pdf"))["responses"][200]["content"]
    assert declared == {
        "text/csv": {"schema": {"type": "string"}},
        "application/pdf": {"schema": {"type": "string", "format": "binary"}},
    }
