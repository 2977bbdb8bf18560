"""Runs the checks that a spec asks for on files, and gives every finding its severity.

A check that crashes, or whose figure could not be measured, is the tool's fault: the file is `unjudged`,
whatever else was found, and the report names the check.
"""

import os
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

from audio_checks import judge as judgements
from audio_checks.audio.audio_file import AudioFile, DryStem
from audio_checks.checks import Check, all_checks
from audio_checks.errors import Unreadable
from audio_checks.judge.compare.dry_stem import combined_with, compare_reverb_with_dry
from audio_checks.metadata.mark import cue_marked
from audio_checks.report.findings import FileReport, Finding, Report, SpecRef, Unjudged, Verdict
from audio_checks.report.judged import JudgedFile
from audio_checks.run.containment import failed_checks, make_judgements, run_checks
from audio_checks.run.name_check import as_listed
from audio_checks.run.sets import with_set_findings
from audio_checks.run.severity import crash, graded, in_words, ordered
from audio_checks.run.workload import size_of
from audio_checks.spec import check_names
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec
from audio_checks.spec.loudness_presets import PRESETS
from audio_checks.spec.sound_list import SoundList
from audio_checks.spec.sound_names import parse_file_name
from audio_checks.version import TOOL_VERSION

PathLike = str | os.PathLike[str]
_NO_SPEC = DeliverySpec(tables={})


@dataclass(frozen=True)
class Task:
    """One file to judge, with all that is known of it.

    `spec` is the view for the file's category and the target, None for structure only; `unlisted`
    says that there is a sound list, and no cue in it owns the file's name; `variation` is which of
    the cue's variations it is; `dry` is the file's dry stem, to compare its reverb with; `coded` says that
    Ogg Vorbis, Opus and MP3 are decoded where the spec accepts them, or where another container would not
    reject them: a game's files, and no masters; `shipped` that they are decoded whatever the spec accepts;
    `listed_name` is what the list calls a file whose folder says a part of its name, as a voice line's does.
    """

    path: str
    spec: DeliverySpec | None = None
    cue: CueFacts | None = None
    unlisted: bool = False
    variation: int = 1
    dry: DryStem | None = None
    coded: bool = False
    shipped: bool = False
    listed_name: str | None = None


def check_file(
    path: PathLike,
    spec: DeliverySpec | None = None,
    *,
    target: str | None = None,
    category: str | None = None,
    cue: CueFacts | None = None,
    name: str | None = None,
    checks: Iterable[str] | None = None,
    all_figures: bool = False,
    dry: DryStem | None = None,
    shipped: bool = False,
) -> FileReport:
    """Judge one file.

    Parameters
    ----------
    path : path
        Any path: what cannot be opened or read is a finding, never an exception.
    spec : DeliverySpec, optional
        Without one, only the structure is judged.
    target : str, optional
        Judge a render made to this target, not a delivery.
    category : str, optional
        Whose limits hold; else the cue's, else what `[files]` of the spec says.
    cue : CueFacts, optional
        What the sound list asks of this sound.
    name : str, optional
        The file's name as delivered, when it is stored under another; the report calls it so.
    checks : iterable of str, optional
        Run only these.
    all_figures : bool
        Measure everything, not only what the checks read.
    dry : DryStem, optional
        The same sound without reverb: reverb is compared with it if the two are the same sound. One that
        cannot be read is reported in the judgement.
    shipped : bool
        It is a game's own file and no master: Ogg Vorbis, Opus and MP3 are decoded, whatever the spec accepts.

    Returns
    -------
    FileReport

    Raises
    ------
    SpecError
        The spec has no such target.
    ValueError
        There is no check of a name in `checks`.
    """
    if spec is not None:
        spec = view_of(spec, path, target=target, category=category, cue=cue)
    coded = spec is not None and spec.target is not None and spec.target.is_lossy
    task = Task(os.fspath(path), spec, cue, dry=dry, coded=coded, shipped=shipped)
    return _judge(task, name=name, checks=checks, all_figures=all_figures)


def check_files(
    paths: Iterable[PathLike],
    spec: DeliverySpec | None = None,
    *,
    target: str | None = None,
    sound_list: SoundList | None = None,
    category: str | None = None,
    jobs: int = 1,
) -> Report:
    """Judge many files by one spec, in their order, each alone and all of them together; see `check_file`.

    `jobs` is the number of processes, 0 for one a core. A process that dies leaves its file unjudged.
    """
    views: dict[tuple[int, str | None], DeliverySpec] = {}
    tasks = [
        task_for(path, spec, target=target, category=category, sound_list=sound_list, views=views) for path in paths
    ]
    entries = with_set_checks(tasks, judge(tasks, jobs=jobs))
    return report_on(entries, [spec] if spec else [], [task.spec for task in tasks if task.spec])


def measure_file(
    path: PathLike,
    *,
    category: str | None = None,
    kind: str | None = None,
    dry: PathLike | None = None,
    name: str | None = None,
    presets: Iterable[str] = (),
) -> FileReport:
    """Measure everything in one file and hold it to nothing: its entry has no findings, and is `unjudged`.

    Parameters
    ----------
    path : path
        A WAV or FLAC file.
    category, name : str, optional
        For the entry: the category, and the name as delivered.
    kind : str, optional
        What the category's sounds are, so that judgements know: event, natural-decay, ambience, voice, music.
    dry : path, optional
        The same sound without reverb, a dry stem or an earlier take: reverb is then compared with it, if the
        two are the same sound.
    presets : iterable of str
        Loudness presets of whole mixes to compare its figures with: ebu-r128, aswg-home, aswg-portable.

    Raises
    ------
    Unreadable
        The file breaks a rule of structure.
    """
    specs = {preset: PRESETS[preset] for preset in presets}
    with AudioFile(path, name=name) as file:
        measurements = file.measurements.to_dict()
        judged, failed = make_judgements(judgements.names(), file, kind)
        if dry is not None and "reverb" in judged:
            compared = compare_reverb_with_dry(path, dry)
            judged["reverb"] = combined_with(judged["reverb"], compared, os.path.basename(os.fspath(dry)))
        return FileReport(
            path=printable_path(path) if name is None else name,
            verdict="unjudged",
            sha256=file.sha256,
            pcm_sha256=file.pcm_sha256,
            category=category,
            facts=file.facts.to_dict(),
            measurements=measurements,
            judgements={check_name: judgement.to_dict() for check_name, judgement in judged.items()},
            loudness_presets={preset_name: preset.against(measurements) for preset_name, preset in specs.items()},
            unjudged=failed_checks(file, failed),
        )


def is_placeholder(path: PathLike) -> bool:
    """Return whether a file carries the mark of a placeholder; Unreadable when it is no sound at all."""
    with AudioFile(path, coded=True) as file:
        file.prepare(())
        return cue_marked(file.metadata.fields) is not None


def view_of(
    spec: DeliverySpec, path: PathLike, *, target: str | None, category: str | None, cue: CueFacts | None
) -> DeliverySpec:
    """Return the view of the spec that a file is judged by."""
    if spec.category is None:
        category = category or (cue.category if cue else None) or spec.category_of(os.fspath(path))
        spec = spec.for_category(category)
    return spec if target is None else spec.for_target(target)


def task_for(
    path: PathLike,
    spec: DeliverySpec | None,
    *,
    target: str | None = None,
    category: str | None = None,
    sound_list: SoundList | None = None,
    views: dict[tuple[int, str | None], DeliverySpec] | None = None,
    dry: PathLike | None = None,
    coded: bool = False,
) -> Task:
    """Return the task of judging one file: its cue found by name, its limits by category and target.

    `views` keeps the views of specs by category, so that many files share them; one target has one.
    `coded` is as in `Task`, and holds for game files of a lossy codec anyway.
    """
    slot = sound_list.slot_of_file(os.fspath(path)) if sound_list else None
    listed = sound_list.listed_name(os.fspath(path)) if sound_list and slot else None
    cue = slot[0] if slot else None
    view = None
    if spec is not None:
        views = {} if views is None else views
        name = category or (cue.category if cue else None) or spec.category_of(os.fspath(path))
        if (id(spec), name) not in views:
            views[id(spec), name] = view_of(spec, path, target=target, category=name, cue=cue)
        view = views[id(spec), name]
    unlisted = sound_list is not None and slot is None
    stem = None if dry is None else DryStem(os.fspath(dry), os.path.basename(printable_path(dry)))
    coded = coded or (view is not None and view.target is not None and view.target.is_lossy)
    return Task(
        os.fspath(path),
        view,
        cue,
        unlisted=unlisted,
        variation=slot[1] if slot else 1,
        dry=stem,
        coded=coded,
        listed_name=listed if listed != os.path.basename(os.fspath(path)) else None,
    )


def with_set_checks(tasks: Sequence[Task], entries: Sequence[FileReport]) -> list[FileReport]:
    """Return the reports on files, with the findings over all of them together."""
    judged = {
        index: JudgedFile(entry, task.spec, task.cue, task.variation, is_alternate=_is_alternate(task))
        for index, (task, entry) in enumerate(zip(tasks, entries, strict=True))
        if task.spec is not None
    }
    reports = dict(zip(judged, with_set_findings(list(judged.values())), strict=True))
    return [reports.get(index, entry) for index, entry in enumerate(entries)]


def _is_alternate(task: Task) -> bool:
    return task.cue is not None and parse_file_name(task.path).alternate is not None


def judge(tasks: list[Task], *, jobs: int = 1, done: Callable[[FileReport], None] | None = None) -> list[FileReport]:
    """Return the report of each file, in order; `done` is called with each as it is finished."""
    jobs = jobs or os.cpu_count() or 1
    if jobs > 1 and len(tasks) > 1:
        from audio_checks.run.processes import in_processes  # costs what a single file need not pay

        return in_processes(_judge_all, tasks, workers=min(jobs, len(tasks)), size=_bytes_of, died=_died, done=done)
    entries = []
    for task in tasks:
        entries.append(_judge(task))
        if done:
            done(entries[-1])
    return entries


def report_on(
    entries: Iterable[FileReport], specs: Iterable[DeliverySpec], views: Iterable[DeliverySpec] = ()
) -> Report:
    """Return the report over what was said of files, the specs that were used, and the views of them."""
    specs = list(specs)
    lacking = {name for spec in [*specs, *views] for name in spec.not_run}
    return Report(
        files=tuple(entries),
        specs=tuple(dict.fromkeys(SpecRef(spec.name, spec.sha256) for spec in specs)),
        not_run=tuple(name for name in check_names.DEFAULT_SEVERITY if name in lacking),
        tool_version=TOOL_VERSION,
    )


def printable_path(path: PathLike) -> str:
    """Return a path as text that any encoding of Unicode can hold; undecodable bytes are shown as escapes."""
    return os.fsencode(path).decode("utf-8", "backslashreplace")


def _judge(
    task: Task, *, name: str | None = None, checks: Iterable[str] | None = None, all_figures: bool = False
) -> FileReport:
    spec = _NO_SPEC if task.spec is None else task.spec
    selected = _selected(spec, task.cue, ["structure"] if task.spec is None and checks is None else checks)
    shown = printable_path(task.path) if name is None else name
    try:
        with AudioFile(
            task.path,
            name=name or task.listed_name or os.path.basename(task.path),
            flac=_reads_flac(spec),
            coded=task.shipped or (task.coded and _reads_coded(spec)),
            dry=task.dry,
        ) as file:
            asked = judgements.names() if all_figures else _judgements_of(selected)
            if not all_figures:
                file.prepare(figure for check in selected for figure in check.figures)
                file.prepare(figure for name in asked for figure in judgements.figures_of(name))
            facts, measurements = file.facts.to_dict(), file.measurements.to_dict()
            likeness_print = file.measurements.likeness_print
            ungraded, crashed = run_checks(selected, file, spec, task.cue)
            judged, failed = make_judgements(asked, file, spec.kind)
            unjudged = failed_checks(file, failed)
    except Unreadable as error:
        return _refused(shown, error, spec)
    except Exception as error:  # whatever breaks in the tool must not be held against the file
        return broken(shown, error, spec.category)
    if task.unlisted:
        ungraded.append(_unlisted())
    findings = [
        graded_finding
        for graded_finding in (graded(finding, spec) for finding in ungraded)
        if graded_finding is not None
    ]
    findings = as_listed(findings, file.name, task.cue)
    verdict: Verdict = "rejected" if any(finding.severity == "error" for finding in findings) else "conforming"
    findings = [*crashed, *findings]
    return FileReport(
        path=shown,
        verdict="unjudged" if crashed else verdict,
        sha256=file.sha256,
        pcm_sha256=file.pcm_sha256,
        category=spec.category,
        facts=facts,
        measurements=measurements,
        judgements={check_name: judgement.to_dict() for check_name, judgement in judged.items()},
        findings=ordered(findings),
        likeness_print=likeness_print,
        unjudged=unjudged,
    )


def broken(path: str, error: BaseException, category: str | None = None) -> FileReport:
    """Return the report of a file that the tool failed on altogether."""
    unjudged = Unjudged("audio-checks", (), in_words(error))
    return FileReport(
        path, "unjudged", category=category, findings=(crash("audio-checks", error),), unjudged=(unjudged,)
    )


def _selected(spec: DeliverySpec, cue: CueFacts | None, wanted: Iterable[str] | None) -> list[Check]:
    checks = all_checks()
    names = list(checks) if wanted is None else list(wanted)
    for name in names:
        if name not in checks:
            raise ValueError(f"no check {name!r}")
    return [checks[name] for name in names if spec.checks.get(name) != "off" and checks[name].applies(spec, cue)]


def _judgements_of(checks: Iterable[Check]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(check.judgement for check in checks if check.judgement))


def _reads_flac(spec: DeliverySpec) -> bool:
    """Whether a FLAC is looked into: where it is accepted, or where another container would not reject it."""
    containers = spec.accept.containers
    return containers is None or "flac" in containers or spec.checks.get("container", "error") != "error"


def _reads_coded(spec: DeliverySpec) -> bool:
    """Whether what a codec keeps is decoded: where the spec names its container, or warns of another."""
    containers = spec.accept.containers
    is_warned = containers is not None and spec.checks.get("container", "error") != "error"
    return is_warned or bool({"ogg", "mp3"} & set(containers or ()))


def _refused(path: str, error: Unreadable, spec: DeliverySpec) -> FileReport:
    if error.code == "container:flac" and path.lower().endswith(".flac"):  # valid, but not accepted
        accepted = spec.accept.containers or ()
        finding = Finding(
            code=error.code,
            message=f"container FLAC, accepted {', '.join(accepted).upper()}",
            fix=f"export the sound as {accepted[0].upper()}" if accepted else error.fix,
            severity="error",
        )
        return FileReport(path, "rejected", category=spec.category, findings=(finding,))
    finding = Finding(code=error.code, message=str(error), fix=error.fix, severity="error")
    return FileReport(path, "unreadable", category=spec.category, findings=(finding,))


def _unlisted() -> Finding:
    return Finding(
        code="naming:unlisted",
        message="no cue of the sound list owns this name",
        fix="rename it to the file name of its cue, or add the cue to the list",
        severity="warning",
    )


def _bytes_of(task: Task) -> int:
    return size_of(task.path)


def _judge_all(tasks: list[Task]) -> list[FileReport]:
    return [_judge(task) for task in tasks]


def _died(task: Task, error: BaseException) -> FileReport:
    return broken(printable_path(task.path), error, task.spec.category if task.spec else None)
