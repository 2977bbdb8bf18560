"""The tables of this room."""

from datetime import date, datetime
from uuid import UUID

from sqlalchemy import BigInteger, CheckConstraint, ForeignKey, Index, UniqueConstraint, text
from sqlalchemy.orm import Mapped, mapped_column, relationship

from app.accounts.models import Person
from app.core import clock
from app.core.columns import Dated, ProjectOwned
from app.core.db import Base, new_id
from app.core.recorded_rows import declare
from app.money.ledger.rules import LineKind
from app.sound_lists.models import Cue


class Invoice(Dated, Base):
    """A designer's request for payment by a studio; its amounts are those of its lines."""

    __tablename__ = "contracts_invoices"
    __table_args__ = (
        UniqueConstraint("studio_id", "designer_id", "number"),
        UniqueConstraint("studio_id", "designer_id", "full_number"),
        CheckConstraint("number > 0", name="numbered_from_one"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"))
    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"), index=True)
    contract_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_contracts.id"), index=True)
    designer_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), index=True)
    number: Mapped[int]  # counts without gaps for one designer and one studio
    full_number: Mapped[str]  # as the designer numbers their invoices, to whichever studio: "INV-2026-014"
    issued_on: Mapped[date]
    due_on: Mapped[date]
    po_number: Mapped[str] = mapped_column(default="")
    seller: Mapped[str]  # name, address and tax number, as printed
    buyer: Mapped[str]
    note: Mapped[str] = mapped_column(default="")
    reverse_charge: Mapped[bool] = mapped_column(default=False)
    issued_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))


class Payment(ProjectOwned, Dated, Base):
    """Money that changed hands for an invoice, as recorded by a person; a refund names the payment it gives back."""

    __tablename__ = "contracts_payments"
    __table_args__ = (CheckConstraint("amount_minor <> 0", name="not_nothing"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    contract_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_contracts.id"), index=True)
    invoice_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_invoices.id"), index=True)
    refund_of_id: Mapped[UUID | None] = mapped_column(ForeignKey("contracts_payments.id"), index=True)
    amount_minor: Mapped[int] = mapped_column(BigInteger)  # to the designer; below zero: back to the studio
    reference: Mapped[str]
    paid_on: Mapped[date]
    recorded_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))


class LedgerLine(ProjectOwned, Dated, Base):
    """One line of a contract's ledger; lines are added, never changed."""

    __tablename__ = "contracts_ledger_lines"
    __table_args__ = (
        CheckConstraint("amount_minor <> 0", name="not_nothing"),
        CheckConstraint("(kind in ('paid', 'refunded')) = (payment_id is not null)", name="payments_are_named"),
        CheckConstraint("(kind in ('reversed', 'paid', 'refunded')) = (about_id is not null)", name="about_a_line"),
        CheckConstraint(
            "cue_id is not null or milestone_id is not null or tax_bp is not null or late_invoice_id is not null"
            " or kind in ('bonus', 'worked_day', 'worked_hours', 'retainer') or about_id is not null",
            name="about_something",
        ),
        CheckConstraint("(kind = 'worked_hours') = (worked_day_id is not null)", name="hours_are_named"),
        CheckConstraint("(kind = 'retainer') = (month_number is not null)", name="months_are_numbered"),
        CheckConstraint("(late_invoice_id is null) = (late_until_on is null)", name="late_until_a_day"),
        Index(
            "uq_contracts_ledger_lines_reversed",
            "about_id",
            unique=True,
            sqlite_where=text("kind = 'reversed'"),
            postgresql_where=text("kind = 'reversed'"),
        ),
        Index(
            "uq_contracts_ledger_lines_round",
            *("contract_id", "cue_id", "round_number"),
            unique=True,
            sqlite_where=text("kind = 'extra_round'"),
            postgresql_where=text("kind = 'extra_round'"),
        ),
        Index(
            "uq_contracts_ledger_lines_month",
            *("contract_id", "month_number"),
            unique=True,
            sqlite_where=text("kind = 'retainer'"),
            postgresql_where=text("kind = 'retainer'"),
        ),
        Index(
            "uq_contracts_ledger_lines_hours",
            "worked_day_id",
            unique=True,
            sqlite_where=text("kind = 'worked_hours'"),
            postgresql_where=text("kind = 'worked_hours'"),
        ),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    contract_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_contracts.id"), index=True)
    kind: Mapped[LineKind]
    amount_minor: Mapped[int] = mapped_column(BigInteger)
    clause: Mapped[str]  # key of the clause by which it is so
    cue_id: Mapped[UUID | None] = mapped_column(ForeignKey("sound_lists_cues.id"))
    milestone_id: Mapped[UUID | None] = mapped_column(ForeignKey("contracts_milestones.id"))
    about_id: Mapped[UUID | None] = mapped_column(ForeignKey("contracts_ledger_lines.id"))
    round_number: Mapped[int | None]
    tax_bp: Mapped[int | None]
    payment_id: Mapped[UUID | None] = mapped_column(ForeignKey("contracts_payments.id"))
    late_invoice_id: Mapped[UUID | None] = mapped_column(ForeignKey("contracts_invoices.id"))  # paid late
    late_until_on: Mapped[date | None]  # the day up to which interest is charged
    worked_day_id: Mapped[UUID | None] = mapped_column(ForeignKey("contracts_worked_days.id"))  # of hours
    month_number: Mapped[int | None]  # the month of a retainer, counted from the agreement
    person_id: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))  # whose act it follows; None: none
    person: Mapped[Person | None] = relationship(lazy="raise")
    cue: Mapped[Cue | None] = relationship(lazy="raise")


class InvoiceLine(ProjectOwned, Base):
    """Puts a line of the ledger on an invoice; once, for good."""

    __tablename__ = "contracts_invoice_lines"

    ledger_line_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_ledger_lines.id"), primary_key=True)
    invoice_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_invoices.id"), index=True)
    text: Mapped[str]  # as printed


class ExtraRound(ProjectOwned, Base):
    """A round beyond the included ones: it waits until the studio agrees to its price, or the designer lets it go."""

    __tablename__ = "contracts_extra_rounds"
    __table_args__ = (
        UniqueConstraint("contract_id", "cue_id", "number"),
        CheckConstraint("agreed_at is null or dropped_at is null", name="agreed_or_dropped"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    contract_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_contracts.id"))
    cue_id: Mapped[UUID] = mapped_column(ForeignKey("sound_lists_cues.id"), index=True)
    number: Mapped[int]
    proposed_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    proposed_at: Mapped[datetime] = mapped_column(default=clock.now)
    agreed_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    agreed_at: Mapped[datetime | None]
    dropped_at: Mapped[datetime | None]
    cue: Mapped[Cue] = relationship(lazy="raise")


class WorkLog(ProjectOwned, Dated, Base):
    """Time that a designer says went into a cue; seen by the two parties only."""

    __tablename__ = "contracts_work_logs"
    __table_args__ = (CheckConstraint("minutes > 0", name="minutes_positive"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    contract_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_contracts.id"), index=True)
    cue_id: Mapped[UUID] = mapped_column(ForeignKey("sound_lists_cues.id"), index=True)
    minutes: Mapped[int]
    worked_on: Mapped[date]
    logged_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))


class OwnTime(ProjectOwned, Dated, Base):
    """Time that a person logged in a project without a contract; seen by that person only."""

    __tablename__ = "contracts_own_times"
    __table_args__ = (CheckConstraint("minutes between 1 and 1440", name="hours_of_a_day_at_most"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), index=True)
    cue_id: Mapped[UUID | None] = mapped_column(ForeignKey("sound_lists_cues.id"))  # that it went into
    minutes: Mapped[int]
    worked_on: Mapped[date]
    note: Mapped[str]
    cue: Mapped[Cue | None] = relationship(lazy="raise")


class WorkedDay(ProjectOwned, Dated, Base):
    """Work of a day, in quarters of a day or in minutes; due once the studio has agreed to it, up to the cap."""

    __tablename__ = "contracts_worked_days"
    __table_args__ = (
        Index(
            "uq_contracts_worked_days_quarters",
            *("contract_id", "worked_on"),
            unique=True,
            sqlite_where=text("quarters is not null"),
            postgresql_where=text("quarters is not null"),
        ),
        CheckConstraint("quarters between 1 and 4", name="a_day_at_most"),
        CheckConstraint("minutes between 1 and 1440", name="hours_of_a_day_at_most"),
        CheckConstraint("(quarters is null) <> (minutes is null)", name="in_one_unit"),
        CheckConstraint("agreed_by is null or agreed_at is not null", name="agreed_at_some_time"),
        CheckConstraint("(refused_at is null) = (refused_by is null)", name="refused_by_somebody"),
        CheckConstraint("agreed_at is null or refused_at is null", name="agreed_or_refused"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    contract_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_contracts.id"), index=True)
    milestone_id: Mapped[UUID | None] = mapped_column(ForeignKey("contracts_milestones.id"))  # of days
    cue_id: Mapped[UUID | None] = mapped_column(ForeignKey("sound_lists_cues.id"))  # that hours went into
    worked_on: Mapped[date]
    quarters: Mapped[int | None]  # of a day
    minutes: Mapped[int | None]
    note: Mapped[str]
    logged_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    agreed_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))  # None: by the settlement
    agreed_at: Mapped[datetime | None]
    refused_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    refused_at: Mapped[datetime | None]
    refusal: Mapped[str] = mapped_column(default="")  # why; the designer may correct it and send it again
    cue: Mapped[Cue | None] = relationship(lazy="raise")


class CalendarLink(ProjectOwned, Dated, Base):
    """A secret address at which a person's calendar reads the dates of their contracts in a project."""

    __tablename__ = "contracts_calendar_links"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), index=True)
    secret_sha256: Mapped[str] = mapped_column(unique=True)
    revoked_at: Mapped[datetime | None]


declare(Invoice, "invoice")
declare(
    InvoiceLine,
    "invoice line",
    owners=lambda session, line: (session.get_one(Invoice, line.invoice_id).contract_id,),
)
declare(Payment, "payment")
declare(LedgerLine, "ledger line")
declare(ExtraRound, "further round")
declare(WorkedDay, "logged work")
