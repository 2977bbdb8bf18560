"""The compiled functions. Blocks are float64 of shape (channels, frames), each channel contiguous."""

import numpy as np
from numpy.typing import NDArray

_Block = NDArray[np.float64]

def decode_pcm(raw: bytes, container_bits: int, block: _Block, /) -> int: ...
def decode_float(raw: bytes, container_bits: int, block: _Block, /) -> int: ...
