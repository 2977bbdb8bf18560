"""A pack without import files is a plain folder: unpacked, each file has its path and the bytes of its game file."""

import hashlib
import io
import zipfile
from pathlib import Path

import pytest

from tests.app.builds.approved import accepted_list
from tests.app.builds.test_packs import KEY, download
from tests.support.server import World

pytestmark = pytest.mark.slow


def test_unpacked_it_is_the_folder_that_the_list_of_game_files_says(world: World, tmp_path: Path) -> None:
    accepted_list(world)
    with zipfile.ZipFile(io.BytesIO(download(world))) as archive:
        archive.extractall(tmp_path)
    found = {
        path.relative_to(tmp_path).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in tmp_path.rglob("*")
        if path.is_file()
    }
    listed = world.producer.get(f"/v1/projects/{world.project_id}/game-files", params={"target": "game"}).json()[
        "files"
    ]
    assert listed
    assert found.keys() == {one["path"] for one in listed} | set(KEY)
    for one in listed:
        assert found[one["path"]] == one["sha256"]
        assert (tmp_path / one["path"]).read_bytes() == world.producer.get(one["url"]).content
    sums = (tmp_path / "SHA256SUMS").read_text().splitlines()
    assert {line.partition("  ")[2]: line[:64] for line in sums}.items() <= found.items()
