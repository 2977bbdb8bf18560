"""Coded game files are handed on byte for byte, or refused in words; no other file is made of one."""

import hashlib
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest
import soundfile

from audio_checks import RenderRefused, Target, Unreadable, check_file, keep_coded, new_spec, parse_spec, render_key
from audio_checks.render.ogg_pages import rewrite_ogg
from tests.support.coded import coded_bytes

VORBIS = Target(name="game", sample_rate_hz=44_100, bit_depth=32, encoding="vorbis", dither="none", quality=0.5)
PCM = Target(name="game", sample_rate_hz=44_100, bit_depth=16)


def stored(tmp_path: Path, ending: str, **more: int) -> Path:
    """Return a coded file under a name without an ending, as the store has it."""
    path = tmp_path / "stored"
    path.write_bytes(coded_bytes(ending, **more))
    return path


@pytest.mark.parametrize(
    ("ending", "encoding", "target"),
    [
        ("ogg", "vorbis", VORBIS),
        ("ogg", "vorbis", replace(VORBIS, sample_rate_hz=48_000)),
        ("ogg", "vorbis", replace(PCM, keep_coded=True)),
        ("mp3", "mp3", replace(PCM, keep_coded=True)),
        ("mp3", "mp3", replace(VORBIS, sample_rate_hz=22_050, channels=2, keep_coded=True)),
    ],
)
def test_the_file_that_a_target_takes_is_the_very_same(
    tmp_path: Path, ending: str, encoding: str, target: Target
) -> None:
    path, out = stored(tmp_path, ending), tmp_path / "game"
    rendered = keep_coded(path, target, out)
    assert out.read_bytes() == path.read_bytes()
    assert rendered.sha256 == rendered.master_sha256 == hashlib.sha256(path.read_bytes()).hexdigest()
    assert (rendered.encoding, rendered.sample_rate_hz, rendered.channels) == (encoding, 44_100, 1)
    assert rendered.frames == soundfile.info(str(path)).frames
    assert (rendered.attenuation_db, rendered.recalculated, rendered.loss) == (0.0, False, None)
    assert -40 < rendered.measurements["rms_dbfs"] < -25  # noise of -26 dBFS that fades to nothing: -4.8 dB


@pytest.mark.parametrize(
    ("ending", "target"),
    [
        ("ogg", PCM),
        ("mp3", VORBIS),
        ("opus", VORBIS),
        ("ogg", replace(VORBIS, sample_rate_hz=22_050)),
        ("ogg", replace(VORBIS, channels=2)),
    ],
)
def test_no_other_file_is_made_of_it(tmp_path: Path, ending: str, target: Target) -> None:
    out = tmp_path / "game"
    with pytest.raises(RenderRefused, match="a coded file is not a master") as refused:
        keep_coded(stored(tmp_path, ending, rate=48_000 if ending == "opus" else 44_100), target, out)
    assert refused.value.code == "render:coded-master"
    assert "keep_coded = true" in refused.value.fix
    assert not out.exists()


def test_a_damaged_file_is_not_handed_on(tmp_path: Path) -> None:
    path = tmp_path / "stored"
    path.write_bytes(coded_bytes("ogg")[:60] + b"\0" * 200)
    with pytest.raises(Unreadable):
        keep_coded(path, VORBIS, tmp_path / "game")
    assert not (tmp_path / "game").exists()


@pytest.mark.parametrize(
    ("start", "length", "points"),
    [("100", "1000", ((100, 1099),)), ("100", "999999", ()), ("-1", "10", ()), ("0", "0", ()), ("", "10", ())],
)
def test_the_loop_of_its_comments_goes_along(
    tmp_path: Path, start: str, length: str, points: tuple[tuple[int, int], ...]
) -> None:
    plain, path = stored(tmp_path, "ogg"), tmp_path / "looped.ogg"
    with plain.open("rb") as source, path.open("wb") as out:
        rewrite_ogg(source, out, encoding="vorbis", serial=1, comments=[("LOOPSTART", start), ("LOOPLENGTH", length)])
    assert keep_coded(path, VORBIS, tmp_path / "game", loop=True).loop_points == points


def test_keys_of_other_targets_stay_as_they_were() -> None:
    key = partial(
        render_key, "a" * 64, loop=False, sample_peak_limit_dbfs=None, true_peak_limit_dbtp=None, tolerance_db=0.05
    )
    assert key(PCM) != key(replace(PCM, keep_coded=True))


def test_a_spec_says_it_and_a_shipped_file_is_read_whatever_the_spec_accepts(tmp_path: Path) -> None:
    spec = parse_spec(new_spec() + "[targets.ship]\nsample_rate_hz = 44100\nbit_depth = 16\nkeep_coded = true\n")
    assert spec.targets["ship"].keep_coded
    assert parse_spec(spec.to_toml()).targets["ship"].keep_coded
    path = tmp_path / "theme.ogg"
    path.write_bytes(coded_bytes("ogg"))
    delivered = check_file(path, spec)
    assert (delivered.verdict, [finding.code for finding in delivered.findings]) == ("unreadable", ["container:ogg"])
    shipped = check_file(path, spec, shipped=True)
    assert shipped.verdict == "rejected"
    assert "container:not-accepted" in [finding.code for finding in shipped.findings]
    assert shipped.facts is not None
    assert shipped.facts["encoding"] == "vorbis"
