"""Bodies that this room reads and answers."""

from datetime import datetime
from typing import Annotated, Any
from uuid import UUID

from pydantic import ConfigDict, Field

from app.accounts.schemas import PersonBrief, Prose
from app.briefs.questions import AnswerKind
from app.core.web.http import LARGEST_NUMBER, Schema

Asked = Annotated[str, Field(min_length=1, max_length=2000, pattern="^[^\\x00]*$")]
Number = Annotated[int, Field(ge=0, le=LARGEST_NUMBER)]


class BriefChoice(Schema):
    """One answer that can be picked."""

    key: str
    label: str


class BriefAnswerRead(Schema):
    """The answer to a question."""

    value: Any = Field(description="What it is depends on the question's kind; null where it is not known yet.")
    is_unknown: bool = Field(description='The answer is "I don\'t know yet": the question stays open.')
    note: str
    words: str = Field(description="The answer as a text.")
    revision: int = Field(description="The revision of the brief that changed it last.")
    answered_by: PersonBrief
    answered_at: datetime


class FollowUpRead(Schema):
    """A designer's question about a question of the brief, and the team's answer."""

    id: UUID
    question: str
    text: str
    asked_by: PersonBrief | None = Field(description="Null where a designer looks at another designer's follow-up.")
    asked_at: datetime
    answer: str | None
    answered_by: PersonBrief | None
    answered_at: datetime | None


class BriefQuestionRead(Schema):
    """One question of the brief with its answer."""

    key: str
    number: int
    text: str
    why: str
    example: str
    kind: AnswerKind
    choices: list[BriefChoice]
    unit: str
    required: bool = Field(description="Needed before a contract is signed.")
    writes: str = Field(description="The table of the delivery spec that the answer writes; empty for none.")
    applies: bool = Field(description="Whether it is asked, given the other answers.")
    answer: BriefAnswerRead | None


class BriefTopicRead(Schema):
    """Questions that are answered together."""

    key: str
    title: str
    lead: str
    answered: int
    total: int
    questions: list[BriefQuestionRead]


class BriefAnswers(Schema):
    """The questions of the brief with their answers, and how complete they are."""

    topics: list[BriefTopicRead]
    answered: int
    total: int
    open: list[str] = Field(description="Keys of the questions without an answer, in their order.")
    open_required: list[str]


class BriefDocument(BriefAnswers):
    """The brief of a project as it stands."""

    revision: int = Field(description="0 while nothing is answered. Send it back with a change.")
    changed_at: datetime | None
    newest_version: int = Field(description="0 while none is published.")
    differs: bool = Field(description="Whether the answers differ from those of the newest version.")
    may_answer: bool
    may_ask: bool
    follow_ups: list[FollowUpRead]


class BriefAnswerWrite(Schema):
    """One answer. Without a value, and not unknown: the answer is removed."""

    model_config = ConfigDict(str_strip_whitespace=False)

    value: Any = None
    is_unknown: bool = False
    note: Prose = ""


class BriefChange(Schema):
    """Answers that change; those left out stay."""

    revision: Number = Field(description="The revision that was read.")
    answers: dict[str, BriefAnswerWrite] = Field(max_length=100)


class BriefVersionAdd(Schema):
    """A version of the brief to publish."""

    note: Prose = ""
    revision: Number = Field(description="The revision that is published.")


class BriefVersionSummary(Schema):
    """A published version, without its answers."""

    number: int
    note: str
    publisher: PersonBrief
    published_at: datetime
    answered: int
    total: int


class BriefVersionRead(BriefAnswers):
    """A published version."""

    number: int
    note: str
    publisher: PersonBrief
    published_at: datetime


class BriefDifference(Schema):
    """A question whose answer differs."""

    question: str
    number: int
    text: str
    before: str
    after: str


class BriefComparison(Schema):
    """The answers that differ between two versions; `to_version` null is the brief as it stands."""

    from_version: int
    to_version: int | None
    differences: list[BriefDifference]


class LastReadRead(Schema):
    """The version that a designer opened last."""

    designer: PersonBrief
    version: int | None = Field(description="Null: none yet.")
    read_at: datetime | None
    behind: int = Field(description="How many versions are newer.")


class SpecChangeRead(Schema):
    """One key of the delivery spec that an answer changes."""

    place: str = Field(description="Dotted, as in `engine.adds`.")
    before: Any = Field(description="Null: the key is absent.")
    after: Any = Field(description="Null: the key goes.")
    question: str
    number: int
    lines: list[str] = Field(description="The change as TOML.")


class SpecProposal(Schema):
    """The delivery spec as the answers ask for it, beside the one in force."""

    based_on_version: int
    brief_revision: int
    toml: str
    changes: list[SpecChangeRead]
    errors: list[str] = Field(description="Why it cannot be saved; empty where it can.")


class SpecProposalApply(Schema):
    """The sources of the proposal: it is refused where either has changed."""

    based_on_version: int = Field(ge=1, le=LARGEST_NUMBER)
    brief_revision: Number


class SpecApplied(Schema):
    """The version of the delivery spec that was saved."""

    version: int


class FollowUpAdd(Schema):
    """A designer's question about a question of the brief."""

    question: str = Field(max_length=60)
    text: Asked


class FollowUpAnswer(Schema):
    """The team's answer."""

    text: Asked
