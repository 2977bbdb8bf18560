"""A PostgreSQL server of our own: Debian's binaries, a folder that is thrown away, a socket and no port."""

import os
import pwd
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import psycopg
from psycopg import sql

OWNER = "soundlist"  # the login that the application uses: it owns its database and is not a superuser
SUPERUSER = "postgres"
START_WITHIN_S = 240.0
MADE_WITHIN_S = 300.0


class PostgresMissing(Exception):
    """PostgreSQL is not installed on this machine."""


class Postgres:
    """One running server; its databases belong to the application's login."""

    def __init__(self, folder: Path, *, durable: bool) -> None:
        self.folder = folder
        self._programs = _programs()
        self._durable = durable
        self._user = None if os.getuid() else SUPERUSER  # PostgreSQL refuses to run as root
        self._running: subprocess.Popen[bytes] | None = None
        if self._user:
            shutil.chown(folder, self._user)
        if self._data.exists():
            return
        self._run(
            "initdb", "--auth=trust", f"--username={SUPERUSER}", "--encoding=UTF8", "--locale=C.UTF-8",
            "--no-sync", "--no-instructions", "--pgdata", str(self._data),
        )  # fmt: skip

    @property
    def _data(self) -> Path:
        return self.folder / "data"

    @property
    def pid(self) -> int:
        """The id of the postmaster."""
        assert self._running is not None
        return self._running.pid

    def start(self) -> None:
        """Start the server, or start it again after a kill, and return once it answers."""
        safe = "on" if self._durable else "off"
        settings = {
            "listen_addresses": "",
            "unix_socket_directories": str(self.folder),
            "fsync": safe,
            "full_page_writes": safe,
            "synchronous_commit": safe,
            "autovacuum": safe,  # what it counts at some moment would have plans change from then on
            "max_connections": "200",
        }
        options = [argument for name, value in settings.items() for argument in ("-c", f"{name}={value}")]
        with (self.folder / "log").open("ab") as log:
            self._running = subprocess.Popen(
                [str(self._programs / "postgres"), "-D", str(self._data), *options],
                stdout=log, stderr=log, user=self._user, group=self._group, extra_groups=self._extra_groups, cwd="/",
            )  # fmt: skip
        deadline = time.monotonic() + START_WITHIN_S
        while not self._answers():
            if self._running.poll() is not None or time.monotonic() > deadline:
                raise RuntimeError(f"PostgreSQL did not start:\n{(self.folder / 'log').read_text()}")
            time.sleep(0.02)
        with self.superuser() as connection:
            if not connection.execute("select 1 from pg_roles where rolname = %s", [OWNER]).fetchone():
                connection.execute(sql.SQL("create role {} login createrole").format(sql.Identifier(OWNER)))

    def stop(self) -> None:
        """Stop without waiting for connections."""
        if self._running is not None:
            if self._running.poll() is None:
                self._running.send_signal(signal.SIGQUIT)
            self._running.wait(START_WITHIN_S)

    def kill(self) -> None:
        """SIGKILL the postmaster and every backend, as a power cut would."""
        running = self._running
        assert running is not None
        backends = Path(f"/proc/{running.pid}/task/{running.pid}/children").read_text().split()
        for pid in (running.pid, *map(int, backends)):
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                continue
        running.wait(START_WITHIN_S)

    def superuser(self, database: str = "postgres") -> psycopg.Connection:
        """Return a connection without limits, each statement a transaction of its own."""
        within_s = int(START_WITHIN_S)
        return psycopg.connect(
            host=str(self.folder), user=SUPERUSER, dbname=database, autocommit=True, connect_timeout=within_s
        )

    def url(self, database: str) -> str:
        """Return what SOUNDLIST_DATABASE_URL would say."""
        return f"postgresql://{OWNER}@/{database}?host={self.folder}"

    def has_database(self, name: str) -> bool:
        """Whether a database is there."""
        with self.superuser() as connection:
            return connection.execute("select 1 from pg_database where datname = %s", [name]).fetchone() is not None

    def new_database(self, name: str) -> str:
        """Create an empty database, and return its URL."""
        with self.superuser() as connection:
            created = sql.SQL("create database {} owner {}").format(sql.Identifier(name), sql.Identifier(OWNER))
            connection.execute(created)
        return self.url(name)

    def drop_database(self, name: str) -> None:
        """Drop a database with all its connections."""
        with self.superuser() as connection:
            connection.execute(sql.SQL("drop database if exists {} with (force)").format(sql.Identifier(name)))

    @property
    def _group(self) -> int | None:
        return pwd.getpwnam(self._user).pw_gid if self._user else None

    @property
    def _extra_groups(self) -> list[int] | None:
        return [] if self._user else None

    def _run(self, program: str, *arguments: str) -> None:
        ran = subprocess.run(
            [str(self._programs / program), *arguments],
            capture_output=True, text=True, timeout=MADE_WITHIN_S,
            user=self._user, group=self._group, extra_groups=self._extra_groups,
            cwd="/",
        )  # fmt: skip
        if ran.returncode:
            raise RuntimeError(f"{program} failed: {ran.stdout}{ran.stderr}")

    def _answers(self) -> bool:
        try:
            self.superuser().close()
        except psycopg.OperationalError:
            return False
        return True


def _programs() -> Path:
    """Return the folder of the newest PostgreSQL that Debian installed, or of the one on the PATH."""
    installed = sorted(Path("/usr/lib/postgresql").glob("*/bin/postgres"), key=lambda path: float(path.parts[4]))
    on_path = shutil.which("postgres")
    if installed:
        return installed[-1].parent
    if on_path:
        return Path(on_path).resolve().parent
    raise PostgresMissing("PostgreSQL is not installed: apt-get install postgresql")


@contextmanager
def running_postgres(*, durable: bool = False) -> Iterator[Postgres]:
    """Run a server for as long as the block lasts; what a durable one acknowledged survives a kill."""
    # A socket's path may have 107 bytes, and the server's user must reach it: pytest's own folders offer neither.
    folder = Path(tempfile.mkdtemp(prefix="soundlist-pg-"))
    try:
        server = Postgres(folder, durable=durable)
        server.start()
        try:
            yield server
        finally:
            server.stop()
    finally:
        shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    # For programs that are not Python: the URL of an empty database, which is there until standard input ends.
    with running_postgres() as started:
        sys.stdout.write(started.new_database("soundlist") + "\n")
        sys.stdout.flush()
        sys.stdin.read()
