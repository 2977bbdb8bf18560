"""Passkeys (WebAuthn): a key on a person's device signs in, in place of password and second factor."""

import json
from collections.abc import Sequence
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts import queries
from app.accounts.authentication import sha256_of
from app.accounts.errors import NotInDemo, PasskeyNotFound, TooManyPasskeys
from app.accounts.models import Passkey, Person
from app.accounts.passkeys import queries as passkey_queries
from app.accounts.passkeys.rules import (
    MALFORMED,
    MAX_PASSKEYS,
    challenge_in,
    new_challenge,
    refused,
    relying_party_of,
)
from app.accounts.rules import Actor
from app.accounts.second_factors import service as second_factors
from app.core import clock
from app.core.db import bypass_row_policies
from app.core.server_keys import derived
from app.settings import Settings

RELYING_PARTY_NAME = "Soundlist"
SIGN_IN = "sign in"


def begin_passkey(session: Session, actor: Actor, settings: Settings) -> dict[str, Any]:
    """Return the options with which a browser makes a passkey for the caller."""
    from webauthn import generate_registration_options, options_to_json
    from webauthn.helpers.structs import (
        AuthenticatorSelectionCriteria,
        PublicKeyCredentialDescriptor,
        ResidentKeyRequirement,
        UserVerificationRequirement,
    )

    person = session.get_one(Person, actor.person)
    if person.demo_part is not None:
        raise NotInDemo("the people of the demo have no passkeys")
    passkeys = passkey_queries.passkeys_of(session, person.id)
    _ensure_room(passkeys)
    options = generate_registration_options(
        rp_id=relying_party_of(settings.base_url)[0],
        rp_name=RELYING_PARTY_NAME,
        user_id=person.id.bytes,
        user_name=person.email,
        user_display_name=person.name,
        challenge=new_challenge(_key(settings), _registration_of(person.id), clock.now()),
        authenticator_selection=AuthenticatorSelectionCriteria(
            resident_key=ResidentKeyRequirement.REQUIRED, user_verification=UserVerificationRequirement.REQUIRED
        ),
        exclude_credentials=[PublicKeyCredentialDescriptor(id=passkey.credential_id) for passkey in passkeys],
    )
    document: dict[str, Any] = json.loads(options_to_json(options))
    return document


def add_passkey(
    session: Session,
    actor: Actor,
    settings: Settings,
    *,
    name: str,
    credential: dict[str, Any],
    kept_secret: str | None,
) -> tuple[Passkey, list[str]]:
    """Keep a passkey that a browser made; return it with recovery codes where it is the first second factor."""
    from webauthn import verify_registration_response
    from webauthn.helpers.exceptions import WebAuthnException

    session.get_one(Person, actor.person, with_for_update=True)  # of two at once, the second sees the first
    _ensure_room(passkey_queries.passkeys_of(session, actor.person))
    challenge, made_at_us = challenge_in(credential, _key(settings), _registration_of(actor.person), clock.now())
    host, origin = relying_party_of(settings.base_url)
    try:
        verified = verify_registration_response(
            credential=credential,
            expected_challenge=challenge,
            expected_rp_id=host,
            expected_origin=origin,
            require_user_verification=True,
        )
    except (WebAuthnException, *MALFORMED) as error:
        raise refused("the passkey was not accepted; it must verify you by PIN, fingerprint or face") from error
    with bypass_row_policies(session):  # it may be another person's
        if passkey_queries.passkey_by_credential(session, verified.credential_id) is not None:
            raise refused("this passkey belongs to an account already")
    codes = second_factors.codes_for_first_factor(session, actor.person)
    passkey = Passkey(
        person_id=actor.person,
        credential_id=verified.credential_id,
        public_key=verified.credential_public_key,
        sign_count=verified.sign_count,
        challenge_made_at_us=made_at_us,
        name=name,
    )
    session.add(passkey)
    session.flush()
    # They may have begun with a password alone.
    queries.end_sign_ins(session, actor.person, except_sha256=sha256_of(kept_secret) if kept_secret else None)
    change = f"The passkey “{name}” was added to your account."
    second_factors.publish_change(session, actor.person, change, "added a passkey")
    return passkey, codes


def passkeys_of(session: Session, actor: Actor) -> Sequence[Passkey]:
    """Return the caller's passkeys."""
    return passkey_queries.passkeys_of(session, actor.person)


def remove_passkey(session: Session, actor: Actor, passkey_id: UUID) -> None:
    """Remove one of the caller's passkeys."""
    for passkey in passkeys_of(session, actor):
        if passkey.id == passkey_id:
            session.delete(passkey)
            session.flush()
            second_factors.drop_unneeded_codes(session, actor.person)
            change = f"The passkey “{passkey.name}” was removed from your account."
            second_factors.publish_change(session, actor.person, change, "removed a passkey")
            return
    raise PasskeyNotFound(f"no passkey {passkey_id} of yours")


def sign_in_options(settings: Settings) -> dict[str, Any]:
    """Return the options with which a browser asks for any passkey of this server."""
    from webauthn import generate_authentication_options, options_to_json
    from webauthn.helpers.structs import UserVerificationRequirement

    options = generate_authentication_options(
        rp_id=relying_party_of(settings.base_url)[0],
        challenge=new_challenge(_key(settings), SIGN_IN, clock.now()),
        user_verification=UserVerificationRequirement.REQUIRED,
    )
    document: dict[str, Any] = json.loads(options_to_json(options))
    return document


def person_with_passkey(session: Session, settings: Settings, credential: dict[str, Any]) -> UUID:
    """Return the id of the person whose passkey answered, or raise PasskeyRefused; no answer counts twice."""
    from webauthn import base64url_to_bytes, verify_authentication_response
    from webauthn.helpers.exceptions import WebAuthnException

    challenge, made_at_us = challenge_in(credential, _key(settings), SIGN_IN, clock.now())
    host, origin = relying_party_of(settings.base_url)
    with bypass_row_policies(session):  # the passkey identifies the caller
        try:
            passkey = passkey_queries.passkey_by_credential(session, base64url_to_bytes(credential["id"]))
            if passkey is None:
                raise refused("no account here has this passkey")
            verified = verify_authentication_response(
                credential=credential,
                expected_challenge=challenge,
                expected_rp_id=host,
                expected_origin=origin,
                credential_public_key=passkey.public_key,
                credential_current_sign_count=passkey.sign_count,
                require_user_verification=True,
            )
        except (WebAuthnException, *MALFORMED) as error:
            raise refused("the answer of the passkey is wrong") from error
        if not passkey_queries.record_passkey_use(
            session, passkey.id, sign_count=verified.new_sign_count, challenge_made_at_us=made_at_us
        ):
            raise refused("this answer was used already")
        return passkey.person_id


def _ensure_room(passkeys: Sequence[Passkey]) -> None:
    if len(passkeys) >= MAX_PASSKEYS:
        raise TooManyPasskeys(
            f"you have {MAX_PASSKEYS} passkeys, as many as a person may have", fix="remove one that you do not use"
        )


def _registration_of(person_id: UUID) -> str:
    return f"passkey of {person_id}"


def _key(settings: Settings) -> bytes:
    return derived(settings.secret_key.get_secret_value(), "passkeys", 32)
