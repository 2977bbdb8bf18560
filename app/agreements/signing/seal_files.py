"""The seal of a PDF: a signature of this server over the whole file (PAdES), put on and read.

pyHanko takes a second to load, so only what seals or reads a seal loads it.
"""

import io
import re
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from app.core.server_keys import certificate_key

if TYPE_CHECKING:
    from cryptography.hazmat.primitives.asymmetric.ec import EllipticCurvePrivateKey
    from pyhanko.sign.signers import Signer

PURPOSE = "seal of contracts, P-256, version 1"
FIELD = "Seal"
MARK = "soundlist-seal:"
_MARKED = re.compile(rb"soundlist-seal:([0-9a-f]{8}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{12})")
PDF_BEGINS = b"%PDF-"


@dataclass(frozen=True)
class SealedFile:
    """A PDF that was sealed, and the SHA-256 of the public key that a reader finds in it."""

    content: bytes
    key_sha256: str


@dataclass(frozen=True)
class SealRead:
    """A file's own account of its seal."""

    is_sealed: bool  # there is a seal that can be read
    is_intact: bool  # nothing under the seal was changed
    covers_file: bool  # all of the file is under the seal, but for the bytes of the seal itself
    key_sha256: str  # of the public key that sealed it; empty without a seal
    sealed_at: str  # as the seal says it, ISO 8601; empty without


def seal(pdf: bytes, signer: "Signer", *, mark: str, timestamp_url: str) -> SealedFile:
    """Return a PDF with a seal over the whole of it (PAdES B-B, with a timestamp server B-T)."""
    from pyhanko.pdf_utils.incremental_writer import IncrementalPdfFileWriter
    from pyhanko.sign import fields, signers
    from pyhanko.sign.timestamps import HTTPTimeStamper

    metadata = signers.PdfSignatureMetadata(
        field_name=FIELD,
        md_algorithm="sha256",
        subfilter=fields.SigSeedSubFilter.PADES,
        reason=mark,
        certify=True,
        docmdp_permissions=fields.MDPPerm.NO_CHANGES,
    )
    timestamper = HTTPTimeStamper(timestamp_url) if timestamp_url else None
    writer = IncrementalPdfFileWriter(io.BytesIO(pdf))
    sealed = signers.sign_pdf(writer, metadata, signer=signer, timestamper=timestamper)
    if signer.signing_cert is None:
        raise ValueError("a signer without a certificate")
    return SealedFile(sealed.getvalue(), signer.signing_cert.public_key.sha256.hex())


def own_signer(secret: str) -> "Signer":
    """Return the signer by the key that follows from the server's secret, with a self-signed certificate."""
    from asn1crypto import keys, x509
    from cryptography.hazmat.primitives.serialization import Encoding, NoEncryption, PrivateFormat
    from pyhanko.sign.signers import SimpleSigner
    from pyhanko_certvalidator.registry import SimpleCertificateStore

    key = certificate_key(secret, PURPOSE)
    private = key.private_bytes(Encoding.DER, PrivateFormat.PKCS8, NoEncryption())
    return SimpleSigner(
        signing_cert=x509.Certificate.load(_own_certificate(key)),
        signing_key=keys.PrivateKeyInfo.load(private),
        cert_registry=SimpleCertificateStore(),  # type: ignore[no-untyped-call]
    )


def given_signer(certificate: Path, key: Path) -> "Signer":
    """Return the signer by a certificate and a key of the operator; raise ValueError where they cannot be read."""
    from pyhanko.keys import load_certs_from_pemder
    from pyhanko.sign.signers import SimpleSigner

    try:
        _, *chain = load_certs_from_pemder([str(certificate)])  # type: ignore[no-untyped-call]
        signer: SimpleSigner | None = SimpleSigner.load(  # type: ignore[no-untyped-call]
            str(key), str(certificate), other_certs=chain
        )
    except (OSError, ValueError) as error:
        raise ValueError(f"{certificate} and {key} cannot be read as certificate and key: {error}") from None
    if signer is None:
        raise ValueError(f"{certificate} and {key} cannot be read as certificate and key; both are PEM files")
    return signer


def _own_certificate(key: "EllipticCurvePrivateKey") -> bytes:
    from datetime import UTC, datetime

    from cryptography import x509
    from cryptography.hazmat.primitives import hashes
    from cryptography.hazmat.primitives.serialization import Encoding

    name = x509.Name([x509.NameAttribute(x509.NameOID.COMMON_NAME, "Soundlist, seal of contracts")])
    usage = x509.KeyUsage(
        digital_signature=True,
        content_commitment=True,
        key_encipherment=False,
        data_encipherment=False,
        key_agreement=False,
        key_cert_sign=False,
        crl_sign=False,
        encipher_only=False,
        decipher_only=False,
    )
    return (
        x509.CertificateBuilder()
        .subject_name(name)
        .issuer_name(name)
        .public_key(key.public_key())
        .serial_number(1)
        .not_valid_before(datetime(2020, 1, 1, tzinfo=UTC))  # it is its key that is known, not its dates
        .not_valid_after(datetime(9999, 12, 31, tzinfo=UTC))  # none was set (RFC 5280, section 4.1.2.5)
        .add_extension(usage, critical=True)
        .sign(key, hashes.SHA256())
        .public_bytes(Encoding.DER)
    )


def marks_of(pdf: bytes) -> list[str]:
    """Return the ids of seals that a file names, ten at most."""
    return sorted({match.decode() for match in _MARKED.findall(pdf)})[:10]


def sealing_key(pdf: bytes) -> str:
    """Return the SHA-256 of the public key by which a file says that it was sealed; empty without a seal.

    Runs in a child, which may not open the sockets that validation wants of asyncio, so the seal is not validated.
    """
    from asn1crypto import cms
    from pyhanko.pdf_utils.reader import PdfFileReader

    try:
        fields = PdfFileReader(io.BytesIO(pdf)).root["/AcroForm"]["/Fields"]
        signature = cms.ContentInfo.load(bytes(fields[0]["/V"]["/Contents"]))["content"]
        return str(signature["certificates"][0].chosen.public_key.sha256.hex())
    except Exception:  # whatever the library makes of another or a damaged file, it has no seal that can be read
        return ""


def read_seal(pdf: bytes) -> SealRead:
    """Return a file's account of its seal; of anything that cannot be read, that it has none."""
    from pyhanko.pdf_utils.reader import PdfFileReader
    from pyhanko.sign.validation import validate_pdf_signature
    from pyhanko.sign.validation.status import SignatureCoverageLevel
    from pyhanko_certvalidator import ValidationContext

    unsealed = SealRead(is_sealed=False, is_intact=False, covers_file=False, key_sha256="", sealed_at="")
    try:
        sealed = PdfFileReader(io.BytesIO(pdf)).embedded_signatures
        if not sealed:
            return unsealed
        first = sealed[0]
        # Whether the key is one of ours is the server's to say: the certificate is taken as it is.
        trust = ValidationContext(trust_roots=[first.signer_cert], allow_fetching=False)
        status = validate_pdf_signature(first, signer_validation_context=trust)
        at = first.self_reported_timestamp
        return SealRead(
            is_sealed=True,
            is_intact=bool(status.intact and status.valid),
            covers_file=status.coverage is SignatureCoverageLevel.ENTIRE_FILE,
            key_sha256=first.signer_cert.public_key.sha256.hex(),
            sealed_at=at.isoformat() if at else "",
        )
    except Exception:  # whatever the library makes of a damaged file, this one has no seal that can be read
        return unsealed
