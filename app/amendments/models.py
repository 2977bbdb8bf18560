"""The tables of this room; their names begin with `contracts_`, as those of all that belongs to a contract."""

from datetime import date, datetime
from typing import Any
from uuid import UUID

from sqlalchemy import CheckConstraint, ForeignKey, Index, UniqueConstraint, text
from sqlalchemy.orm import Mapped, mapped_column, relationship

from app.accounts.models import Person
from app.agreements.models import Acceptance
from app.agreements.rules import Party
from app.amendments.rules import ChangeOrderState
from app.core import clock
from app.core.columns import ProjectOwned
from app.core.db import Base, new_id
from app.core.recorded_rows import declare


class Notice(ProjectOwned, Base):
    """A party's notice that a contract ends early: until when it can be withdrawn, and what was settled."""

    __tablename__ = "contracts_notices"
    __table_args__ = (
        UniqueConstraint("contract_id", "number"),
        CheckConstraint("withdrawn_at is null or settled_at is null", name="withdrawn_or_settled"),
        CheckConstraint("(settled_at is null) = (statement is null)", name="settled_by_a_statement"),
        CheckConstraint("(statement is null) = (statement_sha256 is null)", name="statement_has_hash"),
        Index(
            "uq_contracts_notices_standing",
            "contract_id",
            unique=True,
            sqlite_where=text("withdrawn_at is null"),
            postgresql_where=text("withdrawn_at is null"),
        ),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    contract_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_contracts.id"))
    number: Mapped[int]  # counts in the contract
    party: Mapped[Party]
    given_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    given_at: Mapped[datetime] = mapped_column(default=clock.now)
    reason: Mapped[str]
    ends_on: Mapped[date | None]  # last day; None: only when both agree to the statement
    withdrawn_at: Mapped[datetime | None]
    settled_at: Mapped[datetime | None]
    statement: Mapped[str | None]  # Markdown, as it took effect
    statement_sha256: Mapped[str | None]
    giver: Mapped[Person] = relationship(lazy="raise")


class ChangeOrder(ProjectOwned, Base):
    """A change of an agreed contract as one party proposes it; it holds once both have accepted its text."""

    __tablename__ = "contracts_change_orders"
    __table_args__ = (
        UniqueConstraint("contract_id", "number"),
        CheckConstraint("(state = 'proposed') = (closed_at is null)", name="closed_is_dated"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    contract_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_contracts.id"))
    number: Mapped[int]  # counts in the contract
    state: Mapped[ChangeOrderState] = mapped_column(default=ChangeOrderState.PROPOSED)
    party: Mapped[Party]
    proposed_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    proposed_at: Mapped[datetime] = mapped_column(default=clock.now)
    reason: Mapped[str]
    begins_at_once: Mapped[bool]  # work begins before both agree, at the risk of the party that proposes
    changes: Mapped[list[dict[str, Any]]]
    text: Mapped[str]  # Markdown, as both read it
    text_sha256: Mapped[str]
    closed_at: Mapped[datetime | None]
    close_reason: Mapped[str] = mapped_column(default="")
    proposer: Mapped[Person] = relationship(lazy="raise")


class AmendmentAcceptance(Acceptance, Base):
    """One person's yes to the text of a statement or change order."""

    __tablename__ = "contracts_amendment_acceptances"
    __table_args__ = (
        UniqueConstraint("contract_id", "text_sha256", "person_id", name="uq_contracts_amendment_acceptances_person"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    contract_id: Mapped[UUID] = mapped_column(ForeignKey("contracts_contracts.id"))
    text_sha256: Mapped[str]


declare(Notice, "notice", digested=("statement",))
declare(ChangeOrder, "change order", digested=("text",))
declare(AmendmentAcceptance, "signature of an amendment", digested=("address", "agent"))
