"""Game files and pictures of one take, made in a child and stored."""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any, cast

import structlog
from prometheus_client import Counter

from app.conformance.workspaces import TakeWorkspace
from app.core.runtime import Runtime
from app.core.storage import StoredBlob
from app.renders import drawing, service
from app.renders.children import TIMEOUT_S, retried
from app.renders.models import Picture, Render
from app.renders.pictures import stored_picture
from app.renders.rules import Recipe, RenderState
from audio_checks import (
    AudioChecksError,
    RenderRefused,
    SandboxChild,
    SandboxCrashed,
    SandboxFailed,
    Unreadable,
)

log = structlog.get_logger(__name__)
RENDERS = Counter("soundlist_renders", "Game files made, or refused.", ["state"])
OUR_FAULT = "rendering failed three times; that is our fault, not the master's"


def make_missing(
    runtime: Runtime, order: service.RenderOrder, recipes: dict[str, Recipe], workspace: TakeWorkspace, *, draws: bool
) -> tuple[service.Made, Picture | None]:
    """Return game files of a take, or why they were refused, with their pictures; and that of its master."""
    if not recipes and not draws:
        return [], None
    studio_id, sha256 = order.studio_id, order.master_sha256
    child = workspace.child(order.delivery_id)
    master = workspace.master(studio_id, sha256)
    new_place = partial(workspace.new_place, order.delivery_id)
    outcomes = _outcomes(child, str(master), new_place, recipes, loop=order.loop, draws=draws)
    renders: service.Made = []
    files: dict[str, StoredBlob] = {}
    spectra: dict[str, StoredBlob] = {}
    for target, recipe in recipes.items():
        outcome, target_folder = outcomes[target]
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
        made = cast(drawing.Made, outcome)
        name = drawing.game_file(made["rendered"].encoding)
        files[target] = blob = runtime.store.put_file(studio_id, target_folder / name)
        _describe(render, blob, made["rendered"].to_dict())
        spectra[target] = spectrum = runtime.store.put_file(studio_id, target_folder / drawing.SPECTRUM)
        drawn = stored_picture(runtime, studio_id, blob.sha256, target_folder, made["drawing"], spectrum=spectrum)
        renders.append((render, drawn))
    if not draws:
        return renders, None
    outcome, master_folder = outcomes[drawing.MASTER]
    if isinstance(outcome, AudioChecksError):
        log.info("a sound could not be drawn", sha256=sha256, error=str(outcome))
        return renders, Picture(studio_id=studio_id, sound_sha256=sha256)
    master_drawn = cast(drawing.Drawn, outcome)
    like = master_drawn["preview_of"]
    return renders, stored_picture(
        runtime, studio_id, sha256, master_folder, master_drawn, files.get(like), spectra.get(like)
    )


def _outcomes(
    child: SandboxChild,
    master: str,
    new_place: Callable[[], Path],
    recipes: dict[str, Recipe],
    *,
    loop: bool,
    draws: bool,
) -> dict[str, tuple[drawing.Outcome, Path]]:
    """Return a child's results of a master, with paths; after a failure each part is tried in a child of its own."""
    child.timeout_s = TIMEOUT_S

    def made(some: dict[str, Recipe], draws: bool) -> dict[str, tuple[drawing.Outcome, Path]]:
        folder = str(new_place())
        asked = {target: recipe._asdict() for target, recipe in some.items()}
        done = child.call(drawing.prepare, master, folder, asked, loop=loop, draws_master=draws)
        for part, outcome in done.items():
            if not isinstance(outcome, AudioChecksError) and ("rendered" in outcome) is (part == drawing.MASTER):
                raise SandboxCrashed(f"the answer is not what {part or 'the master'} is to be")
        return {part: (done[part], where) for part, where in drawing.places(folder, some).items() if part in done}

    parts = [*(({target: recipe}, False) for target, recipe in recipes.items()), *([({}, True)] if draws else [])]
    if len(parts) > 1:
        try:
            return made(recipes, draws)
        except SandboxFailed as error:
            log.warning("what a take needs could not be made together", error=str(error))
    outcomes: dict[str, tuple[drawing.Outcome, Path]] = {}
    for some, draws_it in parts:
        try:
            outcomes |= retried(partial(made, some, draws_it))
        except SandboxFailed as error:
            outcomes[next(iter(some), drawing.MASTER)] = error, Path()
    return outcomes


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
