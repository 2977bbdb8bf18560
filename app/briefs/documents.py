"""The brief as its page and its documents show it."""

from collections.abc import Iterator, Mapping
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.queries import people_by_id
from app.accounts.schemas import PersonBrief
from app.briefs import queries
from app.briefs.follow_ups import follow_up_read
from app.briefs.models import BriefVersion
from app.briefs.questions import QUESTIONS, TOPICS, Question
from app.briefs.rules import Answers, applies, completeness, differences, in_words, is_answered, number_of
from app.briefs.schemas import (
    BriefAnswerRead,
    BriefAnswers,
    BriefChoice,
    BriefDocument,
    BriefQuestionRead,
    BriefTopicRead,
    BriefVersionRead,
    BriefVersionSummary,
)
from app.core.plural import counted
from app.projects.service import ProjectAccess


def document_of(session: Session, access: ProjectAccess) -> BriefDocument:
    """Return the brief of a project as it stands, for one caller."""
    project_id = access.project.id
    brief = queries.brief_of(session, project_id)
    answers = brief.answers if brief else {}
    newest = queries.newest_version(session, project_id)
    version = queries.version_of(session, project_id, newest)
    return BriefDocument(
        **dict(answers_read(session, answers)),
        revision=brief.revision if brief else 0,
        changed_at=brief.changed_at if brief else None,
        newest_version=newest,
        differs=bool(differences(version.answers if version else {}, answers)),
        may_answer=access.is_producer or access.is_liaison or access.is_approver,
        may_ask=access.engagement is not None and not access.is_team,
        follow_ups=[follow_up_read(follow_up, access) for follow_up in queries.follow_ups_of(session, project_id)],
    )


def answers_read(session: Session, answers: Answers) -> BriefAnswers:
    """Return all questions with these answers."""
    people = people_by_id(session, {UUID(answer["answered_by"]) for answer in answers.values()})
    figures = completeness(answers)
    return BriefAnswers(
        topics=[_topic(topic.key, answers, people) for topic in TOPICS],
        answered=figures.answered,
        total=figures.total,
        open=list(figures.open),
        open_required=list(figures.open_required),
    )


def _topic(key: str, answers: Answers, people: Mapping[UUID, Person]) -> BriefTopicRead:
    topic = next(candidate for candidate in TOPICS if candidate.key == key)
    own = [question for question in QUESTIONS if question.topic == key]
    asked = [question for question in own if applies(question, answers)]
    return BriefTopicRead(
        key=key,
        title=topic.title,
        lead=topic.lead,
        answered=sum(is_answered(question, answers) for question in asked),
        total=len(asked),
        questions=[_question(question, answers, people) for question in own],
    )


def _question(question: Question, answers: Answers, people: Mapping[UUID, Person]) -> BriefQuestionRead:
    answer = answers.get(question.key)
    return BriefQuestionRead(
        key=question.key,
        number=number_of(question),
        text=question.text,
        why=question.why,
        example=question.example,
        kind=question.kind,
        choices=[BriefChoice(key=choice.key, label=choice.label) for choice in question.choices],
        unit=question.unit,
        required=question.required,
        writes=question.writes,
        applies=applies(question, answers),
        answer=_answer(question, answer, people) if answer else None,
    )


def _answer(question: Question, answer: Mapping[str, Any], people: Mapping[UUID, Person]) -> BriefAnswerRead:
    who = PersonBrief.model_validate(people[UUID(answer["answered_by"])])
    return BriefAnswerRead(**{**answer, "answered_by": who}, words=in_words(question, answer))


def version_brief(version: BriefVersion) -> BriefVersionSummary:
    """Return a published version without its answers."""
    figures = completeness(version.answers)
    return BriefVersionSummary(
        number=version.number,
        note=version.note,
        publisher=PersonBrief.model_validate(version.publisher),
        published_at=version.published_at,
        answered=figures.answered,
        total=figures.total,
    )


def version_read(session: Session, version: BriefVersion) -> BriefVersionRead:
    """Return a published version with its answers."""
    fields = {**dict(version_brief(version)), **dict(answers_read(session, version.answers))}
    return BriefVersionRead(**fields)


def markdown_of(name: str, answers: Answers, *, version: int) -> str:
    """Return the brief as Markdown: every question that is asked, open ones marked."""
    return "\n".join(_markdown(name, answers, version)) + "\n"


def _markdown(name: str, answers: Answers, version: int) -> Iterator[str]:
    figures = completeness(answers)
    published = f"Version {version} is the newest published." if version else "No version is published."
    yield f"# Brief: {name}\n\n{figures.answered} of {counted(figures.total, 'question')} answered. {published}"
    for topic in TOPICS:
        yield f"\n## {topic.title}"
        for question in QUESTIONS:
            if question.topic != topic.key or not applies(question, answers):
                continue
            answer_text = in_words(question, answers.get(question.key)) or "Open"
            needed = " (needed before signing)" if question.key in figures.open_required else ""
            yield f"\n**{number_of(question)}. {question.text}**{needed}\n"
            yield from (f"> {line}" if line else ">" for line in answer_text.split("\n"))
