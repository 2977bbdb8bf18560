"""What a transaction changes in declared tables is collected for the record: those columns and no others."""

from collections.abc import Iterator
from datetime import date
from typing import Any

import pytest
import sqlalchemy as sa
from sqlalchemy.orm import Session

from app.core.db import Base, new_id
from app.core.recorded_rows import TABLES, RowChanges, owners_with_changes, take_changes
from app.money.models import Payment
from app.tables import is_ours

CONTRACT = new_id()
# Of a contract, and on no record: no money and no right depends on them.
NOT_ON_RECORD = {
    "contracts_events": "the record itself",
    "contracts_signing_codes": "mailed codes; the signature says that one was entered",
    "contracts_date_reminders": "mails that were sent",
    "contracts_work_logs": "time for estimates, which owes nothing",
    "hiring_postings": "which posting a contract came from",
}


@pytest.fixture
def session() -> Iterator[Session]:
    engine = sa.create_engine("sqlite://")
    Base.metadata.create_all(engine, tables=[Base.metadata.tables["contracts_payments"]])
    with Session(engine, expire_on_commit=False) as session:
        yield session
    engine.dispose()


def payment(**facts: Any) -> Payment:
    ids = {name: new_id() for name in ("studio_id", "project_id", "invoice_id", "recorded_by")}
    return Payment(
        **ids, contract_id=CONTRACT, **{"amount_minor": 100, "reference": "T-1", "paid_on": date(2026, 3, 2)} | facts
    )


def rows(session: Session) -> dict[str, Any]:
    session.flush()
    return take_changes(session, CONTRACT).as_json()


def test_a_new_row_is_collected_whole_and_what_is_empty_left_out(session: Session) -> None:
    added = payment()
    session.add(added)
    assert rows(session) == {
        "added": {
            "payment": {
                str(added.id): {
                    "invoice_id": str(added.invoice_id),
                    "amount_minor": 100,
                    "reference": "T-1",
                    "paid_on": "2026-03-02",
                    "recorded_by": str(added.recorded_by),
                    "created_at": added.created_at.isoformat(timespec="microseconds"),
                }
            }
        }
    }
    assert rows(session) == {}, "it was collected once"


def test_what_was_altered_by_hand_is_not_taken_over_by_a_later_change(session: Session) -> None:
    added = payment()
    session.add(added)
    rows(session)
    session.execute(sa.text("update contracts_payments set amount_minor = 999"))
    session.refresh(added)
    added.reference = "T-2"
    assert rows(session) == {"changed": {"payment": {str(added.id): {"reference": "T-2"}}}}


def test_a_row_that_comes_and_goes_in_one_transaction_leaves_nothing(session: Session) -> None:
    added = payment()
    session.add(added)
    session.flush()
    added.reference = "T-3"
    session.flush()
    session.delete(added)
    assert rows(session) == {}


def test_a_removed_row_is_named(session: Session) -> None:
    added = payment()
    session.add(added)
    rows(session)
    session.delete(added)
    assert rows(session) == {"removed": {"payment": [str(added.id)]}}


def test_a_rollback_forgets_what_was_collected(session: Session) -> None:
    session.add(payment())
    session.flush()
    assert owners_with_changes(session) == [CONTRACT]
    session.rollback()
    assert owners_with_changes(session) == []


def test_long_and_private_values_are_hashes() -> None:
    table = next(table for table in TABLES.values() if table.name == "signature")
    # SHA-256 of "abc", FIPS 180-2, appendix B.1
    abc = "sha256:ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
    assert table.value("address", "abc") == abc
    assert table.value("name", "abc") == "abc"
    assert RowChanges().as_json() == {}


def test_every_table_of_a_contract_is_on_record_or_says_why_not() -> None:
    of_contracts = {
        name for name, table in Base.metadata.tables.items() if is_ours(name) and "contract_id" in table.columns
    }
    assert of_contracts - {model.__tablename__ for model in TABLES} == NOT_ON_RECORD.keys()
