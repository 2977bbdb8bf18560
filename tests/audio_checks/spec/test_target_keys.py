"""Keys of a target of the delivery spec."""

import pytest

from audio_checks.errors import SpecError
from audio_checks.spec.delivery_spec import parse_spec


class TestTargetKeys:
    TARGET = "format = 1\n[targets.pc]\nsample_rate_hz = 48000\nbit_depth = 16\n"

    def test_what_is_absent_changes_nothing_of_a_render(self):
        target = parse_spec(self.TARGET).targets["pc"]
        assert (target.mono_gains, target.chunks, target.shelf_db) == ((0.5, 0.5), "sound", 0.0)
        assert (target.trim_below_dbfs, target.fade_in_ms, target.fade_out_ms) == (None, 0.0, 0.0)
        assert (target.budget_bytes, target.codec_ratio, target.streamed) == (None, 1.0, False)

    def test_what_is_said_is_read_and_written_again(self):
        said = (
            'mono_gains = [0.7, 0.3]\nchunks = "all"\nshelf_db = "auto"\ntrim_below_dbfs = -60\nfade_in_ms = 1\n'
            "fade_out_ms = 5\nbudget_bytes = 8000000\ncodec_ratio = 4\nstreamed = true\nstream_buffer_bytes = 4096\n"
        )
        spec = parse_spec(self.TARGET + said)
        target = spec.targets["pc"]
        assert (target.mono_gains, target.chunks, target.shelf_db) == ((0.7, 0.3), "all", "auto")
        assert (target.trim_below_dbfs, target.fade_in_ms, target.fade_out_ms) == (-60.0, 1.0, 5.0)
        assert (target.budget_bytes, target.codec_ratio) == (8_000_000, 4.0)
        assert (target.streamed, target.stream_buffer_bytes) == (True, 4_096)
        assert parse_spec(spec.to_toml()).sha256 == spec.sha256

    def test_a_category_lifts_what_the_target_cuts(self):
        spec = parse_spec(self.TARGET + 'trim_below_dbfs = -60\n[categories.amb]\ntargets.pc.trim_below_dbfs = "any"\n')
        assert spec.for_category("amb").targets["pc"].trim_below_dbfs is None

    @pytest.mark.parametrize(
        ("line", "key", "words"),
        [
            ("mono_gains = [0.5]", "mono_gains", "two numbers"),
            ('shelf_db = "any"', "shelf_db", 'a number or "auto"'),
            ("shelf_db = 12", "shelf_db", "outside 0 to 6"),
            ('chunks = "none"', "chunks", "one of sound, all"),
            ("codec_ratio = 0.5", "codec_ratio", "outside 1 to 100"),
            ('fade_in_ms = "any"', "fade_in_ms", "wanted a number, found"),
        ],
    )
    def test_what_is_refused(self, line, key, words):
        with pytest.raises(SpecError, match=words) as wrong:
            parse_spec(self.TARGET + line)
        assert wrong.value.where == f"spec.toml: targets.pc.{key}"
