"""The key that identifies a game file of a master."""

import hashlib
import json

from audio_checks.render.coding import CODER_VERSION
from audio_checks.render.work import RENDERER_VERSION
from audio_checks.spec.delivery_spec import Target

NO_PART_OF_A_FILE = ("name", "budget_bytes", "codec_ratio", "streamed", "stream_buffer_bytes", "folder")


def render_key(
    master_sha256: str,
    target: Target,
    *,
    loop: bool | None,
    loop_points: tuple[int, int] | None = None,
    sample_peak_limit_dbfs: float | None,
    true_peak_limit_dbtp: float | None,
    tolerance_db: float,
) -> str:
    """Return the key of a render: the same key means the same bytes, and another key another file.

    Of what a lossy codec keeps, the same bytes as far as machine and libsndfile are the same.

    A file is never replaced by one of another key. The arguments are those of `render_master`; loop
    points in the master are part of it, so its hash covers them.

    Returns
    -------
    str
        64 hexadecimal digits. A target's name and memory settings do not change the key.
    """
    how = {key: value for key, value in vars(target).items() if key not in NO_PART_OF_A_FILE}
    coded = [] if target.coding is None else [CODER_VERSION]
    if not target.is_lossy:
        del how["quality"]
    if not target.keep_coded:  # as keys were before targets could say it
        del how["keep_coded"]
    limits = [sample_peak_limit_dbfs, true_peak_limit_dbtp, tolerance_db]
    facts = [master_sha256, RENDERER_VERSION, how, loop, loop_points, limits, *coded]
    return hashlib.sha256(json.dumps(facts, sort_keys=True).encode()).hexdigest()
