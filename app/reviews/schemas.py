"""The bodies of this room."""

from datetime import date, datetime
from typing import Annotated, Any, Literal
from uuid import UUID

from pydantic import Field

from app.accounts.schemas import PersonBrief
from app.conformance.schemas import FindingRead
from app.core.web.http import Schema
from app.deliveries.rules import TakeState
from app.renders.rules import RenderState
from app.renders.schemas import SoundBrief, ThumbRead
from app.reviews.checklists.schemas import BlockedTake, CueChecklist
from app.reviews.reasons.schemas import Reasons
from app.reviews.rules import HistoryKind, PausedBy, QueueKind, VerdictKind
from app.sound_lists.rules import CueChannels, CueState, Reverb

MAX_HEARD = 200  # takes that are recorded at once
NO_NUL = "^[^\\x00]*$"  # PostgreSQL takes none in text
Note = Annotated[str, Field(max_length=10_000, pattern=NO_NUL)]
Said = Annotated[str, Field(min_length=1, max_length=10_000, pattern=NO_NUL)]
Seconds = Annotated[float, Field(ge=0, allow_inf_nan=False)]
Mentioned = Annotated[
    list[UUID],
    Field(max_length=20, description="People who may see the version, whose names stand in the text after an @."),
]


class ReviewCue(Schema):
    """The cue that waiting takes are for."""

    id: UUID
    project_id: UUID
    label: str = Field(examples=["SW-007"])
    name: str
    description: str
    use: str
    category: str
    duration_s: float | None
    loop: bool
    variations: int
    state: CueState
    reverb: Reverb | None
    channels: CueChannels | None
    placeholder: bool
    palette: bool
    due_on: date | None


class ReviewRender(SoundBrief):
    """One game file of a take, or why there is none."""

    thumb: ThumbRead | None = Field(description="Always null: its peaks have the shape, and no list draws it.")
    id: UUID | None
    target: str
    state: RenderState | Literal["waiting"]
    refusal: str | None
    attenuation_db: float | None
    loudness_lufs: float | None = Field(description="Measured of the file, as the take's own is.")
    true_peak_dbtp: float | None


class MentionRead(Schema):
    """A person whom a text mentions, by the name after the @ there."""

    person_id: UUID
    name: str


class ChangeRequestRead(Schema):
    """A change request for a take; a draft while `sent_at` is null."""

    id: UUID
    take_id: UUID
    cue_id: UUID
    cue_label: str
    cue_name: str
    variation: int
    number: int
    text: str
    reasons: list[str] = Field(description="Chosen of the studio's list; the text has them too.")
    mentions: list[MentionRead]
    start_s: float | None
    end_s: float | None
    reverses: bool = Field(description="Whether the take is approved now, so that sending counts no round.")
    written_by: PersonBrief
    created_at: datetime
    feedback_id: UUID | None
    sends_at: datetime | None = Field(description="When it sends itself; null for a draft that waits to be sent.")
    sent_at: datetime | None


class ReviewTake(SoundBrief):
    """One take, with what is needed to play and judge it."""

    id: UUID
    variation: int
    number: int
    alternate: int | None
    label: str | None
    file_name: str
    state: TakeState
    state_since: datetime
    received_at: datetime
    late: bool
    note: str
    delivery_number: int
    delivery_note: str
    designer: PersonBrief
    facts: dict[str, Any]
    loudness_lufs: float | None = Field(description="Integrated, or of the loudest 0.4 s where that is all there is.")
    away_from_set_lu: float | None = Field(description="Louder than the middle of the other variations by so much.")
    sample_peak_dbfs: float | None
    true_peak_dbtp: float | None
    measurements: dict[str, Any]
    findings: list[FindingRead]
    waived: bool
    waiver_reason: str | None
    fix_of_id: UUID | None = Field(description="The version that this one is a fix of.")
    renders: list[ReviewRender]
    draft_change: ChangeRequestRead | None
    open_comments: int
    is_heard: bool = Field(description="By the caller; nobody sees what others heard.")
    heard_at: datetime | None = Field(description="When the caller first heard it.")
    undecided_with: list[UUID] = Field(
        description="Files of the same delivery for the same sound, under other names: nobody said which one counts."
    )


class QueueItem(Schema):
    """One cue that waits for the approver, with every take of it that waits."""

    cue: ReviewCue
    kind: QueueKind
    waiting_since: datetime
    is_urgent: bool = Field(
        description="Of the palette, or due within a week; such cues come first, then need and priority order."
    )
    rounds_so_far: int
    last_change: str | None = Field(description="What was asked last of this cue, which these takes answer.")
    open_notes: int = Field(description="Notes on earlier versions that are not done in these.")
    approved_variations: list[int]
    accepted_after: date | None = Field(
        description="Day after which the cue counts as accepted without a verdict, by its contract's clause on silence."
    )
    silence_paused_by: PausedBy | None = Field(description="What is open, so that the days of the clause do not count.")
    findings_count: int
    worst_finding: FindingRead | None
    takes: list[ReviewTake]
    blocked: list[BlockedTake] = Field(description="Those of the takes that cannot be approved yet.")


class QueueCount(Schema):
    """The number of cues that wait for the approver, counted up to a limit."""

    cues: int
    is_all: bool = Field(description="Whether no more wait than are counted here.")


class VerdictGive(Schema):
    """A verdict on one take."""

    kind: Literal["approve", "request_change", "set_aside"]
    note: Note = ""
    reasons: Reasons = Field(default=[])
    start_s: Seconds | None = None
    end_s: Seconds | None = None
    seen_state: TakeState = Field(
        TakeState.CONFORMING,
        description="Where the page showed the take; another state now is answered 409 and changes nothing. "
        "Say `set_aside` to pick a take later, `approved` to reverse an approval. What the caller decided is no "
        "other state: whoever repeats or continues their own decision is not refused.",
    )
    mentions: Mentioned = Field(default=[])
    heard: bool = Field(
        False,
        description="Whether the caller has just heard this version. An approval by someone who has not heard it, "
        "neither now nor by `heard-takes` before, is recorded as `without_listening`.",
    )
    send: bool = Field(
        False,
        description="Send the requested change to the designer by itself, ten seconds from now; until then the verdict "
        "can be undone. Without it the change stays a draft until the drafts are sent.",
    )


class VerdictGiven(Schema):
    """The decisions of one click."""

    take_id: UUID
    state: TakeState
    set_aside: list[UUID] = Field(description="Other takes of the same variation that gave way.")
    draft: ChangeRequestRead | None
    cue_id: UUID
    cue_accepted: bool
    undo_until: datetime | None = Field(description="Null for a draft, which can be dropped until it is sent.")


class VerdictUndone(Schema):
    """The state restored after a verdict was undone."""

    takes: list["TakeStateRead"]
    draft_dropped: bool


class TakeStateRead(Schema):
    """A take and its state."""

    id: UUID
    variation: int
    state: TakeState


class HeardTakes(Schema):
    """Versions that the caller has heard."""

    take_ids: list[UUID] = Field(min_length=1, max_length=MAX_HEARD)


class SetAccept(Schema):
    """The acceptance of a whole set; where no take is named, the newest conforming one of a variation is meant."""

    note: Note = ""
    reasons: Reasons = Field(default=[])
    take_ids: list[UUID] = Field(default=[], max_length=99)
    heard_take_ids: list[UUID] = Field(
        default=[], max_length=99, description="Which of them the caller has just heard; see `heard` of a verdict."
    )


class SetAccepted(Schema):
    """The decisions made by accepting a set."""

    cue_id: UUID
    cue_accepted: bool
    approved: list[TakeStateRead]
    set_aside: list[UUID]
    undo_until: datetime


class FeedbackAdd(Schema):
    """A word that goes with all the drafts."""

    note: Note = ""


class RoundRead(Schema):
    """One sending, counted once for a cue or set; `number` is null where it is not counted, with the reason."""

    cue_id: UUID
    number: int | None
    why_not_counted: str | None
    feedback_id: UUID
    created_at: datetime


class HeldBack(Schema):
    """A draft that could not be sent now, and stays a draft."""

    change_request_id: UUID
    take_id: UUID
    why: str


class FeedbackRead(Schema):
    """One consolidated set of notes that went to designers."""

    id: UUID
    note: str
    created_at: datetime
    change_requests: list[ChangeRequestRead]
    rounds: list[RoundRead]
    held_back: list[HeldBack]


class CommentAdd(Schema):
    """Advice on a take, at a time in the sound or on the whole of it."""

    text: Said
    start_s: Seconds | None = None
    end_s: Seconds | None = None
    reply_to_id: UUID | None = Field(default=None, description="The comment on the same take that it answers.")
    change_request_id: UUID | None = Field(default=None, description="The sent change request that it answers.")
    mentions: Mentioned = Field(default=[])


class AcknowledgementRead(Schema):
    """A viewer of a comment, and the time."""

    person: PersonBrief
    created_at: datetime


class CommentAuthor(Schema):
    """The author of a comment: a person, or a guest by the name that they typed."""

    id: UUID | None = Field(description="Null for a guest, who has no account.")
    name: str = Field(examples=["guest Ada"])
    picture: str | None = Field(None, description="The address of the person's picture.")


class CommentRead(Schema):
    """Advice on a take."""

    id: UUID
    take_id: UUID
    reply_to_id: UUID | None
    change_request_id: UUID | None
    text: str
    start_s: float | None
    end_s: float | None
    author: CommentAuthor = Field(validation_alias="byline")
    decides: bool = Field(description="Whether the author was the approver when writing; all others advise.")
    created_at: datetime
    resolved_at: datetime | None
    mentions: list[MentionRead] = Field(validation_alias="mentioned")
    acknowledgements: list[AcknowledgementRead] = Field(description="Who has acknowledged it, the first first.")


class NoteAnswerGive(Schema):
    """Whether a version does what a note on an earlier one asked."""

    is_done: bool


class NoteAnswerRead(Schema):
    """The last answer to a note that was carried over, with its version, author and time."""

    is_done: bool
    number: int = Field(description="Of the version that it was said of.")
    given_by: PersonBrief
    created_at: datetime


class CarriedNote(Schema):
    """A note on a version for which a change was requested; it is carried over to later ones until it is done."""

    id: UUID
    kind: Literal["comment", "change"]
    take_id: UUID
    variation: int
    number: int = Field(description="Of the version that it was written on.")
    text: str
    start_s: float | None
    end_s: float | None
    author: PersonBrief
    decides: bool
    created_at: datetime
    answer: NoteAnswerRead | None


class HistoryEntry(Schema):
    """One thing that happened to a take."""

    at: datetime
    kind: HistoryKind
    by: PersonBrief | None
    on_behalf_of: PersonBrief | None = Field(None, description="The approver whose deputy decided.")
    by_deemed_acceptance: bool = Field(False, description="Whether a clause on silence approved it; then nobody did.")
    by_adoption: bool = Field(False, description="Whether it was approved by adopting a folder, without a review.")
    without_listening: bool = Field(False, description="Whether who approved it had not heard it.")
    text: str
    reasons: list[str] = Field([], description="Why it was approved; a change has them in its text.")
    start_s: float | None = None
    end_s: float | None = None


class VerdictRead(Schema):
    """One verdict on record."""

    id: UUID
    take_id: UUID
    kind: VerdictKind
    note: str
    reasons: list[str]
    given_by: PersonBrief | None = Field(description="Null where a clause on silence decided it.")
    on_behalf_of: PersonBrief | None = Field(description="The approver whose deputy decided; null in one's own right.")
    created_at: datetime
    by_deemed_acceptance: bool = Field(description="Whether a clause on silence decided it; then nobody did.")
    by_adoption: bool = Field(description="Whether it was approved by adopting a folder, without a review.")
    without_listening: bool = Field(description="Whether who approved it had not heard it.")
    withdrawn: bool


class CueReviewRead(Schema):
    """Everything of one cue that the review room shows: takes in every state, newest first, and what was said."""

    cue: ReviewCue
    kind: QueueKind
    accepted: bool
    approved_variations: list[int]
    accepted_after: date | None
    silence_paused_by: PausedBy | None
    approver: PersonBrief = Field(description="Of the cue's category, else of the project.")
    deputies: list[PersonBrief] = Field(description="Those who may approve in the approver's place today.")
    may_approve: bool
    on_behalf_of: PersonBrief | None = Field(description="The approver for whom the caller would decide as a deputy.")
    takes: list[ReviewTake]
    comments: list[CommentRead]
    verdicts: list[VerdictRead]
    change_requests: list[ChangeRequestRead]
    carried_notes: list[CarriedNote]
    checklist: CueChecklist
    rounds: list[RoundRead]


class CueCut(Schema):
    """The reason the game no longer needs a cue."""

    reason: Said


class CueCutRead(Schema):
    """A cut cue."""

    id: UUID
    state: CueState
    cut_reason: str
    cut_at: datetime
