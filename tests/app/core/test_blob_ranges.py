"""Ranges of a blob: what is asked for within its bytes, and nothing that a number cannot be read from."""

import pytest

from app.core.web.blob_response import _span


@pytest.mark.parametrize(
    ("asked", "span"),
    [
        ("bytes=0-3", (0, 4)),
        ("bytes=6-", (6, 10)),
        ("bytes=-3", (7, 10)),
        ("bytes=0-999999999999999999", (0, 10)),
        ("bytes=-999999999999999999", (0, 10)),
        ("bytes=" + "9" * 5_000 + "-", None),
        ("bytes=0-" + "9" * 5_000, None),
        ("bytes=-" + "9" * 5_000, None),
        ("bytes=²-", None),
        ("bytes=5-2", None),
        ("bytes=-", None),
    ],
)
def test_a_span_lies_within_the_blob(asked: str, span: tuple[int, int] | None):
    assert _span(asked, 10) == span
