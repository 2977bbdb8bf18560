"""The endpoints of a contract's texts and of its record."""

import json
from collections.abc import Sequence
from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Path, Query, Response

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.agreements import queries, schemas
from app.agreements.access import visible_contract
from app.agreements.clauses.text import Block, blocks_of
from app.agreements.drafts import comparison, comparison_schemas, versions
from app.agreements.drafts.documents import PDF
from app.agreements.errors import (
    ContractNotFound,
    ContractVersionNotFound,
    TooLongToCompare,
)
from app.agreements.models import ContractVersion
from app.agreements.record import service as record
from app.agreements.record import signed_checkpoints as heads
from app.agreements.word.document import DOCX, Earlier, Heading, word_document
from app.agreements.word.file import properties_of
from app.core.web.downloads import downloads, file_response
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.core.web.per_user_limit import PerUserLimit, TooManyAtOnce

router = APIRouter(prefix="/v1", tags=["contracts"])
COMPARISONS = PerUserLimit(1, "comparison")  # of the four requests that read at once
VersionNumber = Annotated[int, Path(ge=1, le=2**31 - 1)]


def blocks_read(blocks: Sequence[Block]) -> list[schemas.BlockRead]:
    """Return the blocks of a text as they are answered."""
    return [schemas.BlockRead.model_validate(block) for block in blocks]


def version_read(version: ContractVersion, *, is_team: bool) -> schemas.VersionRead:
    """Return a version with its text; a designer sees only clauses that stand."""
    rows = [row for row in version.clauses if is_team or row["stands"]]
    return schemas.VersionRead(
        **schemas.VersionBrief.model_validate(version).model_dump(),
        blocks=blocks_read(blocks_of(version.text)),
        clauses=[schemas.ClauseRow.model_validate(row) for row in rows],
        terms=version.terms,
    )


@router.get(
    "/contracts/{contract_id}/versions",
    response_model=list[schemas.VersionBrief],
    responses=problems(ContractNotFound),
)
def list_contract_versions(
    contract_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> Sequence[ContractVersion]:
    """Return the versions that the caller may see, the newest first."""
    contract = visible_contract(session, actor, contract_id)
    return versions.visible_versions(session, actor, contract)


@router.get(
    "/contracts/{contract_id}/versions/{version}", responses=problems(ContractNotFound, ContractVersionNotFound)
)
def read_contract_version(
    contract_id: UUID, version: VersionNumber, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> schemas.VersionRead:
    """Return one version of the text."""
    contract = visible_contract(session, actor, contract_id)
    contract_version = versions.visible_version(session, actor, contract, version)
    return version_read(contract_version, is_team=bool(actor.roles_in(contract.studio_id)))


@router.get(
    "/contracts/{contract_id}/versions/{version}/contract.pdf",
    **downloads(PDF, ContractNotFound, ContractVersionNotFound),
)
def download_contract_pdf(
    contract_id: UUID,
    version: VersionNumber,
    runtime: CurrentRuntime,
    session: DbSession,
    as_sent: bool = False,
    actor: Actor = allows(Audience.PROJECT),
) -> Response:
    """Return the PDF of a version that was sent: sealed once all have signed it, or else as both saw it."""
    contract = visible_contract(session, actor, contract_id)
    contract_version = versions.visible_version(session, actor, contract, version)
    if contract_version.pdf_sha256 is None:
        raise ContractVersionNotFound(f"version {version} was not sent, so there is no PDF of it")
    seal = None if as_sent else queries.seal_of(session, contract_version.id)
    pdf = runtime.store.read(contract.studio_id, seal.file_sha256 if seal else contract_version.pdf_sha256)
    name = f"{contract.title}, version {version}{', signed' if seal else ''}.pdf"
    return file_response(pdf, PDF, name)


@router.get(
    "/contracts/{contract_id}/versions/{version}/contract.docx",
    **downloads(DOCX, ContractNotFound, ContractVersionNotFound, TooLongToCompare, TooManyAtOnce),
)
def download_contract_docx(
    contract_id: UUID,
    version: VersionNumber,
    session: DbSession,
    against: Annotated[int | None, Query(ge=1, le=2**31 - 1)] = None,
    actor: Actor = allows(Audience.PROJECT),
) -> Response:
    """Return a version as a Word document, with tracked changes against another one if one is named."""
    contract = visible_contract(session, actor, contract_id)
    contract_version = versions.visible_version(session, actor, contract, version)
    name = f"{contract.title}, version {version}"
    standing = [row for row in contract_version.clauses if row["stands"]]
    headings = [Heading(row["key"], f"{number}. {row['title']}") for number, row in enumerate(standing, start=1)]
    with COMPARISONS.of(actor.person):
        earlier = None
        if against is not None:
            other = versions.visible_version(session, actor, contract, against)
            earlier = Earlier(other.text, contract_version.author.name, contract_version.created_at)
            name = f"{name}, changes since version {against}"
        document = word_document(
            contract_version.text, headings, earlier, properties_of(str(contract.id), version, against)
        )
    return file_response(document, DOCX, f"{name}.docx")


@router.get(
    "/contracts/{contract_id}/comparison",
    responses=problems(ContractNotFound, ContractVersionNotFound, TooLongToCompare, TooManyAtOnce),
)
def compare_contract_versions(
    contract_id: UUID,
    session: DbSession,
    from_version: Annotated[int, Query(ge=1, le=2**31 - 1)],
    to_version: Annotated[int, Query(ge=1, le=2**31 - 1)],
    actor: Actor = allows(Audience.PROJECT),
) -> comparison_schemas.ComparisonRead:
    """Return two versions word by word."""
    contract = visible_contract(session, actor, contract_id)
    earlier = versions.visible_version(session, actor, contract, from_version)
    later = versions.visible_version(session, actor, contract, to_version)
    with COMPARISONS.of(actor.person):
        lines = comparison.compare(earlier.text, later.text)
        return comparison_schemas.ComparisonRead(
            from_version=from_version,
            to_version=to_version,
            lines=[comparison_schemas.ComparedRead.model_validate(line) for line in lines],
        )


@router.get("/contracts/{contract_id}/record", responses=problems(ContractNotFound))
def read_contract_record(
    contract_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> schemas.RecordRead:
    """Return the record of a contract, verified now."""
    contract = visible_contract(session, actor, contract_id)
    document = record.document_of(session, contract)
    entries = [entry | {"payload": json.loads(entry["payload"])} for entry in document["entries"]]
    return schemas.RecordRead(
        contract_id=contract.id,
        title=contract.title,
        length=contract.record_length,
        sha256=contract.record_sha256,
        faults=list(record.validation_errors(session, contract)),
        entries=[schemas.RecordEntryRead.model_validate(entry) for entry in entries],
    )


@router.get(
    "/contracts/{contract_id}/record.json",
    **downloads("application/json", ContractNotFound),
)
def download_contract_record(
    contract_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> Response:
    """Return the record as the file that a party keeps, and that `soundlist verify` reads."""
    contract = visible_contract(session, actor, contract_id)
    text = json.dumps(record.document_of(session, contract), ensure_ascii=False, indent=1) + "\n"
    return file_response(text, "application/json", f"{contract.title}, record.json")


@router.get(
    "/contracts/{contract_id}/head.json",
    **downloads("application/json", ContractNotFound),
)
def download_contract_head(
    contract_id: UUID, runtime: CurrentRuntime, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> Response:
    """Return the head of the record, signed: what a party keeps, and `soundlist verify --head` reads."""
    contract = visible_contract(session, actor, contract_id)
    text = json.dumps(heads.signed_checkpoint(runtime.settings, contract), ensure_ascii=False, indent=1) + "\n"
    return file_response(text, "application/json", f"{contract.title}, head.json")
