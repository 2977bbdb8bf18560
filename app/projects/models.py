"""The tables of this room."""

from datetime import date, datetime
from uuid import UUID

from sqlalchemy import BigInteger, CheckConstraint, ForeignKey, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column, relationship

from app.accounts.models import MailedLink, Person, Studio
from app.core import clock
from app.core.columns import Dated, ProjectOwned, StudioOwned
from app.core.db import Base, new_id
from app.projects.rules import DesignersHear, EngagementKind


class Project(StudioOwned, Dated, Base):
    """One game, or one part of it, that needs sounds."""

    __tablename__ = "projects_projects"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    name: Mapped[str]
    description: Mapped[str] = mapped_column(default="")
    cue_prefix: Mapped[str]  # SW makes SW-001
    created_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    archived_at: Mapped[datetime | None]
    nda_needed: Mapped[bool] = mapped_column(default=False)  # designers see brief, list and spec once they accepted it
    designers_hear: Mapped[DesignersHear] = mapped_column(default=DesignersHear.APPROVED)  # of other designers' sounds
    is_sample: Mapped[bool] = mapped_column(default=False)  # made to look around in, and deleted by one request
    studio: Mapped[Studio] = relationship(lazy="raise")

    @property
    def project_id(self) -> UUID:
        """The project itself, as everything else in it names it."""
        return self.id


class Spec(ProjectOwned, Dated, Base):
    """One version of a project's delivery spec, as TOML; the newest holds."""

    __tablename__ = "projects_specs"
    __table_args__ = (UniqueConstraint("project_id", "version"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    version: Mapped[int]
    toml: Mapped[str]
    sha256: Mapped[str]
    note: Mapped[str] = mapped_column(default="")
    created_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    author: Mapped[Person] = relationship(lazy="raise")


class Liaison(StudioOwned, Dated, Base):
    """A member of the studio who acts for the team in a project."""

    __tablename__ = "projects_liaisons"

    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"), primary_key=True)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), primary_key=True)
    person: Mapped[Person] = relationship(lazy="raise")


class ProjectMember(StudioOwned, Dated, Base):
    """A member of the studio who is in a project; only they see it where the studio's members see their own alone."""

    __tablename__ = "projects_members"

    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"), primary_key=True)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), primary_key=True, index=True)
    person: Mapped[Person] = relationship(lazy="raise")


class ApproverChange(ProjectOwned, Dated, Base):
    """The approvers of a project, since when, and why it changed; the newest row holds."""

    __tablename__ = "projects_approver_changes"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    reason: Mapped[str]
    changed_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    person: Mapped[Person] = relationship(lazy="raise", foreign_keys=[person_id])
    changer: Mapped[Person] = relationship(lazy="raise", foreign_keys=[changed_by])


class CategoryApprover(ProjectOwned, Dated, Base):
    """The approvers of a category of the sound list; of each category the newest row holds."""

    __tablename__ = "projects_category_approvers"
    __table_args__ = (CheckConstraint("category <> ''", name="names_a_category"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    category: Mapped[str]
    person_id: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))  # None: the project's approver
    named_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))


class Deputy(ProjectOwned, Dated, Base):
    """A member of the studio who may approve in place of another person, from one day to another, both included."""

    __tablename__ = "projects_deputies"
    __table_args__ = (
        CheckConstraint("until_on >= from_on", name="ends_after_it_began"),
        CheckConstraint("deputy_id <> person_id", name="two_people"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    deputy_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    from_on: Mapped[date]  # in the time zone of the studio
    until_on: Mapped[date]
    named_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    withdrawn_at: Mapped[datetime | None]
    person: Mapped[Person] = relationship(lazy="raise", foreign_keys=[person_id])
    deputy: Mapped[Person] = relationship(lazy="raise", foreign_keys=[deputy_id])


class Engagement(ProjectOwned, Dated, Base):
    """A designer's engagement on a project; while it lasts the designer sees spec, list and their own work."""

    __tablename__ = "projects_engagements"
    __table_args__ = (
        UniqueConstraint("project_id", "designer_id"),
        CheckConstraint("(nda_sha256 is null) = (nda_accepted_at is null)", name="nda_is_dated"),
    )

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    designer_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), index=True)
    kind: Mapped[EngagementKind]
    kind_since: Mapped[datetime] = mapped_column(default=clock.now)
    ended_at: Mapped[datetime | None]
    nda_sha256: Mapped[str | None]  # of the document that the designer accepted
    nda_accepted_at: Mapped[datetime | None]
    designer: Mapped[Person] = relationship(lazy="raise")


class ProjectInvitation(MailedLink, ProjectOwned, Dated, Base):
    """A mailed link that shows a designer the list at once, and makes an engagement when accepted."""

    __tablename__ = "projects_invitations"

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    email: Mapped[str]
    kind: Mapped[EngagementKind]
    note: Mapped[str] = mapped_column(default="")
    invited_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    expires_at: Mapped[datetime]
    accepted_at: Mapped[datetime | None]
    accepted_by: Mapped[UUID | None] = mapped_column(ForeignKey("accounts_people.id"))
    revoked_at: Mapped[datetime | None]
    project: Mapped[Project] = relationship(lazy="raise")
    inviter: Mapped[Person] = relationship(lazy="raise", foreign_keys=[invited_by])


class CreditName(StudioOwned, Base):
    """A person's name in the credits of a project, or their omission, as they said themselves."""

    __tablename__ = "projects_credit_names"

    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"), primary_key=True)
    person_id: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"), primary_key=True, index=True)
    name: Mapped[str]  # empty: the name of their account
    is_left_out: Mapped[bool] = mapped_column(default=False)
    changed_at: Mapped[datetime] = mapped_column(default=clock.now, onupdate=clock.now)


class CreditLine(ProjectOwned, Base):
    """A name that was added to the credits of a project by hand: of a performer, for instance."""

    __tablename__ = "projects_credit_lines"
    __table_args__ = (CheckConstraint("role <> '' and name <> ''", name="role_and_name"),)

    id: Mapped[UUID] = mapped_column(primary_key=True, default=new_id)
    role: Mapped[str]
    name: Mapped[str]
    added_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    added_at: Mapped[datetime] = mapped_column(default=clock.now)


class Budget(StudioOwned, Base):
    """The permitted cost of a project in one currency, as a producer set it; no designer sees it."""

    __tablename__ = "projects_budgets"
    __table_args__ = (CheckConstraint("amount_minor > 0", name="not_nothing"),)

    project_id: Mapped[UUID] = mapped_column(ForeignKey("projects_projects.id"), primary_key=True)
    currency: Mapped[str] = mapped_column(primary_key=True)
    amount_minor: Mapped[int] = mapped_column(BigInteger)
    set_by: Mapped[UUID] = mapped_column(ForeignKey("accounts_people.id"))
    set_at: Mapped[datetime] = mapped_column(default=clock.now)
