"""A clearance sheet's account of the sounds of a pack, for a publisher's lawyers."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.queries import people_by_id
from app.accounts.rules import Actor
from app.agreements.models import Contract
from app.agreements.plan.queries import cues_of
from app.builds import queries
from app.builds.clearance.sheet import ClearanceRow
from app.builds.packs.sealing import ensure_sealed, visible_sealed
from app.builds.packs.service import pack_of, title_of
from app.builds.same_sounds.service import library_files_in_words, same_sounds_in_words
from app.core.plural import day_in_words
from app.deliveries.models import Take
from app.deliveries.schemas import Sources
from app.deliveries.sources.service import sources_of
from app.deliveries.sources.statements import open_points, words_of_points
from app.money.ledger.book import paid_cues
from app.money.ledger.service import load_ledger_book, priced
from app.projects.models import Project
from app.projects.service import project_access
from app.reviews.models import Verdict
from app.reviews.queries import effective_verdicts
from app.reviews.rules import VerdictKind
from app.sound_lists.rules import label


def clearance_of_project(
    session: Session, actor: Actor, project_id: UUID, target: str | None
) -> tuple[str, list[ClearanceRow]]:
    """Return title and rows for the pack of a target as it is now; for producers, because it says what is paid."""
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    pack = pack_of(session, access.project, target)
    return title_of(pack), clearance_rows(session, pack.project, [(sound.path, sound.take) for sound in pack.sounds])


def clearance_of_pack(session: Session, actor: Actor, pack_id: UUID) -> tuple[str, list[ClearanceRow]]:
    """Return title and rows for a sealed pack, by what is stated now."""
    pack = visible_sealed(session, actor, pack_id)
    access = project_access(session, actor, pack.project_id)
    access.ensure_producer()
    ensure_sealed(pack)
    title = f"{access.project.name}, {pack.target} {pack.number}"
    return title, clearance_rows(session, access.project, queries.packed_takes_of(session, pack_id))


def clearance_rows(session: Session, project: Project, sounds: Sequence[tuple[str, Take]]) -> list[ClearanceRow]:
    """Return the sheet's rows on some files, each with its take; the caller has checked access."""
    takes = [take for _, take in sounds]
    stated = sources_of(session, takes)
    designers = people_by_id(session, {take.designer_id for take in takes})
    in_house = queries.in_house_designers(session, project.id)
    contracts: dict[tuple[UUID, UUID], Contract] = {}
    for covered, cue_contract in queries.contracts_of_cues(session, {take.cue_id for take in takes if take.cue_id}):
        contracts[covered.cue_id, cue_contract.designer_id] = cue_contract
    paid = {known_contract.id: _paid(session, known_contract) for known_contract in contracts.values()}
    elsewhere = queries.same_masters_elsewhere(
        session, project.studio_id, project.id, {take.master_sha256 for take in takes}
    )
    same_sounds = same_sounds_in_words(session, takes)
    of_libraries = library_files_in_words(session, takes)
    approvals = {
        verdict.take_id: verdict
        for verdict in effective_verdicts(session, [take.id for take in takes])
        if verdict.kind is VerdictKind.APPROVE
    }
    judges = people_by_id(session, {judged.given_by for judged in approvals.values() if judged.given_by})
    rows = []
    for path, take in sounds:
        sources, cue = stated.get(take.id), take.cue
        contract = contracts.get((take.cue_id, take.designer_id)) if take.cue_id else None
        approval = approvals.get(take.id)
        judge = judges.get(approval.given_by) if approval and approval.given_by else None
        rows.append(
            ClearanceRow(
                file=path,
                cue=label(project.cue_prefix, cue.number) if cue else "",
                name=cue.name if cue else "",
                variation=take.variation,
                version=take.number,
                designer=_made_by(approval, designers[take.designer_id].name),
                agreement=_agreement(contract, is_in_house=take.designer_id in in_house),
                paid=("yes" if take.cue_id in paid[contract.id] else "no") if contract else "",
                **_stated(sources),
                open_points=words_of_points(open_points(sources)),
                same_file_in=", ".join(elsewhere.get(take.master_sha256, [])),
                same_sound_in=same_sounds.get(take.id, ""),
                same_in_libraries=of_libraries.get(take.id, ""),
                delivered_on=take.received_at.date().isoformat(),
                approved_on=approval.created_at.date().isoformat() if approval else "",
                approved_by=_approved_by(approval, judge.name if judge else ""),
                master=take.file_name,
                master_sha256=take.master_sha256,
            )
        )
    return rows


def _paid(session: Session, contract: Contract) -> set[UUID]:
    return paid_cues(load_ledger_book(session, contract), priced(cues_of(session, contract.id)))


def _made_by(approval: Verdict | None, name: str) -> str:
    """Return the maker of a sound; of one that was adopted only the sender is known."""
    return "not known (adopted)" if approval is not None and approval.adoption_id else name


def _approved_by(approval: Verdict | None, name: str) -> str:
    if approval is None:
        return ""
    return f"{name} (adopted)" if approval.adoption_id else name or "the clause on silence"


def _agreement(contract: Contract | None, *, is_in_house: bool) -> str:
    if contract is not None and contract.agreed_at is not None:
        return f"{contract.title}, agreed {day_in_words(contract.agreed_at.date())}"
    return "employed by the studio" if is_in_house else "no contract in Soundlist"


def _stated(sources: Sources | None) -> dict[str, str]:
    if sources is None:
        return dict.fromkeys(("from_scratch", "own_recordings", "libraries", "generated", "performers", "note"), "")
    return {
        "from_scratch": "yes" if sources.from_scratch else "no",
        "own_recordings": "yes" if sources.own_recordings else "no",
        "libraries": "; ".join(
            ", ".join(part for part in (library.name, library.licence, library.file) if part)
            for library in sources.libraries
        ),
        "generated": "; ".join(f"{generated_part.tool}: {generated_part.part}" for generated_part in sources.generated),
        "performers": "; ".join(
            f"{performer.name}, release: {performer.release or 'none named'}" for performer in sources.performers
        ),
        "note": sources.note,
    }
