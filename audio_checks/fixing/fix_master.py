"""A fixed copy of a master: repaired as its findings ask, and judged again by the same spec."""

import os
import secrets
from collections.abc import Collection, Iterable, Iterator
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from typing import BinaryIO, Literal

import numpy as np
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.errors import FixRefused, Unreadable
from audio_checks.fixing import header, offers
from audio_checks.fixing.fixed import FixedMaster, Left, Repair
from audio_checks.fixing.offers import Offer, fix_offer
from audio_checks.fixing.offset import Offset, offset_of, why_not
from audio_checks.fixing.plan import Plan
from audio_checks.fixing.sound import Extremes, fades_of, fixed_sound
from audio_checks.metadata.moving import MOST_BYTES, Move, bytes_outside_data, carried
from audio_checks.render.dither import DITHERED_TO_BITS, quantised
from audio_checks.report.findings import FileReport
from audio_checks.run.runner import check_file
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

ATTEMPTS = 8  # the first settles it but for rounding at low depths, and for what one repair does to another
Encoding = Literal["pcm", "float"]


def fix_master(
    path: str | os.PathLike[str],
    spec: DeliverySpec,
    out: str | os.PathLike[str],
    *,
    target: str | None = None,
    category: str | None = None,
    cue: CueFacts | None = None,
    name: str | None = None,
    beside: Collection[Path] = (),
) -> FixedMaster:
    """Write a fixed copy of a master into a folder, and judge it by the same spec.

    Every finding that a fix can answer is answered: a level beyond its limit by one static gain of
    exactly the excess, a constant DC offset by taking its mean out of each channel,
    silence at the edges by trimming to the limit, never into the sound, the name
    by the nearest valid one, sizes in the header by those that are true, a depth that is too high
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
        A folder that exists. The copy gets the master's name, or the valid one; it is written whole or
        not at all, and replaces what has its name there.
    target, category, cue, name
        As for `check_file`.
    beside : collection of path
        Copies made before, which this one must not replace.

    Returns
    -------
    FixedMaster
        Without a path when there is nothing to fix, or nothing that a fix can answer; what it left
        says why. A silent file is left alone: there is no sound to fix.

    Raises
    ------
    FixRefused
        `fix:over-master` and `fix:same-name`, when the copy would replace the master or a copy made
        before; `fix:large-chunks`; `fix:valid-bits`, when header and samples disagree about the depth.
    SpecError
        The spec has no such target.
    """
    name = offers.base_name(os.fspath(path)) if name is None else name
    view = _view(spec, path, target, category, cue)
    before = _judged(path, view, cue, name)
    with ExitStack() as scratches:
        work = _Work(Path(path), Path(out), view, cue, scratches, beside)
        return work.fix(before, name)


def _view(
    spec: DeliverySpec, path: str | os.PathLike[str], target: str | None, category: str | None, cue: CueFacts | None
) -> DeliverySpec:
    """Return the view that master and copy are judged by, whatever the copy's path is: its category is decided here."""
    if spec.category is None:
        spec = spec.for_category(category or (cue.category if cue else None) or spec.category_of(os.fspath(path)) or "")
    return spec if target is None else spec.for_target(target)


def _judged(path: str | os.PathLike[str], view: DeliverySpec, cue: CueFacts | None, name: str) -> FileReport:
    report = check_file(path, view, cue=cue, name=name, all_figures=True)
    return replace(report, category=report.category or None)


class _Work:
    """One master being fixed."""

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
        self._offset: Offset | None = None
        self._header_words: tuple[str, ...] = ()

    def fix(self, before: FileReport, name: str) -> FixedMaster:
        first = Plan(name).extended(before, self._view)
        if not first.does_something or before.verdict == "unjudged":
            return self._nothing(before, name, first)
        source, report = self._path, before
        if before.facts is None:
            whole = self._with_whole_header(before)
            if whole is None:
                return self._nothing(before, name, first)
            source = whole
            report = _judged(source, self._view, self._cue, name)
            if report.facts is None:  # something else is wrong with it, which no header puts right
                return self._nothing(report, name, first)
            first = first.extended(report, self._view)
        _ensure_depth_is_true(report)
        copy = self._scratch()
        seed = bytes.fromhex(report.sha256 or "")
        with wav.open_regular(source) as file:
            layout = wav.read_layout(file)
            if first.removes_offset:
                first = self._checked_offset(file, layout, first)
            if not first.does_something:
                return self._nothing(report, name, first)
            plan, after = self._settled(file, layout, first, copy, seed)
            new = _errors(after) - _errors(report)
            if plan.removes_offset and new:
                plan = first.without_offset(f"Without its offset it would be returned for {', '.join(sorted(new))}.")
                if not plan.does_something:
                    return self._nothing(report, name, plan)
                plan, after = self._settled(file, layout, plan, copy, seed)
        final = self._place(plan.name)
        os.replace(copy, final)
        return FixedMaster(
            path=final,
            name=plan.name,
            repairs=tuple(self._repairs(plan, name, layout)),
            left=self._left(after, plan),
            before=before,
            after=after,
            gain_db=plan.gain_db,
            cut_frames=(plan.cut_head, plan.cut_tail),
            fade_frames=self._fades,
        )

    def _checked_offset(self, file: BinaryIO, layout: wav.WavLayout, plan: Plan) -> Plan:
        limit = self._view.limits.dc_offset_percent or 0.0
        why = why_not(file, layout, limit)
        return plan.without_offset(why) if why else plan

    def _settled(
        self, file: BinaryIO, layout: wav.WavLayout, plan: Plan, copy: Path, seed: bytes
    ) -> tuple[Plan, FileReport]:
        """Write the copy until its own report asks for nothing more that a fix can do."""
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
            raise FixRefused(
                "the peaks do not fit the depth that is asked for",
                code="fix:over-full-scale",
                fix="lower the level in the session, then export at the accepted depth",
            )
        return plan, after

    def _write(self, file: BinaryIO, layout: wav.WavLayout, plan: Plan, copy: Path, seed: bytes) -> float:
        """Write the copy once; return by how many dB its peaks exceed what its depth can hold."""
        encoding: Encoding = "pcm" if plan.depth is not None else layout.encoding
        depth = plan.depth or layout.bit_depth
        first, end = plan.cut_head, layout.frames - plan.cut_tail
        offset = offset_of(file, layout, first, end) if plan.removes_offset else None
        self._fades = fades_of(file, layout, plan, offset)
        self._offset = offset
        sound = fixed_sound(file, layout, plan, self._fades, offset)
        rounded = plan.gain_db != 0.0 or plan.depth is not None or (offset is not None and not offset.is_exact)
        changed = rounded or offset is not None
        _ensure_carried(layout)
        before, after = carried(file, layout, Move(first, end - first, changed, plan.depth))
        extremes = Extremes(depth)
        blocks: Iterable[NDArray[np.integer]] | Iterable[NDArray[np.floating]] = sound
        if encoding == "pcm":
            dither: Literal["tpdf", "none"] = "tpdf" if rounded and depth <= DITHERED_TO_BITS else "none"
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
        if not any(finding.code in header.SIZES for finding in before.findings):
            return None
        whole = self._scratch()
        try:
            self._header_words = header.with_right_sizes(self._path, whole).words
        except Unreadable:
            return None
        return whole

    def _repairs(self, plan: Plan, name: str, layout: wav.WavLayout) -> Iterator[Repair]:
        rate = layout.sample_rate_hz
        codes = {kind: tuple(finding.code for finding in findings) for kind, findings in plan.answers.items()}
        if plan.rewrites_header:
            words = "; ".join(self._header_words) or "header rewritten, with correct sizes and no padding"
            yield Repair("header", codes["header"], words)
        if plan.cut_head:
            words = f"{1000 * plan.cut_head / rate:.1f} ms trimmed from the start{_faded(self._fades[0], rate)}"
            yield Repair("head", codes["head"], words, 0.0, plan.cut_head / rate)
        if plan.cut_tail:
            words = f"{1000 * plan.cut_tail / rate:.1f} ms trimmed from the end{_faded(self._fades[1], rate)}"
            start_s = (layout.frames - plan.cut_tail) / rate
            yield Repair("tail", codes["tail"], words, start_s, layout.duration_s)
        if plan.removes_offset and self._offset is not None:
            percent = 100 * max(abs(value) for value in self._offset.values)
            edges = "" if self._offset.is_exact else ", from zero at the edges"
            words = f"DC offset of {percent:.2f} % taken out{edges}"
            first_s, end_s = self._offset.first / rate, self._offset.end / rate
            yield Repair("offset", codes["offset"], words, first_s, end_s)
        if plan.gain_db:
            moved = "lowered" if plan.gain_db < 0 else "raised"
            spot = next((finding for finding in plan.answers.get("gain", ()) if finding.start_s is not None), None)
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

    def _left(self, report: FileReport, plan: Plan) -> tuple[Left, ...]:
        offered = ((finding, fix_offer(finding, report, self._view)) for finding in report.findings)
        return tuple(Left(finding, _why(offer, plan)) for finding, offer in offered)

    def _nothing(self, before: FileReport, name: str, plan: Plan) -> FixedMaster:
        return FixedMaster(None, name, (), self._left(before, plan), before, None)

    def _place(self, name: str) -> Path:
        final = self._out / name
        if final.exists() and os.path.samefile(final, self._path):
            raise FixRefused(
                "the fixed copy would replace its master",
                code="fix:over-master",
                fix="name another folder; a master is never altered",
            )
        if final in self._beside:
            raise FixRefused(
                f"another file has the name {name} too, once both are valid",
                code="fix:same-name",
                fix="rename one of the two masters",
            )
        return final

    def _scratch(self) -> Path:
        scratch = self._out / f".fix-{secrets.token_hex(8)}.part"
        self._scratches.callback(lambda: scratch.unlink(missing_ok=True))
        return scratch


def _ensure_depth_is_true(report: FileReport) -> None:
    """Raise FixRefused for samples that make use of more bits than the header says: a copy would cut them off."""
    facts = report.facts or {}
    used, stated = facts.get("effective_bits"), facts.get("bit_depth")
    if used is not None and stated is not None and used > stated:
        raise FixRefused(
            f"the samples make use of {used} bits, and the header says that {stated} count",
            code="fix:valid-bits",
            fix="export it again from the session, so that header and samples agree",
        )


def _errors(report: FileReport) -> set[str]:
    return {finding.code for finding in report.findings if finding.severity == "error"}


def _why(offer: Offer, plan: Plan) -> str:
    if offer.repair is None:
        return offer.words
    if offer.repair == "offset" and plan.keeps_offset:
        return plan.keeps_offset
    return "A fix was tried and does not answer it: no size or level puts it right. Export the sound again."


def _faded(frames: int, rate: int) -> str:
    return f", with a fade of {1000 * frames / rate:.1f} ms" if frames else ""


def _ensure_carried(layout: wav.WavLayout) -> None:
    beside = bytes_outside_data(layout)
    if beside > MOST_BYTES:
        raise FixRefused(
            f"the file carries {beside >> 20} MiB beside its sound; a fix carries {MOST_BYTES >> 20} MiB at most",
            code="fix:large-chunks",
            fix="fix it in the session, or leave out what the file need not carry",
        )
