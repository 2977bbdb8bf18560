"""Every table of every room, imported once for migrations and tests."""

from app.accounts import models as _accounts  # noqa: F401
from app.builds import models as _builds  # noqa: F401
from app.conformance import models as _conformance  # noqa: F401
from app.contracts import models as _contracts  # noqa: F401
from app.deliveries import models as _deliveries  # noqa: F401
from app.kit import http as _http  # noqa: F401
from app.kit.db import Base
from app.notifications import models as _notifications  # noqa: F401
from app.projects import models as _projects  # noqa: F401
from app.renders import models as _renders  # noqa: F401
from app.reviews import models as _reviews  # noqa: F401
from app.sound_lists import models as _sound_lists  # noqa: F401


def is_ours(table: str) -> bool:
    """Whether a table is one of the rooms' own, and not DBOS's or Alembic's."""
    return table in Base.metadata.tables
