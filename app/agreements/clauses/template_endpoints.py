"""The endpoints of the clause library and of the templates that studios keep."""

from collections.abc import Sequence
from typing import Annotated, TypeAlias
from uuid import UUID

from fastapi import APIRouter, Depends, Request, Response

from app.accounts.errors import ProducerNeeded as StudioProducerNeeded
from app.accounts.errors import StudioNotFound
from app.accounts.rules import Actor, Audience
from app.accounts.service import ensure_producer_of
from app.accounts.web.policies import allows
from app.agreements import schemas
from app.agreements.clauses import rules as clauses
from app.agreements.clauses import template_files, templates
from app.agreements.errors import BadTemplate, ContractNotFound, TemplateNameTaken, TemplateNotFound
from app.agreements.models import ContractTemplate
from app.agreements.rules import ContractKind
from app.core.parsing_queue import ParsingBusy, parse_request
from app.core.web.bodies import LARGE_BODY_BYTES, accepts_body
from app.core.web.downloads import downloads, file_response
from app.core.web.http import DbSession, problems
from app.projects.errors import ProducerNeeded

router = APIRouter(prefix="/v1", tags=["contracts"])
SentTemplate: TypeAlias = tuple[schemas.TemplateImport, template_files.TemplateFields]
TOML, MARKDOWN = "application/toml", "text/markdown; charset=utf-8"


def clauses_of(rows: Sequence[schemas.ClauseRow]) -> list[clauses.Clause]:
    """Return clauses as they were sent, without blanks at their ends."""
    return [clauses.Clause(row.key, row.title.strip(), row.text.strip(), row.stands) for row in rows]


def _template(template: ContractTemplate) -> schemas.TemplateRead:
    return schemas.TemplateRead(
        **schemas.TemplateBrief.model_validate(template).model_dump(),
        clauses=[schemas.ClauseRow.model_validate(row) for row in template.clauses],
        terms=template.terms,
    )


@router.get("/contract-library/{kind}")
def read_contract_library(
    kind: ContractKind,
    _actor: Actor = allows(Audience.PERSON),
) -> schemas.LibraryRead:
    """Return the clauses that the library has for a kind of contract, and what they leave open."""
    return schemas.LibraryRead(
        kind=kind,
        notice=template_files.NOTICE,
        clauses=[
            schemas.LibraryClauseRead(
                **each.clause.as_row(),
                why=each.why,
                music=each.music,
                instead_of=each.instead_of,
                terms=[schemas.TermRead.model_validate(term) for term in each.terms],
            )
            for each in clauses.library()
            if kind in each.kinds
        ],
        variables=dict(clauses.FACTS),
    )


@router.get("/contract-library/{kind}/template.toml", **downloads(TOML))
def download_library_template(
    kind: ContractKind,
    _actor: Actor = allows(Audience.PERSON),
) -> Response:
    """Return the library's content for a kind as a template file."""
    return file_response(templates.library_toml(kind), TOML, f"{kind}.toml")


@router.get(
    "/studios/{studio_id}/contract-templates",
    response_model=list[schemas.TemplateBrief],
    responses=problems(StudioNotFound, StudioProducerNeeded),
)
def list_contract_templates(
    studio_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> Sequence[ContractTemplate]:
    """Return the templates that a studio keeps, by name."""
    return templates.templates_of(session, actor, studio_id)


@router.post(
    "/studios/{studio_id}/contract-templates",
    status_code=201,
    responses=problems(StudioNotFound, StudioProducerNeeded, BadTemplate, TemplateNameTaken),
)
@accepts_body(LARGE_BODY_BYTES)
def add_contract_template(
    studio_id: UUID, body: schemas.TemplateAdd, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.TemplateRead:
    """Keep a template."""
    return _template(
        templates.save_template(
            session,
            actor,
            studio_id,
            name=body.name,
            kind=body.kind,
            clauses=clauses_of(body.clauses),
            terms=body.terms,
        )
    )


async def _parsed(studio_id: UUID, body: schemas.TemplateImport, request: Request) -> SentTemplate:
    fields = await parse_request(
        request,
        template_files.parse_toml,
        body.toml,
        refusal=BadTemplate,
        permit=ensure_producer_of,
        whose=studio_id,
    )
    return body, fields


@router.post(
    "/studios/{studio_id}/contract-templates/import",
    status_code=201,
    responses=problems(StudioNotFound, StudioProducerNeeded, BadTemplate, TemplateNameTaken, ParsingBusy),
)
@accepts_body(LARGE_BODY_BYTES)
def import_contract_template(
    studio_id: UUID,
    actor: Annotated[Actor, allows(Audience.PRODUCER)],
    sent: Annotated[SentTemplate, Depends(_parsed)],
    session: DbSession,
) -> schemas.TemplateRead:
    """Keep a template that comes as TOML."""
    body, fields = sent
    return _template(templates.import_template(session, actor, studio_id, fields, name=body.name))


@router.get(
    "/studios/{studio_id}/contract-templates/{template_id}",
    responses=problems(StudioNotFound, StudioProducerNeeded, TemplateNotFound),
)
def read_contract_template(
    studio_id: UUID, template_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.TemplateRead:
    """Return a template with its clauses."""
    return _template(templates.visible_template(session, actor, studio_id, template_id))


@router.put(
    "/studios/{studio_id}/contract-templates/{template_id}",
    responses=problems(StudioNotFound, StudioProducerNeeded, TemplateNotFound, BadTemplate, TemplateNameTaken),
)
@accepts_body(LARGE_BODY_BYTES)
def change_contract_template(
    studio_id: UUID,
    template_id: UUID,
    body: schemas.TemplateChange,
    session: DbSession,
    actor: Actor = allows(Audience.PRODUCER),
) -> schemas.TemplateRead:
    """Change a template; contracts that began from it stay as they are."""
    return _template(
        templates.change_template(
            session, actor, studio_id, template_id, name=body.name, clauses=clauses_of(body.clauses), terms=body.terms
        )
    )


@router.delete(
    "/studios/{studio_id}/contract-templates/{template_id}",
    status_code=204,
    responses=problems(StudioNotFound, StudioProducerNeeded, TemplateNotFound),
)
def drop_contract_template(
    studio_id: UUID, template_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> None:
    """Keep a template no longer."""
    templates.drop_template(session, actor, studio_id, template_id)


@router.get(
    "/studios/{studio_id}/contract-templates/{template_id}/template.toml",
    **downloads(TOML, StudioNotFound, StudioProducerNeeded, TemplateNotFound),
)
def download_contract_template(
    studio_id: UUID, template_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> Response:
    """Return a template as the file that an import reads."""
    template = templates.visible_template(session, actor, studio_id, template_id)
    rows = [clauses.Clause.of(row) for row in template.clauses]
    toml = template_files.write_toml(template.name, template.kind, rows, template.terms)
    return file_response(toml, TOML, f"{template.name}.toml")


@router.get(
    "/studios/{studio_id}/contract-templates/{template_id}/template.md",
    **downloads(MARKDOWN, StudioNotFound, StudioProducerNeeded, TemplateNotFound),
)
def download_contract_template_text(
    studio_id: UUID, template_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> Response:
    """Return a template's standing clauses as Markdown, for lawyers to read."""
    template = templates.visible_template(session, actor, studio_id, template_id)
    text = template_files.write_markdown(template.name, [clauses.Clause.of(row) for row in template.clauses])
    return file_response(text, MARKDOWN, f"{template.name}.md")


@router.post(
    "/contracts/{contract_id}/template",
    status_code=201,
    responses=problems(ContractNotFound, ProducerNeeded, TemplateNameTaken, BadTemplate),
)
def save_contract_as_template(
    contract_id: UUID, body: schemas.ContractTemplateAdd, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> schemas.TemplateRead:
    """Keep the contract's clauses and terms as a template of the studio."""
    return _template(templates.save_contract_as_template(session, actor, contract_id, name=body.name))
