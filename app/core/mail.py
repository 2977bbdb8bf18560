"""Sends one email to an SMTP server."""

import asyncio
from collections.abc import Mapping
from email.headerregistry import BaseHeader, HeaderRegistry, UnstructuredHeader
from email.message import EmailMessage
from email.policy import Policy, default
from email.utils import make_msgid
from urllib.parse import unquote, urlsplit

import aiosmtplib

TIMEOUT_S = 20.0


class PlainHeader(UnstructuredHeader, BaseHeader):
    """A header on one line as it is: an address that is folded into encoded words is read by no mail program."""

    def fold(self, *, policy: Policy) -> str:
        """Return the header's line."""
        return f"{self.name}: {self}{policy.linesep}"


_HEADERS = HeaderRegistry()
for _name in ("list-unsubscribe", "list-unsubscribe-post"):
    _HEADERS.map_to_type(_name, PlainHeader)
_POLICY = default.clone(header_factory=_HEADERS)


class BadSmtpUrl(ValueError):
    """SOUNDLIST_SMTP_URL is not an address of an SMTP server."""


def build_mail(*, sender: str, recipient: str, subject: str, text: str, stop_url: str | None = None) -> EmailMessage:
    """Return a message of plain text; the message class refuses a line break in a header.

    A POST to `stop_url` stops mails like this: mail programs offer that as one click (RFC 8058).
    """
    message = EmailMessage(policy=_POLICY)
    message["From"] = sender
    message["To"] = recipient
    message["Subject"] = " ".join(subject.split())
    message["Message-ID"] = make_msgid(domain="soundlist")
    message["Auto-Submitted"] = "auto-generated"
    if stop_url:
        message["List-Unsubscribe"] = f"<{stop_url}>"
        message["List-Unsubscribe-Post"] = "List-Unsubscribe=One-Click"
    message.set_content(text)
    return message


def add_html(message: EmailMessage, html: str, pngs: Mapping[str, bytes]) -> None:
    """Give a message of plain text the same as HTML, with the pictures that it names `cid:`; they load nothing."""
    message.add_alternative(html, subtype="html")
    *_, page = message.iter_parts()
    for cid, png in pngs.items():
        page.add_related(png, "image", "png", cid=f"<{cid}>", disposition="inline")


def send(smtp_url: str, message: EmailMessage) -> None:
    """Send to the server; raise aiosmtplib.SMTPException or OSError if it does not accept the message."""
    parts = urlsplit(smtp_url)
    if parts.scheme not in ("smtp", "smtps") or not parts.hostname:
        raise BadSmtpUrl(
            f"{parts.scheme}://{parts.hostname} is not an SMTP server; write smtp://user:password@host:port"
        )
    asyncio.run(
        aiosmtplib.send(
            message,
            hostname=parts.hostname,
            port=parts.port or (465 if parts.scheme == "smtps" else 587),
            username=unquote(parts.username) if parts.username else None,
            password=unquote(parts.password) if parts.password else None,
            use_tls=parts.scheme == "smtps",
            timeout=TIMEOUT_S,
        )
    )
