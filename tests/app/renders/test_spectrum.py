import io
import struct
import zlib

import numpy as np
from numpy.typing import NDArray

from app.renders.spectrum import grey_png, spectrum_png


def test_levels_become_greys() -> None:
    levels = np.array([[-np.inf, -84.0, -48.0, -12.0, 3.0]])
    assert decoded(spectrum_png(levels)).tolist() == [[0, 0, 128, 255, 255]]


def decoded(png: bytes) -> NDArray[np.uint8]:
    """Read a PNG by its specification: signature, chunks with lengths and CRCs, one filter byte a line."""
    stream = io.BytesIO(png)
    assert stream.read(8) == b"\x89PNG\r\n\x1a\n"
    chunks = {}
    while head := stream.read(8):
        length, kind = struct.unpack(">I4s", head)
        payload = stream.read(length)
        assert struct.unpack(">I", stream.read(4))[0] == zlib.crc32(kind + payload)
        chunks[kind] = payload
    width, height, depth, colour, *rest = struct.unpack(">IIBBBBB", chunks[b"IHDR"])
    assert (depth, colour, rest) == (8, 0, [0, 0, 0])
    lines = np.frombuffer(zlib.decompress(chunks[b"IDAT"]), np.uint8).reshape(height, width + 1)
    assert (lines[:, 0] == 0).all()
    return lines[:, 1:]


def test_a_png_holds_the_values_it_was_given() -> None:
    values = np.arange(256, dtype=np.uint8).reshape(16, 16)
    assert (decoded(grey_png(values)) == values).all()
