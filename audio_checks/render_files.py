"""Renders files of a folder to the places where the game expects them."""

import filecmp
import os
from dataclasses import replace
from pathlib import Path

from audio_checks.errors import RenderRefused, Unreadable
from audio_checks.render.recipe import MONO_LOSS_LIMIT_DB
from audio_checks.render.render import render_master
from audio_checks.render.rendered import Rendered
from audio_checks.runner import Task, is_placeholder
from audio_checks.sound_list import parse_file_name

AUDIBLE_DB = -60.0  # what lies below is lost on everyone


class RenderRun:
    """One run over masters; two of them never make the same file, and none replaces an earlier one unasked.

    Parameters
    ----------
    folder : path
        Renders go to folder/target/place of the master.
    replaces : bool
        Whether a game file that differs from one of an earlier run takes its place.
    """

    def __init__(self, folder: str | os.PathLike[str], *, replaces: bool = False) -> None:
        self._folder = Path(folder)
        self._replaces = replaces
        self._made: dict[Path, str] = {}

    def render(self, task: Task, relative: str) -> tuple[Rendered, bool]:
        """Render one master to the target of its task; return it, and whether it is new.

        A file that would be the same is left as it is, so that depots do not grow. A stand-in gives way.

        Raises
        ------
        RenderRefused
            The render would harm the sound, or overwrite a master, another render of this run, or a
            different one of an earlier run.
        Unreadable
            The master breaks a rule of structure.
        """
        spec = task.spec
        if spec is None or spec.target is None:
            raise ValueError("a render needs a target")
        out = self._place(spec.target.name, relative)
        self._ensure_free(out, task.path)
        out.parent.mkdir(parents=True, exist_ok=True)
        limit_db = spec.limits.mono_loss_db
        beside = out.with_name(f".{out.name}.{os.getpid()}.new")
        try:
            rendered = render_master(
                task.path,
                spec.target,
                beside,
                loop=task.cue is not None and task.cue.loop,
                sample_peak_limit_dbfs=spec.limits.sample_peak_dbfs,
                true_peak_limit_dbtp=spec.limits.true_peak_dbtp,
                tolerance_db=spec.limits.tolerance_db,
                mono_loss_limit_db=MONO_LOSS_LIMIT_DB if limit_db is None else limit_db,
            )
            is_new = not (out.exists() and filecmp.cmp(beside, out, shallow=False))
            if is_new:
                self._ensure_replaceable(out)
                os.replace(beside, out)
        finally:
            beside.unlink(missing_ok=True)
        self._made[out] = task.path
        return replace(rendered, path=out), is_new

    def _place(self, target: str, relative: str) -> Path:
        """Return where a render goes: the master's place, under the name without the mark of an alternate."""
        name = parse_file_name(relative)
        return self._folder / target / Path(relative).parent / f"{name.stem}.wav"

    def _ensure_free(self, out: Path, master: str) -> None:
        if out in self._made:
            raise RenderRefused(
                f"{self._made[out]} has the same name without its alternate's mark",
                "render:same-name",
                "render the picked alternate only",
            )
        if out.exists() and os.path.samefile(out, master):
            raise RenderRefused("the render would overwrite its master", "render:over-master", "name another --out")

    def _ensure_replaceable(self, out: Path) -> None:
        if out.exists() and not self._replaces and not _is_stand_in(out):
            raise RenderRefused(
                f"{out} is there already, and differs: its master, its target or the renderer was another",
                "render:exists",
                "name another --out to keep both, or say --replace",
            )


def _is_stand_in(path: Path) -> bool:
    try:
        return is_placeholder(path)
    except Unreadable:
        return False


def in_words(rendered: Rendered) -> str:
    """Return what was made, and what it cost, in one line."""
    channels = {1: "mono", 2: "stereo"}.get(rendered.channels, f"{rendered.channels} channels")
    parts = [f"{rendered.sample_rate_hz} Hz, {rendered.bit_depth} bit, {channels}, {rendered.duration_s:.3f} s"]
    if rendered.attenuation_db:
        parts.append(f"lowered by {rendered.attenuation_db:.2f} dB to keep its peak limit")
    loss = rendered.loss
    if loss is not None:
        if loss.above_nyquist_db > AUDIBLE_DB:
            parts.append(f"highs of {loss.above_nyquist_db:.1f} dB lost")
        if loss.shelf_db:
            parts.append(f"top octave lifted by {loss.shelf_db:.1f} dB")
        if any(loss.trimmed_s):
            parts.append(f"{loss.trimmed_s[0]:.3f} s and {loss.trimmed_s[1]:.3f} s of silence cut")
    if rendered.loop_fit_frames:
        parts.append(f"loop fitted by {rendered.loop_fit_frames:+.2f} frames")
    return "; ".join([*parts, *(f"warning: {one.sentence}; {one.fix}" for one in rendered.warnings)])
