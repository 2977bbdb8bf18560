"""Templates: the library's, which belong to no studio, and those that a studio saves, exports and imports as TOML."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.service import ensure_producer_of
from app.agreements import queries
from app.agreements.access import contract_to_change
from app.agreements.clauses.figures import text_errors
from app.agreements.clauses.rules import Clause, Terms, default_clauses
from app.agreements.clauses.template_files import TemplateFields, write_toml
from app.agreements.errors import BadTemplate, ContractVersionNotFound, TemplateNameTaken, TemplateNotFound
from app.agreements.models import ContractTemplate
from app.agreements.rules import KIND_WORDS, ContractKind
from app.core import clock
from app.core.errors import FieldProblem

MAX_TEMPLATES = 200


def templates_of(session: Session, actor: Actor, studio_id: UUID) -> Sequence[ContractTemplate]:
    """Return a studio's templates, by name."""
    ensure_producer_of(session, actor, studio_id)
    return queries.templates_of(session, studio_id)


def visible_template(session: Session, actor: Actor, studio_id: UUID, template_id: UUID) -> ContractTemplate:
    """Return one of a studio's templates; raise TemplateNotFound where it has none of that id."""
    ensure_producer_of(session, actor, studio_id)
    template = queries.template_by_id(session, studio_id, template_id)
    if template is None:
        raise TemplateNotFound(f"no template {template_id} in this studio")
    return template


def save_template(
    session: Session,
    actor: Actor,
    studio_id: UUID,
    *,
    name: str,
    kind: ContractKind,
    clauses: Sequence[Clause],
    terms: Terms,
) -> ContractTemplate:
    """Keep clauses and terms under a new name."""
    ensure_producer_of(session, actor, studio_id)
    if problems := _problems(clauses, terms, kind):
        raise BadTemplate(f"{problems[0]['where']}: {problems[0]['message']}", errors=problems)
    if len(queries.templates_of(session, studio_id)) >= MAX_TEMPLATES:
        raise BadTemplate(f"a studio keeps at most {MAX_TEMPLATES} templates", fix="delete one that is not used")
    if queries.template_by_name(session, studio_id, name) is not None:
        message = f'this studio has a template "{name}" already'
        raise TemplateNameTaken(
            message, errors=[{"where": "name", "message": message}], fix="give this one another name"
        )
    template = ContractTemplate(
        studio_id=studio_id,
        name=name,
        kind=kind,
        clauses=[clause.as_row() for clause in clauses],
        terms=dict(terms),
        created_by=actor.person,
    )
    session.add(template)
    session.flush()
    return template


def save_contract_as_template(session: Session, actor: Actor, contract_id: UUID, *, name: str) -> ContractTemplate:
    """Keep the clauses and terms of a contract as they were saved last."""
    contract = contract_to_change(session, actor, contract_id)
    version = queries.newest_version(session, contract.id)
    if version is None:
        raise ContractVersionNotFound("this contract has no text")
    return save_template(
        session,
        actor,
        contract.studio_id,
        name=name,
        kind=contract.kind,
        clauses=[Clause.of(row) for row in version.clauses],
        terms=version.terms,
    )


def change_template(
    session: Session,
    actor: Actor,
    studio_id: UUID,
    template_id: UUID,
    *,
    name: str,
    clauses: Sequence[Clause],
    terms: Terms,
) -> ContractTemplate:
    """Change a template; contracts that began from it stay as they are."""
    template = visible_template(session, actor, studio_id, template_id)
    if problems := _problems(clauses, terms, template.kind):
        raise BadTemplate(f"{problems[0]['where']}: {problems[0]['message']}", errors=problems)
    other = queries.template_by_name(session, studio_id, name)
    if other is not None and other.id != template.id:
        message = f'this studio has another template "{name}"'
        raise TemplateNameTaken(
            message, errors=[{"where": "name", "message": message}], fix="give this one another name"
        )
    template.name, template.terms, template.changed_at = name, dict(terms), clock.now()
    template.clauses = [dict(clause.as_row()) for clause in clauses]
    session.flush()
    return template


def drop_template(session: Session, actor: Actor, studio_id: UUID, template_id: UUID) -> None:
    """Keep a template no longer; contracts that began from it stay as they are."""
    session.delete(visible_template(session, actor, studio_id, template_id))
    session.flush()


def import_template(
    session: Session, actor: Actor, studio_id: UUID, fields: TemplateFields, *, name: str | None = None
) -> ContractTemplate:
    """Import a template from TOML, under its name or another."""
    own_name, kind, rows, terms = fields
    return save_template(
        session,
        actor,
        studio_id,
        name=name or own_name,
        kind=ContractKind(kind),
        clauses=[Clause.of(row) for row in rows],
        terms=terms,
    )


def library_toml(kind: ContractKind) -> str:
    """Return the library's content for a kind, as a template."""
    clauses, terms = default_clauses(kind)
    return write_toml(KIND_WORDS[kind].capitalize(), kind, clauses, terms)


def _problems(clauses: Sequence[Clause], terms: Terms, kind: ContractKind) -> list[FieldProblem]:
    return [
        {"where": where, "message": message} for where, message in text_errors(clauses, terms, kind, is_template=True)
    ]
