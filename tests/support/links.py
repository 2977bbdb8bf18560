"""The links that the server mails, read from its outbox."""

from sqlalchemy import select

from app.notifications.models import Mail
from tests.support.server import RunningServer

UUID_CHARS = 36


def mailed_links(server: RunningServer, address: str) -> list[str]:
    """Return every link that was mailed to an address, oldest first."""
    server.wait_for_jobs()
    with server.runtime.database.reading() as session:
        links = session.scalars(select(Mail.link).where(Mail.recipient == address).order_by(Mail.id))
        return [link for link in links if link]


def secret_for(server: RunningServer, address: str) -> str:
    """Return the secret of the newest mailed link that has one; other links lead to pages, such as of a new browser."""
    ends = [link.rpartition("/")[2] for link in mailed_links(server, address)]
    return [end for end in ends if len(end) > UUID_CHARS][-1]
