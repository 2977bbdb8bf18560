"""What each designer of joint work makes and is paid: the figures of its text, its record and its page."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sqlalchemy.orm import Session

from app.agreements.clauses.rules import BY_DAY
from app.agreements.clauses.text import literal
from app.agreements.joint.queries import other_contract
from app.agreements.joint.rules import shares_in_words
from app.agreements.models import Contract, ContractCue, Milestone
from app.agreements.plan.queries import agreed_terms, cues_of, milestones_of
from app.core.money import money
from app.sound_lists.rules import label


@dataclass(frozen=True)
class Part:
    """One designer's part of joint work: the contract, its price and its cues."""

    contract: Contract
    amount_minor: int
    currency: str
    cues: Sequence[ContractCue]
    share: str = ""  # of the whole, in percent; empty where the currencies differ or nothing is paid


def price_minor(milestones: Sequence[Milestone], terms: Mapping[str, object]) -> int:
    """Return the price of a contract: its milestones, with the highest cost of days, hours and a retainer.

    A draft that is only looked at may have any terms.
    """
    by_day = _product(terms, "day_rate_minor", "days_cap") if terms.get("price_mode") == BY_DAY else 0
    by_hour = _product(terms, "hour_rate_minor", "hours_cap")
    retainer = _product(terms, "retainer_minor", "retainer_months")
    return sum(milestone.amount_minor for milestone in milestones) + by_day + by_hour + retainer


def _product(terms: Mapping[str, object], price: str, count: str) -> int:
    each_minor, times = terms.get(price), terms.get(count)
    return each_minor * times if isinstance(each_minor, int) and isinstance(times, int) else 0


def parts_of(
    session: Session, contract: Contract, terms: Mapping[str, object] | None = None, currency: str | None = None
) -> list[Part]:
    """Return both parts of joint work, the older contract's first; empty for a contract that stands alone.

    The contract's own part is in `terms` and `currency` where a draft of it is looked at.
    """
    other = other_contract(session, contract)
    if other is None:
        return []
    parts = [
        _part(session, contract, agreed_terms(session, contract) if terms is None else terms, currency),
        _part(session, other, agreed_terms(session, other)),
    ]
    parts.sort(key=lambda part: part.contract.number)
    if len({part.currency for part in parts}) > 1:
        return parts
    shares = shares_in_words([part.amount_minor for part in parts])
    return [
        Part(part.contract, part.amount_minor, part.currency, part.cues, share)
        for part, share in zip(parts, shares, strict=True)
    ]


def _part(session: Session, contract: Contract, terms: Mapping[str, object], currency: str | None = None) -> Part:
    amount_minor = price_minor(milestones_of(session, contract.id), terms)
    return Part(contract, amount_minor, currency or contract.currency, cues_of(session, contract.id))


def total_of(parts: Sequence[Part]) -> str:
    """Return the price of the whole work in words; in each currency where they differ."""
    currencies = dict.fromkeys(part.currency for part in parts)
    sums = {name: sum(part.amount_minor for part in parts if part.currency == name) for name in currencies}
    return " and ".join(money(amount_minor, currency) for currency, amount_minor in sums.items())


def table_of(parts: Sequence[Part], cue_prefix: str) -> str:
    """Return both parts as a table in Markdown, with their sum."""
    rows = [["Designer", "Makes", "Price", "Share"], ["---"] * 4]
    for part in parts:
        labels = ", ".join(label(cue_prefix, covered.cue.number) for covered in part.cues)
        name = literal(part.contract.designer.name)
        rows.append([name, labels, money(part.amount_minor, part.currency), part.share])
    rows.append(["Both", "", total_of(parts), ""])
    return "\n".join(f"| {' | '.join(cells)} |" for cells in rows)


def facts_of_split(session: Session, contract: Contract) -> dict[str, Any]:
    """Return, in words for the record, each designer's part of joint work; empty for a contract that stands alone."""
    parts = parts_of(session, contract)
    if not parts:
        return {}
    split = [
        {
            "name": part.contract.designer.name,
            "amount": money(part.amount_minor, part.currency),
            "share": part.share,
            "cues": len(part.cues),
        }
        for part in parts
    ]
    return {"split": split, "together": total_of(parts)}
