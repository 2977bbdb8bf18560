"""Emails, and the facts in them."""

from collections.abc import Collection, Sequence
from datetime import date, datetime, timedelta
from uuid import UUID

from sqlalchemy import BindParameter, ColumnElement, Uuid, and_, delete, exists, func, literal, not_, or_, select
from sqlalchemy.orm import InstrumentedAttribute, Session

from app.accounts.models import Membership, Person, StudioInvitation
from app.accounts.rules import Actor, Role
from app.agreements.models import Contract, Milestone
from app.core import clock
from app.core.db import bypass_row_policies
from app.core.in_array import in_array
from app.deliveries.models import Take
from app.hiring.models import Candidate
from app.notifications.models import Mail, MailPreferences, Notice
from app.notifications.rules import SECURITY_TOPICS
from app.projects.approval.service import approval_rights
from app.projects.models import Engagement, Project, ProjectInvitation
from app.projects.queries import liaisons_of
from app.projects.visibility import engaged_with_nda_accepted, is_closed_to
from app.renders.models import Picture
from app.reviews.models import ChangeRequest, Comment
from app.sound_lists.models import Cue

OUTBOX_ROWS = 200
LINK_ROWS = 500
DIGEST = "digest"  # how the topic of a mail begins that gathers news of several projects


def open_mail(session: Session, topic: str, recipient: str) -> Mail | None:
    """Return the unsent digest of this topic, locked until this transaction ends."""
    return session.scalar(
        select(Mail).where(Mail.topic == topic, Mail.recipient == recipient, Mail.sealed_at.is_(None)).with_for_update()
    )


def has_mail(session: Session, topic: str) -> bool:
    """Whether a mail on the topic was written, sent or not."""
    return session.scalar(select(Mail.id).where(Mail.topic == topic).limit(1)) is not None


def pending_for(session: Session, recipient: str | None) -> Sequence[Mail]:
    """Return the mails that were not sent, to one address or to all, the oldest first."""
    waiting = select(Mail).where(Mail.sent_at.is_(None)).order_by(Mail.id)
    return session.scalars(waiting.where(Mail.recipient == recipient) if recipient else waiting).all()


def ids_without_link(session: Session) -> Sequence[UUID]:
    """Return the mails that wait without the secret link that they are written for, the oldest first."""
    return session.scalars(
        select(Mail.id)
        .where(Mail.sent_at.is_(None), Mail.link.is_(None), Mail.secret_of_id.is_not(None))
        .order_by(Mail.id)
    ).all()


def mail_locked(session: Session, mail_id: UUID) -> Mail | None:
    """Return a mail, locked until this transaction ends."""
    return session.get(Mail, mail_id, with_for_update=True)


def outbox(session: Session, studio_id: UUID, *, with_digests: bool) -> Sequence[Mail]:
    """Return a studio's mails but those about projects that the caller does not see: what waits first, then by age."""
    of_studio = [Mail.studio_id == studio_id]
    of_studio.append(or_(Mail.about_project_id.is_(None), Mail.about_project_id.in_(select(Project.id))))
    if not with_digests:
        of_studio.append(Mail.topic.not_like(f"{DIGEST}:%"))
    return session.scalars(
        select(Mail).where(*of_studio).order_by(Mail.sent_at.is_not(None), Mail.id.desc()).limit(OUTBOX_ROWS)
    ).all()


def is_in_outbox(session: Session, actor: Actor, mail: Mail) -> bool:
    """Whether a caller runs the studio that a mail is sent for, and sees the project that it is about."""
    if mail.studio_id is None or Role.PRODUCER not in actor.roles_in(mail.studio_id):
        return False
    if mail.studio_id in actor.limited_studio_ids and mail.topic.startswith(f"{DIGEST}:"):
        return False
    return mail.about_project_id is None or session.get(Project, mail.about_project_id) is not None


def link_mails(session: Session, project: Project, *, of_members: bool) -> Sequence[Mail]:
    """Return the newest mail of each secret link that a project invites by, and of the studio's where asked for."""
    invited = [
        select(Candidate.id).where(Candidate.project_id == project.id),
        select(ProjectInvitation.id).where(ProjectInvitation.project_id == project.id),
    ]
    if of_members:
        invited.append(select(StudioInvitation.id).where(StudioInvitation.studio_id == project.studio_id))
    mails = session.scalars(
        select(Mail)
        .where(Mail.studio_id == project.studio_id, or_(*(Mail.secret_of_id.in_(ids) for ids in invited)))
        .order_by(Mail.id.desc())
        .limit(LINK_ROWS)
    )
    newest: dict[UUID | None, Mail] = {}
    for mail in mails:
        newest.setdefault(mail.secret_of_id, mail)
    return list(newest.values())


def unsent_mails(session: Session) -> tuple[int, int, datetime | None]:
    """Return the numbers of mails that wait and that a mail server refused, and the due time of the oldest."""
    unsent = select(func.count(), func.count(Mail.failure), func.min(Mail.send_after)).where(Mail.sent_at.is_(None))
    count, failed, due_at = session.execute(unsent).one()
    return count - failed, failed, due_at


def overdue_ids(session: Session, at: datetime, digest_delay_s: float) -> Sequence[UUID]:
    """Return the mails that no job will send any more, oldest first: sealed, or past the time of their job."""
    due_before = at - timedelta(seconds=digest_delay_s)
    return session.scalars(
        select(Mail.id)
        .where(
            Mail.sent_at.is_(None),
            or_(Mail.sealed_at.is_not(None), Mail.send_after < due_before),
            or_(Mail.claimed_until.is_(None), Mail.claimed_until < at),
        )
        .order_by(Mail.id)
    ).all()


def changes_of(session: Session, feedback_id: UUID) -> Sequence[tuple[ChangeRequest, Take, Cue]]:
    """Return the changes sent together, with the takes and cues they are about."""
    return session.execute(
        select(ChangeRequest, Take, Cue)
        .join(Take, Take.id == ChangeRequest.take_id)
        .join(Cue, Cue.id == ChangeRequest.cue_id)
        .where(ChangeRequest.feedback_id == feedback_id)
        .order_by(Cue.number, Take.variation)
    ).all()


def preferences_of(session: Session, person_id: UUID) -> MailPreferences | None:
    """Return the saved mail preferences of a person."""
    return session.get(MailPreferences, person_id)


def person_id_at(session: Session, address: str) -> UUID | None:
    """Return the person of an address."""
    return session.scalar(select(Person.id).where(Person.email == address))


def address_of(session: Session, person_id: UUID) -> str:
    """Return the mail address of a person."""
    return session.scalars(select(Person.email).where(Person.id == person_id)).one()


def has_part(studio_id: InstrumentedAttribute[UUID] | BindParameter[UUID], person_id: UUID) -> ColumnElement[bool]:
    """Whether a person is a member of a studio, was ever engaged by it, or may bid on one of its postings."""
    return or_(
        exists().where(Membership.studio_id == studio_id, Membership.person_id == person_id),
        exists().where(Engagement.studio_id == studio_id, Engagement.designer_id == person_id),
        exists().where(
            Candidate.studio_id == studio_id, Candidate.person_id == person_id, Candidate.revoked_at.is_(None)
        ),
    )


def is_addressed(session: Session, studio_id: UUID, person_id: UUID, project_id: UUID | None = None) -> bool:
    """Whether news of a studio, or of one of its projects, may go to a person."""
    is_part = has_part(literal(studio_id, Uuid()), person_id)
    if project_id is not None:
        is_part = and_(is_part, not_(is_closed_to(person_id, studio_id=studio_id, project_id=project_id)))
    with bypass_row_policies(session):  # nobody sees all that others have to do with a studio
        return bool(session.scalar(select(is_part)))


def _shown(person_id: UUID) -> ColumnElement[bool]:
    """Admit a person's notices of studios and projects that still have to do with them."""
    closed = is_closed_to(person_id, studio_id=Notice.studio_id, project_id=Notice.project_id)
    of_them = and_(Notice.person_id == person_id, has_part(Notice.studio_id, person_id))
    return and_(of_them, or_(Notice.project_id.is_(None), not_(closed)))


def works_on(session: Session, project: Project, person_id: UUID) -> bool:
    """Whether a person is a member of a project's studio, or engaged on it and not ended."""
    member = exists().where(Membership.studio_id == project.studio_id, Membership.person_id == person_id)
    engaged = exists().where(
        Engagement.project_id == project.id, Engagement.designer_id == person_id, Engagement.ended_at.is_(None)
    )
    return bool(session.scalar(select(or_(member, engaged))))


def delete_notices_of_former_member(session: Session, studio_id: UUID, person_id: UUID) -> None:
    """Delete a person's notices of a studio, but of the projects that engage them."""
    engaged = select(Engagement.project_id).where(Engagement.designer_id == person_id, Engagement.ended_at.is_(None))
    of_person = Notice.studio_id == studio_id, Notice.person_id == person_id
    with bypass_row_policies(session):  # a notice is its reader's own
        session.execute(
            delete(Notice).where(*of_person, or_(Notice.project_id.is_(None), Notice.project_id.not_in(engaged)))
        )


def delete_unsent_news(session: Session, studio_id: UUID, address: str) -> None:
    """Delete the news of a studio for an address that was not sent; what is about the account itself goes out."""
    session.execute(
        delete(Mail).where(
            Mail.studio_id == studio_id,
            Mail.recipient == address,
            or_(Mail.news.is_not(None), *(Mail.topic.startswith(f"{kind}:") for kind in SECURITY_TOPICS)),
            Mail.sent_at.is_(None),
            or_(Mail.claimed_until.is_(None), Mail.claimed_until < clock.now()),
        )
    )


def designer_addresses(session: Session, project_id: UUID) -> Sequence[str]:
    """Return the addresses of the designers engaged on a project who may see its list."""
    return session.scalars(
        select(Person.email)
        .join(Engagement, Engagement.designer_id == Person.id)
        .join(Project, Project.id == Engagement.project_id)
        .where(Engagement.project_id == project_id, engaged_with_nda_accepted())
    ).all()


def approver_addresses(session: Session, project: Project, category: str = "") -> list[str]:
    """Return the addresses of those who may approve in a category today: its approver, then their deputies."""
    people = approval_rights(session, project).people_for(category)
    addresses = dict(session.execute(select(Person.id, Person.email).where(Person.id.in_(people))).all())
    return [addresses[person_id] for person_id in people]


def spokesperson_addresses(session: Session, project: Project) -> set[str]:
    """Return the addresses of approver, deputies and liaisons: those who answer for the team."""
    liaisons = liaisons_of(session, [project.id])
    return {*approver_addresses(session, project), *(liaison.person.email for liaison in liaisons)}


def producer_addresses(session: Session, studio_id: UUID, project_id: UUID | None = None) -> set[str]:
    """Return the addresses of the studio's producers; of a project, those of who sees it."""
    return _addresses_with(session, studio_id, Role.PRODUCER, project_id)


def implementer_addresses(session: Session, project: Project) -> set[str]:
    """Return the addresses of the studio's implementers who see a project; of its producers where there are none."""
    implementers = _addresses_with(session, project.studio_id, Role.IMPLEMENTER, project.id)
    return implementers or producer_addresses(session, project.studio_id, project.id)


def _addresses_with(session: Session, studio_id: UUID, role: Role, project_id: UUID | None) -> set[str]:
    people = (
        select(Person.email, Membership.roles)
        .join(Membership, Membership.person_id == Person.id)
        .where(Membership.studio_id == studio_id)
    )
    if project_id is not None:
        people = people.where(not_(is_closed_to(Person.id, studio_id=studio_id, project_id=project_id)))
    rows = session.execute(people)
    return {email for email, roles in rows if role in roles}


def notices_of(session: Session, person_id: UUID, *, before: UUID | None, limit: int) -> Sequence[Notice]:
    """Return a person's notices, newest first."""
    query = select(Notice).where(_shown(person_id))
    if before is not None:
        query = query.where(Notice.id < before)
    with bypass_row_policies(session):  # who only bids does not see that they may
        return session.scalars(query.order_by(Notice.id.desc()).limit(limit)).all()


def open_notice(session: Session, person_id: UUID, topic: str) -> Notice | None:
    """Return the notice that takes further events of a topic, locked until this transaction ends."""
    query = select(Notice).where(Notice.person_id == person_id, Notice.topic == topic, Notice.is_open)
    return session.scalar(query.with_for_update())


def has_notice(session: Session, person_id: UUID, topic: str, event_id: str) -> bool:
    """Whether a person has a notice of an event, one of its own or the newest of its topic that others are folded into.

    A job that runs again does so soon: its event is in the newest.
    """
    of_topic = select(Notice.event_id, Notice.event_ids).where(Notice.person_id == person_id, Notice.topic == topic)
    newest = session.execute(of_topic.order_by(Notice.id.desc()).limit(1)).first()
    if newest is not None and event_id in newest.event_ids:
        return True
    return session.scalar(of_topic.where(Notice.event_id == event_id).limit(1)) is not None


def unread_notices(session: Session, person_id: UUID, *, limit: int) -> int:
    """Return the number of a person's unread notices, counted up to a limit."""
    unread = select(Notice.id).where(Notice.read_at.is_(None), _shown(person_id))
    with bypass_row_policies(session):  # who only bids does not see that they may
        return session.scalar(select(func.count()).select_from(unread.limit(limit).subquery())) or 0


def deposit_of(session: Session, contract_id: UUID) -> int:
    """Return the sum of a contract's deposits in whole minor units."""
    of_contract = Milestone.contract_id == contract_id
    total = session.scalar(select(func.sum(Milestone.amount_minor)).where(of_contract, Milestone.is_deposit))
    return int(total or 0)


def contracts_with_new_heads(session: Session, today: date) -> Sequence[UUID]:
    """Return contracts that were signed and whose record has grown since its head was mailed, on an earlier day."""
    return session.scalars(
        select(Contract.id)
        .where(
            Contract.agreed_at.is_not(None),
            Contract.record_length > Contract.head_mailed_length,
            or_(Contract.head_mailed_on.is_(None), Contract.head_mailed_on < today),
        )
        .order_by(Contract.id)
    ).all()


def take_with_place(session: Session, take_id: UUID) -> tuple[Take, Project, Cue | None]:
    """Return a take with its project and its cue, None while it is unmatched."""
    query = select(Take, Project, Cue).join(Project, Project.id == Take.project_id)
    take, project, cue = session.execute(query.outerjoin(Cue, Cue.id == Take.cue_id).where(Take.id == take_id)).one()
    return take, project, cue


def pictures_of_takes(session: Session, take_ids: Collection[UUID]) -> dict[UUID, Picture]:
    """Return the pictures of takes whose masters are drawn."""
    is_of_master = and_(Picture.studio_id == Take.studio_id, Picture.sound_sha256 == Take.master_sha256)
    drawn = select(Take.id, Picture).join(Picture, is_of_master).where(in_array(Take.id, take_ids))
    return dict(session.execute(drawn).all())


def note_by_id(session: Session, note_id: UUID, *, is_comment: bool) -> Comment | ChangeRequest:
    """Return a comment, or a change request."""
    return session.get_one(Comment, note_id) if is_comment else session.get_one(ChangeRequest, note_id)
