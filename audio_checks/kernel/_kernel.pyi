"""The compiled functions. Blocks are float64 of shape (channels, frames), each channel contiguous."""

import numpy as np
from numpy.typing import NDArray

_Block = NDArray[np.float64]

def decode_pcm(raw: bytes, container_bits: int, block: _Block, /) -> int: ...
def decode_float(raw: bytes, container_bits: int, block: _Block, /) -> int: ...
def convert(
    stream: _Block,
    out: _Block,
    response: NDArray[np.float64],
    turns_in: NDArray[np.float64],
    turns_out: NDArray[np.float64],
    hop_in: int,
    hop_out: int,
    edge_out: int,
    /,
) -> None: ...
def fourier(real: _Block, imaginary: _Block, turns: NDArray[np.float64], /) -> None: ...
def hush(stream: _Block, out: _Block, first: NDArray[np.int64], last: NDArray[np.int64], /) -> None: ...
