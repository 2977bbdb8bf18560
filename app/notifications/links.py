"""Emails with a secret link: their kinds, texts and links.

A secret is made at the last moment. With a mail server it goes into the mail that is handed over, and only its hash
is kept: no outbox, job or backup holds it, so the link's user has read that mail. Without one it is in the
outbox for the producer to hand over, and using it verifies no address.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts import addresses
from app.accounts.models import EmailChange, EmailVerification, MailedLink, PasswordReset, SignUp, StudioInvitation
from app.accounts.rules import Actor
from app.agreements.models import SigningCode
from app.agreements.signing import codes as signing_codes
from app.core import clock
from app.core.jobs.queue import Payload
from app.hiring.models import Candidate
from app.notifications import queries, service
from app.notifications.errors import MailNotFailed, MailNotFound
from app.notifications.models import Mail
from app.projects.models import ProjectInvitation


@dataclass(frozen=True)
class LinkMail:
    """The text of an event's mail, and the purpose of its link."""

    subject: str
    line: str
    table: Any
    page: str


KINDS: Mapping[str, LinkMail] = {
    "designer.invited": LinkMail(
        "{from_name} invites you to make sounds for {subject_name}",
        "{from_name} invites you to make sounds for {subject_name}. The link shows the sound list right away; "
        "you need an account only to upload.",
        ProjectInvitation,
        "invitation",
    ),
    "posting.shared": LinkMail(
        "{from_name} asks you for a bid: {subject_name}",
        "{from_name} asks you for a bid on {subject_name}. The link shows what is asked for and by when; "
        "you need an account only to bid.",
        Candidate,
        "posting",
    ),
    "member.invited": LinkMail(
        "{from_name} invites you to {subject_name}",
        "{from_name} invites you to join {subject_name} on Soundlist.",
        StudioInvitation,
        "join",
    ),
    "password.reset_asked": LinkMail(
        "A new password for Soundlist",
        "Someone asked for a new password for this account. The link works once, within an hour. "
        "If it was not you, ignore this email: nothing has changed.",
        PasswordReset,
        "new-password",
    ),
    "address.verification_asked": LinkMail(
        "Verify your email for Soundlist",
        "The link verifies this email for your account. It works once, within a day. "
        "If you have no account, ignore this email: the link does nothing for anyone else.",
        EmailVerification,
        "verify-address",
    ),
    "old_address.asked": LinkMail(
        "Change the email of your account on Soundlist",
        "Someone who is signed in to your account asked to change its email to {subject_name}. Nothing has changed. "
        "The link shows the change, to confirm it or to stop it; the new address has to confirm it too. It works "
        "within a day. If it was not you, stop it and set a new password.",
        EmailChange,
        "change-email",
    ),
    "new_address.asked": LinkMail(
        "Confirm your new email for Soundlist",
        "The holder of an account asked to use this email for it. The link confirms it; it works within a day. "
        "If you have no account, stop the change there or ignore this email: nothing has changed.",
        EmailChange,
        "change-email",
    ),
    "sign_up.asked": LinkMail(
        "Your account on Soundlist",
        "Someone asked for an account with this email. The link creates it. It works once, within a day. "
        "If it was not you, ignore this email: nothing has changed.",
        SignUp,
        "sign-up",
    ),
    "signing_code.asked": LinkMail(
        "Your code to sign {subject_name}",
        "Someone who is signed in as you is about to sign {subject_name}. Type this code there to sign. It works once, "
        "within ten minutes. If it was not you, keep the code to yourself and change your password; nothing is signed.",
        SigningCode,
        "",
    ),
}
KNOWN_ADDRESS = (
    "Your account on Soundlist",
    "Someone asked for an account with this email, which already has one. Sign in, or ask for a new password there. "
    "If it was not you, ignore this email: nothing has changed.",
)


def write(session: Session, payload: Payload, *, base_url: str) -> None:
    """Write the mail of an event, once; its link is made later."""
    event, event_id = payload["event"], payload["event_id"]
    topic = f"link:{event_id}"
    if queries.has_mail(session, topic):
        return
    kind = KINDS[event]
    subject, line, link_id = kind.subject, kind.line, payload.get("link_id")
    link: str | None = None
    if event == "password.reset_asked":
        if (link_id := addresses.begin_reset(session, payload["recipient"])) is None:
            return
    elif event == "sign_up.asked" and (link_id := addresses.begin_sign_up(session, payload["recipient"])) is None:
        (subject, line), link = KNOWN_ADDRESS, f"{base_url}/sign-in"
    names = {"from_name": payload.get("from_name") or "", "subject_name": payload.get("subject_name") or ""}
    opened = session.get(kind.table, UUID(str(link_id))) if link_id else None
    note = str(payload.get("note") or "")
    service.write_mail(
        session,
        event_id=event_id,
        studio_id=UUID(payload["studio_id"]) if payload.get("studio_id") else None,
        project_id=getattr(opened, "project_id", None),
        topic=topic,
        recipient=payload["recipient"],
        subject=subject.format(**names),
        lines=[line.format(**names) + (f"\n\n{note}" if note else "")],
        link=link,
        secret_of=event if link_id else None,
        secret_of_id=UUID(str(link_id)) if link_id else None,
    )


def make(session: Session, mail: Mail, *, base_url: str, is_sent_by_mail_only: bool) -> str | None:
    """Return a mail's link, or its code: a new one where it is secret, so that every earlier link is revoked.

    None where it opens nothing any more.
    """
    if mail.secret_of is None or mail.secret_of_id is None:
        return mail.link
    kind = KINDS[mail.secret_of]
    opened: MailedLink | SigningCode | None = session.get(kind.table, mail.secret_of_id, with_for_update=True)
    if opened is None or is_over(opened):
        return None
    if isinstance(opened, SigningCode):
        return signing_codes.renew(opened) if is_sent_by_mail_only else None  # in no outbox, only in the mail
    return f"{base_url}/{kind.page}/{addresses.renew_secret(opened, is_sent_by_mail_only=is_sent_by_mail_only)}"


def link_by_hand(session: Session, actor: Actor, mail_id: UUID, *, base_url: str) -> Mail:
    """Show the link of a mail that the server refused, to be handed over; the mail is sent with the same one later.

    Raises MailNotFailed where there is nothing to hand over. The link proves no address.
    """
    mail = queries.mail_locked(session, mail_id)
    if mail is None or not queries.is_in_outbox(session, actor, mail):
        raise MailNotFound(f"no mail {mail_id}")
    is_sending = mail.claimed_until is not None and mail.claimed_until > clock.now()
    if mail.sent_at is not None or mail.failure is None or mail.secret_of is None or is_sending:
        raise MailNotFailed("this mail was sent, or is on its way", fix="read how it stands, and wait a moment")
    mail.link = mail.link or make(session, mail, base_url=base_url, is_sent_by_mail_only=False)
    if mail.link is None:
        raise MailNotFailed("its link was used or withdrawn, or is too old", fix="invite the address again")
    session.flush()
    return mail


def still_opens(session: Session, mail: Mail) -> bool:
    """Whether the secret link of a mail has something left to do."""
    opened = session.get(KINDS[mail.secret_of].table, mail.secret_of_id) if mail.secret_of else None
    return opened is not None and not is_over(opened)


def is_over(opened: Any) -> bool:
    """Whether a link has nothing left to do: used, accepted, revoked or too old."""
    ended = (getattr(opened, name, None) for name in ("used_at", "accepted_at", "revoked_at"))
    return any(ended) or opened.expires_at <= clock.now()
