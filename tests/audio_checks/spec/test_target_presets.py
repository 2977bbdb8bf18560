"""Targets for engines: specs that can be read, accept what they need, and make what each engine is best handed."""

import pytest

from audio_checks import new_spec, parse_spec
from audio_checks.cli import main
from audio_checks.spec.target_presets import TARGET_PRESETS


@pytest.mark.parametrize("name", TARGET_PRESETS)
def test_a_spec_for_an_engine_renders_without_a_warning(name, capsys):
    assert main(["new-spec", "--targets", name]) == 0
    spec = parse_spec(capsys.readouterr().out)
    assert list(spec.targets) == [name]
    assert spec.warnings == ()
    assert TARGET_PRESETS[name].accepts in parse_comments(new_spec("48k", targets=[name]))


def parse_comments(text):
    return " ".join(line.removeprefix("# ") for line in text.splitlines() if line.startswith("# "))


def test_what_each_is_handed():
    targets = parse_spec(new_spec("48k", targets=list(TARGET_PRESETS))).targets
    handed = {name: (one.sample_rate_hz, one.bit_depth, one.channels, one.dither) for name, one in targets.items()}
    assert handed == {
        "wwise": (48_000, 24, "master", "none"),
        "fmod": (48_000, 24, "master", "none"),
        "unreal": (48_000, 16, "master", "tpdf"),
        "unity": (48_000, 16, 1, "tpdf"),
        "raw": (44_100, 16, "master", "tpdf"),
    }


def test_an_engine_nobody_knows():
    with pytest.raises(ValueError, match="targets: wwise, fmod, unreal, unity, raw"):
        new_spec(targets=["godot"])
