"""The jobs of this room: packs put together, stand-ins made."""

import tempfile
from pathlib import Path
from uuid import UUID

from app.builds import packs, placeholders, queries, sealing
from app.builds.rules import FileKind, PackState
from app.kit import kill
from app.kit.errors import Refused
from app.kit.queue import Payload, job
from app.kit.runtime import Runtime
from app.projects.models import Project
from audio_checks import RenderRefused, make_placeholder


@job("builds.seal_pack")
def seal_pack(runtime: Runtime, payload: Payload) -> None:
    """Put a pack together of what is accepted now, and store its key, so that it can be fetched for ever."""
    pack_id = UUID(payload["pack_id"])
    with runtime.database.reading() as session:
        asked = queries.pack_by_id(session, pack_id)
        if asked is None or asked.state is not PackState.SEALING:
            return
        pack = packs.pack_of(session, session.get_one(Project, asked.project_id), asked.target)
        if asked.placeholders:
            pack = placeholders.with_stand_ins(session, pack)
    try:
        files = packs.pack_files(
            runtime.store,
            pack,
            masters=asked.with_masters,
            allow_missing=asked.allow_missing,
            placeholders=asked.placeholders,
        )
    except Refused as error:
        with runtime.database.writing() as session:
            sealing.refuse(session, pack_id, error.message)
        return
    for file in files:
        if file.kind is FileKind.KEY:
            with file.entry.opened() as content:
                runtime.store.put(asked.studio_id, [content.read()])
    kill.point("builds.before_seal")
    with runtime.database.writing() as session:
        sealing.seal(session, pack_id, files)


@job("builds.make_stand_ins")
def make_stand_ins(runtime: Runtime, payload: Payload) -> None:
    """Make what the pack of a target lacks, each on record before the next."""
    target = payload["target"]
    with runtime.database.reading() as session:
        project, slots = placeholders.slots_to_make(session, UUID(payload["project_id"]), target)
    for slot in slots:
        blob, is_spoken, refusal = None, False, ""
        with tempfile.TemporaryDirectory(prefix="soundlist-") as folder:
            try:
                made = make_placeholder(slot.facts, slot.variation, slot.view, Path(folder, "stand_in.wav"))
                blob, is_spoken = runtime.store.put_file(project.studio_id, made.path), made.is_spoken
            except RenderRefused as error:
                refusal = f"{error}; {error.fix}"
        kill.point("builds.before_stand_in")
        with runtime.database.writing() as session:
            placeholders.keep(session, project, target, slot, blob, is_spoken=is_spoken, refusal=refusal)
