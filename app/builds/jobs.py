"""The jobs of this room: packs put together."""

from uuid import UUID

from app.builds import packs, queries, sealing
from app.builds.rules import FileKind, PackState
from app.kit import kill
from app.kit.errors import Refused
from app.kit.queue import Payload, job
from app.kit.runtime import Runtime
from app.projects.models import Project


@job("builds.seal_pack")
def seal_pack(runtime: Runtime, payload: Payload) -> None:
    """Put a pack together of what is accepted now, and store its key, so that it can be fetched for ever."""
    pack_id = UUID(payload["pack_id"])
    with runtime.database.reading() as session:
        asked = queries.pack_by_id(session, pack_id)
        if asked is None or asked.state is not PackState.SEALING:
            return
        pack = packs.pack_of(session, session.get_one(Project, asked.project_id), asked.target)
    try:
        files = packs.pack_files(runtime.store, pack, masters=asked.with_masters, allow_missing=asked.allow_missing)
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
