"""The endpoints of contracts."""

import json
from collections.abc import Mapping, Sequence
from typing import Annotated, Any
from uuid import UUID

from fastapi import APIRouter, Depends, Request
from starlette.concurrency import run_in_threadpool

from app.accounts.rules import Actor, Audience
from app.accounts.schemas import PersonBrief
from app.accounts.web.policies import allows
from app.agreements import queries, schemas
from app.agreements.access import party_of, visible_contract
from app.agreements.clauses.template_endpoints import clauses_of
from app.agreements.drafts import lifecycle, versions
from app.agreements.drafts.documents import TextPdf
from app.agreements.drafts.previous_contract import last_contract
from app.agreements.drafts.version_endpoints import blocks_read, version_read
from app.agreements.errors import (
    AmountsNeeded,
    BadDraft,
    BadSplit,
    BriefOpen,
    ContractNotFound,
    DraftChanged,
    FrameworkNeeded,
    NoContractNeeded,
    NotASigner,
    NoticeNeeded,
    NotYourContract,
    NotYourTurn,
    RedlinesOpen,
    TemplateNotFound,
    TooManySigners,
    WrongState,
)
from app.agreements.joint import service as joint
from app.agreements.joint.parts import parts_of
from app.agreements.joint.rules import Share
from app.agreements.models import Contract, ContractEvent, ContractVersion
from app.agreements.redlines import service as redlines
from app.agreements.redlines.rules import TURNS
from app.agreements.rules import ORDERS, ContractKind, ContractState, Party
from app.agreements.signing import service as signing
from app.agreements.signing.endpoints import SIGNING, signature_sent
from app.core.typesetting import DocumentTooLarge, TypesettingBusy
from app.core.web.bodies import LARGE_BODY_BYTES, accepts_body
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.projects.errors import EngagementNotFound, ProducerNeeded, ProjectNotFound, TeamNeeded

router = APIRouter(prefix="/v1", tags=["contracts"])


def _waits_for(contract: Contract, to_sign: Sequence[Party]) -> list[Party]:
    if contract.state is ContractState.DRAFT:
        return [Party.STUDIO]
    return list(to_sign) if contract.state is ContractState.SENT else []


def _brief(
    contract: Contract, actor: Actor, to_sign: Sequence[Party], notices: Mapping[UUID, ContractEvent]
) -> dict[str, Any]:
    same = {
        name: getattr(contract, name)
        for name in schemas.ContractBrief.model_fields
        if name not in ("designer", "my_party", "waits_for", "notice")
    }
    return same | {
        "designer": PersonBrief.model_validate(contract.designer),
        "my_party": party_of(actor, contract),
        "waits_for": _waits_for(contract, to_sign),
        "notice": _notice(notices[contract.id])
        if contract.id in notices and contract.state is ContractState.AGREED
        else None,
    }


def _notice(entry: ContractEvent) -> schemas.NoticeBrief:
    return schemas.NoticeBrief(given_at=entry.at, ends_on=json.loads(entry.payload)["ends_on"] or None)


def _contract(session: DbSession, actor: Actor, contract: Contract) -> schemas.ContractRead:
    seen = versions.visible_versions(session, actor, contract)
    shown, is_team = seen[0], bool(actor.roles_in(contract.studio_id))
    acceptances = queries.acceptances_of(session, shown.id) if contract.state is not ContractState.DRAFT else []
    order = signing.order_of(session, contract)
    party, state = party_of(actor, contract), contract.state
    is_draft, is_sent = state is ContractState.DRAFT, state is ContractState.SENT
    is_running = state is ContractState.AGREED and contract.kind in ORDERS
    asked = queries.newest_event_of(session, contract.id, TURNS) if is_draft else None
    change = json.loads(asked.payload) if asked and asked.kind == "change_requested" else None
    return schemas.ContractRead(
        **_brief(
            contract,
            actor,
            order.parties_left(signing.yeses(acceptances)),
            queries.notices_in_effect(session, [contract.id]),
        ),
        studio_name=contract.project.studio.name,
        version=version_read(shown, is_team=is_team),
        acceptances=[schemas.AcceptanceRead.model_validate(acceptance) for acceptance in acceptances],
        signers=[PersonBrief.model_validate(signer.person) for signer in queries.signers_of(session, contract.id)],
        signs_first=contract.signs_first,
        change_requested=schemas.ContractChangeRead(
            text=change["text"], clause=change["clause"], by=change["by"], at=asked.at
        )
        if asked and change
        else None,
        redlines=_redlines(session, contract),
        joint=_joint(session, contract, is_team=is_team),
        signature_time=_signature_time(session, contract, seen),
        may=schemas.MayRead(
            change=is_draft and party is Party.STUDIO,
            send=is_draft and party is Party.STUDIO,
            recall=is_sent and party is Party.STUDIO,
            request_change=is_sent and party is Party.DESIGNER,
            accept=signing.may_sign(session, actor, contract, acceptances),
            end=party is not None and state is not ContractState.ENDED and not is_running,
            amend=party is not None and is_running,
        ),
    )


def _redlines(session: DbSession, contract: Contract) -> schemas.ContractRedlines | None:
    rounds = redlines.rounds(session, contract)
    if not rounds:
        return None
    last = rounds[-1]
    return schemas.ContractRedlines(
        rounds=len(rounds),
        count=len(last.redlines),
        unanswered=len(last.unanswered),
        is_open=last.sent_version is None,
        by=last.by,
        at=last.at,
    )


def _joint(session: DbSession, contract: Contract, *, is_team: bool) -> list[schemas.JointPart]:
    if contract.state is ContractState.DRAFT and not is_team:
        return []
    return [
        schemas.JointPart(
            contract_id=part.contract.id if is_team or part.contract is contract else None,
            designer=PersonBrief.model_validate(part.contract.designer),
            is_own=part.contract is contract,
            cues=len(part.cues),
            amount_minor=part.amount_minor,
            currency=part.currency,
            share=part.share,
        )
        for part in parts_of(session, contract)
    ]


def _signature_time(
    session: DbSession, contract: Contract, seen: Sequence[ContractVersion]
) -> schemas.SignatureTime | None:
    first_sent_at = min((version.sent_at for version in seen if version.sent_at), default=None)
    if first_sent_at is None:
        return None
    is_awaited = contract.state in (ContractState.DRAFT, ContractState.SENT)
    turn = queries.newest_event_of(session, contract.id, (*TURNS, "accepted_by")) if is_awaited else None
    return schemas.SignatureTime(first_sent_at=first_sent_at, waits_since=turn.at if turn else None)


def _draft(body: schemas.DraftChange) -> lifecycle.Draft:
    return lifecycle.Draft(
        title=body.title,
        clauses=clauses_of(body.clauses),
        terms=body.terms,
        currency=body.currency,
        release_clause=body.release_clause,
        holdback_bp=body.holdback_bp,
    )


@router.get(
    "/projects/{project_id}/contracts",
    response_model=list[schemas.ContractBrief],
    responses=problems(ProjectNotFound, TeamNeeded),
)
def list_contracts(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> list[schemas.ContractBrief]:
    """Return the project's contracts, the oldest first; a designer sees their own, once they were sent."""
    contracts = lifecycle.contracts_of(session, actor, project_id)
    to_sign = queries.turns_to_sign(session, contracts)
    notices = queries.notices_in_effect(session, [contract.id for contract in contracts])
    return [
        schemas.ContractBrief(**_brief(contract, actor, to_sign[contract.id].parties, notices))
        for contract in contracts
    ]


@router.post(
    "/projects/{project_id}/contracts",
    status_code=201,
    responses=problems(
        ProjectNotFound,
        ProducerNeeded,
        EngagementNotFound,
        NoContractNeeded,
        FrameworkNeeded,
        TemplateNotFound,
        ContractNotFound,
    ),
)
def create_contract(
    project_id: UUID, body: schemas.ContractAdd, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.ContractRead:
    """Begin a draft with one designer, from the library or a template of the studio."""
    contract = lifecycle.create_contract(
        session,
        actor,
        project_id,
        engagement_id=body.engagement_id,
        kind=body.kind,
        title=body.title,
        currency=body.currency,
        template_id=body.template_id,
        framework_id=body.framework_id,
        same_as_id=body.same_as_id,
        with_music=body.with_music,
    )
    return _contract(session, actor, contract)


@router.get(
    "/projects/{project_id}/last-contract", responses=problems(ProjectNotFound, ProducerNeeded, EngagementNotFound)
)
def read_last_contract(
    project_id: UUID,
    engagement_id: UUID,
    session: DbSession,
    kind: ContractKind = ContractKind.SINGLE,
    actor: Actor = allows(Audience.PRODUCER),
) -> schemas.LastContractRead:
    """Return the contract that a new one can begin like: the last with this designer, else the studio's last."""
    last = last_contract(session, actor, project_id, engagement_id=engagement_id, kind=kind)
    return schemas.LastContractRead(contract=schemas.LastContract.model_validate(last) if last else None)


@router.get("/contracts/{contract_id}", responses=problems(ContractNotFound))
def read_contract(
    contract_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> schemas.ContractRead:
    """Return a contract with its newest text; the designer reads what was sent."""
    return _contract(session, actor, visible_contract(session, actor, contract_id))


@router.put(
    "/contracts/{contract_id}/draft",
    responses=problems(ContractNotFound, ProducerNeeded, WrongState, DraftChanged, BadDraft, AmountsNeeded),
)
@accepts_body(LARGE_BODY_BYTES)
def save_contract_draft(
    contract_id: UUID, body: schemas.DraftSave, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.ContractRead:
    """Save the draft as its next version."""
    amounts = None if body.amounts is None else {entry.milestone_id: entry.amount_minor for entry in body.amounts}
    lifecycle.save_draft(
        session,
        actor,
        contract_id,
        _draft(body),
        based_on_version=body.based_on_version,
        note=body.note,
        amounts=amounts,
    )
    return _contract(session, actor, visible_contract(session, actor, contract_id))


@router.post(
    "/contracts/{contract_id}/preview",
    responses=problems(ContractNotFound, ProducerNeeded),
)
@accepts_body(LARGE_BODY_BYTES)
def preview_contract(
    contract_id: UUID, body: schemas.DraftChange, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.DraftPreview:
    """Return the text that a draft would have; nothing is saved."""
    blocks, clauses, problems = lifecycle.preview(session, actor, contract_id, _draft(body))
    return schemas.DraftPreview(
        blocks=blocks_read(blocks),
        clauses=[schemas.PreviewedClauseRead.model_validate(clause) for clause in clauses],
        problems=[schemas.DraftProblem.model_validate(problem) for problem in problems],
    )


async def _pdfs_to_send(request: Request, contract_id: UUID) -> dict[UUID, TextPdf]:
    database = request.app.state.runtime.database
    return await run_in_threadpool(lifecycle.pdfs_to_send, database, request.state.actor, contract_id)


@router.post(
    "/contracts/{contract_id}/send",
    responses=problems(
        ContractNotFound,
        BadDraft,
        BriefOpen,
        DocumentTooLarge,
        DraftChanged,
        ProducerNeeded,
        RedlinesOpen,
        TypesettingBusy,
        WrongState,
    ),
)
def send_contract(
    contract_id: UUID,
    body: schemas.SendAdd,
    runtime: CurrentRuntime,
    actor: Annotated[Actor, allows(Audience.PRODUCER)],
    pdfs: Annotated[dict[UUID, TextPdf], Depends(_pdfs_to_send)],
    session: DbSession,
) -> schemas.ContractRead:
    """Put the text before both parties as PDF, with the open questions of this moment.

    The two contracts of joint work are sent together.
    """
    lifecycle.send(session, runtime.store, actor, contract_id, pdfs=pdfs, note=body.note)
    return _contract(session, actor, visible_contract(session, actor, contract_id))


@router.post(
    "/contracts/{contract_id}/joint",
    status_code=201,
    responses=problems(ContractNotFound, ProducerNeeded, EngagementNotFound, NoContractNeeded, WrongState, BadSplit),
)
def divide_contract(
    contract_id: UUID, body: schemas.JointAdd, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.ContractRead:
    """Divide a draft between its designer and a second one, who makes some of its cues for a share of its price."""
    contract = joint.divide_contract(
        session,
        actor,
        contract_id,
        engagement_id=body.engagement_id,
        cue_ids=body.cue_ids,
        share=Share(body.share_bp, body.share_minor),
    )
    return _contract(session, actor, contract)


@router.put(
    "/contracts/{contract_id}/joint", responses=problems(ContractNotFound, ProducerNeeded, WrongState, BadSplit)
)
def split_price(
    contract_id: UUID, body: schemas.ShareSet, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.ContractRead:
    """Give the designer of a draft another share of the price of joint work; the sum of both stays as it is."""
    contract = joint.split_price(session, actor, contract_id, Share(body.share_bp, body.share_minor))
    return _contract(session, actor, contract)


@router.post("/contracts/{contract_id}/recall", responses=problems(ContractNotFound, ProducerNeeded, WrongState))
def recall_contract(
    contract_id: UUID, body: schemas.RecallAdd, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.ContractRead:
    """Make a sent contract a draft again."""
    lifecycle.recall(session, actor, contract_id, reason=body.reason)
    return _contract(session, actor, visible_contract(session, actor, contract_id))


@router.post("/contracts/{contract_id}/ask-change", responses=problems(ContractNotFound, NotYourContract, WrongState))
def request_contract_change(
    contract_id: UUID, body: schemas.ContractChangeAdd, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> schemas.ContractRead:
    """Send a contract back to the studio with what its designer wants otherwise."""
    lifecycle.request_change(session, actor, contract_id, text=body.text, clause_key=body.clause_key)
    return _contract(session, actor, visible_contract(session, actor, contract_id))


@router.put(
    "/contracts/{contract_id}/signers",
    responses=problems(ContractNotFound, ProducerNeeded, WrongState, NotASigner, TooManySigners),
)
def set_contract_signers(
    contract_id: UUID, body: schemas.SignersSet, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.ContractRead:
    """Name the producers who sign a draft for the studio, in order, and which party signs first."""
    signing.set_signers(session, actor, contract_id, person_ids=body.person_ids, first=body.first)
    return _contract(session, actor, visible_contract(session, actor, contract_id))


@router.post(
    "/contracts/{contract_id}/accept",
    responses=problems(ContractNotFound, NotYourContract, WrongState, BadDraft, NotASigner, NotYourTurn, *SIGNING),
)
def accept_contract(
    contract_id: UUID,
    actor: Annotated[Actor, allows(Audience.PROJECT)],
    signature: Annotated[signing.SignatureRequest, Depends(signature_sent)],
    session: DbSession,
) -> schemas.ContractRead:
    """Sign the text that was sent, for the caller's party; once all have signed, it is agreed."""
    signing.accept(session, actor, contract_id, signature)
    return _contract(session, actor, visible_contract(session, actor, contract_id))


@router.post(
    "/contracts/{contract_id}/end", responses=problems(ContractNotFound, NotYourContract, WrongState, NoticeNeeded)
)
def end_contract(
    contract_id: UUID, body: schemas.EndAdd, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> schemas.ContractRead:
    """End a contract that orders no work, or give up a draft."""
    lifecycle.end(session, actor, contract_id, reason=body.reason)
    return _contract(session, actor, visible_contract(session, actor, contract_id))
