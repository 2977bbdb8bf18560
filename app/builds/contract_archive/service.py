"""The handover pack of a contract that has ended: what the next designer begins with."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import PurePosixPath
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.agreements.access import contract_for_producer
from app.agreements.models import Contract, ContractCue
from app.agreements.plan.queries import cues_of, wanted_cues
from app.agreements.queries import contracts_in
from app.agreements.rules import ORDERS, ContractState
from app.briefs.queries import answers_of
from app.briefs.questions import QUESTIONS
from app.briefs.rules import in_words
from app.briefs.service import open_answers
from app.builds import queries
from app.builds.contract_archive.text import ArchivedCue, ArchivedFile, ArchivedRemark, Handover, cue_table, read_me
from app.builds.engine_export.cues import file_safe
from app.builds.errors import ContractNotEnded
from app.builds.packs.service import SUMS, ensure_stored, memory_entry, stored_entry
from app.builds.packs.zip_stream import Entry
from app.builds.rules import sums
from app.builds.schemas import OpenCue, OpenHandover
from app.core.storage import Store
from app.deliveries.models import SourceFile, Take
from app.deliveries.rules import base_name
from app.deliveries.source_banks import queries as bank_queries
from app.deliveries.source_banks.service import handed_over
from app.deliveries.sources.queries import approved_takes_of
from app.deliveries.sources.service import sources_of
from app.deliveries.sources.statements import words_of
from app.money.downloads import closed_downloads
from app.projects.models import Project
from app.projects.service import project_access
from app.reviews.queries import accepted_takes
from app.sound_lists.queries import questions_of
from app.sound_lists.rules import label

READ_ME, CUES = "README.md", "cues.csv"
NO_STATE = "not settled"


def handover_pack(session: Session, store: Store, actor: Actor, contract_id: UUID) -> tuple[Project, str, list[Entry]]:
    """Return project, name and files of a contract's handover pack, for a producer.

    Raises ContractNotEnded before the contract has ended, BlobDamaged where the store lacks a master.
    """
    contract = contract_for_producer(session, actor, contract_id)
    if contract.state is not ContractState.ENDED:
        raise ContractNotEnded(
            "this contract has not ended, so its designer still works on it",
            fix="end it on the page Terminate contract; the pack is made of what is approved then",
        )
    project = session.get_one(Project, contract.project_id)
    covered = cues_of(session, contract.id)
    approved = approved_takes_of(session, [contract_cue.cue_id for contract_cue in covered], contract.designer_id)
    palette = _palette(session, project, {take.id for take in approved})
    files, source_files = _with_banks(session, approved, _files(session, project, "masters", approved))
    of_palette = _files(session, project, "palette", palette)
    handover = Handover(
        project=project.name,
        contract=contract.title,
        cues=_cues(session, project, contract, covered, approved, files),
        palette=[of_palette[take.id] for take in palette],
        brief=_brief(session, project.id),
        open_brief=[answer.text for answer in open_answers(session, project.id)],
    )
    masters = [
        stored_entry(store, take.studio_id, file.path, take.master_sha256, take.master_bytes)
        for take in (*approved, *palette)
        if not (file := (files | of_palette)[take.id]).left_out
    ]
    masters += [
        stored_entry(store, file.studio_id, path, file.sha256, file.file_bytes) for path, file in source_files.items()
    ]
    ensure_stored(store, project.studio_id, masters)
    entries = [*masters, memory_entry(CUES, cue_table(handover)), memory_entry(READ_ME, read_me(handover))]
    entries.append(memory_entry(SUMS, sums({entry.path: entry.sha256 for entry in entries})))
    return project, f"{project.name} handover {contract.number}.zip", entries


def open_handovers(session: Session, actor: Actor, project_id: UUID) -> list[OpenHandover]:
    """Return the ended contracts of a project whose cues have no designer now, the newest first, for a producer.

    A cue that several of them had is named by the newest. A producer who is a contract's own designer leaves it out.
    """
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    ended = [
        ended_contract
        for ended_contract in contracts_in(session, actor, project_id)
        if ended_contract.state is ContractState.ENDED
        and ended_contract.kind in ORDERS
        and ended_contract.ended_at is not None
    ]
    if not ended:
        return []
    covered = {ended_contract.id: cues_of(session, ended_contract.id) for ended_contract in ended}
    waiting = {cue.id for cue in wanted_cues(session, project_id)}
    waiting -= {cue.cue_id for cues in covered.values() for cue in cues if cue.accepted_at is not None}
    handovers: list[OpenHandover] = []
    for contract in sorted(ended, key=lambda other: other.number, reverse=True):
        cues = [contract_cue.cue for contract_cue in covered[contract.id] if contract_cue.cue_id in waiting]
        waiting -= {cue.id for cue in cues}
        if cues and contract.designer_id != actor.person_id and contract.ended_at is not None:
            prefix = access.project.cue_prefix
            handovers.append(
                OpenHandover(
                    contract_id=contract.id,
                    title=contract.title,
                    designer=contract.designer.name,
                    ended_at=contract.ended_at,
                    cues=[OpenCue(id=cue.id, label=label(prefix, cue.number), name=cue.name) for cue in cues],
                )
            )
    return handovers


def _palette(session: Session, project: Project, own_take_ids: set[UUID]) -> list[Take]:
    """Return the accepted sounds of the palette that the contract itself does not have."""
    return [take for cue, _, take in accepted_takes(session, project.id) if cue.palette and take.id not in own_take_ids]


def _files(session: Session, project: Project, folder: str, takes: Sequence[Take]) -> dict[UUID, ArchivedFile]:
    stems = queries.stems_of_project(session, project.id)
    stated = sources_of(session, takes)
    # No actor: the pack goes to another designer, who reads no invoice.
    closed = closed_downloads(session, None, {(take.cue_id, take.designer_id) for take in takes if take.cue_id})
    return {
        take.id: ArchivedFile(
            path=f"{folder}/{_stem(stems, take)}{PurePosixPath(take.file_name).suffix.lower()}",
            sha256=take.master_sha256,
            version=take.number,
            sources=words_of(stated[take.id]) if take.id in stated else "",
            left_out=(
                "its master was deleted: the contract's years of keeping it were over"
                if take.master_deleted_at
                else closed.get((take.cue_id, take.designer_id), "")
            ),
        )
        for take in takes
        if take.cue_id is not None and take.variation is not None
    }


def _with_banks(
    session: Session, takes: Sequence[Take], files: dict[UUID, ArchivedFile]
) -> tuple[dict[UUID, ArchivedFile], dict[str, SourceFile]]:
    """Return files with the source banks that the contract hands over, and the source files by their paths."""
    open_takes = [take for take in handed_over(session, takes) if not files[take.id].left_out]
    take_ids = [take.id for take in open_takes]
    banks, kept = bank_queries.source_banks(session, take_ids), bank_queries.source_files(session, take_ids)
    whole, by_path = dict(files), dict[str, SourceFile]()
    for take in open_takes:
        folder = f"source_files/{PurePosixPath(files[take.id].path).stem}"
        paths = {
            f"{folder}/{place:02d}_{file_safe(base_name(file.file_name))}": file
            for place, file in enumerate(kept.get(take.id, []), start=1)
        }
        bank = banks.get(take.id)
        whole[take.id] = replace(
            files[take.id],
            plug_ins=bank.plug_ins if bank else (),
            recipe=bank.recipe if bank else "",
            source_files=list(paths),
        )
        by_path |= paths
    return whole, by_path


def _stem(stems: Mapping[tuple[UUID, int], str], take: Take) -> str:
    """Return the name that the list owns; of a cue that was cut from the list, the delivered one, made unique."""
    owned = stems.get((take.cue_id, take.variation)) if take.cue_id else None
    return owned or f"{PurePosixPath(take.file_name).stem}_cut_{take.id.hex[-8:]}"


def _cues(
    session: Session,
    project: Project,
    contract: Contract,
    covered: Sequence[ContractCue],
    approved: Sequence[Take],
    files: dict[UUID, ArchivedFile],
) -> list[ArchivedCue]:
    stems = queries.stems_of_project(session, project.id)
    unfinished = [unaccepted.cue_id for unaccepted in covered if unaccepted.accepted_at is None]
    remarks = queries.open_remarks(session, unfinished, contract.designer_id)
    asked = questions_of(session, project.id, only_open=True)
    cues = []
    for contract_cue in covered:
        cue, takes = contract_cue.cue, [take for take in approved if take.cue_id == contract_cue.cue_id]
        done = {take.variation for take in takes}
        cues.append(
            ArchivedCue(
                label=label(project.cue_prefix, cue.number),
                name=cue.name,
                category=cue.category,
                description=cue.description,
                variations=cue.variations,
                is_palette=cue.palette,
                state=_state(contract_cue),
                files=[files[take.id] for take in takes],
                owed=[  # a cue that was cut from the list owns no names, and is owed no more
                    stems[cue.id, variation]
                    for variation in range(1, cue.variations + 1)
                    if variation not in done and (cue.id, variation) in stems
                ],
                remarks=[_remark(remark) for remark in remarks if remark.cue_id == cue.id],
                questions=[question.text for question in asked if question.cue_id == cue.id],
            )
        )
    return cues


def _state(covered: ContractCue) -> str:
    if covered.accepted_at is not None:
        return "accepted"
    return covered.cut_in.value.replace("_", " ") if covered.cut_in is not None else NO_STATE


def _remark(row: queries.RemarkRow) -> ArchivedRemark:
    day = row.created_at.date().isoformat()
    return ArchivedRemark(row.file_name, row.start_s, row.author, day, row.text, is_request=row.is_request)


def _brief(session: Session, project_id: UUID) -> list[tuple[str, str]]:
    answers = answers_of(session, project_id)
    answers_given = [(question.text, in_words(question, answers.get(question.key))) for question in QUESTIONS]
    return [(question, answer) for question, answer in answers_given if answer]
