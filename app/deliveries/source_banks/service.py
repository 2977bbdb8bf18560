"""Source banks: kept with a take by its designer, open to the studio once handed over, in no pack."""

from collections.abc import Mapping, Sequence
from datetime import datetime
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock
from app.core.events import send
from app.core.uploads import finished_upload
from app.deliveries.downloads import ensure_open
from app.deliveries.errors import SourceBankHandedOver, SourceFileNotFound, TakeNotFound
from app.deliveries.models import SourceBank, SourceFile, Take
from app.deliveries.rules import TakeState, source_file_kind, stored_name
from app.deliveries.schemas import RecipeSet, SourceBankRead, SourceFileRead
from app.deliveries.service import ensure_own_designer, take_for, uploader
from app.deliveries.signals import SourceFilesAgreed
from app.deliveries.source_banks import queries
from app.deliveries.take_states import note_take
from app.projects.queries import engagements_of
from app.projects.rules import EngagementKind
from app.projects.service import ProjectAccess


def source_bank(session: Session, actor: Actor, take_id: UUID) -> SourceBankRead:
    """Return the source bank of a take that the caller sees; empty where it is not shown to them."""
    take, access = take_for(session, actor, take_id)
    return _read(session, access, take)


def set_recipe(session: Session, actor: Actor, take_id: UUID, recipe: RecipeSet) -> SourceBankRead:
    """Set plug-ins and recipe of a take, as its designer; raise SourceBankHandedOver where the studio has them."""
    take, access = take_for(session, actor, take_id, locked=True)
    ensure_own_designer(access, take)
    bank = session.get(SourceBank, take_id)
    if bank is not None and handed_over(session, [take]):
        raise SourceBankHandedOver(
            "this version is approved, and its recipe is the studio's",
            fix="write the new recipe beside the next version",
        )
    bank = bank or SourceBank(studio_id=take.studio_id, project_id=take.project_id, take_id=take_id)
    bank.plug_ins, bank.recipe, bank.changed_at = recipe.plug_ins, recipe.recipe, clock.now()
    session.add(bank)
    session.flush()
    return _read(session, access, take)


def add_source_file(session: Session, actor: Actor, take_id: UUID, upload_id: UUID) -> SourceFile:
    """Keep a finished upload into a take's delivery as a file that the take was made from; the same again is one."""
    take, access = take_for(session, actor, take_id, locked=True)
    ensure_own_designer(access, take)
    if (kept := queries.source_file_of_upload(session, take_id, upload_id)) is not None:
        return kept
    upload = finished_upload(session, upload_id, owner_id=uploader(actor), scope=str(take.delivery_id))
    name = stored_name(upload.file_name)
    file = SourceFile(
        studio_id=take.studio_id,
        project_id=take.project_id,
        take_id=take.id,
        upload_id=upload.id,
        kind=source_file_kind(name),
        file_name=name,
        sha256=upload.sha256,
        file_bytes=upload.size_bytes,
    )
    session.add(file)
    session.flush()
    note_take(session, take, "source_file", {"file": name, "sha256": file.sha256}, by=take.designer_id)
    return file


def remove_source_file(session: Session, actor: Actor, source_file_id: UUID) -> None:
    """Remove a source file, as its designer; raise SourceBankHandedOver once it is the studio's."""
    file, take, access = _file_and_take(session, actor, source_file_id, locked=True)
    ensure_own_designer(access, take)
    if handed_over(session, [take]):
        raise SourceBankHandedOver(
            "this version is approved, and its source files are the studio's",
            fix="add another file beside it",
        )
    note_take(session, take, "source_file_removed", {"file": file.file_name}, by=take.designer_id)
    session.delete(file)
    session.flush()


def visible_source_file(session: Session, actor: Actor, source_file_id: UUID) -> SourceFile:
    """Return a source file within the caller's sight.

    Raises DownloadUnpaid where the contract of its take opens files by payment.
    """
    file, take, access = _file_and_take(session, actor, source_file_id)
    if not _is_shown(access, take, is_handed_over=bool(_of_studio(session, [take]))):
        raise SourceFileNotFound(f"no source file {source_file_id}")
    ensure_open(session, actor, take.cue_id, take.designer_id)
    return file


def copy_bank(session: Session, take: Take, copy: Take) -> None:
    """Give a take that was made from another, fixed or cut, the source bank that made both."""
    there = {file.upload_id for file in queries.source_files(session, [copy.id])[copy.id]}
    copied = ("studio_id", "project_id", "upload_id", "kind", "file_name", "sha256", "file_bytes")
    for file in queries.source_files(session, [take.id])[take.id]:
        if file.upload_id not in there:
            session.add(SourceFile(**{name: getattr(file, name) for name in copied}, take_id=copy.id))
    bank = session.get(SourceBank, take.id)
    if bank is not None and session.get(SourceBank, copy.id) is None:
        copied_facts = {name: getattr(bank, name) for name in ("studio_id", "project_id", "plug_ins", "recipe")}
        session.add(SourceBank(**copied_facts, take_id=copy.id))
    session.flush()


def handed_over(session: Session, takes: Sequence[Take]) -> list[Take]:
    """Return the approved takes whose source banks go to the studio."""
    return _of_studio(session, [take for take in takes if take.state is TakeState.APPROVED])


def read_source_files(files: Sequence[SourceFile]) -> list[SourceFileRead]:
    """Return source files as they are shown."""
    return [SourceFileRead.model_validate(file) for file in files]


def _file_and_take(
    session: Session, actor: Actor, source_file_id: UUID, *, locked: bool = False
) -> tuple[SourceFile, Take, ProjectAccess]:
    not_found = SourceFileNotFound(f"no source file {source_file_id}")
    file = queries.source_file_by_id(session, source_file_id)
    if file is None:
        raise not_found
    try:
        take, access = take_for(session, actor, file.take_id, locked=locked)
    except TakeNotFound:
        raise not_found from None
    return file, take, access


def _of_studio(session: Session, takes: Sequence[Take]) -> list[Take]:
    """Return the takes whose source banks go to the studio: by contract, or as work of an employee of then."""
    if not takes:
        return []
    work = {(take.cue_id, take.designer_id) for take in takes if take.cue_id is not None}
    agreed: dict[tuple[UUID | None, UUID], bool] = {
        key: is_agreed for answer in send(session, SourceFilesAgreed(work)) for key, is_agreed in answer.items()
    }
    employed_since = {
        (engagement.project_id, engagement.designer_id): engagement.kind_since
        for engagement in engagements_of(session, {take.project_id for take in takes})
        if engagement.kind is EngagementKind.IN_HOUSE
    }
    return [
        take
        for take in takes
        if agreed.get((take.cue_id, take.designer_id), _is_made_since(session, take, employed_since))
    ]


def _is_made_since(session: Session, take: Take, employed_since: Mapping[tuple[UUID, UUID], datetime]) -> bool:
    since = employed_since.get((take.project_id, take.designer_id))
    # What the designer made is as old as what a fix or a part is of.
    while since is not None and (made_from_id := take.fix_of_id or take.split_of_id) is not None:
        take = session.get_one(Take, made_from_id)
    return since is not None and take.received_at >= since


def _is_shown(access: ProjectAccess, take: Take, *, is_handed_over: bool) -> bool:
    if access.actor.person_id == take.designer_id:
        return True
    return access.is_team and is_handed_over and take.state is TakeState.APPROVED


def _read(session: Session, access: ProjectAccess, take: Take) -> SourceBankRead:
    is_handed_over = bool(_of_studio(session, [take]))
    read = SourceBankRead(
        take_id=take.id,
        is_shown=_is_shown(access, take, is_handed_over=is_handed_over),
        is_handed_over=is_handed_over,
        plug_ins=[],
        recipe="",
        files=[],
    )
    if read.is_shown:
        bank = session.get(SourceBank, take.id)
        read.plug_ins, read.recipe = (bank.plug_ins, bank.recipe) if bank else ([], "")
        read.files = read_source_files(queries.source_files(session, [take.id])[take.id])
    return read
