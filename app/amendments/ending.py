"""Ending an agreed contract: notice, a statement that both see, and its settlement in one step."""

from dataclasses import asdict
from datetime import date, datetime
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.agreements.access import party_of, visible_contract
from app.agreements.clauses.terms import MoneyTerms, PriceMode
from app.agreements.drafts import lifecycle
from app.agreements.drafts.documents import TextPdf, sha256_of
from app.agreements.errors import NotYourContract
from app.agreements.models import Contract
from app.agreements.plan import queries as plan_queries
from app.agreements.plan.queries import terms_of
from app.agreements.queries import NOTICE_GIVEN, NOTICE_WITHDRAWN, lock_contract
from app.agreements.record import service as record
from app.agreements.rules import ORDERS, ContractState, Party, next_action_hint
from app.agreements.signing.certificates import signatures_page, studio_zone
from app.agreements.signing.service import SignatureRequest
from app.amendments import queries, schemas
from app.amendments.change_orders import lapse_open
from app.amendments.ending_text import statement_text, statement_title
from app.amendments.errors import AlreadyEnded, NoNotice, NoticeGiven
from app.amendments.models import Notice
from app.amendments.rules import end_of_notice, is_over
from app.amendments.signing import locked_for_party, sign, signatures
from app.amendments.work import work_states
from app.core import clock
from app.core.events import publish
from app.core.money import money
from app.core.plural import day_in_words
from app.money import overview
from app.money import queries as money_queries
from app.money.ledger.book import price_of_round
from app.money.ledger.service import cue_label, load_ledger_book
from app.money.schemas import FiguresRead
from app.money.settlement import end_statement, open_cues, settle_end
from app.money.work.service import price_of


def ending(session: Session, actor: Actor, contract_id: UUID) -> schemas.EndingRead:
    """Return the outcome of a contract's early end, as it stands now or as it was settled."""
    return _read(session, visible_contract(session, actor, contract_id), actor)


def give_notice(session: Session, actor: Actor, contract_id: UUID, *, reason: str, ends_on: date | None = None) -> None:
    """Give notice for the caller's party; from then on both see the statement."""
    contract, party = locked_for_party(session, actor, contract_id)
    _ensure_unsettled(session, contract)
    standing = queries.standing_notice(session, contract.id)
    if standing is not None:
        raise NoticeGiven(
            f"{standing.giver.name} gave notice on {day_in_words(standing.given_at.date())}",
            fix="agree to its statement; who gave the notice can withdraw it",
        )
    is_agreed = contract.state is ContractState.AGREED
    notice_days = terms_of(session, contract).notice_days if is_agreed else None
    last_day = end_of_notice(clock.now().date(), notice_days, ends_on)
    notice = Notice(
        studio_id=contract.studio_id,
        project_id=contract.project_id,
        contract_id=contract.id,
        number=queries.next_notice_number(session, contract.id),
        party=party,
        given_by=actor.person,
        reason=reason,
        ends_on=last_day,
    )
    session.add(notice)
    session.flush()
    facts = {"notice": notice.number, "reason": reason, "ends_on": last_day.isoformat() if last_day else ""}
    record.append(session, contract.id, NOTICE_GIVEN, facts, by=actor.person)
    _publish(session, contract, "contract.notice_given")


def withdraw_notice(session: Session, actor: Actor, contract_id: UUID) -> None:
    """Take a notice back, as the party that gave it, before it takes effect."""
    contract, party = locked_for_party(session, actor, contract_id)
    notice = _open_notice(session, contract)
    if notice.party is not party:
        raise NotYourContract(
            f"only the {notice.party}, who gave the notice, can withdraw it",
            fix="agree to the statement, or wait until the notice is over or withdrawn",
        )
    notice.withdrawn_at = clock.now()
    session.flush()
    record.append(session, contract.id, NOTICE_WITHDRAWN, {"notice": notice.number}, by=actor.person)


def agree_to_statement(
    session: Session,
    actor: Actor,
    contract_id: UUID,
    signature: SignatureRequest,
) -> None:
    """Say yes to the statement for the caller's party; with the last yes the contract is settled and ends."""
    contract, party = locked_for_party(session, actor, contract_id)
    notice = _open_notice(session, contract)
    read = _read(session, contract, actor)
    text = statement_text(read, contract.project.studio.name)
    have_all_signed = sign(
        session,
        actor,
        contract,
        party,
        kind="statement_accepted",
        facts={"notice": notice.number},
        text_sha256=sha256_of(text),
        signature=signature,
    )
    if have_all_signed:
        _settle(session, contract, notice, text, read, by=actor.person)


def settle_if_over(session: Session, contract_id: UUID, today: date) -> None:
    """Settle a contract whose last day has passed, as the server; settling twice is settling once."""
    contract = lock_contract(session, contract_id)
    notice = queries.standing_notice(session, contract_id)
    if notice is None or notice.settled_at is not None or not is_over(notice.ends_on, today):
        return
    read = _read(session, contract, None)
    _settle(session, contract, notice, statement_text(read, contract.project.studio.name), read, by=None)


def _settle(
    session: Session,
    contract: Contract,
    notice: Notice,
    text: str,
    read: schemas.EndingRead,
    *,
    by: UUID | None,
) -> None:
    notice.settled_at, notice.statement, notice.statement_sha256 = clock.now(), text, sha256_of(text)
    session.flush()
    states = work_states(session, contract)
    facts = {
        "notice": notice.number,
        "because": "both agreed to the statement" if by else "the last day of the notice is over",
        "text_sha256_of_amendment": notice.statement_sha256,
        "owed": money(read.figures.accepted_minor, contract.currency),
        "to_pay": money(read.figures.due_minor, contract.currency),
        "cut": {str(cue.cue_id): states[cue.cue_id].value for cue in open_cues(session, contract)},
    }
    record.append(session, contract.id, "settled", facts, by=by)
    lapse_open(session, contract)
    settle_end(session, contract, states, person_id=by or notice.given_by, is_by_server=by is None)
    if contract.state is ContractState.AGREED:
        lifecycle.mark_ended(session, contract, reason=notice.reason)
        record.append(session, contract.id, "ended", {"reason": notice.reason}, by=by)
    _publish(session, contract, "contract.settled")


def statement_pdf(session: Session, actor: Actor, contract_id: UUID) -> TextPdf:
    """Return the statement as PDF, as it took effect or as it stands; raise NoNotice while there is none."""
    contract = visible_contract(session, actor, contract_id)
    notice = queries.standing_notice(session, contract.id)
    if notice is None:
        _ensure_unsettled(session, contract)
        raise NoNotice("no notice was given, so there is no statement yet", fix="give notice first")
    read = _read(session, contract, actor)
    text = notice.statement or statement_text(read, contract.project.studio.name)
    text_sha256 = sha256_of(text)
    given = queries.acceptances_of(session, contract.id, text_sha256)
    return TextPdf.of(statement_title(read), text, signatures_page(given, text_sha256, studio_zone(contract)))


def _ensure_unsettled(session: Session, contract: Contract) -> None:
    if contract.kind not in ORDERS or contract.agreed_at is None:
        is_ended = contract.state is ContractState.ENDED
        raise AlreadyEnded(
            "nothing is owed under this contract, so it needs no settlement",
            fix=next_action_hint(contract.state, contract.kind) if is_ended else "end it on the contract's page",
        )
    is_open = any(cue.accepted_at is None and cue.cut_at is None for cue in plan_queries.cues_of(session, contract.id))
    if contract.state is ContractState.ENDED and not is_open:
        raise AlreadyEnded(
            "this contract has ended and is settled", fix=next_action_hint(contract.state, contract.kind)
        )


def _open_notice(session: Session, contract: Contract) -> Notice:
    notice = queries.standing_notice(session, contract.id)
    if notice is None:
        _ensure_unsettled(session, contract)
        raise NoNotice("no notice is in effect", fix="give notice; the statement is made from it")
    if notice.settled_at is not None:
        raise AlreadyEnded(
            "the notice took effect, and this contract is settled", fix="this is final: read the statement on its page"
        )
    return notice


def _publish(session: Session, contract: Contract, event: str) -> None:
    publish(session, event, studio_id=contract.studio_id, contract_id=contract.id)


def _read(session: Session, contract: Contract, actor: Actor | None) -> schemas.EndingRead:
    """Return the ending as one party sees it; `actor` None: as the server does."""
    terms = terms_of(session, contract)
    notice = queries.standing_notice(session, contract.id)
    is_settled = notice is not None and notice.settled_at is not None
    states = work_states(session, contract)
    statement = end_statement(session, contract, states)
    milestones = {milestone.id: milestone.name for milestone in plan_queries.milestones_of(session, contract.id)}
    covered = {cue.cue_id: cue for cue in plan_queries.cues_of(session, contract.id)}
    prefix = contract.project.cue_prefix
    party = party_of(actor, contract) if actor else None
    now = load_ledger_book(session, contract)
    read = schemas.EndingRead(
        project_id=contract.project_id,
        contract_id=contract.id,
        title=contract.title,
        designer=PersonBrief(id=contract.designer_id, name=contract.designer.name),
        currency=contract.currency,
        my_party=party,
        state="settled" if is_settled else "notice" if notice else "forecast",
        notice=_notice_read(notice) if notice else None,
        notice_days=terms.notice_days,
        earliest_ends_on=end_of_notice(clock.now().date(), terms.notice_days, None),
        deposit_at_end=terms.deposit_at_end,
        cues=[
            schemas.StatedCueRead(
                cue=overview.brief(covered[cue.cue_id].cue, prefix),
                milestone=milestones[cue.milestone_id],
                state=cue.state,
                was_cut=cue.was_cut and not _was_cut_by(notice, covered[cue.cue_id].cut_at),
                price_minor=cue.price_minor,
                part_bp=cue.part_bp,
                owed_minor=cue.owed_minor,
                clause=cue.clause,
            )
            for cue in statement.cues
        ],
        cues_minor=statement.cues_minor,
        deposit_minor=statement.deposit_minor,
        rounds_minor=statement.rounds_minor,
        extra_minor=statement.extra_minor,
        days_minor=statement.days_minor,
        hours_minor=statement.hours_minor,
        retainer_minor=statement.retainer_minor,
        due_now_minor=overview.figures(session, contract, now).due_minor,
        figures=FiguresRead(**asdict(statement.figures)),
        open_points=_open_points(session, contract, terms),
        statement_sha256=notice.statement_sha256 if notice else None,
        settled_at=notice.settled_at if notice else None,
        signed=[],
        signatures_needed=2,
        may=_may(contract, notice, party),
    )
    if notice is not None and not is_settled:
        read.statement_sha256 = sha256_of(statement_text(read, contract.project.studio.name))
    if read.statement_sha256 is not None:
        given = queries.acceptances_of(session, contract.id, read.statement_sha256)
        read.signed = [schemas.SignedRead.model_validate(signature) for signature in given]
        standing = signatures(session, contract, given, actor.person_id if actor else None, party)
        read.signatures_needed = standing.needed
        read.may.agree &= standing.is_my_turn
    return read


def _was_cut_by(notice: Notice | None, cut_at: datetime | None) -> bool:
    """Whether the settlement itself counted a cue as cut."""
    return bool(notice and notice.settled_at and cut_at and cut_at >= notice.settled_at)


def _notice_read(notice: Notice) -> schemas.NoticeRead:
    return schemas.NoticeRead(
        number=notice.number,
        party=notice.party,
        given_by=notice.giver.name,
        given_at=notice.given_at,
        reason=notice.reason,
        ends_on=notice.ends_on,
    )


def _open_points(session: Session, contract: Contract, terms: MoneyTerms) -> list[schemas.OpenPointRead]:
    """Return rounds and days that wait for the studio to agree to them."""
    prefix = contract.project.cue_prefix
    cues = overview.priced_by_cue(session, contract)
    rounds = [
        schemas.OpenPointRead(
            kind="round",
            text=f"round {extra_round.number} of {cue_label(extra_round.cue, prefix)}",
            amount_minor=price_of_round(cues[extra_round.cue_id], terms.extra_round_bp),
        )
        for extra_round in money_queries.extra_rounds_of(session, contract.id)
        if extra_round.agreed_at is None and extra_round.dropped_at is None
    ]
    by_day = terms.price_mode is PriceMode.DAY_RATE
    days = [
        schemas.OpenPointRead(
            kind="day",
            text=f"work on {day_in_words(day.worked_on)}",
            amount_minor=price_of(day.quarters, terms.day_rate_minor),
        )
        for day in (money_queries.worked_days_of(session, contract.id) if by_day else ())
        if day.quarters and day.agreed_at is None and day.refused_at is None
    ]
    return rounds + days


def _may(contract: Contract, notice: Notice | None, party: Party | None) -> schemas.EndingMay:
    is_open = notice is not None and notice.settled_at is None
    can_be_given = notice is None and contract.kind in ORDERS and contract.agreed_at is not None
    return schemas.EndingMay(
        give_notice=party is not None and can_be_given and contract.state is ContractState.AGREED,
        withdraw=notice is not None and is_open and notice.party is party,
        agree=party is not None and is_open,
    )
