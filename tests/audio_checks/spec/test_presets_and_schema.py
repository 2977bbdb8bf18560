"""Presets of the delivery spec, and the schema that editors read."""

import jsonschema_rs
import pytest

from audio_checks.spec import keys as spec_keys
from audio_checks.spec.delivery_spec import Target, new_spec, parse_spec, schema
from tests.audio_checks.spec.test_spec import GAME


@pytest.fixture
def spec():
    return parse_spec(GAME)


class TestPresets:
    @pytest.mark.parametrize("preset", ["44k1", "48k"])
    def test_defaults_of_the_field(self, preset):
        spec = parse_spec(new_spec(preset, name="Shield Wing"))
        assert (spec.name, spec.warnings, spec.not_run) == ("Shield Wing", (), ())
        limits = spec.limits
        assert (limits.sample_peak_dbfs, limits.true_peak_dbtp, limits.tolerance_db) == (-0.1, -1.0, 0.05)
        assert (limits.head_silence_ms, limits.tail_silence_ms, limits.silence_below_dbfs) == (5.0, 250.0, -90.0)
        assert spec.accept.duration_s.max == 30.0
        assert spec.for_category("ambience").accept.duration_s.max == 300.0
        assert spec.for_category("music").accept.duration_s.max == 300.0
        voice = spec.for_category("vo")
        assert (voice.limits.head_silence_ms, voice.limits.tail_silence_ms) == (50.0, 250.0)
        warned = [name for name in ("true-peak", "head-silence", "tail-silence") if spec.checks[name] == "warning"]
        assert len(warned) == 3
        assert {name for name in spec.categories if spec.for_category(name).checks["true-peak"] == "error"} == {
            "music",
            "cinematic",
            "vo",
            "narration",
        }

    def test_targets(self):
        spec = parse_spec(new_spec("44k1"))
        assert spec.targets["game"] == Target("game", 44_100, 16)
        assert spec.targets["handheld"] == Target("handheld", 22_050, 16, channels=1)
        assert parse_spec(new_spec("48k")).targets == {"game": Target("game", 48_000, 16)}

    def test_an_unknown_preset(self):
        with pytest.raises(ValueError, match="44k1, 48k"):
            new_spec("96k")


def test_a_rate_below_a_target_is_warned_about(spec):
    assert spec.warnings == ()
    low = parse_spec(GAME.replace("[44100, ", "[22050, 44100, "))
    (warning,) = low.warnings
    assert "22050 Hz" in warning
    assert "target game is 44100 Hz" in warning


class TestSchema:
    @pytest.mark.parametrize("text", [GAME, new_spec("44k1"), new_spec("48k")])
    def test_valid_specs_pass(self, text):
        jsonschema_rs.validator_for(schema()).validate(parse_spec(text).tables)

    @pytest.mark.parametrize(
        "tables",
        [
            {"name": "no format"},
            {"format": 1, "limits": {"true_peak": -1}},
            {"format": 1, "accept": {"channels": []}},
            {"format": 1, "targets": {"PC": {"sample_rate_hz": 48000, "bit_depth": 16}}},
            {"format": 1, "naming": {"grammar": "latin"}},
            {"format": 1, "naming": {"tokens": [{"digits": 2}]}},
            {"format": 1, "metadata": {"required": ["Originator"]}},
            {"format": 1, "targets": {"pc": {"sample_rate_hz": 48000}}},
        ],
    )
    def test_invalid_specs_fail(self, tables):
        assert not jsonschema_rs.validator_for(schema()).is_valid(tables)

    def test_every_key_of_the_format_is_read(self):
        assert set(schema()["properties"]) == set(spec_keys.SPEC.keys)
