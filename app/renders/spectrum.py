"""A sound's spectrum over time as a small grey picture.

White is a tone of −12 dBFS or more, black 72 dB below; rows run from 20 kHz at the top to 60 Hz at
the bottom in equal steps of pitch.
"""

import struct
import zlib

import numpy as np
from numpy.typing import NDArray

WHITE_DBFS = -12.0
RANGE_DB = 72.0
PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"


def spectrum_png(levels_dbfs: NDArray[np.float64]) -> bytes:
    """Return the picture of levels, shape (rows, columns); −inf is black."""
    grey = np.clip((levels_dbfs - WHITE_DBFS + RANGE_DB) / RANGE_DB, 0, 1) * 255
    return grey_png(np.rint(grey).astype(np.uint8))


def grey_png(values: NDArray[np.uint8]) -> bytes:
    """Return an 8-bit grey PNG of values, shape (height, width)."""
    height, width = values.shape
    lines = np.hstack([np.zeros((height, 1), dtype=np.uint8), values])  # each line begins with its filter, none
    return b"".join(
        [
            PNG_SIGNATURE,
            _png_chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)),
            _png_chunk(b"IDAT", zlib.compress(lines.tobytes(), 1)),
            _png_chunk(b"IEND", b""),
        ]
    )


def _png_chunk(kind: bytes, payload: bytes) -> bytes:
    return struct.pack(">I", len(payload)) + kind + payload + struct.pack(">I", zlib.crc32(kind + payload))
