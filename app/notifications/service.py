"""Writes emails with the facts of their events, and sends them."""

from collections.abc import Mapping, Sequence
from datetime import datetime, timedelta
from types import MappingProxyType
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor, MemberChange
from app.accounts.service import ensure_producer_of
from app.core import clock
from app.core.db import insert_if_absent, new_id
from app.core.events import publish
from app.notifications import queries
from app.notifications.audio_excerpts.rules import SpotLine
from app.notifications.errors import MailBusy, MailNotFound
from app.notifications.kinds import news_of
from app.notifications.models import Mail
from app.notifications.notices import service as notices
from app.notifications.preferences import service as preferences
from app.notifications.preferences.rules import Cadence
from app.notifications.rules import DigestPart, Fold
from app.projects.service import project_access

# Longer than the server is given to take a mail; a worker that died sending leaves it to the next after that.
CLAIMED_FOR = timedelta(seconds=60)
SENT_BY_JOB = timedelta(minutes=10)  # later than that a worker sends what is due, every five minutes
DIGEST_SUBJECTS = {Cadence.HOURLY: "Soundlist: news of the hour", Cadence.DAILY: "Soundlist: news of the day"}
UNSEALED = Mail.sealed_at.is_(None)  # the condition of their unique index


def write_mail(
    session: Session,
    *,
    event_id: str,
    studio_id: UUID | None,
    project_id: UUID | None = None,
    topic: str,
    recipient: str,
    subject: str,
    lines: Sequence[str],
    spots: Mapping[str, dict[str, Any]] = MappingProxyType({}),
    link: str | None = None,
    secret_of: str | None = None,
    secret_of_id: UUID | None = None,
    news: str | None = None,
    send_after: datetime | None = None,
    fold: Fold | None = None,
    part: DigestPart | None = None,
    line_project_ids: Sequence[str] = (),
) -> None:
    """Add to the recipient's open mail on the topic, or begin one and have it sent at once, or after a moment.

    By a `fold` the subject counts the lines; a `part` of a digest takes the further lines of its own topic, and
    `line_project_ids` are the projects of its lines.
    """
    now = clock.now()
    send_after = send_after or now
    mail_id = new_id()
    facts = {
        "id": mail_id,
        "studio_id": studio_id,
        "about_project_id": project_id,
        "topic": topic,
        "recipient": recipient,
        "subject": subject,
        "lines": list(lines),
        "line_project_ids": list(line_project_ids),
        "spots": dict(spots),
        "event_ids": [event_id],
        "folds": part.begun(0) if part else {},
        "link": link,
        "secret_of": secret_of,
        "secret_of_id": secret_of_id,
        "news": news,
        "created_at": now,
        "send_after": send_after,
    }
    # What another job has just begun is joined; a mail that is sealed between the two is followed by another.
    while (mail := queries.open_mail(session, topic, recipient)) is None:
        if insert_if_absent(session, Mail, facts, unique=("topic", "recipient"), where=UNSEALED):
            if send_after - now <= SENT_BY_JOB:
                delay_s = (send_after - now).total_seconds()
                publish(session, "mail.written", studio_id=studio_id, delay_s=delay_s, mail_id=mail_id)
            return
    if event_id in mail.event_ids:
        return
    if part is None or part.topic not in mail.folds:
        mail.folds = {**mail.folds, **(part.begun(len(mail.lines)) if part else {})}
        mail.lines = [*mail.lines, *lines]
        mail.line_project_ids = [*mail.line_project_ids, *line_project_ids]
    else:
        at = mail.folds[part.topic]["at"]
        mail.folds, text = part.joined(mail.folds)
        mail.lines = [*mail.lines[:at], text, *mail.lines[at + 1 :]]
    if fold is not None:
        mail.subject = fold.subject(len(mail.lines))
    mail.spots = {**mail.spots, **spots}
    mail.event_ids = [*mail.event_ids, event_id]


def write_news(
    session: Session,
    *,
    event_id: str,
    studio_id: UUID,
    project_id: UUID | None,
    topic: str,
    recipient: str,
    subject: str | Fold,
    lines: Sequence[str | SpotLine],
    base_url: str,
    path: str,
    delay_s: float,
) -> None:
    """Add a notice in the app, and mail the news as its reader wishes it: at once, hourly, daily or not at all.

    Nothing is written to who left the studio, or does not see the project, whatever still names them.
    By a subject that is a `Fold`, further news of the topic joins what the reader has not read.
    """
    person_id = queries.person_id_at(session, recipient)
    if person_id is not None and not queries.is_addressed(session, studio_id, person_id, project_id):
        return
    news = news_of(topic)
    of_spots = [line for line in lines if isinstance(line, SpotLine)]
    texts = [line.text if isinstance(line, SpotLine) else line for line in lines]
    about: dict[str, Any] = {"event_id": event_id, "studio_id": studio_id, "project_id": project_id, "topic": topic}
    if isinstance(subject, Fold):
        notices.fold(session, **about, recipient=recipient, subject=subject, lines=texts, path=path)
    else:
        path_of_notice = of_spots[0].spot.path if len(of_spots) == len(lines) == 1 else path
        text = "\n".join(texts)
        notices.add(session, **about, recipient=recipient, subject=subject, text=text, path=path_of_notice)
    mailed = [f"{line.text}\n{base_url}{line.spot.path}" if isinstance(line, SpotLine) else line for line in lines]
    spots = {f"{base_url}{line.spot.path}": line.spot.stored() for line in of_spots}
    link = f"{base_url}{path}"
    cadence, send_after = preferences.timing(session, recipient, news, timedelta(seconds=delay_s))
    if cadence is Cadence.NEVER:
        return
    fold = subject if isinstance(subject, Fold) else None
    heading = subject.subject(len(lines)) if isinstance(subject, Fold) else subject
    if cadence is Cadence.AT_ONCE:
        write_mail(
            session,
            event_id=event_id,
            studio_id=studio_id,
            project_id=project_id,
            topic=topic,
            recipient=recipient,
            subject=heading,
            lines=mailed,
            spots=spots,
            link=link,
            news=news,
            send_after=send_after,
            fold=fold,
        )
        return
    write_mail(
        session,
        event_id=f"{event_id}:{topic}",  # an event may be several pieces of news
        studio_id=studio_id,
        topic=f"{queries.DIGEST}:{cadence}:{studio_id}",
        recipient=recipient,
        subject=DIGEST_SUBJECTS[cadence],
        lines=["\n\n".join((heading, *mailed, link))],
        spots=spots,
        news=preferences.EVERYTHING,
        send_after=send_after,
        part=DigestPart(topic, fold, mailed, link) if fold else None,
        line_project_ids=[str(project_id or "")],
    )


def drop_unaddressed(session: Session, mail: Mail) -> bool:
    """Take out of a mail what is about projects that its reader may not see by now; delete it where nothing is left.

    Return whether it was deleted. A mail with a secret link is for whoever is invited, and stays.
    """
    person_id = queries.person_id_at(session, mail.recipient)
    if person_id is None or mail.studio_id is None or mail.secret_of is not None:
        return False
    if mail.about_project_id is not None:
        is_left = queries.is_addressed(session, mail.studio_id, person_id, mail.about_project_id)
    else:
        is_left = not mail.line_project_ids or _keep_addressed_lines(session, mail, mail.studio_id, person_id)
    if not is_left:
        session.delete(mail)
    return not is_left


def _keep_addressed_lines(session: Session, mail: Mail, studio_id: UUID, person_id: UUID) -> bool:
    is_open = {
        id_: queries.is_addressed(session, studio_id, person_id, UUID(id_) if id_ else None)
        for id_ in set(mail.line_project_ids)
    }
    kept = [(line, id_) for line, id_ in zip(mail.lines, mail.line_project_ids, strict=True) if is_open[id_]]
    mail.lines, mail.line_project_ids = [line for line, _ in kept], [id_ for _, id_ in kept]
    mail.spots = {url: spot for url, spot in mail.spots.items() if any(url in line for line in mail.lines)}
    return bool(kept)


def drop_news_of_member(session: Session, payload: Mapping[str, Any]) -> None:
    """Delete news of a studio for who left it, but of projects that engage them: a handler of `member.changed`."""
    change = MemberChange.of(payload)
    if not change.has_left:
        return
    queries.delete_notices_of_former_member(session, change.studio_id, change.person_id)
    if not queries.is_addressed(session, change.studio_id, change.person_id):
        queries.delete_unsent_news(session, change.studio_id, queries.address_of(session, change.person_id))


def outbox(session: Session, actor: Actor, studio_id: UUID) -> list[Mail]:
    """Return the mails that the studio's producer may see; mails about a person's account are left out."""
    ensure_producer_of(session, actor, studio_id)
    is_limited = studio_id in actor.limited_studio_ids  # a digest gathers news of several projects
    return list(queries.outbox(session, studio_id, with_digests=not is_limited))


def mailed_links(session: Session, actor: Actor, project_id: UUID) -> Sequence[Mail]:
    """Return the newest mail of each link by which a project invites; those of members are for producers only."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    return queries.link_mails(session, access.project, of_members=access.is_producer)


def send_again(session: Session, actor: Actor, mail_id: UUID) -> Mail:
    """Try a mail again that was not sent."""
    mail = session.get(Mail, mail_id)
    if mail is None or not queries.is_in_outbox(session, actor, mail):
        raise MailNotFound(f"no mail {mail_id}")
    if mail.sent_at is None:
        publish(session, "mail.written", studio_id=mail.studio_id, mail_id=mail.id)
    return mail


def claim(session: Session, mail_id: UUID) -> Mail | None:
    """Close a mail to further news and return it; None when it was sent, MailBusy while another worker sends it."""
    mail = queries.mail_locked(session, mail_id)
    if mail is None or mail.sent_at is not None:
        return None
    if mail.claimed_until is not None and mail.claimed_until > clock.now():
        raise MailBusy(f"mail {mail_id} is being sent")
    mail.sealed_at = mail.sealed_at or clock.now()
    mail.claimed_until = clock.now() + CLAIMED_FOR
    return mail
