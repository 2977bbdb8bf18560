"""Renders and pictures: what a caller sees of them, and how they are recorded."""

from dataclasses import dataclass
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.conformance.models import Fix
from app.conformance.queries import made_fix_of
from app.core.db import insert_all_if_absent, insert_if_absent, row_of
from app.core.events import publish
from app.core.jobs.queue import BULK
from app.deliveries.downloads import closed_to, ensure_open
from app.deliveries.models import Take
from app.deliveries.queries import stem_of, take_with_cue
from app.deliveries.service import take_for
from app.projects.queries import current_spec
from app.renders import queries
from app.renders.errors import LossUnknown, NotDrawn, NothingRendered, RenderNotFound, SoundNotFound
from app.renders.models import Picture, Render, RenderSet, Timbre
from app.renders.rules import RENDERED_STATES, Recipe, ending_of
from app.renders.schemas import LossRead, MasterSoundRead, RenderSoundRead, SoundBrief, TakeSoundsRead
from app.renders.shown_render_queries import ShownPicture
from app.renders.thumb_queries import Thumb

Made = list[tuple[Render, Picture | None]]  # game files, each with its picture where there is a file


def take_sounds(session: Session, actor: Actor, take_id: UUID) -> TakeSoundsRead:
    """Return a take's master and its game files at the current spec, with what is needed to show and play them."""
    take, _ = take_for(session, actor, take_id)
    closed = closed_to(session, actor, take.cue_id, take.designer_id)
    specs = {take.project_id: current_spec(session, take.project_id)}
    renders = queries.current_renders(session, specs, [take])[take.id]
    fix = made_fix_of(session, take.id)
    hashes = [take.master_sha256, *(render.sha256 for render in renders.values() if render and render.sha256)]
    if fix is not None and fix.sha256 is not None:
        hashes.append(fix.sha256)
    pictures = queries.pictures_of_sounds(session, [take.studio_id], hashes)
    return TakeSoundsRead(
        take_id=take.id,
        master=master_sound(take, pictures.get(take.master_sha256)),
        fix=_fix_sound(fix, pictures),
        renders=[
            render_sound(target, render, picture_of_render(render, pictures), is_closed=closed is not None)
            for target, render in renders.items()
        ],
        closed=closed,
    )


def _fix_sound(fix: Fix | None, pictures: dict[str, Picture]) -> SoundBrief | None:
    picture = pictures.get(fix.sha256) if fix and fix.sha256 else None
    return SoundBrief(**_sound(picture)) if picture else None


def _sound(picture: Picture | None) -> dict[str, Any]:
    return sound_places(picture, picture.thumb if picture else None)


def sound_places(picture: Picture | ShownPicture | None, thumb: Thumb | None) -> dict[str, Any]:
    """Return the fields of a SoundBrief: where a sound's preview, peaks and spectrum are."""
    if picture is None:
        return dict.fromkeys(SoundBrief.model_fields)
    address = f"/v1/sounds/{picture.id}"
    return {
        "picture_id": picture.id,
        "duration_s": picture.duration_s,
        "thumb": thumb or None,
        "preview_url": f"{address}/preview" if picture.preview_sha256 else None,
        "peaks_url": f"{address}/peaks.json" if picture.peaks_sha256 else None,
        "spectrum_url": f"{address}/spectrum.png" if picture.spectrum_sha256 else None,
    }


def master_sound(take: Take, picture: Picture | None) -> MasterSoundRead:
    """Return a take's master as it is shown."""
    return MasterSoundRead(
        **_sound(picture),
        state="drawing" if picture is None else "drawn" if picture.preview_sha256 else "undrawable",
        facts=picture.facts if picture else {},
        file_bytes=take.master_bytes,
    )


def render_sound(
    target: str, render: Render | None, picture: Picture | None, *, is_closed: bool = False
) -> RenderSoundRead:
    """Return one game file as it is shown; `waiting` while it is still to be made."""
    return RenderSoundRead(
        **_sound(picture),
        id=render.id if render else None,
        target=target,
        state=render.state.value if render else "waiting",
        refusal=render.refusal if render else None,
        facts=render.facts if render else {},
        measurements=render.measurements if render else {},
        attenuation_db=render.attenuation_db if render else None,
        file_bytes=render.file_bytes if render else None,
        file_url=f"/v1/renders/{render.id}/file" if render and render.sha256 and not is_closed else None,
    )


def picture_of_render(render: Render | None, pictures: dict[str, Picture]) -> Picture | None:
    """Return the picture of a render's file out of those at hand."""
    return pictures.get(render.sha256) if render and render.sha256 else None


def picture_in_sight(session: Session, actor: Actor, picture_id: UUID) -> Picture:
    """Return a picture; raise SoundNotFound where the caller sees no take that it shows."""
    picture = queries.visible_picture(session, actor, picture_id)
    if picture is None:
        raise SoundNotFound(f"no sound {picture_id}")
    return picture


def preview_file(picture: Picture, *, light: bool) -> tuple[str, str]:
    """Return the hash and media type of what plays a sound; the light preview where it is asked for and made."""
    if light and picture.light_sha256 is not None:
        return picture.light_sha256, "audio/ogg"
    return drawn(picture.preview_sha256), picture.preview_media_type or "audio/wav"


def drawn(sha256: str | None) -> str:
    """Return the hash of something drawn; raise NotDrawn if there is none."""
    if sha256 is None:
        raise NotDrawn("the waveform could not be drawn; that is our fault, and the master is not affected")
    return sha256


def render_file(session: Session, actor: Actor, render_id: UUID) -> tuple[Render, str, str]:
    """Return a made render, the hash of its file, and the name that the game expects it under.

    Raises RenderNotFound, NothingRendered where it was refused, DownloadUnpaid where its contract opens it by payment.
    """
    render_and_take = queries.visible_render(session, actor, render_id)
    if render_and_take is None:
        raise RenderNotFound(f"no render {render_id}")
    render, take = render_and_take
    if render.sha256 is None:
        raise NothingRendered(f"the render for {render.target} was refused: {render.refusal}")
    ensure_open(session, actor, take.cue_id, take.designer_id)
    stem = stem_of(session, take) or "render"
    return render, render.sha256, f"{stem}{ending_of(render.facts)}"


def render_loss(session: Session, actor: Actor, render_id: UUID) -> LossRead:
    """Return the loss of a game file; raise LossUnknown if it was not measured."""
    render_and_take = queries.visible_render(session, actor, render_id)
    if render_and_take is None:
        raise RenderNotFound(f"no render {render_id}")
    if render_and_take[0].loss is None:
        raise LossUnknown(
            "the quality loss of this file was not measured: it was refused, or rendered by an earlier version",
            fix="re-render the game files",
        )
    return LossRead.model_validate(render_and_take[0].loss)


@dataclass(frozen=True)
class RenderOrder:
    """The renders to make of a take, read at one moment."""

    may_ship: bool
    draws: bool  # its master
    loop: bool
    category: str  # of its cue, "" for none
    take_id: UUID
    delivery_id: UUID
    edition: int
    studio_id: UUID
    project_id: UUID
    master_sha256: str
    spec_id: UUID
    missing: dict[str, Recipe]  # by target
    there: dict[str, Render]  # what stands already for the other targets


def order_renders(session: Session, take_id: UUID) -> RenderOrder | None:
    """Return the render order of a take; None where it may not ship, or is for no cue yet."""
    order = order_renders_and_drawing(session, take_id)
    return order if order is not None and order.may_ship else None


def order_renders_and_drawing(session: Session, take_id: UUID) -> RenderOrder | None:
    """Return the order for a take that may ship, and whether its master is to be drawn; None for neither."""
    take = take_with_cue(session, take_id)
    if take is None or take.master_deleted_at is not None:
        return None
    is_drawn, has_renders = queries.current_state(session, take)
    may_ship = take.cue is not None and take.state in RENDERED_STATES
    if is_drawn and not may_ship:
        return None
    spec = current_spec(session, take.project_id)
    recipes = queries.wanted_recipes(spec, take) if may_ship else {}
    made = queries.current_renders(session, {take.project_id: spec}, [take])[take.id] if has_renders else {}
    return RenderOrder(
        may_ship=may_ship,
        draws=not is_drawn,
        loop=take.cue is not None and take.cue.loop,
        category=take.cue.category if take.cue is not None else "",
        take_id=take.id,
        delivery_id=take.delivery_id,
        edition=take.edition,
        studio_id=take.studio_id,
        project_id=take.project_id,
        master_sha256=take.master_sha256,
        spec_id=spec.id,
        missing={target: recipe for target, recipe in recipes.items() if made.get(target) is None},
        there={target: render for target, render in made.items() if render is not None},
    )


def save_renders(session: Session, renders: Made, picture: Picture | None = None) -> None:
    """Put game files with their pictures, and the picture of another sound, on record, each once."""
    pictures = [row_of(drawing) for drawing in (*(drawn for _, drawn in renders), picture) if drawing is not None]
    insert_all_if_absent(session, Picture, pictures, unique=("studio_id", "sound_sha256"))
    made = [row_of(render) for render, _ in renders]
    insert_all_if_absent(session, Render, made, unique=("take_id", "target", "key"))


def complete(session: Session, order: RenderOrder) -> bool:
    """Say that every render of a take is made or refused; return False if take, spec or cue changed meanwhile."""
    now = queries.take_snapshot(session, order.take_id)
    ordered = (order.edition, order.spec_id, order.category, order.loop)
    if now is None or (now.edition, now.spec_id, now.category, now.loop) != ordered:
        return False
    whole = {"studio_id": order.studio_id, "spec_id": order.spec_id, "edition": order.edition}
    if not insert_if_absent(session, RenderSet, {"take_id": order.take_id, **whole}, unique=("take_id",)):
        session.merge(RenderSet(take_id=order.take_id, **whole))
    if now.has_palette:
        publish(session, "take.rendered", studio_id=order.studio_id, priority=BULK, take_id=order.take_id)
    return True


def save_timbre(session: Session, timbre: Timbre) -> None:
    """Put the timbre of a sound on record, once."""
    if queries.timbre_of(session, timbre.studio_id, timbre.sound_sha256) is None:
        session.add(timbre)
        session.flush()
