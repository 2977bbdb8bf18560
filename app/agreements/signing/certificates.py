"""The part of a certificate of signing on each signature."""

from collections.abc import Sequence
from datetime import datetime
from typing import Protocol
from zoneinfo import ZoneInfo

from app.accounts.rules import PROOF_WORDS, AddressProof
from app.agreements.clauses.text import literal
from app.agreements.drafts.documents import CertificatePart
from app.agreements.models import Contract
from app.agreements.rules import Party
from app.agreements.signing.drawn_signatures import Strokes, drawing_sha256, drawing_svg
from app.agreements.signing.rules import BY_CODE, CONSENT, WITHOUT_CODE
from app.core.typesetting import undrawn_scripts


class Signed(Protocol):
    """A signature under a contract, a change order or a statement."""

    @property
    def party(self) -> Party:
        """Return the party signed for."""

    @property
    def name(self) -> str:
        """The name as typed."""

    @property
    def email(self) -> str:
        """The mail address of the person."""

    @property
    def email_proof(self) -> AddressProof | None:
        """Return the proof that they read its mail; None: it was not shown."""

    @property
    def address(self) -> str:
        """The address on the network."""

    @property
    def agent(self) -> str:
        """The browser and its system."""

    @property
    def code_entered_at(self) -> datetime | None:
        """Return the entry time of the mailed code; None: none was asked for."""

    @property
    def drawing(self) -> Strokes | None:
        """The name as it was drawn; None: it was not."""

    @property
    def accepted_at(self) -> datetime:
        """Return the time of signing."""


def signatures_page(signed: Sequence[Signed], text_sha256: str, zone: ZoneInfo) -> list[CertificatePart]:
    """Return the page of signatures that follows the text of a change order or a statement; none before the first."""
    if not signed:
        return []
    head = [
        "# Signatures",
        f"SHA-256 of the text: {text_sha256}",
        f"Each of those who signed agreed to this sentence: {literal(CONSENT)}",
    ]
    return [CertificatePart("\n\n".join(head)), *(signature_part(signature, zone) for signature in signed)]


def studio_zone(contract: Contract) -> ZoneInfo:
    """Return the time zone in which a contract's certificates give times beside UTC."""
    return ZoneInfo(contract.project.studio.time_zone)


def signature_part(signature: Signed, zone: ZoneInfo) -> CertificatePart:
    """Return the part of a certificate on one signature, and the name as it was drawn."""
    code = f"{BY_CODE} {in_both(signature.code_entered_at, zone)}" if signature.code_entered_at else WITHOUT_CODE
    facts = [
        f"- Signed {in_both(signature.accepted_at, zone)}",
        f"- Email: {literal(signature.email)}, {PROOF_WORDS[signature.email_proof]}",
        f"- Code: {literal(code)}",
        f"- Network address: {literal(signature.address) or 'unknown'}",
        f"- Browser: {literal(signature.agent) or 'unknown'}",
        *([f"- Name drawn by hand, SHA-256 {drawing_sha256(signature.drawing)}:"] if signature.drawing else []),
    ]
    lines = [
        f"## {literal(signature.name)}, for the {signature.party}",
        *([_undrawn(scripts)] if (scripts := undrawn_scripts(signature.name)) else []),
        "\n".join(facts),
    ]
    return CertificatePart("\n\n".join(lines), drawing_svg(signature.drawing) if signature.drawing else None)


def _undrawn(scripts: Sequence[str]) -> str:
    named = ", ".join(scripts)
    return f"This PDF has no font made for {named}, so this name may show boxes. The audit trail has its letters."


def in_both(at: datetime | None, zone: ZoneInfo) -> str:
    """Return a time in UTC and in a studio's time zone."""
    if at is None:
        return "at no known time"
    here = at.astimezone(zone)
    utc = f"{at:%Y-%m-%d %H:%M:%S} UTC"
    return utc if zone.key == "UTC" else f"{utc} ({here:%Y-%m-%d %H:%M:%S} {zone.key})"
