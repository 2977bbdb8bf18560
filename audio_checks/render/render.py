"""A game file from a master: one stream from the master's bytes to the file's, measured as it is written."""

import math
import os
from contextlib import suppress
from pathlib import Path

from audio_checks.audio.sound_files import OpenSound, open_sound
from audio_checks.errors import RenderRefused
from audio_checks.render.channels import ensure_codable, mixing_gains
from audio_checks.render.dither import ensure_shapeable
from audio_checks.render.recipe import MONO_LOSS_LIMIT_DB, TOLERANCE_DB, Recipe
from audio_checks.render.rendered import Rendered
from audio_checks.render.resample import ensure_downwards
from audio_checks.render.work import Work
from audio_checks.spec.delivery_spec import Target

ATTEMPTS = 12  # the second settles it but for a step of rounding; at 8 bit that step may take a few more
SETTLES_DB = 0.02  # for each further attempt: a codec's peaks do not fall by just what its input does
MILLIONTHS = 1_000_000  # of a dB: attenuation is a whole number of them, so that no machine's logarithm shows in bytes


def render_master(
    path: str | os.PathLike[str],
    target: Target,
    out_path: str | os.PathLike[str],
    *,
    loop: bool | None = None,
    loop_points: tuple[int, int] | None = None,
    sample_peak_limit_dbfs: float | None = None,
    true_peak_limit_dbtp: float | None = None,
    tolerance_db: float = TOLERANCE_DB,
    mono_loss_limit_db: float = MONO_LOSS_LIMIT_DB,
    durable: bool = True,
) -> Rendered:
    """Make the game file of a target from a master, in a WAV file or a codec's; the master is only read.

    The file carries the sound and what describes it: loops, cue points and their labels, notes, tempo.
    Everything else goes along only where the target asks for all chunks; the mark of a placeholder always
    does. It is written whole or not at all. The same master and target give the same bytes.

    Parameters
    ----------
    path, out_path : path
        The master, and the file to write; `Target.ending` says what its name should end in.
    target : Target
        Rate, depth, encoding, channels, dither, chunks, shelf, trim, fades, and what to do with peaks
        over the limits.
    loop : bool, optional
        True: the whole file loops, is filtered across its seam and fitted to whole frames. False: it plays
        once, and loops of its own `smpl` chunk are left out, with a warning. None: what the file says.
    loop_points : (int, int), optional
        First and last frame of a loop within the master, in place of those of its own `smpl` chunk.
    sample_peak_limit_dbfs, true_peak_limit_dbtp : float, optional
        What the peaks of the new file are held to; without them full scale.
    tolerance_db : float
        How far a peak may lie beyond its limit and still be let be.
    mono_loss_limit_db : float
        What a stereo sound may lose in mono before a warning is given.
    durable : bool
        The file is on the disk before this returns; without, after a power cut it may be cut short.

    Returns
    -------
    Rendered
        With the report of what was lost, and warnings.

    Raises
    ------
    RenderRefused
        `render:upwards`, `render:channels`, `render:shaped-too-low`, `render:over-peak`,
        `render:loop-points`, `render:large-chunks`, `render:codec-channels`.
    Unreadable
        When the master breaks a rule of structure.
    SandboxFailed
        When a FLAC master could not be unpacked, or a game file encoded, for want of time, memory or disk.
    """
    with open_sound(path) as sound:
        layout = sound.layout
        ensure_downwards(layout.sample_rate_hz, target.sample_rate_hz)
        if loop_points is not None:
            _ensure_inside(loop_points, layout.frames)
        recipe = Recipe(
            sample_rate_hz=target.sample_rate_hz,
            bit_depth=target.bit_depth,
            encoding=target.encoding,
            gains=mixing_gains(layout.channels, target.channels, target.mono_gains),
            dither=target.dither,
            refuse_over_peak=target.over_peak == "refuse",
            sample_peak_limit_dbfs=sample_peak_limit_dbfs,
            true_peak_limit_dbtp=true_peak_limit_dbtp,
            tolerance_db=tolerance_db,
            mono_loss_limit_db=mono_loss_limit_db,
            loop=loop,
            loop_points=(loop_points,) if loop_points else None,
            chunks=target.chunks,
            shelf_db=target.shelf_db,
            trim_below_dbfs=target.trim_below_dbfs,
            fade_in_ms=target.fade_in_ms,
            fade_out_ms=target.fade_out_ms,
            quality=target.quality,
        )
        ensure_codable(layout.channels if recipe.gains is None else recipe.gains.shape[1], target)
        return render(sound, recipe, Path(out_path), durable=durable)


def render(sound: OpenSound, recipe: Recipe, out_path: Path, *, durable: bool = True) -> Rendered:
    """Make a file by a recipe; see `render_master`."""
    ensure_shapeable(recipe.dither, recipe.sample_rate_hz)
    work = Work(sound, recipe)
    scratch = out_path.with_name(f".{out_path.name}.{os.getpid()}.part")
    try:
        lowered_db = 0.0
        for tries in range(ATTEMPTS):
            attempt = work.write(scratch, lowered_db, durable=durable)
            over_db = attempt.over_db(recipe)
            if over_db <= 0:
                break
            if recipe.refuse_over_peak:
                raise _over_peak(over_db)
            settles_db = SETTLES_DB * tries if recipe.is_lossy else 0.0
            lowered_db = math.ceil((lowered_db + over_db + settles_db) * MILLIONTHS) / MILLIONTHS
        else:
            raise _over_peak(over_db)
        rendered = work.describe(scratch, out_path, attempt, lowered_db)
        os.replace(scratch, out_path)
    finally:
        with suppress(FileNotFoundError):
            scratch.unlink()
    return rendered


def _over_peak(over_db: float) -> RenderRefused:
    return RenderRefused(
        f"at the target's rate and depth the peaks are {over_db:.2f} dB over their limit",
        code="render:over-peak",
        fix=f'lower the master by {over_db:.2f} dB or more, or set the target\'s over_peak to "attenuate"',
    )


def _ensure_inside(points: tuple[int, int], frames: int) -> None:
    start, end = points
    if not 0 <= start <= end < frames:
        raise RenderRefused(
            f"a loop is asked for from frame {start} to {end}, and the master has frames 0 to {frames - 1}",
            code="render:loop-points",
            fix="give the loop's first and last frame inside the master, the first one first",
        )
