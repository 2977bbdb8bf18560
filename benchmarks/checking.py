"""Checks of whole files compared with other tools on the same files: CPU seconds, as ratios."""

import os
import sys
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from multiprocessing import get_context
from pathlib import Path

import soundfile

import audio_checks
from audio_checks import wav
from audio_checks.checks import all_checks
from benchmarks import peers, sounds
from benchmarks.rows import Row
from benchmarks.timing import command_cpu, in_turns, own_cpu, wall

LIMITS = (
    "structure",
    "sample-peak",
    "true-peak",
    "loudness",
    "dc-offset",
    "silence",
    "head-silence",
    "tail-silence",
    "noise-floor",
)
MORE_LIMITS = """\
loudness_lufs = { min = -60.0, max = 0.0 }
noise_floor_dbfs = -20.0

[naming]"""


def rows(folder: Path, quick: bool) -> list[Row]:
    """Measure whole minutes, short effects, a cold start and two processes."""
    runs = 3 if quick else 9
    spec = every_limit()
    found: list[Row] = []
    for rate, bits, must, stretch in ((96_000, 24, 8, 20), (44_100, 16, 15, 40)):
        path = sounds.write(folder / f"minute_{rate}.wav", sounds.minute(rate), rate, bits)
        found += _minute(path, f"60 s, {rate / 1000:g} kHz/{bits} bit stereo", spec, runs, must, stretch)
        found += _materials(folder, rate, bits, spec, 3 if quick else 5, must, stretch)
    found += _effects(folder / "effects", spec, quick)
    found.append(_cold(folder / "effects" / "effect_0000.wav", runs))
    found += _two_jobs(folder / "effects", spec, quick)
    return found


def every_limit() -> audio_checks.DeliverySpec:
    """Return a spec that states every limit, so that every check is called, and asks for no judgement."""
    text = audio_checks.new_spec("48k", name="bench").replace("[naming]", MORE_LIMITS, 1)
    text = text.replace('adds = ["reverb"]', "adds = []")
    return audio_checks.parse_spec(text.replace("bit_depths = [24]", "bit_depths = [16, 24]"))


def read_by_soundfile(path: Path) -> Callable[[], object]:
    """Return the floor: soundfile reading and decoding the file block by block."""

    def read() -> None:
        with soundfile.SoundFile(path) as file:
            for _ in file.blocks(blocksize=wav.BLOCK_FRAMES, dtype="float64"):
                pass

    return read


def read_by_us(path: Path) -> Callable[[], object]:
    """Return the same by our own reader."""

    def read() -> None:
        with wav.open_regular(path) as file:
            for _ in wav.blocks(file, wav.read_layout(file)):
                pass

    return read


def _minute(
    path: Path, sound: str, spec: audio_checks.DeliverySpec, runs: int, must: float, stretch: float
) -> list[Row]:
    works = {
        "full": own_cpu(lambda: audio_checks.check_file(path, spec)),
        "limits": own_cpu(lambda: audio_checks.check_file(path, spec, checks=LIMITS)),
        "measure": own_cpu(lambda: audio_checks.measure_file(path)),
        "floor": own_cpu(read_by_soundfile(path)),
        "own floor": own_cpu(read_by_us(path)),
    }
    commands = {"ffmpeg": peers.ffmpeg_measures(path), "sox": peers.sox_stats(path), "loudgain": peers.loudgain(path)}
    works |= {name: command_cpu(command) for name, command in commands.items() if command}
    if meter := peers.pyloudnorm_integrated(path):
        works["pyloudnorm"] = own_cpu(meter)
    took = in_turns(works, runs)
    full, limits, floor = took["full"], took["limits"], took["floor"]

    def beside(
        what: str, ours: float, peer: str, name: str, must: float | None = None, best: float | None = None
    ) -> Row:
        if peer not in took:
            return Row(what, None, must=must, stretch=best, missing=f"{name} is not installed")
        return Row(what, took[peer] / ours, "×", must, best, ours=_ms(ours), peer=f"{name}: {_ms(took[peer])}")

    def floors(what: str, ours: float, must: float | None = None, best: float | None = None) -> Row:
        peer = f"soundfile, blocks of float64: {_ms(floor)}; our own reader: {_ms(took['own floor'])}"
        return Row(what, ours / floor, "×", must, best, "less", _ms(ours), peer)

    at_96 = must == 8
    filters = f"{peers.ffmpeg_version()}, ebur128=peak=true and astats"
    return [
        beside(f"full check (every check but the judgements), {sound}", full, "ffmpeg", filters, must, stretch),
        beside("structure and `[limits]` alone", limits, "ffmpeg", filters),
        floors("full check, in times of reading and decoding", full, *((3, 1.3) if at_96 else ())),
        floors("structure and `[limits]` alone, in times of reading and decoding", limits),
        beside("full check, beside statistics alone", full, "sox", "sox stats", None if at_96 else 1),
        beside("structure and `[limits]` alone, beside statistics alone", limits, "sox", "sox stats"),
        beside("full check", full, "loudgain", "loudgain (libebur128)"),
        beside("full check", full, "pyloudnorm", "pyloudnorm, integrated loudness alone"),
        beside("every figure there is (`measure`)", took["measure"], "ffmpeg", filters),
    ]


def _materials(
    folder: Path, rate: int, bits: int, spec: audio_checks.DeliverySpec, runs: int, must: float, stretch: float
) -> list[Row]:
    """Measure a full check of each material; the must holds for each, the stretch for the one in the middle."""
    rows, path = [], folder / "material.wav"
    for name, make in sounds.materials(rate, bits).items():
        what = f"full check of {name}, 60 s, {rate / 1000:g} kHz/{bits} bit stereo"
        command = peers.ffmpeg_measures(sounds.write(path, make(), rate, bits))
        if command is None:
            rows.append(Row(what, None, must=must, missing="ffmpeg is not installed"))
            continue
        took = in_turns(
            {"ours": own_cpu(lambda: audio_checks.check_file(path, spec)), "ffmpeg": command_cpu(command)}, runs
        )
        ours, theirs = took["ours"], took["ffmpeg"]
        peer = f"{peers.ffmpeg_version()}: {_ms(theirs)}"
        rows.append(Row(what, theirs / ours, "×", must, ours=_ms(ours), peer=peer))
    middle = sorted(rows, key=lambda row: row.reached or 0.0)[len(rows) // 2]
    rows[rows.index(middle)] = replace(middle, stretch=stretch)
    return rows


def _effects(folder: Path, spec: audio_checks.DeliverySpec, quick: bool) -> list[Row]:
    count, times = (50, 2) if quick else (250, 4)
    paths = sounds.effects(folder, count)
    others = [name for name in all_checks() if name not in LIMITS]

    def each(work: Callable[[Path], object]) -> Callable[[], object]:
        return lambda: [work(path) for path in paths]

    works = {
        "limits": own_cpu(each(lambda path: audio_checks.check_file(path, spec, checks=LIMITS))),
        "others": own_cpu(each(lambda path: audio_checks.check_file(path, spec, checks=others))),
        "full": own_cpu(each(lambda path: audio_checks.check_file(path, spec))),
        "pydub": own_cpu(each(peers.pydub_levels)),
    }
    took = {name: seconds / count for name, seconds in in_turns(works, times).items()}
    files = f"{count} files, {times} times"
    pydub = f"pydub, peak and level: {_ms(took['pydub'])}"
    what = "short effects (0.2 to 3 s, 48 kHz/24 bit), one warm process: structure and `[limits]`"
    found = [
        Row(what, took["limits"] * 1000, "ms", 1.2, 0.5, "less", files, pydub),
        Row("short effects, all other checks but the judgements", took["others"] * 1000, "ms", 4, None, "less"),
        Row("short effects, every check at once", took["full"] * 1000, "ms", None, None, "less"),
    ]
    what = "short effects, structure and `[limits]`, a file"
    commands = [peers.ffmpeg_measures(path) for path in paths[: 10 if quick else 40]]
    if None in commands:
        return [*found, Row(what, None, must=25, missing="ffmpeg is not installed")]
    works = {"ffmpeg": lambda: sum(command_cpu(command or [])() for command in commands)}
    a_file = in_turns(works, 2)["ffmpeg"] / len(commands)
    peer = f"{peers.ffmpeg_version()}, one process a file: {_ms(a_file)}"
    return [*found, Row(what, a_file / took["limits"], "×", 25, None, "more", _ms(took["limits"]), peer)]


def _cold(path: Path, runs: int) -> Row:
    works = {
        "ours": command_cpu([sys.executable, "-m", "audio_checks.cli", "check", "--no-cache", str(path)]),
        "librosa": command_cpu([sys.executable, "-c", "import librosa; librosa.load"]),
    }
    took = in_turns(works, runs)
    peer = f"importing librosa's reader: {took['librosa']:.2f} s"
    return Row("first verdict of a cold command line", took["ours"], "s", 0.5, 0.2, "less", "", peer)


def _two_jobs(folder: Path, spec: audio_checks.DeliverySpec, quick: bool) -> list[Row]:
    paths = sorted(folder.iterdir()) * (4 if quick else 8)
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as apart:

        def check_by(jobs: int) -> Callable[[], object]:
            return lambda: audio_checks.check_files(paths, spec, jobs=jobs)

        def check_halves_apart() -> None:
            for run in [apart.submit(_check_alone, half, spec) for half in (paths[::2], paths[1::2])]:
                run.result()

        works = {"1": check_by(1), "2": check_by(2), "apart": check_halves_apart}
        took = in_turns({name: wall(work) for name, work in works.items()}, 3 if quick else 5)
    one, two, side_by_side = took["1"], took["2"], took["apart"]
    peer = f"{len(paths)} files by one job: {one:.2f} s; {os.cpu_count()} cores"
    most = f"half of the files by one process each: {side_by_side:.2f} s, {one / side_by_side:.2f} × one job"
    return [
        Row("two jobs beside one (wall)", one / two, "×", 1.7, None, "more", f"{two:.2f} s", peer),
        Row(
            "two jobs beside two runs that share nothing: the most there is",
            side_by_side / two,
            "×",
            peer=most,
        ),
    ]


def _check_alone(paths: list[Path], spec: audio_checks.DeliverySpec) -> None:
    audio_checks.check_files(paths, spec)


def _ms(seconds: float) -> str:
    return f"{seconds * 1000:.3g} ms" if seconds < 1 else f"{seconds:.2f} s"
