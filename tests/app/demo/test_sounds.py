"""The demo's files show what they are there to show, and conform in everything else."""

import hashlib
import io
import wave

import numpy as np
import pytest

from app.demo.cues import CUES
from app.demo.sounds import demo_sounds, warp_in_stem
from audio_checks import AudioFile, compare_reverb_with_dry, parse_spec
from audio_checks.judge import judge
from audio_checks.judge.reverb import judge_decay
from audio_checks.measure.edges import Edges
from audio_checks.measure.faults import Faults
from audio_checks.measure.levels import Levels
from audio_checks.measure.loudness import Loudness
from audio_checks.measure.seam import Seam
from audio_checks.measure.true_peak import TruePeak
from audio_checks.spec.presets import new_spec

SOUNDS = demo_sounds()
SPEC = parse_spec(new_spec("44k1"))  # the preset of the demo's project
LOOPS = {"engine_idle_loop": 4.0, "amb_bridge_loop": 24.0, "alarm_red_alert": 2.0, "drone_swarm_loop": 6.0}
MAX_HEAD_SILENCE_MS = {"vo_oath": 50}  # as the spec allows voices
KINDS = {"vo_oath": "voice"}
MISTAKEN = {
    ("mine_arm", "upsampled"),  # its pips end at 4 kHz, as steeply as a resampler would end them
    ("explosion_far", "natural-decay"),  # wide noise that dies away in 2 s is the tail of a room, or its own
}
SHOWS_SOMETHING = {"shield_hit", "airlock_cycle"}
REQUESTED_S = {
    "ui_confirm": 0.12, "ui_back": 0.12, "laser_fire": 0.30, "engine_idle_loop": 4.0, "amb_bridge_loop": 24.0,
    "hull_impact": 0.90, "shield_hit": 0.80, "foot_deck_walk": 0.40, "airlock_cycle": 2.0, "suit_hit": 0.50,
    "thruster_burst": 0.80, "final_FINAL_sting2": 3.0, "alarm_red_alert": 2.0, "mine_arm": 0.50,
    "radar_ping": 0.60, "dock_clamp": 0.80, "explosion_far": 2.5, "missile_launch": 1.4,
    "warp_in": 2.0, "drone_swarm_loop": 6.0, "vo_oath": 6.0,
}  # fmt: skip


@pytest.fixture(scope="module")
def files():
    return {key: sound.wav_bytes() for key, sound in SOUNDS.items()}


@pytest.fixture(scope="module")
def figures(files):
    return {key: measured(content) for key, content in files.items()}


def kind_of(key):
    """What the demo's spec says of the category of a sound's cue."""
    category = "music" if "sting" in key else next(cue["category"] for cue in CUES if key.startswith(cue["name"]))
    return SPEC.for_category(category).kind


def decoded(content):
    with wave.open(io.BytesIO(content)) as file:
        width, channels = file.getsampwidth(), file.getnchannels()
        raw = np.frombuffer(file.readframes(file.getnframes()), np.uint8).reshape(-1, width)
        wide = np.zeros((len(raw), 4), np.uint8)
        wide[:, 4 - width :] = raw
        return wide.view("<i4")[:, 0].reshape(-1, channels) / 2.0**31, file.getframerate()


def measured(content):
    samples, rate = decoded(content)
    results = {"duration_s": len(samples) / rate, "channels": samples.shape[1]}
    for family in (Levels, Edges, Faults, Seam, TruePeak, Loudness):
        accumulator = family(rate, samples.shape[1], len(samples))
        accumulator.add(samples)
        results |= accumulator.result()
    return results


def test_every_file_of_the_demo_is_there():
    assert {sound.file_name for sound in SOUNDS.values()} == {
        "ui_confirm.wav", "ui_back.wav", *(f"laser_fire_{n:02d}.wav" for n in range(1, 5)),
        "engine_idle_loop.wav", "amb_bridge_loop.wav", *(f"hull_impact_{n:02d}.wav" for n in range(1, 4)),
        "shield_hit.wav", "shield_hit_altB.wav", "shield_hit_altC.wav",
        *(f"foot_deck_walk_{n:02d}.wav" for n in range(1, 7)), "airlock_cycle.wav", "suit_hit.wav",
        *(f"thruster_burst_{n:02d}.wav" for n in range(1, 5)), "final_FINAL_sting2.wav",
        "alarm_red_alert.wav", "mine_arm.wav",
        "radar_ping.wav", "dock_clamp.wav", "explosion_far.wav", "missile_launch.wav", "warp_in.wav",
        "drone_swarm_loop.wav", "vo_oath.wav",
    }  # fmt: skip
    assert SOUNDS["suit_hit"].file_name == SOUNDS["suit_hit_take2"].file_name


def test_masters_of_all_rates_and_depths():
    assert {sound.sample_rate_hz for sound in SOUNDS.values()} == {44_100, 48_000, 96_000}
    assert {sound.bit_depth for sound in SOUNDS.values()} == {16, 24}


@pytest.mark.slow
def test_the_same_bytes_each_time(files):
    again = demo_sounds()
    for key in ("ui_confirm", "laser_fire_03", "engine_idle_loop", "shield_hit", "alarm_red_alert", "suit_hit_take2"):
        assert again[key].wav_bytes() == files[key]


@pytest.mark.slow
def test_no_two_files_are_alike(files):
    assert len({hashlib.sha256(content).digest() for content in files.values()}) == len(SOUNDS)


@pytest.mark.slow
@pytest.mark.parametrize("key", SOUNDS)
def test_its_length_is_near_the_request(figures, key):
    requested = next(seconds for stem, seconds in REQUESTED_S.items() if key.startswith(stem))
    assert 0.75 * requested <= figures[key]["duration_s"] <= 1.25 * requested
    assert figures[key]["duration_s"] == pytest.approx(LOOPS.get(key, figures[key]["duration_s"]), abs=0)


@pytest.mark.slow
@pytest.mark.parametrize("key", sorted(set(SOUNDS) - SHOWS_SOMETHING))
def test_it_conforms(figures, key):
    found = figures[key]
    assert found["true_peak_dbtp"] <= -1.0
    assert found["clipped_runs"] == 0
    assert found["dc_offset_percent"] < 0.05
    if key not in LOOPS:
        assert found["head_silence_ms"] <= MAX_HEAD_SILENCE_MS.get(key, 1)
        assert found["tail_silence_ms"] <= 100


@pytest.mark.slow
@pytest.mark.parametrize("key", LOOPS)
def test_loops_have_no_seam(figures, key):
    assert figures[key]["seam_step_db"] < 0
    assert figures[key]["seam_slope_db"] < 0


@pytest.mark.slow
def test_the_first_alternate_peaks_between_its_samples(figures):
    assert -1.0 < figures["shield_hit"]["sample_peak_dbfs"] <= -0.9
    assert figures["shield_hit"]["true_peak_dbtp"] == pytest.approx(-0.6, abs=0.049)
    assert [round(figures[key]["duration_s"], 2) for key in ("shield_hit", "shield_hit_altB", "shield_hit_altC")] == [
        0.84,
        0.91,
        0.78,
    ]


@pytest.mark.slow
def test_the_airlock_starts_late_and_is_too_loud(figures):
    found = figures["airlock_cycle"]
    assert found["head_silence_ms"] == pytest.approx(412, abs=0.5)
    assert found["sample_peak_dbfs"] == pytest.approx(0.0, abs=1e-5)
    assert found["true_peak_dbtp"] > 0.4
    assert found["clipped_runs"] > 0
    assert found["duration_s"] == pytest.approx(2.41, abs=0.005)


@pytest.mark.slow
def test_only_the_arrival_comes_with_reverb(files, tmp_path):
    found = {}
    for key, content in files.items():
        path = tmp_path / f"{key}.wav"
        path.write_bytes(content)
        with AudioFile(path) as file:
            file.prepare(["decay"])
            decay = file.measurements.decay
        for kind in {None, kind_of(key)}:
            judged = judge_decay(decay, kind)
            if judged.verdict == "reverb":
                found[key, kind] = judged.figures["rt60_s"]
    assert found.keys() - MISTAKEN == {("warp_in", None)}
    assert found["warp_in", None] == pytest.approx(1.8, rel=0.2)


@pytest.mark.slow
def test_beside_its_stem_the_hall_is_what_was_added(files, tmp_path):
    (tmp_path / "warp_in.wav").write_bytes(files["warp_in"])
    found = compare_reverb_with_dry(tmp_path / "warp_in.wav", warp_in_stem().write(tmp_path))
    assert found.verdict == "reverb"
    assert found.figures["rt60_s"] == pytest.approx(1.8, rel=0.2)


@pytest.mark.slow
def test_only_the_swarm_and_the_oath_are_asked_about(files, tmp_path):
    found = {}
    for key, content in files.items():
        path = tmp_path / f"{key}.wav"
        path.write_bytes(content)
        with AudioFile(path) as file:
            file.prepare(["codec_traces", "mean_spectrum", "decay"])
            for name, kind in (("upsampled", None), ("lossy", None), ("reversed", KINDS.get(key))):
                judged = judge(name, file, kind)
                if judged.verdict == name:
                    found[key, name] = judged.figures
    assert found["drone_swarm_loop", "upsampled"]["edge_hz"] == pytest.approx(11_000, rel=0.02)
    assert set(found) - MISTAKEN == {("drone_swarm_loop", "upsampled"), ("vo_oath", "reversed")}


@pytest.mark.slow
def test_the_third_thruster_stands_out_of_its_set(figures):
    levels = [figures[f"thruster_burst_{number:02d}"]["max_momentary_lufs"] for number in range(1, 5)]
    others = [*levels[:2], levels[3]]
    assert levels[2] - np.median(others) == pytest.approx(4.0, abs=0.1)
    assert max(others) - min(others) < 0.5


@pytest.mark.slow
def test_the_steps_are_a_set(figures):
    levels = [figures[f"foot_deck_walk_{number:02d}"]["short_loudness_lufs"] for number in range(1, 7)]
    assert max(levels) - min(levels) == pytest.approx(1.3, abs=0.1)


@pytest.mark.slow
def test_the_second_take_adds_a_clank(files):
    before, rate = decoded(files["suit_hit"])
    after, _ = decoded(files["suit_hit_take2"])
    hz = np.fft.rfftfreq(len(before), 1 / rate)
    clank = (hz > 390) & (hz < 430)

    def strength(samples):
        power = np.abs(np.fft.rfft(samples[:, 0])) ** 2
        return power[clank].sum() / power.sum()

    assert strength(after) > 5 * strength(before)


@pytest.mark.slow
def test_it_is_written_under_its_name(tmp_path, files):
    path = SOUNDS["suit_hit_take2"].write(tmp_path)
    assert path == tmp_path / "suit_hit.wav"
    assert path.read_bytes() == files["suit_hit_take2"]
