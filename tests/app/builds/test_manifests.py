"""The manifest of approved sounds: what the game's CI compares its build with, whole or refused."""

import hashlib
import io
import json
import re
import subprocess
import sys
import threading
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema_rs
import numpy as np
import pytest
import sqlalchemy as sa
from httpx import Response

import audio_checks
from app.builds.models import Fingerprint
from app.builds.packs import manifests
from app.core.jobs import queue
from audio_checks.audit.manifest import schema
from benchmarks.plans import heard, whole_reads
from tests.app.builds.approved import accepted_list, approve, sound
from tests.app.builds.test_builds import token
from tests.app.builds.test_sealed_packs import SOUNDS, seal
from tests.app.test_plans import planning
from tests.support.blobs import blob_file
from tests.support.deliver import add_cues, deliver
from tests.support.server import World
from tests.support.waiting import until

pytestmark = pytest.mark.slow


def ask(world: World, **params: Any) -> Response:
    answer: Response = world.producer.get(
        f"/v1/projects/{world.project_id}/manifest.json", params={"target": "game"} | params
    )
    return answer


def manifest(world: World, **params: Any) -> dict[str, Any]:
    answer = ask(world, **params)
    assert answer.status_code == 200, answer.text
    reported: dict[str, Any] = answer.json()
    return reported


def pack(world: World, **params: Any) -> zipfile.ZipFile:
    answer = world.producer.get(f"/v1/projects/{world.project_id}/pack.zip", params={"target": "game"} | params)
    assert answer.status_code == 200, answer.text
    return zipfile.ZipFile(io.BytesIO(answer.content))


def kept(world: World) -> dict[str, int]:
    """What the studio's sounds were heard by: the version, by sound."""
    find = sa.select(Fingerprint.sound_sha256, Fingerprint.fingerprint_version).where(
        Fingerprint.studio_id == world.studio_id
    )
    found: dict[str, int] = world.server.in_database(lambda session: dict(session.execute(find).all()))
    return found


def forget(world: World) -> None:
    """Be as a server that approved takes before it made manifests."""
    of_studio = sa.delete(Fingerprint).where(Fingerprint.studio_id == world.studio_id)
    world.server.in_database(lambda session: session.execute(of_studio))


def jobs_for(world: World, name: str) -> list[tuple[str, str]]:
    """The urgency and state of each job of that name and studio."""
    schema_name = None if world.server.runtime.database.is_sqlite else "dbos"
    columns = [sa.column(one, sa.Text) for one in ("queue_partition_key", "status", "workflow_uuid")]
    jobs = sa.table("workflow_status", *columns, sa.column("attributes", sa.JSON), schema=schema_name)
    find = sa.select(jobs.c.queue_partition_key, jobs.c.status).where(
        jobs.c.queue_partition_key.startswith(str(world.studio_id)),
        sa.cast(jobs.c.attributes, sa.Text).contains(name),
    )
    rows: list[Any] = world.server.in_database(lambda session: session.execute(find).all())
    return [(lane.rpartition(":")[2], status) for lane, status in rows]


def test_it_lists_the_files_of_the_pack_and_what_each_is_known_by(world: World, tmp_path: Path) -> None:
    accepted_list(world)
    reported = manifest(world)
    jsonschema_rs.validate(schema(), reported)
    with pack(world) as archive:
        archive.extractall(tmp_path)
    (tmp_path / "manifest.json").write_text(json.dumps(reported))
    approved = audio_checks.read_manifest(tmp_path / "manifest.json")
    assert [one.path for one in approved] == SOUNDS
    assert [one.cue for one in approved] == ["1", "1", "2"]
    takes = {take["id"] for take in world.producer.get(f"/v1/projects/{world.project_id}/takes").json()["items"]}
    assert len({one.take for one in approved}) == 3
    assert {one.take for one in approved} == takes
    listened = audio_checks.fingerprint_files([(str(tmp_path / name), name) for name in SOUNDS])
    assert [{**audio_checks.manifest_entry(one), "cue": None, "take": None} for one in approved] == [
        audio_checks.manifest_entry(one) for one in listened
    ]
    assert all(one.fingerprint for one in approved)


def test_approval_has_game_files_listened_to_once_and_before_any_request(world: World) -> None:
    accepted_list(world)
    assert len(kept(world)) == 6  # three sounds for two targets
    assert jobs_for(world, "builds.fingerprint_take") == [("100", "SUCCESS")] * 3
    assert jobs_for(world, "builds.fingerprint_pack") == []
    assert (len(manifest(world)["files"]), len(manifest(world, target="handheld")["files"])) == (3, 3)
    assert jobs_for(world, "builds.fingerprint_pack") == []


def test_a_take_that_is_not_approved_is_not_listened_to(world: World) -> None:
    add_cues(world, {"name": "UI confirm"})
    deliver(world, "ui_confirm.wav", sound(3))
    world.server.wait_for_jobs()
    assert kept(world) == {}
    assert manifest(world)["files"] == []


def test_what_was_approved_before_is_listened_to_when_it_is_asked_for(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    accepted_list(world)
    forget(world)
    monkeypatch.setattr(manifests, "REQUEST_AGAIN_AFTER_S", 10**10)  # however long this takes
    asked_twice = threading.Event()
    listening_in_child(monkeypatch, lambda _: asked_twice.wait(60))
    for _ in range(2):
        refused = ask(world)
        assert (refused.status_code, refused.headers["content-type"]) == (409, "application/problem+json")
        said = refused.json()
        assert (said["code"], refused.headers["retry-after"]) == ("manifest-not-ready", "5")
        assert said["detail"].startswith("3 of 3 approved sounds")
        assert "5 seconds" in said["fix"]
    asked_twice.set()
    world.server.wait_for_jobs()
    assert [one["path"] for one in manifest(world)["files"]] == SOUNDS
    assert len(kept(world)) == 3  # nobody asked for the other target
    assert jobs_for(world, "builds.fingerprint_pack") == [("10", "SUCCESS")]


def test_masters_analysed_by_another_version_are_analysed_again(world: World) -> None:
    accepted_list(world)
    before = manifest(world)
    older = sa.update(Fingerprint).where(Fingerprint.studio_id == world.studio_id)
    world.server.in_database(lambda session: session.execute(older.values(fingerprint_version=0, entry={"old": 1})))
    assert ask(world).status_code == 409
    world.server.wait_for_jobs()
    assert manifest(world) == before
    assert sorted(kept(world).values()) == [0, 0, 0, 1, 1, 1]


def test_rerendered_game_files_are_analysed(world: World) -> None:
    accepted_list(world)
    before = manifest(world)
    spec = world.producer.get(f"/v1/projects/{world.project_id}/spec").json()
    toml = re.sub(r"(\[targets\.game\][^\n]*\nsample_rate_hz = )44100", r"\g<1>32000", spec["toml"])
    body = {"toml": toml, "based_on_version": spec["version"]}
    assert world.producer.put(f"/v1/projects/{world.project_id}/spec", json=body).status_code == 200
    world.server.wait_for_jobs()
    assert ask(world).status_code == 409
    world.server.wait_for_jobs()
    after = manifest(world)
    assert {one["sample_rate_hz"] for one in after["files"]} == {32_000}
    assert [one["take"] for one in after["files"]] == [one["take"] for one in before["files"]]


def test_an_accepted_sound_without_a_game_file_is_never_left_out_unsaid(world: World) -> None:
    accepted_list(world)
    spec = world.producer.get(f"/v1/projects/{world.project_id}/spec").json()
    toml = spec["toml"] + "\n[targets.film]\nsample_rate_hz = 48000\nbit_depth = 24\n"
    body = {"toml": toml, "based_on_version": spec["version"]}
    assert world.producer.put(f"/v1/projects/{world.project_id}/spec", json=body).status_code == 200
    world.server.wait_for_jobs()
    refused = ask(world, target="film")
    assert (refused.status_code, refused.json()["code"]) == (409, "pack-incomplete")
    assert manifest(world, target="film", allow_missing=True)["files"] == []
    assert ask(world, target="toaster").json()["code"] == "target-unknown"


def test_a_sealed_pack_has_the_manifest_of_what_was_sealed(world: World) -> None:
    accepted_list(world)
    sealed = seal(world, masters=True, placeholders=True)
    then = manifest(world)
    take = deliver(world, "ui_confirm.wav", sound(77))
    world.server.wait_for_jobs()
    assert world.approver.post(f"/v1/takes/{take['id']}/verdict", json={"kind": "approve"}).status_code == 200
    world.server.wait_for_jobs()
    assert [one["take"] for one in manifest(world)["files"]][2] == take["id"]
    url = f"/v1/packs/{sealed['id']}/manifest.json"
    assert world.reviewer.get(url).json() == then
    forget(world)
    refused = world.reviewer.get(url)
    assert (refused.status_code, refused.json()["code"]) == (409, "manifest-not-ready")
    world.server.wait_for_jobs()
    assert world.reviewer.get(url).json() == then


def test_a_pack_that_was_not_sealed_has_none(world: World) -> None:
    accepted_list(world)
    with pack(world) as archive:
        sha256 = hashlib.sha256(archive.read(SOUNDS[0])).hexdigest()
    blob = blob_file(world.server.runtime.store, world.studio_id, sha256)
    blob.unlink()
    refused = world.reviewer.get(f"/v1/packs/{seal(world)['id']}/manifest.json")
    assert (refused.status_code, refused.json()["code"]) == (409, "pack-not-sealed")
    assert len(manifest(world)["files"]) == 3  # which was heard before the file was lost
    forget(world)
    lost = ask(world)
    assert (lost.status_code, lost.json()["code"]) == (500, "blob-damaged")


def test_studios_share_nothing(world: World) -> None:
    other = World(world.server)
    for one in (world, other):
        approve(one, add_cues(one, {"name": "UI confirm"}))
    (ours,), (theirs,) = manifest(world)["files"], manifest(other)["files"]
    assert ours["fingerprint"] == theirs["fingerprint"]
    assert ours["take"] != theirs["take"]
    forget(world)
    assert (ask(world).status_code, ask(other).status_code) == (409, 200)


@pytest.mark.parametrize(
    ("who", "status"), [("stranger", 404), ("other_designer", 404), ("designer", 403), ("nobody", 401)]
)
def test_who_may_not(world: World, who: str, status: int) -> None:
    accepted_list(world)
    sealed = seal(world)
    client = getattr(world, who)
    assert client.get(f"/v1/projects/{world.project_id}/manifest.json").status_code == status
    assert client.get(f"/v1/packs/{sealed['id']}/manifest.json").status_code == status


def test_a_build_fetches_it_by_its_token(world: World) -> None:
    accepted_list(world)
    urls = (f"/v1/projects/{world.project_id}/manifest.json", f"/v1/packs/{seal(world)['id']}/manifest.json")
    build, other = token(world, "manifest:read"), token(world, "list:read", "spec:read", "checks:write")
    elsewhere = token(World(world.server), "manifest:read")
    for url in urls:
        assert [one.get(url).status_code for one in (build, other, elsewhere)] == [200, 403, 404]
    forget(world)
    assert build.get(urls[0]).status_code == 409
    world.server.wait_for_jobs()
    assert build.get(urls[0]).status_code == 200


def listening_in_child(monkeypatch: pytest.MonkeyPatch, before: Callable[[list[str]], object]) -> list[str]:
    """Have something happen before a child listens to a sound; return the sounds, as they come."""
    call = audio_checks.SandboxChild.call
    given: list[str] = []

    def listened(child: audio_checks.SandboxChild, work: Any, *args: Any, **options: Any) -> Any:
        if work is audio_checks.fingerprint_files:
            given.append(args[0][0][1])
            before(given)
        return call(child, work, *args, **options)

    monkeypatch.setattr(audio_checks.SandboxChild, "call", listened)
    return given


def die_first(given: list[str]) -> None:
    if len(given) == 1:
        raise audio_checks.SandboxCrashed("the child was killed by signal 9")


def until_ready(world: World) -> None:
    until(lambda: ask(world).status_code == 200)


def test_a_child_that_dies_holds_up_no_other_sound_and_is_retried(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    accepted_list(world)
    forget(world)
    monkeypatch.setattr(queue, "RETRY_DELAYS_S", (0.01,))
    given = listening_in_child(monkeypatch, die_first)
    assert ask(world).status_code == 409
    until_ready(world)
    assert len(given) == 4
    assert given[3] == given[0]


def test_a_sound_that_cannot_be_listened_to_parks_its_job(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    accepted_list(world)
    forget(world)
    monkeypatch.setattr(queue, "RETRY_DELAYS_S", ())
    with monkeypatch.context() as patched:
        given = listening_in_child(patched, die_first)
        assert ask(world).status_code == 409
        world.server.wait_for_jobs()
        assert len(given) == 3
    assert "1 of 3" in ask(world).json()["detail"]
    (job,) = world.server.runtime.queue.unfinished(only_failed=True, studio_id=world.studio_id)
    assert (job.name, job.state) == ("builds.fingerprint_pack", "parked")
    assert "signal 9" in str(job.reason)
    assert world.server.runtime.queue.retry(job.id)
    until_ready(world)


def test_it_is_read_by_an_index(world: World) -> None:
    accepted_list(world)
    engine = world.server.runtime.database.engine
    with heard(engine) as statements:
        manifest(world)
    asked = [each for each in statements if "FROM builds_fingerprints" in each[0]]
    assert len(asked) == 2
    with planning(engine) as connection:
        assert not any(whole_reads(connection, each, {"builds_fingerprints"}) for each in asked)


def test_an_audit_of_the_pack_says_all_the_same_and_names_what_was_raised(world: World, tmp_path: Path) -> None:
    accepted_list(world)
    build = tmp_path / "build"
    with pack(world) as archive:
        archive.extractall(build)
    (tmp_path / "manifest.json").write_bytes(ask(world).content)

    def audit() -> tuple[int, dict[str, Any]]:
        program = Path(sys.executable).parent / "audio-checks"
        command = [program, "audit", "--manifest", "manifest.json", "--format", "json", "build"]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, timeout=300)
        reported: dict[str, Any] = json.loads(done.stdout)
        return done.returncode, {one["path"]: one for one in reported["files"]}

    code, files = audit()
    assert (code, [file["status"] for file in files.values()]) == (0, ["same"] * 3)
    raise_by_3_db(build / SOUNDS[2])
    code, files = audit()
    assert (code, files[SOUNDS[0]]["status"], files[SOUNDS[2]]["status"]) == (1, "same", "gain")
    assert files[SOUNDS[2]]["gain_db"] == pytest.approx(3.0, abs=0.05)
    (take,) = {one["take"] for one in manifest(world)["files"] if one["path"] == SOUNDS[2]}
    assert [(file["cue"], file["take"]) for file in files[SOUNDS[2]]["matches"]] == [("2", take)]


def raise_by_3_db(path: Path) -> None:
    content = path.read_bytes()
    start = content.index(b"data") + 8
    samples = np.frombuffer(content[start:], "<i2") * 10 ** (3 / 20)
    assert np.abs(samples).max() < 32_767
    path.write_bytes(content[:start] + np.round(samples).astype("<i2").tobytes())
