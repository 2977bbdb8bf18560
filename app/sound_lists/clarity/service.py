"""The clarity check of a list: which cues a designer could not make from their words, and answers that join them."""

from collections.abc import Iterator
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.projects.service import ProjectAccess
from app.sound_lists import queries, service
from app.sound_lists.categories.ucs_rules import MOST_OFFERED, cat_id_of, is_ucs, ucs_candidates
from app.sound_lists.clarity.rules import Fact, Question, questions
from app.sound_lists.models import Cue
from app.sound_lists.rules import tidy_line


def unclear_cues(session: Session, access: ProjectAccess) -> Iterator[tuple[UUID, tuple[Question, ...]]]:
    """Yield each cue that leaves something open, in list order, with what it leaves open.

    The category is asked for where the list files by the Universal Category System, or by nothing yet.
    """
    requests = queries.requests(session, access.project.id)
    files_by_ucs = all(not category or is_ucs(category) for category in {request.category for request in requests})
    for cue_id, name, category, description, use, loop, length_s, dismissed in requests:
        request_text = f"{use}\n{description}".strip()
        left = questions(name, category, request_text, loop, length_s is not None)
        if files_by_ucs and not category:
            left = (*left, *_category_question(name, request_text))
        if left := tuple(question for question in left if question.fact not in dismissed):
            yield cue_id, left


def _category_question(name: str, description: str) -> Iterator[Question]:
    candidates = ucs_candidates(name, description)
    if 2 <= len(candidates) <= MOST_OFFERED:
        labels = tuple(candidate.label for candidate in candidates)
        yield Question(Fact.CATEGORY, f"Which of {len(labels)} categories?", labels)


def answer(session: Session, actor: Actor, cue_id: UUID, fact: Fact, text: str) -> Cue:
    """Write an answer into the cue's description, or its category, as a revision of the list."""
    access, cue = service.visible_cue(session, actor, cue_id)
    access.ensure_may_speak()
    queries.lock_list(session, access.project.id)
    cue = service.cue_for(session, access, cue_id)
    if fact is Fact.CATEGORY:
        return service.change_cue(session, actor, cue_id, None, {"category": cat_id_of(tidy_line(text))})
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
