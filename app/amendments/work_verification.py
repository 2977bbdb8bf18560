"""The work under a contract held against its record: plan, terms, acceptances, verdicts, comments, list and spec."""

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements import plan_queries
from app.agreements.documents import sha256_of
from app.agreements.models import Contract, ContractEvent
from app.agreements.queries import versions_of
from app.agreements.rules import ContractState
from app.agreements.sealed_facts import sealed, sealed_milestone, sealed_terms
from app.amendments import work_queries
from app.money.ledger import called
from app.projects.models import Project
from app.projects.queries import spec_version
from app.reviews.models import Comment, Verdict

ACCEPTED, REOPENED, CUT, SETTLED = ("accepted", "adopted"), "reopened", "cut", "settled"


@dataclass(frozen=True)
class Entry:
    """One entry of the record, read."""

    kind: str
    at: datetime
    said: Mapping[str, Any]


def work_faults(session: Session, contract: Contract, events: Sequence[ContractEvent]) -> Iterator[str]:
    """Yield, in words, where plan, terms, acceptances, verdicts, comments, list or spec differ from the record.

    Entries from before these facts were recorded name none, and nothing is held against them.
    """
    entries = [Entry(event.kind, event.at, json.loads(event.payload)) for event in events]
    yield from _terms(session, contract, entries)
    yield from _plan(session, contract, entries)
    yield from _cues(session, contract, entries)
    yield from _verdicts(session, contract, entries)
    yield from _comments(session, contract, entries)
    yield from _revisions(session, contract, entries)
    yield from _specs(session, contract, entries)


def _terms(session: Session, contract: Contract, entries: Sequence[Entry]) -> Iterator[str]:
    sent = [entry.said for entry in entries if entry.kind == "sent"]
    if contract.state is ContractState.DRAFT or not sent or "terms_sha256" not in sent[-1]:
        return
    versions = {version.number: version for version in versions_of(session, contract.id)}
    number = sent[-1]["version"]
    if number in versions and sealed_terms(contract, versions[number]) != sent[-1]["terms_sha256"]:
        yield f"clauses, terms or currency of version {number} were altered"
    yield from (f"version {one} was added after version {number} was sent" for one in versions if one > number)


def _plan(session: Session, contract: Contract, entries: Sequence[Entry]) -> Iterator[str]:
    plans = [entry.said["milestones"] for entry in entries if entry.kind == "planned"]
    if contract.agreed_at is None or (plans and "sha256" not in plans[-1][0]):
        return
    recorded = {milestone["id"]: milestone for milestone in plans[-1]} if plans else {}
    cues = plan_queries.cues_of(session, contract.id)
    found = {
        str(milestone.id): sealed_milestone(milestone, [cue for cue in cues if cue.milestone_id == milestone.id])
        for milestone in plan_queries.milestones_of(session, contract.id)
    }
    names = {str(one.id): one.name for one in plan_queries.milestones_of(session, contract.id)}
    for id_ in sorted(recorded.keys() | found.keys()):
        if id_ not in found:
            yield f"the milestone {recorded[id_]['name']} of the record is missing"
        elif id_ not in recorded:
            yield f"the milestone {names[id_]} is in no entry"
        elif found[id_]["sha256"] != recorded[id_]["sha256"]:
            yield f"the milestone {recorded[id_]['name']} was altered: its amount, date, tax, cues or their prices"


def _cues(session: Session, contract: Contract, entries: Sequence[Entry]) -> Iterator[str]:
    """Yield cues that were accepted, opened again or cut otherwise than the record says."""
    states = [entry for entry in entries if entry.kind in (*ACCEPTED, REOPENED, CUT, SETTLED)]
    if any("cut" not in one.said if one.kind == SETTLED else "cue_id" not in one.said for one in states):
        return
    accepted: dict[str, bool] = {}
    cut: dict[str, str] = {}
    for entry in states:
        if entry.kind == SETTLED:
            cut |= entry.said["cut"]
        elif entry.kind == CUT:
            cut[entry.said["cue_id"]] = entry.said["state"]
        else:
            accepted[entry.said["cue_id"]] = entry.kind in ACCEPTED
    prefix = session.get_one(Project, contract.project_id).cue_prefix
    for covered in plan_queries.cues_of(session, contract.id):
        id_, name = str(covered.cue_id), called(covered.cue, prefix)
        if (covered.accepted_at is not None) != accepted.get(id_, False):
            is_ = "accepted" if covered.accepted_at else "not accepted"
            yield f"{name} is {is_}, and the record says otherwise"
        if (covered.cut_in.value if covered.cut_in else None) != cut.get(id_):
            yield f"{name} is cut in another state than the record says"


def _since(entries: Sequence[Entry]) -> dict[str, datetime]:
    """Return since when a contract has had each of its cues, as its plans say."""
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
    since = _since(entries)
    known = _recorded_ids(session, contract, "judged", "verdict_id")
    found = {str(one.id): one for one in work_queries.verdicts_under(session, contract)}
    for entry in entries:
        if entry.kind == "judged" and "verdict_id" in entry.said:
            verdict = found.get(entry.said["verdict_id"]) or session.get(Verdict, UUID(entry.said["verdict_id"]))
            if verdict is None:
                yield f"a verdict on {entry.said['cue']} is missing"
            elif (verdict.kind.value, verdict.note) != (entry.said["verdict"], entry.said["note"]):
                yield f"a verdict on {entry.said['cue']} was altered"
    for id_, verdict in found.items():
        if id_ not in known and _is_under(contract, since.get(str(verdict.cue_id)), verdict.created_at):
            yield f"the verdict {id_} ({verdict.kind}) is in no entry"


def _comments(session: Session, contract: Contract, entries: Sequence[Entry]) -> Iterator[str]:
    since = _since(entries)
    known = _recorded_ids(session, contract, "commented", "comment_id")
    rows = work_queries.comments_under(session, contract)
    found = {str(comment.id): comment for _, comment in rows}
    for entry in entries:
        if entry.kind == "commented":
            comment = found.get(entry.said["comment_id"]) or session.get(Comment, UUID(entry.said["comment_id"]))
            if comment is None:
                yield f"a comment on {entry.said['cue']} is missing"
            elif comment.text != entry.said["text"]:
                yield f"a comment on {entry.said['cue']} was altered"
    for cue_id, comment in rows:
        if str(comment.id) not in known and _is_under(contract, since.get(str(cue_id)), comment.created_at):
            yield f"the comment {comment.id} is in no entry"


def _recorded_ids(session: Session, contract: Contract, kind: str, name: str) -> set[str]:
    payloads = work_queries.entries_with_this_designer(session, contract, [kind])
    return {json.loads(payload).get(name, "") for payload in payloads}


def _revisions(session: Session, contract: Contract, entries: Sequence[Entry]) -> Iterator[str]:
    recorded = [entry.said for entry in entries if entry.kind == "list_revised"]
    numbers = [said["revision"] for said in recorded]
    changes = work_queries.list_changes(session, contract.project_id, numbers)
    for said in recorded:
        number = said["revision"]
        wrong = [
            cue_id
            for cue_id, sha256 in said["sha256"].items()
            if (number, cue_id) not in changes or sealed(changes[number, cue_id]) != sha256
        ]
        if wrong:
            yield f"revision {number} of the sound list was altered"


def _specs(session: Session, contract: Contract, entries: Sequence[Entry]) -> Iterator[str]:
    for entry in entries:
        if entry.kind == "spec_changed":
            number = entry.said["spec_version"]
            spec = spec_version(session, contract.project_id, number)
            if spec is None or sha256_of(spec.toml) != entry.said["toml_sha256"]:
                yield f"version {number} of the delivery spec was altered or is missing"
