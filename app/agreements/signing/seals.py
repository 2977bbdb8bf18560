"""Seal the text that all have signed, and find out of any file whether it is a sealed one, untouched."""

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING
from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements import queries
from app.agreements.clauses.text import literal
from app.agreements.drafts.documents import CertificatePart, signed_pdf_of
from app.agreements.drafts.versions import newest_of
from app.agreements.models import Contract, ContractAcceptance, ContractVersion, Seal
from app.agreements.record import service as record
from app.agreements.record.signed_checkpoints import public_key_of
from app.agreements.rules import KIND_WORDS
from app.agreements.signing import seal_files
from app.agreements.signing.certificates import in_both, signature_part, studio_zone
from app.agreements.signing.rules import CONSENT
from app.agreements.signing.seal_files import MARK
from app.core.db import new_id
from app.core.runtime import Runtime
from app.settings import Settings

if TYPE_CHECKING:
    from pyhanko.sign.signers import Signer


class Verdict(StrEnum):
    """The verdict on a file, compared with the seals of this server."""

    UNTOUCHED = "untouched"
    CHANGED = "changed"  # it says that it was sealed here, and is none of the files that were
    NOT_OURS = "not_ours"


@dataclass(frozen=True)
class Verified:
    """A file's verdict and, where it is untouched, its text and those bound to it."""

    verdict: Verdict
    file_sha256: str
    seal: Seal | None
    acceptances: Sequence[ContractAcceptance]


def seal_contract(runtime: Runtime, contract_id: UUID) -> None:
    """Make, seal and keep the PDF of a signed contract, once; the file is made outside of any transaction."""
    seal_id = new_id()
    with runtime.database.reading() as session:
        contract = queries.contract_by_id(session, contract_id)
        version = newest_of(session, contract)
        if contract.agreed_at is None or queries.seal_of(session, version.id) is not None:
            return
        acceptances = queries.acceptances_of(session, version.id)
        certificate = certificate_of(contract, version, acceptances, head_key=public_key_of(runtime.settings))
        title, text, agreed_on = contract.title, version.text, contract.agreed_at.date()
    mark = f"{MARK}{seal_id}"
    pdf = signed_pdf_of(title, text, certificate, agreed_on=agreed_on, mark=mark)
    timestamp_url = runtime.settings.timestamp_url
    sealed = seal_files.seal(pdf, signer_of(runtime.settings), mark=mark, timestamp_url=timestamp_url)
    stored = runtime.store.put(contract.studio_id, [sealed.content])
    with runtime.database.writing() as session:
        queries.lock_contract(session, contract_id)
        if queries.seal_of(session, version.id) is not None:
            return
        session.add(
            Seal(
                id=seal_id,
                studio_id=contract.studio_id,
                project_id=contract.project_id,
                contract_id=contract_id,
                version_id=version.id,
                file_sha256=stored.sha256,
                file_bytes=stored.size_bytes,
                key_sha256=sealed.key_sha256,
                is_timestamped=bool(timestamp_url),
            )
        )
        record.append(session, contract_id, "sealed", {"file_sha256": stored.sha256}, by=None)


def signer_of(settings: Settings) -> "Signer":
    """Return the signer of this server: the operator's certificate, or one of our own."""
    if settings.seal_certificate is not None and settings.seal_key is not None:
        return seal_files.given_signer(settings.seal_certificate, settings.seal_key)
    return seal_files.own_signer(settings.secret_key.get_secret_value())


def certificate_of(
    contract: Contract, version: ContractVersion, acceptances: Sequence[ContractAcceptance], *, head_key: str
) -> list[CertificatePart]:
    """Return the page that says who signed a text, how that is shown, and when."""
    zone = studio_zone(contract)
    head = [
        "# Certificate of signing",
        f"{KIND_WORDS[contract.kind].capitalize()} **{literal(contract.title)}** between "
        f"{literal(contract.project.studio.name)} and {literal(contract.designer.name)}, version {version.number}.",
        f"SHA-256 of the text: {version.text_sha256}",
        f"Sent {in_both(version.sent_at, zone)}. Agreed {in_both(contract.agreed_at, zone)}.",
        f"Each of those who signed agreed to this sentence: {literal(CONSENT)}",
    ]
    foot = [
        "## How to verify",
        "This file is sealed: a changed byte shows in any reader of signed PDFs, and on the page Verify of the server "
        "that made it. Heads of this contract's record are signed with the Ed25519 key "
        f"{head_key}",
    ]
    return [
        CertificatePart("\n\n".join(head)),
        *(signature_part(acceptance, zone) for acceptance in acceptances),
        CertificatePart("\n\n".join(foot)),
    ]


def is_known(session: Session, file: bytes) -> bool:
    """Whether a file is a sealed one of this server, or names one: then its seal need not be read."""
    ids = [UUID(mark) for mark in seal_files.marks_of(file)]
    return queries.has_seal(session, ids) or queries.seal_by_file(session, _sha256_of(file)) is not None


def verify(session: Session, file: bytes, key_sha256: str) -> Verified:
    """Compare a file, and the key that it was sealed by, with the seals of this server."""
    sha256 = _sha256_of(file)
    seal = queries.seal_by_file(session, sha256)
    if seal is not None:
        return Verified(Verdict.UNTOUCHED, sha256, seal, queries.acceptances_of(session, seal.version_id))
    is_ours = is_known(session, file) or (bool(key_sha256) and queries.has_sealed_by(session, key_sha256))
    return Verified(Verdict.CHANGED if is_ours else Verdict.NOT_OURS, sha256, None, ())


def _sha256_of(file: bytes) -> str:
    return hashlib.sha256(file).hexdigest()
