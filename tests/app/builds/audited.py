"""Audits of builds as a game's CI posts them: the real audit of a small project of Wwise."""

import io
import json
import zipfile
from pathlib import Path
from typing import Any

from app.demo.wwise_game import audit_game, write_game
from tests.app.builds.approved import accepted_list
from tests.support.server import World


def approved_pack(world: World) -> dict[str, bytes]:
    """Approve two cues of three, and return their game files by name."""
    accepted_list(world)
    answer = world.producer.get(f"/v1/projects/{world.project_id}/pack.zip", params={"target": "game"})
    assert answer.status_code == 200, answer.text
    with zipfile.ZipFile(io.BytesIO(answer.content)) as pack:
        return {Path(name).name: pack.read(name) for name in pack.namelist() if name.endswith(".wav")}


def audited(world: World, folder: Path, sounds: dict[str, bytes], **volumes_db: float) -> dict[str, Any]:
    """Return the report of an audit of a game that plays these sounds."""
    manifest = world.producer.get(f"/v1/projects/{world.project_id}/manifest.json", params={"target": "game"})
    assert manifest.status_code == 200, manifest.text
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "manifest.json").write_text(json.dumps(manifest.json()))
    return audit_game(folder / "manifest.json", write_game(folder / "game", sounds, volumes_db))


def post(world: World, report: dict[str, Any], label: str = "1", *, by: Any = None) -> Any:
    """Post a report as CI does."""
    body = {"label": label, "commit": "abc123", "target": "game", "report": report}
    return (by or world.producer).post(f"/v1/projects/{world.project_id}/audits", json=body)


def posted(world: World, report: dict[str, Any], label: str = "1") -> dict[str, Any]:
    """Post a report and return its summary."""
    answer = post(world, report, label)
    assert answer.status_code == 201, answer.text
    summary: dict[str, Any] = answer.json()
    return summary


def sounds_of(world: World, audit: dict[str, Any], **query: Any) -> dict[str, dict[str, Any]]:
    """Return what an audit says of each sound, by the file's name."""
    answer = world.producer.get(f"/v1/audits/{audit['id']}/sounds", params=query)
    assert answer.status_code == 200, answer.text
    return {one["path"].rpartition("/")[2]: one for one in answer.json()["items"]}
