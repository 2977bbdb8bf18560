"""The demo game's CI: checks its files, audits its project of Wwise, and posts both reports by its token."""

import io
import json
import tempfile
import zipfile
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

import httpx

import audio_checks
from app.demo.sounds import DemoSound
from app.demo.wwise_game import audit_game, commit_game, write_game

Ask = Callable[..., Any]  # sends a request as the producer, and returns the body


class GameCi:
    """One project's CI."""

    def __init__(self, base_url: str, project: str, token: str) -> None:
        self._address = f"{base_url}/v1/projects/{project}"
        self._path = f"/projects/{project}"
        self._headers = {"Authorization": f"Bearer {token}"}

    def build(self, label: str, ask: Ask, *, strays: Iterable[DemoSound] = ()) -> None:
        """Check the approved pack and added files, and post the report; one that was posted stays."""
        if label in self._posted("build", ask):
            return
        with tempfile.TemporaryDirectory() as folder:
            assets = Path(folder) / "assets"
            with zipfile.ZipFile(io.BytesIO(ask("GET", f"{self._path}/pack.zip?target=game"))) as pack:
                pack.extractall(assets)
            for stray in strays:
                stray.write(assets)
            files = sorted(assets.rglob("*.wav"))
            spec = audio_checks.parse_spec(ask("GET", f"{self._path}/spec.toml").decode())
            sounds = audio_checks.read_sound_list(ask("GET", f"{self._path}/sound-list.csv").decode())
            report = audio_checks.check_files(files, spec, target="game", sound_list=sounds).to_dict()
            for file in report["files"]:
                file["path"] = str(Path(file["path"]).relative_to(folder))
        self._post("build", label, report)

    def has_manifest(self) -> bool:
        """Whether everything that was approved is fingerprinted."""
        return httpx.get(f"{self._address}/manifest.json?target=game", headers=self._headers, timeout=60).is_success

    def audit(self, ask: Ask, builds: Mapping[str, Mapping[str, float]]) -> None:
        """Audit the game's project as it was in each build, by the volumes of its sets in dB, and post the reports."""
        posted = self._posted("audit", ask)
        with tempfile.TemporaryDirectory() as folder:
            manifest = Path(folder, "manifest.json")
            manifest.write_text(json.dumps(ask("GET", f"{self._path}/manifest.json?target=game")))
            with zipfile.ZipFile(io.BytesIO(ask("GET", f"{self._path}/pack.zip?target=game"))) as pack:
                sounds = {Path(name).name: pack.read(name) for name in pack.namelist() if name.endswith(".wav")}
            for label, volumes_db in builds.items():
                project = write_game(Path(folder, "game"), sounds, volumes_db)
                commit_game(project.parent, "Raise the footsteps" if volumes_db else "Play the approved sounds")
                if label not in posted:
                    self._post("audit", label, audit_game(manifest, project))

    def _posted(self, what: str, ask: Ask) -> set[str]:
        return {posted["label"] for posted in ask("GET", f"{self._path}/{what}s")["items"]}

    def _post(self, what: str, label: str, report: Mapping[str, Any]) -> None:
        body = {"label": label, "commit": "", "target": "game", "report": report}
        httpx.post(f"{self._address}/{what}s", json=body, headers=self._headers, timeout=60).raise_for_status()
