"""Codes that are mailed to people who sign: made when the mail is sent, kept as a hash, tried a few times."""

import secrets
from dataclasses import dataclass
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.passwords import hash_of, matches
from app.accounts.rules import Actor, SecondFactorUse
from app.accounts.second_factors.requirements import ensure_second_factor_for
from app.agreements import queries
from app.agreements.access import party_of, visible_contract
from app.agreements.errors import NoSigningCode, NotYourContract, SigningCodeNeeded, SigningCodeOver, WrongSigningCode
from app.agreements.models import SigningCode
from app.agreements.rules import ensure_address_proven
from app.agreements.signing.rules import CODE_DIGITS, CODE_LIFETIME, CODE_TRIES
from app.core import clock
from app.core.db import Database
from app.core.errors import Refused
from app.core.events import publish
from app.core.plural import counted

ANOTHER = "ask for another code"


@dataclass(frozen=True)
class CodeCheck:
    """The code that matched, or why none did."""

    code_id: UUID | None = None
    refusal: Refused | None = None


def request_code(
    session: Session, actor: Actor, contract_id: UUID, text_sha256: str, *, is_mail_on: bool
) -> tuple[SigningCode, str]:
    """Have a code for one text mailed to the caller, in place of earlier ones; return it with their address."""
    contract = visible_contract(session, actor, contract_id)
    if party_of(actor, contract) is None:
        raise NotYourContract("only a producer of the studio and the contract's designer sign it")
    ensure_second_factor_for(session, actor, contract.studio_id, SecondFactorUse.SIGNING)
    if not is_mail_on:
        raise NoSigningCode("this server sends no mail, so a signature needs no code", fix="sign without one")
    person = session.get_one(Person, actor.person)
    ensure_address_proven(person.email_proof, person.email)
    queries.drop_signing_codes(session, contract.id, person.id)
    code = SigningCode(
        studio_id=contract.studio_id,
        project_id=contract.project_id,
        contract_id=contract.id,
        person_id=person.id,
        text_sha256=text_sha256,
        expires_at=clock.now() + CODE_LIFETIME,
    )
    session.add(code)
    session.flush()
    publish(
        session,
        "signing_code.asked",
        studio_id=None,  # a mail of the person's own, which no outbox shows to the studio
        recipient=person.email,
        link_id=code.id,
        subject_name=contract.title,
    )
    return code, person.email


def renew(code: SigningCode) -> str:
    """Give a code its digits as its mail is sent, and return them."""
    digits = f"{secrets.randbelow(10**CODE_DIGITS):0{CODE_DIGITS}}"
    code.code_hash, code.tries, code.expires_at = hash_of(digits), 0, clock.now() + CODE_LIFETIME
    return digits


def check(database: Database, actor: Actor, contract_id: UUID, text_sha256: str, typed: str | None) -> CodeCheck:
    """Try the typed code, in a transaction of its own: a wrong try counts although the request is refused."""
    with database.writing(actor.reach) as session:
        code = queries.signing_code_locked(session, contract_id, actor.person, text_sha256)
        if not typed:
            needed = "a code is mailed to you, and your name counts with it; nothing was signed"
            return CodeCheck(refusal=SigningCodeNeeded(needed, fix="ask for the code, then type it"))
        if code is None or code.used_at is not None or code.expires_at <= clock.now():
            return CodeCheck(refusal=SigningCodeOver("this code is no longer valid; nothing was signed", fix=ANOTHER))
        if code.tries >= CODE_TRIES:
            message = f"a code can be tried {CODE_TRIES} times; nothing was signed"
            return CodeCheck(refusal=SigningCodeOver(message, fix=ANOTHER))
        code.tries += 1
        if matches("".join(typed.split()), code.code_hash):
            return CodeCheck(code_id=code.id)
        left = CODE_TRIES - code.tries
    again = f"can be tried {counted(left, 'more time')}" if left else "cannot be tried again"
    message = f"this is not the code that was mailed; it {again}"
    return CodeCheck(refusal=WrongSigningCode(message, fix="type the code of the newest mail" if left else ANOTHER))


def use(session: Session, check: CodeCheck) -> None:
    """Use a code up, once; raise why there is none."""
    if check.refusal is not None:
        raise check.refusal
    code = session.get(SigningCode, check.code_id, with_for_update=True)
    if code is None or code.used_at is not None:
        raise SigningCodeOver("this code is no longer valid; nothing was signed", fix=ANOTHER)
    code.used_at = clock.now()
    session.flush()
