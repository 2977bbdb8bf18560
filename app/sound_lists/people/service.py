"""The people of cues: who puts each into the game, and who records it."""

from sqlalchemy.orm import Session

from app.projects.models import Project
from app.projects.service import ProjectAccess
from app.sound_lists import queries
from app.sound_lists.people.rules import KnownPeople, ProjectPerson


def people_seen(session: Session, access: ProjectAccess) -> list[ProjectPerson]:
    """Return those who can be chosen, and those whom cues still name; a designer sees only themselves."""
    designer_id = access.only_designer_id
    everyone = people_in(session, access.project)
    return [person for person in everyone if designer_id in (None, person.id)]


def people_in(session: Session, project: Project) -> list[ProjectPerson]:
    """Return the members of the studio, the designers of a project, and the people whom its cues name."""
    designers = queries.designers_of(session, project.id)
    return [
        ProjectPerson(id=person_id, name=name, email=email, is_designer=person_id in designers)
        for person_id, name, email in queries.people_of_list(session, project.studio_id, project.id, designers)
    ]


def known_people(session: Session, access: ProjectAccess) -> KnownPeople:
    """Return the people whose names the caller may read in the list."""
    return KnownPeople(people_seen(session, access))
