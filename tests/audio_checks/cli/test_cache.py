"""What is remembered is what would be said again, and nothing else."""

import dataclasses
import json
import math
import os
import sqlite3
import time

import pytest

from audio_checks.run import cache as cache_module
from audio_checks.run import runner
from audio_checks.run.cache import VerdictCache, default_folder
from audio_checks.spec.delivery_spec import CueFacts, new_spec, parse_spec
from tests.support.waves import silence, sine, write_wav

GOOD = sine(hz=997, dbfs=-6, seconds=0.1)
LOUD = sine(hz=997, dbfs=0.0, seconds=0.1)
SPEC = parse_spec(new_spec())
LONG_AGO_NS = 1_700_000_000_500_000_000


@pytest.fixture
def judged(monkeypatch):
    """The paths that were judged, and not remembered."""
    paths = []
    judge = runner.judge

    def noting(tasks, **options):
        paths.extend(task.path for task in tasks)
        return judge(tasks, **options)

    monkeypatch.setattr(runner, "judge", noting)
    return paths


@pytest.fixture
def settled(monkeypatch):
    """Files count as left alone at once, as they are a moment later."""
    monkeypatch.setattr(cache_module, "SETTLED_NS", -1)


def asked(folder, tasks):
    cache = VerdictCache(folder)
    try:
        known = cache.recall(tasks)
        left = [task for task, entry in zip(tasks, known, strict=True) if entry is None]
        judged = runner.judge(left)
        cache.remember(left, judged)
        fresh = iter(judged)
        return [entry or next(fresh) for entry in known], len(left)
    finally:
        cache.close()


def task(path, **facts):
    return dataclasses.replace(runner.task_for(path, SPEC), **facts)


class TestVerdicts:
    def test_they_are_the_same_remembered_or_not(self, tmp_path):
        write_wav(tmp_path / "good.wav", GOOD)
        write_wav(tmp_path / "Loud One.wav", LOUD)
        write_wav(tmp_path / "nothing.wav", silence(seconds=0.1))
        (tmp_path / "cut.wav").write_bytes(b"RIFF")
        tasks = [task(str(path)) for path in sorted(tmp_path.glob("*.wav"))]
        first, judged = asked(tmp_path / "kept", tasks)
        again, judged_again = asked(tmp_path / "kept", tasks)
        assert (judged, judged_again) == (4, 0)
        assert [entry.to_dict() for entry in again] == [entry.to_dict() for entry in first]
        quiet = next(entry for entry in again if entry.path.endswith("nothing.wav"))
        assert quiet.measurements["sample_peak_dbfs"] == -math.inf  # not None: checks over sets compare levels

    @pytest.mark.parametrize("settle", [True, False])
    def test_a_changed_file_is_judged_again(self, tmp_path, settle, monkeypatch):
        if settle:
            monkeypatch.setattr(cache_module, "SETTLED_NS", -1)
        path = write_wav(tmp_path / "laser.wav", GOOD)
        asked(tmp_path / "kept", [task(str(path))])
        os.utime(write_wav(path, LOUD), ns=(LONG_AGO_NS, LONG_AGO_NS))
        (entry,), judged = asked(tmp_path / "kept", [task(str(path))])
        assert (judged, entry.verdict) == (1, "rejected")

    def test_a_moved_file_is_known_by_its_bytes(self, tmp_path):
        path = write_wav(tmp_path / "laser.wav", LOUD)
        asked(tmp_path / "kept", [task(str(path))])
        (tmp_path / "moved").mkdir()
        path.rename(tmp_path / "moved" / "laser.wav")
        (entry,), judged = asked(tmp_path / "kept", [task(str(tmp_path / "moved" / "laser.wav"))])
        assert judged == 0
        assert entry.path == str(tmp_path / "moved" / "laser.wav")

    @pytest.mark.parametrize(
        "change",
        [
            {"spec": parse_spec(new_spec().replace("sample_peak_dbfs = -0.1", "sample_peak_dbfs = -12.0"))},
            {"spec": SPEC.for_category("vo")},
            {"spec": SPEC.for_target("game")},
            {"spec": None},
            {"cue": CueFacts(number="1", duration_s=9.0)},
            {"unlisted": True},
        ],
        ids=lambda change: next(iter(change)),
    )
    def test_what_a_verdict_depends_on_makes_another(self, tmp_path, change):
        path = str(write_wav(tmp_path / "laser.wav", GOOD))
        asked(tmp_path / "kept", [task(path)])
        assert asked(tmp_path / "kept", [task(path, **change)])[1] == 1
        assert asked(tmp_path / "kept", [task(path)])[1] == 0

    def test_so_does_a_name(self, tmp_path):
        path = write_wav(tmp_path / "laser.wav", GOOD)
        asked(tmp_path / "kept", [task(str(path))])
        (entry,), judged = asked(tmp_path / "kept", [task(str(path.rename(tmp_path / "Laser.wav")))])
        assert (judged, entry.findings[0].code) == (1, "naming:pattern")

    def test_so_does_another_version_of_the_tool(self, tmp_path, monkeypatch):
        path = str(write_wav(tmp_path / "laser.wav", GOOD))
        asked(tmp_path / "kept", [task(path)])
        monkeypatch.setattr(cache_module, "_tool", lambda: "other")
        assert asked(tmp_path / "kept", [task(path)])[1] == 1

    def test_what_is_no_fact_of_the_bytes_is_not_kept(self, tmp_path, monkeypatch):
        (tmp_path / "gone.wav").symlink_to("nowhere.wav")
        crashing = str(write_wav(tmp_path / "laser.wav", GOOD))
        tasks = [task(str(tmp_path / "gone.wav")), task(crashing)]
        from audio_checks.checks import all_checks

        def crash(*_):
            raise ZeroDivisionError

        with monkeypatch.context() as broken:
            broken.setattr(all_checks()["clipping"].module, "check", crash)
            first, _ = asked(tmp_path / "kept", tasks)
        assert [entry.verdict for entry in first] == ["unreadable", "unjudged"]
        again, judged = asked(tmp_path / "kept", tasks)
        assert (judged, again[1].verdict) == (2, "conforming")


class TestReading:
    @pytest.mark.usefixtures("settled")
    def test_an_unchanged_file_is_not_opened(self, tmp_path, monkeypatch):
        path = str(write_wav(tmp_path / "laser.wav", GOOD))
        asked(tmp_path / "kept", [task(path)])
        monkeypatch.setattr(cache_module, "_sha256", lambda _: pytest.fail("it was read"))
        assert asked(tmp_path / "kept", [task(path)])[1] == 0

    def test_one_that_was_just_written_is(self, tmp_path, monkeypatch):
        monkeypatch.setattr(cache_module, "SETTLED_NS", 60_000_000_000)
        path = str(write_wav(tmp_path / "laser.wav", GOOD))
        asked(tmp_path / "kept", [task(path)])
        rows = sqlite3.connect(tmp_path / "kept" / "verdicts.sqlite").execute("SELECT count(*) FROM seen").fetchone()
        assert rows == (0,)  # it may be written again within the same tick of the clock

    def test_a_file_of_unknown_size_is_not_read_twice(self, tmp_path, monkeypatch):
        asked(tmp_path / "kept", [task(str(write_wav(tmp_path / "laser.wav", GOOD)))])
        other = str(write_wav(tmp_path / "other.wav", sine(hz=997, seconds=0.2)))
        monkeypatch.setattr(cache_module, "_sha256", lambda _: pytest.fail("it was read"))
        assert asked(tmp_path / "kept", [task(other)])[1] == 1

    def test_what_is_used_is_kept_and_noted_in_one_step(self, tmp_path):
        tasks = [task(str(write_wav(tmp_path / f"{name}.wav", GOOD))) for name in "abc"]
        asked(tmp_path / "kept", tasks)
        database = sqlite3.connect(tmp_path / "kept" / "verdicts.sqlite")
        database.execute("UPDATE verdicts SET used_on = used_on - 20")
        database.commit()
        (before,) = database.execute("PRAGMA data_version").fetchone()
        assert asked(tmp_path / "kept", tasks)[1] == 0
        assert database.execute(
            "SELECT count(*) FROM verdicts WHERE used_on > ?", (time.time() // 86_400 - 1,)
        ).fetchone() == (3,)
        assert database.execute("PRAGMA data_version").fetchone()[0] <= before + 2

    def test_old_verdicts_are_dropped(self, tmp_path):
        asked(tmp_path / "kept", [task(str(write_wav(tmp_path / "a.wav", GOOD)))])
        database = sqlite3.connect(tmp_path / "kept" / "verdicts.sqlite")
        database.execute("UPDATE verdicts SET used_on = used_on - 31")
        database.commit()
        asked(tmp_path / "kept", [task(str(write_wav(tmp_path / "b.wav", LOUD)))])
        (names,) = database.execute("SELECT count(*) FROM verdicts").fetchone()
        assert names == 1


class TestDamage:
    @pytest.mark.parametrize(
        "content",
        [b"", b"not a database, but long enough to be taken for one" * 100, b"SQLite format 3\0" + bytes(4080)],
        ids=["empty", "text", "torn"],
    )
    def test_it_does_no_harm(self, tmp_path, content):
        path = str(write_wav(tmp_path / "laser.wav", LOUD))
        (tmp_path / "kept").mkdir()
        (tmp_path / "kept" / "verdicts.sqlite").write_bytes(content)
        assert asked(tmp_path / "kept", [task(path)])[0][0].verdict == "rejected"
        asked(tmp_path / "kept", [task(path)])
        assert asked(tmp_path / "kept", [task(path)])[1] == 0  # and is fixed by itself

    @pytest.mark.parametrize("entry", ["", "[]", "{", '{"verdict": "conforming"}', "null", "\udcff"])
    def test_nor_does_a_damaged_verdict(self, tmp_path, entry):
        path = str(write_wav(tmp_path / "laser.wav", LOUD))
        asked(tmp_path / "kept", [task(path)])
        database = sqlite3.connect(tmp_path / "kept" / "verdicts.sqlite")
        database.execute("UPDATE verdicts SET entry = ?", (entry.encode("utf-8", "surrogateescape"),))
        database.commit()
        database.close()
        assert asked(tmp_path / "kept", [task(path)])[0][0].verdict == "rejected"

    def test_nor_one_of_another_make(self, tmp_path):
        path = str(write_wav(tmp_path / "laser.wav", LOUD))
        asked(tmp_path / "kept", [task(path)])
        database = sqlite3.connect(tmp_path / "kept" / "verdicts.sqlite")
        database.execute("PRAGMA user_version = 99")
        database.close()
        assert asked(tmp_path / "kept", [task(path)])[1] == 1

    def test_nor_one_that_another_run_holds(self, tmp_path, monkeypatch):
        path = str(write_wav(tmp_path / "laser.wav", LOUD))
        asked(tmp_path / "kept", [task(path)])
        monkeypatch.setattr(cache_module, "WAIT_S", 0.05)
        other = sqlite3.connect(tmp_path / "kept" / "verdicts.sqlite", isolation_level=None)
        other.execute("BEGIN EXCLUSIVE")
        assert asked(tmp_path / "kept", [task(path)])[0][0].verdict == "rejected"
        other.execute("ROLLBACK")
        assert asked(tmp_path / "kept", [task(path)])[1] == 0  # what the other kept is still there

    def test_nor_one_that_another_run_writes_to_meanwhile(self, tmp_path, monkeypatch):
        first, second = (str(write_wav(tmp_path / f"{name}.wav", LOUD)) for name in "ab")
        asked(tmp_path / "kept", [task(first)])
        monkeypatch.setattr(cache_module, "WAIT_S", 0.05)
        cache = VerdictCache(tmp_path / "kept")
        other = sqlite3.connect(tmp_path / "kept" / "verdicts.sqlite", isolation_level=None)
        other.execute("BEGIN IMMEDIATE")
        assert cache.recall([task(second)]) == [None]
        cache.remember([task(second)], runner.judge([task(second)]))
        other.execute("ROLLBACK")
        assert not cache.usable
        assert asked(tmp_path / "kept", [task(first)])[1] == 0

    def test_nor_one_without_its_tables(self, tmp_path):
        path = str(write_wav(tmp_path / "laser.wav", LOUD))
        (tmp_path / "kept").mkdir()
        database = sqlite3.connect(tmp_path / "kept" / "verdicts.sqlite")
        database.execute(f"PRAGMA user_version = {cache_module.FORMAT}")
        database.close()
        for _ in range(2):
            asked(tmp_path / "kept", [task(path)])
        assert asked(tmp_path / "kept", [task(path)])[1] == 0

    def test_nor_a_folder_that_cannot_be_made(self, folder, run):
        write_wav(folder / "laser.wav", GOOD)
        (folder / "file").touch()
        code, out, err = run("check", "--cache-dir", "file/inside", "laser.wav")
        assert (code, "1 conforming" in out) == (0, True)
        assert "file/inside: verdicts cannot be kept there" in err


class TestCommand:
    def test_a_second_run_judges_nothing(self, folder, run, judged):
        for name in ("a.wav", "b.wav"):
            write_wav(folder / name, LOUD)
        first = run("check", "--spec", "../spec.toml", "--format", "json", ".")
        assert run("check", "--spec", "../spec.toml", "--format", "json", ".") == first
        assert sorted(judged) == ["./a.wav", "./b.wav"]

    def test_unless_it_is_asked_to(self, folder, run, judged):
        write_wav(folder / "a.wav", GOOD)
        for _ in range(2):
            run("check", "--no-cache", ".")
        assert judged == ["./a.wav", "./a.wav"]
        assert not list(default_folder().glob("*"))

    def test_waivers_are_not_remembered(self, folder, run):
        path = write_wav(folder / "a.wav", LOUD)
        assert run("check", "--spec", "../spec.toml", "--add-baseline", ".")[0] == 0
        assert run("check", "--spec", "../spec.toml", ".")[0] == 1
        assert path.exists()

    def test_where_verdicts_are_kept(self, folder, run, monkeypatch):
        write_wav(folder / "a.wav", GOOD)
        run("check", "--cache-dir", "here", ".")
        assert (folder / "here" / "verdicts.sqlite").exists()
        monkeypatch.delenv("AUDIO_CHECKS_CACHE_DIR")
        monkeypatch.setenv("XDG_CACHE_HOME", str(folder / "xdg"))
        monkeypatch.setattr("sys.platform", "linux")
        assert default_folder() == folder / "xdg" / "audio-checks"
        monkeypatch.setattr("sys.platform", "win32")
        monkeypatch.setenv("LOCALAPPDATA", str(folder / "local"))
        assert default_folder() == folder / "local" / "audio-checks" / "Cache"
        monkeypatch.setattr("sys.platform", "darwin")
        assert default_folder().parts[-3:] == ("Library", "Caches", "audio-checks")


@pytest.mark.slow
@pytest.mark.usefixtures("settled")
def test_a_thousand_unchanged_files_are_reported_again_without_a_look_inside(folder, run, monkeypatch):
    """Benchmarks say how many a second: `python -m benchmarks.unchanged`."""
    for number in range(10):
        write_wav(folder / f"sound_{number}.wav", sine(hz=100 + number, seconds=0.01))
    for number in range(10, 1000):
        os.link(folder / f"sound_{number % 10}.wav", folder / f"sound_{number}.wav")
    first = run("check", "--format", "json", "-j", "1", ".")
    monkeypatch.setattr(cache_module, "_sha256", lambda _: pytest.fail("it was read"))
    assert run("check", "--format", "json", "-j", "1", ".") == first
    assert json.loads(first[1])["summary"]["files"] == 1000
