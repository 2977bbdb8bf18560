"""The cues in the build and those heard in the game: from audits and listening passes, or set by hand."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.builds.audits import queries as audit_queries
from app.builds.audits.models import MarkedCue
from app.builds.audits.rules import CueMark, is_in_build
from app.builds.audits.schemas import CategoryInGame, CueInGame, GameStates
from app.builds.listening.tasks import cue_read, ensure_may_implement, may_implement
from app.core import clock
from app.projects.errors import ProjectNotFound
from app.projects.service import ProjectAccess, project_access
from app.sound_lists.errors import CueNotFound
from app.sound_lists.queries import cue_by_id

SHOWN = 200


def game_states(session: Session, actor: Actor, project_id: UUID) -> GameStates:
    """Return the share of a list that is in the build, and the sounds never heard in the game, to the team."""
    access = project_access(session, actor, project_id)
    access.ensure_team()
    return _states(session, access)


def mark_cue(session: Session, actor: Actor, cue_id: UUID, *, mark: CueMark, is_set: bool) -> GameStates:
    """Set a state of a cue by hand, or take that back; what an audit or a listening pass says stands beside it."""
    cue = cue_by_id(session, cue_id)
    if cue is None:
        raise CueNotFound(f"no cue {cue_id}")
    try:
        access = project_access(session, actor, cue.project_id)
    except ProjectNotFound:
        raise CueNotFound(f"no cue {cue_id}") from None
    ensure_may_implement(access)
    marked_cue = session.get(MarkedCue, (cue_id, mark), with_for_update=True)
    if is_set and marked_cue is None:
        session.add(
            MarkedCue(
                cue_id=cue_id, mark=mark, studio_id=cue.studio_id, project_id=cue.project_id, marked_by=actor.person,
                marked_at=clock.now(),
            )
        )  # fmt: skip
    elif marked_cue is not None and not is_set:
        session.delete(marked_cue)
    session.flush()
    return _states(session, access)


def cues_in_build(session: Session, project_id: UUID) -> set[UUID]:
    """Return the cues that are in the build: by the newest audit, or set by hand."""
    newest = audit_queries.newest_audit(session, project_id)
    statuses = audit_queries.statuses_by_cue(session, newest.id) if newest else {}
    marked = {mark.cue_id for mark in audit_queries.marks_of(session, project_id) if mark.mark is CueMark.IN_BUILD}
    return marked | {cue_id for cue_id, of_cue in statuses.items() if is_in_build(of_cue)}


def _states(session: Session, access: ProjectAccess) -> GameStates:
    project_id = access.project.id
    cues = audit_queries.wanted_cues(session, project_id)
    newest = audit_queries.newest_audit(session, project_id)
    statuses = audit_queries.statuses_by_cue(session, newest.id) if newest else {}
    heard = audit_queries.heard_cues(session, project_id)
    marked = {(mark.cue_id, mark.mark) for mark in audit_queries.marks_of(session, project_id)}
    states = [
        CueInGame(
            cue=cue_read(access.project, cue),
            category=cue.category,
            in_build="audit"
            if is_in_build(statuses.get(cue.id, ()))
            else "hand"
            if (cue.id, CueMark.IN_BUILD) in marked
            else None,
            heard="pass" if cue.id in heard else "hand" if (cue.id, CueMark.HEARD) in marked else None,
        )
        for cue in cues
    ]
    categories = dict.fromkeys(state.category for state in states)
    return GameStates(
        cues=len(states),
        in_build=sum(state.in_build is not None for state in states),
        heard=sum(state.heard is not None for state in states),
        never_heard=sum(state.heard is None for state in states),
        build=newest.label if newest else None,
        categories=[
            CategoryInGame(
                category=category,
                cues=sum(state.category == category for state in states),
                heard=sum(state.category == category and state.heard is not None for state in states),
            )
            for category in categories
        ],
        unheard=[state for state in states if state.heard is None][:SHOWN],
        may_mark=may_implement(access),
    )
