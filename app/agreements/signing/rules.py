"""A text's order of signers, and a signature's content, stated without a database."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from datetime import timedelta
from uuid import UUID

from app.agreements.errors import AlreadyAccepted, NotASigner, NotYourTurn, TooManySigners
from app.agreements.rules import Party

CONSENT = "I have read this text, I agree to be bound by it, and the name that I type is my signature."
CODE_DIGITS = 6
CODE_TRIES = 5
CODE_LIFETIME = timedelta(minutes=10)
MAX_SIGNERS = 2  # of a studio
AGENT_LENGTH = 300
BY_CODE, WITHOUT_CODE = "a code mailed to that address was typed", "none was asked for: this server sends no mail"


@dataclass(frozen=True)
class Signature:
    """A signature: its person and party."""

    party: Party
    person_id: UUID


@dataclass(frozen=True)
class SigningOrder:
    """The studio's signers by name, in order, and the party that signs first."""

    signers: Sequence[UUID] = ()  # none: any one producer of the studio
    first: Party | None = None  # None: in any order

    def has_signed(self, party: Party, given: Collection[Signature]) -> bool:
        """Whether all who sign for a party have done so."""
        people = {yes.person_id for yes in given if yes.party is party}
        return people >= set(self.signers) if party is Party.STUDIO and self.signers else bool(people)

    def parties_left(self, given: Collection[Signature]) -> list[Party]:
        """Return the parties that sign next."""
        left = [party for party in Party if not self.has_signed(party, given)]
        return [self.first] if self.first in left else left

    def next_signer(self, given: Collection[Signature]) -> UUID | None:
        """Return the studio's signer whose turn it is; None where any producer may sign, or all have."""
        signed = {yes.person_id for yes in given}
        return next((person_id for person_id in self.signers if person_id not in signed), None)

    def turn(self, given: Collection[Signature]) -> "Turn":
        """Return the turn to sign."""
        return Turn(self.parties_left(given), self.next_signer(given))

    def ensure_turn(self, party: Party, person_id: UUID, given: Collection[Signature]) -> None:
        """Raise AlreadyAccepted, NotASigner or NotYourTurn unless this person signs for this party now."""
        is_own = any(yes.person_id == person_id for yes in given)
        if is_own or self.has_signed(party, given):
            who = f"the {party} has" if self.has_signed(party, given) else "you have"
            raise AlreadyAccepted(f"{who} signed this text already", fix="wait until the others have signed it too")
        if party is Party.STUDIO and self.signers and person_id not in self.signers:
            raise NotASigner(
                "others are named to sign this text for the studio",
                fix="have one of them sign; the contract's page names them",
            )
        if party not in self.parties_left(given):
            raise NotYourTurn(f"the {self.first} signs this text first", fix="you are mailed once it is your turn")
        if party is Party.STUDIO and self.next_signer(given) not in (None, person_id):
            raise NotYourTurn("another signer of the studio signs first", fix="you are mailed once it is your turn")


@dataclass(frozen=True)
class Turn:
    """Whose turn it is to sign: the parties, and the studio's signer by name, None where any producer may."""

    parties: Sequence[Party]
    signer: UUID | None

    def is_of(self, party: Party, person_id: UUID) -> bool:
        """Whether this person signs now, for this party."""
        return party in self.parties and (party is Party.DESIGNER or self.signer in (None, person_id))


def ensure_signers_fit(person_ids: Sequence[UUID], producers: Collection[UUID]) -> None:
    """Raise TooManySigners, or NotASigner for a person who is not a producer of the studio, or is named twice."""
    if len(person_ids) > MAX_SIGNERS:
        raise TooManySigners(
            f"a studio has {MAX_SIGNERS} signers at most; these are {len(person_ids)}",
            fix=f"name {MAX_SIGNERS} or fewer",
        )
    if len(set(person_ids)) < len(person_ids):
        raise NotASigner("one person is named twice", fix="name two people, or one")
    if unknown := set(person_ids) - set(producers):
        raise NotASigner(
            f"{len(unknown)} of the signers cannot sign for the studio in this contract",
            fix="name producers of the studio who are not the contract's designer",
        )
