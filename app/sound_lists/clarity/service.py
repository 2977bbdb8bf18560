"""The clarity check of a list: which cues a designer could not make from their words, and answers that join them."""

from collections.abc import Iterator
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.projects.service import ProjectAccess
from app.sound_lists import queries, service
from app.sound_lists.clarity.rules import Fact, Question, questions
from app.sound_lists.models import Cue
from app.sound_lists.rules import tidy_line


def unclear_cues(session: Session, access: ProjectAccess) -> Iterator[tuple[UUID, tuple[Question, ...]]]:
    """Yield each cue that leaves something open, in list order, with what it leaves open."""
    for cue_id, name, category, description, use, loop, length_s, dismissed in queries.requests(
        session, access.project.id
    ):
        left = questions(name, category, f"{use}\n{description}".strip(), loop, length_s is not None)
        if left := tuple(question for question in left if question.fact not in dismissed):
            yield cue_id, left


def answer(session: Session, actor: Actor, cue_id: UUID, fact: Fact, text: str) -> Cue:
    """Write an answer into the cue's description, as a revision of the list."""
    access, cue = service.visible_cue(session, actor, cue_id)
    access.ensure_may_speak()
    queries.lock_list(session, access.project.id)
    cue = service.cue_for(session, access, cue_id)
    written = f"{cue.description.rstrip('.')}. " if cue.description else ""
    written += f"{fact.value.capitalize()}: {tidy_line(text)}."
    return service.change_cue(session, actor, cue_id, None, {"description": written})


def dismiss(session: Session, actor: Actor, cue_id: UUID, fact: Fact, *, dismissed: bool) -> None:
    """Ask for a fact of a cue no more, or again."""
    access, _ = service.visible_cue(session, actor, cue_id)
    access.ensure_may_speak()
    queries.lock_list(session, access.project.id)
    cue = service.cue_for(session, access, cue_id)
    kept = [dismissed_fact for dismissed_fact in cue.dismissed_facts if dismissed_fact != fact.value]
    cue.dismissed_facts = [*kept, fact.value] if dismissed else kept
