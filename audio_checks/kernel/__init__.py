"""The hot loops of measuring, compiled from the C files beside this one.

Every function has a plain numpy reference in `tests/audio_checks/kernel`, which holds it to the same
answers. Blocks are float64 of shape (channels, frames), each channel contiguous, full scale ±1.0.
"""

try:
    from audio_checks.kernel._kernel import convert, decode_float, decode_pcm, fourier, hush
except ImportError as error:
    raise ImportError(
        f"the compiled part of audio-checks cannot be loaded ({error}): it is missing, or older than the rest;"
        " install audio-checks again where there is a C compiler (in a checkout: make setup)"
    ) from error

__all__ = ["convert", "decode_float", "decode_pcm", "fourier", "hush"]
