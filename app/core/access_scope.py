"""The principal of a transaction; the database shows it their rows and no others."""

from dataclasses import dataclass
from uuid import UUID


@dataclass(frozen=True)
class AccessScope:
    """A person's studios and engagements, or one project alone; without either, nothing."""

    person_id: UUID | None = None
    project_id: UUID | None = None  # of a build's token, or of a shared link
    limited_studio_ids: frozenset[UUID] = frozenset()  # of which the person sees only the projects that they are in


NOBODY = AccessScope()
