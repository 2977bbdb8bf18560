"""An SMTP server of a test, and the worker's part that hands mails to it."""

import re
import socket
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from email import message_from_bytes, policy

from aiosmtpd.controller import Controller
from aiosmtpd.smtp import SMTP, Envelope
from aiosmtpd.smtp import Session as SmtpSession

from app.notifications import mail_jobs
from tests.support.server import RunningServer


@dataclass
class MailServer:
    """What an SMTP server received while it was set as the server's own."""

    server: RunningServer
    received: list[Envelope] = field(default_factory=list)
    refuses: bool = False

    async def handle_DATA(self, _server: SMTP, _session: SmtpSession, envelope: Envelope) -> str:  # noqa: N802
        if self.refuses:
            return "550 no such mailbox here"
        self.received.append(envelope)
        return "250 taken"

    def texts_for(self, address: str) -> list[str]:
        """Return the mails that an address received, the oldest first."""
        if not self.refuses:  # the job of a mail that is refused waits to try again
            self.server.wait_for_jobs()
        mail_jobs.send_pending(self.server.runtime)
        return [
            message_from_bytes(envelope.content or b"", policy=policy.default).get_content()
            for envelope in self.received
            if address in envelope.rcpt_tos
        ]

    def secret_for(self, address: str) -> str:
        """Return the secret of the newest link that was mailed to an address."""
        links = re.findall(r"https?://\S+/(\S+)", self.texts_for(address)[-1])
        return str(links[-1])


@contextmanager
def mail_server(server: RunningServer) -> Iterator[MailServer]:
    """Give the running server a mail server for a while."""
    box = MailServer(server)
    with socket.create_server(("127.0.0.1", 0)) as probe:
        port = probe.getsockname()[1]
    controller = Controller(box, hostname="127.0.0.1", port=port)
    controller.start()
    settings = server.runtime.settings
    before = settings.smtp_url, settings.digest_delay_s
    settings.smtp_url, settings.digest_delay_s = f"smtp://127.0.0.1:{port}", 0.0
    try:
        yield box
    finally:
        settings.smtp_url, settings.digest_delay_s = before  # what is still tried is shown in the outbox now
        server.wait_for_jobs()
        controller.stop()
