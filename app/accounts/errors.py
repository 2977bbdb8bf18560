"""Errors of this room, each named after the fact."""

from typing import ClassVar

from app.core.errors import Conflict, Forbidden, Invalid, NotFound, Refused


class NotSignedIn(Refused):
    """No credential came with the request, or it is no longer good."""

    status = 401


class WrongSignIn(Refused):
    """Address and password do not belong together; the answer does not reveal whether the address is known."""

    status = 401


class SecondFactorNeeded(Refused):
    """The password is right, and the account asks for a second factor."""

    status = 401


class TooManyAttempts(Refused):
    """The same was tried too often; `retry_after_s` says how long to wait."""

    status: ClassVar[int] = 429

    def __init__(self, retry_after_s: int) -> None:
        super().__init__(f"too many tries; wait {retry_after_s} s and try again")
        self.retry_after_s = retry_after_s


class OperatorNeeded(Forbidden):
    """Only an operator sees the whole server."""


class PersonNeeded(Forbidden):
    """Only a person can do this."""


class ProviderSignInRefused(Forbidden):
    """The sign-in by a provider is not of this browser, or the provider's answer does not let its person in."""


class ScopeMissing(Forbidden):
    """The build's token lacks the scope for this."""


class RecentSignInNeeded(Forbidden):
    """The caller signed in too long ago for an act that gives access to others or erases for good."""


class CsrfMismatch(Forbidden):
    """The request carries our cookie, but does not come from our page."""


class ProducerNeeded(Forbidden):
    """Only a producer of the studio may do this."""


class SignUpClosed(Forbidden):
    """The server takes new people by invitation only."""


class SetupCodeNeeded(Forbidden):
    """The first account of the server needs the set-up code, or the code is wrong."""


class SignInNeeded(Forbidden):
    """The link is for an address that has an account: its holder signs in or gives its password."""


class WrongPassword(Forbidden):
    """The present password that was given is not the account's."""


class SecondFactorRequired(Forbidden):
    """The studio asks for a second factor that the caller has not set up."""


class WrongSecondFactor(Forbidden):
    """The code is wrong, too old or was used before."""


class NotInDemo(Forbidden):
    """The people of the demo do not have this."""


class StudioNotFound(NotFound):
    """No studio of that id within the caller's sight."""


class ProviderNotFound(NotFound):
    """The studio has no sign-in provider."""


class DomainTaken(Conflict):
    """The domain is bound to another studio."""


class MemberNotFound(NotFound):
    """No such person in this studio."""


class StudioInvitationNotFound(NotFound):
    """No open invitation into a studio under that link or id."""


class ResetNotFound(NotFound):
    """The link for a new password is unknown, used or older than an hour."""


class VerificationNotFound(NotFound):
    """The link that verifies an address is unknown, used, too old or for another account."""


class EmailChangeNotFound(NotFound):
    """The link that confirms a change of address is unknown, stopped, too old or for another account."""


class SignUpNotFound(NotFound):
    """The link that opens an account is unknown, used or too old."""


class OperatorNotFound(NotFound):
    """No account, or no operator, of that address."""


class DeskTokenNotFound(NotFound):
    """No such desk token of the caller."""


class TooManyStudios(Conflict):
    """The account has opened as many studios as one may on this server."""


class PasskeyNotFound(NotFound):
    """No such passkey of the caller."""


class TooManyPasskeys(Conflict):
    """The caller has as many passkeys as a person may have."""


class TooManyDeskTokens(Conflict):
    """The caller has as many desk tokens as a person may have."""


class SignInNotFound(NotFound):
    """No such sign-in of the caller."""


class DemoUnavailable(NotFound):
    """There is no demo here, or not by this way."""


class AddressTaken(Conflict):
    """The address has an account already."""


class SameAddress(Conflict):
    """The account has this address already."""


class AlreadyVerified(Conflict):
    """The address is verified already."""


class VerificationNeeded(Conflict):
    """The server opens accounts by a link that it mails."""


class NoMailServer(Conflict):
    """The server cannot send mail."""


class NoSecondFactor(Conflict):
    """The account has no second factor of that kind."""


class SecondFactorExists(Conflict):
    """The account has a second factor of that kind."""


class AddressNotVerified(Conflict):
    """The account's address is not verified."""


class AlreadyMember(Conflict):
    """The person is in the studio already."""


class LastProducer(Conflict):
    """A studio always has a producer."""


class HandOverNeeded(Conflict):
    """A member cannot leave, or lose a role, before another person takes over what `errors` lists."""


class CannotTakeOver(Invalid):
    """A person who takes over is no audio lead and no producer of the studio."""


class TimeZoneUnknown(Invalid):
    """No time zone of the IANA list has that name."""


class DayNamedTwice(Invalid):
    """A calendar names a day twice."""


class BadInvoiceDetails(Invalid):
    """A field of invoice details is filled in with what it cannot be."""


class BadAddress(Invalid):
    """The given text is not an email address."""


class NameNeeded(Invalid):
    """A new account needs a name."""


class PasskeyRefused(Invalid):
    """The browser's answer is not the right one of a passkey."""


class ProviderRefused(Invalid):
    """The address of a sign-in provider is wrong, or what it answers is not what OpenID Connect wants."""


class PasswordTooWeak(Invalid):
    """The password is missing, too short, too long or too easily guessed."""


class QuotaReached(Conflict):
    """The studio has as many of this kind as the operator allows."""


class StorageQuotaReached(Refused):
    """The studio keeps as many bytes as the operator allows."""

    status = 507


class PictureRefused(Invalid):
    """The content sent is not a picture that can be shown beside a name."""


class PictureNotFound(NotFound):
    """The person has no such picture, or the caller does not see who they are."""
