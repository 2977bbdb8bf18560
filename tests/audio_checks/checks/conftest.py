"""What the tests of checks share: a sound on disk, one check, and what it finds."""

import os
from pathlib import Path

import pytest

from audio_checks.audio.audio_file import AudioFile
from audio_checks.checks import all_checks
from audio_checks.spec.delivery_spec import parse_spec
from tests.support.waves import write_wav


@pytest.fixture
def found_by(tmp_path):
    """Call one check on samples under the tables of a spec; nothing is found where it does not apply."""

    def found_by(check, samples, tables="", *, cue=None, target=None, name="laser_fire.wav", **form):
        spec = parse_spec(f"format = 1\n{tables}")
        spec = spec.for_target(target) if target else spec
        one = all_checks()[check]
        if not one.applies(spec, cue):
            return []
        with AudioFile(write_wav(tmp_path / "sound.wav", samples, **form), name=name) as file:
            file.prepare(one.figures)
            return list(one.run(file, spec, cue))

    return found_by


@pytest.fixture
def codes_of(found_by):
    """Return only the codes of what a check finds."""

    def codes_of(*args, **options):
        return [finding.code for finding in found_by(*args, **options)]

    return codes_of


@pytest.fixture(scope="session")
def recordings():
    """Return real recordings."""
    folder = os.environ.get("SOUNDS_DIR")
    if not folder:
        pytest.skip("SOUNDS_DIR does not name a folder of real recordings")
    found = sorted(Path(folder, "masters").glob("*.wav"))
    assert found, f"no recordings in {folder}/masters"
    return found
