"""The list held against the brief."""

from sqlalchemy.orm import Session

from app.briefs.queries import answers_of
from app.projects.service import ProjectAccess
from app.sound_lists import queries
from app.sound_lists.coverage.rules import Coverage, ListedCue, coverage


def list_coverage(session: Session, access: ProjectAccess) -> Coverage:
    """Return the brief's items that the list lacks; without a brief nothing is missing."""
    answers = answers_of(session, access.project.id)
    known = {key: answer["value"] for key, answer in answers.items() if not answer["is_unknown"]}
    if not {"scenes", "categories", "priority"} & known.keys():
        return Coverage([], [], [], [], [])
    return coverage(known, (ListedCue(*row) for row in queries.words_of_cues(session, access.project.id)))
