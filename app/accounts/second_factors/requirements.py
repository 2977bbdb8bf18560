"""The uses for which studios require a second factor."""

from collections.abc import Collection
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.authentication import SET_UP_SECOND_FACTOR as SET_UP
from app.accounts.errors import NoSecondFactor, NotInDemo, SecondFactorRequired
from app.accounts.models import Studio
from app.accounts.rules import Actor, SecondFactorUse
from app.accounts.second_factors import queries as second_factor_queries
from app.accounts.service import ensure_member_of, ensure_producer_of
from app.core.db import bypass_row_policies

USE_WORDS = {SecondFactorUse.SIGNING: "who signs its contracts", SecondFactorUse.PAYING: "who pays"}


def requirement(session: Session, actor: Actor, studio_id: UUID) -> list[SecondFactorUse]:
    """Return the acts for which the caller's studio requires a second factor."""
    ensure_member_of(actor, studio_id)
    return [SecondFactorUse(use) for use in session.get_one(Studio, studio_id).second_factor_for]


def set_requirement(
    session: Session, actor: Actor, studio_id: UUID, uses: Collection[SecondFactorUse]
) -> list[SecondFactorUse]:
    """Set the uses for which a studio requires a second factor, as a producer who has one."""
    studio = ensure_producer_of(session, actor, studio_id)
    if studio.is_demo:
        raise NotInDemo("the people of the demo have no second factor")
    is_vouched_for = actor.second_factor_studio_id == studio_id
    if uses and not is_vouched_for and not second_factor_queries.has_second_factor(session, actor.person):
        raise NoSecondFactor(
            "you have no second factor yourself, so this would shut you out",
            fix=f"{SET_UP} first",
        )
    studio.second_factor_for = [use.value for use in SecondFactorUse if use in uses]
    session.flush()
    return requirement(session, actor, studio_id)


def ensure_second_factor_for(session: Session, actor: Actor, studio_id: UUID, use: SecondFactorUse) -> None:
    """Raise SecondFactorRequired where a studio requires a second factor for this and the caller has none.

    That the studio's own sign-in provider asked for one counts as much.
    """
    if actor.second_factor_studio_id == studio_id:
        return
    with bypass_row_policies(session):  # a designer does not see all of the studio
        studio = session.get_one(Studio, studio_id)
        if not {use.value, SecondFactorUse.EVERYTHING.value} & set(studio.second_factor_for):
            return
        if second_factor_queries.has_second_factor(session, actor.person):
            return
    raise SecondFactorRequired(
        f"{studio.name} requires a second factor of {USE_WORDS[use]}, and your account has none; nothing was done",
        fix=f"{SET_UP}, then repeat this",
    )
