"""Walks from upload to pack on a server without the commercial rooms; a process of its own, for its one worker."""

import io
import json
import sys
import zipfile
from pathlib import Path
from typing import Any

from app.core.jobs.queue import job_names
from tests.app.builds.approved import accepted_list
from tests.support.server import World, run_server


def walk(folder: Path) -> dict[str, Any]:
    """Upload, check, approve and pack; return what came of it, and what the server is without."""
    with run_server(folder, commercial=False) as server:
        world = World(server)
        masters = accepted_list(world)  # each was checked and rendered, and has its verdict
        pack = world.producer.get(f"/v1/projects/{world.project_id}/pack.zip", params={"target": "game"})
        with zipfile.ZipFile(io.BytesIO(pack.content)) as archive:
            packed = [name for name in archive.namelist() if name.endswith(".wav")]
        me = world.producer.get("/v1/me").json()
        refused = world.producer.get(f"/v1/projects/{world.project_id}/contracts")
        return {
            "masters": sorted(masters),
            "packed": packed,
            "has_contracts": me["has_contracts"],
            "contracts_status": refused.status_code,
            "paths": sorted(server.application.openapi()["paths"]),
            "job_rooms": sorted({name.partition(".")[0] for name in job_names()}),
        }


if __name__ == "__main__":
    print("\n" + json.dumps(walk(Path(sys.argv[1]))))  # noqa: T201
