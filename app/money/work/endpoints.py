"""The endpoints of days and hours worked."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.agreements.errors import ContractNotFound
from app.core.web.http import DbSession, problems
from app.money.errors import (
    CapExceeded,
    DayAgreed,
    DayInFuture,
    DayLogged,
    DayRefused,
    NotAgreed,
    NotDayRate,
    NotHourly,
    OtherPartyNeeded,
    WorkedDayNotFound,
    WorkNotNamed,
)
from app.money.work import service as days
from app.money.work.reading import worked_day, worked_days
from app.money.work.schemas import WorkedDayAdd, WorkedDayRead, WorkRefusal
from app.money.work.service import Work
from app.projects.errors import ProducerNeeded
from app.sound_lists.errors import CueNotFound

router = APIRouter(prefix="/v1", tags=["money"])
LOGGING = (
    *(OtherPartyNeeded, NotAgreed, NotDayRate, NotHourly, CapExceeded, DayAgreed),
    *(DayInFuture, WorkNotNamed, CueNotFound),
)


@router.get("/contracts/{contract_id}/worked-days", responses=problems(ContractNotFound))
def list_worked_days(
    contract_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> list[WorkedDayRead]:
    """Return the days and hours that were logged under a contract."""
    return worked_days(session, actor, contract_id)


@router.post("/contracts/{contract_id}/worked-days", status_code=201, responses=problems(ContractNotFound, *LOGGING))
def log_day(
    contract_id: UUID, body: WorkedDayAdd, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> WorkedDayRead:
    """Log a day, quarters of one, or hours; a day that is logged again is corrected."""
    return worked_day(session, days.log_work(session, actor, contract_id, Work(**body.model_dump())))


@router.put("/worked-days/{worked_day_id}", responses=problems(WorkedDayNotFound, DayLogged, *LOGGING))
def correct_day(
    worked_day_id: UUID, body: WorkedDayAdd, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> WorkedDayRead:
    """Correct logged work and send it again, refused or not, until the studio agrees to it."""
    return worked_day(session, days.correct_work(session, actor, worked_day_id, Work(**body.model_dump())))


@router.delete(
    "/worked-days/{worked_day_id}",
    status_code=204,
    responses=problems(WorkedDayNotFound, OtherPartyNeeded, DayAgreed),
)
def drop_day(worked_day_id: UUID, session: DbSession, actor: Actor = allows(Audience.DESIGNER)) -> None:
    """Take logged work back, until the studio agrees to it."""
    days.drop_day(session, actor, worked_day_id)


@router.post(
    "/worked-days/{worked_day_id}/agree",
    responses=problems(WorkedDayNotFound, ProducerNeeded, DayAgreed, DayRefused, CapExceeded),
)
def agree_day(worked_day_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)) -> WorkedDayRead:
    """Agree to logged work; it is due, up to the cap."""
    return worked_day(session, days.agree_day(session, actor, worked_day_id))


@router.post(
    "/worked-days/{worked_day_id}/refuse",
    responses=problems(WorkedDayNotFound, ProducerNeeded, DayAgreed, DayRefused),
)
def refuse_day(
    worked_day_id: UUID, body: WorkRefusal, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> WorkedDayRead:
    """Refuse logged work and say why; its designer can correct it and send it again."""
    return worked_day(session, days.refuse_day(session, actor, worked_day_id, reason=body.reason))
