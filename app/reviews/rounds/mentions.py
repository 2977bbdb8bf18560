"""People mentioned in comments, replies and change requests: those who may see the version."""

from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.core.db import bypass_row_policies
from app.core.events import publish
from app.deliveries.models import Take
from app.reviews import queries
from app.reviews.models import ChangeRequest, Comment
from app.reviews.rules import names_mentioned


def people_to_mention(session: Session, take: Take) -> Sequence[Person]:
    """Return the people who may see a take."""
    with bypass_row_policies(session):  # a designer reads no memberships, and may mention the team
        return queries.people_who_see(session, take)


def mentions_in(session: Session, take: Take, text: str, person_ids: Collection[UUID]) -> dict[str, str]:
    """Return the people that a text on a take mentions, with their names; raise NotMentionable."""
    if not person_ids:
        return {}
    names = {person.id: person.name for person in people_to_mention(session, take)}
    return names_mentioned(text, person_ids, names)


def publish_mentions(session: Session, source: Comment | ChangeRequest, *, without: UUID | None = None) -> None:
    """Publish for each person that a comment or a change request mentions them, but for one who is mailed of it."""
    kind = "comment" if isinstance(source, Comment) else "change_request"
    for person_id in source.mentions:
        if person_id != str(without):
            publish(
                session,
                "person.mentioned",
                studio_id=source.studio_id,
                kind=kind,
                said_id=source.id,
                person_id=person_id,
            )
