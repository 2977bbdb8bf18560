"""Masters handed out with what is known of them; the master itself stays as it was delivered, and can be had so."""

import hashlib
import json
from collections import ChainMap
from dataclasses import asdict, replace
from pathlib import PurePosixPath
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Studio
from app.accounts.rules import Actor
from app.accounts.security_log.rules import SecurityEventKind
from app.accounts.security_log.service import record
from app.conformance.queries import takes_with_finding
from app.conformance.rules import PLACEHOLDER_CODE
from app.core.events import publish, send
from app.core.storage import StoredBlob
from app.deliveries.downloads import ensure_open
from app.deliveries.models import Take
from app.deliveries.rules import base_name, ensure_master_kept, shown_name, work_state
from app.deliveries.schemas import Sources
from app.deliveries.service import take_for
from app.deliveries.signals import ContractsNamed
from app.deliveries.sources.service import sources_of
from app.deliveries.sources.statements import words_of
from app.projects.models import Project
from app.renders import queries
from app.renders.errors import MasterExportNotFound, MasterExportNotMade
from app.renders.models import MasterExport
from app.renders.schemas import MasterExportRead
from app.sound_lists.rules import label
from audio_checks import Provenance

EXPORT_VERSION = 2  # counts up when the same master and provenance would give another file


def request_export(session: Session, actor: Actor, take_id: UUID) -> MasterExport:
    """Return a take's master with what is known of it now, and have it made unless it was or is."""
    take, access = take_for(session, actor, take_id)
    ensure_open(session, actor, take.cue_id, take.designer_id)
    ensure_master_kept(take.master_deleted_at)
    provenance = asdict(_provenance(session, take, access.project))
    made_of = [EXPORT_VERSION, take.master_sha256, provenance]
    key = hashlib.sha256(json.dumps(made_of, sort_keys=True).encode()).hexdigest()
    export = queries.master_export_of(session, take_id, key)
    if export is not None and export.refusal is None:
        return export
    if export is None:
        name = PurePosixPath(shown_name(base_name(take.file_name))).stem
        export = MasterExport(
            studio_id=take.studio_id,
            project_id=take.project_id,
            take_id=take_id,
            key=key,
            provenance=provenance,
            file_name=f"{name}.wav",
        )
        session.add(export)
    export.refusal = None
    session.flush()
    summary = f"exported the master {export.file_name}"
    record(
        session,
        SecurityEventKind.EXPORT,
        summary,
        studio_ids=[take.studio_id],
        project_id=take.project_id,
        person_id=actor.person,
    )
    publish(session, "master_export.asked", studio_id=take.studio_id, export_id=export.id)
    return export


def _provenance(session: Session, take: Take, project: Project) -> Provenance:
    """Return the recorded provenance of a take; the date of recording is known only from its file."""
    studio = session.get_one(Studio, project.studio_id)
    work_of = {} if take.cue_id is None else {take.id: (take.cue_id, take.designer_id)}
    contracts = ChainMap(*send(session, ContractsNamed(project.cue_prefix, work_of)))
    provenance = Provenance(
        project=project.name,
        studio=studio.name,
        originator=take.designer.name,
        contract=contracts.get(take.id, ""),
        state=work_state(take.state, is_placeholder=bool(takes_with_finding(session, [take.id], PLACEHOLDER_CODE))),
    )
    stated = sources_of(session, [take]).get(take.id)
    fields = _source_fields(stated) if stated else {}
    made_from = f"Sources: {words_of(stated)}" if stated else ""
    cue = take.cue
    if cue is None:
        return replace(provenance, notes=made_from, fields=fields)
    return replace(
        provenance,
        number=label(project.cue_prefix, cue.number),
        name=cue.name,
        notes=" ".join(part for part in (cue.description, made_from) if part),
        fields=fields | ({"isLoop": "true"} if cue.loop else {}),
    )


def _source_fields(sources: Sources) -> dict[str, str]:
    """Return the fields of ASWG-G006 that say what a sound was made from; empty ones are left out."""
    fields = {
        "library": ", ".join(library.name for library in sources.libraries),
        "usageRights": "; ".join(
            f"{library.name}: {library.licence}" for library in sources.libraries if library.licence
        ),
        "actorName": ", ".join(performer.name for performer in sources.performers),
    }
    return {name: text for name, text in fields.items() if text}


def visible_export(session: Session, actor: Actor, export_id: UUID) -> MasterExport:
    """Return a handed-out master; raise MasterExportNotFound unless the caller sees its take."""
    export = queries.master_export_by_id(session, export_id)
    if export is None or not queries.can_see_takes(session, actor, [export.take_id]):
        raise MasterExportNotFound(f"no handed-out master {export_id}")
    return export


def file_of(session: Session, actor: Actor, export: MasterExport) -> str:
    """Return the hash of a handed-out master.

    Raises MasterExportNotMade if there is none, DownloadUnpaid where its contract opens it by payment.
    """
    take = session.get_one(Take, export.take_id)
    ensure_open(session, actor, take.cue_id, take.designer_id)
    if export.sha256 is None:
        raise MasterExportNotMade(
            export.refusal or "this copy is still being made",
            fix="take the master as it was delivered" if export.refusal else "ask again in a moment",
        )
    return export.sha256


def export_read(export: MasterExport) -> MasterExportRead:
    """Return a handed-out master as it is shown."""
    return MasterExportRead(
        id=export.id,
        take_id=export.take_id,
        state="made" if export.sha256 else "refused" if export.refusal else "making",
        refusal=export.refusal,
        fields=_provenance_of(export).aswg(),
        left=export.left,
        file_bytes=export.file_bytes,
        file_name=export.file_name,
        file_url=f"/v1/master-exports/{export.id}/file" if export.sha256 else None,
    )


def _provenance_of(export: MasterExport) -> Provenance:
    return Provenance(**export.provenance)


def to_make(session: Session, export_id: UUID) -> tuple[MasterExport, str, Provenance] | None:
    """Return the export to make, its master and its provenance; None where there is none."""
    export = queries.master_export_by_id(session, export_id)
    if export is None or export.sha256 is not None:
        return None
    return export, session.get_one(Take, export.take_id).master_sha256, _provenance_of(export)


def keep(session: Session, export_id: UUID, blob: StoredBlob, *, left: list[str]) -> None:
    """Put a handed-out master on record, once."""
    export = session.get_one(MasterExport, export_id)
    if export.sha256 is None:
        export.sha256, export.file_bytes, export.left, export.refusal = blob.sha256, blob.size_bytes, left, None


def refuse(session: Session, export_id: UUID, refusal: str) -> None:
    """Record the reason for failure; the next request tries again."""
    export = session.get_one(MasterExport, export_id)
    if export.sha256 is None:
        export.refusal = refusal
