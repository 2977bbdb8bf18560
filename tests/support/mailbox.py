"""A real SMTP server that keeps what it receives."""

import asyncio
import socket
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from email import message_from_bytes, policy
from email.message import EmailMessage

from aiosmtpd.controller import Controller
from aiosmtpd.smtp import SMTP, Envelope
from aiosmtpd.smtp import Session as SmtpSession

from app.core.runtime import Runtime


class Mailbox:
    """What an SMTP server received; it may refuse."""

    def __init__(self) -> None:
        self.received: list[Envelope] = []
        self.refuses = False
        self.takes_s = 0.0

    async def handle_DATA(self, _server: SMTP, _session: SmtpSession, envelope: Envelope) -> str:  # noqa: N802
        await asyncio.sleep(self.takes_s)
        if self.refuses:
            return "451 try again later"
        self.received.append(envelope)
        return "250 taken"

    def messages_for(self, address: str) -> list[EmailMessage]:
        """Return the mails to an address, parsed."""
        mine = [envelope.content or b"" for envelope in self.received if address in envelope.rcpt_tos]
        return [message_from_bytes(content, EmailMessage, policy=policy.default) for content in mine]

    def texts_for(self, address: str) -> list[str]:
        return [(envelope.content or b"").decode() for envelope in self.received if address in envelope.rcpt_tos]


@contextmanager
def serving(mailbox: Mailbox) -> Iterator[str]:
    """Run its server; give its address."""
    with socket.create_server(("127.0.0.1", 0)) as probe:
        port = probe.getsockname()[1]
    controller = Controller(mailbox, hostname="127.0.0.1", port=port)
    controller.start()
    yield f"smtp://127.0.0.1:{port}"
    controller.stop()


def with_smtp(runtime: Runtime, url: str) -> Runtime:
    """Return the process's runtime as it would be with this mail server, sending at once."""
    settings = runtime.settings.model_copy(update={"smtp_url": url, "digest_delay_s": 0.0})
    return replace(runtime, settings=settings)
