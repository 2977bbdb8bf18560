"""Pictures and previews of real takes, made by the real worker."""

import io
import wave

import numpy as np
import pytest
import soundfile

from app.core.web.blob_response import IMMUTABLE
from tests.app.renders.making import add_cue, deliver, deliver_sound
from tests.app.renders.test_renders import sounds
from tests.support.server import World
from tests.support.waves import join, silence, sine, wav_bytes


@pytest.mark.slow
def test_thumb_peaks_and_spectrum_show_the_sound(world: World) -> None:
    add_cue(world, "beep")
    half = sine(hz=1_000, dbfs=-6.02, rate=96_000, seconds=0.5)
    take_id = deliver_sound(world, "beep.wav", join(half, silence(rate=96_000, seconds=0.05)))
    master = sounds(world, take_id)["master"]
    thumb = master["thumb"]
    assert thumb["points"] == len(thumb["min"]) == len(thumb["max"]) == len(thumb["rms"]) == 160
    # Half of full scale is 63.5 of 127, its RMS 44.9; the last eleventh is silence.
    assert max(thumb["max"]) in (63, 64)
    assert thumb["rms"][40] in (44, 45)
    assert thumb["max"][150:] == [0] * 10
    peaks = world.designer.get(master["peaks_url"])
    assert peaks.headers["cache-control"] == "private, max-age=31536000, immutable"
    shape = peaks.json()
    assert shape["points"] == len(shape["rms"]) == 4096
    assert max(shape["max"]) / shape["full_scale"] == pytest.approx(0.5, abs=0.001)
    assert shape["duration_s"] == pytest.approx(0.55)
    # A tone of half full scale for ten elevenths of the time: −6.02 − 3.01 − 0.41 dBFS.
    bands = dict(zip(shape["bands"]["hz"], shape["bands"]["dbfs"], strict=True))
    loudest = max(bands, key=lambda hz: bands[hz] or -999.0)
    assert (900 < loudest < 1_100, bands[loudest]) == (True, pytest.approx(-9.4, abs=0.1))
    assert 42_000 < max(bands) < 48_000
    spectrum = world.designer.get(master["spectrum_url"])
    assert spectrum.headers["content-type"] == "image/png"
    assert spectrum.content.startswith(b"\x89PNG")
    assert int.from_bytes(spectrum.content[16:20]) <= 1_000
    assert int.from_bytes(spectrum.content[20:24]) == 128


@pytest.mark.slow
def test_the_preview_plays_in_parts(world: World) -> None:
    add_cue(world, "beep")
    take_id = deliver_sound(world, "beep.wav", sine(hz=1_000, dbfs=-6, rate=96_000, seconds=0.5))
    address = sounds(world, take_id)["master"]["preview_url"]
    whole = world.reviewer.get(address)
    assert whole.headers["content-type"] == "audio/wav"
    with wave.open(io.BytesIO(whole.content)) as sound:
        assert (sound.getframerate(), sound.getsampwidth(), sound.getnframes()) == (48_000, 2, 24_000)
    part = world.reviewer.get(address, headers={"Range": "bytes=100-199"})
    assert part.status_code == 206
    assert part.headers["content-range"] == f"bytes 100-199/{len(whole.content)}"
    assert part.content == whole.content[100:200]


@pytest.mark.slow
def test_a_light_preview_is_as_long_as_the_sound_and_a_small_sound_is_sent_as_it_is(world: World) -> None:
    add_cue(world, "beep")
    add_cue(world, "tick")
    long_id = deliver_sound(world, "beep.wav", sine(hz=1_000, dbfs=-6, rate=96_000, seconds=7.0), rate=96_000)
    short_id = deliver_sound(world, "tick.wav", sine(hz=1_000, dbfs=-6, seconds=0.1))
    exact_url, short_url = (sounds(world, one)["master"]["preview_url"] for one in (long_id, short_id))
    exact, light = world.reviewer.get(exact_url), world.reviewer.get(f"{exact_url}?light=true")
    assert (light.headers["content-type"], light.headers["cache-control"]) == ("audio/ogg", IMMUTABLE)
    assert len(light.content) < len(exact.content) / 4
    heard, _ = soundfile.read(io.BytesIO(light.content))
    played, rate_hz = soundfile.read(io.BytesIO(exact.content))
    assert (len(heard), rate_hz) == (len(played), 48_000)
    # At the same samples: moved by a single one, this tone would differ by 13 % of its level.
    assert np.sqrt(np.mean((heard - played)[1_000:-1_000] ** 2)) < 0.05 * np.sqrt(np.mean(played**2))
    part = world.reviewer.get(f"{exact_url}?light=true", headers={"Range": "bytes=0-99"})
    assert (part.status_code, part.content) == (206, light.content[:100])
    small = world.reviewer.get(f"{short_url}?light=true")
    assert (small.headers["content-type"], small.content) == ("audio/wav", world.reviewer.get(short_url).content)
    assert world.stranger.get(f"{exact_url}?light=true").status_code == 404


@pytest.mark.slow
def test_what_plays_already_is_its_own_preview(world: World) -> None:
    add_cue(world, "beep")
    content = wav_bytes(sine(hz=1_000, dbfs=-6, rate=44_100, seconds=0.2), rate=44_100, bits=16)
    (take,) = deliver(world, ("beep.wav", content))
    world.server.wait_for_jobs()
    assert world.designer.get(sounds(world, take["id"])["master"]["preview_url"]).content == content


def test_what_cannot_be_read_is_said_to_be_undrawable(world: World) -> None:
    add_cue(world, "hit")
    (take,) = deliver(world, ("hit.wav", b"ID3\x04 this is not a WAV file"))
    world.server.wait_for_jobs()
    master = sounds(world, take["id"])["master"]
    assert (master["state"], master["preview_url"], master["thumb"]) == ("undrawable", None, None)


@pytest.mark.slow
def test_three_hundred_peaks_for_three_hundred_frames(world: World) -> None:
    """A sound of fewer frames than points has one point a frame."""
    add_cue(world, "tick")
    samples = np.full((300, 1), 0.25)
    (take,) = deliver(world, ("tick.wav", wav_bytes(samples, rate=48_000, bits=16)))
    world.server.wait_for_jobs()
    master = sounds(world, take["id"])["master"]
    assert world.designer.get(master["peaks_url"]).json()["points"] == 300
    assert set(master["thumb"]["max"]) == {32}
