"""What sounds are like beside others: measured by librosa, asked for where a project has a palette."""

from typing import Any

import numpy as np
import pytest
from sqlalchemy import select
from sqlalchemy.orm import Session

from app.renders import children
from app.renders.models import Timbre
from app.renders.timbre import jobs as timbre_jobs
from app.renders.timbre import rules as timbre
from audio_checks import SandboxCrashed
from tests.app.renders.making import add_cue, deliver_sound
from tests.support.server import World
from tests.support.waves import noise, silence, sine, write_wav

pytestmark = pytest.mark.slow

HEARD = {"timbre": [1.0, 2.0], "bands_db": [0.0, -3.0]}


class InPlaceOfLibrosa:
    """A sandbox that answers at once; what librosa says is another test's."""

    def __init__(self) -> None:
        self.calls = 0
        self.breaks = False

    def child(self, **_: Any) -> "InPlaceOfLibrosa":
        return self

    def __enter__(self) -> "InPlaceOfLibrosa":
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def call(self, *_: Any, **__: Any) -> dict[str, list[float]]:
        self.calls += 1
        if self.breaks:
            raise SandboxCrashed("the child broke")
        return HEARD


@pytest.fixture
def sandbox(monkeypatch: pytest.MonkeyPatch) -> InPlaceOfLibrosa:
    placeholder_file = InPlaceOfLibrosa()
    monkeypatch.setattr(timbre_jobs, "_librosa_sandbox", lambda: placeholder_file)
    return placeholder_file


def heard(world: World) -> list[list[float]]:
    def read(session: Session) -> list[list[float]]:
        return list(session.scalars(select(Timbre.timbre).where(Timbre.studio_id == world.studio_id)))

    found: list[list[float]] = world.server.in_database(read)
    return found


def beep(world: World, name: str) -> str:
    return deliver_sound(world, f"{name}.wav", sine(hz=900, dbfs=-12, seconds=0.2, rate=48_000), rate=48_000)


def test_takes_are_heard_once_there_is_a_palette(world: World, sandbox: InPlaceOfLibrosa) -> None:
    cue = add_cue(world, "early")
    beep(world, "early")
    assert (heard(world), sandbox.calls) == ([], 0)
    answer = world.producer.put(f"/v1/cues/{cue['id']}/palette", json={"palette": True})
    assert answer.status_code == 200
    world.server.wait_for_jobs()
    assert heard(world) == [HEARD["timbre"]]
    add_cue(world, "late")
    deliver_sound(world, "late.wav", sine(hz=700, dbfs=-12, seconds=0.2, rate=48_000), rate=48_000)
    assert (heard(world), sandbox.calls) == ([HEARD["timbre"]] * 2, 2)


def test_a_sound_that_cannot_be_heard_is_not_tried_without_end(world: World, sandbox: InPlaceOfLibrosa) -> None:
    sandbox.breaks = True
    add_cue(world, "odd", palette=True)
    beep(world, "odd")
    assert (heard(world), sandbox.calls) == ([[]], children.TRIES)


@pytest.fixture
def measured(tmp_path):
    def measured(samples, rate=48_000):
        path = write_wav(tmp_path / "sound.wav", samples, rate=rate)
        return timbre.measure(str(path), str(tmp_path), loop=False)

    return measured


def apart(one: dict[str, list[float]], other: dict[str, list[float]]) -> float:
    return float(np.linalg.norm(np.subtract(one["timbre"], other["timbre"])))


def test_timbre_knows_no_level_but_noise_from_a_tone(measured) -> None:
    hiss, low = noise(dbfs=-14, seconds=0.5), noise(dbfs=-30, seconds=0.5)
    tone = sine(hz=600, dbfs=-6, seconds=0.5, rate=48_000)
    assert apart(measured(hiss), measured(low)) < 0.2
    assert apart(measured(hiss), measured(tone)) > 5
    assert measured(hiss)["bands_db"][0] <= 0
    assert max(measured(tone)["bands_db"]) == 0


def test_the_same_tone_at_another_rate_is_the_same_timbre(measured) -> None:
    def chord(rate):
        return sum(sine(hz=hz, dbfs=-20, seconds=0.5, rate=rate) for hz in (300, 900, 2_700))

    assert apart(measured(chord(48_000)), measured(chord(96_000), rate=96_000)) < 1
    assert measured(silence(seconds=0.5)) is None
    assert len(measured(sine(hz=900, dbfs=-6, seconds=0.01, rate=48_000))["timbre"]) == 29
