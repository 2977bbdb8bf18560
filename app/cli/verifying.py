"""The reports of `soundlist verify`: on every record, on copies and heads that a party kept, on PDFs."""

from collections.abc import Sequence
from pathlib import Path

import typer
from sqlalchemy.orm import Session

from app.agreements.errors import BadHead
from app.agreements.record import service as record
from app.agreements.record import signed_checkpoints as heads
from app.agreements.signing import seals
from app.agreements.signing.seal_files import PDF_BEGINS, SealRead, marks_of, read_seal
from app.amendments import verification
from app.core.runtime import Runtime


def report_all(runtime: Runtime, copies: Sequence[Path], kept_heads: Sequence[Path]) -> int:
    """Report every record of the server and what was given to compare; return how many are not whole."""
    records = entries = wrong = 0
    for verified in verification.verify_all(runtime.database, runtime.store):
        records, entries, wrong = records + 1, entries + verified.entries, wrong + bool(verified.faults)
        for fault in verified.faults:
            typer.echo(f"{verified.contract_id} {verified.title}: {fault}", err=True)
    with runtime.database.reading() as session:
        for path in copies:
            wrong += _report(path, _faults_of_copy(session, path))
        for path in kept_heads:
            wrong += _report(path, _faults_of_head(session, runtime, path))
    looked_at = len(copies) + len(kept_heads)
    typer.echo(f"{records} records with {entries} entries and {looked_at} copies looked at; {wrong} are not whole")
    return wrong


def report_seal(path: Path) -> bool:
    """Report a PDF's own account by its seal alone; return whether it is not untouched as far as that shows."""
    try:
        read = read_seal(path.read_bytes())
    except OSError as error:
        return _report(path, [str(error)])
    if read.is_sealed and read.is_intact and read.covers_file:
        typer.echo(
            f"{path}: untouched under its seal of {read.sealed_at}, by the key {read.key_sha256}. Whether that key is "
            "the server's, and whether the bytes of the seal itself are those stored, only the server can say"
        )
        return False
    return _report(path, [_broken(read, marks_of(path.read_bytes()))])


def _report(path: Path, faults: Sequence[str]) -> bool:
    for fault in faults:
        typer.echo(f"{path}: {fault}", err=True)
    return bool(faults)


def _broken(read: SealRead, marks: Sequence[str]) -> str:
    if read.is_sealed:
        return f"it was changed after it was sealed on {read.sealed_at}"
    return "it was sealed once, and its seal cannot be read any more" if marks else "it has no seal"


def _faults_of_copy(session: Session, path: Path) -> list[str]:
    try:
        content = path.read_bytes()
        if content.startswith(PDF_BEGINS):
            return _faults_of_pdf(session, path, content)
        contract_id, kept = record.read_document(content.decode())
        return list(record.faults_beside(session, contract_id, kept))
    except (OSError, UnicodeDecodeError, record.NoRecord) as error:
        return [str(error)]


def _faults_of_pdf(session: Session, path: Path, content: bytes) -> list[str]:
    read = read_seal(content)
    verified = seals.verify(session, content, read.key_sha256)
    match verified.verdict:
        case seals.Verdict.CHANGED:
            return [f"it is not the file that was sealed here; {_broken(read, marks_of(content))}"]
        case seals.Verdict.NOT_OURS:
            return ["it was not sealed by this server"]
    if verified.seal is not None:
        contract, version = verified.seal.contract, verified.seal.version
        names = ", ".join(f"{acceptance.name} for the {acceptance.party}" for acceptance in verified.acceptances)
        typer.echo(
            f"{path}: untouched. {contract.title}, version {version.number} between {contract.project.studio.name} and "
            f"{contract.designer.name}, SHA-256 of the text {version.text_sha256}, signed by {names}"
        )
    return []


def _faults_of_head(session: Session, runtime: Runtime, path: Path) -> list[str]:
    try:
        return list(heads.faults_of_head(session, runtime.settings, heads.read_head(path.read_text(encoding="utf-8"))))
    except (OSError, UnicodeDecodeError, BadHead) as error:
        return [str(error)]
