"""Templates: the library's, which are nobody's, and those that a studio keeps, takes out and brings in as TOML."""

import tomllib
from collections.abc import Sequence
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.service import ensure_producer_of
from app.contracts import queries
from app.contracts.clauses import Clause, Terms, begin, faults_of
from app.contracts.errors import BadTemplate, ContractVersionNotFound, TemplateNameTaken, TemplateNotFound
from app.contracts.models import ContractTemplate
from app.contracts.rules import KIND_WORDS, ContractKind
from app.contracts.sight import contract_to_change
from app.kit import clock
from app.kit.errors import FieldProblem

FORMAT = 1
MOST_TEMPLATES = 200
LONGEST_NAME = 120
NOTICE = "A start for the lawyers of both parties, and no legal advice."


def templates_of(session: Session, actor: Actor, studio_id: UUID) -> Sequence[ContractTemplate]:
    """Return what a studio keeps, by name."""
    ensure_producer_of(session, actor, studio_id)
    return queries.templates_of(session, studio_id)


def template_in_sight(session: Session, actor: Actor, studio_id: UUID, template_id: UUID) -> ContractTemplate:
    """Return one of a studio's templates; raise TemplateNotFound where it has none of that id."""
    ensure_producer_of(session, actor, studio_id)
    template = queries.template_by_id(session, studio_id, template_id)
    if template is None:
        raise TemplateNotFound(f"no template {template_id} in this studio")
    return template


def keep_template(
    session: Session,
    actor: Actor,
    studio_id: UUID,
    *,
    name: str,
    kind: ContractKind,
    clauses: Sequence[Clause],
    terms: Terms,
) -> ContractTemplate:
    """Keep clauses and terms under a name of their own."""
    ensure_producer_of(session, actor, studio_id)
    if problems := _problems(clauses, terms):
        raise BadTemplate(f"{problems[0]['where']}: {problems[0]['message']}", errors=problems)
    if len(queries.templates_of(session, studio_id)) >= MOST_TEMPLATES:
        raise BadTemplate(f"a studio keeps at most {MOST_TEMPLATES} templates", fix="delete one that nobody uses")
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


def keep_contract_as_template(session: Session, actor: Actor, contract_id: UUID, *, name: str) -> ContractTemplate:
    """Keep the clauses and terms of a contract as they were saved last."""
    contract = contract_to_change(session, actor, contract_id)
    version = queries.newest_version(session, contract.id)
    if version is None:
        raise ContractVersionNotFound("this contract has no text")
    return keep_template(
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
    template = template_in_sight(session, actor, studio_id, template_id)
    if problems := _problems(clauses, terms):
        raise BadTemplate(f"{problems[0]['where']}: {problems[0]['message']}", errors=problems)
    other = queries.template_by_name(session, studio_id, name)
    if other is not None and other.id != template.id:
        message = f'this studio has another template "{name}"'
        raise TemplateNameTaken(message, errors=[{"where": "name", "message": message}])
    template.name, template.terms, template.changed_at = name, dict(terms), clock.now()
    template.clauses = [clause.as_row() for clause in clauses]
    session.flush()
    return template


def drop_template(session: Session, actor: Actor, studio_id: UUID, template_id: UUID) -> None:
    """Keep a template no longer; contracts that began from it stay as they are."""
    session.delete(template_in_sight(session, actor, studio_id, template_id))
    session.flush()


def import_template(
    session: Session, actor: Actor, studio_id: UUID, toml: str, *, name: str | None = None
) -> ContractTemplate:
    """Keep a template that came as TOML, under its own name or another."""
    ensure_producer_of(session, actor, studio_id)
    own_name, kind, clauses, terms = read_toml(toml)
    return keep_template(session, actor, studio_id, name=name or own_name, kind=kind, clauses=clauses, terms=terms)


def library_toml(kind: ContractKind) -> str:
    """Return what the library has for a kind, as a template."""
    clauses, terms = begin(kind)
    return write_toml(KIND_WORDS[kind].capitalize(), kind, clauses, terms)


def _problems(clauses: Sequence[Clause], terms: Terms) -> list[FieldProblem]:
    return [{"where": where, "message": message} for where, message in faults_of(clauses, terms)]


def write_toml(name: str, kind: ContractKind, clauses: Sequence[Clause], terms: Terms) -> str:
    """Return a template as a TOML file whose clauses are Markdown."""
    lines = [f"# {NOTICE}", f"format = {FORMAT}", f"name = {_basic(name)}", f'kind = "{kind}"', "", "[terms]"]
    lines += [f"{key} = {_basic(value) if isinstance(value, str) else value}" for key, value in terms.items()]
    for clause in clauses:
        stands = "true" if clause.stands else "false"
        lines += ["", "[[clauses]]", f'key = "{clause.key}"', f"title = {_basic(clause.title)}", f"stands = {stands}"]
        lines.append(f"text = {_block(clause.text)}")
    return "\n".join(lines) + "\n"


def _basic(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return (
        '"'
        + "".join(letter if letter >= " " and letter != "\x7f" else f"\\u{ord(letter):04x}" for letter in escaped)
        + '"'
    )


def _block(text: str) -> str:
    """Return text between three quotes, so that people can edit it; on one line where it holds such quotes itself."""
    is_plain = "'''" not in text and not text.endswith("'") and all(each >= " " or each in "\n\t" for each in text)
    return f"'''\n{text}'''" if is_plain and "\x7f" not in text else _basic(text)


def read_toml(toml: str) -> tuple[str, ContractKind, list[Clause], Terms]:
    """Return name, kind, clauses and terms of a template; raise BadTemplate, saying where, for anything else."""
    try:
        said = tomllib.loads(toml)
    except tomllib.TOMLDecodeError as error:
        raise BadTemplate(
            f"this is no TOML: {error}", fix="take a template out as TOML to see what one looks like"
        ) from None
    _ensure_keys("", said, {"format", "name", "kind", "terms", "clauses"}, needed={"format", "name", "kind", "clauses"})
    if said["format"] != FORMAT:
        raise BadTemplate(f"format is {said['format']!r}; this version reads format {FORMAT}")
    if not isinstance(said["name"], str) or not 0 < len(said["name"].strip()) <= LONGEST_NAME:
        raise BadTemplate(f"name: wanted a text of 1 to {LONGEST_NAME} characters")
    if said["kind"] not in list(ContractKind):
        raise BadTemplate(f"kind is {said['kind']!r}; wanted one of {', '.join(ContractKind)}")
    terms = said.get("terms", {})
    if not isinstance(terms, dict) or not all(type(value) in (int, str) for value in terms.values()):
        raise BadTemplate("terms: wanted a table of whole numbers and texts")
    if not isinstance(said["clauses"], list):
        raise BadTemplate("clauses: wanted a list of tables, each under [[clauses]]")
    return (
        said["name"].strip(),
        ContractKind(said["kind"]),
        [_clause(place, row) for place, row in enumerate(said["clauses"], 1)],
        terms,
    )


def _clause(place: int, row: Any) -> Clause:
    where = f"clause {place}: "
    if not isinstance(row, dict):
        raise BadTemplate(f"{where}wanted a table")
    _ensure_keys(where, row, {"key", "title", "text", "stands"}, needed={"key", "title", "text"})
    for name in ("key", "title", "text"):
        if not isinstance(row[name], str):
            raise BadTemplate(f"{where}{name} is {row[name]!r}; wanted a text")
    if not isinstance(row.get("stands", True), bool):
        raise BadTemplate(f"{where}stands is {row['stands']!r}; wanted true or false")
    return Clause(row["key"], row["title"].strip(), row["text"].strip(), row.get("stands", True))


def _ensure_keys(where: str, table: dict[str, Any], known: set[str], needed: set[str]) -> None:
    if strange := sorted(set(table) - known):
        raise BadTemplate(f"{where}there is no key {strange[0]} here; known are {', '.join(sorted(known))}")
    if missing := sorted(needed - set(table)):
        raise BadTemplate(f"{where}{missing[0]} is missing")


def write_markdown(name: str, clauses: Sequence[Clause]) -> str:
    """Return the clauses that stand as Markdown, variables in braces: for lawyers, to read and mark."""
    parts = [f"# {name}", f"*{NOTICE}*"]
    for number, clause in enumerate((each for each in clauses if each.stands), start=1):
        parts += [f"## {number}. {clause.title}", clause.text]
    return "\n\n".join(parts) + "\n"
