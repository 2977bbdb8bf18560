"""The wiring of a process: settings, database, store and queue, passed to endpoints and jobs."""

from dataclasses import dataclass, field

from app.core.db import Database
from app.core.jobs.queue import CLIENT_CONNECTIONS, JobQueue
from app.core.parsing import Parsers
from app.core.storage import Store, open_store
from app.settings import Settings


@dataclass(frozen=True)
class Runtime:
    """The parts of one running process."""

    settings: Settings
    database: Database
    store: Store
    queue: JobQueue
    parsers: Parsers = field(default_factory=Parsers)  # of what strangers send; nothing starts before the first call

    @classmethod
    def of(cls, settings: Settings, *, engine_connections: int = 0) -> "Runtime":
        """Open the settings' resources; a worker leaves some of the process's connections to the engine of jobs."""
        connections = settings.database_connections - CLIENT_CONNECTIONS - engine_connections
        database = Database(settings.resolved_database_url, connections=connections)
        return cls(settings, database, open_store(settings), JobQueue(database))

    def close(self) -> None:
        """Close connections, and end the parsers' process."""
        self.parsers.close()
        self.queue.close()
        self.database.dispose()
