"""A producer says that the game has shipped, where a bonus waits for it."""

from datetime import date
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor, Role, SecondFactorUse
from app.accounts.second_factors.requirements import ensure_second_factor_for
from app.agreements.access import visible_contract
from app.agreements.clauses.terms import BonusWhen
from app.agreements.plan.queries import terms_of
from app.agreements.queries import lock_contract
from app.agreements.record import service as record
from app.agreements.rules import ContractState
from app.core import clock
from app.core.plural import day_in_words
from app.money.bonuses.service import studio_days
from app.money.errors import NoShippingBonus
from app.money.ledger.rules import ensure_not_ahead
from app.money.settlement import settle
from app.projects.errors import ProducerNeeded


def say_shipped(session: Session, actor: Actor, contract_id: UUID, *, shipped_on: date) -> None:
    """Record that the game shipped on a day; the bonus that waits for it is due at once."""
    contract = visible_contract(session, actor, contract_id)
    if Role.PRODUCER not in actor.roles_in(contract.studio_id):
        raise ProducerNeeded("only a producer of the studio says that the game has shipped")
    ensure_second_factor_for(session, actor, contract.studio_id, SecondFactorUse.PAYING)
    lock_contract(session, contract.id)
    session.refresh(contract, ["state", "game_shipped_on"])
    terms = terms_of(session, contract)
    if contract.state is not ContractState.AGREED or terms.bonus_when is not BonusWhen.SHIPPED or not terms.bonus_minor:
        raise NoShippingBonus(
            "this contract has no bonus that waits for the game to ship",
            fix="propose a change order that adds it as work"
            if contract.state is ContractState.AGREED
            else "this is final: a bonus is missed where the contract ended before",
        )
    if contract.game_shipped_on is not None:
        raise NoShippingBonus(
            f"it is on record that the game shipped on {day_in_words(contract.game_shipped_on)}",
            fix="this is final: the bonus is due since then",
        )
    today = studio_days(session, contract).of(clock.now())
    ensure_not_ahead(shipped_on, today, "a game that has not shipped yet sets off no bonus")
    contract.game_shipped_on = shipped_on
    facts = {"shipped_on": shipped_on.isoformat()}
    record.append(session, contract.id, "shipped", facts, by=actor.person)
    settle(session, contract.id, actor.person)
