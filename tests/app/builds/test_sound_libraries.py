"""Sound libraries: registered by fingerprints, and said of each take that equals one of their files."""

import base64
import io
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import python_calamine
import soundfile
import sqlalchemy as sa
from numpy.typing import NDArray

from app.builds.libraries import service as libraries
from app.builds.libraries.models import LibraryMatch, LibrarySound
from audio_checks.cli import main
from tests.app.builds.test_same_sounds import RATE, approve, burst, other_project, take_of
from tests.app.reviews.making import body_of, refused
from tests.support.server import World
from tests.support.waves import wav_bytes

DOORS = {"name": "Doors & Gates", "licence": "Site licence 12"}


def sheet(folder: Path, sounds: dict[str, NDArray[np.float64]]) -> bytes:
    """Write sounds into a folder, and return what the command writes of it."""
    for name, samples in sounds.items():
        path = folder / "library" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(wav_bytes(samples, rate=RATE, bits=24))
    out = folder / "library.json"
    assert main(["manifest", str(folder / "library"), "--out", str(out), "--quiet"]) == 0
    return out.read_bytes()


def post(world: World, content: bytes | str, by: Any = None, **more: str) -> Any:
    text = content if isinstance(content, str) else base64.b64encode(content).decode()
    body = DOORS | {"content_base64": text} | more
    answer = (by or world.producer).post(f"/v1/projects/{world.project_id}/sound-libraries", json=body)
    world.server.wait_for_jobs()
    return answer


def made(answer: Any) -> dict[str, Any]:
    assert answer.status_code == 201, answer.text
    return dict(answer.json())


def listed(world: World, by: Any = None) -> list[dict[str, Any]]:
    return list(body_of((by or world.producer).get(f"/v1/projects/{world.project_id}/sound-libraries")))


def equals(client: Any, take_id: str) -> list[dict[str, Any]]:
    """Return which files of libraries a take equals."""
    return list(body_of(client.get(f"/v1/takes/{take_id}/same-sounds"))["libraries"])


def declare(world: World, take_id: str, name: str) -> None:
    sources = {"libraries": [{"name": name, "licence": "Site licence 12"}]}
    body_of(world.designer.put(f"/v1/takes/{take_id}/sources", json=sources))


def coded(samples: NDArray[np.float64], rate: int) -> NDArray[np.float64]:
    """Return a sound as Ogg Vorbis gives it back."""
    file = io.BytesIO()
    soundfile.write(file, samples, rate, format="OGG", subtype="VORBIS")
    file.seek(0)
    decoded: NDArray[np.float64] = soundfile.read(file, always_2d=True)[0]
    return decoded


def slower_rate(samples: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return a sound at half its sample rate, without what that rate cannot hold."""
    spectrum = np.fft.rfft(samples[: len(samples) // 2 * 2], axis=0)
    half = len(samples) // 2
    return np.fft.irfft(spectrum[: half // 2 + 1], n=half, axis=0) / 2


@pytest.mark.slow
@pytest.mark.both_databases
def test_a_take_that_equals_a_file_is_said_with_whether_it_is_declared(world: World, tmp_path: Path) -> None:
    door = burst(1)
    library = made(post(world, sheet(tmp_path, {"wood/door.wav": door, "gate.wav": burst(2)})))
    assert (library["name"], library["licence"], library["sounds"]) == ("Doors & Gates", "Site licence 12", 2)
    quieter = take_of(world, "Hull knock", door * 10 ** (-6 / 20))
    unlike = take_of(world, "Gull", burst(3))
    (found,) = equals(world.approver, quieter)
    assert (found["library"], found["file"], found["licence"]) == ("Doors & Gates", "wood/door.wav", "Site licence 12")
    assert (found["words"], found["is_declared"]) == ("the same sound, 6.0 dB quieter", False)
    assert equals(world.approver, unlike) == []
    declare(world, quieter, "doors &  gates")
    assert equals(world.approver, quieter)[0]["is_declared"] is True
    assert equals(world.designer, quieter) == equals(world.approver, quieter), "both sides read it"
    declare(world, unlike, "Doors & Gates")
    assert equals(world.approver, unlike) == [], "a declared library without an equal file is not a finding"


@pytest.mark.slow
@pytest.mark.parametrize(
    "change",
    [lambda sound: sound / 2, lambda sound: coded(sound, RATE), lambda sound: sound[882:], lambda sound: sound],
)
def test_it_is_found_after_what_games_and_designers_do(world: World, tmp_path: Path, change: Any) -> None:
    sound = burst(4, seconds=1.0)
    others = {f"other{seed}.wav": burst(seed, seconds=1.0) for seed in range(10, 40)}
    post(world, sheet(tmp_path, {"the-one.wav": sound, **others}))
    found = equals(world.approver, take_of(world, "Hull knock", change(sound)))
    assert [one["file"] for one in found] == ["the-one.wav"]


@pytest.mark.slow
def test_a_file_at_another_rate_is_found(world: World, tmp_path: Path) -> None:
    sound = burst(5, seconds=1.0)
    folder = tmp_path / "library"
    folder.mkdir()
    (folder / "low.wav").write_bytes(wav_bytes(slower_rate(sound), rate=RATE // 2, bits=24))
    post(world, sheet(tmp_path, {"other.wav": burst(6)}))
    (found,) = equals(world.approver, take_of(world, "Hull knock", sound))
    assert found["file"] == "low.wav"
    assert "at another sample rate" in found["words"]


@pytest.mark.slow
def test_none_of_many_other_sounds_is_taken_for_one(world: World, tmp_path: Path) -> None:
    post(world, sheet(tmp_path, {f"other{seed}.wav": burst(seed) for seed in range(100, 160)}))
    for seed in range(200, 206):
        assert equals(world.approver, take_of(world, f"Sound {seed}", burst(seed))) == []


@pytest.mark.slow
def test_takes_of_before_are_compared_in_every_project_of_the_studio(
    world: World, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("app.builds.libraries.jobs.TAKES_AT_ONCE", 1)  # one job asks for the next
    sound = burst(7)
    first = take_of(world, "Hull knock", sound)
    approve(world, first)
    other = other_project(world, world.other_designer_id)
    second = take_of(other, "Gate", sound / 2)
    assert equals(world.approver, first) == []
    post(world, sheet(tmp_path, {"gate.wav": sound}))
    assert [equals(world.approver, take)[0]["file"] for take in (first, second)] == ["gate.wav"] * 2


@pytest.mark.slow
def test_a_designer_registers_a_library_and_sees_no_other(world: World, tmp_path: Path) -> None:
    content = sheet(tmp_path, {"gate.wav": burst(8)})
    own = made(post(world, content, by=world.designer, name="Mine"))
    made(post(world, content))
    assert [one["name"] for one in listed(world)] == ["Doors & Gates", "Mine"]
    assert [(one["name"], one["may_remove"]) for one in listed(world, world.designer)] == [("Mine", True)]
    assert [one["may_remove"] for one in listed(world, world.reviewer)] == [False, False]
    assert refused(post(world, content, by=world.reviewer)) == (403, "producer-needed")
    assert post(world, content, by=world.stranger).status_code == 404
    (foreign,) = [one for one in listed(world) if one["name"] == "Doors & Gates"]
    assert world.designer.delete(f"/v1/sound-libraries/{foreign['id']}").status_code == 404
    assert world.reviewer.delete(f"/v1/sound-libraries/{foreign['id']}").status_code == 403
    assert world.stranger.delete(f"/v1/sound-libraries/{own['id']}").status_code == 404
    assert world.designer.delete(f"/v1/sound-libraries/{own['id']}").status_code == 204


@pytest.mark.slow
@pytest.mark.both_databases
def test_what_is_removed_is_forgotten(world: World, tmp_path: Path) -> None:
    sound = burst(9)
    library = made(post(world, sheet(tmp_path, {"gate.wav": sound})))
    take = take_of(world, "Hull knock", sound)
    assert len(equals(world.approver, take)) == 1
    assert world.producer.delete(f"/v1/sound-libraries/{library['id']}").status_code == 204
    assert equals(world.approver, take) == []
    assert listed(world) == []

    def left(session: Any) -> list[int]:
        counts = [
            sa.select(sa.func.count()).where(one.studio_id == world.studio_id) for one in (LibrarySound, LibraryMatch)
        ]
        return [session.scalar(count) for count in counts]

    assert world.server.in_database(left) == [0, 0]


def test_a_second_sheet_goes_into_the_library_of_that_name(world: World, tmp_path: Path) -> None:
    first = made(post(world, sheet(tmp_path / "one", {"a.wav": burst(20)})))
    both = sheet(tmp_path / "two", {"a.wav": burst(20), "b.wav": burst(21)})
    again = made(post(world, both, licence=""))
    assert (again["id"], again["sounds"], again["licence"]) == (first["id"], 2, "Site licence 12")


def test_a_studio_keeps_so_many(world: World, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(libraries, "MAX_LIBRARY_SOUNDS", 1)
    content = sheet(tmp_path, {"a.wav": burst(22), "b.wav": burst(23)})
    answer = post(world, content)
    assert refused(answer) == (409, "library-full")
    assert "remove a library that is not used" in answer.json()["fix"]


def broken(text: bytes, **changes: Any) -> bytes:
    document = json.loads(text)
    document["files"][0] |= changes
    return json.dumps(document).encode()


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        ("%%%", "not text in UTF-8"),
        (b"\xff\xfe\x00", "not text in UTF-8"),
        (b"{", "is not JSON"),
        (b"[" * 100_000, "is not JSON"),
        (b"[]", "is not a manifest"),
        (lambda text: text.replace(b'"fingerprint_version": 1', b'"fingerprint_version": 2'), "write a new manifest"),
        (lambda text: broken(text, path="/etc/passwd"), "path must be a path below a folder"),
        (lambda text: broken(text, path="../x.wav"), "path must be a path below a folder"),
        (lambda text: broken(text, frames=10**12), "fingerprint is not as long as the sound"),
        (lambda text: broken(text, fingerprint="AAAA"), "fingerprint is none of ours"),
        (lambda text: broken(text, fingerprint=None), "no file of the sheet can be recognised"),
        (lambda text: broken(text, sample_rate_hz=0), "sample_rate_hz must be"),
        (lambda text: broken(text, more=1), "no such key"),
    ],
)
def test_what_is_no_sheet_is_refused_in_words(world: World, tmp_path: Path, spoil: Any, words: str) -> None:
    answer = post(world, spoil(sheet(tmp_path, {"a.wav": burst(24)})) if callable(spoil) else spoil)
    assert refused(answer) == (422, "bad-library-sheet")
    assert words in answer.json()["detail"]
    assert "audio-checks manifest FOLDER" in answer.json()["fix"]
    assert listed(world) == []


@pytest.mark.slow
def test_a_fingerprint_of_any_bytes_is_compared_without_harm(world: World, tmp_path: Path) -> None:
    text = sheet(tmp_path, {"a.wav": burst(25)})
    packed = base64.b64decode(json.loads(text)["files"][0]["fingerprint"])
    for filler in (b"\x00", b"\xff", b"\x80\x7f"):
        hostile = (filler * len(packed))[: len(packed)]
        spoiled = broken(text, fingerprint=base64.b64encode(hostile).decode())
        assert post(world, spoiled, name=f"Filler {filler[0]}").status_code in (201, 422)
    take = take_of(world, "Hull knock", burst(26))
    assert equals(world.approver, take) == []


@pytest.mark.slow
def test_the_clearance_sheet_says_it(world: World, tmp_path: Path) -> None:
    sound = burst(27)
    post(world, sheet(tmp_path, {"gate.wav": sound}))
    take = take_of(world, "Hull knock", sound)
    approve(world, take)
    answer = world.producer.get(f"/v1/projects/{world.project_id}/clearance-sheet.xlsx")
    book = python_calamine.load_workbook(io.BytesIO(answer.content))
    head, *rows = book.get_sheet_by_index(0).to_python()
    said = {row[head.index("name")]: row[head.index("same_in_libraries")] for row in rows}
    assert said["Hull knock"] == "gate.wav of Doors & Gates (Site licence 12), the same samples, not declared"
