"""Game files in a codec on the server: rendered as the command line does, heard in the browser, packed and audited."""

import io
import json
import wave
import zipfile
from pathlib import Path
from typing import Any

import pytest

import audio_checks
from audio_checks.cli import main
from tests.app.builds.approved import accepted_list
from tests.app.builds.test_manifests import manifest
from tests.app.builds.test_packs import KEY, download
from tests.support.server import World

pytestmark = pytest.mark.slow

TARGETS = """
[targets.coded]
sample_rate_hz = 44100
encoding = "vorbis"
quality = 0.4
folder = "Assets"
[targets.lossless]
sample_rate_hz = 44100
bit_depth = 16
encoding = "flac"
"""
NAMES = ("laser_fire_01", "laser_fire_02", "ui_confirm")


def set_targets(world: World) -> audio_checks.DeliverySpec:
    """Add two targets in codecs to the spec, and return it."""
    spec = world.producer.get(f"/v1/projects/{world.project_id}/spec").json()
    body = {"toml": spec["toml"] + TARGETS, "based_on_version": spec["version"]}
    saved = world.producer.put(f"/v1/projects/{world.project_id}/spec", json=body)
    assert saved.status_code == 200, saved.text
    target = saved.json()["resolved"]["targets"]["coded"]
    assert (target["encoding"], target["quality"], target["dither"]) == ("vorbis", 0.4, "none")
    return audio_checks.parse_spec(saved.json()["toml"])


def renders(world: World, target: str) -> list[dict[str, Any]]:
    """The game files of the accepted sounds for a target, by cue and variation."""
    listed = world.producer.get(f"/v1/projects/{world.project_id}/game-files", params={"target": target}).json()
    heard = [world.producer.get(f"/v1/takes/{file['take_id']}/sounds").json() for file in listed["files"]]
    return [next(one for one in sound["renders"] if one["target"] == target) for sound in heard]


@pytest.mark.parametrize(("target", "folder", "ending"), [("coded", "Assets/", ".ogg"), ("lossless", "", ".flac")])
def test_the_pack_holds_what_the_check_of_its_target_passes(
    world: World, tmp_path: Path, target: str, folder: str, ending: str
) -> None:
    spec = set_targets(world)
    masters = accepted_list(world)
    paths = [f"{folder}{name}{ending}" for name in NAMES]
    with zipfile.ZipFile(io.BytesIO(download(world, target=target, masters=True))) as archive:
        assert archive.namelist() == [*paths, *(f"masters/{name}.wav" for name in NAMES), *KEY]
        archive.extractall(tmp_path / "pack")
    files = [tmp_path / "pack" / path for path in paths]
    report = audio_checks.check_files(files, spec, target=target)
    assert [(entry.verdict, entry.facts["container"]) for entry in report.files if entry.facts] == (
        [("conforming", ending[1:])] * 3
    )
    # The command line makes the very same files of the very same masters.
    (tmp_path / "spec.toml").write_text(spec.to_toml(), encoding="utf-8")
    for name, master in masters.items():
        (tmp_path / "masters").mkdir(exist_ok=True)
        (tmp_path / "masters" / f"{name}.wav").write_bytes(master)
    made = ["render", "--spec", str(tmp_path / "spec.toml"), "--target", target, "--out", str(tmp_path / "game")]
    assert main([*made, "--no-progress", "-q", str(tmp_path / "masters")]) == 0
    for name, file in zip(NAMES, files, strict=True):
        assert (tmp_path / "game" / target / f"{name}{ending}").read_bytes() == file.read_bytes()


def test_a_coded_file_is_downloaded_as_what_it_is_and_heard_as_wav(world: World) -> None:
    set_targets(world)
    accepted_list(world)
    for target, media_type, ending in (("coded", "audio/ogg", ".ogg"), ("lossless", "audio/flac", ".flac")):
        one = renders(world, target)[0]
        file = world.approver.get(one["file_url"])
        assert (file.status_code, file.headers["content-type"]) == (200, media_type)
        assert f'filename="laser_fire_01{ending}"' in file.headers["content-disposition"]
        assert len(file.content) == one["file_bytes"]
        preview = world.approver.get(one["preview_url"])
        assert preview.headers["content-type"] == "audio/wav"
        with wave.open(io.BytesIO(preview.content)) as sound:
            assert (sound.getframerate(), sound.getnframes()) == (44_100, one["facts"]["frames"])
        assert world.approver.get(one["peaks_url"]).json()["frames"] == one["facts"]["frames"]
        assert world.approver.get(one["spectrum_url"]).status_code == 200
        loss = world.approver.get(f"/v1/renders/{one['id']}/loss").json()
        assert loss["requantisation_dbfs"] < -24  # the sound's own level
        listed = world.producer.get(f"/v1/projects/{world.project_id}/game-files", params={"target": target}).json()
        file = world.producer.get(listed["files"][0]["url"])
        assert (file.status_code, file.headers["content-type"]) == (200, media_type)


def test_the_games_ci_finds_the_coded_files_as_approved(world: World, tmp_path: Path) -> None:
    set_targets(world)
    accepted_list(world)
    world.server.wait_for_jobs()
    with zipfile.ZipFile(io.BytesIO(download(world, target="coded"))) as archive:
        archive.extractall(tmp_path)
    for name in KEY:
        (tmp_path / name).unlink()
    approved = manifest(world, target="coded")
    (tmp_path / "approved.json").write_text(json.dumps(approved), encoding="utf-8")
    built = audio_checks.fingerprint_files([(str(tmp_path / one["path"]), one["path"]) for one in approved["files"]])
    found = audio_checks.audit_build(audio_checks.read_manifest(tmp_path / "approved.json"), built).to_dict()
    assert [one["status"] for one in found["files"]] == ["same"] * 3


def test_key_and_memory_say_what_a_codec_has(world: World) -> None:
    set_targets(world)
    accepted_list(world)
    with zipfile.ZipFile(io.BytesIO(download(world, target="coded"))) as archive:
        rows = archive.read("documentation-key.csv").decode("utf-8-sig").splitlines()
    assert "Assets/laser_fire_01.ogg" in rows[1]
    assert ",44100,,1," in rows[1]  # a rate, no depth, mono
    targets = world.producer.get(f"/v1/projects/{world.project_id}/targets").json()["targets"]
    coded = next(target for target in targets if target["name"] == "coded")
    assert coded["quality"] == 0.4
    assert coded["used"]["total"]["pcm_bytes"] == 3 * 11_025 * 2  # as 16 bit, which it is decoded to


def test_a_placeholder_for_the_game_is_in_its_codec(world: World, tmp_path: Path) -> None:
    spec = set_targets(world)
    accepted_list(world)
    made = world.producer.post(f"/v1/projects/{world.project_id}/placeholders", json={"target": "coded"})
    assert made.status_code in (200, 202), made.text
    world.server.wait_for_jobs()
    with zipfile.ZipFile(io.BytesIO(download(world, target="coded", placeholders=True, handoff="godot"))) as archive:
        archive.extractall(tmp_path)
        assert 'importer="oggvorbisstr"' in archive.read("Assets/ui_confirm.ogg.import").decode()
    entry = audio_checks.check_file(tmp_path / "Assets" / "warp_in.ogg", spec, target="coded")
    assert [finding.code for finding in entry.findings if finding.severity == "error"] == ["placeholder:marked"]
