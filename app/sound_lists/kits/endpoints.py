"""The endpoints of starter kits."""

from collections import Counter
from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.projects.errors import ProjectNotFound, TeamNeeded
from app.projects.queries import current_spec
from app.projects.service import project_access
from app.projects.specs.service import read_spec
from app.sound_lists import queries
from app.sound_lists.errors import AdditionInUse, KitNotFound
from app.sound_lists.kits.rules import Kit, all_kits, file_name_of, kit_of
from app.sound_lists.kits.schemas import AdditionUndo, KitRead, KitRow, KitRows, UsualRange
from app.sound_lists.rules import folded
from app.sound_lists.undo import undo_addition

router = APIRouter(prefix="/v1", tags=["sound-lists"])


@router.get("/kits")
def list_kits(_actor: Actor = allows(Audience.PERSON)) -> list[KitRead]:
    """Return the kinds of game that a list can be started from."""
    return [_read(kit) for kit in all_kits()]


def _read(kit: Kit) -> KitRead:
    ranges = {
        field: UsualRange(low=low, high=high)
        for field, (low, high) in (
            ("usual_cues", kit.usual_cues),
            ("usual_hours", kit.usual_hours),
            ("usual_memory_mb", kit.usual_memory_mb),
        )
    }
    return KitRead(
        key=kit.key,
        name=kit.name,
        about=kit.about,
        cues=len(kit.cues),
        files=sum(cue.variations for cue in kit.cues),
        categories=dict(Counter(cue.category for cue in kit.cues)),
        **ranges,
    )


@router.get("/projects/{project_id}/kits/{kit_key}", responses=problems(ProjectNotFound, KitNotFound))
def read_kit(project_id: UUID, kit_key: str, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> KitRows:
    """Return the cues of a kit under the names that the project's spec asks for; nothing is added."""
    project_access(session, actor, project_id)
    kit = kit_of(kit_key)
    if kit is None:
        raise KitNotFound(f'no kit "{kit_key}"')
    spec = read_spec(current_spec(session, project_id).toml)
    named = []
    for cue in kit.cues:
        naming = spec.for_category(cue.category).naming
        named.append((cue, file_name_of(cue, naming.tokens, naming.separator)))
    keys = {folded(name) for _, name in named} | {folded(f"{name}_01") for _, name in named}
    owned = queries.stem_owners(session, project_id, keys)
    rows = [
        KitRow(
            name=cue.name,
            file_name=name,
            category=cue.category,
            description=cue.description,
            use=cue.use,
            duration_s=cue.duration_s,
            loop=cue.loop,
            variations=cue.variations,
            is_listed=folded(name) in owned or folded(f"{name}_01") in owned,
        )
        for cue, name in named
    ]
    return KitRows(key=kit.key, name=kit.name, rows=rows)


@router.post(
    "/projects/{project_id}/cues/undo-addition",
    status_code=204,
    responses=problems(ProjectNotFound, TeamNeeded, AdditionInUse),
)
def undo_cue_addition(
    project_id: UUID, body: AdditionUndo, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> None:
    """Remove the cues that the newest revision added, while no work on them has begun."""
    undo_addition(session, actor, project_id, body.cue_ids)
