"""A contract begun like the studio's last one: its clauses, its terms and how it pays."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.agreements import queries
from app.agreements.clauses import rules as clause_rules
from app.agreements.clauses.rules import Clause, Terms
from app.agreements.drafts.versions import newest_of
from app.agreements.errors import ContractNotFound
from app.agreements.models import Contract
from app.agreements.rules import ContractKind
from app.projects.errors import EngagementNotFound
from app.projects.queries import engagement_by_id
from app.projects.service import project_access

PARTIES = "parties"
OF_ONE_CONTRACT = frozenset(
    {"po_number", "exclusive_from", "exclusive_until", "bonus_trigger", "bonus_minor", "bonus_when"}
)
OF_ONE_DESIGNER = frozenset({"tax_bp", "reverse_charge", "credit_line"})


def last_contract(
    session: Session, actor: Actor, project_id: UUID, *, engagement_id: UUID, kind: ContractKind
) -> Contract | None:
    """Return the studio's last contract of a kind that was sent: with this designer, else with any, else None."""
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    engagement = engagement_by_id(session, project_id, engagement_id)
    if engagement is None:
        raise EngagementNotFound(f"no engagement {engagement_id} in this project")
    return queries.last_sent(session, actor, access.project.studio_id, kind, engagement.designer_id)


def copied_terms(
    session: Session, actor: Actor, same_as_id: UUID, *, studio_id: UUID, kind: ContractKind, designer_id: UUID
) -> tuple[Contract, list[Clause], Terms]:
    """Return a contract of the studio with its clauses and terms as another one begins with them.

    What belongs to one contract (purchase order, dates, bonus) begins as in the library. So does, with another
    designer, what is that designer's own: the paragraph on the parties, the tax and the credit.
    """
    same_as = queries.contract_for(session, actor, same_as_id)
    if same_as is None or same_as.studio_id != studio_id or same_as.kind is not kind:
        raise ContractNotFound(f"the studio has no contract {same_as_id} of the kind {kind.value}")
    newest = newest_of(session, same_as)
    clauses = [Clause.of(row) for row in newest.clauses]
    library, defaults = clause_rules.default_clauses(kind)
    reset_names = OF_ONE_CONTRACT
    if same_as.designer_id != designer_id:
        reset_names |= OF_ONE_DESIGNER
        parties = [clause for clause in library if clause.key == PARTIES]
        clauses = [parties[0] if clause.key == PARTIES and parties else clause for clause in clauses]
    terms = {
        name: defaults[name] if name in reset_names & defaults.keys() else is_ for name, is_ in newest.terms.items()
    }
    return same_as, clauses, terms
