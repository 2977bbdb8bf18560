"""What takes were made from: stated by their designers, on record once accepted, needed where a contract says so."""

import io
import json
from pathlib import Path
from typing import Any
from uuid import UUID

import pytest
import python_calamine
from sqlalchemy.orm import Session

from app.agreements.queries import events_of
from app.deliveries.models import Delivery, Take
from app.deliveries.schemas import Sources
from app.deliveries.sources.statements import open_points, words_of, words_of_points
from audio_checks import AudioFile
from tests.app.builds.approved import accepted_list
from tests.app.money.agreed import Agreed, milestone
from tests.app.reviews.making import Stage, body_of, refused
from tests.support.deliver import add_cues, deliver, open_delivery
from tests.support.pdfs import letters_of
from tests.support.server import World
from tests.support.waves import sine, wav_bytes

SCRATCH = {"from_scratch": True}
LAYERED = {
    "own_recordings": True,
    "libraries": [{"name": "Metal Impacts 2", "licence": "single user, 2024", "file": "MI2_014.wav"}],
    "generated": [{"tool": "Stable Audio 2", "part": "the shimmer on top"}],
    "performers": [{"name": "A. Voice", "release": "signed 3 May 2026"}],
    "note": "session kept",
}
LICENCE_OPEN = {"libraries": [{"name": "Metal Impacts 2"}]}


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


def state(world: World, take_id: UUID, sources: dict[str, Any], by: Any = None) -> Any:
    return (by or world.designer).put(f"/v1/takes/{take_id}/sources", json=sources)


def of_take(world: World, take_id: UUID) -> dict[str, Any]:
    return body_of(world.reviewer.get(f"/v1/takes/{take_id}/sources"))


def test_what_is_stated_of_a_delivery_holds_for_its_takes_but_those_with_their_own(stage: Stage) -> None:
    world, cue = stage.world, stage.cue()
    first, second = stage.take(cue), stage.take(cue)
    nothing = of_take(world, first)
    assert (nothing["stated"], nothing["open_points"]) == (None, ["its sources are not stated"])
    path = f"/v1/deliveries/{stage.delivery_id}/sources"
    whole = body_of(world.designer.put(path, json=SCRATCH))
    assert [one["stated"]["words"] for one in whole["takes"]] == ["made from scratch"] * 2
    body_of(state(world, second, LAYERED))
    assert of_take(world, first)["stated"]["sources"]["from_scratch"] is True
    second_read = of_take(world, second)
    assert second_read["is_own"] is True
    assert second_read["stated"]["words"] == (
        "own recordings; library Metal Impacts 2 (single user, 2024, MI2_014.wav); "
        "generated with Stable Audio 2: the shimmer on top; performed by A. Voice (release: signed 3 May 2026); "
        "session kept"
    )
    assert second_read["open_points"] == []
    later = stage.take(cue)
    assert of_take(world, later)["stated"]["words"] == "made from scratch", "files that come later are of the batch too"


def test_the_designer_is_offered_what_they_stated_last(stage: Stage) -> None:
    world = stage.world
    take = stage.take(stage.cue())
    body_of(state(world, take, LAYERED))
    another = open_delivery(world)
    asked = body_of(world.designer.get(f"/v1/deliveries/{another}/sources"))
    assert asked["stated"] is None
    assert asked["remembered"]["libraries"] == LAYERED["libraries"]
    assert body_of(world.producer.get(f"/v1/deliveries/{another}/sources"))["remembered"] is None


@pytest.mark.parametrize("by", ["producer", "approver", "reviewer"])
def test_only_its_designer_states_them(stage: Stage, by: str) -> None:
    take = stage.take(stage.cue())
    assert refused(state(stage.world, take, SCRATCH, getattr(stage.world, by))) == (403, "own-designer-needed")
    assert of_take(stage.world, take)["stated"] is None


def test_a_note_alone_names_no_source(stage: Stage) -> None:
    take = stage.take(stage.cue())
    assert refused(state(stage.world, take, {"note": "see the session"})) == (422, "no-source-named")


@pytest.mark.slow
def test_once_approved_and_complete_they_stand(stage: Stage) -> None:
    world, cue = stage.world, stage.cue()
    take = stage.take(cue)
    path = f"/v1/deliveries/{stage.delivery_id}/sources"
    body_of(world.designer.put(path, json=SCRATCH))
    stage.approve(take)
    assert refused(state(world, take, LAYERED)) == (409, "sources-fixed")
    body_of(world.designer.put(path, json={"own_recordings": True}))
    read = of_take(world, take)
    assert (read["stated"]["words"], read["is_fixed"]) == ("made from scratch", True)
    stage.draft(take, seen_state="approved")
    stage.send()
    assert body_of(state(world, take, LAYERED))["is_fixed"] is False, "a reversal opens them again"


@pytest.mark.slow
def test_what_is_open_can_be_completed_after_the_approval(stage: Stage) -> None:
    take = stage.take(stage.cue())
    body_of(state(stage.world, take, LICENCE_OPEN))
    stage.approve(take)
    assert of_take(stage.world, take)["open_points"] == ["the licence of Metal Impacts 2 is not named"]
    body_of(state(stage.world, take, LAYERED))
    assert refused(state(stage.world, take, SCRATCH)) == (409, "sources-fixed")


def agreed_by(world: World, needed: str) -> tuple[Agreed, UUID, UUID]:
    agreed = Agreed(world, terms={"sources_needed": needed})
    cue = agreed.cue()
    agreed.agree(milestone("Alpha", cue, amount_minor=18_000))
    return agreed, cue, agreed.take(cue)


def recorded(agreed: Agreed) -> list[tuple[str, str]]:
    def read(session: Session) -> list[tuple[str, str]]:
        said = [(event.kind, json.loads(event.payload)) for event in events_of(session, agreed.contract_id)]
        return [(payload["by"], payload["sources"]) for kind, payload in said if kind == "sources"]

    found: list[tuple[str, str]] = agreed.world.server.in_database(read)
    return found


@pytest.mark.slow
def test_a_contract_can_want_them_before_acceptance(world: World) -> None:
    agreed, cue, take = agreed_by(world, "before_acceptance")
    answer = agreed.verdict(take, "approve")
    assert refused(answer) == (409, "sources-missing")
    assert "shield_hit.wav: its sources are not stated" in answer.json()["detail"]
    body_of(state(world, take, LICENCE_OPEN))
    whole = world.approver.post(f"/v1/cues/{cue}/accept-set", json={})
    assert refused(whole) == (409, "sources-missing")
    assert "the licence of Metal Impacts 2 is not named" in whole.json()["detail"]
    assert (agreed.states(take), agreed.owed(), recorded(agreed)) == (["conforming"], [], [])
    body_of(state(world, take, LAYERED))
    agreed.approve(take)
    assert agreed.owed() == [("accepted", 18_000)]
    ((by, words),) = recorded(agreed)
    assert by == "Sound designer"
    assert words.startswith("own recordings; library Metal Impacts 2")


@pytest.mark.slow
def test_a_contract_can_want_them_before_the_invoice(world: World) -> None:
    agreed, _, take = agreed_by(world, "before_invoice")
    agreed.approve(take)
    path = f"/v1/contracts/{agreed.contract_id}/invoices"
    answer = world.designer.post(path, json={"seller": "Sound designer"})
    assert refused(answer) == (409, "sources-missing")
    assert answer.json()["errors"][0]["where"] == f"takes.{take}"
    body_of(world.designer.put(f"/v1/deliveries/{agreed.delivery_id}/sources", json=SCRATCH))
    assert recorded(agreed) == [("Sound designer", "made from scratch")], "completed after the approval, on record too"
    agreed.invoice()


@pytest.mark.slow
def test_a_contract_that_only_asks_lets_approve_and_invoice(world: World) -> None:
    agreed, _, take = agreed_by(world, "asked")
    agreed.approve(take)
    agreed.invoice()


def test_another_designer_of_the_project_does_not_see_them(world: World) -> None:
    stage = Stage(world)
    take = stage.take(stage.cue(), designer_id=world.other_designer_id)
    assert world.designer.get(f"/v1/takes/{take}/sources").status_code == 404
    assert state(world, take, SCRATCH).status_code == 404


@pytest.mark.parametrize(
    ("sources", "points"),
    [
        (None, "its sources are not stated"),
        (SCRATCH, ""),
        (LAYERED, ""),
        (LICENCE_OPEN, "the licence of Metal Impacts 2 is not named"),
        ({"performers": [{"name": "A. Voice"}]}, "the release of A. Voice is not named"),
    ],
)
def test_points_that_are_open(sources: dict[str, Any] | None, points: str) -> None:
    assert words_of_points(open_points(Sources(**sources) if sources else None)) == points


def test_a_library_without_licence_says_so_in_words() -> None:
    assert words_of(Sources(**LICENCE_OPEN)) == "library Metal Impacts 2 (no licence named)"


@pytest.mark.slow
def test_a_copy_of_a_master_carries_them(world: World, tmp_path: Path) -> None:
    [cue] = add_cues(world, {"name": "Shield hit", "description": "a bowl, struck"})
    take = deliver(world, "shield_hit.wav", wav_bytes(sine(hz=997, dbfs=-3.0, seconds=0.5)), cue_id=cue["id"])
    body_of(state(world, take["id"], LAYERED))
    asked = world.designer.post(f"/v1/takes/{take['id']}/master-exports")
    assert asked.status_code == 201, asked.text
    world.server.wait_for_jobs()
    made = body_of(world.designer.get(f"/v1/master-exports/{asked.json()['id']}"))
    fields = made["fields"]
    assert fields["library"] == "Metal Impacts 2"
    assert fields["usageRights"] == "Metal Impacts 2: single user, 2024"
    assert fields["actorName"] == "A. Voice"
    assert fields["notes"].startswith("a bowl, struck Sources: own recordings; library Metal Impacts 2")
    copy = tmp_path / "copy.wav"
    copy.write_bytes(world.designer.get(made["file_url"]).content)
    with AudioFile(copy) as file:
        assert file.metadata.fields["iXML.ASWG.library"] == "Metal Impacts 2"


def sheet_of(content: bytes) -> list[dict[str, Any]]:
    columns, *rows = (
        python_calamine.CalamineWorkbook.from_filelike(io.BytesIO(content)).get_sheet_by_index(0).to_python()
    )
    return [dict(zip(columns, row, strict=True)) for row in rows]


@pytest.mark.slow
def test_the_clearance_sheet_of_a_pack_says_what_a_lawyer_asks(world: World) -> None:
    accepted_list(world)
    listed = body_of(world.designer.get(f"/v1/projects/{world.project_id}/takes"))["items"]
    takes = {one["file_name"]: one["id"] for one in listed}
    body_of(state(world, takes["laser_fire_01.wav"], LAYERED))
    path = f"/v1/projects/{world.project_id}/clearance-sheet"
    first, second, single = sheet_of(world.producer.get(f"{path}.xlsx").content)
    assert first["file"].endswith("laser_fire_01.wav")
    assert (first["designer"], first["agreement"]) == ("Sound designer", "no contract in Soundlist")
    assert (first["from_scratch"], first["own_recordings"]) == ("no", "yes")
    assert first["libraries"] == "Metal Impacts 2, single user, 2024, MI2_014.wav"
    assert first["generated"] == "Stable Audio 2: the shimmer on top"
    assert first["performers"] == "A. Voice, release: signed 3 May 2026"
    assert (first["open_points"], first["approved_by"]) == ("", "Audio director")
    assert second["open_points"] == single["open_points"] == "its sources are not stated"
    text = letters_of(world.producer.get(f"{path}.pdf").content)
    for said in ("laser_fire_01.wav", "Sounddesigner", "MetalImpacts2", "StableAudio2", "A.Voice", "Audiodirector"):
        assert said in text
    assert text.count("itssourcesarenotstated") == 2
    key = world.producer.get(f"/v1/projects/{world.project_id}/documentation-key.xlsx").content
    assert [bool(one["sources"]) for one in sheet_of(key)] == [True, False, False]
    for person in (world.reviewer, world.approver):
        assert refused(person.get(f"{path}.xlsx")) == (403, "producer-needed")
    assert world.designer.get(f"{path}.xlsx").status_code == 403


@pytest.mark.slow
def test_a_sealed_pack_has_its_clearance_sheet(world: World) -> None:
    accepted_list(world)
    target = body_of(world.producer.get(f"/v1/projects/{world.project_id}/pack"))["target"]
    sealed = world.producer.post(f"/v1/projects/{world.project_id}/packs", json={"target": target}).json()
    world.server.wait_for_jobs()
    rows = sheet_of(world.producer.get(f"/v1/packs/{sealed['id']}/clearance-sheet.xlsx").content)
    assert len(rows) == 3
    text = letters_of(world.producer.get(f"/v1/packs/{sealed['id']}/clearance-sheet.pdf").content)
    assert [row["file"] for row in rows if row["file"] not in text] == []


@pytest.mark.slow
def test_the_same_file_in_another_project_of_the_studio_is_reported(world: World) -> None:
    accepted_list(world)
    listed = body_of(world.producer.get(f"/v1/projects/{world.project_id}/takes"))["items"]
    body = {"studio_id": str(world.studio_id), "name": "Shield Wing 2", "cue_prefix": "SB"}
    other = world.producer.post("/v1/projects", json=body).json()

    def deliver_there(session: Session) -> None:
        of = {"studio_id": world.studio_id, "project_id": UUID(other["id"]), "designer_id": world.designer_id}
        delivery = Delivery(**of, number=1)
        session.add(delivery)
        session.flush()
        same = {"file_name": "again.wav", "master_sha256": listed[0]["master_sha256"], "master_bytes": 1_000}
        session.add(Take(**of, delivery_id=delivery.id, **same))

    world.server.in_database(deliver_there)
    rows = sheet_of(world.producer.get(f"/v1/projects/{world.project_id}/clearance-sheet.xlsx").content)
    said = {row["master_sha256"]: row["same_file_in"] for row in rows}
    assert said.pop(listed[0]["master_sha256"]) == "Shield Wing 2"
    assert set(said.values()) == {""}
