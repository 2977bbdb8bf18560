"""Roles, scopes and policies, stated without a database."""

import ipaddress
import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from datetime import datetime, timedelta
from enum import StrEnum
from typing import Any
from uuid import UUID

from app.accounts.common_passwords import is_common
from app.accounts.errors import BadAddress, LastProducer, PasswordTooWeak, PersonNeeded
from app.core.access_scope import AccessScope


class Role(StrEnum):
    """A member's role in the studio; liaisons and the approver are named per project."""

    PRODUCER = "producer"
    LIAISON = "liaison"
    REVIEWER = "reviewer"
    IMPLEMENTER = "implementer"


# Who may act for the studio in a project, once named there, and approve.
LEAD_ROLES = frozenset({Role.PRODUCER, Role.LIAISON})


class AccessKind(StrEnum):
    """A member's access that works without their sign-in, and so outlives their membership unless it is ended."""

    TOKENS = "tokens"
    GUEST_LINKS = "guest_links"
    POSTING_LINKS = "posting_links"
    WEBHOOKS = "webhooks"


class SecondFactorUse(StrEnum):
    """A use for which a studio may require a second factor."""

    SIGNING = "signing"  # its contracts, by either party
    PAYING = "paying"  # recording payments and refunds, and what makes an amount due at once
    EVERYTHING = "everything"  # all that its members do, and signing by either party


class Scope(StrEnum):
    """The rights of a build's token."""

    SPEC_READ = "spec:read"
    LIST_READ = "list:read"
    CHECKS_WRITE = "checks:write"
    MANIFEST_READ = "manifest:read"
    DELIVERIES_WRITE = "deliveries:write"
    RIGHTS_READ = "rights:read"


MAX_TOKEN_DAYS = 365  # how long a token works at most
TOKEN_WARNED_BEFORE = timedelta(days=14)  # or in the last half of a shorter life


def is_end_near(created_at: datetime, expires_at: datetime, now: datetime) -> bool:
    """Whether the end of a token is to be announced."""
    return expires_at - min(TOKEN_WARNED_BEFORE, (expires_at - created_at) / 2) <= now


class AddressProof(StrEnum):
    """The way an account's address was verified."""

    MAIL = "mail"  # by a link that was sent there and shown nowhere else
    OPERATOR = "operator"  # by a link that the operator read on the command line and handed over
    PROVIDER = "provider"  # by the sign-in provider of a studio to which the address's domain is bound


PROOF_WORDS: Mapping[AddressProof | None, str] = {
    AddressProof.MAIL: "proven by a link mailed to it",
    AddressProof.OPERATOR: "proven by a link that the server's operator handed over",
    AddressProof.PROVIDER: "proven by the sign-in provider of a studio",
    None: "not proven",
}
MIN_PASSWORD_LENGTH = 10
MAX_PASSWORD_LENGTH = 200
IPV6_NETWORK = 64  # what one subscriber is given
MEASURED_LENGTH = 40  # estimating 72 characters can take more than a second
FEWEST_GUESSES = 10**10  # by zxcvbn's estimate
PRODUCT_WORDS = ("soundlist", "sound", "studio", "password")
WEAKNESS_MESSAGES = {
    "passwords": "it is, or contains, one of the most common passwords",
    "user_inputs": "it contains your email, your name, your studio's or the name of this product",
    "spatial": "it follows neighbouring keys",
    "repeat": "it repeats itself",
    "sequence": "it is a sequence such as abcd or 6543",
    "date": "it is, or contains, a date",
}
MAX_ADDRESS_LENGTH = 254  # RFC 5321, 4.5.3.1.3, without its angle brackets
# Browsers name those that they descend from too, so the most particular mark comes first.
BROWSERS = (
    ("Edg/", "Edge"),
    ("OPR/", "Opera"),
    ("Firefox/", "Firefox"),
    ("Chrome/", "Chrome"),
    ("Safari/", "Safari"),
    ("curl/", "curl"),
)
SYSTEMS = (
    ("Android", "Android"),
    ("iPhone", "iOS"),
    ("iPad", "iPadOS"),
    ("Windows", "Windows"),
    ("Mac OS X", "macOS"),
    ("CrOS", "ChromeOS"),
    ("Linux", "Linux"),
)
# One @, and nothing that a mail header or a log line could take for something else.
ADDRESS = re.compile(
    r"[a-z0-9!#$%&'*+/=?^_`{|}~.-]{1,64}@[a-z0-9](?:[a-z0-9-]*[a-z0-9])?(?:\.[a-z0-9](?:[a-z0-9-]*[a-z0-9])?)*"
)


def normalised_email(address: str) -> str:
    """Return the form under which an address is unique: trimmed, lower case."""
    return address.strip().lower()


def ensure_address(address: str) -> str:
    """Return the normalised form of a mail address, or raise BadAddress."""
    normalised = normalised_email(address)
    if len(normalised) > MAX_ADDRESS_LENGTH or not ADDRESS.fullmatch(normalised):
        message = "enter an email such as name@studio.example"
        raise BadAddress(message, errors=[{"where": "email", "message": message}])
    return normalised


def ensure_strong_password(password: str | None, address: str, *names: str) -> str:
    """Return the password, or raise PasswordTooWeak; `names` are words that others know of its owner."""
    message = None
    if not password or len(password) < MIN_PASSWORD_LENGTH:
        message = f"choose a password of {MIN_PASSWORD_LENGTH} characters or more"
    elif len(password) > MAX_PASSWORD_LENGTH:
        message = f"choose a password of {MAX_PASSWORD_LENGTH} characters or fewer"
    elif reason := _why_weak(password, address, names):
        message = f"this password is easily guessed: {reason}. Four or more unrelated words make a good one"
    if message or not password:
        raise PasswordTooWeak(message or "", errors=[{"where": "password", "message": message or ""}])
    return password


def _why_weak(password: str, address: str, names: Collection[str]) -> str | None:
    """Return the reason, in words, that a password is easily guessed; None where it is not."""
    from zxcvbn import zxcvbn  # its lists take 0.2 s to load, which the command line need not wait for

    personal_words = [
        word for text in (address, *names) for word in (text, *re.split(r"[^\w]+", text)) if len(word) > 2
    ]
    if is_common(password):
        return WEAKNESS_MESSAGES["passwords"]
    estimate = zxcvbn(password[:MEASURED_LENGTH], user_inputs=[*PRODUCT_WORDS, *personal_words])
    if estimate["guesses"] >= FEWEST_GUESSES:
        return None
    longest = max(estimate["sequence"], key=lambda match: len(match["token"]))
    return WEAKNESS_MESSAGES.get(
        longest.get("dictionary_name") or longest["pattern"], "it is made of common words or names"
    )


def mailbox_of(address: str) -> str:
    """Return the mailbox behind an address: what follows a + before the @ does not make another one."""
    name, at, domain = address.rpartition("@")
    if not at:
        return address
    return f"{name.partition('+')[0]}@{domain}"


def network_of(address: str) -> str:
    """Return the network of an address: an IPv4 address, or the /64 of an IPv6 one."""
    try:
        ip = ipaddress.ip_address(address)
    except ValueError:
        return address
    if isinstance(ip, ipaddress.IPv6Address):
        if ip.ipv4_mapped is not None:
            return str(ip.ipv4_mapped)
        return str(ipaddress.ip_network((ip, IPV6_NETWORK), strict=False))
    return str(ip)


def device_of(user_agent: str) -> str:
    """Return a browser and its system in words, from the header that it sends."""
    browser = next((name for mark, name in BROWSERS if mark in user_agent), "Unknown browser")
    system = next((name for mark, name in SYSTEMS if mark in user_agent), "")
    return f"{browser} on {system}" if system else browser


def ensure_producer_remains(others: Collection["frozenset[Role]"], new_roles: "frozenset[Role]") -> None:
    """Raise LastProducer when a change would leave a studio without a producer."""
    if Role.PRODUCER not in new_roles and not any(Role.PRODUCER in roles for roles in others):
        raise LastProducer("a studio needs a producer; make someone else a producer first")


@dataclass(frozen=True)
class MemberChange:
    """The content of `member.changed`: a member has other roles now, or with none has left the studio."""

    studio_id: UUID
    person_id: UUID
    roles: frozenset[Role]
    changed_by: UUID
    hand_over_to: UUID | None = None  # who approves in their place
    kept: frozenset[AccessKind] = frozenset()  # kinds that go on, of who sees their projects

    @property
    def has_left(self) -> bool:
        """Whether the person is no member any more."""
        return not self.roles

    @classmethod
    def of(cls, payload: Mapping[str, Any]) -> "MemberChange":
        """Return the facts of an event."""
        hand_over_to = payload["hand_over_to"]
        return cls(
            studio_id=UUID(payload["studio_id"]),
            person_id=UUID(payload["person_id"]),
            roles=frozenset(map(Role, payload["roles"])),
            changed_by=UUID(payload["changed_by"]),
            hand_over_to=UUID(hand_over_to) if hand_over_to else None,
            kept=frozenset(map(AccessKind, payload["kept"])),
        )


@dataclass(frozen=True)
class Actor:
    """The caller: a person with the roles held in each studio, or a build with its token."""

    person_id: UUID | None = None
    roles: Mapping[UUID, frozenset[Role]] = field(default_factory=dict)  # by studio
    token_id: UUID | None = None
    token_studio_id: UUID | None = None
    token_project_id: UUID | None = None
    scopes: frozenset[Scope] = frozenset()
    second_factor_studio_id: UUID | None = None  # whose sign-in provider says that a second factor was used
    limited_studio_ids: frozenset[UUID] = frozenset()  # whose members see only the projects that they are in

    @property
    def is_build(self) -> bool:
        """Whether a machine asks."""
        return self.token_id is not None

    @property
    def reach(self) -> AccessScope:
        """Whose rows the database shows."""
        return AccessScope(self.person_id, self.token_project_id, self.limited_studio_ids)

    @property
    def person(self) -> UUID:
        """The calling person; only for endpoints whose policy requires one."""
        if self.person_id is None:
            raise PersonNeeded("a build's token cannot do this; sign in as a person")
        return self.person_id

    def roles_in(self, studio_id: UUID) -> frozenset[Role]:
        """Return the roles held in a studio; empty for a stranger."""
        return self.roles.get(studio_id, frozenset())

    def studios_with(self, roles: Collection[Role]) -> list[UUID]:
        """Return the studios in which the caller holds one of these roles."""
        return [studio_id for studio_id, held in self.roles.items() if not held.isdisjoint(roles)]


class MembersSee(StrEnum):
    """The projects of a studio that its members see."""

    ALL = "all"
    OWN = "own"  # those that they are in


class Audience(StrEnum):
    """The audience of an endpoint; every endpoint declares one."""

    ANYONE = "anyone"  # without credentials
    PERSON = "person"  # anyone signed in: their own things
    STUDIO = "studio"  # members of the studio
    PRODUCER = "producer"  # producers of the studio; other members receive 403
    PROJECT = "project"  # the team, and designers engaged on the project
    TEAM = "team"  # the team; engaged designers receive 403
    APPROVER = "approver"  # the project's approver; everyone else with sight receives 403
    DESIGNER = "designer"  # engaged designers; the team receives 403
    OPERATOR = "operator"  # everyone else receives 403


@dataclass(frozen=True)
class Policy:
    """The policy of an endpoint: its audience, what admits a machine, and whether a recent sign-in is needed."""

    audience: Audience
    build: Scope | None = None
    desk_token: bool = False
    recent_sign_in: bool = False
