"""Rendering compared with other resamplers and writers: quality, speed, dither, and the metadata that survives."""

import itertools
import shutil
import struct
import subprocess
import wave
from pathlib import Path

import numpy as np

from audio_checks import wav
from audio_checks.render.render import render_master
from audio_checks.render.resample import resample
from audio_checks.spec.delivery_spec import Target
from benchmarks import peers
from benchmarks.resamplers import SOXR_33, Resampler, Samples, all_of_them, ffmpeg_command
from benchmarks.rows import Row
from benchmarks.timing import Work, command_cpu, in_turns, own_cpu
from tests.support import waves

MASTERS = (192_000, 96_000, 88_200, 48_000, 44_100)
TARGETS = (96_000, 48_000, 44_100, 32_000, 24_000, 22_050, 16_000, 11_025)
ALL_PAIRS = [(high, low) for high, low in itertools.product(MASTERS, TARGETS) if low < high]
FEW_PAIRS = [(96_000, 44_100), (96_000, 48_000), (48_000, 44_100), (44_100, 22_050)]
SPEED_S = 60
FLOOR_DB = -400.0  # of a figure that is exactly zero


def rows(folder: Path, quick: bool, *, full: bool = False) -> list[Row]:
    """Try a few pairs of rates, or all 33; then speed, dither and chunks."""
    pairs = ALL_PAIRS if full else FEW_PAIRS[:2] if quick else FEW_PAIRS
    found = list(_quality(pairs))
    found += _speed(folder, FEW_PAIRS[:1] if quick else FEW_PAIRS, 3 if quick else 7)
    found += [_dither(folder, 16, -96.33), _dither(folder, 8, -48.16), _quiet_tone(folder), _chunks(folder)]
    return found


def _quality(pairs: list[tuple[int, int]]) -> list[Row]:
    """Return the worst of all pairs, ours and each peer's."""
    resamplers = all_of_them()
    worst: dict[str, dict[str, float]] = {}
    for name, work in resamplers.items():
        figures = [_figures(work, high, low) for high, low in pairs]
        worst[name] = {
            "gain": min((figure["gain"] for figure in figures), key=lambda gain: -abs(gain)),
            **{key: max(figure[key] for figure in figures) for key in ("alias", "distortion", "delay", "length")},
        }
    which = f"worst of {len(pairs)} pairs of rates"

    def others(key: str, unit: str) -> str:
        return "; ".join(f"{name}: {one[key]:.4g} {unit}" for name, one in worst.items() if name != "ours")

    ours = worst["ours"]
    return [
        Row(f"gain at 0.95 of the new Nyquist frequency, {which}", abs(ours["gain"]), "dB", 0.001, None, "less",
            f"{ours['gain']:.2g} dB", others("gain", "dB")),
        Row("a full-scale tone above the new Nyquist frequency comes out at", ours["alias"], "dB", -180, None, "less",
            "", others("alias", "dB")),
        Row("997 Hz: distortion and noise, in float", ours["distortion"], "dB", -180, None, "less",
            "", others("distortion", "dB")),
        Row("delay", ours["delay"], "frames", 0.001, None, "less", "", others("delay", "frames")),
        Row("length off the exact one", ours["length"], "frames", 0, None, "less", "", others("length", "frames")),
    ]  # fmt: skip


def _figures(work: Resampler, high: int, low: int) -> dict[str, float]:
    frames = high // 2
    times = np.arange(frames) / high
    edge = work(0.5 * np.sin(2 * np.pi * 0.475 * low * times), high, low)
    above = [work(0.999 * np.sin(2 * np.pi * hz * times), high, low) for hz in _above(high, low)]
    tone = work(0.5 * np.sin(2 * np.pi * 997 * times), high, low)
    level, phase, rest = _fitted(_middle(tone), 997, low, len(tone) // 4)
    return {
        "gain": _db(_fitted(_middle(edge), 0.475 * low, low, 0)[0] / 0.5),
        "alias": max(_db(float(np.abs(_middle(one)).max()) / 0.999) for one in above),
        "distortion": _db(rest / level),
        "delay": abs(phase / (2 * np.pi * 997) * low),
        "length": abs(len(tone) - -(-frames * low // high)),
    }


def _above(high: int, low: int) -> list[float]:
    """Return a frequency just above the new Nyquist frequency, and one far above."""
    return [0.5005 * low, min(0.7 * low, 0.499 * high)]


def _fitted(part: Samples, hz: float, rate: int, first: int) -> tuple[float, float, float]:
    """Return crest and phase of a tone in a part that begins at frame `first`, and the crest of what is left."""
    places = 2 * np.pi * hz * (np.arange(len(part)) + first) / rate
    basis = np.stack([np.sin(places), np.cos(places)], axis=1)
    weights = np.linalg.lstsq(basis, part, rcond=None)[0]
    rest = part - basis @ weights
    return float(np.hypot(*weights)), float(np.arctan2(weights[1], weights[0])), float(np.sqrt(2 * np.mean(rest**2)))


def _middle(samples: Samples) -> Samples:
    return samples[len(samples) // 4 : len(samples) // 4 + len(samples) // 2]


def _db(ratio: float) -> float:
    return 20 * float(np.log10(ratio)) if ratio > 0 else FLOOR_DB


def _speed(folder: Path, pairs: list[tuple[int, int]], runs: int) -> list[Row]:
    return [row for high, low in pairs for row in _speed_of(folder, high, low, runs)]


def _speed_of(folder: Path, high: int, low: int, runs: int) -> list[Row]:
    what = f"{high / 1000:g} → {low / 1000:g} kHz, {SPEED_S} s mono in float64"
    samples = waves.noise(seconds=SPEED_S, dbfs=-12, rate=high)
    raw = folder / f"{high}.f64"
    raw.write_bytes(samples.astype("<f8").tobytes())
    works: dict[str, Work] = {
        "ours": own_cpu(lambda: resample(samples, high, low)),
        "from a file": own_cpu(lambda: resample(np.fromfile(raw, "<f8")[:, np.newaxis], high, low)),
    }
    soxr = peers.module("soxr")
    if soxr is not None:
        works["soxr"] = own_cpu(lambda: soxr.resample(samples, high, low, quality="VHQ"))
    for name, filters in (("ffmpeg", SOXR_33), ("reading", None)):
        command = ffmpeg_command(raw, high, low, filters)
        if command is not None:
            works[name] = command_cpu(command)
    took = in_turns(works, runs)
    shown = {name: f"{seconds * 1000:.0f} ms" for name, seconds in took.items()}
    found = []
    if "soxr" in took:
        ratio = took["soxr"] / took["ours"]
        found.append(Row(what, ratio, "×", 0.5, 1, "more", shown["ours"], f"soxr VHQ: {shown['soxr']}"))
    if "ffmpeg" in took:
        peer = f"ffmpeg, soxr at precision 33: {shown['ffmpeg']}, {shown['reading']} of them without resampling"
        ratio = took["ffmpeg"] / took["from a file"]
        found.append(Row(f"{what}, read from a file", ratio, "×", 1, None, "more", shown["from a file"], peer))
    return found


def _dither(folder: Path, bits: int, theory_dbfs: float) -> Row:
    """Return what writing to fewer bits adds to a tone, against the theory of triangular dither."""
    tone = waves.sine(hz=997, dbfs=-20, seconds=4, rate=44_100)
    master = waves.write_wav(folder / f"tone{bits}.wav", tone, rate=44_100)
    render_master(master, Target("t", 44_100, bits), folder / f"game{bits}.wav")
    level = _db(float(np.sqrt(np.mean((_samples(folder / f"game{bits}.wav") - _samples(master)) ** 2))))
    what = f"noise of {bits} bit against {theory_dbfs} dBFS of theory"
    return Row(what, abs(level - theory_dbfs), "dB", 0.1, None, "less", f"{level:.2f} dBFS", _undithered(folder, bits))


def _undithered(folder: Path, bits: int) -> str:
    """Return how others' rounding keeps a tone far below a step: without dither it is lost, or grows to a step."""
    soundfile = peers.module("soundfile")
    dbfs = -80.0 if bits == 8 else -110.0
    samples = waves.sine(hz=997, dbfs=dbfs, seconds=1, rate=44_100)
    path = folder / "undithered.wav"
    soundfile.write(path, samples, 44_100, subtype="PCM_U8" if bits == 8 else "PCM_16")
    crest = _fitted(_samples(path)[:, 0], 997, 44_100, 0)[0]
    return f"soundfile returns a tone of {dbfs:.0f} dBFS at {_db(crest):.1f} dBFS"


def _quiet_tone(folder: Path) -> Row:
    tone = waves.sine(hz=1_000, dbfs=-80, seconds=21, rate=96_000)
    master = waves.write_wav(folder / "quiet.wav", tone, rate=96_000)
    render_master(master, Target("t", 44_100, 16), folder / "quiet_game.wav")
    part = _samples(folder / "quiet_game.wav")[22_050 : 22_050 + 882_000, 0]
    off = abs(_db(_fitted(part, 1_000, 44_100, 22_050)[0]) + 80)
    return Row("a tone of −80 dBFS at 16 bit is off by", off, "dB", 0.01, None, "less")


def _samples(path: Path) -> Samples:
    with wav.open_regular(path) as file:
        return np.concatenate(list(wav.blocks(file, wav.read_layout(file))))


def _chunks(folder: Path) -> Row:
    """Return how many of nine kinds of chunk survive a render, ours and others'."""
    adtl = waves.chunk(b"LIST", b"adtl" + waves.chunk(b"labl", struct.pack("<I", 1) + b"hit\0"))
    info = waves.chunk(b"LIST", b"INFO" + waves.chunk(b"INAM", b"Door\0\0"))
    cue = waves.chunk(b"cue ", struct.pack("<III4sIII", 1, 1, 96, b"data", 0, 0, 96))
    kept = {
        "bext": waves.chunk(b"bext", b"Door".ljust(602, b"\0")),
        "iXML": waves.chunk(b"iXML", b"<BWFXML><PROJECT>P</PROJECT></BWFXML>"),
        "cue ": cue,
        "smpl": waves.smpl([(96, 9_599)], rate=96_000),
        "adtl": adtl,
        "INFO": info,
        "inst": waves.chunk(b"inst", bytes([60, 0, 0, 0, 127, 1, 127, 0])),
        "acid": waves.chunk(b"acid", struct.pack("<IHHfIHHf", 0, 60, 0x8000, 0.0, 8, 4, 4, 120.0)),
        "xYz1": waves.chunk(b"xYz1", b"unknown!"),
    }
    master = waves.write_wav(
        folder / "chunks.wav", waves.noise(rate=96_000, seconds=0.2), rate=96_000, before=kept.values()
    )
    render_master(master, Target("t", 48_000, 16, chunks="all"), folder / "kept.wav")
    others = {}
    program = peers.ffmpeg()
    if program is not None:
        command = [program, "-v", "error", "-y", "-i", str(master), "-ar", "48000", str(folder / "ffmpeg.wav")]
        subprocess.run(command, check=True, timeout=60)
        others["ffmpeg"] = folder / "ffmpeg.wav"
    if sox := shutil.which("sox"):
        subprocess.run([sox, "-V1", str(master), "-r", "48000", str(folder / "sox.wav")], check=True, timeout=60)
        others["sox"] = folder / "sox.wav"
    pydub = peers.module("pydub")
    if pydub is not None:
        with wave.open(str(folder / "pydub.wav"), "wb") as file:
            sound = pydub.AudioSegment.from_wav(str(master)).set_frame_rate(48_000)
            file.setparams((1, sound.sample_width, 48_000, 0, "NONE", ""))
            file.writeframes(sound.raw_data)
        others["pydub"] = folder / "pydub.wav"
    survivors = "; ".join(f"{name}: {_survivors(path, kept)}" for name, path in others.items())
    return Row(
        "kinds of chunk that survive, of 9", _survivors(folder / "kept.wav", kept), "", 9, None, "more", "", survivors
    )


def _survivors(path: Path, kept: dict[str, bytes]) -> int:
    with wav.open_regular(path) as file:
        layout = wav.read_layout(file)
        payloads = [(chunk.id, wav.chunk_payload(file, chunk)) for chunk in layout.chunks if chunk.id != "data"]
    names = {payload[:4].decode("latin-1") if name == "LIST" else name for name, payload in payloads}
    return len(names & set(kept))
