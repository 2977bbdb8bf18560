"""Game files are the same to the last byte whatever made the kernel, and whatever the processor can do.

Each run is a process of its own. The plainest has a kernel that was not optimised, numpy without any of its
faster loops, and a C library without the instructions that make its logarithms and powers differ in their last bit.
"""

import json
import os
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import numpy as np
import pytest
from numpy._core._multiarray_umath import __cpu_dispatch__, __cpu_features__

import audio_checks.kernel
from audio_checks.kernel.sources import digest_of
from tests.support.waves import noise, sine, smpl, swelling, write_wav

pytestmark = pytest.mark.slow

ROOT = Path(__file__).resolve().parents[3]
KERNEL = Path(audio_checks.kernel.__file__).parent
PLAIN = {
    "NPY_DISABLE_CPU_FEATURES": " ".join(name for name in __cpu_dispatch__ if __cpu_features__.get(name)),
    "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX512F,-AVX2,-FMA,-FMA4,-AVX,-SSE4_1",
    "OPENBLAS_CORETYPE": "Prescott",
}
RUN = """
import json, sys
from importlib.machinery import ExtensionFileLoader
from importlib.util import module_from_spec, spec_from_loader
if sys.argv[3]:
    name = "audio_checks.kernel._kernel"
    loader = ExtensionFileLoader(name, sys.argv[3])
    module = module_from_spec(spec_from_loader(name, loader))
    loader.exec_module(module)
    sys.modules[name] = module
from pathlib import Path
from audio_checks.placeholders.make import make_placeholders
from audio_checks.render.render import render_master
from audio_checks.spec.sound_list import read_sound_list
from audio_checks.spec.delivery_spec import Target, parse_spec
folder, out = Path(sys.argv[1]), Path(sys.argv[2])
made = {}
for master, target, more in [
    ("loud.wav", Target("pc", 44100, 16), {"true_peak_limit_dbtp": -1.0}),
    ("loud.wav", Target("old", 22050, 8, channels=1, mono_gains=(0.7, 0.45), shelf_db="auto"), {}),
    ("loud.wav", Target("odd", 44101, 24, shelf_db=2.5, fade_in_ms=7.0, fade_out_ms=11.0), {}),
    ("loud.wav", Target("shaped", 48000, 16, dither="shaped"), {"sample_peak_limit_dbfs": -3.0}),
    ("loud.wav", Target("float", 32000, 32, encoding="float", trim_below_dbfs=-40.0), {}),
    ("loop.wav", Target("loop", 44100, 16), {}),
    ("loop.wav", Target("whole", 11025, 16), {"loop": True, "loop_points": (0, 12002)}),
]:
    rendered = render_master(folder / master, target, out / "game.wav", **more)
    made[target.name] = [rendered.sha256, rendered.attenuation_db]
spec = parse_spec("format = 1\\nlimits.loudness_lufs = { min = -20, max = -18 }")
for one in make_placeholders(read_sound_list("number,name,variations\\nSW-014,door,2\\n"), spec, out, voice=False):
    made[one.path.name] = [one.path.read_bytes().hex(), 0]
print(json.dumps(made))
"""


@pytest.fixture(scope="module")
def masters(tmp_path_factory):
    folder = tmp_path_factory.mktemp("masters")
    loud = swelling(np.clip(noise(dbfs=-6, seconds=0.2, rate=96_000, channels=2), -0.999, 0.999))
    loud[6_000:9_000] = 0.0
    write_wav(folder / "loud.wav", loud, rate=96_000)
    loop = noise(dbfs=-20, seconds=12_003 / 96_000, rate=96_000) + sine(hz=1_000, seconds=12_003 / 96_000, rate=96_000)
    write_wav(folder / "loop.wav", loop, rate=96_000, before=[smpl([(1_000, 9_006)], rate=96_000)])
    return folder


def renders(masters, out, *, kernel="", environment=None):
    out.mkdir()
    reported = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", RUN, str(masters), str(out), str(kernel)],
        env={**os.environ, **(environment or {}), "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert reported.returncode == 0, reported.stderr
    return json.loads(reported.stdout)


@pytest.fixture(scope="module")
def as_installed(masters, tmp_path_factory):
    made = renders(masters, tmp_path_factory.mktemp("out") / "installed")
    assert made["pc"][1] > 0
    assert made["shaped"][1] > 0
    return made


def compiled(folder, compiler, *flags):
    if shutil.which(compiler) is None:
        pytest.skip(f"{compiler} is not installed")
    kernel = folder / "_kernel.abi3.so"
    kept = ["-std=c11", "-ffp-contract=off", "-shared", "-fPIC", "-I", sysconfig.get_path("include")]
    kept.append(f'-DSOURCES_SHA256="{digest_of(KERNEL)}"')
    sources = sorted(map(str, KERNEL.glob("*.c")))
    subprocess.run([compiler, *kept, *flags, *sources, "-o", str(kernel), "-lm"], check=True, timeout=300)
    return kernel


def test_not_optimised_on_the_plainest_processor(masters, as_installed, tmp_path):
    kernel = compiled(tmp_path, "cc", "-O0", "-DPLAIN_REGISTERS")
    assert renders(masters, tmp_path / "out", kernel=kernel, environment=PLAIN) == as_installed


def test_by_another_compiler(masters, as_installed, tmp_path):
    kernel = compiled(tmp_path, "clang", "-O2")
    assert renders(masters, tmp_path / "out", kernel=kernel) == as_installed
