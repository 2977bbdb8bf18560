"""How the compiled kernel is built; everything else is in pyproject.toml."""

import runpy
import sys
import sysconfig
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.errors import CompileError, LinkError, PlatformError

KERNEL = Path("audio_checks/kernel")
MADE_FROM = runpy.run_path(str(KERNEL / "sources.py"))["digest_of"](KERNEL)
# No flag for one CPU and none that reorders sums: figures and renders must be the same on every machine.
UNIX_FLAGS = ["-std=c11", "-O3", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math", "-fvisibility=hidden"]
MSVC_FLAGS = ["/std:c11", "/O2", "/fp:precise"]
COMPILERS = {
    "win32": "the Build Tools for Visual Studio, with the workload for C++",
    "darwin": "Apple's command line tools: xcode-select --install",
}


class BuildKernel(build_ext):
    """Builds with the flags of the compiler at hand; says in one sentence what is missing."""

    def build_extension(self, ext: Extension) -> None:
        """Compile and link the kernel."""
        ext.extra_compile_args = MSVC_FLAGS if self.compiler.compiler_type == "msvc" else UNIX_FLAGS
        headers = Path(sysconfig.get_path("include"), "Python.h")
        if not headers.exists():
            raise SystemExit(
                f"audio-checks has a part in C, and Python's headers are missing ({headers});"
                " install them, on Debian and Ubuntu with: apt-get install python3-dev"
            )
        try:
            super().build_extension(ext)
        except (CompileError, LinkError, PlatformError) as error:
            compiler = COMPILERS.get(
                sys.platform, "gcc or clang, on Debian and Ubuntu with: apt-get install gcc libc6-dev"
            )
            raise SystemExit(
                f"audio-checks has a part in C, and the C compiler is missing or failed ({error}); install {compiler}"
            ) from None


setup(
    ext_modules=[
        Extension(
            "audio_checks.kernel._kernel",
            sources=sorted(str(source) for source in KERNEL.glob("*.c")),
            depends=sorted(str(header) for header in KERNEL.glob("*.h")),
            define_macros=[("SOURCES_SHA256", f'"{MADE_FROM}"')],
            py_limited_api=True,
        )
    ],
    cmdclass={"build_ext": BuildKernel},
    options={"bdist_wheel": {"py_limited_api": "cp311"}},
)
