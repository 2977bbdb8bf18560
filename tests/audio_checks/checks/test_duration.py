"""`duration`: against the spec, and against what the cue asks for."""

import pytest

from audio_checks.spec.delivery_spec import CueFacts
from tests.support.waves import silence

ACCEPTED = "accept.duration_s = { min = 0.01, max = 2.0 }"


def frames(count, rate=48_000, channels=1):
    return silence(seconds=count / rate, rate=rate, channels=channels)


@pytest.mark.parametrize(
    ("count", "codes"),
    [(479, ["duration:short"]), (480, []), (96_000, []), (96_001, ["duration:long"]), (1, ["duration:short"])],
)
@pytest.mark.parametrize("channels", [1, 2])
def test_bounds_are_exact(codes_of, count, codes, channels):
    assert codes_of("duration", frames(count, channels=channels), ACCEPTED) == codes


def test_exact_at_a_rate_that_binary_fractions_miss(codes_of):
    assert codes_of("duration", frames(441, 44_100), ACCEPTED, rate=44_100) == []
    assert codes_of("duration", frames(440, 44_100), ACCEPTED, rate=44_100) == ["duration:short"]


@pytest.mark.parametrize(("count", "codes"), [(60_000, []), (60_001, ["duration:cue"]), (35_999, ["duration:cue"])])
def test_a_request_may_be_missed_by_a_quarter(found_by, count, codes):
    findings = found_by("duration", frames(count), cue=CueFacts("SW-1", duration_s=1.0))
    assert [finding.code for finding in findings] == codes
    assert all(finding.severity == "warning" for finding in findings)


@pytest.mark.parametrize(
    ("count", "fps", "codes"),
    [
        (48_800, None, []),  # a sixtieth of a second over: exactly one frame
        (48_801, None, ["duration:locked"]),
        (47_199, None, ["duration:locked"]),
        (50_000, 24.0, []),
        (50_001, 24.0, ["duration:locked"]),
    ],
)
def test_a_locked_length_allows_one_video_frame(found_by, count, fps, codes):
    cue = CueFacts("SW-1", duration_s=1.0, length_locked=True, frame_rate_fps=fps)
    findings = found_by("duration", frames(count), cue=cue)
    assert [finding.code for finding in findings] == codes
    assert all(finding.severity == "error" for finding in findings)


@pytest.mark.parametrize(
    ("count", "low", "high", "codes"),
    [
        (24_000, 0.5, 1.0, []),
        (23_999, 0.5, 1.0, ["duration:bounds"]),
        (48_000, 0.5, 1.0, []),
        (48_001, 0.5, 1.0, ["duration:bounds"]),
        (1, None, 1.0, []),
        (48_001, None, 1.0, ["duration:bounds"]),
        (480_000, 0.5, None, []),
        (23_999, 0.5, None, ["duration:bounds"]),
    ],
)
def test_bounds_of_the_list_count_in_place_of_a_length(found_by, count, low, high, codes):
    cue = CueFacts("SW-1", duration_s=0.75, duration_min_s=low, duration_max_s=high)
    findings = found_by("duration", frames(count), cue=cue)
    assert [(finding.code, finding.severity) for finding in findings] == [(code, "warning") for code in codes]


def test_locked_bounds_are_an_error_and_say_how_far(found_by):
    cue = CueFacts("SW-1", duration_s=0.5, duration_max_s=0.5, length_locked=True)
    (finding,) = found_by("duration", frames(30_000), cue=cue)
    assert (finding.severity, finding.limit) == ("error", 0.5)
    assert finding.message == "0.625 s long; the sound list asks for at most 0.5 s"
    assert finding.fix == "shorten the sound by 0.125 s or more"


def test_a_cue_that_asks_for_nothing(codes_of):
    assert codes_of("duration", frames(48_000), cue=CueFacts("SW-1")) == []
