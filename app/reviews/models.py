"""The tables of this room."""

from datetime import datetime
from typing import Any
from uuid import UUID

from sqlalchemy import CheckConstraint, ForeignKey, Index, UniqueConstraint, text
from sqlalchemy.orm import Mapped, mapped_column, relationship

from app.accounts.models import Person
from app.core import clock
from app.core.columns import Dated, ProjectOwned, StudioOwned
from app.core.db import Base, new_id
from app.core.recorded_rows import declare
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.reviews.reasons.rules import ReasonKind
from app.reviews.rules import ApprovalBlockers, VerdictKind, mentioned_in
from app.sound_lists.models import Cue


class Verdict(StudioOwned, Dated, Base):
    """The approver's verdict on a take; rows are added, never changed."""

    __tablename__ = "reviews_verdicts"
    __table_args__ = (
        Index("ix_reviews_verdicts_project_id_id", "project_id", "id"),
        CheckConstraint("given_by is not null or deemed_by_contract_id is not null", name="given_or_deemed"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    cue_id: Mapped[UUID] = mapped_column(index=True)  # no foreign key: an undone adoption removes cues, not verdicts
    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"), index=True)
    action_id: Mapped[UUID] = mapped_column(index=True)  # decisions of one click are undone together
    kind: Mapped[VerdictKind]
    note: Mapped[str] = mapped_column(default="")
    reasons: Mapped[list[str]] = mapped_column(default=list)  # as they were said
    state_before: Mapped[TakeState]
    since_before: Mapped[datetime]
    dropped_draft: Mapped[dict[str, Any]] = mapped_column(default=dict)  # what was noted to change, and fell away
    withdraws_id: Mapped[UUID | None] = mapped_column(ForeignKey("reviews_verdicts.id"), unique=True)
    given_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))  # None: nobody, by the clause
    on_behalf_of: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))  # None: in their own right
    # By whose clause it was decided, because nobody said anything; None: `given_by` did.
    deemed_by_contract_id: Mapped[UUID | None] = mapped_column(ForeignKey("contracts_contracts.id"), index=True)
    # The adoption that approved it, with no review before; None: it was reviewed.
    adoption_id: Mapped[UUID | None] = mapped_column(ForeignKey("deliveries_adoptions.id"), index=True)
    without_listening: Mapped[bool] = mapped_column(default=False)  # approved by a person who had not heard it
    author: Mapped[Person | None] = relationship(lazy="raise", foreign_keys=[given_by])
    represented: Mapped[Person | None] = relationship(lazy="raise", foreign_keys=[on_behalf_of])


class GameLevel(ProjectOwned, Base):
    """The game's playback of a variation of a cue when its folder was adopted: the level that counts as approved."""

    __tablename__ = "reviews_game_levels"

    cue_id: Mapped[UUID] = mapped_column(ForeignKey("sound_lists_cues.id"), primary_key=True)
    variation: Mapped[int] = mapped_column(primary_key=True)
    plays: Mapped[list[dict[str, Any]]]  # as a manifest for audits has them


class Feedback(ProjectOwned, Dated, Base):
    """One consolidated set of notes that the approver sent to a designer."""

    __tablename__ = "reviews_feedback"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    sent_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    note: Mapped[str] = mapped_column(default="")


class ChangeRequest(StudioOwned, Dated, Base):
    """A change request for a take, at a time in the sound; a draft until it is sent."""

    __tablename__ = "reviews_change_requests"
    __table_args__ = (
        CheckConstraint("end_s is null or end_s >= start_s", name="range_forwards"),
        Index(
            "uq_reviews_change_requests_draft",
            "take_id",
            unique=True,
            sqlite_where=text("feedback_id is null"),
            postgresql_where=text("feedback_id is null"),
        ),
        Index(
            "ix_reviews_change_requests_drafts",
            "project_id",
            sqlite_where=text("feedback_id is null"),
            postgresql_where=text("feedback_id is null"),
        ),
        Index("ix_reviews_change_requests_project_id_id", "project_id", "id"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    cue_id: Mapped[UUID] = mapped_column(ForeignKey("sound_lists_cues.id"), index=True)
    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"), index=True)
    text: Mapped[str]
    reasons: Mapped[list[str]] = mapped_column(default=list)  # as they were said; the text has them too
    start_s: Mapped[float | None]
    end_s: Mapped[float | None]
    written_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    feedback_id: Mapped[UUID | None] = mapped_column(ForeignKey("reviews_feedback.id"), index=True)
    sends_at: Mapped[datetime | None]  # when it leaves by itself; None: it waits until its approver sends it
    mentions: Mapped[dict[str, Any]] = mapped_column(default=dict)  # by person: the name after the @
    cue: Mapped[Cue] = relationship(lazy="raise")  # its take may be moved to another one, or to none
    take: Mapped[Take] = relationship(lazy="raise")
    author: Mapped[Person] = relationship(lazy="raise")
    sending: Mapped[Feedback | None] = relationship(lazy="raise")

    @property
    def mentioned(self) -> list[dict[str, Any]]:
        """Return the text's mentions, by id and name."""
        return mentioned_in(self.mentions)


class Round(ProjectOwned, Dated, Base):
    """One sending counted once for a cue or set, or the reason why it is not counted."""

    __tablename__ = "reviews_rounds"
    __table_args__ = (
        UniqueConstraint("cue_id", "feedback_id"),
        UniqueConstraint("cue_id", "number"),
        CheckConstraint("(number is null) = (why_not_counted is not null)", name="counted_or_why_not"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    cue_id: Mapped[UUID] = mapped_column(ForeignKey("sound_lists_cues.id"))
    feedback_id: Mapped[UUID] = mapped_column(ForeignKey("reviews_feedback.id"))
    number: Mapped[int | None]  # None: not counted
    why_not_counted: Mapped[str | None]


class Comment(StudioOwned, Dated, Base):
    """Advice on a take, at a time in the sound."""

    __tablename__ = "reviews_comments"
    __table_args__ = (
        Index("ix_reviews_comments_project_id_id", "project_id", "id"),
        CheckConstraint("(written_by is null) <> (guest_name is null)", name="by_a_person_or_guest"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"), index=True)
    reply_to_id: Mapped[UUID | None] = mapped_column(ForeignKey("reviews_comments.id"), index=True)  # no reply itself
    change_request_id: Mapped[UUID | None] = mapped_column(ForeignKey("reviews_change_requests.id"), index=True)
    text: Mapped[str]
    start_s: Mapped[float | None]
    end_s: Mapped[float | None]
    written_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))  # None: a guest
    guest_name: Mapped[str | None]  # as a guest without an account typed it
    decides: Mapped[bool]  # whether the author was the approver when writing; all others advise
    resolved_at: Mapped[datetime | None]
    resolved_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    mentions: Mapped[dict[str, Any]] = mapped_column(default=dict)  # by person: the name after the @
    author: Mapped[Person | None] = relationship(lazy="raise", foreign_keys=[written_by])
    acknowledgements: Mapped[list["Acknowledgement"]] = relationship(lazy="raise", order_by="Acknowledgement.id")

    @property
    def byline(self) -> dict[str, Any]:
        """Return its author, as people read it; a guest has no account."""
        if self.author is None:
            return {"id": None, "name": f"guest {self.guest_name}"}
        return {"id": self.author.id, "name": self.author.name, "picture": self.author.picture}

    @property
    def mentioned(self) -> list[dict[str, Any]]:
        """Return the text's mentions, by id and name."""
        return mentioned_in(self.mentions)


class Acknowledgement(ProjectOwned, Dated, Base):
    """A person who is mentioned in a comment, or made the sound, has seen it."""

    __tablename__ = "reviews_acknowledgements"
    __table_args__ = (UniqueConstraint("comment_id", "person_id"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    comment_id: Mapped[UUID] = mapped_column(ForeignKey("reviews_comments.id"))
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    person: Mapped[Person] = relationship(lazy="raise")


class NoteAnswer(ProjectOwned, Dated, Base):
    """Whether a version did what a note on an earlier one asked; rows are added, and a note's newest counts."""

    __tablename__ = "reviews_note_answers"
    __table_args__ = (
        CheckConstraint("(comment_id is null) <> (change_request_id is null)", name="one_note"),
        Index("ix_reviews_note_answers_comment_id", "comment_id", "id"),
        Index("ix_reviews_note_answers_change_request_id", "change_request_id", "id"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"), index=True)  # the later version
    comment_id: Mapped[UUID | None] = mapped_column(ForeignKey("reviews_comments.id"))
    change_request_id: Mapped[UUID | None] = mapped_column(ForeignKey("reviews_change_requests.id"))
    is_done: Mapped[bool]
    given_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    take: Mapped[Take] = relationship(lazy="raise")
    author: Mapped[Person] = relationship(lazy="raise")


class ChecklistItem(StudioOwned, Dated, Base):
    """Something to check of every version of a category's cues before it is approved."""

    __tablename__ = "reviews_checklist_items"
    __table_args__ = (
        UniqueConstraint("project_id", "category", "text"),
        CheckConstraint("text <> ''", name="has_text"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    category: Mapped[str]  # empty: of every cue
    text: Mapped[str]
    place: Mapped[int]  # in its checklist, from 0
    written_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    removed_at: Mapped[datetime | None]  # kept with its checks, and back with them once it is written again


class ItemCheck(ProjectOwned, Base):
    """A person checked an item of the checklist for one take."""

    __tablename__ = "reviews_item_checks"

    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"), primary_key=True)
    item_id: Mapped[UUID] = mapped_column(ForeignKey("reviews_checklist_items.id"), primary_key=True)
    checked_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    checked_at: Mapped[datetime] = mapped_column(default=clock.now)
    person: Mapped[Person] = relationship(lazy="raise")


class HeardTake(Base):
    """A person heard a take, or most of it; without a studio, since that person alone sees it."""

    __tablename__ = "reviews_heard_takes"

    take_id: Mapped[UUID] = mapped_column(ForeignKey("deliveries_takes.id"), primary_key=True)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), primary_key=True)
    heard_at: Mapped[datetime] = mapped_column(default=clock.now)


class ApprovalRule(StudioOwned, Base):
    """The blockers of approval in a project, as a producer set them; without a row there are none."""

    __tablename__ = "reviews_approval_rules"

    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"), primary_key=True)
    blockers: Mapped[ApprovalBlockers]
    set_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    set_at: Mapped[datetime] = mapped_column(default=clock.now)


class ReasonList(Base):
    """A studio's own list of reasons or labels; without a row it has ours."""

    __tablename__ = "reviews_reason_lists"

    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"), primary_key=True)
    kind: Mapped[ReasonKind] = mapped_column(primary_key=True)
    reasons: Mapped[list[str]]  # in order, one for each digit
    set_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    set_at: Mapped[datetime] = mapped_column(default=clock.now)


class GivenReason(StudioOwned, Base):
    """One reason of a verdict that was not taken back, so that reasons are counted by an index."""

    __tablename__ = "reviews_given_reasons"
    __table_args__ = (
        Index("ix_reviews_given_reasons_found", "project_id", "kind", "reason", "verdict_id"),
        # Everything that is counted, so that no row itself is read.
        Index(
            "ix_reviews_given_reasons_counted",
            *("project_id", "designer_id", "kind", "reason", "cue_id"),
            "studio_id",  # which the row policies of PostgreSQL ask for
        ),
        # The same by cue, for those of a category.
        Index(
            "ix_reviews_given_reasons_of_cues",
            *("project_id", "cue_id", "designer_id", "kind", "reason", "studio_id"),
        ),
    )

    verdict_id: Mapped[UUID] = mapped_column(ForeignKey("reviews_verdicts.id"), primary_key=True)
    reason: Mapped[str] = mapped_column(primary_key=True)
    kind: Mapped[ReasonKind]
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    cue_id: Mapped[UUID]  # of the verdict, without a foreign key as there
    designer_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))  # of the take
    change_request_id: Mapped[UUID | None] = mapped_column(ForeignKey("reviews_change_requests.id"))  # of a change


# Of a cue's variation at most one take is picked, even when two people click at once.
Index(
    "uq_reviews_one_approved",
    Take.cue_id,
    Take.variation,
    unique=True,
    sqlite_where=Take.state == TakeState.APPROVED,
    postgresql_where=Take.state == TakeState.APPROVED,
)


declare(Verdict, "verdict", owners=None, left_out=("dropped_draft",))  # which its designer never saw
declare(Feedback, "feedback", owners=None)
declare(ChangeRequest, "change request", owners=None, left_out=("feedback_id", "sends_at", "mentions"))
declare(Comment, "comment", owners=None, left_out=("resolved_at", "resolved_by", "mentions"))


class PaletteApproval(ProjectOwned, Dated, Base):
    """The approval of a project's palette as a set; the newest holds while the palette has no other cue."""

    __tablename__ = "reviews_palette_approvals"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    approved_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    cue_ids: Mapped[list[str]]
    approver: Mapped[Person] = relationship(lazy="raise")
