"""Audits of game builds: posted by CI, shown with what is new, drift accepted with a reason or sent back."""

from collections.abc import Mapping, Sequence
from pathlib import PurePosixPath
from uuid import UUID

from sqlalchemy.orm import Session

import audio_checks
from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.builds.audits import queries as audit_queries
from app.builds.audits.models import AcceptedDrift, AuditedSound, BuildAudit, GameTask
from app.builds.audits.rules import Drift, has_drifted, played_level
from app.builds.audits.schemas import (
    MAX_MESSAGE_CHARS,
    AcceptedDriftRead,
    AuditAdd,
    AuditedSoundRead,
    AuditRead,
    AuditSummary,
    PostedSound,
    SoundInBuild,
)
from app.builds.errors import (
    AcceptedDriftNotFound,
    AuditedSoundNotFound,
    AuditNotFound,
    NothingDrifted,
)
from app.builds.listening import tasks as game_tasks
from app.builds.packs.service import ensure_team_or_build
from app.builds.schemas import AcceptedSound
from app.core import clock
from app.core.events import publish
from app.deliveries.models import Take
from app.projects.errors import ProjectNotFound
from app.projects.models import Project
from app.projects.service import ProjectAccess, project_access
from app.renders.queries import pictures_of_sounds
from app.renders.schemas import TakeSound
from app.renders.service import sound_places
from app.sound_lists.queries import cues_by_id

UNREAD_KEPT = 100


def save_audit(session: Session, actor: Actor, project_id: UUID, posted: AuditAdd) -> BuildAudit:
    """Keep an audit's results on each sound, and count the drifts since the audit before."""
    access = project_access(session, actor, project_id)
    ensure_team_or_build(access)
    report = posted.report
    before = audit_queries.audit_before(session, project_id, posted.target, None)
    sounds = _sounds(session, access.project, report.files)
    accepted_drifts = [
        *_drifts(session, before),
        *(accepted_drift.drift for accepted_drift in audit_queries.accepted_drifts(session, project_id)),
    ]
    by_path = _by_path(accepted_drifts)
    drifted = [sound.drift for sound in sounds if sound.has_drifted]
    project = report.project
    audit = BuildAudit(
        studio_id=access.project.studio_id,
        project_id=project_id,
        label=posted.label,
        commit=posted.commit,
        target=posted.target,
        engine=project.engine if project else "",
        sounds=len(sounds),
        drifted=len(drifted),
        new_drifts=sum(not _is_among(drift, by_path) for drift in drifted),
        unread=[unread.model_dump() for unread in project.unread[:UNREAD_KEPT]] if project else [],
        token_id=actor.token_id,
    )
    session.add(audit)
    session.flush()
    for sound in sounds:
        sound.audit_id = audit.id
    session.add_all(sounds)
    session.flush()
    publish(session, "audit.posted", studio_id=audit.studio_id, audit_id=audit.id)
    return audit


def _sounds(session: Session, project: Project, files: Sequence[PostedSound]) -> list[AuditedSound]:
    take_ids = {take_id for file in files if (take_id := _take_named(file)) is not None}
    takes = audit_queries.takes_named(session, project.id, take_ids)
    stems = audit_queries.cues_by_stem(session, project.id)
    return [_sound(project, index, file, takes, stems) for index, file in enumerate(files)]


def _sound(
    project: Project, index: int, file: PostedSound, takes: Mapping[UUID, Take], stems: Mapping[str, UUID]
) -> AuditedSound:
    take_id = _take_named(file)
    take = takes.get(take_id) if take_id is not None else None
    named = PurePosixPath((file.approved or file.path).replace("\\", "/"))
    stem = named.stem.lower()
    level = played_level(file.model_dump())
    return AuditedSound(
        place=index,
        studio_id=project.studio_id,
        project_id=project.id,
        path=file.path,
        cue_id=(take.cue_id if take else None)
        or stems.get(stem)
        or stems.get(audio_checks.stem_in_language(named.parent.name.lower(), stem)),
        take_id=take.id if take else None,
        status=file.status,
        played_status=file.played_status,
        has_drifted=has_drifted(file.status, file.played_status),
        gain_db=file.gain_db,
        file_db=level.file_db,
        property_db=level.property_db,
        message=file.message[:MAX_MESSAGE_CHARS],
        moves=level.moves,
        depends=level.depends,
        events=level.events,
    )


def _take_named(file: PostedSound) -> UUID | None:
    """Return the take that the manifest gave to the approved sound of a file; a report may hold any text there."""
    named = next((match.take for match in file.matches if match.path == file.approved), None)
    try:
        return UUID(named) if named else None
    except ValueError:
        return None


def _drifts(session: Session, audit: BuildAudit | None) -> list[Drift]:
    return [sound.drift for sound in audit_queries.drifted_sounds(session, audit.id)] if audit else []


def _by_path(drifts: Sequence[Drift]) -> dict[str, list[Drift]]:
    by_path: dict[str, list[Drift]] = {}
    for drift in drifts:
        by_path.setdefault(drift.path, []).append(drift)
    return by_path


def _is_among(drift: Drift, by_path: Mapping[str, Sequence[Drift]]) -> bool:
    return any(drift.is_same(other) for other in by_path.get(drift.path, ()))


def audits_in(
    session: Session, actor: Actor, project_id: UUID, *, before: UUID | None, limit: int
) -> Sequence[BuildAudit]:
    """Return audits of a project to its team, the newest first."""
    project_access(session, actor, project_id).ensure_team()
    return audit_queries.audits_of(session, project_id, before=before, limit=limit)


def visible_audit(session: Session, actor: Actor, audit_id: UUID) -> tuple[ProjectAccess, BuildAudit]:
    """Return an audit; raise AuditNotFound without sight of it."""
    audit = audit_queries.audit_by_id(session, audit_id)
    if audit is None:
        raise AuditNotFound(f"no audit {audit_id}")
    try:
        access = project_access(session, actor, audit.project_id)
    except ProjectNotFound:
        raise AuditNotFound(f"no audit {audit_id}") from None
    access.ensure_team()
    return access, audit


def read_audit(session: Session, audit: BuildAudit) -> AuditRead:
    """Return an audit, with how much of its drift is accepted now."""
    before = audit_queries.audit_before(session, audit.project_id, audit.target, audit.id)
    accepted = _by_path(
        [accepted_drift.drift for accepted_drift in audit_queries.accepted_drifts(session, audit.project_id)]
    )
    return AuditRead(
        **AuditSummary.model_validate(audit).model_dump(),
        before=before.label if before else None,
        accepted=sum(_is_among(drift, accepted) for drift in _drifts(session, audit)),
        depends=audit_queries.depending_sounds(session, audit.id),
        unread=audit.unread,
    )


def sounds_in(
    session: Session, audit: BuildAudit, *, drifted_only: bool, after: int | None, limit: int
) -> Sequence[AuditedSound]:
    """Return the sounds of an audit in its order."""
    return audit_queries.sounds_of(session, audit.id, drifted_only=drifted_only, after=after, limit=limit)


def read_sounds(
    session: Session, access: ProjectAccess, audit: BuildAudit, sounds: Sequence[AuditedSound]
) -> list[AuditedSoundRead]:
    """Return sounds of an audit with their cues, what is new, what was accepted, and the approved sound to play."""
    project = access.project
    before = audit_queries.audit_before(session, project.id, audit.target, audit.id)
    drifts_before = _by_path(_drifts(session, before))
    accepted = audit_queries.accepted_drifts(session, project.id)
    tasks = audit_queries.open_drift_tasks(session, project.id)
    cues = cues_by_id(session, project.id, {sound.cue_id for sound in sounds if sound.cue_id})
    approved = approved_sounds(session, project, sounds)
    reads = []
    for sound in sounds:
        acceptance = next(
            (accepted_drift for accepted_drift in accepted if accepted_drift.drift.is_same(sound.drift)), None
        )
        reads.append(
            AuditedSoundRead(
                place=sound.place,
                path=sound.path,
                cue=game_tasks.cue_read(project, cues[sound.cue_id]) if sound.cue_id in cues else None,
                status=sound.status,
                played_status=sound.played_status,
                has_drifted=sound.has_drifted,
                is_new=sound.has_drifted and not _is_among(sound.drift, drifts_before),
                gain_db=sound.gain_db,
                file_db=sound.file_db,
                property_db=sound.property_db,
                message=sound.message,
                moves=sound.moves,
                depends=sound.depends,
                events=sound.events,
                accepted=read_accepted(acceptance) if acceptance and sound.has_drifted else None,
                task_id=tasks.get(sound.path),
                sound=approved.get(sound.place),
            )
        )
    return reads


def approved_sounds(session: Session, project: Project, sounds: Sequence[AuditedSound]) -> dict[int, TakeSound]:
    """Return by their places the approved sounds to play, where they are drawn: those that sounds were held to."""
    takes = audit_queries.takes_named(session, project.id, {sound.take_id for sound in sounds if sound.take_id})
    without = {sound.cue_id for sound in sounds if sound.cue_id and sound.take_id not in takes}
    of_cues = audit_queries.approved_takes_of(session, project.id, without) if without else {}
    chosen = {
        sound.place: take
        for sound in sounds
        if (take := takes.get(sound.take_id) if sound.take_id else of_cues.get(sound.cue_id) if sound.cue_id else None)
    }
    hashes = {take.master_sha256 for take in chosen.values()}
    pictures = pictures_of_sounds(session, [project.studio_id], hashes)
    return {
        index: TakeSound(**sound_places(picture, None), take_id=take.id)
        for index, take in chosen.items()
        if (picture := pictures.get(take.master_sha256)) is not None
    }


def history_of(session: Session, actor: Actor, project_id: UUID, path: str) -> list[SoundInBuild]:
    """Return the last builds' results on a sound, the newest first."""
    project_access(session, actor, project_id).ensure_team()
    return [
        SoundInBuild(
            audit_id=audit.id,
            label=audit.label,
            created_at=audit.created_at,
            status=sound.status,
            played_status=sound.played_status,
            gain_db=sound.gain_db,
            changelist=sound.moves[0].get("changelist") if sound.moves else None,
        )
        for sound, audit in audit_queries.history_of(session, project_id, path)
    ]


def accept_drift(session: Session, actor: Actor, audit_id: UUID, *, path: str, reason: str) -> AcceptedDriftRead:
    """Accept a sound's drift, with a reason; another level or another change is asked for again."""
    access, audit = visible_audit(session, actor, audit_id)
    access.ensure_may_speak()
    sound = _drifted_sound(session, audit, path)
    standing = audit_queries.accepted_drifts(session, audit.project_id)
    same_drift = next(
        (accepted_drift for accepted_drift in standing if accepted_drift.drift.is_same(sound.drift)), None
    )
    if same_drift is not None:
        return read_accepted(same_drift)
    session.add(
        AcceptedDrift(
            studio_id=audit.studio_id,
            project_id=audit.project_id,
            target=audit.target,
            path=sound.path,
            status=sound.status,
            played_status=sound.played_status,
            gain_db=sound.gain_db,
            reason=reason,
            accepted_by=actor.person,
        )
    )
    session.flush()
    return read_accepted(audit_queries.accepted_drifts(session, audit.project_id)[0])


def send_back(
    session: Session, actor: Actor, audit_id: UUID, *, path: str, text: str
) -> tuple[ProjectAccess, GameTask]:
    """Make a task for the implementers of how a sound drifted."""
    access, audit = visible_audit(session, actor, audit_id)
    access.ensure_may_speak()
    return access, game_tasks.send_back(session, access, audit.id, _drifted_sound(session, audit, path), text=text)


def _drifted_sound(session: Session, audit: BuildAudit, path: str) -> AuditedSound:
    sound = audit_queries.sound_at(session, audit.id, path)
    if sound is None:
        raise AuditedSoundNotFound(f"build {audit.label} has no sound {path}")
    if not sound.has_drifted:
        raise NothingDrifted(f"{path} plays as approved in build {audit.label}")
    return sound


def withdraw_acceptance(session: Session, actor: Actor, accepted_drift_id: UUID) -> None:
    """Take back that a drift was accepted; the record of it stays."""
    accepted = audit_queries.accepted_drift_by_id(session, accepted_drift_id)
    if accepted is None:
        raise AcceptedDriftNotFound(f"no accepted drift {accepted_drift_id}")
    try:
        access = project_access(session, actor, accepted.project_id)
    except ProjectNotFound:
        raise AcceptedDriftNotFound(f"no accepted drift {accepted_drift_id}") from None
    access.ensure_may_speak()
    if accepted.withdrawn_at is None:
        accepted.withdrawn_at, accepted.withdrawn_by = clock.now(), actor.person
        session.flush()


def acceptances_in(session: Session, actor: Actor, project_id: UUID) -> list[AcceptedDriftRead]:
    """Return the accepted drifts of a project, the newest first, to its team."""
    project_access(session, actor, project_id).ensure_team()
    return [read_accepted(accepted_drift) for accepted_drift in audit_queries.accepted_drifts(session, project_id)]


def accepted_sounds(session: Session, project_id: UUID) -> list[AcceptedSound]:
    """Return the accepted drifts as audits in CI read them; the caller has checked access."""
    return [
        AcceptedSound(
            path=accepted_drift.path,
            status=accepted_drift.status,
            played_status=accepted_drift.played_status,
            gain_db=accepted_drift.gain_db,
            reason=accepted_drift.reason,
            on=accepted_drift.accepted_at.date(),
        )
        for accepted_drift in audit_queries.accepted_drifts(session, project_id)
    ]


def read_accepted(accepted: AcceptedDrift) -> AcceptedDriftRead:
    """Return an accepted drift as it is shown."""
    facts = {name: getattr(accepted, name) for name in AcceptedDriftRead.model_fields if name != "accepted_by"}
    return AcceptedDriftRead(**facts, accepted_by=PersonBrief.model_validate(accepted.author))
