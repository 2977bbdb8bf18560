"""A mended copy of a master: repaired as its findings ask, and judged again by the same spec."""

import math
import os
import secrets
from collections.abc import Collection, Iterable, Iterator
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, BinaryIO, Literal

import numpy as np
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.errors import MendRefused, Unreadable
from audio_checks.findings import FileReport, Finding
from audio_checks.mending import header, offers
from audio_checks.mending.names import lawful_name
from audio_checks.mending.offers import Offer, RepairKind, mendable
from audio_checks.mending.samples import stretch
from audio_checks.metadata.carrying import MOST_BYTES, Move, bytes_beside, carried
from audio_checks.render.dither import DITHERED_TO_BITS, quantised
from audio_checks.runner import check_file
from audio_checks.spec import CueFacts, DeliverySpec

MENDER_VERSION = "1"  # changes when the same master and spec give another copy
ATTEMPTS = 8  # the first settles it but for rounding at low depths, and for what one repair does to another
FADE_MS = 5.0
CLICKS_ABOVE = 2.0**-15  # a step of one 16-bit value: what begins lower than this needs no fade
Encoding = Literal["pcm", "float"]


@dataclass(frozen=True)
class Repair:
    """One thing that was put right.

    Attributes
    ----------
    kind : str
        "gain", "head", "tail", "name", "header" or "depth".
    codes : tuple of str
        The findings it answers.
    words : str
        What was done, as in "level lowered by 1.70 dB".
    start_s, end_s : float or None
        Where in the master: what was cut away, or the spot for which the level was moved.
    """

    kind: RepairKind
    codes: tuple[str, ...]
    words: str
    start_s: float | None = None
    end_s: float | None = None


@dataclass(frozen=True)
class Left:
    """A finding of the mended copy that no mend answers: its code, and why and what to do, in a sentence."""

    finding: Finding
    why: str


@dataclass(frozen=True)
class Mended:
    """What came of a mend.

    Attributes
    ----------
    path : Path or None
        The copy; None when nothing could be mended, and nothing was written.
    name : str
        The copy's name; the master's where that is lawful or cannot be put right.
    repairs : tuple of Repair
        What was done, in the order of the sound's way: header, trims, level, depth, name.
    left : tuple of Left
        What is still found in the copy, or in the master when there is no copy.
    before, after : FileReport or None
        What the spec says of master and copy, with every figure; `after` is None without a copy.
    gain_db : float
        By how much the level was moved: one factor for the whole sound.
    cut_frames : (int, int)
        Frames taken from start and end.
    fade_frames : (int, int)
        Frames faded where a cut would click, within the silence that stays.
    """

    path: Path | None
    name: str
    repairs: tuple[Repair, ...]
    left: tuple[Left, ...]
    before: FileReport
    after: FileReport | None
    gain_db: float = 0.0
    cut_frames: tuple[int, int] = (0, 0)
    fade_frames: tuple[int, int] = (0, 0)
    mender_version: str = MENDER_VERSION

    @property
    def conforms(self) -> bool:
        """Whether the copy, or a master that needed no mend, has no finding of severity error."""
        return (self.after or self.before).verdict == "conforming"

    def to_dict(self) -> dict[str, Any]:
        """Return everything but the path as plain values; −inf is None, as in the report."""
        return {
            "name": self.name,
            "repairs": [
                {
                    "kind": one.kind,
                    "codes": list(one.codes),
                    "words": one.words,
                    "start_s": one.start_s,
                    "end_s": one.end_s,
                }
                for one in self.repairs
            ],
            "left": [{**one.finding.to_dict(), "why": one.why} for one in self.left],
            "conforms": self.conforms,
            "gain_db": self.gain_db,
            "cut_frames": list(self.cut_frames),
            "fade_frames": list(self.fade_frames),
            "before": self.before.to_dict(),
            "after": self.after and self.after.to_dict(),
            "mender_version": self.mender_version,
        }


def mend_master(
    path: str | os.PathLike[str],
    spec: DeliverySpec,
    out: str | os.PathLike[str],
    *,
    target: str | None = None,
    category: str | None = None,
    cue: CueFacts | None = None,
    name: str | None = None,
    beside: Collection[Path] = (),
) -> Mended:
    """Write a mended copy of a master into a folder, and judge it by the same spec.

    Every finding that a mend can answer is answered: a level beyond its limit by one static gain of
    exactly the excess, silence at the edges by trimming to the limit, never into the sound, the name
    by the nearest lawful one, sizes in the header by those that are true, a depth that is too high
    by rounding with TPDF dither seeded from the master. What stays of the samples stays exact: a
    trim alone changes no sample but those of a fade, which is made only where the cut would click,
    and only within the silence that stays. Chunks are carried, and what points into the sound is
    moved with it. The same master and spec give the same bytes.

    Parameters
    ----------
    path : path
        The master; it is only read.
    spec : DeliverySpec
        What it is judged by.
    out : path
        A folder that exists. The copy gets the master's name, or the lawful one; it is written whole or
        not at all, and replaces what has its name there.
    target, category, cue, name
        As for `check_file`.
    beside : collection of path
        Copies made before, which this one must not replace.

    Returns
    -------
    Mended
        Without a path when there is nothing to mend, or nothing that a mend can answer; what it left
        says why. A silent file is left alone: there is no sound to mend.

    Raises
    ------
    MendRefused
        `mend:over-master` and `mend:same-name`, when the copy would replace the master or a copy made
        before; `mend:large-chunks`; `mend:valid-bits`, when header and samples disagree about the depth.
    SpecError
        The spec has no such target.
    """
    name = offers.base_name(os.fspath(path)) if name is None else name
    view = _view(spec, path, target, category, cue)
    before = _judged(path, view, cue, name)
    with ExitStack() as scratches:
        work = _Work(Path(path), Path(out), view, cue, scratches, beside)
        return work.mend(before, name)


def _view(
    spec: DeliverySpec, path: str | os.PathLike[str], target: str | None, category: str | None, cue: CueFacts | None
) -> DeliverySpec:
    """Return the view that master and copy are judged by, wherever the copy lies: its category is settled here."""
    if spec.category is None:
        spec = spec.for_category(category or (cue.category if cue else None) or spec.category_of(os.fspath(path)) or "")
    return spec if target is None else spec.for_target(target)


def _judged(path: str | os.PathLike[str], view: DeliverySpec, cue: CueFacts | None, name: str) -> FileReport:
    report = check_file(path, view, cue=cue, name=name, all_figures=True)
    return replace(report, category=report.category or None)


@dataclass(frozen=True)
class _Plan:
    """What is done to the sound, and for which findings."""

    name: str
    gain_db: float = 0.0
    cut_head: int = 0
    cut_tail: int = 0
    silent_head: int = 0  # frames of silence that stay, in which a fade may lie
    silent_tail: int = 0
    depth: int | None = None
    anew: bool = False  # the header is written anew
    answers: dict[RepairKind, tuple[Finding, ...]] = field(default_factory=dict)

    @property
    def does_something(self) -> bool:
        return bool(self.answers)

    def extended(self, report: FileReport, view: DeliverySpec) -> "_Plan":
        """Return the plan with what a report, of the master or of the last copy, asks in addition."""
        plan = self
        gains = [0.0]
        for finding in report.findings:
            offer = mendable(finding, report, view)
            if offer.repair is None:
                continue
            plan = plan._with(offer.repair, finding)
            if offer.repair == "gain":
                gains.append(-offers.excess_db(finding))
            elif offer.repair == "head":
                plan = plan._trimmed("head", finding, report)
            elif offer.repair == "tail":
                plan = plan._trimmed("tail", finding, report)
            elif offer.repair == "depth":
                plan = replace(plan, depth=offers.accepted_depth(report, view))
            elif offer.repair == "name":
                plan = replace(plan, name=lawful_name(plan.name, view) or plan.name)
            else:
                plan = replace(plan, anew=True)
        lowest = min(gains)
        return replace(plan, gain_db=plan.gain_db + (lowest if lowest < 0 else max(gains)))

    def _with(self, kind: RepairKind, finding: Finding) -> "_Plan":
        known = self.answers.get(kind, ())
        if any(one.code == finding.code for one in known):
            return self
        return replace(self, answers={**self.answers, kind: (*known, finding)})

    def _trimmed(self, end: Literal["head", "tail"], finding: Finding, report: FileReport) -> "_Plan":
        over = offers.frames_over(finding, report)
        rate = (report.facts or {})["sample_rate_hz"]
        stays = round((finding.measured or 0.0) * rate / 1000) - over
        if end == "head":
            return replace(self, cut_head=self.cut_head + over, silent_head=stays)
        return replace(self, cut_tail=self.cut_tail + over, silent_tail=stays)


class _Work:
    """One master being mended."""

    def __init__(
        self,
        path: Path,
        out: Path,
        view: DeliverySpec,
        cue: CueFacts | None,
        scratches: ExitStack,
        beside: Collection[Path],
    ) -> None:
        self._path = path
        self._out = out
        self._view = view
        self._cue = cue
        self._scratches = scratches
        self._beside = beside
        self._fades = (0, 0)
        self._header_words: tuple[str, ...] = ()

    def mend(self, before: FileReport, name: str) -> Mended:
        first = _Plan(name).extended(before, self._view)
        if not first.does_something or before.verdict == "unjudged":
            return self._nothing(before, name)
        source, report = self._path, before
        if before.facts is None:
            whole = self._with_whole_header(before)
            if whole is None:
                return self._nothing(before, name)
            source = whole
            report = _judged(source, self._view, self._cue, name)
            if report.facts is None:  # something else is wrong with it, which no header puts right
                return self._nothing(report, name)
            first = first.extended(report, self._view)
        _ensure_depth_is_true(report)
        copy = self._scratch()
        seed = bytes.fromhex(report.sha256 or "")
        with wav.open_regular(source) as file:
            layout = wav.read_layout(file)
            plan, after = self._settled(file, layout, first, copy, seed)
        final = self._place(plan.name)
        os.replace(copy, final)
        return Mended(
            path=final,
            name=plan.name,
            repairs=tuple(self._repairs(plan, name, layout)),
            left=self._left(after),
            before=before,
            after=after,
            gain_db=plan.gain_db,
            cut_frames=(plan.cut_head, plan.cut_tail),
            fade_frames=self._fades,
        )

    def _settled(
        self, file: BinaryIO, layout: wav.WavLayout, plan: _Plan, copy: Path, seed: bytes
    ) -> tuple[_Plan, FileReport]:
        """Write the copy until its own report asks for nothing more that a mend can do."""
        after = None
        for _ in range(ATTEMPTS):
            over_db = self._write(file, layout, plan, copy, seed)
            if over_db > 0:  # the new depth cannot hold it: full scale is a limit too
                plan = replace(plan, gain_db=plan.gain_db - over_db)
                continue
            after = _judged(copy, self._view, self._cue, plan.name)
            more = plan.extended(after, self._view)
            if more == plan:
                break
            plan = more
        if after is None:
            raise MendRefused(
                "the peaks do not fit the depth that is asked for",
                code="mend:over-full-scale",
                fix="lower the level in the session, then export at the accepted depth",
            )
        return plan, after

    def _write(self, file: BinaryIO, layout: wav.WavLayout, plan: _Plan, copy: Path, seed: bytes) -> float:
        """Write the copy once; return by how many dB its peaks exceed what its depth can hold."""
        encoding: Encoding = "pcm" if plan.depth is not None else layout.encoding
        depth = plan.depth or layout.bit_depth
        first, end = plan.cut_head, layout.frames - plan.cut_tail
        self._fades = _fades(file, layout, plan)
        sound = _sound(file, layout, plan, self._fades)
        changed = plan.gain_db != 0.0 or plan.depth is not None
        _ensure_carried(layout)
        before, after = carried(file, layout, Move(first, end - first, changed, plan.depth))
        extremes = _Extremes(depth)
        blocks: Iterable[NDArray[np.integer]] | Iterable[NDArray[np.floating]] = sound
        if encoding == "pcm":
            dither: Literal["tpdf", "none"] = "tpdf" if changed and depth <= DITHERED_TO_BITS else "none"
            whole = quantised(sound, bit_depth=depth, channels=layout.channels, dither=dither, seed=seed)
            blocks = extremes.held(whole)
        wav.write_wav(
            copy,
            blocks,
            sample_rate_hz=layout.sample_rate_hz,
            bit_depth=depth,
            encoding=encoding,
            channels=layout.channels,
            frames=end - first,
            channel_mask=layout.channel_mask,
            chunks=before,
            chunks_after=after,
        )
        return extremes.over_db()

    def _with_whole_header(self, before: FileReport) -> Path | None:
        """Return a copy of the master that the strict reader takes; None where no header makes it whole."""
        if not any(one.code in header.SIZES for one in before.findings):
            return None
        whole = self._scratch()
        try:
            self._header_words = header.with_right_sizes(self._path, whole).words
        except Unreadable:
            return None
        return whole

    def _repairs(self, plan: _Plan, name: str, layout: wav.WavLayout) -> Iterator[Repair]:
        rate = layout.sample_rate_hz
        codes = {kind: tuple(one.code for one in found) for kind, found in plan.answers.items()}
        if plan.anew:
            words = "; ".join(self._header_words) or "header written anew, with true sizes and no padding"
            yield Repair("header", codes["header"], words)
        if plan.cut_head:
            words = f"{1000 * plan.cut_head / rate:.1f} ms trimmed from the start{_faded(self._fades[0], rate)}"
            yield Repair("head", codes["head"], words, 0.0, plan.cut_head / rate)
        if plan.cut_tail:
            words = f"{1000 * plan.cut_tail / rate:.1f} ms trimmed from the end{_faded(self._fades[1], rate)}"
            start_s = (layout.frames - plan.cut_tail) / rate
            yield Repair("tail", codes["tail"], words, start_s, layout.duration_s)
        if plan.gain_db:
            moved = "lowered" if plan.gain_db < 0 else "raised"
            spot = next((one for one in plan.answers.get("gain", ()) if one.start_s is not None), None)
            yield Repair(
                "gain",
                codes.get("gain", ()),
                f"level {moved} by {abs(plan.gain_db):.2f} dB",
                spot.start_s if spot else None,
                spot.end_s if spot else None,
            )
        if plan.depth is not None:
            dithered = ", with TPDF dither" if plan.depth <= DITHERED_TO_BITS else ", rounded"
            held = f"{layout.bit_depth} bit" + (" float" if layout.encoding == "float" else "")
            yield Repair("depth", codes["depth"], f"from {held} to {plan.depth} bit{dithered}")
        if plan.name != name:
            yield Repair("name", codes["name"], f"renamed to {plan.name}")

    def _left(self, report: FileReport) -> tuple[Left, ...]:
        offered = ((one, mendable(one, report, self._view)) for one in report.findings)
        return tuple(Left(finding, _why(offer)) for finding, offer in offered)

    def _nothing(self, before: FileReport, name: str) -> Mended:
        return Mended(None, name, (), self._left(before), before, None)

    def _place(self, name: str) -> Path:
        final = self._out / name
        if final.exists() and os.path.samefile(final, self._path):
            raise MendRefused(
                "the mended copy would replace its master",
                code="mend:over-master",
                fix="name another folder; a master is never altered",
            )
        if final in self._beside:
            raise MendRefused(
                f"another file has the name {name} too, once both are lawful",
                code="mend:same-name",
                fix="rename one of the two masters",
            )
        return final

    def _scratch(self) -> Path:
        scratch = self._out / f".mend-{secrets.token_hex(8)}.part"
        self._scratches.callback(lambda: scratch.unlink(missing_ok=True))
        return scratch


def _ensure_depth_is_true(report: FileReport) -> None:
    """Raise MendRefused for samples that make use of more bits than the header says: a copy would cut them off."""
    facts = report.facts or {}
    used, said = facts.get("effective_bits"), facts.get("bit_depth")
    if used is not None and said is not None and used > said:
        raise MendRefused(
            f"the samples make use of {used} bits, and the header says that {said} count",
            code="mend:valid-bits",
            fix="export it again from the session, so that header and samples agree",
        )


def _why(offer: Offer) -> str:
    if offer.repair is None:
        return offer.words
    return "A mend was tried and does not answer it: no size or level puts it right. Export the sound again."


def _faded(frames: int, rate: int) -> str:
    return f", with a fade of {1000 * frames / rate:.1f} ms" if frames else ""


def _fades(file: BinaryIO, layout: wav.WavLayout, plan: _Plan) -> tuple[int, int]:
    """Return how many frames are faded at start and end: none where the cut would not be heard."""
    most = round(FADE_MS * layout.sample_rate_hz / 1000)
    last = layout.frames - plan.cut_tail - 1
    head = min(most, plan.silent_head) if plan.cut_head and _clicks(file, layout, plan.cut_head) else 0
    tail = min(most, plan.silent_tail) if plan.cut_tail and _clicks(file, layout, last) else 0
    return head, tail


def _clicks(file: BinaryIO, layout: wav.WavLayout, frame: int) -> bool:
    return any(bool(np.abs(block).max() > CLICKS_ABOVE) for block in stretch(file, layout, frame, frame + 1))


def _sound(file: BinaryIO, layout: wav.WavLayout, plan: _Plan, fades: tuple[int, int]) -> Iterator[NDArray[np.float64]]:
    """Yield what stays of the sound, moved in level, with its fades."""
    first, end = plan.cut_head, layout.frames - plan.cut_tail
    factor = 10 ** (plan.gain_db / 20)
    start = first
    for block in stretch(file, layout, first, end):
        places = np.arange(start, start + len(block))
        # Where nothing is done the weights are 1.0, so that samples stay exact.
        yield block * (factor * _rise(places - first, fades[0]) * _rise(end - 1 - places, fades[1]))
        start += len(block)


def _rise(places: NDArray[np.int64], frames: int) -> NDArray[np.float64]:
    """Return the weights of a raised cosine from nothing to the whole over so many frames, shape (n, 1)."""
    if not frames:
        return np.ones((len(places), 1))
    shares = np.clip((places + 0.5) / frames, 0.0, 1.0)
    return np.asarray(0.5 - 0.5 * np.cos(np.pi * shares))[:, np.newaxis]


class _Extremes:
    """Holds whole numbers to what a depth can store, and remembers how far they reached."""

    def __init__(self, bit_depth: int) -> None:
        self._full = 1 << (bit_depth - 1)
        self._lowest = self._highest = 0

    def held(self, blocks: Iterable[NDArray[np.int64]]) -> Iterator[NDArray[np.int64]]:
        for block in blocks:
            self._lowest = min(self._lowest, int(block.min(initial=0)))
            self._highest = max(self._highest, int(block.max(initial=0)))
            yield np.clip(block, -self._full, self._full - 1)

    def over_db(self) -> float:
        most = max(self._highest / (self._full - 1), -self._lowest / self._full)
        return 20 * math.log10(most) if most > 1 else 0.0


def _ensure_carried(layout: wav.WavLayout) -> None:
    beside = bytes_beside(layout)
    if beside > MOST_BYTES:
        raise MendRefused(
            f"the file carries {beside >> 20} MiB beside its sound; a mend carries {MOST_BYTES >> 20} MiB at most",
            code="mend:large-chunks",
            fix="mend it in the session, or leave out what the file need not carry",
        )
