"""The links that the server mails, read from its outbox."""

from sqlalchemy import select

from app.notifications.models import Mail
from tests.support.server import RunningServer


def mailed_links(server: RunningServer, address: str) -> list[str]:
    """Return every link that was mailed to an address, oldest first."""
    server.wait_for_jobs()
    with server.runtime.database.reading() as session:
        links = session.scalars(select(Mail.link).where(Mail.recipient == address).order_by(Mail.id))
        return [link for link in links if link]


def secret_for(server: RunningServer, address: str) -> str:
    """Return the secret of the newest link that was mailed to an address."""
    return mailed_links(server, address)[-1].rpartition("/")[2]
