"""Renders files of a folder to the places where the game expects them."""

from __future__ import annotations

import filecmp
import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from audio_checks.errors import AudioChecksError, RenderRefused, Unreadable
from audio_checks.render.recipe import MONO_LOSS_LIMIT_DB
from audio_checks.render.render import render_master
from audio_checks.render.rendered import Rendered
from audio_checks.run.runner import Task, is_placeholder
from audio_checks.run.workload import CORES, size_of
from audio_checks.spec.codings import CODINGS
from audio_checks.spec.delivery_spec import Target
from audio_checks.spec.sound_names import parse_file_name

AUDIBLE_DB = -60.0  # anything lower is inaudible


class RenderCrashed(AudioChecksError):
    """The renderer itself died; nothing is known to be wrong with the master."""


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

    def render_all(
        self, tasks: Sequence[tuple[Task, str]], *, jobs: int = 1, done: Callable[[Outcome], None] | None = None
    ) -> list[Outcome]:
        """Render masters to the targets of their tasks, in so many processes, 0 for one a core.

        A file that would be the same is left as it is, so that depots do not grow. A placeholder is replaced. What
        would harm the sound is refused, and so is what would overwrite a master, another render of this run, or
        a different one of an earlier run.

        Parameters
        ----------
        tasks : sequence of (Task, str)
            Each with the master's place below the folder that was given.
        jobs : int
            The number of processes.
        done : callable, optional
            Hears of each as it is finished.
        """
        orders = [self._order(task, relative) for task, relative in tasks]
        jobs = min(jobs or CORES, len(orders))
        if jobs > 1:
            from audio_checks.run.processes import in_processes  # a slow import that a single process does not need

            return in_processes(_make_all, orders, workers=jobs, size=_bytes_of, died=_died, done=done)
        outcomes = []
        for order in orders:
            outcomes.append(_make(order))
            if done:
                done(outcomes[-1])
        return outcomes

    def _order(self, task: Task, relative: str) -> _Order:
        """Return a render's destination, or the reason for none; earlier plans have taken their places."""
        if task.spec is None or task.spec.target is None:
            raise ValueError("a render needs a target")
        out = self._place(task.spec.target, relative)
        try:
            self._ensure_free(out, task.path)
        except RenderRefused as refusal:
            return _Order(task, out, self._replaces, refusal)
        self._made[out] = task.path
        return _Order(task, out, self._replaces)

    def _place(self, target: Target, relative: str) -> Path:
        """Return a render's destination: the master's place, under the name without the mark of an alternate."""
        name = parse_file_name(relative)
        return self._folder / target.name / Path(relative).parent / f"{name.stem}{target.ending()}"

    def _ensure_free(self, out: Path, master: str) -> None:
        if out in self._made:
            raise RenderRefused(
                f"{self._made[out]} has the same name without its alternate's mark",
                "render:same-name",
                "render the picked alternate only",
            )
        if out.exists() and os.path.samefile(out, master):
            raise RenderRefused("the render would overwrite its master", "render:over-master", "name another --out")


@dataclass(frozen=True)
class _Order:
    """One render to make, or why not."""

    task: Task
    out: Path
    replaces: bool
    refusal: RenderRefused | None = None


@dataclass(frozen=True)
class Outcome:
    """The outcome of one render.

    Attributes
    ----------
    rendered : Rendered or None
        What was made.
    is_new : bool
        Whether the file is another one than before.
    refusal : RenderRefused, Unreadable or None
        Why nothing was made.
    """

    rendered: Rendered | None = None
    is_new: bool = False
    refusal: RenderRefused | Unreadable | None = None


def _make_all(orders: list[_Order]) -> list[Outcome]:
    return [_make(order) for order in orders]


def _make(order: _Order) -> Outcome:
    if order.refusal is not None:
        return Outcome(refusal=order.refusal)
    spec, out = order.task.spec, order.out
    if spec is None or spec.target is None:
        raise ValueError("a render needs a target")
    out.parent.mkdir(parents=True, exist_ok=True)
    limit_db = spec.limits.mono_loss_db
    scratch = out.with_name(f".{out.name}.{os.getpid()}.new")
    try:
        rendered = render_master(
            order.task.path,
            spec.target,
            scratch,
            loop=None if order.task.cue is None or not order.task.cue.says_loop else order.task.cue.loop,
            sample_peak_limit_dbfs=spec.limits.sample_peak_dbfs,
            true_peak_limit_dbtp=spec.limits.true_peak_dbtp,
            tolerance_db=spec.limits.tolerance_db,
            mono_loss_limit_db=MONO_LOSS_LIMIT_DB if limit_db is None else limit_db,
        )
        is_new = not (out.exists() and filecmp.cmp(scratch, out, shallow=False))
        if is_new:
            _ensure_replaceable(out, replaces=order.replaces)
            os.replace(scratch, out)
    except (RenderRefused, Unreadable) as refusal:
        return Outcome(refusal=refusal.with_traceback(None))
    finally:
        scratch.unlink(missing_ok=True)
    return Outcome(replace(rendered, path=out), is_new)


def _ensure_replaceable(out: Path, *, replaces: bool) -> None:
    if out.exists() and not replaces and not _is_placeholder(out):
        raise RenderRefused(
            f"{out} is there already, and differs: its master, its target or the renderer was another",
            "render:exists",
            "name another --out to keep both, or say --replace",
        )


def _bytes_of(order: _Order) -> int:
    return size_of(order.task.path)


def _died(order: _Order, error: BaseException) -> Outcome:
    raise RenderCrashed(f"{order.task.path}: the process that rendered it died: {error}; run again with -j 1")


def _is_placeholder(path: Path) -> bool:
    try:
        return is_placeholder(path)
    except Unreadable:
        return False


def in_words(rendered: Rendered) -> str:
    """Return the file made, and its cost, in one line."""
    channels = {1: "mono", 2: "stereo"}.get(rendered.channels, f"{rendered.channels} channels")
    coding = CODINGS.get(rendered.encoding)
    if coding:
        kept = coding.label if coding.is_lossy else f"{rendered.bit_depth}-bit {coding.label}"
    else:
        kept = f"{rendered.bit_depth} bit"
    parts = [f"{rendered.sample_rate_hz} Hz, {kept}, {channels}, {rendered.duration_s:.3f} s"]
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
    return "; ".join([*parts, *(f"warning: {warning.sentence}; {warning.fix}" for warning in rendered.warnings)])
