"""Redlines of a contract that was sent: proposed by its designer, answered by the studio, kept in the record alone."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.rules import Actor
from app.agreements import queries
from app.agreements.access import contract_to_change, party_of, visible_contract
from app.agreements.clauses import rules as clause_rules
from app.agreements.clauses.facts import facts_of
from app.agreements.clauses.rules import Clause, Terms, terms_in_force
from app.agreements.clauses.text_faults import text_faults
from app.agreements.drafts.versions import add_version, newest_of
from app.agreements.errors import (
    BadRedlines,
    ContractVersionNotFound,
    NotYourContract,
    OtherContractsFile,
    RedlineNotFound,
    RedlinesOpen,
    TextChanged,
)
from app.agreements.joint.states import take_back_other
from app.agreements.models import Contract, ContractVersion
from app.agreements.record import service as record
from app.agreements.redlines.marks import MarkedClause, clauses_as_sent, marked_clauses
from app.agreements.redlines.rules import (
    ANSWERED,
    PROPOSED,
    SENT,
    Answer,
    Change,
    Redline,
    RedlineAnswerKind,
    Round,
    Text,
    Wording,
    answered_draft,
    change_errors,
    is_in,
    named_in_words,
    numbered,
    proposed_figure_errors,
    rounds_of,
    with_fields_put_back,
    wording_errors,
    wording_with_fields,
)
from app.agreements.rules import ContractKind, ContractState, Party, ensure_state, next_action_hint
from app.agreements.word.file import WordText
from app.agreements.word.reading import MadeFrom, ReadChanges, changes_in
from app.core import clock
from app.core.errors import FieldProblem
from app.core.events import publish
from app.core.plural import counted, verb


def rounds(session: Session, contract: Contract) -> list[Round]:
    """Return the rounds of redlines in the record of a contract, in order."""
    events = queries.events_of_kinds(session, contract.id, (PROPOSED, ANSWERED, SENT))
    return rounds_of((event.kind, event.at, json.loads(event.payload)) for event in events)


def texts_of(session: Session, contract: Contract) -> Mapping[int, Text]:
    """Return clauses and terms of every version of a contract by its number."""
    return {version.number: text_of(version) for version in queries.versions_of(session, contract.id)}


def text_of(version: ContractVersion) -> Text:
    """Return clauses and terms of a version."""
    return [Clause.of(row) for row in version.clauses], version.terms


def propose(
    session: Session, actor: Actor, contract_id: UUID, *, version: int, changes: Sequence[Change], note: str
) -> None:
    """Send a contract back to the studio with changes of its clauses, as its designer wants them.

    Raises NotYourContract for all but its designer, TextChanged for another version than the current one, and
    BadRedlines for changes that a draft could not have either.
    """
    contract = _to_propose(session, actor, contract_id)
    contract = queries.lock_together(session, contract)
    sent = _sent_version(session, contract)
    if sent.number != version:
        raise TextChanged(
            f"version {sent.number} is the newest, and these changes are of version {version}; nothing was sent",
            fix="reload the page and read what changed; what you wrote is kept",
        )
    clauses, terms = text_of(sent)
    changes = with_fields_put_back(changes, clauses, terms, contract.currency)
    if problems := _problems(changes, clauses, terms, contract.kind):
        raise BadRedlines(f"nothing was sent; {problems[0]['message']}", errors=problems)
    earlier = rounds(session, contract)
    first = sum(len(round_.redlines) for round_ in earlier) + 1
    redlines = numbered(changes, first)
    contract.state = ContractState.DRAFT
    facts = {"round": len(earlier) + 1, "note": note, "redlines": [redline.as_facts() for redline in redlines]}
    record.append_by(session, actor, contract, PROPOSED, sent, **facts)
    take_back_other(session, actor, contract)
    words = named_in_words(redlines, clauses)
    text = f"{words}. {note}" if note else f"{words}."
    publish(session, "contract.change_requested", studio_id=contract.studio_id, contract_id=contract.id, text=text)


def preview(
    session: Session, actor: Actor, contract_id: UUID, changes: Sequence[Change]
) -> tuple[list[MarkedClause], list[FieldProblem]]:
    """Return the text as changes would mark it, and what is wrong with them; nothing is saved."""
    contract = _to_propose(session, actor, contract_id)
    sent = _sent_version(session, contract)
    clauses, terms = text_of(sent)
    changes = with_fields_put_back(changes, clauses, terms, contract.currency)
    problems = _problems(changes, clauses, terms, contract.kind)
    broken = {problem["where"] for problem in problems}
    whole = [change for index, change in enumerate(changes) if f"changes.{index}" not in broken]
    return _marked(session, contract, sent, numbered(whole, 1)), problems


def ensure_may_propose(session: Session, actor: Actor, contract_id: UUID) -> None:
    """Raise unless the caller is the designer of a contract that needs their signature."""
    _sent_version(session, _to_propose(session, actor, contract_id))


def changes_of_word_file(session: Session, actor: Actor, contract_id: UUID, word: WordText) -> ReadChanges:
    """Return the changes of a Word document to the version that it was made from; nothing is saved or sent.

    Raises OtherContractsFile for a document of another contract, or of a version that its designer does not see.
    """
    contract = _to_propose(session, actor, contract_id)
    sent = _sent_version(session, contract)
    if word.origin is not None and word.origin.contract_id != str(contract.id):
        raise OtherContractsFile(
            "the file was made from another contract",
            fix="upload it at the contract that it belongs to, or download this one as a Word document",
        )
    number = word.origin.version if word.origin else sent.number
    made_from = queries.version_by_number(session, contract.id, number)
    if made_from is None or made_from.sent_at is None:
        raise OtherContractsFile(
            f"the file says that it was made from version {number}, and no such version was sent",
            fix="download the current version as a Word document, and make the changes in that file",
        )
    clauses, terms = text_of(made_from)
    facts = facts_of(session, contract, terms_in_force(clauses, terms))
    fill = clause_rules.filler(terms, facts, contract.currency)
    return changes_in(
        word, MadeFrom(number, (clauses, terms), made_from.text, fill, contract.currency), _as_in(made_from, sent)
    )


def _as_in(made_from: ContractVersion, sent: ContractVersion) -> set[str]:
    """Return the keys of the clauses that read the same in both versions."""
    before = clauses_as_sent(made_from.text, text_of(made_from)[0])
    now = clauses_as_sent(sent.text, text_of(sent)[0])
    unchanged = set(map(Clause.of, made_from.clauses)) & set(map(Clause.of, sent.clauses))
    keys = {clause.key for clause in unchanged if clause.stands}
    return {key for key in keys if before.get(key, "").strip() == now.get(key, "").strip()}


def answer(
    session: Session,
    actor: Actor,
    contract_id: UUID,
    number: int,
    *,
    kind: RedlineAnswerKind,
    wording: Wording,
    comment: str,
) -> None:
    """Answer a redline for the studio: what is accepted or countered is in the draft from now on, word for word.

    A redline can be answered again until the next version is sent; the last answer counts. Raises RedlineNotFound for a
    number that does not wait for that version, and BadRedlines for an answer that the draft could not have.
    """
    contract = contract_to_change(session, actor, contract_id)
    ensure_state(contract.state, {ContractState.DRAFT}, next_action_hint(contract.state, contract.kind))
    rounds_sent = rounds(session, contract)
    redline = (
        next((candidate for candidate in rounds_sent[-1].redlines if candidate.number == number), None)
        if rounds_sent
        else None
    )
    if redline is None or rounds_sent[-1].sent_version is not None:
        raise RedlineNotFound(f"no redline {number} of this contract waits for an answer")
    base = _base(session, contract, rounds_sent[-1])
    is_counter = kind is RedlineAnswerKind.COUNTERED
    before = next((clause.text for clause in base[0] if clause.key == redline.clause_key), redline.wording.text)
    wording = wording_with_fields(wording, before, base[1], contract.currency)
    if fault := _fault_of_answer(redline, kind, wording, comment, base):
        raise BadRedlines(f"nothing was saved; {fault}", errors=[FieldProblem(where="answer", message=fault)])
    person = session.get_one(Person, actor.person)
    answered = replace(redline, answer=Answer(kind, wording if is_counter else None, comment, person.name, clock.now()))
    draft = text_of(newest_of(session, contract))
    clauses, terms = answered_draft(draft, base, rounds_sent[-1], answered)
    faults_before = text_faults(session, contract, *draft, holdback_bp=contract.holdback_bp)
    now = text_faults(session, contract, clauses, terms, holdback_bp=contract.holdback_bp)
    if faults := [fault for fault in now if fault not in faults_before]:
        raise BadRedlines(
            f"nothing was saved; the draft would not be whole: {faults[0]['message']}",
            errors=faults,
            fix="counter with a text that keeps it, or change the draft first",
        )
    if (clauses, terms) != (list(draft[0]), draft[1]):
        title = answered.wording.title or next(clause.title for clause in base[0] if clause.key == answered.clause_key)
        add_version(session, actor, contract, clauses, terms, note=f"Redline {number} {kind.value}: {title}")
    facts = (wording if is_counter else Wording()).as_facts() | {"comment": comment}
    record.append_by(session, actor, contract, ANSWERED, redline=number, answer=kind.value, **facts)


def _fault_of_answer(
    redline: Redline, kind: RedlineAnswerKind, wording: Wording, comment: str, base: Text
) -> str | None:
    if kind is RedlineAnswerKind.REFUSED and not comment:
        return "say why it is refused"
    if kind is not RedlineAnswerKind.COUNTERED:
        return None
    if wording == redline.wording:
        return "this is what was proposed; accept it"
    return next(wording_errors(wording, base[1]), None)


def ensure_answered(session: Session, contract: Contract, text: Text) -> None:
    """Raise RedlinesOpen unless every redline is answered and a text has what was agreed, word for word."""
    rounds_sent = rounds(session, contract)
    if not rounds_sent or rounds_sent[-1].sent_version is not None:
        return
    if unanswered := rounds_sent[-1].unanswered:
        subject = f"{counted(len(unanswered), 'proposed change')} {verb(len(unanswered), 'has', 'have')}"
        raise RedlinesOpen(f"{subject} no answer yet", fix="accept, refuse or counter each on the page Redlines")
    base = _base(session, contract, rounds_sent[-1])
    for redline in rounds_sent[-1].redlines:
        if not is_in(redline, text, base[0]) and redline.answer is not None:
            raise RedlinesOpen(
                f"redline {redline.number} was {redline.answer.kind.value}, and the draft has other words there now",
                fix="answer it again on the page Redlines: its words are put back, or yours are a counter",
            )


def marked(session: Session, contract: Contract, round_: Round) -> list[MarkedClause]:
    """Return the text that a round is about, clause by clause, with what is proposed and countered as marks."""
    return _marked(session, contract, _base_version(session, contract, round_), round_.redlines)


def _base(session: Session, contract: Contract, round_: Round) -> Text:
    return text_of(_base_version(session, contract, round_))


def _base_version(session: Session, contract: Contract, round_: Round) -> ContractVersion:
    """Return the version that a round is about."""
    version = queries.version_by_number(session, contract.id, round_.version)
    if version is None:
        raise ContractVersionNotFound(f"this contract has no version {round_.version}")
    return version


def _to_propose(session: Session, actor: Actor, contract_id: UUID) -> Contract:
    contract = visible_contract(session, actor, contract_id)
    if party_of(actor, contract) is not Party.DESIGNER:
        raise NotYourContract("only the contract's designer proposes changes of it; a producer recalls and edits it")
    return contract


def _sent_version(session: Session, contract: Contract) -> ContractVersion:
    ensure_state(contract.state, {ContractState.SENT}, next_action_hint(contract.state, contract.kind, Party.DESIGNER))
    return newest_of(session, contract)


def _problems(
    changes: Sequence[Change], clauses: Sequence[Clause], terms: Terms, kind: ContractKind
) -> list[FieldProblem]:
    faults = list(change_errors(changes, clauses, terms)) or proposed_figure_errors(changes, clauses, terms, kind)
    return [FieldProblem(where=where, message=message) for where, message in faults]


def _marked(
    session: Session, contract: Contract, sent: ContractVersion, redlines: Sequence[Redline]
) -> list[MarkedClause]:
    clauses, terms = text_of(sent)
    # Before the NDA is agreed its designer may know nothing but what the text says that was sent.
    names = clause_rules.names_in([clause for clause in clauses if clause.stands])
    facts = facts_of(session, contract, terms_in_force(clauses, terms))
    shown = {name: value for name, value in facts.items() if name in names}
    return marked_clauses((clauses, terms), redlines, shown, contract.currency, sent.text)
