"""The job that copies a master with its provenance."""

import tempfile
from pathlib import Path
from uuid import UUID

import structlog

from app.core import kill_points
from app.core.jobs.queue import Payload, job
from app.core.runtime import Runtime
from app.core.storage import BlobAltered, BlobMissing
from app.renders.children import in_child, retried, sandbox
from app.renders.master_exports import service as master_exports
from audio_checks import (
    Exported,
    SandboxFailed,
    Unreadable,
    export_master,
)

log = structlog.get_logger(__name__)
NO_EXPORT = "the copy could not be made; that is our fault; the master is not affected. Try again"


@job("renders.export_master")
def write_provenance(runtime: Runtime, payload: Payload) -> None:
    """Copy a master with what is known of it written into the copy."""
    export_id = UUID(payload["export_id"])
    with runtime.database.reading() as session:
        export_facts = master_exports.to_make(session, export_id)
    if export_facts is None:
        return
    export, master_sha256, provenance = export_facts
    refusal, blob, left = "", None, []
    with tempfile.TemporaryDirectory(prefix="soundlist-") as folder:
        out = Path(folder, "master.wav")
        try:
            with runtime.store.local_copy(export.studio_id, master_sha256) as master:
                made: Exported = retried(
                    in_child(sandbox(), [master], [Path(folder)], export_master, str(master), str(out), provenance)
                )
            blob, left = runtime.store.put_file(export.studio_id, out), list(made.left)
        except Unreadable as error:
            refusal = f"{error}; {error.fix}"
        except (SandboxFailed, BlobAltered, BlobMissing) as error:
            log.error("a master could not be copied", export_id=str(export_id), error=str(error))
            refusal = NO_EXPORT
    kill_points.point("renders.before_export")
    with runtime.database.writing() as session:
        if blob is None:
            master_exports.refuse(session, export_id, refusal)
        else:
            master_exports.keep(session, export_id, blob, left=left)
