"""Renders files of a folder to the places where the game expects them."""

import os
from pathlib import Path

from audio_checks.errors import RenderRefused
from audio_checks.render.render import render_master
from audio_checks.render.rendered import Rendered
from audio_checks.runner import Task
from audio_checks.sound_list import parse_file_name


class RenderRun:
    """One run over masters; two of them never make the same file."""

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        self._folder = Path(folder)
        self._made: dict[Path, str] = {}

    def render(self, task: Task, relative: str) -> str:
        """Render one master to the target of its task; return what was made, in words.

        Raises
        ------
        RenderRefused
            The render would harm the sound, or overwrite a master or another render of this run.
        Unreadable
            The master breaks a rule of structure.
        """
        spec = task.spec
        if spec is None or spec.target is None:
            raise ValueError("a render needs a target")
        out = self._place(spec.target.name, relative)
        self._ensure_free(out, task.path)
        out.parent.mkdir(parents=True, exist_ok=True)
        rendered = render_master(
            task.path,
            spec.target,
            out,
            loop=task.cue is not None and task.cue.loop,
            sample_peak_limit_dbfs=spec.limits.sample_peak_dbfs,
            true_peak_limit_dbtp=spec.limits.true_peak_dbtp,
            tolerance_db=spec.limits.tolerance_db,
        )
        self._made[out] = task.path
        return f"{out}, {_in_words(rendered)}"

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


def _in_words(rendered: Rendered) -> str:
    channels = {1: "mono", 2: "stereo"}.get(rendered.channels, f"{rendered.channels} channels")
    words = f"{rendered.sample_rate_hz} Hz, {rendered.bit_depth} bit, {channels}, {rendered.duration_s:.3f} s"
    if rendered.attenuation_db:
        words += f"; lowered by {rendered.attenuation_db:.2f} dB to keep its peak limit"
    return words
