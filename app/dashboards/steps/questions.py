"""Cues in short, and what was asked on them."""

from collections.abc import Sequence

from sqlalchemy import Row

from app.accounts.models import Person
from app.accounts.schemas import PersonBrief
from app.dashboards import schemas
from app.dashboards.progress.queries import ListRow
from app.deliveries.schemas import CueBrief
from app.projects.models import Project
from app.sound_lists.models import Cue, Question
from app.sound_lists.rules import label


def brief(project: Project, cue: Cue | ListRow) -> CueBrief:
    """Return a cue as other things name it."""
    return CueBrief(id=cue.id, label=label(project.cue_prefix, cue.number), name=cue.name)


def asked_questions(project: Project, rows: Sequence[Row[Question, Cue, Person]]) -> list[schemas.AskedQuestion]:
    """Return questions as they are shown, each with its cue and asker."""
    return [
        schemas.AskedQuestion(
            id=question.id,
            cue=brief(project, cue),
            text=question.text,
            asked_by=PersonBrief.model_validate(asker),
            asked_at=question.asked_at,
            answer=question.answer,
            answered_at=question.answered_at,
            owner=PersonBrief.model_validate(question.owner) if question.owner else None,
            due_on=question.due_on,
            blocks=question.blocks,
        )
        for question, cue, asker in rows
    ]
