"""Links of mails and calendars, a sign-in and a desk token, as part of one of everything."""

from datetime import timedelta
from typing import TYPE_CHECKING
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.authentication import new_secret, sha256_of
from app.accounts.desk_tokens import create_desk_token
from app.accounts.models import (
    EmailChange,
    EmailVerification,
    Passkey,
    PasswordReset,
    SignIn,
    SignInProvider,
    SignUp,
    StudioInvitation,
)
from app.accounts.rules import Actor, Role
from app.core import clock
from app.core.db import new_id
from app.money.models import CalendarLink
from app.notifications.preferences.rules import News
from app.notifications.preferences.service import link_token
from app.projects.models import ProjectInvitation
from app.projects.rules import EngagementKind

if TYPE_CHECKING:
    from tests.house.objects import House

TOMORROW = timedelta(days=1)


def add_links(session: Session, of: dict[str, UUID], house: "House", posting_secret: str) -> dict[str, UUID]:
    """Add what mails and calendars link to; note the secrets in the house's links, and return ids by path names."""
    house.links |= {"invitations": new_secret(), "studio-invitations": new_secret(), "password-resets": new_secret()}
    house.links["posting-links"] = posting_secret
    house.links |= {kind: new_secret() for kind in ("calendars", "sign-ups", "email-verifications", "email-changes")}
    secret_key = house.server.runtime.settings.secret_key.get_secret_value()
    house.links["mail-choices"] = link_token(secret_key, house.designer_id, News.TALK)
    expires_at = clock.now() + TOMORROW
    session.add(
        SignInProvider(
            studio_id=house.studio_id, issuer="https://id.example.test", client_id="soundlist",
            sealed_client_secret=b"",
            authorization_endpoint="https://id.example.test/authorize", token_endpoint="https://id.example.test/token",
            jwks_uri="https://id.example.test/keys", is_secret_in_body=False,
        )
    )  # fmt: skip
    session.add(
        CalendarLink(
            **of,
            person_id=house.designer_id,
            secret_sha256=sha256_of(house.links["calendars"]),
        )
    )
    invitation = ProjectInvitation(
        **of,
        email=f"{new_id()}@example.test",
        kind=EngagementKind.CONTRACT,
        secret_sha256=sha256_of(house.links["invitations"]),
        invited_by=house.producer_id,
        expires_at=expires_at,
    )
    studio_invitation = StudioInvitation(
        studio_id=house.studio_id,
        email=f"{new_id()}@example.test",
        roles=[Role.REVIEWER],
        secret_sha256=sha256_of(house.links["studio-invitations"]),
        invited_by=house.producer_id,
        expires_at=expires_at,
    )
    reset = PasswordReset(
        person_id=house.reviewer_id,
        secret_sha256=sha256_of(house.links["password-resets"]),
        expires_at=expires_at,
    )
    verification = EmailVerification(
        person_id=house.designer_id,
        secret_sha256=sha256_of(house.links["email-verifications"]),
        expires_at=expires_at,
    )
    of_change = {"person_id": house.designer_id, "new_email": f"{new_id()}@example.test", "expires_at": expires_at}
    old_end = EmailChange(**of_change, is_new_end=False, secret_sha256=sha256_of(house.links["email-changes"]))
    new_end = EmailChange(**of_change, is_new_end=True)
    sign_up = SignUp(
        email=f"{new_id()}@example.test", secret_sha256=sha256_of(house.links["sign-ups"]), expires_at=expires_at
    )
    signed_in = SignIn(person_id=house.designer_id, secret_sha256=sha256_of(new_secret()), expires_at=expires_at)
    session.add_all([invitation, studio_invitation, reset, verification, old_end, new_end, sign_up, signed_in])
    session.flush()
    desk_token, house.desk_secret = create_desk_token(session, Actor(person_id=house.designer_id), "Laptop")
    passkey = Passkey(
        person_id=house.designer_id,
        credential_id=new_id().bytes,
        public_key=b"key",
        sign_count=0,
        challenge_made_at_us=0,
        name="Phone",
    )
    session.add(passkey)
    session.flush()
    return {
        "passkey_id": passkey.id,
        "invitation_id": invitation.id,
        "studio_invitation_id": studio_invitation.id,
        "sign_in_id": signed_in.id,
        "desk_token_id": desk_token.id,
    }
