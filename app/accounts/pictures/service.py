"""Pictures of people: each their own, a small square that is kept with the account."""

import hashlib

from sqlalchemy.orm import Session

from app.accounts.models import Person, PersonPicture
from app.accounts.rules import Actor


def save_picture(session: Session, actor: Actor, content: bytes) -> Person:
    """Replace the caller's picture by one that was drawn."""
    person = session.get_one(Person, actor.person)
    sha256 = hashlib.sha256(content).hexdigest()
    session.merge(PersonPicture(person_id=person.id, sha256=sha256, content=content))
    person.picture_sha256 = sha256
    session.flush()
    return person


def remove_picture(session: Session, actor: Actor) -> None:
    """Take the caller's picture away, if there is one."""
    picture = session.get(PersonPicture, actor.person)
    if picture is not None:
        session.delete(picture)
    session.get_one(Person, actor.person).picture_sha256 = None
    session.flush()
