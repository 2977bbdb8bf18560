"""Accounts, studios, memberships and sessions: the tables of this room."""

from datetime import date, datetime
from uuid import UUID

from sqlalchemy import BigInteger, CheckConstraint, ForeignKey, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column, relationship

from app.accounts.rules import AddressProof, MembersSee
from app.core import clock
from app.core.columns import Dated, StudioOwned
from app.core.db import Base, new_id


class MailedLink:
    """The purpose of a mailed link. Its link is made when the mail is sent; a link made later replaces it."""

    secret_sha256: Mapped[str | None] = mapped_column(unique=True)  # None: no link has been made
    is_sent_by_mail_only: Mapped[bool] = mapped_column(default=False)  # the link was shown nowhere but in the mail


class Studio(Dated, Base):
    """A game team; the tenant that everything belongs to."""

    __tablename__ = "accounts_studios"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    name: Mapped[str]
    is_demo: Mapped[bool] = mapped_column(default=False)
    time_zone: Mapped[str] = mapped_column(default="UTC")  # an IANA name: Europe/Berlin
    second_factor_for: Mapped[list[str]] = mapped_column(default=list)  # each a SecondFactorUse
    members_see: Mapped[MembersSee] = mapped_column(default=MembersSee.ALL)
    opened_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"), index=True)  # None: by the server


class Holiday(Base):
    """A day on which a studio does not work, besides Saturdays and Sundays."""

    __tablename__ = "accounts_holidays"

    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"), primary_key=True)
    day: Mapped[date] = mapped_column(primary_key=True)
    name: Mapped[str]
    created_at: Mapped[datetime] = mapped_column(default=clock.now)  # a cue that waits since before is not delayed


class Person(Dated, Base):
    """A person with an email address; people are global, their memberships and engagements are not."""

    __tablename__ = "accounts_people"
    __table_args__ = (
        CheckConstraint("email = lower(email)", name="email_lower_case"),
        CheckConstraint("(email_verified_at is null) = (email_proof is null)", name="verified_somehow"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    email: Mapped[str] = mapped_column(unique=True)
    name: Mapped[str]
    password_hash: Mapped[str | None]  # None: signs in through the demo only
    demo_part: Mapped[str | None] = mapped_column(unique=True)  # producer, approver, designer … of the demo studio
    email_verified_at: Mapped[datetime | None]  # None: not verified
    email_proof: Mapped[AddressProof | None]  # how it was verified
    picture_sha256: Mapped[str | None]  # of its PersonPicture; None: initials are shown

    @property
    def picture(self) -> str | None:
        """The address of the picture, another one for each that the person chooses."""
        return f"/v1/people/{self.id}/picture?sha256={self.picture_sha256}" if self.picture_sha256 else None


class PersonPicture(Base):
    """The picture of a person, as the small square that is shown; it goes with the account."""

    __tablename__ = "accounts_pictures"

    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id", ondelete="CASCADE"), primary_key=True)
    sha256: Mapped[str]
    content: Mapped[bytes]
    saved_at: Mapped[datetime] = mapped_column(default=clock.now)


class Membership(Dated, Base):
    """A person's place in a studio, with the roles held there."""

    __tablename__ = "accounts_memberships"

    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"), primary_key=True)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), primary_key=True, index=True)
    roles: Mapped[list[str]]
    person: Mapped[Person] = relationship(lazy="raise")
    studio: Mapped[Studio] = relationship(lazy="raise")


class SignIn(Dated, Base):
    """One signed-in browser; the cookie's secret is kept as its SHA-256 only."""

    __tablename__ = "accounts_sign_ins"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), index=True)
    secret_sha256: Mapped[str] = mapped_column(unique=True)
    device: Mapped[str] = mapped_column(default="")  # browser and system, in words
    place: Mapped[str] = mapped_column(default="")  # network address that it signed in from
    last_seen_at: Mapped[datetime] = mapped_column(default=clock.now)  # to within ten minutes
    second_factor_studio_id: Mapped[UUID | None]  # whose provider says that a second factor was used; None: none does
    expires_at: Mapped[datetime]


class TotpFactor(Dated, Base):
    """A person's authenticator app (TOTP), one at most."""

    __tablename__ = "accounts_totp_factors"

    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id", ondelete="CASCADE"), primary_key=True)
    sealed_secret: Mapped[bytes]  # encrypted with a key that follows from the server's secret key
    last_step: Mapped[int] = mapped_column(BigInteger, default=0)  # of the last code used; codes up to it are refused
    confirmed_at: Mapped[datetime | None]  # None: is being set up, and not asked for


class RecoveryCode(Dated, Base):
    """A code that stands in for a lost second factor, once."""

    __tablename__ = "accounts_recovery_codes"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id", ondelete="CASCADE"), index=True)
    code_sha256: Mapped[str]
    used_at: Mapped[datetime | None]


class Passkey(Dated, Base):
    """A key on a person's device that signs in alone (WebAuthn)."""

    __tablename__ = "accounts_passkeys"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id", ondelete="CASCADE"), index=True)
    credential_id: Mapped[bytes] = mapped_column(unique=True)
    public_key: Mapped[bytes]
    sign_count: Mapped[int] = mapped_column(BigInteger)  # of the device, which never falls; 0 where it does not count
    challenge_made_at_us: Mapped[int] = mapped_column(BigInteger)  # of the last challenge answered; none counts twice
    name: Mapped[str]
    last_used_at: Mapped[datetime | None]


class SignInProvider(Base):
    """The OpenID Connect provider by which the people of a studio sign in."""

    __tablename__ = "accounts_sign_in_providers"

    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"), primary_key=True)
    issuer: Mapped[str]
    client_id: Mapped[str]
    sealed_client_secret: Mapped[bytes]  # encrypted with a key that follows from the server's secret key
    authorization_endpoint: Mapped[str]  # this and the following as its discovery document named them on saving
    token_endpoint: Mapped[str]
    jwks_uri: Mapped[str]
    is_secret_in_body: Mapped[bool]  # the provider takes the client secret in the body only
    saved_at: Mapped[datetime] = mapped_column(default=clock.now)


class SignInDomain(StudioOwned, Base):
    """A mail domain whose addresses a studio's provider vouches for; bound on the command line only."""

    __tablename__ = "accounts_sign_in_domains"

    domain: Mapped[str] = mapped_column(primary_key=True)
    bound_at: Mapped[datetime] = mapped_column(default=clock.now)


class PasswordReset(MailedLink, Base):
    """A mailed link that sets a new password, once and within an hour."""

    __tablename__ = "accounts_password_resets"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), index=True)
    expires_at: Mapped[datetime]
    used_at: Mapped[datetime | None]


class EmailVerification(MailedLink, Base):
    """A mailed link that shows that an account's holder reads its address, once and within a day."""

    __tablename__ = "accounts_email_verifications"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), index=True)
    expires_at: Mapped[datetime]
    used_at: Mapped[datetime | None]


class EmailChange(MailedLink, Base):
    """One end of a change of an account's address: the link that was mailed to the old address, or to the new one."""

    __tablename__ = "accounts_email_changes"
    __table_args__ = (UniqueConstraint("person_id", "is_new_end"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id", ondelete="CASCADE"), index=True)
    new_email: Mapped[str]
    is_new_end: Mapped[bool]
    expires_at: Mapped[datetime]
    confirmed_at: Mapped[datetime | None]


class SignUp(MailedLink, Base):
    """A mailed link that opens a new account, once and within a day."""

    __tablename__ = "accounts_sign_ups"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    email: Mapped[str] = mapped_column(index=True)
    expires_at: Mapped[datetime]
    used_at: Mapped[datetime | None]


class Operator(Base):
    """An operator of the server; named on its command line only."""

    __tablename__ = "accounts_operators"

    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), primary_key=True)
    named_at: Mapped[datetime] = mapped_column(default=clock.now)
    person: Mapped[Person] = relationship(lazy="raise")


class RateLimit(Base):
    """The time at which the next try is allowed (GCRA): one row for each limit and key."""

    __tablename__ = "accounts_rate_limits"

    key: Mapped[str] = mapped_column(primary_key=True)  # hash of the limit's name and its subject
    free_at_s: Mapped[float] = mapped_column(index=True)  # Unix time from which every try is free again


class Token(StudioOwned, Dated, Base):
    """A machine's key to one project, with narrow scopes."""

    __tablename__ = "accounts_tokens"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    project_id: Mapped[UUID] = mapped_column(index=True)  # projects stand above this room: an id, not a relation
    name: Mapped[str]
    secret_sha256: Mapped[str] = mapped_column(unique=True)
    scopes: Mapped[list[str]]
    created_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    last_used_at: Mapped[datetime | None]
    expires_at: Mapped[datetime] = mapped_column(index=True)
    warned_at: Mapped[datetime | None]  # when its end was announced
    revoked_at: Mapped[datetime | None]
    creator: Mapped[Person] = relationship(lazy="raise")


class DeskToken(Dated, Base):
    """A person's key for `soundlist desk`, which reads what they owe and nothing else."""

    __tablename__ = "accounts_desk_tokens"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), index=True)
    name: Mapped[str]
    secret_sha256: Mapped[str] = mapped_column(unique=True)
    last_used_at: Mapped[datetime | None]
    expires_at: Mapped[datetime]
    warned_at: Mapped[datetime | None]  # when its end was announced


class Quota(Base):
    """A limit of one studio that is not the default; set by an operator."""

    __tablename__ = "accounts_quotas"
    __table_args__ = (CheckConstraint("maximum >= 0", name="maximum_known"),)

    studio_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_studios.id"), primary_key=True)
    kind: Mapped[str] = mapped_column(primary_key=True)
    maximum: Mapped[int] = mapped_column(BigInteger)


class StudioInvitation(MailedLink, StudioOwned, Dated, Base):
    """A mailed link that makes its holder a member of the studio."""

    __tablename__ = "accounts_studio_invitations"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    email: Mapped[str]
    roles: Mapped[list[str]]
    approves_project_id: Mapped[UUID | None]  # becomes the approver of this project on joining
    invited_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    expires_at: Mapped[datetime]
    accepted_at: Mapped[datetime | None]
    accepted_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    revoked_at: Mapped[datetime | None]
    studio: Mapped[Studio] = relationship(lazy="raise")
    inviter: Mapped[Person] = relationship(lazy="raise", foreign_keys=[invited_by])


class InvoiceDetails(Base):
    """The details of a studio or a person on invoices, as saved once; rows are only added, and the newest holds."""

    __tablename__ = "accounts_invoice_details"
    __table_args__ = (CheckConstraint("(studio_id is null) <> (person_id is null)", name="one_owner"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    studio_id: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_studios.id"), index=True)
    person_id: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"), index=True)
    name: Mapped[str]  # by which it trades
    street: Mapped[str]
    postal_code: Mapped[str]
    city: Mapped[str]
    country_code: Mapped[str]  # ISO 3166-1 alpha-2, or empty
    vat_id: Mapped[str]  # with the prefix of its country
    tax_number: Mapped[str]  # of the local tax office
    account_number: Mapped[str]  # IBAN, or the number of an account without one
    no_tax_reason: Mapped[str]  # why no tax is charged, where the contract names no rate and no reverse charge
    saved_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    saved_at: Mapped[datetime] = mapped_column(default=clock.now)
