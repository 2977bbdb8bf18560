"""The tables of this room."""

from datetime import date, datetime
from typing import Any
from uuid import UUID

from sqlalchemy import BigInteger, CheckConstraint, ForeignKey, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column, relationship

from app.accounts.models import Person
from app.accounts.rules import AddressProof
from app.agreements.rules import AcceptedBy, ContractKind, ContractState, Party, ReleaseClause, WorkState
from app.core import clock
from app.core.columns import Dated, ProjectOwned, StudioOwned
from app.core.db import Base, new_id
from app.core.record import START
from app.core.recorded_rows import declare
from app.projects.models import Engagement, Project
from app.sound_lists.models import Cue


class Contract(StudioOwned, Dated, Base):
    """An agreement of a studio and one designer in a project, from the first draft on."""

    __tablename__ = "contracts_contracts"
    __table_args__ = (
        UniqueConstraint("project_id", "number"),
        CheckConstraint("(kind = 'statement_of_work') = (framework_id is not null)", name="batch_has_framework"),
        CheckConstraint("deposit_bp between 0 and 10000", name="deposit_is_a_part"),
        CheckConstraint("holdback_bp between 0 and 10000", name="holdback_is_a_part"),
        CheckConstraint("(state <> 'agreed') or (agreed_at is not null)", name="agreed_is_dated"),
        CheckConstraint("(state = 'ended') = (ended_at is not null)", name="ended_is_dated"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"))
    engagement_id: Mapped[UUID] = mapped_column(ForeignKey("projects_engagements.id"), index=True)
    designer_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), index=True)
    framework_id: Mapped[UUID | None] = mapped_column(ForeignKey("contracts_contracts.id"), index=True)
    joint_id: Mapped[UUID | None] = mapped_column(index=True)  # the same in both contracts of joint work
    number: Mapped[int]  # counts in the project
    title: Mapped[str]
    kind: Mapped[ContractKind]
    state: Mapped[ContractState] = mapped_column(default=ContractState.DRAFT)
    currency: Mapped[str]  # ISO 4217
    release_clause: Mapped[ReleaseClause] = mapped_column(default=ReleaseClause.PER_CUE)
    deposit_bp: Mapped[int] = mapped_column(default=0)
    holdback_bp: Mapped[int] = mapped_column(default=0)
    created_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    signs_first: Mapped[Party | None]  # None: in any order
    agreed_at: Mapped[datetime | None]
    ended_at: Mapped[datetime | None]
    end_reason: Mapped[str | None]
    record_length: Mapped[int] = mapped_column(default=0)
    record_sha256: Mapped[str] = mapped_column(default=START)  # of the newest entry of its record
    head_mailed_length: Mapped[int] = mapped_column(default=0)  # of the record when its signed head was last mailed
    head_mailed_on: Mapped[date | None]
    changed_terms: Mapped[dict[str, Any]] = mapped_column(default=dict)  # that change orders set since it was signed
    game_shipped_on: Mapped[date | None]  # as a producer said, where a bonus waits for it
    project: Mapped[Project] = relationship(lazy="raise")
    engagement: Mapped[Engagement] = relationship(lazy="raise")
    designer: Mapped[Person] = relationship(lazy="raise", foreign_keys=[designer_id])
    framework: Mapped["Contract | None"] = relationship(lazy="raise", remote_side="Contract.id")


class ContractVersion(ProjectOwned, Dated, Base):
    """One state of a contract's text, with the clauses and figures that it was written from; never altered."""

    __tablename__ = "contracts_versions"
    __table_args__ = (
        UniqueConstraint("contract_id", "number"),
        CheckConstraint("(sent_at is null) = (pdf_sha256 is null)", name="sent_as_pdf"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    contract_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_contracts.id"))
    number: Mapped[int]
    clauses: Mapped[list[dict[str, Any]]]  # key, title, text and whether it stands, in order
    terms: Mapped[dict[str, Any]]  # what the clauses leave open: rounds, days, parts
    text: Mapped[str]  # Markdown, as both read it
    text_sha256: Mapped[str]
    note: Mapped[str] = mapped_column(default="")
    created_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    sent_at: Mapped[datetime | None]
    pdf_sha256: Mapped[str | None]
    pdf_bytes: Mapped[int | None]
    author: Mapped[Person] = relationship(lazy="raise")


class ContractSigner(ProjectOwned, Base):
    """A producer who is to sign a contract for the studio; without any, one of its producers does."""

    __tablename__ = "contracts_signers"
    __table_args__ = (UniqueConstraint("contract_id", "position"), UniqueConstraint("contract_id", "person_id"))

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    contract_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_contracts.id"))
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    position: Mapped[int]  # they sign in this order
    person: Mapped[Person] = relationship(lazy="raise")


class SigningCode(ProjectOwned, Base):
    """A code mailed to a person, to be typed when they sign one text; kept as a slow hash only."""

    __tablename__ = "contracts_signing_codes"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    contract_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_contracts.id"), index=True)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    text_sha256: Mapped[str]
    code_hash: Mapped[str | None]  # None: not sent yet
    tries: Mapped[int] = mapped_column(default=0)
    expires_at: Mapped[datetime]
    used_at: Mapped[datetime | None]


class Acceptance(ProjectOwned):
    """One person's yes to a text: under which name, when, from where, and what shows that it was them."""

    party: Mapped[Party]
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    name: Mapped[str]  # as typed
    email: Mapped[str]
    email_proof: Mapped[AddressProof | None]  # that they read the mail of that address; None: it was not shown
    address: Mapped[str]  # on the network
    agent: Mapped[str] = mapped_column(default="")  # the browser and its system, as it names them
    code_entered_at: Mapped[datetime | None]  # the code that was mailed to that address; None: none was asked for
    drawing: Mapped[list[list[list[int]]] | None]  # the name as it was drawn, in strokes of points; None: it was not
    accepted_at: Mapped[datetime] = mapped_column(default=clock.now)


class ContractAcceptance(Acceptance, Base):
    """One person's yes to one version of a contract."""

    __tablename__ = "contracts_acceptances"
    __table_args__ = (UniqueConstraint("version_id", "person_id"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    contract_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_contracts.id"), index=True)
    version_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_versions.id"))


class Seal(ProjectOwned, Base):
    """The sealed PDF of a text that all have signed: the text, the certificate of its signatures, the server's seal."""

    __tablename__ = "contracts_seals"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)  # the file names it
    contract_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_contracts.id"), index=True)
    version_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_versions.id"), unique=True)
    file_sha256: Mapped[str] = mapped_column(index=True)
    file_bytes: Mapped[int]
    key_sha256: Mapped[str]  # of the public key
    is_timestamped: Mapped[bool]
    sealed_at: Mapped[datetime] = mapped_column(default=clock.now)
    version: Mapped[ContractVersion] = relationship(lazy="raise")
    contract: Mapped[Contract] = relationship(lazy="raise")


class ContractEvent(ProjectOwned, Base):
    """One entry of a contract's record, chained to the one before; never altered, never deleted."""

    __tablename__ = "contracts_events"
    __table_args__ = (UniqueConstraint("contract_id", "seq"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    contract_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_contracts.id"))
    seq: Mapped[int]
    at: Mapped[datetime]
    kind: Mapped[str]
    payload: Mapped[str]  # canonical JSON: the hash is over these bytes
    previous_sha256: Mapped[str]
    sha256: Mapped[str]


class ContractTemplate(StudioOwned, Dated, Base):
    """Clauses and figures that a studio keeps to begin contracts from."""

    __tablename__ = "contracts_templates"
    __table_args__ = (UniqueConstraint("studio_id", "name"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    name: Mapped[str]
    kind: Mapped[ContractKind]
    clauses: Mapped[list[dict[str, Any]]]
    terms: Mapped[dict[str, Any]]
    created_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    changed_at: Mapped[datetime] = mapped_column(default=clock.now)


class Milestone(ProjectOwned, Base):
    """A dated part of a contract: cues and an amount; a deposit has no cues and is due at signing."""

    __tablename__ = "contracts_milestones"
    __table_args__ = (
        UniqueConstraint("contract_id", "position"),
        CheckConstraint("amount_minor >= 0", name="amount_not_negative"),
        CheckConstraint("tax_bp between 0 and 10000", name="tax_is_a_part"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    contract_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_contracts.id"))
    position: Mapped[int]
    name: Mapped[str]
    is_deposit: Mapped[bool] = mapped_column(default=False)
    amount_minor: Mapped[int] = mapped_column(BigInteger)  # as agreed; its cues share it
    due_on: Mapped[date | None]
    tax_bp: Mapped[int | None]  # None: the contract's rate


class ContractCue(ProjectOwned, Base):
    """A cue that a contract covers: its price, fixed when agreed, and what happened to it."""

    __tablename__ = "contracts_cues"
    __table_args__ = (
        UniqueConstraint("contract_id", "cue_id"),
        CheckConstraint("price_minor >= 0", name="price_not_negative"),
        CheckConstraint("amount_minor >= 0", name="amount_not_negative"),
        CheckConstraint("estimate_min > 0", name="estimate_positive"),
        CheckConstraint("(cut_at is null) = (cut_in is null)", name="cut_in_a_state"),
        CheckConstraint("(accepted_at is null) = (accepted_by is null)", name="accepted_somehow"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    contract_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_contracts.id"))
    milestone_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_milestones.id"), index=True)
    cue_id: Mapped[UUID] = mapped_column(ForeignKey("sound_lists_cues.id"), index=True)
    position: Mapped[int]
    price_minor: Mapped[int | None] = mapped_column(BigInteger)  # as asked for; the weight of its share
    amount_minor: Mapped[int | None] = mapped_column(BigInteger)  # its share, from the agreement on
    estimate_min: Mapped[int | None]  # minutes of work; stands from the agreement on
    accepted_at: Mapped[datetime | None]
    accepted_by: Mapped[AcceptedBy | None]
    cut_at: Mapped[datetime | None]
    cut_in: Mapped[WorkState | None]
    change_requested_at: Mapped[datetime | None]  # the first round of changes that was counted
    cue: Mapped[Cue] = relationship(lazy="raise")


class DateReminder(ProjectOwned, Base):
    """A reminder of a day that a contract names, sent once to both parties."""

    __tablename__ = "contracts_date_reminders"

    contract_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_contracts.id"), primary_key=True)
    term: Mapped[str] = mapped_column(primary_key=True)  # that names the day
    day: Mapped[date] = mapped_column(primary_key=True)
    sent_at: Mapped[datetime] = mapped_column(default=clock.now)


class ClockPause(ProjectOwned, Base):
    """A time in which the days of a contract's clause on silence did not count, because a change order was open."""

    __tablename__ = "contracts_clock_pauses"
    __table_args__ = (CheckConstraint("ended_at is null or ended_at >= began_at", name="ends_after_it_began"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    contract_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_contracts.id"), index=True)
    change_order: Mapped[int]  # its number in the contract
    began_at: Mapped[datetime] = mapped_column(default=clock.now)
    ended_at: Mapped[datetime | None]


class Reminder(ProjectOwned, Dated, Base):
    """One mail to the approver of a cue that a clause on silence will accept."""

    __tablename__ = "contracts_approval_reminders"
    __table_args__ = (UniqueConstraint("cue_id", "waiting_since", "number"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    cue_id: Mapped[UUID] = mapped_column(ForeignKey("sound_lists_cues.id"))
    waiting_since: Mapped[datetime]  # another version of the cue starts a new wait
    number: Mapped[int]


# On record: `soundlist verify` holds each of these rows against what was written down of it. What a contract is agreed
# on is private to the studio while it is a draft, and goes on record whole each time that it is sent.
declare(
    Contract,
    "contract",
    owners=lambda _session, contract: (contract.id,),
    # Which state it is in follows from the kinds of entries; the rest says how far the record itself is.
    left_out=("state", "record_length", "record_sha256", "head_mailed_length", "head_mailed_on"),
    implied=(),
    is_draft=True,
)
declare(ContractVersion, "version", digested=("text",), is_draft=True)
declare(ContractSigner, "signer", is_draft=True)
declare(Milestone, "milestone", is_draft=True)
declare(ContractCue, "cue of the plan", is_draft=True)
declare(ContractAcceptance, "signature", digested=("address", "agent"))
declare(Seal, "seal")
declare(ClockPause, "pause of the clause on silence")
