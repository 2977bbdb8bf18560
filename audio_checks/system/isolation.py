"""Starts helper processes that import only from where this process has imported already.

A game's tree is checked from inside it. Files there (`numpy.py`, `sitecustomize.py`, a package called
`audio_checks`) must never be imported, so helpers run in Python's isolated mode: no working directory on the import
path, no PYTHONPATH, no user site. Import folders outside the interpreter's own are handed over by name.
"""

import os
import shutil
import sys

# What libraries read to find their files; the sandbox's processes see nothing else of this one's environment.
LIBRARY_VARIABLES = frozenset(
    {
        "HOME",
        "LANG",
        "LC_ALL",
        "LC_CTYPE",
        "LD_LIBRARY_PATH",
        "LOCALAPPDATA",
        "NUMBA_CACHE_DIR",
        "SYSTEMROOT",
        "TEMP",
        "TMP",
        "TMPDIR",
        "USERPROFILE",
        "XDG_CACHE_HOME",
    }
)


def isolated_python(code: str, *packages: str) -> list[str]:
    """Return the command that runs code in an isolated interpreter.

    Parameters
    ----------
    code : str
        Python statements. They import the very `audio_checks` that runs here.
    *packages : str
        Further modules that the code imports; the folders that hold their top-level packages join the import path.
    """
    flags = ["-I"]
    if sys.dont_write_bytecode:
        flags.append("-B")
    if sys.pycache_prefix:
        flags += ["-X", f"pycache_prefix={sys.pycache_prefix}"]
    return [sys.executable, *flags, "-c", f"import sys; sys.path[:] = {_merge(packages)}; {code}"]


def library_environment() -> dict[str, str]:
    """Return the part of this process's environment that libraries need, without any setting or secret."""
    kept = {name: value for name, value in os.environ.items() if name.upper() in LIBRARY_VARIABLES}
    if "LD_LIBRARY_PATH" in kept:
        folders = [folder for folder in kept["LD_LIBRARY_PATH"].split(os.pathsep) if os.path.isabs(folder)]
        kept["LD_LIBRARY_PATH"] = os.pathsep.join(folders)
    return kept


def installed_program(name: str) -> str | None:
    """Return the absolute path of a program on PATH; never one of the working directory, where Windows looks first."""
    folders = [folder for folder in os.environ.get("PATH", os.defpath).split(os.pathsep) if os.path.isabs(folder)]
    os.environ["NoDefaultCurrentDirectoryInExePath"] = "1"  # noqa: SIM112 - Windows spells it so
    path = shutil.which(name, path=os.pathsep.join(folders))
    return path if path is not None and os.path.isabs(path) else None


def _merge(packages: tuple[str, ...]) -> str:
    """Return the import path of a helper as code: this process's order, then what an isolated interpreter has."""
    trusted = _folders_imported_from()
    first = [os.path.abspath(entry) for entry in sys.path if os.path.abspath(entry) in trusted]
    last = [folder for package in ("audio_checks", *packages) if (folder := _folder_of(package))]
    return f"list(dict.fromkeys([*{first!r}, *sys.path, *{last!r}]))"


def _folders_imported_from() -> set[str]:
    """Return the folders on the import path whose modules run in this process already, its script aside."""
    folders = set()
    for name, module in list(sys.modules.items()):
        file = getattr(module, "__file__", None)
        if file and "." not in name and name not in ("__main__", "__mp_main__"):
            folder = os.path.dirname(os.path.abspath(file))
            folders.add(os.path.dirname(folder) if hasattr(module, "__path__") else folder)
    return folders


def _folder_of(package: str) -> str | None:
    """Return the folder that holds the top-level package of a module; None where it is not loaded, or built in."""
    module = sys.modules.get(package.partition(".")[0])
    package_path = next(iter(getattr(module, "__path__", ())), None) or getattr(module, "__file__", None)
    return None if package_path is None else os.path.dirname(os.path.abspath(package_path))
