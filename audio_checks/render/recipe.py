"""The treatment of a master, once its header is known."""

from dataclasses import dataclass
from typing import Literal

from numpy import float64
from numpy.typing import NDArray

from audio_checks.render.coding import Coder
from audio_checks.render.dither import Dither
from audio_checks.spec.codings import CODINGS, LOSSY_ENCODINGS
from audio_checks.spec.parts import Encoding

TOLERANCE_DB = 0.05  # as for checks: what they would let pass is not touched
MONO_LOSS_LIMIT_DB = 6.0


@dataclass(frozen=True)
class Recipe:
    """The treatment of a master, once its header is known."""

    sample_rate_hz: int
    bit_depth: int
    encoding: Encoding
    gains: NDArray[float64] | None  # from the master's channels to the file's; None leaves them
    dither: Dither
    refuse_over_peak: bool = False
    sample_peak_limit_dbfs: float | None = None
    true_peak_limit_dbtp: float | None = None
    tolerance_db: float = TOLERANCE_DB
    mono_loss_limit_db: float = MONO_LOSS_LIMIT_DB
    loop: bool | None = None  # None: what the file says
    loop_points: tuple[tuple[int, int], ...] | None = None  # None keeps the master's
    chunks: Literal["sound", "all"] = "sound"
    shelf_db: float | Literal["auto"] = 0.0
    trim_below_dbfs: float | None = None
    fade_in_ms: float = 0.0
    fade_out_ms: float = 0.0
    measures_loss: bool = True
    quality: float | None = None  # of what a lossy codec keeps

    @property
    def coder(self) -> Coder | None:
        """Return the encoder of the file; None where it is plain samples in a WAV file."""
        return Coder(self.encoding, self.quality or 0.0) if self.encoding in CODINGS else None

    @property
    def is_lossy(self) -> bool:
        """Whether a codec changes the sound."""
        return self.encoding in LOSSY_ENCODINGS

    @property
    def samples(self) -> Literal["pcm", "float"]:
        """The kind of samples that are written, or given to the encoder."""
        return "float" if self.encoding == "float" or self.is_lossy else "pcm"
