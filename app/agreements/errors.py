"""The refusals of this room, each named after the fact."""

from app.core.errors import Conflict, Forbidden, Invalid, NotFound


class ContractNotFound(NotFound):
    """No contract of that id within the caller's sight."""


class PlanLocked(Conflict):
    """Milestones and prices stand as they were sent or agreed; a draft's can be changed."""


class BadPlan(Invalid):
    """The plan cannot be kept; its problems say why, milestone by milestone."""


class BadSplit(Invalid):
    """A price cannot be split over two designers like this."""


class UnderContract(Conflict):
    """Another contract that runs covers the same cue."""


class NothingToSplit(Invalid):
    """A milestone has an amount and no cues to share it."""


class ContractVersionNotFound(NotFound):
    """The contract has no version of that number that the caller may see."""


class TemplateNotFound(NotFound):
    """The studio has no template of that id."""


class NotYourContract(Forbidden):
    """Only a party to the contract may do this: a producer of the studio, or its designer."""


class SamePersonOnBothSides(Forbidden):
    """One person cannot act for both parties of a contract."""


class AddressNotProven(Forbidden):
    """A person who accepts a contract must first have shown that they read their mail address."""


class NotASigner(Forbidden):
    """Others are named to sign for the studio, or a person is named who cannot."""


class NotYourTurn(Conflict):
    """Another person signs first."""


class TooManySigners(Invalid):
    """A studio names fewer people to sign than this."""


class SigningCodeNeeded(Forbidden):
    """A name counts as a signature only with the code that is mailed to the person's address."""


class WrongSigningCode(Forbidden):
    """The code is not the one that was mailed."""


class SigningCodeOver(Conflict):
    """The code was used, tried too often, or is too old; another one can be mailed."""


class NoSigningCode(Conflict):
    """The server sends no mail, so it asks for no code."""


class BadHead(Invalid):
    """A file is not a signed head of a record, or was altered since."""


class BadPdf(Invalid):
    """A file is too large or too slow to read as PDF."""


class WrongState(Conflict):
    """The contract is not in the state in which this can be done."""


class NoticeNeeded(Conflict):
    """An agreed contract that orders work ends by a notice, so that what is owed is settled."""


class BriefOpen(Conflict):
    """A needed answer of the brief is open, and no clause in force prints the open questions."""


class DraftChanged(Conflict):
    """The draft was changed by another person since it was read."""


class TextChanged(Conflict):
    """The text that was read is not the current one."""


class BadDrawing(Invalid):
    """The content sent as a drawn name is none, or is too large."""


class AlreadyAccepted(Conflict):
    """The party has accepted the text already."""


class NoContractNeeded(Conflict):
    """The studio's own people work without a contract."""


class TemplateNameTaken(Conflict):
    """The studio has a template of that name."""


class FrameworkNeeded(Invalid):
    """A statement of work names an agreed framework with the same designer, and nothing else does."""


class BadDraft(Invalid):
    """Clauses or terms cannot stand so; `errors` names the places."""


class AmountsNeeded(Invalid):
    """A draft changes its currency, and its amounts were not entered again in the new one; `errors` names them."""


class BadTemplate(Invalid):
    """The content sent is not a template; says place and reason."""


class TooLongToCompare(Invalid):
    """Two versions of a contract are longer than what is compared word by word."""


class BadRedlines(Invalid):
    """Proposed changes, or an answer to one, cannot stand so; `errors` names the places."""


class BadWordFile(Invalid):
    """A file is not a Word document, is damaged, or has more in it than is read."""


class OtherContractsFile(Invalid):
    """A Word document was made from another contract, or has no clause of this one."""


class RedlineNotFound(NotFound):
    """The contract has no redline of that number that waits for the next version."""


class RedlinesOpen(Conflict):
    """A redline has no answer, or the draft has not the words that were agreed."""
