"""Errors of this room, each named after the fact."""

from app.core.errors import Conflict, Forbidden, Invalid, NotFound


class ProjectNotFound(NotFound):
    """No project of that id within the caller's sight."""


class SpecVersionNotFound(NotFound):
    """The project has no spec of that version."""


class LiaisonNotFound(NotFound):
    """No such person among those who could be, or are, liaisons of the project."""


class EngagementNotFound(NotFound):
    """No such engagement on the project."""


class InvitationNotFound(NotFound):
    """No good invitation under that link or id: unknown, withdrawn or too old."""


class TokenNotFound(NotFound):
    """No such token of the project."""


class TeamNeeded(Forbidden):
    """Only the game team may do this."""


class ProducerNeeded(Forbidden):
    """Only a producer of the studio may do this."""


class ApproverNeeded(Forbidden):
    """Only the project's approver may do this."""


class DesignerNeeded(Forbidden):
    """Only a designer engaged on the project may do this."""


class NdaNeeded(Forbidden):
    """The project shows brief, list and spec to designers who accepted its non-disclosure agreement."""


class LiaisonIsApprover(Conflict):
    """The liaison is the approver; another approver must be named first."""


class ProjectMemberNotFound(NotFound):
    """No such person in the project, or in its studio."""


class MemberNeeded(Conflict):
    """The project needs this person: an approver, a deputy, an audio lead, or its only producer."""


class SpecChanged(Conflict):
    """The spec was changed by another person since it was read."""


class AlreadyEngaged(Conflict):
    """The designer is engaged on the project already."""


class DeputyNotFound(NotFound):
    """No such deputy in the project."""


class CannotApprove(Invalid):
    """Approvers and deputies are liaisons of the project or producers of the studio."""


class BadDeputy(Invalid):
    """The deputy is the person themselves, or the days end before they begin, or are over."""


class BadSpec(Invalid):
    """The text is not a delivery spec; `errors` names the places."""


class CreditLineNotFound(NotFound):
    """No name of that id in the credits within the caller's sight."""


class TooManyCredits(Conflict):
    """The project's credits have as many names as one list holds."""
