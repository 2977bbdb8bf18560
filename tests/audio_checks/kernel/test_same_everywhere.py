"""Figures and renders are the same to the last bit, whatever compiler, level and registers made the kernel."""

import shutil
import subprocess
import sysconfig
from importlib.machinery import ExtensionFileLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

import audio_checks.kernel
from audio_checks.measure import codec_frames
from audio_checks.measure.loudness import _recursion
from audio_checks.measure.window_powers import twiddle_factors
from audio_checks.render import resample, resample_plan

pytestmark = pytest.mark.slow

SOURCES = sorted(str(path) for path in Path(audio_checks.kernel.__file__).parent.glob("*.c"))
KEPT = ["-std=c11", "-ffp-contract=off", "-shared", "-fPIC", "-I", sysconfig.get_path("include")]
BUILDS = {
    "not optimised, plain registers": ["cc", "-O0", "-DPLAIN_REGISTERS"],
    "optimised, plain registers": ["cc", "-O2", "-DPLAIN_REGISTERS"],
    "another compiler": ["clang", "-O2"],
}


def built(folder: Path, compiler: str, flags: list[str]) -> ModuleType:
    target = folder / "_kernel.abi3.so"
    subprocess.run([compiler, *KEPT, *flags, *SOURCES, "-o", str(target), "-lm"], check=True)
    loader = ExtensionFileLoader("_kernel", str(target))
    spec = spec_from_loader("_kernel", loader)
    assert spec is not None
    module = module_from_spec(spec)
    loader.exec_module(module)
    return module


@pytest.fixture(scope="module", params=BUILDS)
def other(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    compiler, *flags = BUILDS[request.param]
    if shutil.which(compiler) is None:
        pytest.skip(f"{compiler} is not installed")
    return built(tmp_path_factory.mktemp("kernel"), compiler, flags)


def figures_of(kernel: ModuleType, samples: np.ndarray, rate: int) -> list[np.ndarray]:
    """What every loop that looks at all samples makes of them."""
    channels, frames = samples.shape
    rows, sums, products = np.empty((channels, -(-frames // 32))), np.zeros((channels, 2)), np.zeros((channels,) * 2)
    kernel.maxima(samples, rows)
    kernel.sums(samples, sums)
    raw, decoded = (samples.T * 2**23).astype("<i4").tobytes(), np.zeros((channels, 6 + frames + 24))
    surveyed = np.empty_like(rows), np.zeros((channels, 3)), np.empty((5 * channels, frames // 24))
    kernel.survey(raw, 32, False, decoded, 6, *surveyed, 24, None, 1, 0)
    raw, sixteen, hops = (samples.T * 2**15).astype("<i2").tobytes(), np.zeros_like(decoded), np.zeros((100, 4))
    whole = np.empty_like(rows), np.zeros((channels, 3)), np.empty((5 * channels, frames // 22))
    kernel.survey(raw, 16, False, sixteen, 6, *whole, 22, *((hops, 997, 5) if channels == 2 else (None, 1, 0)))
    kernel.products(samples, products)
    sums_of_cells = np.empty((2 * channels, frames // 22))
    kernel.survey(raw, 16, False, np.zeros_like(decoded), 6, *whole[:2], sums_of_cells, 22, None, 1, 0)
    cells = [np.empty((5 * channels, (frames - 6) // size)) for size in (1, 3, 22, 24, 48)]
    for figures, size in zip(cells, (1, 3, 22, 24, 48), strict=True):
        kernel.cells(samples, 6, size, figures)
    stereo = np.zeros((frames // 1_000 + 1, 4))
    kernel.stereo_products(samples[[0, -1]], 0, 1_000, stereo)
    unforeseen = np.empty((2, 20))
    kernel.unforeseen(
        samples[0],
        np.array([40, 16_000]),
        np.hanning(3_001),
        20,
        150,
        0,
        1,
        0.0,
        -1.0,
        unforeseen,
        np.empty(2, np.int64),
    )
    unpredicted = np.full((2, 40), -1)
    starts = np.linspace(2_000, frames - 4_000, 40).astype(np.int64)
    windows = np.hanning(480), np.hanning(83 * 20)
    kernel.unforeseen_both_ways(samples[0], 1, starts, *windows, 20, 20, 3, 0.8, 0.8, unpredicted[0])
    thinned = np.hanning(144), np.hanning(83 * 6)
    kernel.unforeseen_both_ways(samples[0], 3, starts, *thinned, 20, 6, 3, 0.8, 0.8, unpredicted[1])
    even = channels + channels % 2
    energies = np.empty(frames * 100 // rate + 2)
    kernel.hop_energies(
        samples, _recursion(rate), np.ones(even), np.zeros(6 * even), np.zeros(even), energies, rate, 0, 0
    )
    of_windows = np.empty(len(energies) - 39)
    kernel.window_loudness(np.abs(samples[0, : len(energies)]), -300, 40, rate, of_windows)
    again, standing, bent = np.zeros((64, 3), np.int64), np.zeros((frames, 5)), np.empty(frames - 2)
    kernel.recurrences(samples[0], 0, 1e-3, 64, 2_000, 4.5, 4, again)
    kernel.bends(samples[-1], bent)
    squares = np.square(samples[-1])
    beside = 0.0, squares, squares, 4, 0.0, 30.0
    kernel.outstanding_amid(np.abs(samples[-1:]), np.zeros(1, np.int64), 1.5, 5, 1, 0.1, *beside, standing)
    burst, powers = np.full(frames, -1), np.zeros(frames)
    kernel.bursts(np.abs(samples[-1]), squares, squares, 2, 6, 4, 1.1, 0.1, 0.0, 30.0, 9.0, burst, powers)
    lines = codec_frames.bands_of(samples[:, :500])
    silent, spectrum = np.empty(1_000, np.int64), codec_frames._spectrum(samples[0, :16_384])
    kernel.silent_lines(spectrum, *lines, codec_frames._turns(), 499, 1_000, 15, 0.03, 1e-6, 5.0, silent)
    octaves, fine = np.array([[1, 2, 1], [2, 6, 4], [6, 90, 84]]), np.array([1, 9, 80])
    decay, levels = np.zeros(((frames - 1) // 240 - 1, 7 * 3 + 2 + 2)), np.empty((channels, 90, 2))
    kernel.decay_rows(samples, np.hanning(480), 240, twiddle_factors(480), octaves, fine, levels, True, decay)
    pitch, spans = np.empty((99, 2)), np.array([[0, 0], [20, 99]])
    of_rows = np.array([7, 50]), np.array([0.3, 0.0]), spans
    kernel.pitch_rows(samples, np.hanning(440), 3, 480, twiddle_factors(440), *of_rows, pitch)
    points = np.zeros((3, 300))
    kernel.shape_points(samples, np.arange(300) * frames // 300, *points)
    by_spectra = [decay, pitch, points]
    found_in_doubles = [silent, rows, sums, *surveyed, decoded, products, *cells, sums_of_cells, stereo, unforeseen]
    by_clicks = [unpredicted, standing, bent, burst, powers]
    return [*found_in_doubles, *whole, sixteen, hops, energies, of_windows, again, *by_clicks, *by_spectra]


@pytest.mark.parametrize("channels", [1, 2, 3])
def test_figures_are_the_same_to_the_last_bit(other, channels):
    samples = np.random.Generator(np.random.Philox(6)).uniform(-1, 1, (channels, 48_017))
    samples[:, 9_000:15_000] *= 1e-5
    samples[0, 20_000:30_000] = 0.0
    for at, length in ((31_000, 64), (33_000, 127), (36_000, 1_999)):  # come twice
        samples[0, at : at + length] = samples[0, at - length : at]
    wanted, got = (figures_of(kernel, samples, 48_000) for kernel in (audio_checks.kernel, other))
    assert all(one.tobytes() == two.tobytes() for one, two in zip(wanted, got, strict=True))


def test_a_render_is_the_same_to_the_last_bit(other, monkeypatch):
    noise = np.random.Generator(np.random.Philox(5)).uniform(-1, 1, (30_001, 3))
    noise[9_000:15_000, 1] = 0.0
    pairs = [(96_000, 44_100), (48_000, 32_000), (44_100, 16_000), (8_192, 8_009)]
    wanted = [resample.resample(noise, high, low, loop=loop) for high, low in pairs for loop in (False, True)]
    for module, name in (
        (resample, "convert"),
        (resample, "fourier"),
        (resample, "restore_silence"),
        (resample_plan, "fourier"),
    ):
        monkeypatch.setattr(module, name, getattr(other, name))
    resample_plan._laid_plan.cache_clear()
    got = [resample.resample(noise, high, low, loop=loop) for high, low in pairs for loop in (False, True)]
    resample_plan._laid_plan.cache_clear()
    assert all(np.array_equal(one, two) for one, two in zip(wanted, got, strict=True))
