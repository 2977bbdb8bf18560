"""AudioFile: facts, one pass, hashes; and no input that breaks it."""

import gc
import hashlib
import math
import subprocess
import sys
import weakref

import numpy as np
import pytest

from audio_checks import wav
from audio_checks.audio import audio_file as audio
from audio_checks.audio.audio_file import FAMILIES, FIGURES, AudioFile
from audio_checks.audio.measurements import PLACES
from audio_checks.errors import Unreadable
from audio_checks.measure.faults import DETECTORS
from tests.support.chunks import bext, cue, info, inst
from tests.support.mutants import mutant
from tests.support.waves import chunk, join, noise, pcm_bytes, silence, sine, smpl, write_large, write_wav


class CountedReads:
    """A file that counts the bytes read from each place."""

    def __init__(self, file, size):
        self.file = file
        self.reads = np.zeros(size, np.int64)

    def read(self, count=-1):
        place = self.file.tell()
        content = self.file.read(count)
        self.reads[place : place + len(content)] += 1
        return content

    def readinto(self, room):
        place = self.file.tell()
        count = self.file.readinto(room)
        self.reads[place : place + count] += 1
        return count

    def __getattr__(self, name):
        return getattr(self.file, name)


@pytest.fixture
def counted(monkeypatch):
    opened = []

    def open_counted(path):
        opened.append(CountedReads(original(path), path.stat().st_size))
        return opened[-1]

    original = wav.open_regular
    monkeypatch.setattr(wav, "open_regular", open_counted)
    return opened


def test_facts(tmp_path):
    path = write_wav(tmp_path / "laser_fire_01.wav", noise(seconds=0.5, rate=96_000, channels=2), rate=96_000, bits=24)
    file = AudioFile(path)
    assert file.facts.to_dict() == {
        "container": "wav",
        "encoding": "pcm",
        "sample_rate_hz": 96_000,
        "bit_depth": 24,
        "effective_bits": 24,
        "channels": 2,
        "frames": 48_000,
        "duration_s": 0.5,
        "chunks": ["fmt ", "data"],
    }
    assert (file.name, file.stem, file.warnings) == ("laser_fire_01.wav", "laser_fire_01", ())


def test_metadata_is_shown_where_there_is_some(tmp_path, monkeypatch):
    monkeypatch.setattr(audio, "READ_BYTES", 500)  # so that chunks come in pieces
    samples = noise(seconds=0.1)
    path = write_wav(tmp_path / "a.wav", samples, before=[bext(description="x" * 256)], after=[cue({1: 480}), inst()])
    facts = AudioFile(path).facts.to_dict()["metadata"]
    assert facts["fields"]["bext.Description"] == "x" * 256
    assert facts["cue_points"] == [{"frame": 480, "label": ""}]
    assert facts["instrument"]["unity_note"] == 60
    assert AudioFile(path).metadata == AudioFile(path).metadata


def test_the_name_as_delivered_wins(tmp_path):
    file = AudioFile(write_wav(tmp_path / "0f3a", noise(seconds=0.1)), name="Schuß.v2.wav")
    assert (file.name, file.stem) == ("Schuß.v2.wav", "Schuß.v2")


@pytest.mark.parametrize("figures", [list(FAMILIES), ["true_peak_dbtp", "edges"], []])
def test_every_byte_of_sound_is_read_once(tmp_path, counted, figures):
    around = {"before": [bext(originator="Mara Lind")], "after": [chunk(b"LIST", bytes(300_000)), info(ICMT="wind")]}
    path = write_wav(tmp_path / "wind.wav", noise(seconds=3, channels=2), **around)
    file = AudioFile(path)
    file.prepare(figures)
    for figure in figures:
        getattr(file.measurements, figure)
    assert (file.sha256, file.facts.effective_bits) == (hashlib.sha256(path.read_bytes()).hexdigest(), 24)
    assert file.metadata.fields.items() >= {"bext.Originator": "Mara Lind", "INFO.ICMT": "wind"}.items()
    (reads,) = counted
    start, size = file.layout.data_offset, file.layout.data_size
    assert (reads.reads[start : start + size] == 1).all()
    assert (reads.reads > 0).all()
    assert reads.reads.sum() < path.stat().st_size + 400  # only headers are seen twice


def test_only_prepared_families_are_measured(tmp_path, monkeypatch):
    made = []
    measuring = audio.Pass
    monkeypatch.setattr(audio, "Pass", lambda layout, wanted: made.extend(wanted) or measuring(layout, wanted))
    file = AudioFile(write_wav(tmp_path / "tick.wav", sine(hz=997)))
    file.prepare(["true_peak_dbtp"])
    file.prepare(["rms_dbfs"])
    assert set(file.measurements.to_dict()) == {*FIGURES["true_peak"], *FIGURES["levels"]} - PLACES
    assert file.measurements.true_peak_dbtp == pytest.approx(-6, abs=0.01)
    assert sorted(made) == ["levels", "true_peak"]
    assert file.measurements.clipped_runs == 0  # not prepared: another pass
    assert sorted(made) == ["flat_tops", "levels", "true_peak"]


def test_faults_are_looked_for_one_by_one_as_together(tmp_path):
    with AudioFile(write_wav(tmp_path / "hum.wav", noise(seconds=2, channels=2))) as file:
        together = file.measurements.to_dict()
    for detector, figures in DETECTORS.items():
        with AudioFile(tmp_path / "hum.wav") as file:
            file.prepare(figures)
            alone = file.measurements.to_dict()
        assert alone == {name: together[name] for name in figures if name not in PLACES}, detector


def test_an_unknown_figure_is_our_fault(tmp_path):
    with pytest.raises(ValueError, match="loudness_of_crickets"):
        AudioFile(write_wav(tmp_path / "tick.wav", sine(hz=997))).prepare(["loudness_of_crickets"])


def test_every_figure_has_an_attribute(tmp_path):
    measurements = AudioFile(write_wav(tmp_path / "hum.wav", noise(seconds=4, channels=2))).measurements
    for figure in FAMILIES:
        assert hasattr(measurements, figure)
    assert set(measurements.to_dict()) == set(FAMILIES) - PLACES


def test_hashes(tmp_path):
    samples = noise(seconds=0.2, channels=2)
    plain = AudioFile(write_wav(tmp_path / "a.wav", samples, bits=16))
    tagged = AudioFile(write_wav(tmp_path / "b.wav", samples, bits=16, before=[chunk(b"bext", bytes(602))]))
    assert plain.pcm_sha256 == tagged.pcm_sha256 == hashlib.sha256(pcm_bytes(samples, 16)).hexdigest()
    assert plain.sha256 != tagged.sha256
    assert tagged.sha256 == hashlib.sha256((tmp_path / "b.wav").read_bytes()).hexdigest()


@pytest.mark.parametrize(("container", "used"), [(24, 16), (32, 24), (24, 8), (16, 8)])
def test_padded_depth_shows(tmp_path, container, used):
    coarse = np.round(noise(seconds=0.1) * 2 ** (used - 1)) / 2 ** (used - 1)
    assert AudioFile(write_wav(tmp_path / "a.wav", coarse, bits=container)).facts.effective_bits == used


def test_float_has_no_effective_bits(tmp_path):
    path = write_wav(tmp_path / "a.wav", noise(seconds=0.1), bits=32, encoding="float")
    assert AudioFile(path).facts.effective_bits is None


def test_an_effect_in_full(tmp_path):
    samples = join(
        silence(seconds=0.02, channels=2),
        sine(hz=997, dbfs=-3, seconds=0.5, channels=2),
        silence(seconds=0.2, channels=2),
    )
    measured = AudioFile(write_wav(tmp_path / "beep.wav", samples)).measurements
    assert measured.sample_peak_dbfs == pytest.approx(-3, abs=0.01)
    assert measured.true_peak_dbtp == pytest.approx(-3, abs=0.05)
    assert measured.rms_dbfs == pytest.approx(-6.01 + 10 * math.log10(0.5 / 0.72), abs=0.01)
    assert measured.edges(-60)[0] == measured.head_silence_ms == pytest.approx(20, abs=0.05)
    assert measured.tail_silence_ms == pytest.approx(200, abs=0.05)
    assert measured.channel_correlation == pytest.approx(1)
    assert measured.max_momentary_lufs == measured.short_loudness_lufs == pytest.approx(-3.0, abs=0.1)
    assert measured.clipped_spans == ()
    assert measured.sample_peak_s == pytest.approx(0.02, abs=0.5)
    assert measured.edges(-200)[0] == pytest.approx(20, abs=0.05)  # zeros are silent at any threshold


def test_the_loop_of_the_smpl_chunk_is_the_seam(tmp_path):
    samples = noise(seconds=1, dbfs=-30)
    samples[10_000:20_000] = sine(hz=480, seconds=10_000 / 48_000)
    looped = AudioFile(write_wav(tmp_path / "engine.wav", samples, after=[smpl([(10_000, 19_999)])]))
    assert looped.layout.loops[0].end == 19_999
    assert looped.measurements.seam_step_db == pytest.approx(0, abs=0.1)


@pytest.mark.parametrize("bits", [8, 16, 24, 32])
@pytest.mark.parametrize("channels", [1, 2, 6])
def test_one_frame_and_silence(tmp_path, bits, channels):
    one = AudioFile(write_wav(tmp_path / "one.wav", np.full((1, channels), 0.5), bits=bits)).measurements
    assert one.sample_peak_dbfs == pytest.approx(-6.0206, abs=1e-4)
    quiet = AudioFile(write_wav(tmp_path / "none.wav", silence(seconds=0.1, channels=channels), bits=bits)).measurements
    assert quiet.is_silence
    assert {quiet.sample_peak_dbfs, quiet.true_peak_dbtp, quiet.rms_dbfs, quiet.short_loudness_lufs} == {-math.inf}
    assert quiet.silent_channels == tuple(range(1, channels + 1))


def test_a_bad_float_shows_when_the_file_streams(tmp_path):
    samples = silence(seconds=3)
    samples[-1] = np.nan
    file = AudioFile(write_wav(tmp_path / "nan.wav", samples, bits=32, encoding="float"))
    with pytest.raises(Unreadable) as refusal:
        _ = file.sha256
    assert refusal.value.rule == "R7"


def test_the_input_stays_as_it_was(tmp_path):
    path = write_wav(tmp_path / "a.wav", noise(seconds=0.1))
    before = (path.read_bytes(), path.stat().st_mtime_ns)
    AudioFile(path).measurements.to_dict()
    assert (path.read_bytes(), path.stat().st_mtime_ns) == before


@pytest.mark.parametrize("name", ["new\nline.wav", "\u202eevil.wav", "x" * 255, "\x07\x1b[31m.wav", "dot."])
def test_strange_names(tmp_path, name):
    file = AudioFile(write_wav(tmp_path / name, noise(seconds=0.01)))
    assert file.name == name
    (tmp_path / name).write_bytes(b"no sound")
    with pytest.raises(Unreadable) as refusal:
        AudioFile(tmp_path / name)
    assert str(refusal.value).isprintable()


def test_closing(tmp_path):
    with AudioFile(write_wav(tmp_path / "a.wav", noise(seconds=0.1))) as file:
        peak = file.measurements.sample_peak_dbfs
    assert file._file.closed
    assert file.measurements.sample_peak_dbfs == peak


@pytest.mark.slow
def test_mutants_are_measured_or_refused(tmp_path):
    rng = np.random.default_rng(7)
    path, measured = tmp_path / "mutant.wav", 0
    with np.errstate(all="raise", under="ignore"):
        for _ in range(1_000):
            path.write_bytes(mutant(rng))
            try:
                with AudioFile(path) as file:
                    figures = file.measurements.to_dict()
            except Unreadable:
                continue
            assert not any(isinstance(value, float) and math.isnan(value) for value in figures.values())
            measured += 1
    assert measured > 50


@pytest.mark.slow
def test_the_import_is_light():
    script = (
        "import sys, audio_checks.audio.audio_file; print({'soundfile', 'scipy', 'librosa', 'app'} & set(sys.modules))"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "set()"


@pytest.mark.slow
def test_a_long_file_takes_no_more_memory_than_a_short_one(tmp_path):
    # 2 GiB are measured by `make bench`; what does not grow from 2 minutes to 6 minutes does not grow.
    script = """
import sys
from audio_checks.audio.audio_file import AudioFile
AudioFile(sys.argv[1]).measurements.to_dict()
print(open("/proc/self/status").read().partition("VmHWM:")[2].split()[0])
"""
    taken_kib = []
    for mebibytes in (32, 96):
        path = write_large(tmp_path / f"{mebibytes}.wav", mebibytes << 20)
        done = subprocess.run([sys.executable, "-c", script, path], capture_output=True, text=True, check=True)
        taken_kib.append(int(done.stdout))
    assert taken_kib[1] < taken_kib[0] + 8 * 1_024
    assert taken_kib[1] < 120 * 1_024  # the interpreter and numpy alone take 40 MiB


def test_a_file_that_was_closed_is_gone_when_nobody_holds_it(tmp_path):
    # A ring of references would keep its arrays until the garbage collector comes by.
    path = write_wav(tmp_path / "laser.wav", sine(hz=997, dbfs=-6))
    with AudioFile(path) as file:
        assert file.facts.to_dict()["frames"] == file.layout.frames
        assert file.measurements.sample_peak_dbfs < 0
    left = weakref.ref(file)
    assert file.facts.frames == file.layout.frames  # what was measured stays
    file.close()
    gc.disable()
    try:
        del file
        assert left() is None
    finally:
        gc.enable()


@pytest.mark.filterwarnings("error::RuntimeWarning")
@pytest.mark.parametrize("gain", [1e-300, 1e-44, 1e6, 1e18])
def test_every_figure_of_numbers_that_only_float_holds(tmp_path, gain):
    samples = join(silence(seconds=0.1), noise(seconds=0.3, channels=2)[:, :1], silence(seconds=0.2)) * gain
    with AudioFile(write_wav(tmp_path / "a.wav", samples, bits=64, encoding="float")) as file:
        figures = file.measurements.to_dict()
        assert file.errors == {}
    numbers = [value for value in figures.values() if isinstance(value, float)]
    assert not [value for value in numbers if np.isnan(value) or value == np.inf]
