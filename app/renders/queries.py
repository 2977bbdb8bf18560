"""Renders and pictures within the caller's reach."""

from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping, Sequence
from functools import cache, lru_cache
from typing import NamedTuple, TypeVar
from uuid import UUID

from sqlalchemy import ColumnElement, Row, Select, bindparam, exists, func, or_, select
from sqlalchemy.orm import InstrumentedAttribute, Session, aliased, contains_eager, joinedload

import audio_checks
from app.accounts.rules import Actor
from app.conformance.models import Fix
from app.core.in_array import in_array
from app.deliveries.models import Take
from app.projects.models import Spec
from app.projects.visibility import visible_work
from app.renders.models import Batch, BatchItem, MasterExport, Picture, Reel, Render, Timbre
from app.renders.other_sounds.queries import opened_takes
from app.renders.rules import OPEN_BATCHES, RENDERED_STATES, BatchState, ItemState, Recipe, RenderState, recipes
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState

Stored = TypeVar("Stored")
RenderRow = Row[UUID, str, str, RenderState, int | None, str | None]


@lru_cache(maxsize=64)
def parsed_spec(toml: str) -> audio_checks.DeliverySpec:
    """Return the spec from its stored form."""
    return audio_checks.parse_spec(toml)


def wanted_recipes(spec: Spec, take: Take) -> dict[str, Recipe]:
    """Return a spec's recipes for a take (its cue loaded), by target; nothing while it is unmatched."""
    return {} if take.cue is None else _recipes(spec.toml, _category(spec, take, take.cue), loop=take.cue.loop)


def _wanted_keys(spec: Spec, take: Take) -> dict[str, str]:
    if take.cue is None:
        return {}
    return _keys(spec.toml, _category(spec, take, take.cue), take.master_sha256, loop=take.cue.loop)


def _category(spec: Spec, take: Take, cue: Cue) -> str | None:
    return cue.category or parsed_spec(spec.toml).category_of(take.file_name)


@lru_cache(maxsize=512)
def _recipes(toml: str, category: str | None, *, loop: bool) -> dict[str, Recipe]:
    return recipes(parsed_spec(toml), category=category, loop=loop)


@lru_cache(maxsize=4096)  # a page of the review queue asks for the same again and again
def _keys(toml: str, category: str | None, master_sha256: str, *, loop: bool) -> dict[str, str]:
    target_recipes = _recipes(toml, category, loop=loop)
    return {target: recipe.key(master_sha256) for target, recipe in target_recipes.items()}


def renders_by_key(session: Session, take_ids: Collection[UUID]) -> dict[tuple[UUID, str, str], Render]:
    """Return the renders of takes, by take, target and key."""
    renders = session.scalars(_renders(), {"take_ids": take_ids})
    return {(render.take_id, render.target, render.key): render for render in renders}


@cache  # built once: that takes longer than to send it
def _renders() -> Select[Render]:
    return select(Render).where(in_array(Render.take_id, "take_ids"))


def pictures_of_sounds(session: Session, studio_ids: Collection[UUID], sha256s: Collection[str]) -> dict[str, Picture]:
    """Return the pictures of stored sounds, by their hashes."""
    pictures = session.scalars(
        select(Picture).where(in_array(Picture.studio_id, studio_ids), in_array(Picture.sound_sha256, sha256s))
    )
    return {picture.sound_sha256: picture for picture in pictures}


def picture_of(session: Session, studio_id: UUID, sha256: str) -> Picture | None:
    """Return the picture of one stored sound."""
    return session.scalar(_picture_of(), {"studio_id": studio_id, "sha256": sha256})


@cache
def _picture_of() -> Select[Picture]:
    return select(Picture).where(
        Picture.studio_id == bindparam("studio_id"), Picture.sound_sha256 == bindparam("sha256")
    )


def timbre_of(session: Session, studio_id: UUID, sha256: str) -> Timbre | None:
    """Return the features of one stored sound."""
    return session.scalar(select(Timbre).where(Timbre.studio_id == studio_id, Timbre.sound_sha256 == sha256))


def has_palette(session: Session, project_id: UUID) -> bool:
    """Whether a project's list marks any cue as its palette."""
    return bool(session.scalar(select(_marks_a_palette(Cue, project_id))))


def _marks_a_palette(cue: type[Cue], project_id: UUID | InstrumentedAttribute[UUID]) -> ColumnElement[bool]:
    return exists().where(cue.project_id == project_id, cue.palette, cue.state != CueState.CUT)


def current_state(session: Session, take: Take) -> tuple[bool, bool]:
    """Return whether a take's master is drawn, and whether any game file was made of it or refused."""
    sought = {"studio_id": take.studio_id, "sha256": take.master_sha256, "take_id": take.id}
    is_drawn, has_renders = session.execute(_current_state(), sought).one()
    return is_drawn, has_renders


@cache
def _current_state() -> Select[bool, bool]:
    of_sound = (Picture.studio_id == bindparam("studio_id"), Picture.sound_sha256 == bindparam("sha256"))
    return select(exists().where(*of_sound), exists().where(Render.take_id == bindparam("take_id")))


class TakeSnapshot(NamedTuple):
    """The facts that decide whether an order for a take is still valid, and whether its project has a palette."""

    edition: int
    spec_id: UUID
    category: str
    loop: bool
    has_palette: bool


def take_snapshot(session: Session, take_id: UUID) -> TakeSnapshot | None:
    """Return the current facts of a matched take, its cue and the newest spec of its project."""
    row = session.execute(_take_snapshot(), {"take_id": take_id}).one_or_none()
    return TakeSnapshot._make(row) if row else None


@cache
def _take_snapshot() -> Select[int, UUID, str, bool, bool]:
    newest = select(Spec.id).where(Spec.project_id == Take.project_id).order_by(Spec.version.desc()).limit(1)
    palette = _marks_a_palette(aliased(Cue), Take.project_id)
    query = select(Take.edition, newest.scalar_subquery(), Cue.category, Cue.loop, palette)
    return query.select_from(Take).join(Cue, Cue.id == Take.cue_id).where(Take.id == bindparam("take_id"))


def take_ids_without_timbre(session: Session, project_id: UUID) -> Sequence[UUID]:
    """Return the matched takes of a project that may still ship and whose sound has not been measured yet."""
    heard = exists().where(Timbre.studio_id == Take.studio_id, Timbre.sound_sha256 == Take.master_sha256)
    query = select(Take.id).where(Take.project_id == project_id, Take.state.in_(RENDERED_STATES), ~heard)
    return session.scalars(query.where(Take.cue_id.is_not(None)).order_by(Take.id)).all()


def _in_reach(actor: Actor) -> ColumnElement[bool]:
    """Admit the takes that the caller sees."""
    return visible_work(actor, studio_id=Take.studio_id, project_id=Take.project_id, designer_id=Take.designer_id)


def visible_picture(session: Session, actor: Actor, picture_id: UUID) -> Picture | None:
    """Return a picture that shows a take that the caller sees (master, render, fix), or a master that they may hear."""
    of_master = exists().where(
        Take.studio_id == Picture.studio_id, Take.master_sha256 == Picture.sound_sha256, _in_reach(actor)
    )
    of_render = exists().where(
        Render.studio_id == Picture.studio_id,
        Render.sha256 == Picture.sound_sha256,
        Render.take_id == Take.id,
        _in_reach(actor),
    )
    of_fix = exists().where(
        Fix.studio_id == Picture.studio_id,
        Fix.sha256 == Picture.sound_sha256,
        Fix.take_id == Take.id,
        _in_reach(actor),
    )
    of_another = exists().where(
        Take.studio_id == Picture.studio_id, Take.master_sha256 == Picture.sound_sha256, opened_takes(actor)
    )
    seen = or_(of_master, of_render, of_fix, of_another)
    return session.scalar(select(Picture).where(Picture.id == picture_id, seen))


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
    """Return the current render of each target of the newest spec, by take (its cue loaded); None: not made yet.

    `specs` are the newest specs by project.
    """
    takes = list(takes)
    return current(specs, takes, renders_by_key(session, [take.id for take in takes]))


def current(
    specs: Mapping[UUID, Spec], takes: Iterable[Take], stored: Mapping[tuple[UUID, str, str], Stored]
) -> dict[UUID, dict[str, Stored | None]]:
    """Return the current ones of the stored renders, by take (its cue loaded) and target."""
    return {
        take.id: {
            target: stored.get((take.id, target, key))
            for target, key in _wanted_keys(specs[take.project_id], take).items()
        }
        for take in takes
    }


def admitted_take_ids(session: Session, project_id: UUID, cue_ids: Collection[UUID]) -> Sequence[UUID]:
    """Return the matched takes of some cues that may still ship."""
    query = select(Take.id).where(
        Take.project_id == project_id, Take.state.in_(RENDERED_STATES), in_array(Take.cue_id, cue_ids)
    )
    return session.scalars(query.order_by(Take.id)).all()


def admitted_takes(session: Session, project_id: UUID) -> Sequence[Take]:
    """Return the matched takes of a project that may still ship, with their cues, in list order."""
    return session.scalars(
        select(Take)
        .join(Cue, Cue.id == Take.cue_id)
        .where(Take.project_id == project_id, Take.state.in_(RENDERED_STATES))
        .options(contains_eager(Take.cue))
        .order_by(Cue.position, Cue.number, Take.variation, Take.number)
    ).all()


def has_admitted_takes(session: Session, project_id: UUID) -> bool:
    """Whether a project has takes that may still ship."""
    admitted = exists().where(Take.project_id == project_id, Take.state.in_(RENDERED_STATES), Take.cue_id.is_not(None))
    return bool(session.scalar(select(admitted)))


def renders_so_far(session: Session, project_id: UUID) -> dict[tuple[UUID, str], list[RenderRow]]:
    """Return the keys of all renders of a project, by take and target, the oldest first."""
    renders_by_take: dict[tuple[UUID, str], list[RenderRow]] = defaultdict(list)
    rows = session.execute(
        select(Render.take_id, Render.target, Render.key, Render.state, Render.file_bytes, Render.refusal)
        .where(Render.project_id == project_id)
        .order_by(Render.id)
    )
    for row in rows:
        renders_by_take[row.take_id, row.target].append(row)
    return renders_by_take


def batch_by_id(session: Session, batch_id: UUID, *, locked: bool = False) -> Batch | None:
    """Return a batch without a check of the caller; locked where it is going to change."""
    query = select(Batch).where(Batch.id == batch_id)
    if locked:
        query = query.with_for_update().execution_options(populate_existing=True)
    return session.scalar(query)


def batches_of(session: Session, project_id: UUID, *, before: UUID | None, limit: int) -> Sequence[Batch]:
    """Return the batches of a project, the newest first."""
    query = select(Batch).where(Batch.project_id == project_id)
    if before is not None:
        query = query.where(Batch.id < before)
    return session.scalars(query.order_by(Batch.id.desc()).limit(limit)).all()


def open_batches(session: Session, project_id: UUID) -> Sequence[Batch]:
    """Return the batches of a project that still run, to be ended."""
    return session.scalars(
        select(Batch).where(Batch.project_id == project_id, Batch.state.in_(OPEN_BATCHES)).with_for_update()
    ).all()


def last_batch_number(session: Session, project_id: UUID) -> int:
    """Return the number of the newest batch; 0 where there was none."""
    return session.scalar(select(func.max(Batch.number)).where(Batch.project_id == project_id)) or 0


def item_counts(session: Session, batch_ids: Collection[UUID]) -> dict[UUID, dict[ItemState, int]]:
    """Return the number of game files of each batch in each state."""
    counts: dict[UUID, dict[ItemState, int]] = defaultdict(dict)
    rows = session.execute(
        select(BatchItem.batch_id, BatchItem.state, func.count())
        .where(in_array(BatchItem.batch_id, batch_ids))
        .group_by(BatchItem.batch_id, BatchItem.state)
    )
    for batch_id, state, count in rows:
        counts[batch_id][state] = count
    return counts


def item_sizes(session: Session, batch_id: UUID) -> Sequence[Row[str, str, int, int | None, int | None]]:
    """Return for each target and category how many game files a batch has, and their bytes before and after."""
    return session.execute(
        select(
            BatchItem.target,
            BatchItem.category,
            func.count(),
            func.sum(BatchItem.before_bytes),
            func.sum(BatchItem.after_bytes),
        )
        .where(BatchItem.batch_id == batch_id)
        .group_by(BatchItem.target, BatchItem.category)
        .order_by(BatchItem.target, BatchItem.category)
    ).all()


def items_without_file(session: Session, batch_id: UUID, *, limit: int) -> Sequence[Row[BatchItem, int, str]]:
    """Return game files of a batch that were refused or left out, each with its cue's number and name."""
    return session.execute(
        select(BatchItem, Cue.number, Cue.name)
        .join(Take, Take.id == BatchItem.take_id)
        .join(Cue, Cue.id == Take.cue_id)
        .where(BatchItem.batch_id == batch_id, BatchItem.state.in_((ItemState.REFUSED, ItemState.LEFT)))
        .order_by(BatchItem.place)
        .limit(limit)
    ).all()


def next_item(session: Session, batch_id: UUID, lane: int, lanes: int) -> BatchItem | None:
    """Return the next game file that a lane of a running batch is to make."""
    return session.scalar(
        select(BatchItem)
        .join(Batch, Batch.id == BatchItem.batch_id)
        .where(
            Batch.id == batch_id,
            Batch.state == BatchState.RUNNING,
            BatchItem.state == ItemState.WAITING,
            BatchItem.place % lanes == lane,
        )
        .order_by(BatchItem.place)
        .limit(1)
    )


def has_waiting_items(session: Session, batch_id: UUID) -> bool:
    """Whether a batch has game files to make."""
    return bool(
        session.scalar(select(exists().where(BatchItem.batch_id == batch_id, BatchItem.state == ItemState.WAITING)))
    )


def visible_takes_of_cue(session: Session, actor: Actor, cue_id: UUID, *, newest_first: bool) -> Sequence[Take]:
    """Return the takes of a cue that the caller sees, variation by variation."""
    by_number = Take.number.desc() if newest_first else Take.number
    return session.scalars(
        select(Take).where(Take.cue_id == cue_id, _in_reach(actor)).order_by(Take.variation, by_number)
    ).all()


def can_see_takes(session: Session, actor: Actor, take_ids: Collection[UUID]) -> bool:
    """Whether the caller sees every one of some takes."""
    seen = session.scalar(select(func.count()).where(in_array(Take.id, take_ids), _in_reach(actor)))
    return seen == len(take_ids)


def reel_by_id(session: Session, reel_id: UUID) -> Reel | None:
    """Return a reel without a check of the caller."""
    return session.get(Reel, reel_id)


def reel_of(session: Session, cue_id: UUID, key: str) -> Reel | None:
    """Return the reel of a cue under one key; locked against others until the transaction ends."""
    session.execute(select(Cue.id).where(Cue.id == cue_id).with_for_update(key_share=True))
    return session.scalar(select(Reel).where(Reel.cue_id == cue_id, Reel.key == key))


def master_export_by_id(session: Session, export_id: UUID) -> MasterExport | None:
    """Return a handed-out master without a check of the caller."""
    return session.get(MasterExport, export_id)


def master_export_of(session: Session, take_id: UUID, key: str) -> MasterExport | None:
    """Return the handed-out master of a take under one key; locked against others until the transaction ends."""
    session.execute(select(Take.id).where(Take.id == take_id).with_for_update(key_share=True))
    return session.scalar(select(MasterExport).where(MasterExport.take_id == take_id, MasterExport.key == key))
