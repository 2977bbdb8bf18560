"""What the endpoints of project members take and return."""

from pydantic import Field

from app.accounts.rules import MembersSee
from app.accounts.schemas import PersonBrief
from app.core.web.http import Schema


class ProjectSight(Schema):
    """The projects of a studio that its members see."""

    members_see: MembersSee = Field(description="`own`: only the projects that they are in.")


class ProjectMemberRead(Schema):
    """A member of the studio who is in a project."""

    person: PersonBrief


class ProjectMembersRead(ProjectSight):
    """The members of a project."""

    members: list[ProjectMemberRead]
