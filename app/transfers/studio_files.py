"""One studio as a ZIP: its rows, table by table, and its stored files by their hash.

Left out are what works on one server only (webhooks and sign-in providers, whose secrets come from its key; mails;
limits; codes) and the passwords and sign-ins of people, who set a password by mail on the other server.
"""

import json
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any
from uuid import UUID

import sqlalchemy as sa
from sqlalchemy.orm import Session

from app.accounts.models import Person, Studio
from app.core import clock
from app.core.plural import counted
from app.core.runtime import Runtime
from app.core.storage import READ_BYTES, BlobAltered, BlobMissing
from app.core.web.health import NotReady
from app.migrate import ensure_at_head, revision_by
from app.operations.erasure import scope_queries as scopes
from app.operations.scrubbing import queries as blob_queries
from app.transfers import rows
from app.transfers.move import unfinished_jobs
from app.transfers.refusal import TransferRefused

FORMAT = 1
MANIFEST, PEOPLE, TABLES, BLOBS = "soundlist.json", "people.jsonl", "tables/", "blobs/"
LEFT_OUT = frozenset(
    {
        *("core_changed_rooms", "accounts_quotas", "notifications_mails", "contracts_signing_codes"),
        *("accounts_sign_in_providers", "accounts_sign_in_domains"),
        "operations_erasures",  # the studio that is imported is to stay
        *("webhooks_webhooks", "webhooks_calls", "webhooks_attempts"),
    }
)
PARTIAL = ".partial"
LINE_BYTES = 256 << 20
APART = "imported.invalid"  # the domain of addresses that belong to another account of the server


@dataclass
class Transferred:
    """The counts of an export or import."""

    studio_id: UUID
    name: str
    rows: int = 0
    people: int = 0
    blobs: int = 0
    size_bytes: int = 0


def export_studio(runtime: Runtime, studio_id: UUID, file: Path) -> Transferred:
    """Write a studio into a ZIP; raise TransferRefused where jobs wait or a stored file is damaged."""
    _ensure_this_version(runtime)
    if file.exists():
        raise TransferRefused(f"{file} exists; name another file")
    if waiting := unfinished_jobs(runtime, lambda job_studio_id: job_studio_id == studio_id):
        raise TransferRefused(
            f"{counted(len(waiting), 'job')} of this studio still to be done, such as {waiting[0]}; wait for a worker"
        )
    unfinished = file.with_name(file.name + PARTIAL)
    try:
        with (
            runtime.database.reading() as session,
            zipfile.ZipFile(unfinished, "w", zipfile.ZIP_DEFLATED, allowZip64=True) as archive,
        ):
            exported = _write_archive(session, runtime, studio_id, archive)
        unfinished.replace(file)
    finally:
        unfinished.unlink(missing_ok=True)
    return exported


def import_studio(runtime: Runtime, file: Path, *, keep_apart: bool = False) -> Transferred:
    """Add a studio out of a ZIP, all of it or nothing.

    Raises TransferRefused where the studio is here, the file is of another version or altered, or an address belongs to
    another account; with `keep_apart` such people are added beside that account, and cannot sign in.
    """
    _ensure_this_version(runtime)
    try:
        archive = zipfile.ZipFile(file)
    except (OSError, zipfile.BadZipFile) as error:
        raise TransferRefused(f"{file} cannot be read ({error}); name a file that `soundlist export` wrote") from None
    stored: list[str] = []
    with archive:
        manifest = _manifest(runtime, archive)
        imported = Transferred(UUID(manifest["studio"]["id"]), manifest["studio"]["name"])
        with runtime.database.reading() as session:
            if session.get(Studio, imported.studio_id) is not None:
                raise TransferRefused(f"the studio {imported.name} ({imported.studio_id}) is on this server already")
        try:
            _store_blobs(runtime, archive, imported, stored)
            with runtime.database.writing() as session:
                _write_people(session, archive, imported, keep_apart=keep_apart)
                _write_tables(session, archive, manifest, imported)
                named = set(blob_queries.named_blobs(session, imported.studio_id))
                if missing := sorted(named - _blob_names(archive)):
                    raise TransferRefused(f"{file} lacks {counted(len(missing), 'stored file')}, such as {missing[0]}")
        except BaseException:
            for sha256 in stored:
                runtime.store.delete(imported.studio_id, sha256)
            raise
    return imported


def _ensure_this_version(runtime: Runtime) -> None:
    try:
        ensure_at_head(runtime)
    except NotReady as error:
        raise TransferRefused(str(error)) from None


def _revision(session: Session) -> str | None:
    return revision_by(session.connection())


def _rows_of(table: sa.Table, studio_id: UUID) -> sa.ColumnElement[bool] | None:
    if table.name in LEFT_OUT:
        return None
    where = scopes.of_studio(table, studio_id)
    if where is not None and table.name == "core_uploads":
        return sa.and_(where, table.c.sha256.is_not(None))
    return where


def _write_archive(session: Session, runtime: Runtime, studio_id: UUID, archive: zipfile.ZipFile) -> Transferred:
    studio = session.get(Studio, studio_id)
    if studio is None:
        raise TransferRefused(f"no studio {studio_id}; the page Jobs and storage lists the ids of all")
    exported = Transferred(studio_id, studio.name)
    people: set[UUID] = set()
    digests: dict[str, Any] = {}
    for table in scopes.tables():
        where = _rows_of(table, studio_id)
        if where is None:
            continue
        of_people = [column.name for column in table.columns if _is_person(column)]
        digest = rows.Digest()
        with archive.open(f"{TABLES}{table.name}.jsonl", "w", force_zip64=True) as lines:
            for row in rows.read(session, table, where):
                lines.write(rows.to_json(row).encode() + b"\n")
                digest.add(table, row)
                people |= {row[name] for name in of_people if row[name] is not None}
        digests[table.name] = {"rows": digest.rows, "digest": digest.hex}
        exported.rows += digest.rows
    _write_people_file(session, archive, people, exported)
    for sha256 in sorted(blob_queries.named_blobs(session, studio_id)):
        entry = zipfile.ZipInfo(f"{BLOBS}{sha256}")  # stored: sounds hardly get smaller
        try:
            with archive.open(entry, "w", force_zip64=True) as content:
                for piece in runtime.store.stream(studio_id, sha256):
                    content.write(piece)
                    exported.size_bytes += len(piece)
        except (BlobMissing, BlobAltered) as error:
            raise TransferRefused(f"{error}; {error.fix}") from None
        exported.blobs += 1
    manifest = {
        "format": FORMAT,
        "revision": _revision(session),
        "exported_at": clock.now().isoformat(),
        "studio": {"id": str(studio_id), "name": studio.name},
        "tables": digests,
        "left_out": sorted(LEFT_OUT),
    }
    archive.writestr(MANIFEST, json.dumps(manifest, indent=1))
    return exported


def _is_person(column: sa.Column[Any]) -> bool:
    return any(key.column.table is Person.__table__ for key in column.foreign_keys)


def _write_people_file(session: Session, archive: zipfile.ZipFile, ids: set[UUID], exported: Transferred) -> None:
    with archive.open(PEOPLE, "w") as lines:
        for person_id in sorted(ids):
            person = session.get_one(Person, person_id)
            facts = {"id": str(person_id), "email": person.email, "name": person.name}
            lines.write(json.dumps(facts | {"created_at": person.created_at.isoformat()}).encode() + b"\n")
            exported.people += 1


def _manifest(runtime: Runtime, archive: zipfile.ZipFile) -> dict[str, Any]:
    try:
        manifest: dict[str, Any] = json.loads(archive.read(MANIFEST))
        UUID(manifest["studio"]["id"])
        revision, kind = manifest["revision"], manifest["format"]
    except (KeyError, ValueError, TypeError, zipfile.BadZipFile):
        raise TransferRefused(
            f"{archive.filename} holds no studio; name a file that `soundlist export` wrote"
        ) from None
    with runtime.database.reading() as session:
        here = _revision(session)
    if kind != FORMAT or revision != here:
        raise TransferRefused(
            f"{archive.filename} is of the tables {revision}, and this server has {here}; bring both servers "
            "to the same version and export again"
        )
    return manifest


def _blob_names(archive: zipfile.ZipFile) -> set[str]:
    return {name.removeprefix(BLOBS) for name in archive.namelist() if name.startswith(BLOBS)}


def _store_blobs(runtime: Runtime, archive: zipfile.ZipFile, imported: Transferred, stored: list[str]) -> None:
    for sha256 in sorted(_blob_names(archive)):
        try:
            with archive.open(f"{BLOBS}{sha256}") as content:
                blob = runtime.store.put(imported.studio_id, iter(partial(content.read, READ_BYTES), b""))
        except zipfile.BadZipFile:
            raise TransferRefused(
                f"the file {sha256} in {archive.filename} is damaged; export the studio again"
            ) from None
        stored.append(blob.sha256)
        if blob.sha256 != sha256:
            raise TransferRefused(f"the file {sha256} in {archive.filename} has other bytes; export the studio again")
        imported.blobs += 1
        imported.size_bytes += blob.size_bytes


def _write_people(session: Session, archive: zipfile.ZipFile, imported: Transferred, *, keep_apart: bool) -> None:
    taken = []
    for line in archive.read(PEOPLE).splitlines():
        facts = json.loads(line)
        person_id, email = UUID(facts["id"]), str(facts["email"]).lower()
        imported.people += 1
        if session.get(Person, person_id) is not None:
            continue
        if session.scalar(sa.select(Person.id).where(Person.email == email)) is not None:
            taken.append(email)
            email = f"{person_id}@{APART}"
        session.add(Person(id=person_id, email=email, name=facts["name"]))
    if taken and not keep_apart:
        raise TransferRefused(
            f"{', '.join(taken)}: another account of this server has this address; with --keep-apart their work is "
            "imported beside that account, and you invite the account to the studio"
        )
    session.flush()


def _write_tables(session: Session, archive: zipfile.ZipFile, manifest: dict[str, Any], imported: Transferred) -> None:
    for table in scopes.tables():
        where = _rows_of(table, imported.studio_id)
        if where is None:
            continue
        imported.rows += rows.write(session, table, _lines(archive, table, imported.studio_id))
        digest = rows.digest(session, table, where)
        if {"rows": digest.rows, "digest": digest.hex} != manifest["tables"].get(table.name):
            raise TransferRefused(f"{table.name} is not what was exported; the file was altered")


def _lines(archive: zipfile.ZipFile, table: sa.Table, studio_id: UUID) -> Iterator[rows.Row]:
    try:
        lines = archive.open(f"{TABLES}{table.name}.jsonl")
    except KeyError:
        raise TransferRefused(f"{archive.filename} lacks the table {table.name}") from None
    with lines:
        while line := lines.readline(LINE_BYTES):
            row = rows.from_json(table, line)
            if row.get("studio_id", studio_id) != studio_id:
                raise TransferRefused(f"a row of {table.name} is another studio's; the file was altered")
            yield row
