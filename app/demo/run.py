"""The demo as one process tree: web application and worker on the embedded database, stopped together."""

import os
import secrets
import signal
from pathlib import Path

import httpx
import typer

from app.core import clock
from app.core.db import Database
from app.core.permissions import tighten
from app.core.runtime import Runtime
from app.core.web.serving import PortTaken, ensure_port_free
from app.demo.data_lock import DataLock, InUse
from app.demo.process_tree import ProcessTree
from app.demo.progress import Progress
from app.demo.project import DemoIncomplete, make_demo_project
from app.demo.whole_files import write_whole
from app.migrate import CannotUpgrade, MadeBeforeRelease, current_revision, ensure_upgradable, migrate
from app.settings import Settings

HOST = "127.0.0.1"


def run_demo(port: int) -> int:
    """Serve the demo until stopped; return the exit code."""
    settings = Settings()
    try:
        settings.data_dir.mkdir(parents=True, exist_ok=True)
        for line in tighten(settings.private_paths):
            typer.echo(line, err=True)
        with Progress(typer.echo) as progress:
            with DataLock(settings.data_dir, progress.begin):
                ensure_port_free(HOST, port)
                _move_old_data_aside(settings)
            with DataLock(settings.data_dir, progress.begin) as lock:
                return _run(settings.data_dir, port, lock, progress)
    except InUse as error:
        typer.echo(str(error), err=True)
    except PortTaken as error:
        typer.echo(f"{error}: make run PORT={port + 1}", err=True)
    except CannotUpgrade as error:
        typer.echo(f"{error}; or choose another folder: make run DATA=another-folder", err=True)
    except OSError as error:
        if error.filename is None:
            raise
        typer.echo(
            f"{error.filename} cannot be used ({error.strerror}); choose another folder: make run DATA=another-folder",
            err=True,
        )
    return 2


def _move_old_data_aside(settings: Settings) -> None:
    """Rename a data folder that a version before 1.0 made, and make an empty one; the caller holds its lock."""
    data_dir = settings.data_dir.resolve()
    if settings.database_url or not (data_dir / "soundlist.sqlite").exists():
        return
    database = Database(settings.resolved_database_url)
    try:
        ensure_upgradable(current_revision(database))
    except MadeBeforeRelease as error:
        reason = str(error).partition(",")[0]
    else:
        return
    finally:
        database.dispose()
    aside = data_dir.with_name(f"{data_dir.name}-before-1.0-{clock.now():%Y%m%dT%H%M%SZ}")
    data_dir.rename(aside)
    data_dir.mkdir(mode=0o700)
    typer.echo(
        f"  {reason}, and this version cannot read it. Everything in {settings.data_dir} was moved to {aside}, "
        f"and a new demo begins in {settings.data_dir}."
    )


def _run(data_dir: Path, port: int, lock: DataLock, progress: Progress) -> int:
    address = f"http://{HOST}:{port}"
    environment = os.environ | {
        "SOUNDLIST_DATA_DIR": str(data_dir.resolve()),
        "SOUNDLIST_SECRET_KEY": _secret_key(data_dir),
        "SOUNDLIST_BASE_URL": address,
        "SOUNDLIST_DEMO": "1",
        "SOUNDLIST_LOG_LEVEL": os.environ.get("SOUNDLIST_LOG_LEVEL", "WARNING"),
    }
    os.environ.update(environment)
    runtime = Runtime.of(Settings())
    commands = {"worker": ["worker"], "server": ["serve", "--host", HOST, "--port", str(port)]}
    tree = ProcessTree(commands, environment)
    try:
        progress.begin(f"Preparing the database in {data_dir}")
        migrate(runtime.database)
        signal.signal(signal.SIGTERM, tree.stop_on_signal)
        signal.signal(signal.SIGINT, tree.stop_on_signal)
        progress.begin("Starting the server and the worker")
        tree.start([lock.inherited])
        lock.record_processes(tree.process_ids)
        if not tree.wait_until(lambda: _answers(address)):
            if tree.is_stopping():
                return 0
            typer.echo(f"Soundlist did not start: {tree.ended()}; the reason is above", err=True)
            return 1
        _make_project(runtime, address, tree, progress)
        code = tree.watch()
        if not tree.is_stopping():
            typer.echo(f"Soundlist stopped: {tree.ended()}; the reason is above. Start it again", err=True)
        return code
    finally:
        progress.begin("Stopping")
        tree.stop()
        runtime.close()


def _make_project(runtime: Runtime, address: str, tree: ProcessTree, progress: Progress) -> None:
    """Make the demo project and report where Soundlist is, also where the project could not be completed."""
    try:
        made = make_demo_project(runtime, progress=progress, keep_going=tree.is_whole)
    except DemoIncomplete as error:
        progress.end()
        typer.echo(
            f"\n  Soundlist is at {address}, but its demo project is not complete: {error}\n"
            "  Use what is there; or start in an empty folder: make run DATA=another-folder\n",
            err=True,
        )
        return
    progress.end()
    if made and tree.is_whole():
        _welcome(address, *made)


def _secret_key(data_dir: Path) -> str:
    path = data_dir / "secret_key"
    if not path.exists() or not path.stat().st_size:
        write_whole(path, secrets.token_hex(32))
    return path.read_text()


def _answers(address: str) -> bool:
    try:
        return httpx.get(f"{address}/healthz", timeout=2).status_code == httpx.codes.OK
    except httpx.TransportError:
        return False


def _welcome(address: str, project: str, token: str) -> None:
    typer.echo(
        f"\n  Soundlist is at {address}\n"
        "  It needs no sign-in: the menu at the top right switches between producer, approver and designer.\n\n"
        "  The game's CI would say:\n"
        f"    SOUNDLIST_TOKEN={token} .venv/bin/soundlist ci --server {address} --project {project}"
        " --target game assets/\n\n"
        "  Ctrl C stops it; what you did is kept.\n"
    )
