"""Paths and files as Windows has them, by Windows' own rules of paths: no test here runs on Windows itself."""

import io
import json
import ntpath
from pathlib import PureWindowsPath
from types import SimpleNamespace

import pytest

from audio_checks.cli import outputs, reporters
from audio_checks.cli.locations import in_repository, uri_of
from audio_checks.run import discovery
from audio_checks.run.discovery import audio_files
from audio_checks.spec.delivery_spec import new_spec
from audio_checks.spec.globs import matches
from audio_checks.spec.sound_names import parse_file_name
from audio_checks.system.windows import reachable, unlimited, without_long_prefix
from tests.support.waves import sine, write_wav

ROOT = PureWindowsPath(r"C:\game")
HERE = PureWindowsPath(r"C:\game\assets")
GOOD = sine(hz=997, dbfs=-6, seconds=0.1)
DEEP = "\\".join(["a_long_folder_name"] * 20)

LONG_PATHS = [
    (r"C:\game\laser.wav", r"C:\game\laser.wav"),
    (rf"C:\game\{DEEP}\laser.wav", rf"\\?\C:\game\{DEEP}\laser.wav"),
    (f"C:/game/{DEEP}/laser.wav".replace("\\", "/"), rf"\\?\C:\game\{DEEP}\laser.wav"),
    (rf"C:\game\x\..\{DEEP}\laser.wav", rf"\\?\C:\game\{DEEP}\laser.wav"),
    (rf"\\server\share\{DEEP}\laser.wav", rf"\\?\UNC\server\share\{DEEP}\laser.wav"),
    (rf"\\?\C:\game\{DEEP}\laser.wav", rf"\\?\C:\game\{DEEP}\laser.wav"),
]


@pytest.mark.parametrize(("path", "opened"), LONG_PATHS)
def test_long_paths_are_opened_behind_their_prefix(path, opened):
    assert reachable(path, windows=True) == opened
    assert reachable(path, windows=False) == path


@pytest.mark.parametrize(
    ("path", "plain"),
    [
        (r"\\?\C:\game\laser.wav", r"C:\game\laser.wav"),
        (r"\\?\UNC\server\share\laser.wav", r"\\server\share\laser.wav"),
        (r"\\server\share\laser.wav", r"\\server\share\laser.wav"),
        (r"C:\game\laser.wav", r"C:\game\laser.wav"),
    ],
)
def test_and_named_without_it(path, plain):
    assert without_long_prefix(path) == plain


def test_a_folder_is_walked_behind_the_prefix_and_its_files_are_named_without(folder, monkeypatch):
    is_folder = folder.stat()
    monkeypatch.setattr(discovery, "unlimited", lambda path: unlimited(path, windows=True))
    system = SimpleNamespace(
        path=ntpath,
        stat=lambda _: is_folder,
        walk=lambda start, **_: [(rf"{start}\{DEEP}", [], ["laser.wav"])],
    )
    monkeypatch.setattr(discovery, "os", system)
    (found,) = audio_files([r"C:\game"])
    assert found.path == rf"C:\game\{DEEP}\laser.wav"
    assert found.relative == rf"{DEEP}\laser.wav"
    assert reachable(found.path, windows=True) == rf"\\?\C:\game\{DEEP}\laser.wav"


@pytest.mark.parametrize(
    ("path", "inside", "uri"),
    [
        ("laser.wav", "assets/laser.wav", ("assets/laser.wav", True)),
        (r"sub\Laser Fire.wav", "assets/sub/Laser Fire.wav", ("assets/sub/Laser%20Fire.wav", True)),
        (r".\a.wav", "assets/a.wav", ("assets/a.wav", True)),
        (r"..\a.wav", "a.wav", ("a.wav", True)),
        (r"C:\game\assets\a.wav", "assets/a.wav", ("assets/a.wav", True)),
        (r"c:\GAME\assets\a.wav", "assets/a.wav", ("assets/a.wav", True)),
        (r"\\?\C:\game\assets\a.wav", "assets/a.wav", ("assets/a.wav", True)),
        (r"D:\other\a b.wav", None, ("file:///D:/other/a%20b.wav", False)),
        (r"\\server\share\a.wav", None, ("file://server/share/a.wav", False)),
        (r"\\?\UNC\server\share\a.wav", None, ("file://server/share/a.wav", False)),
        (r"\assets\a.wav", None, ("file:///C:/assets/a.wav", False)),
    ],
)
def test_services_get_slashes_below_the_repository(path, inside, uri):
    assert in_repository(path, ROOT, HERE) == inside
    assert uri_of(path, ROOT, HERE) == uri


@pytest.mark.parametrize(
    ("glob", "path", "folder", "found"),
    [
        ("vo/**", r"C:\game\vo\en\line.wav", r"C:\game", True),
        ("vo/**", r"c:\Game\vo\line.wav", r"C:\game", True),
        ("vo/**", r"\\?\C:\game\vo\line.wav", r"C:\game", True),
        ("vo/**", r"\\server\share\vo\line.wav", r"\\?\UNC\server\share", True),
        ("*_amb.wav", r"C:\game\deep\wind_amb.wav", r"C:\game", True),
        ("vo/*", r"C:\game\vo\en\line.wav", r"C:\game", False),
        ("vo/**", r"D:\game\vo\line.wav", r"C:\game", False),
        ("vo/**", r"C:\game\VO\line.wav", r"C:\game", False),  # one verdict on every system
    ],
)
def test_globs_are_about_the_same_files(glob, path, folder, found):
    assert matches(glob, PureWindowsPath(path), PureWindowsPath(folder)) is found


@pytest.mark.parametrize("path", [r"C:\in\laser_fire_02__alt2.wav", r"\\server\in\laser_fire_02__alt2.wav"])
def test_the_name_is_what_follows_the_last_backslash(path):
    assert parse_file_name(path) == ("laser_fire_02", 2, None, ".wav")


def test_a_report_goes_to_a_path_with_a_drive_letter(tmp_path, monkeypatch):
    written = []
    monkeypatch.setattr(outputs.Path, "write_text", lambda path, *_, **__: written.append(str(path)))
    outputs.Outputs([r"sarif:C:\out\audio.sarif", r"json:D:\audio.json"], reporters.formats()).write(lambda *_: "")
    assert written == [r"C:\out\audio.sarif", r"D:\audio.json"]


def crlf(text):
    return b"\xef\xbb\xbf" + text.replace("\n", "\r\n").encode()


def test_specs_lists_and_baselines_with_crlf_and_a_byte_order_mark(folder, run, monkeypatch):
    write_wav(folder / "laser.wav", sine(hz=997, dbfs=-6, seconds=2.0))
    (folder / "base.toml").write_bytes(crlf(new_spec()))
    (folder / "audio-checks.toml").write_bytes(crlf('format = 1\nextend = "base.toml"\n\n[files]\n"*.wav" = "vo"\n'))
    (folder / "sounds.csv").write_bytes(crlf("number,file_name,duration_s,category\n1,laser,2,vo\n"))
    (folder / "baseline.json").write_bytes(crlf('{\n"format": 1,\n"waived": []\n}\n'))
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(b"laser.wav\r\n")))
    asked = ("--list", "sounds.csv", "--baseline", "baseline.json", "--format", "json", "--files-from", "-")
    code, out, err = run("check", *asked)
    (entry,) = json.loads(out)["files"]
    assert (code, err) == (0, "")
    assert (entry["category"], entry["verdict"], entry["path"]) == ("vo", "conforming", "laser.wav")


def test_reports_have_the_same_line_ends_everywhere(folder, run):
    write_wav(folder / "Laser.wav", GOOD)
    run("check", "--spec", "../spec.toml", *(f"--format={name}:{name}.out" for name in reporters.formats()), ".")
    for name in reporters.formats():
        assert b"\r" not in (folder / f"{name}.out").read_bytes()
