"""The demo's studio and its people, whose parts a visitor may choose."""

from sqlalchemy import select

from app.accounts.models import Membership, Person, Studio
from app.accounts.rules import Role
from app.core.runtime import Runtime

SECOND_DESIGNER = "Second designer"  # who bids too, and is not chosen
PEOPLE: tuple[tuple[str | None, str, list[Role]], ...] = (
    ("producer", "Producer", [Role.PRODUCER]),
    ("approver", "Audio director", [Role.LIAISON]),
    (None, "Composer", [Role.REVIEWER]),
    (None, "Programmer", [Role.REVIEWER, Role.IMPLEMENTER]),
    ("designer", "Sound designer", []),
    (None, SECOND_DESIGNER, []),
)


def make_people(runtime: Runtime) -> dict[str, str]:
    """Make the studio and the people whose parts the demo plays; return their ids by name."""
    with runtime.database.writing() as session:
        studio = session.scalar(select(Studio).where(Studio.is_demo))
        if studio is None:
            studio = Studio(name="Shield Wing studio", is_demo=True)
            session.add(studio)
            session.flush()
            for part, name, roles in PEOPLE:
                address = f"{name.lower().replace(' ', '.')}@soundlist.example"
                person = Person(email=address, name=name, demo_part=part)
                session.add(person)
                session.flush()
                if roles:
                    session.add(Membership(studio_id=studio.id, person_id=person.id, roles=[*roles]))
        people = session.execute(select(Person.name, Person.id)).all()
        return {"studio": str(studio.id)} | {name: str(person_id) for name, person_id in people}
