"""The client as one file, fetched from the server and run as a game team runs it."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from app.client.source_control import program
from tests.app.builds.test_builds import token
from tests.app.client.served import PATHS, Client, files_in
from tests.support.server import World


@pytest.mark.slow
def test_the_program_pulls_without_anything_installed(client: Client, game: Path, tmp_path: Path) -> None:
    secret = os.environ["SOUNDLIST_TOKEN"]
    url = f"http://127.0.0.1:{client.port}/v1/projects/{client.world.project_id}/soundlist.pyz"
    fetched = [program("curl"), "-fsS", "-o", "soundlist.pyz", "-H", f"Authorization: Bearer {secret}", url]
    subprocess.run(fetched, cwd=tmp_path, check=True)
    (game / "app").mkdir()
    (game / "app" / "__init__.py").write_text("raise SystemExit('a module of the game was imported')")
    environment = {"PATH": os.environ["PATH"], "SOUNDLIST_TOKEN": secret}
    pull = [sys.executable, "-I", "-S", str(tmp_path / "soundlist.pyz"), "pull", *client.source]
    done = subprocess.run(pull, cwd=game, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert set(PATHS) < set(files_in(game))
    why = [sys.executable, str(tmp_path / "soundlist.pyz"), "why", "ui_confirm", *client.source]
    done = subprocess.run(why, cwd=game, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "Audio director" in done.stdout


@pytest.mark.parametrize(("who", "status"), [("stranger", 404), ("designer", 403), ("reviewer", 200), ("nobody", 401)])
def test_who_fetches_it(approved: World, who: str, status: int) -> None:
    answer = getattr(approved, who).get(f"/v1/projects/{approved.project_id}/soundlist.pyz")
    assert answer.status_code == status


def test_a_build_fetches_it_by_the_scope_of_packs(approved: World) -> None:
    url = f"/v1/projects/{approved.project_id}/soundlist.pyz"
    assert [token(approved, one).get(url).status_code for one in ("manifest:read", "list:read")] == [200, 403]
