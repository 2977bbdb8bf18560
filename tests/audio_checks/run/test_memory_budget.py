"""What a target takes in memory, by sums that can be done on paper."""

import pytest

from audio_checks import parse_spec
from audio_checks.errors import SpecError
from audio_checks.run.memory_budget import SoundSize, memory_use, requested_sizes
from audio_checks.spec.delivery_spec import CueFacts

SPEC = parse_spec("""
format = 1
accept.channels = [1, 2]
[targets.handheld]
sample_rate_hz = 22050
bit_depth = 16
channels = 1
budget_bytes = 500000
codec_ratio = 4.0
[targets.pc]
sample_rate_hz = 48000
bit_depth = 24
[categories.music]
targets.handheld = { streamed = true, codec_ratio = 10.0, budget_bytes = 100000, stream_buffer_bytes = 32768 }
targets.pc.channels = 2
[categories.foley]
""")


def test_resident_and_streamed():
    sounds = [SoundSize("foley", 2.0, files=8), SoundSize("music", 120.0), SoundSize(None, 1.0)]
    memory = memory_use(SPEC, "handheld", sounds)
    foley, music, other = memory.categories
    assert foley.pcm_bytes == 8 * 2 * 22_050 * 2
    assert foley.memory_bytes == foley.disk_bytes == 8 * 22_050
    assert music.disk_bytes == 120 * 22_050 * 2 / 10
    assert (music.memory_bytes, music.budget_bytes, music.over_bytes) == (32_768, 100_000, 32_768 - 100_000)
    assert (other.memory_bytes, other.budget_bytes) == (11_025, None)
    assert memory.total.memory_bytes == foley.memory_bytes + 32_768 + 11_025
    assert memory.total.over_bytes == memory.total.memory_bytes - 500_000
    assert (memory.total.files, memory.total.category) == (10, None)


@pytest.mark.parametrize(("category", "channels", "counted"), [(None, None, 2), (None, 1, 1), ("music", 1, 2)])
def test_channels_of_the_target_the_master_or_the_most_accepted(category, channels, counted):
    memory = memory_use(SPEC, "pc", [SoundSize(category, 0.5, channels)])
    assert memory.total.pcm_bytes == 24_000 * 3 * counted


def test_a_length_nobody_asked_for_is_counted_apart_and_cut_cues_not_at_all():
    cues = [
        CueFacts("1", duration_s=1.0, variations=3, category="foley"),
        CueFacts("2", category="foley", variations=2),
        CueFacts("3", duration_s=60.0, state="cut"),
    ]
    memory = memory_use(SPEC, "pc", requested_sizes(cues))
    assert (memory.total.files, memory.total.unknown_files) == (3, 2)
    assert memory.total.pcm_bytes == 3 * 48_000 * 3 * 2
    assert memory.to_dict()["total"]["over_bytes"] is None


def test_a_tenth_of_a_second_is_no_frame_longer():
    assert memory_use(SPEC, "handheld", [SoundSize(None, 0.1)]).total.pcm_bytes == 2_205 * 2


def test_no_sounds_and_no_such_target():
    assert memory_use(SPEC, "handheld", []).total.memory_bytes == 0
    with pytest.raises(SpecError, match="targets of this spec"):
        memory_use(SPEC, "trailer", [])
