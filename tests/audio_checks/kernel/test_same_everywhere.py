"""Renders are the same to the last bit however the kernel was compiled: other compilers, levels, registers."""

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
from audio_checks.render import resample

SOURCES = sorted(str(path) for path in Path(audio_checks.kernel.__file__).parent.glob("*.c"))
KEPT = ["-std=c11", "-ffp-contract=off", "-shared", "-fPIC", "-I", sysconfig.get_path("include")]
BUILDS = {
    "not optimised, plain registers": ["cc", "-O0", "-DCLONES="],
    "optimised, plain registers": ["cc", "-O2", "-DCLONES="],
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


@pytest.mark.parametrize("build", BUILDS)
def test_a_render_is_the_same_to_the_last_bit(build, tmp_path, monkeypatch):
    compiler, *flags = BUILDS[build]
    if shutil.which(compiler) is None:
        pytest.skip(f"{compiler} is not installed")
    noise = np.random.Generator(np.random.Philox(5)).uniform(-1, 1, (30_001, 3))
    noise[9_000:15_000, 1] = 0.0
    pairs = [(96_000, 44_100), (48_000, 32_000), (44_100, 16_000), (8_192, 8_009)]
    wanted = [resample.resample(noise, high, low, loop=loop) for high, low in pairs for loop in (False, True)]
    other = built(tmp_path, compiler, flags)
    for name in ("convert", "fourier", "hush"):
        monkeypatch.setattr(resample, name, getattr(other, name))
    resample._laid_plan.cache_clear()
    got = [resample.resample(noise, high, low, loop=loop) for high, low in pairs for loop in (False, True)]
    resample._laid_plan.cache_clear()
    assert all(np.array_equal(one, two) for one, two in zip(wanted, got, strict=True))
