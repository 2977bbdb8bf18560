"""The work under a contract held against its record: takes, verdicts, comments, questions and the sound list."""

import json
from collections.abc import Iterator, Sequence
from datetime import datetime

from sqlalchemy.orm import Session

from app.agreements.models import Contract
from app.agreements.queries import versions_of
from app.agreements.record.sealed_facts import sealed
from app.agreements.rules import ContractState
from app.amendments import work_queries
from app.amendments.entries import Entry, state_after
from app.deliveries.rules import TakeState
from app.reviews.rules import VerdictKind


def work_faults(session: Session, contract: Contract, entries: Sequence[Entry]) -> Iterator[str]:
    """Yield, in words, where versions, takes, verdicts, comments, questions or the list differ from the record."""
    yield from _later_versions(session, contract, entries)
    yield from _verdicts(session, contract, entries)
    yield from _approved_takes(session, contract)
    yield from _comments(session, contract, entries)
    yield from _change_requests(session, contract, entries)
    yield from _questions(session, contract, entries)
    yield from _revisions(session, contract, entries)


def _later_versions(session: Session, contract: Contract, entries: Sequence[Entry]) -> Iterator[str]:
    sent = [entry.said["version"] for entry in entries if entry.kind == "sent"]
    if sent and state_after(entries) is not ContractState.DRAFT:
        numbers = [version.number for version in versions_of(session, contract.id)]
        yield from (
            f"version {number} was added after version {sent[-1]} was sent" for number in numbers if number > sent[-1]
        )


def _since(entries: Sequence[Entry]) -> dict[str, datetime]:
    """Return the moment at which a contract got each of its cues, by its plans."""
    since: dict[str, datetime] = {}
    for entry in entries:
        if entry.kind == "planned":
            for milestone in entry.said["milestones"]:
                for cue_id in milestone.get("cue_ids", ()):
                    since.setdefault(cue_id, entry.at)
    return since


def _is_under(contract: Contract, since: datetime | None, at: datetime) -> bool:
    """Whether something happened to a cue while the contract had it, and was in force."""
    return since is not None and at > since and (contract.ended_at is None or at < contract.ended_at)


def _verdicts(session: Session, contract: Contract, entries: Sequence[Entry]) -> Iterator[str]:
    since, recorded_ids = _since(entries), _recorded_ids(session, contract, "verdict")
    for verdict in work_queries.verdicts_under(session, contract):
        if str(verdict.id) not in recorded_ids and _is_under(
            contract, since.get(str(verdict.cue_id)), verdict.created_at
        ):
            yield f"the verdict {verdict.id} ({verdict.kind}) is in no entry"


def _approved_takes(session: Session, contract: Contract) -> Iterator[str]:
    """Yield takes that are approved with no verdict that says so, and such that are not, with one."""
    verdicts = work_queries.verdicts_under(session, contract)
    withdrawn = {verdict.withdraws_id for verdict in verdicts}
    last = {
        verdict.take_id: verdict
        for verdict in verdicts
        if verdict.id not in withdrawn and verdict.kind is not VerdictKind.WITHDRAW
    }
    for take in work_queries.takes_under(session, contract):
        verdict = last.get(take.id)
        says_approved = verdict is not None and verdict.kind is VerdictKind.APPROVE
        if (take.state is TakeState.APPROVED) is not says_approved:
            of_verdict = f"its last verdict is {verdict.kind}" if verdict else "no verdict says so"
            yield f"the take {take.file_name} ({take.id}) is {take.state}, and {of_verdict}"


def _comments(session: Session, contract: Contract, entries: Sequence[Entry]) -> Iterator[str]:
    since, recorded_ids = _since(entries), _recorded_ids(session, contract, "comment")
    for cue_id, comment in work_queries.comments_under(session, contract):
        if str(comment.id) not in recorded_ids and _is_under(contract, since.get(str(cue_id)), comment.created_at):
            yield f"the comment {comment.id} is in no entry"


def _change_requests(session: Session, contract: Contract, entries: Sequence[Entry]) -> Iterator[str]:
    since, recorded_ids = _since(entries), _recorded_ids(session, contract, "change request")
    for cue_id, request, sent_at in work_queries.change_requests_under(session, contract):
        if str(request.id) not in recorded_ids and _is_under(contract, since.get(str(cue_id)), sent_at):
            yield f"the change request {request.id} is in no entry"


def _questions(session: Session, contract: Contract, entries: Sequence[Entry]) -> Iterator[str]:
    since, recorded_ids = _since(entries), _recorded_ids(session, contract, "question")
    for question in work_queries.questions_under(session, contract):
        if str(question.id) not in recorded_ids and _is_under(
            contract, since.get(str(question.cue_id)), question.asked_at
        ):
            yield f"the question {question.id} is in no entry"


def _recorded_ids(session: Session, contract: Contract, name: str) -> set[str]:
    """Return the ids of rows that a record of the project's contracts with this designer has."""
    payloads = work_queries.entries_with_this_designer(
        session, contract, ["judged", "commented", "question_asked", "accepted", "adopted"]
    )
    return {id_ for payload in payloads for id_ in json.loads(payload).get("rows", {}).get("added", {}).get(name, ())}


def _revisions(session: Session, contract: Contract, entries: Sequence[Entry]) -> Iterator[str]:
    recorded = [entry.said for entry in entries if entry.kind == "list_revised"]
    numbers = [facts["revision"] for facts in recorded]
    changes = work_queries.list_changes(session, contract.project_id, numbers)
    for revision in recorded:
        number = revision["revision"]
        wrong = [
            cue_id
            for cue_id, sha256 in revision["sha256"].items()
            if (number, cue_id) not in changes or sealed(changes[number, cue_id]) != sha256
        ]
        if wrong:
            yield f"revision {number} of the sound list was altered"
