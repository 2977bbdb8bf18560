"""Game files of real takes, made by the real worker."""

import hashlib
import io
import wave
from collections.abc import Callable
from pathlib import Path
from typing import Any
from uuid import UUID

import pytest
from sqlalchemy import func, select, update
from sqlalchemy.orm import Session, joinedload

import audio_checks
from app.core import kill_points
from app.core.db import new_id
from app.core.jobs.queue import workflows
from app.deliveries.models import Take
from app.projects.models import Spec
from app.projects.queries import current_spec
from app.renders import drawing, queries, service, take_jobs
from app.renders.models import Picture, Render, RenderSet
from app.sound_lists.models import Cue
from tests.app.renders.making import add_cue, deliver_sound
from tests.support.server import RunningServer, World
from tests.support.waves import sine


def sounds(world: World, take_id: str) -> dict[str, Any]:
    answer = world.designer.get(f"/v1/takes/{take_id}/sounds")
    assert answer.status_code == 200, answer.text
    body: dict[str, Any] = answer.json()
    return body


def count(server: RunningServer, *where: Any) -> int:
    found: int = server.in_database(lambda session: session.scalar(select(func.count()).where(*where)))
    return found


@pytest.mark.slow
def test_a_conforming_take_gets_a_game_file_for_each_target(world: World) -> None:
    add_cue(world, "laser")
    take_id = deliver_sound(world, "laser.wav", sine(hz=997, dbfs=-6, rate=96_000, channels=2, seconds=0.5))
    heard = sounds(world, take_id)
    assert heard["master"]["state"] == "drawn"
    assert heard["master"]["facts"]["sample_rate_hz"] == 96_000
    game, handheld = heard["renders"]
    assert [(one["target"], one["state"], one["refusal"]) for one in (game, handheld)] == [
        ("game", "made", None),
        ("handheld", "made", None),
    ]
    for one, rate, channels in ((game, 44_100, 2), (handheld, 22_050, 1)):
        file = world.approver.get(one["file_url"])
        assert file.status_code == 200
        assert 'filename="laser.wav"' in file.headers["content-disposition"]
        assert len(file.content) == one["file_bytes"]
        with wave.open(io.BytesIO(file.content)) as sound:
            assert (sound.getframerate(), sound.getnchannels(), sound.getsampwidth()) == (rate, channels, 2)
            assert sound.getnframes() == rate // 2
        # A tone that both sides share keeps its level, and 0 dB of it is taken away.
        assert one["measurements"]["sample_peak_dbfs"] == pytest.approx(-6.0, abs=0.05)
        assert one["attenuation_db"] == 0


@pytest.mark.slow
def test_a_target_above_the_master_is_refused_with_a_reason(world: World) -> None:
    add_spec(world, "[targets.trailer]\nsample_rate_hz = 48000\nbit_depth = 24\n")
    add_cue(world, "beep")
    take_id = deliver_sound(world, "beep.wav", sine(hz=997, rate=44_100, seconds=0.2), rate=44_100, bits=16)
    by_target = {sound["target"]: sound for sound in sounds(world, take_id)["renders"]}
    assert by_target["game"]["state"] == "made"
    trailer = by_target["trailer"]
    assert trailer["state"] == "refused"
    assert "48000 Hz" in trailer["refusal"]
    assert "44100 Hz" in trailer["refusal"]
    assert trailer["preview_url"] is None
    assert trailer["file_url"] is None
    answer = world.designer.get(f"/v1/renders/{trailer['id']}/file")
    assert (answer.status_code, answer.json()["code"]) == (409, "nothing-rendered")


@pytest.mark.slow
def test_a_returned_take_is_drawn_and_not_rendered(world: World) -> None:
    add_cue(world, "hit")
    take_id = deliver_sound(world, "hit.wav", sine(hz=997, dbfs=0, rate=96_000, seconds=0.2))
    heard = sounds(world, take_id)
    assert heard["master"]["state"] == "drawn"
    assert {one["state"] for one in heard["renders"]} == {"waiting"}


def add_spec(world: World, toml_end: str) -> None:
    """Save a new version of the spec, as the producer does, and let the jobs that it asks for run."""
    now = world.producer.get(f"/v1/projects/{world.project_id}/spec").json()
    saved = world.producer.put(
        f"/v1/projects/{world.project_id}/spec",
        json={"toml": now["toml"] + toml_end, "note": "", "based_on_version": now["version"]},
    )
    assert saved.status_code == 200, saved.text
    world.server.wait_for_jobs()


@pytest.mark.slow
def test_a_new_spec_adds_renders_and_keeps_the_old_ones(world: World) -> None:
    add_cue(world, "beep")
    take_id = deliver_sound(world, "beep.wav", sine(hz=997, rate=96_000, seconds=0.2))
    before = {sound["target"]: sound["id"] for sound in sounds(world, take_id)["renders"]}
    add_spec(world, "[targets.trailer]\nsample_rate_hz = 48000\nbit_depth = 24\n")
    after = {sound["target"]: sound["id"] for sound in sounds(world, take_id)["renders"]}
    assert after.keys() == {"game", "handheld", "trailer"}
    assert {target: after[target] for target in before} == before
    now = world.producer.get(f"/v1/projects/{world.project_id}/spec").json()
    louder = now["toml"].replace("sample_rate_hz = 22050", "sample_rate_hz = 32000")
    body = {"toml": louder, "note": "", "based_on_version": now["version"]}
    assert world.producer.put(f"/v1/projects/{world.project_id}/spec", json=body).status_code == 200
    world.server.wait_for_jobs()
    renewed = {sound["target"]: sound for sound in sounds(world, take_id)["renders"]}
    assert renewed["handheld"]["id"] != before["handheld"]
    assert renewed["handheld"]["facts"]["sample_rate_hz"] == 32_000
    assert renewed["game"]["id"] == before["game"]
    assert world.designer.get(f"/v1/renders/{before['handheld']}/file").status_code == 200


@pytest.mark.slow
def test_an_approved_take_is_renewed_too(world: World) -> None:
    add_cue(world, "beep")
    take_id = deliver_sound(world, "beep.wav", sine(hz=997, rate=96_000, seconds=0.2))
    assert world.approver.post(f"/v1/takes/{take_id}/verdict", json={"kind": "approve"}).status_code == 200
    add_spec(world, "[targets.trailer]\nsample_rate_hz = 48000\nbit_depth = 24\n")
    assert {sound["target"]: sound["state"] for sound in sounds(world, take_id)["renders"]}["trailer"] == "made"


@pytest.mark.slow
def test_jobs_that_run_twice_change_nothing(world: World) -> None:
    add_cue(world, "beep")
    take_id = deliver_sound(world, "beep.wav", sine(hz=997, rate=96_000, seconds=0.2))
    before = sounds(world, take_id)
    take_jobs.make_renders(world.server.runtime, {"take_id": take_id})
    assert sounds(world, take_id) == before
    assert count(world.server, Render.take_id == UUID(take_id)) == 2
    # Of the master and of two game files.
    assert count(world.server, Picture.studio_id == world.studio_id) == 3
    for picture in world.server.in_database(
        lambda session: session.scalars(select(Picture).where(Picture.studio_id == world.studio_id)).all()
    ):
        hashes = (picture.peaks_sha256, picture.spectrum_sha256, picture.preview_sha256, picture.light_sha256)
        drawn = set(hashes) - {picture.sound_sha256, None}
        sizes = world.server.runtime.store.sizes_bytes(picture.studio_id, drawn)
        assert picture.drawn_bytes == sum(sizes.values()) > 0


def test_a_game_file_that_two_workers_made_is_kept_once(world: World) -> None:
    add_cue(world, "beep")
    take_id = UUID(deliver_sound(world, "beep.wav", sine(hz=997, rate=96_000, seconds=0.2)))
    with world.server.runtime.database.writing() as session:
        made = session.scalars(select(Render).where(Render.take_id == take_id)).all()
        facts = ("studio_id", "project_id", "take_id", "target", "key", "state", "sha256")
        again = [Render(**{name: getattr(one, name) for name in facts}) for one in made]
        service.save_renders(session, [(one, None) for one in again])
    assert count(world.server, Render.take_id == take_id) == len(made) == 2


@pytest.mark.slow
def test_the_same_master_gives_the_same_bytes(world: World) -> None:
    add_cue(world, "one")
    add_cue(world, "two")
    samples = sine(hz=997, rate=96_000, seconds=0.2)
    first, second = (deliver_sound(world, f"{name}.wav", samples) for name in ("one", "two"))
    files = [
        [
            hashlib.sha256(world.designer.get(sound["file_url"]).content).hexdigest()
            for sound in sounds(world, take)["renders"]
        ]
        for take in (first, second)
    ]
    assert files[0] == files[1]


def add_newer_spec(session: Session, world: World) -> None:
    toml = audio_checks.new_spec("48k", name="newer")
    session.add(
        Spec(
            studio_id=world.studio_id,
            project_id=world.project_id,
            version=2,
            toml=toml,
            sha256=audio_checks.parse_spec(toml).sha256,
            created_by=world.producer_id,
        )
    )


def make_it_loop(session: Session, world: World) -> None:
    session.execute(update(Cue).where(Cue.project_id == world.project_id).values(loop=True))


@pytest.mark.slow
@pytest.mark.parametrize("move_on", [add_newer_spec, make_it_loop])
def test_what_moves_on_between_check_and_game_files_is_followed(
    world: World, monkeypatch: pytest.MonkeyPatch, move_on: Callable[[Session, World], None]
) -> None:
    add_cue(world, "beep")
    moved: list[str] = []

    def move(point: str) -> None:
        if point == "conformance.after_check" and not moved:
            moved.append(point)
            world.server.in_database(lambda session: move_on(session, world))

    monkeypatch.setattr(kill_points, "point", move)
    take_id = UUID(deliver_sound(world, "beep.wav", sine(hz=997, rate=96_000, seconds=0.2)))
    assert moved
    with world.server.runtime.database.reading() as session:
        take = session.get_one(Take, take_id, options=[joinedload(Take.cue)])
        spec = current_spec(session, world.project_id)
        stands = queries.current_renders(session, {world.project_id: spec}, [take])[take_id]
        assert stands
        assert all(stands.values())
        assert session.get_one(RenderSet, take_id).spec_id == spec.id


@pytest.mark.slow
def test_a_spec_that_moved_on_meanwhile_leaves_the_set_open(world: World) -> None:
    add_cue(world, "beep")
    take_id = UUID(deliver_sound(world, "beep.wav", sine(hz=997, rate=96_000, seconds=0.2)))
    server = world.server
    server.in_database(lambda session: session.execute(update(Take).where(Take.id == take_id).values(edition=7)))
    completed = server.in_database(lambda session: session.get(RenderSet, take_id).edition)
    assert completed == 1
    take_jobs.make_renders(server.runtime, {"take_id": str(take_id)})
    assert server.in_database(lambda session: session.get(RenderSet, take_id).edition) == 7

    order = server.in_database(lambda session: service.order_renders(session, take_id))
    server.in_database(lambda session: add_newer_spec(session, world))
    server.in_database(
        lambda session: session.execute(update(RenderSet).where(RenderSet.take_id == take_id).values(edition=0))
    )
    server.in_database(lambda session: service.complete(session, order))
    assert server.in_database(lambda session: session.get(RenderSet, take_id).edition) == 0  # says nothing of the newer


@pytest.mark.slow
def test_one_job_and_one_child_do_all_of_a_take(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    add_cue(world, "beep")
    fork, forked = audio_checks.Sandbox._fork, []

    def counted(sandbox: audio_checks.Sandbox, module: str) -> Any:
        forked.append(module)
        return fork(sandbox, module)

    monkeypatch.setattr(audio_checks.Sandbox, "_fork", counted)
    heard = sounds(world, deliver_sound(world, "beep.wav", sine(hz=997, rate=96_000, seconds=0.2)))
    assert heard["master"]["state"] == "drawn"
    assert world.approver.get(f"/v1/takes/{heard['take_id']}/same-sounds").json()["is_compared"]
    assert forked == ["audio_checks.run.runner"]
    jobs = workflows(is_sqlite=world.server.runtime.database.is_sqlite)
    name = jobs.c.attributes["job"].as_string()
    of_studio = select(name).where(jobs.c.queue_partition_key.startswith(str(world.studio_id)))
    names = world.server.in_database(lambda session: session.scalars(of_studio).all())
    assert [name for name in names if not name.startswith("notifications.")] == ["renders.prepare_take"]


@pytest.mark.slow
def test_a_game_file_that_plays_as_the_preview_is_made_and_drawn_once(world: World, tmp_path: Path) -> None:
    add_cue(world, "beep")
    take_id = UUID(deliver_sound(world, "beep.wav", sine(hz=997, dbfs=-6, rate=44_100, seconds=0.2), rate=44_100))

    def stored(session: Any) -> tuple[Picture, Picture, str]:
        master = session.get(Take, take_id).master_sha256
        game = session.scalar(select(Render.sha256).where(Render.take_id == take_id, Render.target == "game"))
        of = {one.sound_sha256: one for one in session.scalars(select(Picture))}
        return of[master], of[game], game

    master, game, game_sha256 = world.server.in_database(stored)
    assert master.preview_sha256 == game_sha256
    assert master.spectrum_sha256 == game.spectrum_sha256
    assert master.peaks_sha256 != game.peaks_sha256
    with world.server.runtime.store.local_copy(world.studio_id, master.sound_sha256) as path:
        drawing.draw(str(path), str(tmp_path), loop=False)
    assert {one.name: hashlib.sha256(one.read_bytes()).hexdigest() for one in tmp_path.iterdir()} == {
        drawing.PEAKS: master.peaks_sha256,
        drawing.SPECTRUM: master.spectrum_sha256,
        drawing.PREVIEW: master.preview_sha256,
    }


@pytest.mark.slow
def test_who_may_see_and_hear(world: World) -> None:
    add_cue(world, "beep")
    take_id = deliver_sound(world, "beep.wav", sine(hz=997, rate=96_000, seconds=0.2))
    heard = sounds(world, take_id)
    addresses = [f"/v1/takes/{take_id}/sounds"]
    for one in (heard["master"], *heard["renders"]):
        addresses += [one["preview_url"], one["peaks_url"], one["spectrum_url"], one.get("file_url")]
    addresses = [address for address in addresses if address]
    assert len(addresses) == 1 + 3 * 3 + 2
    for address in addresses:
        assert world.designer.get(address).status_code == 200
        assert world.reviewer.get(address).status_code == 200
        assert world.nobody.get(address).status_code == 401
        for who in (world.stranger, world.other_designer):
            assert who.get(address).status_code == 404, address
    for address in (f"/v1/takes/{new_id()}/sounds", f"/v1/sounds/{new_id()}/preview", f"/v1/renders/{new_id()}/file"):
        assert world.approver.get(address).status_code == 404


@pytest.mark.slow
def test_a_designer_hears_only_their_own(world: World) -> None:
    """Two designers on one project, each with the same sound: a picture is shared, sight of a take is not."""
    add_cue(world, "beep")
    take_id = deliver_sound(world, "beep.wav", sine(hz=997, rate=96_000, seconds=0.2))
    heard = sounds(world, take_id)
    world.server.in_database(
        lambda session: session.execute(
            update(Take).where(Take.id == UUID(take_id)).values(designer_id=world.other_designer_id)
        )
    )
    for address in (f"/v1/takes/{take_id}/sounds", heard["master"]["preview_url"], heard["renders"][0]["file_url"]):
        assert world.designer.get(address).status_code == 404
        assert world.other_designer.get(address).status_code == 404  # made it, and is not engaged
        assert world.approver.get(address).status_code == 200


@pytest.mark.slow
def test_what_a_game_file_lost_is_shown_in_figures_and_spectra(world: World) -> None:
    add_cue(world, "chirp")
    # Two tones of one level: half of the energy lies above 11,025 Hz, and the file for 22,050 Hz lacks it.
    tones = sine(hz=1_000, dbfs=-12, rate=96_000, seconds=0.5) + sine(hz=15_000, dbfs=-12, rate=96_000, seconds=0.5)
    take_id = deliver_sound(world, "chirp.wav", tones)
    by_target = {sound["target"]: sound for sound in sounds(world, take_id)["renders"]}
    url = f"/v1/renders/{by_target['handheld']['id']}/loss"
    loss = world.approver.get(url).json()
    assert loss["above_nyquist_db"] == pytest.approx(-3.0, abs=0.2)
    assert loss["after"]["sample_peak_dbfs"] == pytest.approx(-12.0, abs=0.1)
    bands = list(zip(*(loss["spectra"][key] for key in ("hz", "master_dbfs", "render_dbfs")), strict=True))
    master, file = next((one, other) for hz, one, other in bands if 14_200 < hz < 15_900 and (one or -99) > -20)
    assert master == pytest.approx(-15, abs=1)
    assert file is None or file < -80
    assert world.designer.get(url).status_code == 200
    for client, status in ((world.other_designer, 404), (world.stranger, 404), (world.nobody, 401)):
        assert client.get(url).status_code == status
    forget = update(Render).where(Render.id == UUID(by_target["handheld"]["id"])).values(loss=None)
    world.server.in_database(lambda session: session.execute(forget))
    old = world.approver.get(url)
    assert (old.status_code, old.json()["code"]) == (409, "loss-unknown")
