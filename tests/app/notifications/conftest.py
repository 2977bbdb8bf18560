"""A mail server for the tests of this room."""

from collections.abc import Iterator

import pytest

from tests.support.mailbox import Mailbox, serving


@pytest.fixture
def mailbox() -> Mailbox:
    return Mailbox()


@pytest.fixture
def smtp_url(mailbox: Mailbox) -> Iterator[str]:
    with serving(mailbox) as url:
        yield url
