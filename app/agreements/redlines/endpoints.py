"""The endpoints of redlines: what a designer wants otherwise in a text that was sent, clause by clause."""

from collections.abc import Sequence
from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Depends, Path, Query, Request

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.agreements.access import party_of, visible_contract
from app.agreements.errors import (
    BadRedlines,
    BadWordFile,
    ContractNotFound,
    NotYourContract,
    OtherContractsFile,
    RedlineNotFound,
    TextChanged,
    WrongState,
)
from app.agreements.redlines import schemas
from app.agreements.redlines import service as redlines
from app.agreements.redlines.rules import Change, RedlineKind, Wording
from app.agreements.rules import ContractState, Party
from app.agreements.schemas import DraftProblem
from app.agreements.word.file import WordText, parse_word_file
from app.core.parsing_queue import ParsingBusy, parse_request
from app.core.web.bodies import LARGE_BODY_BYTES, accepts_body
from app.core.web.http import DbSession, problems
from app.core.web.per_user_limit import PerUserLimit, TooManyAtOnce
from app.projects.errors import ProducerNeeded

router = APIRouter(prefix="/v1", tags=["contracts"])
MARKED = PerUserLimit(2, "texts with redlines")
PREVIEWS = PerUserLimit(2, "previews of redlines")  # apart: those still running keep nobody from sending
RedlineNumber = Annotated[int, Path(ge=1, le=2**31 - 1)]


def _wording(body: schemas.WordingFields) -> Wording:
    return Wording(body.title.strip(), body.text.strip(), body.terms)


def _changes(bodies: Sequence[schemas.RedlineAdd]) -> list[Change]:
    return [
        Change(
            kind=body.kind,
            clause_key=None if body.kind is RedlineKind.INSERT else body.clause_key,
            after_key=body.after_key,
            wording=Wording() if body.kind is RedlineKind.STRIKE else _wording(body),
            comment=body.comment,
        )
        for body in bodies
    ]


def _read(session: DbSession, actor: Actor, contract_id: UUID, number: int | None = None) -> schemas.RedlinesRead:
    contract = visible_contract(session, actor, contract_id)
    rounds = redlines.rounds(session, contract)
    shown = rounds[min(number or len(rounds), len(rounds)) - 1] if rounds else None
    is_last_open = bool(rounds) and rounds[-1].sent_version is None
    return schemas.RedlinesRead(
        contract_id=contract.id,
        project_id=contract.project_id,
        rounds=len(rounds),
        round=schemas.RedlineRoundRead(
            number=shown.number,
            version=shown.version,
            sent_version=shown.sent_version,
            note=shown.note,
            by=shown.by,
            at=shown.at,
            unanswered=len(shown.unanswered),
            clauses=[
                schemas.MarkedClauseRead.model_validate(clause) for clause in redlines.marked(session, contract, shown)
            ],
        )
        if shown
        else None,
        may_answer=is_last_open
        and shown is rounds[-1]
        and contract.state is ContractState.DRAFT
        and party_of(actor, contract) is Party.STUDIO,
    )


@router.get("/contracts/{contract_id}/redlines", responses=problems(ContractNotFound, TooManyAtOnce))
def read_redlines(
    contract_id: UUID,
    session: DbSession,
    round_number: Annotated[int | None, Query(alias="round", ge=1, le=2**31 - 1)] = None,
    actor: Actor = allows(Audience.PROJECT),
) -> schemas.RedlinesRead:
    """Return a round of redlines in the text that it is about, with the answers so far; the last one by default."""
    with MARKED.of(actor.person):
        return _read(session, actor, contract_id, round_number)


@router.post(
    "/contracts/{contract_id}/redlines",
    status_code=201,
    responses=problems(ContractNotFound, NotYourContract, WrongState, TextChanged, BadRedlines, TooManyAtOnce),
)
@accepts_body(LARGE_BODY_BYTES)
def propose_redlines(
    contract_id: UUID, body: schemas.RedlinesAdd, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> schemas.RedlinesRead:
    """Send a contract back to the studio with changes of its clauses."""
    with MARKED.of(actor.person):
        changes = _changes(body.changes)
        redlines.propose(session, actor, contract_id, version=body.version, changes=changes, note=body.note)
        return _read(session, actor, contract_id)


@router.post(
    "/contracts/{contract_id}/redline-preview",
    responses=problems(ContractNotFound, NotYourContract, WrongState, TooManyAtOnce),
)
@accepts_body(LARGE_BODY_BYTES)
def preview_redlines(
    contract_id: UUID, body: schemas.RedlinesSet, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> schemas.RedlinesPreview:
    """Return the text as changes would mark it; nothing is saved."""
    with PREVIEWS.of(actor.person):
        marked, draft_problems = redlines.preview(session, actor, contract_id, _changes(body.changes))
        return schemas.RedlinesPreview(
            clauses=[schemas.MarkedClauseRead.model_validate(clause) for clause in marked],
            problems=[DraftProblem.model_validate(each) for each in draft_problems],
        )


async def _word_text(contract_id: UUID, body: schemas.WordFile, request: Request) -> WordText:
    plain = await parse_request(
        request,
        parse_word_file,
        body.content_base64,
        refusal=BadWordFile,
        permit=redlines.ensure_may_propose,
        whose=contract_id,
    )
    return WordText.of(plain)


@router.post(
    "/contracts/{contract_id}/redlines/word",
    responses=problems(
        ContractNotFound,
        NotYourContract,
        WrongState,
        BadWordFile,
        OtherContractsFile,
        TooManyAtOnce,
        ParsingBusy,
    ),
)
@accepts_body(LARGE_BODY_BYTES)
def read_word_redlines(
    contract_id: UUID,
    actor: Annotated[Actor, allows(Audience.DESIGNER)],
    word: Annotated[WordText, Depends(_word_text)],
    session: DbSession,
) -> schemas.WordChangesRead:
    """Return the changes of a Word document to a contract, clause by clause; nothing is saved or sent."""
    with MARKED.of(actor.person):
        read = redlines.changes_of_word_file(session, actor, contract_id, word)
        return schemas.WordChangesRead(
            version=read.version,
            changes=[
                schemas.ReadChangeRead(
                    kind=change.kind,
                    clause_key=change.clause_key,
                    after_key=change.after_key,
                    title=change.wording.title,
                    text=change.wording.text,
                    terms=change.wording.terms,
                    comment=change.comment,
                )
                for change in read.changes
            ],
            note=read.note,
            findings=[schemas.WordFindingRead.model_validate(finding) for finding in read.findings],
        )


@router.post(
    "/contracts/{contract_id}/redlines/{redline_number}/answer",
    responses=problems(ContractNotFound, ProducerNeeded, WrongState, RedlineNotFound, BadRedlines, TooManyAtOnce),
)
@accepts_body(LARGE_BODY_BYTES)
def answer_redline(
    contract_id: UUID,
    redline_number: RedlineNumber,
    body: schemas.RedlineAnswerAdd,
    session: DbSession,
    actor: Actor = allows(Audience.PRODUCER),
) -> schemas.RedlinesRead:
    """Accept, refuse or counter a redline; the last answer before the next version is sent counts."""
    with MARKED.of(actor.person):
        redlines.answer(
            session,
            actor,
            contract_id,
            redline_number,
            kind=body.answer,
            wording=_wording(body),
            comment=body.comment,
        )
        return _read(session, actor, contract_id)
