"""Who speaks, directs and casts, and the releases of performers: added, seen, warned about, removed."""

from datetime import timedelta
from typing import Any

import pytest
from httpx import Response

from app.core import clock
from tests.support.references import uploaded
from tests.support.server import World
from tests.support.voice import imported, lines, recorded

PDF = b"%PDF-1.7 a release"
VOICE = "The voice of the captain"


def cast(world: World, character: str = "Captain", language: str = "en", **body: str) -> dict[str, Any]:
    script = world.producer.get(f"/v1/projects/{world.project_id}/voice-script").json()
    [character_id] = [one["id"] for one in script["characters"] if one["name"] == character]
    answer = world.producer.put(f"/v1/voice-characters/{character_id}/castings/{language}", json=body)
    assert answer.status_code == 200, answer.text
    return dict(next(one for one in answer.json()["characters"] if one["id"] == character_id))


def add(world: World, **body: Any) -> Response:
    upload_id = uploaded(world, "release.pdf", PDF) if "upload_id" not in body else body["upload_id"]
    release = {"performer": VOICE, "upload_id": upload_id, "valid_from": "2026-01-01", "synthetic_use": "no"} | body
    return world.producer.post(f"/v1/projects/{world.project_id}/voice-releases", json=release)


def releases(world: World) -> dict[str, Any]:
    answer = world.designer.get(f"/v1/projects/{world.project_id}/voice-releases")
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


@pytest.mark.slow
def test_a_character_is_cast_for_each_language(world: World) -> None:
    imported(world)
    cast(world, performer=VOICE, directed_by="Audio director", cast_by="Producer")
    character = cast(world, language="German", performer="Another voice")
    assert character["castings"] == [
        {"language": "de", "performer": "Another voice", "directed_by": "", "cast_by": ""},
        {"language": "en", "performer": VOICE, "directed_by": "Audio director", "cast_by": "Producer"},
    ]
    line = lines(world)["captain_010"]
    assert (line["performer"], line["directed_by"]) == (VOICE, "Audio director")
    assert [one["performer"] for one in cast(world, performer="")["castings"]] == ["Another voice", None]


@pytest.mark.slow
def test_notes_on_a_voice(world: World) -> None:
    imported(world)
    script = world.producer.get(f"/v1/projects/{world.project_id}/voice-script").json()
    url = f"/v1/voice-characters/{script['characters'][0]['id']}"
    noted = world.producer.patch(url, json={"notes": "Old, and never loud."}).json()
    assert noted["characters"][0]["notes"] == "Old, and never loud."
    assert world.designer.patch(url, json={"notes": "x"}).status_code == 403
    assert world.stranger.patch(url, json={"notes": "x"}).status_code == 404


def test_a_release_is_filed_with_its_dates_and_sent_as_it_came(world: World) -> None:
    answer = add(world, valid_until="2027-12-31", synthetic_use="yes", note="For this game and its trailers.")
    assert answer.status_code == 201, answer.text
    [performer] = releases(world)["performers"]
    [release] = performer["releases"]
    assert (performer["name"], release["file_name"], release["file_bytes"]) == (VOICE, "release.pdf", len(PDF))
    assert (release["valid_from"], release["valid_until"], release["is_valid"]) == ("2026-01-01", "2027-12-31", True)
    assert (release["synthetic_use"], release["added_by"]["name"]) == ("yes", "Producer")
    url = f"/v1/voice-releases/{release['id']}"
    file = world.designer.get(f"{url}/file")
    assert (file.status_code, file.content) == (200, PDF)
    assert file.headers["content-disposition"].startswith("attachment")
    assert file.headers["content-security-policy"] == "default-src 'none'; sandbox"
    for client, status in ((world.stranger, 404), (world.other_designer, 404), (world.nobody, 401)):
        assert client.get(f"{url}/file").status_code == status
    assert world.designer.delete(url).status_code == 403
    assert world.producer.delete(url).status_code == 204
    assert releases(world)["performers"] == []
    assert world.designer.get(f"{url}/file").status_code == 404


@pytest.mark.parametrize(
    ("body", "where"),
    [
        ({"valid_until": "2025-12-31"}, "valid_until"),
        ({"performer": "\u200b"}, "performer"),
    ],
)
def test_what_cannot_be_is_refused_by_its_field(world: World, body: dict[str, str], where: str) -> None:
    answer = add(world, **body)
    assert (answer.status_code, [error["where"] for error in answer.json()["errors"]]) == (422, [where])
    assert releases(world)["performers"] == []


def test_only_a_finished_upload_of_ones_own_becomes_a_release(world: World) -> None:
    upload_id = uploaded(world, "release.pdf", PDF, world.approver)
    assert add(world, upload_id=upload_id).status_code == 404
    empty = uploaded(world, "release.pdf", b"")
    assert add(world, upload_id=empty).json()["code"] == "voice-line-invalid"


@pytest.mark.slow
def test_approved_lines_without_a_release_are_named(world: World) -> None:
    imported(world)
    recorded(world, "en_captain_010.wav", approve=True)
    assert releases(world)["lines_without_performer"] == 1
    cast(world, performer=VOICE)
    found = releases(world)
    assert found["lines_without_performer"] == 0
    assert found["performers"][0]["parts"] == ["Captain, en"]
    assert found["performers"][0]["warning"] == "1 approved line has no release"
    yesterday = (clock.now() - timedelta(days=1)).date().isoformat()
    add(world, valid_until=yesterday)
    assert releases(world)["performers"][0]["warning"] == "1 approved line has no release that is valid today"
    add(world, performer=VOICE.upper(), valid_from=yesterday)
    [performer] = releases(world)["performers"]
    assert (len(performer["releases"]), performer["warning"]) == (2, "")


@pytest.mark.both_databases
def test_on_both_databases_a_designer_reads_releases_and_a_stranger_none(world: World) -> None:
    assert add(world).status_code == 201
    assert len(releases(world)["performers"]) == 1
    assert world.stranger.get(f"/v1/projects/{world.project_id}/voice-releases").status_code == 404
