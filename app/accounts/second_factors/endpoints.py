"""The endpoints of second factors: the caller's own, and what a studio requires one for."""

from uuid import UUID

from fastapi import APIRouter, Request

from app.accounts.authentication import SESSION_COOKIE
from app.accounts.errors import (
    NoSecondFactor,
    NotInDemo,
    ProducerNeeded,
    RecentSignInNeeded,
    SecondFactorExists,
    StudioNotFound,
    TooManyAttempts,
    WrongSecondFactor,
)
from app.accounts.rules import Actor, Audience
from app.accounts.second_factors import requirements as second_factor_requirements
from app.accounts.second_factors import service as second_factors
from app.accounts.second_factors.schemas import (
    RecoveryCodesMade,
    SecondFactorRequirement,
    SecondFactorsRead,
    TotpConfirm,
    TotpSetupRead,
)
from app.accounts.second_factors.service import SecondFactors, TotpSetup
from app.accounts.web.policies import allows
from app.accounts.web.request_limits import (
    DeferredSession,
    ensure_second_factor_allowed,
)
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.core.web.idempotency import UNSAVED

router = APIRouter(prefix="/v1", tags=["accounts"])
_unsaved_router = APIRouter(dependencies=UNSAVED)


@router.get("/me/second-factors", response_model=SecondFactorsRead)
def read_my_second_factors(session: DbSession, actor: Actor = allows(Audience.PERSON)) -> SecondFactors:
    """Return the second factors of the caller's account, without their secrets."""
    return second_factors.second_factors_of(session, actor)


@_unsaved_router.post(
    "/me/totp",
    status_code=201,
    response_model=TotpSetupRead,
    responses=problems(NotInDemo, RecentSignInNeeded, SecondFactorExists),
)
def begin_my_totp(
    session: DbSession, runtime: CurrentRuntime, actor: Actor = allows(Audience.PERSON, recent_sign_in=True)
) -> TotpSetup:
    """Begin to set up an authenticator app; a code of it confirms it, and until then nothing changes."""
    return second_factors.begin_totp(session, actor, runtime.settings)


@_unsaved_router.post(
    "/me/totp/confirm",
    responses=problems(NoSecondFactor, RecentSignInNeeded, SecondFactorExists, TooManyAttempts, WrongSecondFactor),
)
def confirm_my_totp(
    body: TotpConfirm,
    request: Request,
    begin: DeferredSession,
    runtime: CurrentRuntime,
    actor: Actor = allows(Audience.PERSON, recent_sign_in=True),
) -> RecoveryCodesMade:
    """Put the authenticator app to use by its first code, and sign every other browser of the caller out."""
    ensure_second_factor_allowed(request, str(actor.person))
    kept_secret = request.cookies.get(SESSION_COOKIE)
    with begin() as session:
        codes = second_factors.confirm_totp(session, actor, runtime.settings, body.code, kept_secret=kept_secret)
    return RecoveryCodesMade(recovery_codes=codes)


@router.delete("/me/totp", status_code=204, responses=problems(NoSecondFactor, RecentSignInNeeded))
def end_my_totp(session: DbSession, actor: Actor = allows(Audience.PERSON, recent_sign_in=True)) -> None:
    """Remove the caller's authenticator app, and the recovery codes with it."""
    second_factors.end_totp(session, actor)


@_unsaved_router.post("/me/recovery-codes", status_code=201, responses=problems(NoSecondFactor, RecentSignInNeeded))
def renew_my_recovery_codes(
    session: DbSession, actor: Actor = allows(Audience.PERSON, recent_sign_in=True)
) -> RecoveryCodesMade:
    """Make new recovery codes, shown this once; the earlier ones stop working."""
    return RecoveryCodesMade(recovery_codes=second_factors.renew_recovery_codes(session, actor))


@router.get("/studios/{studio_id}/second-factor", responses=problems(StudioNotFound))
def read_second_factor_requirement(
    studio_id: UUID, session: DbSession, actor: Actor = allows(Audience.STUDIO)
) -> SecondFactorRequirement:
    """Return the acts for which the studio requires a second factor."""
    return SecondFactorRequirement(required_for=second_factor_requirements.requirement(session, actor, studio_id))


@router.put(
    "/studios/{studio_id}/second-factor",
    responses=problems(StudioNotFound, ProducerNeeded, NoSecondFactor, NotInDemo, RecentSignInNeeded),
)
def set_second_factor_requirement(
    studio_id: UUID,
    body: SecondFactorRequirement,
    session: DbSession,
    actor: Actor = allows(Audience.PRODUCER, recent_sign_in=True),
) -> SecondFactorRequirement:
    """Set the uses for which the studio requires a second factor."""
    uses = second_factor_requirements.set_requirement(session, actor, studio_id, body.required_for)
    return SecondFactorRequirement(required_for=uses)


router.include_router(_unsaved_router)
