"""Mails about postings: a bid that arrived, questions and their answers, the award and its kind refusals."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person, Studio
from app.core.jobs.queue import Payload
from app.core.runtime import Runtime
from app.hiring.models import Bid, Posting, PostingQuestion
from app.hiring.queries import candidates_of, sent_bids
from app.notifications import queries, service
from app.notifications.kinds import notice
from app.notifications.notifier import Notifier
from app.notifications.preferences.rules import News
from app.projects.models import Project


def _notify_team(runtime: Runtime, session: Session, payload: Payload, posting: Posting, topic: str, line: str) -> None:
    project = session.get_one(Project, posting.project_id)
    notifier = Notifier(runtime, session, project, payload["event_id"])
    recipients = queries.producer_addresses(session, project.studio_id) | queries.spokesperson_addresses(
        session, project
    )
    for recipient in sorted(recipients):
        notifier.notify(recipient, f"{topic}:{posting.id}", f"news of {posting.title}", line, page=_page(posting))


def _page(posting: Posting) -> str:
    return f"postings/{posting.id}"


def _mail(
    runtime: Runtime, session: Session, payload: Payload, posting: Posting, recipient: str, subject: str, line: str
) -> None:
    """Mail a candidate, who may not see the project and so is led to the posting alone."""
    service.write_news(
        session,
        event_id=payload["event_id"],
        studio_id=posting.studio_id,
        project_id=posting.project_id,
        topic=f"posting:{posting.id}",
        recipient=recipient,
        subject=f"{posting.title}: {subject}",
        lines=[line],
        base_url=runtime.settings.base_url,
        path=f"/postings/{posting.id}",
        delay_s=runtime.settings.digest_delay_s,
    )


@notice("bid.sent", topics={"bids": News.HIRING})
def notify_bid(runtime: Runtime, payload: Payload) -> None:
    """Notify those who act for the studio of a bid; without its figures, which are for the page."""
    with runtime.database.writing() as session:
        bid = session.get_one(Bid, UUID(payload["bid_id"]))
        posting = session.get_one(Posting, bid.posting_id)
        designer = session.get_one(Person, bid.designer_id)
        _notify_team(runtime, session, payload, posting, "bids", f"{designer.name} sent a bid on {posting.title}.")


@notice("posting_question.asked", topics={"posting-questions": News.HIRING})
def notify_posting_question(runtime: Runtime, payload: Payload) -> None:
    """Notify those who act for the studio of a candidate's question."""
    with runtime.database.writing() as session:
        question = session.get_one(PostingQuestion, UUID(payload["question_id"]))
        posting = session.get_one(Posting, question.posting_id)
        asker = session.get_one(Person, question.asked_by)
        line = f"{asker.name} asks about {posting.title}: {question.text}"
        _notify_team(runtime, session, payload, posting, "posting-questions", line)


@notice("posting_question.answered")
def notify_posting_answer(runtime: Runtime, payload: Payload) -> None:
    """Notify the candidate who asked, or all of them where the answer is for all."""
    with runtime.database.writing() as session:
        question = session.get_one(PostingQuestion, UUID(payload["question_id"]))
        posting = session.get_one(Posting, question.posting_id)
        joined = [candidate.person_id for candidate in candidates_of(session, posting.id) if candidate.person_id]
        person_ids = joined if question.is_for_all else [question.asked_by]
        for person_id in person_ids:
            address = queries.address_of(session, person_id)
            line = f"{question.text}\n\n{question.answer or ''}"
            _mail(runtime, session, payload, posting, address, "a question was answered", line)


@notice("posting.awarded", topics={"posting": News.HIRING})
def notify_award(runtime: Runtime, payload: Payload) -> None:
    """Notify the designer who was chosen, and thank the others who sent a bid."""
    with runtime.database.writing() as session:
        chosen = session.get_one(Bid, UUID(payload["bid_id"]))
        posting = session.get_one(Posting, chosen.posting_id)
        studio = session.get_one(Studio, posting.studio_id).name
        for bid in sent_bids(session, posting.id):
            address = queries.address_of(session, bid.designer_id)
            if bid.id == chosen.id:
                subject = "your bid was chosen"
                line = (
                    f"{studio} chose your bid on {posting.title}. A contract with your figures follows; "
                    "you are on the project from now on."
                )
            else:
                subject = "another bid was chosen"
                line = (
                    f"Thank you for your bid on {posting.title}. {studio} has chosen another one this time. "
                    "Your bid stays on your page, and no other designer has seen your rates."
                )
            _mail(runtime, session, payload, posting, address, subject, line)
