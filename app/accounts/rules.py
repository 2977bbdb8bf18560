"""What a person or a machine may be, stated without a database."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from uuid import UUID

from app.accounts.errors import PersonNeeded


class Role(StrEnum):
    """What a member does for the studio; liaisons and the decider are named per project."""

    PRODUCER = "producer"
    LIAISON = "liaison"
    REVIEWER = "reviewer"
    IMPLEMENTER = "implementer"


class Scope(StrEnum):
    """What a build's token may do."""

    SPEC_READ = "spec:read"
    LIST_READ = "list:read"
    CHECKS_WRITE = "checks:write"
    MANIFEST_READ = "manifest:read"
    DELIVERIES_WRITE = "deliveries:write"


MIN_PASSWORD_LENGTH = 10


def normalised_email(address: str) -> str:
    """Return the form under which an address is unique: trimmed, lower case."""
    return address.strip().lower()


@dataclass(frozen=True)
class Actor:
    """Who asks: a person with the roles held in each studio, or a build with its token."""

    person_id: UUID | None = None
    roles: Mapping[UUID, frozenset[Role]] = field(default_factory=dict)  # by studio
    token_id: UUID | None = None
    token_studio_id: UUID | None = None
    token_project_id: UUID | None = None
    scopes: frozenset[Scope] = frozenset()

    @property
    def is_build(self) -> bool:
        """Whether a machine asks."""
        return self.token_id is not None

    @property
    def person(self) -> UUID:
        """The person who asks; only for endpoints whose policy wants one."""
        if self.person_id is None:
            raise PersonNeeded("a build's token cannot do this; sign in as a person")
        return self.person_id

    def roles_in(self, studio_id: UUID) -> frozenset[Role]:
        """Return the roles held in a studio; empty for a stranger."""
        return self.roles.get(studio_id, frozenset())


class Sight(StrEnum):
    """Who may use an endpoint; every endpoint declares one."""

    ANYONE = "anyone"  # without credentials
    PERSON = "person"  # anyone signed in: their own things
    STUDIO = "studio"  # members of the studio
    PRODUCER = "producer"  # producers of the studio; other members are told 403
    PROJECT = "project"  # the team, and designers engaged on the project
    TEAM = "team"  # the team; engaged designers are told 403
    DECIDER = "decider"  # the project's decider; everyone else with sight is told 403
    DESIGNER = "designer"  # engaged designers; the team is told 403


@dataclass(frozen=True)
class Policy:
    """What an endpoint declares: who may use it, and the scope by which a build may."""

    sight: Sight
    build: Scope | None = None
