"""Errors of this room, each named after the fact."""

from app.core.errors import Conflict, Invalid, NotFound


class BriefVersionNotFound(NotFound):
    """The project has no brief version of that number."""


class FollowUpNotFound(NotFound):
    """No follow-up of that id within the caller's sight."""


class DecisionNotFound(NotFound):
    """No decision of that id within the caller's sight."""


class DecisionSigned(Conflict):
    """A contract was signed since the decision; what changes it now is another decision, or a change order."""


class AnswerChanged(Conflict):
    """Another person changed an answer since the brief was read; `errors` names each."""


class NothingToPublish(Conflict):
    """The answers are those of the newest version."""


class FollowUpAnswered(Conflict):
    """The follow-up has its answer."""


class AnswerInvalid(Invalid):
    """An answer does not fit its question; `errors` names each."""


class QuestionUnknown(Invalid):
    """The brief has no question of that name."""


class NothingProposed(Conflict):
    """The answers ask for no change of the delivery spec."""
