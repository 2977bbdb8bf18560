"""Renders and pictures within the caller's reach."""

from collections.abc import Collection, Iterable, Mapping, Sequence
from functools import lru_cache
from uuid import UUID

from sqlalchemy import ColumnElement, and_, exists, or_, select
from sqlalchemy.orm import Session, joinedload

import audio_checks
from app.accounts.rules import Actor
from app.conformance.models import Mend
from app.deliveries.models import Take
from app.projects.models import Engagement, Spec
from app.renders.models import Picture, Render
from app.renders.rules import RENDERED_STATES, Recipe, recipes


@lru_cache(maxsize=64)
def parsed_spec(toml: str) -> audio_checks.DeliverySpec:
    """Return what a stored spec says."""
    return audio_checks.parse_spec(toml)


def wanted_recipes(spec: Spec, take: Take) -> dict[str, Recipe]:
    """Return what a spec wants made of a take (its cue loaded), by target; nothing while it is unmatched."""
    if take.cue is None:
        return {}
    whole = parsed_spec(spec.toml)
    return recipes(whole, category=take.cue.category or whole.category_of(take.file_name), loop=take.cue.loop)


def _renders_by_key(session: Session, take_ids: Iterable[UUID]) -> dict[tuple[UUID, str, str], Render]:
    renders = session.scalars(select(Render).where(Render.take_id.in_(list(take_ids))))
    return {(render.take_id, render.target, render.key): render for render in renders}


def pictures_of_sounds(session: Session, studio_ids: Iterable[UUID], sha256s: Iterable[str]) -> dict[str, Picture]:
    """Return the pictures of stored sounds, by their hashes."""
    pictures = session.scalars(
        select(Picture).where(Picture.studio_id.in_(list(studio_ids)), Picture.sound_sha256.in_(set(sha256s)))
    )
    return {picture.sound_sha256: picture for picture in pictures}


def picture_of(session: Session, studio_id: UUID, sha256: str) -> Picture | None:
    """Return the picture of one stored sound."""
    return session.scalar(select(Picture).where(Picture.studio_id == studio_id, Picture.sound_sha256 == sha256))


def _in_reach(actor: Actor) -> ColumnElement[bool]:
    """Admit takes of the caller's studios, and those the caller made in projects they are engaged on."""
    engaged = exists().where(
        Engagement.project_id == Take.project_id,
        Engagement.designer_id == actor.person_id,
        Engagement.ended_at.is_(None),
    )
    return or_(
        Take.studio_id.in_([studio for studio, roles in actor.roles.items() if roles]),
        and_(Take.designer_id == actor.person_id, engaged),
    )


def visible_picture(session: Session, actor: Actor, picture_id: UUID) -> Picture | None:
    """Return a picture when it shows the master, a render or a mend of a take that the caller sees."""
    of_master = exists().where(
        Take.studio_id == Picture.studio_id, Take.master_sha256 == Picture.sound_sha256, _in_reach(actor)
    )
    of_render = exists().where(
        Render.studio_id == Picture.studio_id,
        Render.sha256 == Picture.sound_sha256,
        Render.take_id == Take.id,
        _in_reach(actor),
    )
    of_mend = exists().where(
        Mend.studio_id == Picture.studio_id,
        Mend.sha256 == Picture.sound_sha256,
        Mend.take_id == Take.id,
        _in_reach(actor),
    )
    return session.scalar(select(Picture).where(Picture.id == picture_id, or_(of_master, of_render, of_mend)))


def visible_render(session: Session, actor: Actor, render_id: UUID) -> tuple[Render, Take] | None:
    """Return a render and its take, with its cue, when the caller sees them."""
    row = session.execute(
        select(Render, Take)
        .join(Take, Take.id == Render.take_id)
        .where(Render.id == render_id, _in_reach(actor))
        .options(joinedload(Take.cue))
    ).one_or_none()
    return (row[0], row[1]) if row else None


def current_renders(
    session: Session, specs: Mapping[UUID, Spec], takes: Iterable[Take]
) -> dict[UUID, dict[str, Render | None]]:
    """Return what stands for each target of the newest spec, by take (its cue loaded); None: not made yet.

    `specs` are the newest specs by project.
    """
    takes = list(takes)
    stored = _renders_by_key(session, [take.id for take in takes])
    return {
        take.id: {
            target: stored.get((take.id, target, recipe.key(take.master_sha256)))
            for target, recipe in wanted_recipes(specs[take.project_id], take).items()
        }
        for take in takes
    }


def admitted_take_ids(session: Session, project_id: UUID, cue_ids: Collection[UUID] | None) -> Sequence[UUID]:
    """Return the matched takes of a project that may still ship; those of some cues where they are given."""
    query = select(Take.id).where(
        Take.project_id == project_id, Take.state.in_(RENDERED_STATES), Take.cue_id.is_not(None)
    )
    if cue_ids is not None:
        query = query.where(Take.cue_id.in_(cue_ids))
    return session.scalars(query.order_by(Take.id)).all()


def render_of(session: Session, take_id: UUID, target: str, key: str) -> Render | None:
    """Return the render of a take for one target under one key."""
    return session.scalar(select(Render).where(Render.take_id == take_id, Render.target == target, Render.key == key))
