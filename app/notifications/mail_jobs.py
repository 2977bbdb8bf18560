"""Mails leave the outbox: by a mail server, or as links for operators to copy."""

from uuid import UUID

import aiosmtplib

from app.core import clock, mail
from app.core.jobs.queue import Payload, job
from app.core.runtime import Runtime
from app.notifications import links, queries, service
from app.notifications.audio_excerpts import service as spots
from app.notifications.audio_excerpts.rules import html_of
from app.notifications.errors import MailBusy
from app.notifications.models import Mail
from app.notifications.preferences import service as preferences
from app.notifications.preferences.rules import ALWAYS_MAILED
from app.notifications.rules import text_of


@job("notifications.send_mail")
def send_mail(runtime: Runtime, payload: Payload) -> None:
    """Hand one mail to the SMTP server; without one it waits in the outbox, its link to be copied."""
    if runtime.settings.smtp_url:
        _send(runtime, UUID(payload["mail_id"]))
    else:
        _show_link(runtime, UUID(payload["mail_id"]))


def send_pending(runtime: Runtime) -> None:
    """Send the waiting mails, oldest first, now that a server is set or back; without one, show their links."""
    if not runtime.settings.smtp_url:
        with runtime.database.reading() as session:
            linkless = queries.ids_without_link(session)
        for mail_id in linkless:
            _show_link(runtime, mail_id)
        return
    with runtime.database.reading() as session:
        waiting = queries.overdue_ids(session, clock.now(), runtime.settings.digest_delay_s)
    for mail_id in waiting:
        try:
            _send(runtime, mail_id)
        except (MailBusy, aiosmtplib.SMTPResponseException):
            continue  # another worker sends it, or it was refused, which is noted on it: the next may pass
        except (aiosmtplib.SMTPException, OSError):
            return  # the server is away; the next round tries again


def _show_link(runtime: Runtime, mail_id: UUID) -> None:
    with runtime.database.writing() as session:
        waiting = queries.mail_locked(session, mail_id)
        if waiting is None or waiting.sent_at is not None or waiting.link is not None:
            return
        waiting.link = links.make(session, waiting, base_url=runtime.settings.base_url, is_sent_by_mail_only=False)


def _send(runtime: Runtime, mail_id: UUID) -> None:
    with runtime.database.writing() as session:
        claimed = service.claim(session, mail_id)
        if claimed is None:
            return
        if preferences.drop_unwanted(session, claimed) or service.drop_unaddressed(session, claimed):
            return
        # A link that was handed over since the server refused the mail goes on working.
        is_by_hand = claimed.secret_of is not None and claimed.failure is not None and claimed.link is not None
        if is_by_hand:
            link = claimed.link if links.still_opens(session, claimed) else None
        else:
            link = links.make(session, claimed, base_url=runtime.settings.base_url, is_sent_by_mail_only=True)
        if claimed.secret_of is not None and (link is None or not is_by_hand):
            claimed.link = None  # the link that the outbox showed is revoked
            if link is None:
                session.delete(claimed)  # it was used, revoked or grew old before a server took it
                return
        token = preferences.token_for(session, runtime.settings.secret_key.get_secret_value(), claimed)
        shown = spots.shown_spots(session, claimed)
    base_url = runtime.settings.base_url
    text = text_of(claimed.lines, link, f"{base_url}/mails/{token}" if token else None)
    message = mail.build_mail(
        sender=runtime.settings.mail_from,
        recipient=claimed.recipient,
        subject=claimed.subject,
        text=text,
        stop_url=f"{base_url}/v1/mail-choices/{token}/stop" if token and claimed.news not in ALWAYS_MAILED else None,
    )
    if pictures := spots.pictures_of(shown):
        mail.add_html(message, html_of(text, pictures), {picture.cid: picture.png for picture in pictures.values()})
    try:
        mail.send(runtime.settings.smtp_url, message)
    except (aiosmtplib.SMTPException, OSError) as error:
        with runtime.database.writing() as session:
            refused = session.get_one(Mail, mail_id)
            refused.failure, refused.claimed_until = f"{type(error).__name__}: {error}", None
        raise
    with runtime.database.writing() as session:
        sent = session.get_one(Mail, mail_id)
        sent.sent_at, sent.failure, sent.claimed_until, sent.link = clock.now(), None, None, None


@job("notifications.mail_link")
def mail_link(runtime: Runtime, payload: Payload) -> None:
    """Write the mail of a secret link: an invitation, a new password, an address to verify, a new account."""
    with runtime.database.writing() as session:
        links.write(session, payload, base_url=runtime.settings.base_url)
