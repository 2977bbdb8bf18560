"""A contract that both agreed to, with takes to judge under it."""

from dataclasses import dataclass, field
from datetime import timedelta
from typing import Any
from uuid import UUID

import sqlalchemy as sa
from sqlalchemy.orm import Session

from app.agreements.clauses.rules import Clause
from app.agreements.models import Contract, ContractVersion
from app.agreements.plan.service import activate_plan
from app.agreements.rules import ContractKind, ContractState, ReleaseClause
from app.core import clock
from app.money.ledger.service import charge_deposits
from app.projects.models import Engagement
from tests.app.reviews.making import Stage

# What the library's clauses say of rounds and cut cues.
LIBRARY_TERMS = {
    "rounds_included": 2,
    "extra_round_bp": 2_500,
    "kill_fee_not_begun_bp": 0,
    "kill_fee_in_work_bp": 5_000,
    "kill_fee_delivered_bp": 7_500,
}
TODAY = clock.now().date()


def day(days: int) -> str:
    """Return a day so many days from now."""
    return (TODAY + timedelta(days=days)).isoformat()


@dataclass
class Agreed(Stage):
    """A stage whose designer works under contract."""

    terms: dict[str, Any] = field(default_factory=dict)
    release: ReleaseClause = ReleaseClause.PER_CUE
    currency: str = "USD"

    def __post_init__(self) -> None:
        super().__post_init__()
        self.contract_id: UUID = self.world.server.in_database(self._draft)

    def _draft(self, session: Session) -> UUID:
        world, terms = self.world, LIBRARY_TERMS | self.terms
        engagement = session.scalars(sa.select(Engagement).where(Engagement.designer_id == world.designer_id)).one()
        of = {"studio_id": world.studio_id, "project_id": world.project_id}
        contract = Contract(
            **of,
            engagement_id=engagement.id,
            designer_id=world.designer_id,
            number=1,
            title="Effects",
            kind=ContractKind.SINGLE,
            currency=self.currency,
            release_clause=self.release,
            created_by=world.producer_id,
        )
        session.add(contract)
        session.flush()
        version = ContractVersion(
            **of,
            contract_id=contract.id,
            number=1,
            clauses=[Clause("terms", "Terms", " ".join(f"{{{name}}}" for name in terms)).as_row()],
            terms=terms,
            text="",
            text_sha256="",
            created_by=world.producer_id,
        )
        session.add(version)
        return contract.id

    def plan(self, *planned: dict[str, Any]) -> Any:
        """Save a plan as the producer."""
        body = {"milestones": list(planned)}
        return self.world.producer.put(f"/v1/contracts/{self.contract_id}/milestones", json=body)

    def agree(self, *planned: dict[str, Any]) -> None:
        """Plan, and have both say yes."""
        answer = self.plan(*planned)
        assert answer.status_code == 200, answer.text

        def both(session: Session) -> None:
            contract = session.get_one(Contract, self.contract_id)
            contract.state, contract.agreed_at = ContractState.AGREED, clock.now()
            activate_plan(session, contract, person_id=self.world.producer_id)
            agreed = {"contract_id": str(contract.id), "person_id": str(self.world.producer_id)}
            charge_deposits(session, agreed)

        self.world.server.in_database(both)

    def ledger(self, by: Any = None) -> dict[str, Any]:
        """Return the ledger as the producer, or another person, reads it."""
        answer = (by or self.world.producer).get(f"/v1/contracts/{self.contract_id}/ledger")
        assert answer.status_code == 200, answer.text
        body: dict[str, Any] = answer.json()
        return body

    def figures(self) -> dict[str, int]:
        """Return what the contract comes to."""
        figures: dict[str, int] = self.ledger()["figures"]
        return figures

    def owed(self) -> list[tuple[str, int]]:
        """Return kind and amount of every line."""
        return [(line["kind"], line["amount_minor"]) for line in self.ledger()["lines"]]

    def invoice(self, **more: str) -> dict[str, Any]:
        """Issue an invoice as the designer."""
        body = {"seller": "Sound designer\n1 Quay Street"} | more
        answer = self.world.designer.post(f"/v1/contracts/{self.contract_id}/invoices", json=body)
        assert answer.status_code == 201, answer.text
        issued: dict[str, Any] = answer.json()
        return issued

    def pay(self, invoice: dict[str, Any], amount_minor: int, reference: str = "T-1") -> Any:
        """Record a payment as the producer."""
        body = {"amount_minor": amount_minor, "reference": reference, "paid_on": TODAY.isoformat()}
        return self.world.producer.post(f"/v1/invoices/{invoice['id']}/payments", json=body)


def milestone(name: str, *cue_ids: UUID, **more: Any) -> dict[str, Any]:
    """Return a planned milestone over some cues."""
    return {"name": name, "cues": [{"cue_id": str(cue_id)} for cue_id in cue_ids], "due_on": day(14)} | more


def deposit(amount_minor: int) -> dict[str, Any]:
    """Return a planned deposit."""
    return {"name": "Deposit", "amount_minor": amount_minor, "is_deposit": True}
