"""The jobs of this room: pictures of masters, game files, and new game files at a new spec."""

import contextlib
import tempfile
from collections.abc import Callable, Iterable
from functools import cache, partial
from pathlib import Path
from typing import Any, TypeVar
from uuid import UUID

import numpy as np
import structlog
from prometheus_client import Counter

from app.conformance.benches import Bench, Children
from app.conformance.checking import judge
from app.conformance.queries import mend_by_id
from app.deliveries.queries import take_with_cue
from app.kit import kill
from app.kit.events import publish
from app.kit.queue import BULK, Payload, job
from app.kit.runtime import Runtime
from app.kit.storage import BlobAltered, BlobMissing, StoredBlob
from app.renders import batches, drawing, master_exports, queries, reel_sound, reels, service, timbre
from app.renders.models import Picture, Render, Timbre
from app.renders.rules import Recipe, RenderState
from audio_checks import (
    AudioChecksError,
    Exported,
    RenderRefused,
    Sandbox,
    SandboxChild,
    SandboxFailed,
    Unreadable,
    export_master,
    spoken,
)

log = structlog.get_logger(__name__)
R = TypeVar("R")
Outcome = dict[str, Any] | AudioChecksError  # what a child tells of what it made, or why it made nothing
TRIES = 3
TIMEOUT_S = 300.0
MEMORY_BYTES = 1 << 30
RENDERS = Counter("soundlist_renders", "Game files made, or refused.", ["state"])
OUR_FAULT = "the renderer itself failed three times; that is our fault, and nothing is wrong with the master"
NO_EXPORT = "the copy could not be made; that is our fault, and the master is whole: ask for it again"
NO_REEL = "the reel could not be made; that is our fault, and the takes are whole: ask for it again"


@cache
def _sandbox() -> Sandbox:
    return Sandbox(timeout_s=TIMEOUT_S, memory_bytes=MEMORY_BYTES, rehearsal=drawing.rehearse)


@cache
def _children() -> Children:
    return Children(_sandbox())


@job("renders.draw_mend")
def draw_mend(runtime: Runtime, payload: Payload) -> None:
    """Draw a mended copy and make its preview, so that its designer sees and hears it before it is used."""
    with runtime.database.reading() as session:
        mend = mend_by_id(session, UUID(payload["mend_id"]))
        if mend is None or mend.sha256 is None:
            return
        if queries.picture_of(session, mend.studio_id, mend.sha256) is not None:
            return
        studio_id, sha256 = mend.studio_id, mend.sha256
        take = take_with_cue(session, mend.take_id)
        loop = take is not None and take.cue is not None and take.cue.loop
    with runtime.store.local_copy(studio_id, sha256) as master, runtime.store.making() as folder:
        try:
            drawn = _tried(_in_child(_sandbox(), [master], [folder], drawing.draw, str(master), str(folder), loop=loop))
        except (Unreadable, RenderRefused, SandboxFailed) as error:
            log.info("a sound could not be drawn", sha256=sha256, error=str(error))
            picture = Picture(studio_id=studio_id, sound_sha256=sha256)
        else:
            picture = _stored_picture(runtime, studio_id, sha256, folder, drawn)
    with runtime.database.writing() as session:
        service.keep_made(session, [], picture)


def _in_child(
    sandbox: Sandbox,
    reads: Iterable[Path],
    writes: Iterable[Path],
    function: Callable[..., R],
    *args: object,
    **options: object,
) -> Callable[[], R]:
    """Return a call of a function in a child that reaches these files and no others."""

    def call() -> R:
        with sandbox.child(reads=reads, writes=writes) as child:
            return child.call(function, *args, **options)

    return call


def _tried(call: Callable[[], R]) -> R:
    """Return what a sandboxed call gives, tried again when its child fails; the last failure is raised."""
    for _ in range(TRIES - 1):
        try:
            return call()
        except SandboxFailed as error:
            log.warning("a sandboxed call failed", error=str(error))
    return call()


def _stored_picture(
    runtime: Runtime,
    studio_id: UUID,
    sound_sha256: str,
    folder: Path,
    drawn: dict[str, Any],
    preview: StoredBlob | None = None,
    spectrum: StoredBlob | None = None,
) -> Picture:
    """Store what was drawn of a sound, but for what is stored already: what plays it, and what that looks like."""
    peaks = runtime.store.put_file(studio_id, folder / drawing.PEAKS)
    spectrum = spectrum or runtime.store.put_file(studio_id, folder / drawing.SPECTRUM)
    if preview is None and not drawn["plays_itself"]:
        preview = runtime.store.put_file(studio_id, folder / drawing.PREVIEW)
    return Picture(
        studio_id=studio_id,
        sound_sha256=sound_sha256,
        duration_s=drawn["duration_s"],
        facts=drawn["facts"],
        thumb=drawn["thumb"],
        peaks_sha256=peaks.sha256,
        spectrum_sha256=spectrum.sha256,
        preview_sha256=preview.sha256 if preview else sound_sha256,
        preview_media_type="audio/wav",
        drawn_bytes=sum(blob.size_bytes for blob in (peaks, spectrum, preview) if blob),
    )


@cache
def _librosa_sandbox() -> Sandbox:
    loaded = ("numpy", "audio_checks", "librosa.core.spectrum", "librosa.feature.spectral", timbre.__name__)
    return Sandbox(timeout_s=TIMEOUT_S, memory_bytes=2 * MEMORY_BYTES, preload=loaded)


@job("renders.hear_take")
def hear_take(runtime: Runtime, payload: Payload) -> None:
    """Measure what a take's master is like, for comparing it with others."""
    with runtime.database.reading() as session:
        take = take_with_cue(session, UUID(payload["take_id"]))
        if take is None or queries.timbre_of(session, take.studio_id, take.master_sha256) is not None:
            return
        studio_id, sha256 = take.studio_id, take.master_sha256
        loop = take.cue is not None and take.cue.loop
    with (
        runtime.store.local_copy(studio_id, sha256) as master,
        tempfile.TemporaryDirectory(prefix="soundlist-") as folder,
    ):
        try:
            heard = _tried(
                _in_child(_librosa_sandbox(), [master], [Path(folder)], timbre.measure, str(master), folder, loop=loop)
            )
        except (Unreadable, RenderRefused, SandboxFailed) as error:
            log.info("a sound could not be compared", sha256=sha256, error=str(error))
            heard = None
    with runtime.database.writing() as session:
        service.keep_timbre(session, Timbre(studio_id=studio_id, sound_sha256=sha256, **(heard or {})))


@job("renders.hear_palette")
def hear_palette(runtime: Runtime, payload: Payload) -> None:
    """Ask for what is needed to compare the sounds of a project, once it has a palette."""
    project_id, studio_id = UUID(payload["project_id"]), UUID(payload["studio_id"])
    with runtime.database.writing() as session:
        if queries.has_palette(session, project_id):
            for take_id in queries.unheard_take_ids(session, project_id):
                publish(session, "take.rendered", studio_id=studio_id, priority=BULK, take_id=take_id)


@job("renders.prepare_take")
def prepare_take(runtime: Runtime, payload: Payload) -> None:
    """Check a received take and record its verdict; then draw it and make its game files, in the same child."""
    with Bench(runtime.store, _children()) as bench:
        take_id = UUID(payload["take_id"])
        judged = judge(runtime, take_id, bench, service.foresee)
        if judged is None:
            _make_renders(runtime, take_id, bench)
            return
        state, foreseen = judged
        if (order := service.settled(foreseen, state)) and not _made(runtime, order, bench):
            # Spec or cue moved on before the verdict was there for others to see: nobody else asks for what they want.
            _make_renders(runtime, take_id, bench)


# Earlier versions had a job for the check alone; such a job, come again after its verdict, makes what is not made yet.
job("conformance.check_take")(prepare_take)


@job("renders.make_renders")
def make_renders(runtime: Runtime, payload: Payload) -> None:
    """Draw the master of a checked take and, of one that may ship, make the game files that its spec wants."""
    with Bench(runtime.store, _children()) as bench:
        _make_renders(runtime, UUID(payload["take_id"]), bench)


# An earlier version asked for a master's picture by itself; such a job draws what is not drawn yet.
job("renders.draw_take")(make_renders)


def _make_renders(runtime: Runtime, take_id: UUID, bench: Bench) -> None:
    with runtime.database.reading() as session:
        order = service.order_making(session, take_id)
    if order is not None:
        _made(runtime, order, bench)


def _made(runtime: Runtime, order: service.RenderOrder, bench: Bench) -> bool:
    """Make what is ordered and put it on record; return False where what was ordered moved on meanwhile."""
    kill.point("renders.before_render")
    renders, picture = _prepared(runtime, order, order.missing, bench, draws=order.draws)
    kill.point("renders.after_render")
    with runtime.database.writing() as session:
        service.keep_made(session, renders, picture)
        holds = not order.may_ship or service.complete(session, order)
        kill.point("renders.before_commit")
    kill.point("renders.after_commit")
    for render, _ in renders:
        RENDERS.labels(render.state.value).inc()
    return holds


def _prepared(
    runtime: Runtime, order: service.RenderOrder, recipes: dict[str, Recipe], bench: Bench, *, draws: bool
) -> tuple[service.Made, Picture | None]:
    """Return game files of a take, or why they were refused, with their pictures; and that of its master."""
    if not recipes and not draws:
        return [], None
    studio_id, sha256 = order.studio_id, order.master_sha256
    child = bench.child(order.delivery_id)
    master = bench.master(studio_id, sha256)
    new_place = partial(bench.new_place, order.delivery_id)
    found = _outcomes(child, str(master), new_place, recipes, loop=order.loop, draws=draws)
    renders: service.Made = []
    files: dict[str, StoredBlob] = {}
    spectra: dict[str, StoredBlob] = {}
    for target, recipe in recipes.items():
        outcome, place = found[target]
        render = Render(
            studio_id=studio_id,
            project_id=order.project_id,
            take_id=order.take_id,
            target=target,
            key=recipe.key(sha256),
            state=RenderState.REFUSED,
        )
        if isinstance(outcome, AudioChecksError):
            render.refusal = _refusal(order, target, outcome)
            renders.append((render, None))
            continue
        files[target] = blob = runtime.store.put_file(studio_id, place / drawing.GAME_FILE)
        _describe(render, blob, outcome["rendered"])
        spectra[target] = spectrum = runtime.store.put_file(studio_id, place / drawing.SPECTRUM)
        drawn = _stored_picture(runtime, studio_id, blob.sha256, place, outcome["drawing"], spectrum=spectrum)
        renders.append((render, drawn))
    if not draws:
        return renders, None
    outcome, place = found[drawing.MASTER]
    if isinstance(outcome, AudioChecksError):
        log.info("a sound could not be drawn", sha256=sha256, error=str(outcome))
        return renders, Picture(studio_id=studio_id, sound_sha256=sha256)
    like = outcome["preview_of"]
    return renders, _stored_picture(runtime, studio_id, sha256, place, outcome, files.get(like), spectra.get(like))


def _outcomes(
    child: SandboxChild,
    master: str,
    new_place: Callable[[], Path],
    recipes: dict[str, Recipe],
    *,
    loop: bool,
    draws: bool,
) -> dict[str, tuple[Outcome, Path]]:
    """Return what a child made of a master, and where; what fails together is tried by itself, in children anew."""
    child.timeout_s = TIMEOUT_S

    def made(some: dict[str, Recipe], draws: bool) -> dict[str, tuple[Outcome, Path]]:
        place = str(new_place())
        asked = {target: recipe._asdict() for target, recipe in some.items()}
        done = child.call(drawing.prepare, master, place, asked, loop=loop, draws_master=draws)
        return {part: (done[part], where) for part, where in drawing.places(place, some).items() if part in done}

    parts = [*(({target: recipe}, False) for target, recipe in recipes.items()), *([({}, True)] if draws else [])]
    if len(parts) > 1:
        try:
            return made(recipes, draws)
        except SandboxFailed as error:
            log.warning("what a take needs could not be made together", error=str(error))
    found: dict[str, tuple[Outcome, Path]] = {}
    for some, draws_it in parts:
        try:
            found |= _tried(partial(made, some, draws_it))
        except SandboxFailed as error:
            found[next(iter(some), drawing.MASTER)] = error, Path()
    return found


def _refusal(order: service.RenderOrder, target: str, error: AudioChecksError) -> str:
    if isinstance(error, (RenderRefused, Unreadable)):
        return f"{error}; {error.fix}"
    log.error("a render failed", take_id=str(order.take_id), target=target, error=str(error))
    return OUR_FAULT


def _describe(render: Render, blob: StoredBlob, rendered: dict[str, Any]) -> None:
    render.state, render.sha256, render.file_bytes = RenderState.MADE, blob.sha256, blob.size_bytes
    render.pcm_sha256 = rendered["pcm_sha256"]
    render.measurements = rendered.pop("measurements")
    render.attenuation_db = rendered.pop("attenuation_db")
    render.loss = rendered.pop("loss")
    render.facts = rendered


@job("renders.renew_renders")
def renew_renders(runtime: Runtime, payload: Payload) -> None:
    """Ask for the game files that a new spec or changed cues want of takes admitted before; old ones stay."""
    project_id = UUID(payload["project_id"])
    if "cue_ids" not in payload:
        with runtime.database.writing() as session:
            batches.begin_for_spec(session, project_id)
        return
    with runtime.database.writing() as session:
        for take_id in queries.admitted_take_ids(session, project_id, [UUID(cue) for cue in payload["cue_ids"]]):
            runtime.queue.enqueue(
                session,
                "renders.make_renders",
                {"take_id": str(take_id)},
                key=f"{payload['event_id']}:renders.make_renders:{take_id}",
                studio_id=UUID(payload["studio_id"]),
                priority=BULK,
            )


@job("renders.plan_batch")
def plan_batch(runtime: Runtime, payload: Payload) -> None:
    """Write down every game file that a batch is about, in one go."""
    with runtime.database.writing() as session:
        batches.plan(session, UUID(payload["batch_id"]))
        kill.point("renders.batch_planned")


@job(batches.MAKE_NEXT)
def make_next_of_batch(runtime: Runtime, payload: Payload) -> None:
    """Make the next game file of one lane of a batch."""
    batch_id, lane = UUID(payload["batch_id"]), int(payload["lane"])
    with runtime.database.reading() as session:
        order = batches.order_next(session, batch_id, lane)
    if order is None:
        return
    render, picture, fault = None, None, ""
    if order.take is not None and order.recipe is not None:
        try:
            with Bench(runtime.store, _children()) as bench:
                ((render, picture),), _ = _prepared(
                    runtime, order.take, {order.target: order.recipe}, bench, draws=False
                )
            RENDERS.labels(render.state.value).inc()
        except (BlobAltered, BlobMissing) as error:  # one lost master must not hold up the others
            fault = str(error)
    kill.point("renders.batch_item_made")
    with runtime.database.writing() as session:
        batches.record(session, order, lane, render, picture, fault)
        kill.point("renders.batch_before_commit")
    kill.point("renders.batch_after_commit")


@job("renders.export_master")
def write_provenance(runtime: Runtime, payload: Payload) -> None:
    """Copy a master with what is known of it written into the copy."""
    export_id = UUID(payload["export_id"])
    with runtime.database.reading() as session:
        found = master_exports.to_make(session, export_id)
    if found is None:
        return
    export, master_sha256, provenance = found
    refusal, blob, left = "", None, []
    with tempfile.TemporaryDirectory(prefix="soundlist-") as folder:
        out = Path(folder, "master.wav")
        try:
            with runtime.store.local_copy(export.studio_id, master_sha256) as master:
                made: Exported = _tried(
                    _in_child(_sandbox(), [master], [Path(folder)], export_master, str(master), str(out), provenance)
                )
            blob, left = runtime.store.put_file(export.studio_id, out), list(made.left)
        except Unreadable as error:
            refusal = f"{error}; {error.fix}"
        except (SandboxFailed, BlobAltered, BlobMissing) as error:
            log.error("a master could not be copied", export_id=str(export_id), error=str(error))
            refusal = NO_EXPORT
    kill.point("renders.before_export")
    with runtime.database.writing() as session:
        if blob is None:
            master_exports.refuse(session, export_id, refusal)
        else:
            master_exports.keep(session, export_id, blob, left=left)


@job("renders.make_reel")
def make_reel(runtime: Runtime, payload: Payload) -> None:
    """Put the previews of a cue's takes in a row, each behind its slate."""
    reel_id = UUID(payload["reel_id"])
    with runtime.database.reading() as session:
        reel = queries.reel_by_id(session, reel_id)
    if reel is None or reel.sha256 is not None:
        return
    slates = None
    if reel.with_slates:
        # What was asked for by an earlier version says nothing of speech, which it tried always.
        slates = _slates(reel.takes, of_set=payload["sets"] == 1, speaks=payload.get("speaks", 1) == 1)
    with tempfile.TemporaryDirectory(prefix="soundlist-") as folder, contextlib.ExitStack() as copies:
        out = Path(folder, "reel.wav")
        try:
            paths = [
                str(copies.enter_context(runtime.store.local_copy(reel.studio_id, take["preview_sha256"])))
                for take in reel.takes
            ]
            made = _tried(
                _in_child(
                    _sandbox(),
                    [Path(path) for path in paths],
                    [Path(folder)],
                    reel_sound.make_reel,
                    paths,
                    slates,
                    str(out),
                    gap_ms=reel.gap_ms,
                    crossfade_ms=reel.crossfade_ms,
                )
            )
        except (SandboxFailed, BlobAltered, BlobMissing) as error:
            log.error("a reel failed", reel_id=str(reel_id), error=str(error))
            with runtime.database.writing() as session:
                reels.refuse(session, reel_id, NO_REEL)
            return
        blob = runtime.store.put_file(reel.studio_id, out)
    kill.point("renders.before_reel")
    with runtime.database.writing() as session:
        is_spoken = slates is not None and all(slate.speech is not None for slate in slates)
        reels.keep(session, reel_id, blob, **made, is_spoken=is_spoken)


def _slates(takes: list[dict[str, Any]], *, of_set: bool, speaks: bool) -> list[reel_sound.Slate]:
    """Return what says which take comes; all are beeped where one cannot be spoken."""
    # Outside of the child, which may start no other program: these words are our own, not a stranger's.
    slates = [reel_sound.Slate(take["variation"] if of_set else 0, take["number"], None) for take in takes]
    if not speaks:
        return slates
    spoken_slates = []
    for slate in slates:
        words = f"variation {slate.variation}, version {slate.version}" if of_set else f"version {slate.version}"
        said = spoken(words, reel_sound.SPEECH_RATE_HZ, None)
        if said is None:
            return slates
        speech = np.round(said * 32_767).astype("<i2").tobytes()
        spoken_slates.append(slate._replace(speech=speech))
    return spoken_slates
