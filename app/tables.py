"""Every table of every room, imported once for migrations and tests."""

from app.accounts import models as _accounts
from app.accounts.security_log import models as _security_events
from app.agreements import models as _agreements
from app.amendments import models as _amendments
from app.briefs import models as _briefs
from app.builds import models as _builds
from app.builds.audits import models as _audits
from app.builds.libraries import models as _sound_libraries
from app.builds.same_sounds import models as _same_sounds
from app.conformance import models as _conformance
from app.core import backups as _backups
from app.core import changes as _changes
from app.core.db import Base
from app.core.web import http as _http
from app.deliveries import models as _deliveries
from app.hiring import models as _hiring
from app.money import models as _money
from app.notifications import models as _notifications
from app.operations import models as _operations
from app.projects import models as _projects
from app.references import models as _references
from app.renders import models as _renders
from app.reviews import models as _reviews
from app.scenes import models as _scenes
from app.shares import models as _shares
from app.sound_lists import models as _sound_lists
from app.voice_lines import models as _voice_lines
from app.webhooks import models as _webhooks


def is_ours(table: str) -> bool:
    """Whether a table is one of the rooms' own, and not DBOS's or Alembic's."""
    return table in Base.metadata.tables
