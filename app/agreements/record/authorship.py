"""The actor behind an entry of a contract's record: name, role at that time, and the person represented."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person, Token
from app.accounts.queries import membership
from app.agreements.joint.queries import is_designer_of_other
from app.agreements.models import Contract
from app.projects.approval.service import approval_rights
from app.projects.models import Project

SERVER = "Soundlist"


def author_of(
    session: Session, contract: Contract, by: UUID | None, on_behalf_of: UUID | None = None
) -> dict[str, str]:
    """Return the author of a deed, in words; `by` is a person or a build token, None the server itself."""
    author = {"by": SERVER, "role": "server"} if by is None else _named(session, contract, by)
    if on_behalf_of is not None and on_behalf_of != by:
        author["on_behalf_of"] = session.get_one(Person, on_behalf_of).name
    return author


def _named(session: Session, contract: Contract, by: UUID) -> dict[str, str]:
    person = session.get(Person, by)
    if person is None:
        token = session.get(Token, by)
        return {"by": token.name if token else str(by), "role": "build token"}
    return {"by": person.name, "role": ", ".join(_roles(session, contract, by))}


def _roles(session: Session, contract: Contract, person_id: UUID) -> list[str]:
    if person_id == contract.designer_id:
        return ["designer"]
    if is_designer_of_other(session, contract, person_id):
        return ["designer of the other contract"]
    held = membership(session, contract.studio_id, person_id)
    roles = sorted(held.roles) if held else []
    rights = approval_rights(session, session.get_one(Project, contract.project_id))
    if rights.is_approver(person_id):
        roles.insert(0, "approver")
    elif rights.scope_of(person_id).is_any:
        roles.insert(0, "deputy of the approver")
    return roles or ["no longer in the studio"]
