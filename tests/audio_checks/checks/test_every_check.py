"""What holds for every check: it survives any valid sound, proves what it finds, and explains itself."""

import pytest

from audio_checks.audio.audio_file import AudioFile
from audio_checks.checks import all_checks
from audio_checks.spec.check_names import DEFAULT_SEVERITY
from audio_checks.spec.delivery_spec import CueFacts, new_spec, parse_spec
from tests.support.waves import noise, silence, sine, write_wav

SPEC = parse_spec(new_spec().replace("# loudness_lufs", "loudness_lufs"))
CUE = CueFacts("SW-001", name="laser fire", duration_s=1.0)
SOUNDS = {
    "silence": silence(),
    "one frame": silence(seconds=1 / 48_000) + 0.5,
    "one silent frame": silence(seconds=1 / 48_000),
    "mono": sine(hz=997),
    "stereo": noise(channels=2),
}
NAMES = sorted(all_checks())


def run(check, path, cue=CUE):
    if not check.applies(SPEC, cue):
        return []
    with AudioFile(path) as file:
        file.prepare(check.figures)
        return list(check.run(file, SPEC, cue))


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("sound", SOUNDS)
def test_any_valid_sound_can_be_judged(tmp_path, name, sound):
    for finding in run(all_checks()[name], write_wav(tmp_path / "laser.wav", SOUNDS[sound])):
        assert finding.check == name
        assert finding.message
        assert finding.fix
        assert (finding.measured is None) == (finding.unit is None)


@pytest.mark.parametrize("name", NAMES)
def test_real_recordings_can_be_judged(recordings, name):
    for path in recordings[::12]:
        assert all(finding.check == name for finding in run(all_checks()[name], path))


@pytest.mark.parametrize("name", ["structure", "container", "encoding", "channels", "clipping", "placeholder"])
def test_most_accepted_recordings_pass(recordings, name):
    flagged = [path.name for path in recordings if run(all_checks()[name], path)]
    assert len(flagged) <= 2, flagged


@pytest.mark.parametrize("name", NAMES)
def test_its_page_can_be_made(name):
    assert name in DEFAULT_SEVERITY
    parts = all_checks()[name].parts
    assert all(parts[part] for part in ("summary", "why", "how to fix", "source"))
    assert all_checks()[name].module.__doc__.startswith(f"`{name}`: ")


def test_without_limits_nothing_is_found(found_by):
    loud = noise(dbfs=0.0, channels=2)
    always = {
        "structure",
        "clipping",
        "click",
        "cut-start",
        "cut-tail",
        "dropout",
        "false-stereo",
        "hum",
        "internal-silence",
        "low-level",
        "padded-bits",
        "placeholder",
    }
    for name in set(NAMES) - always:
        assert found_by(name, loud, name="Bad Name!.WAV") == []
