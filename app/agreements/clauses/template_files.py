"""Templates as TOML files and as Markdown, without a database."""

from collections.abc import Sequence
from typing import Any, TypeAlias

from app.agreements.clauses.rules import Clause, ClauseRow, Terms
from app.agreements.errors import BadTemplate
from app.agreements.rules import ContractKind
from audio_checks import SpecError, read_toml

FORMAT = 1
MAX_NAME_CHARS = 120
NOTICE = "A start for the lawyers of both parties, and no legal advice."
TemplateFields: TypeAlias = tuple[str, str, list[ClauseRow], dict[str, int | str]]


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


def parse_toml(toml: str) -> TemplateFields:
    """Return name, kind, clauses as rows, and terms of a template; raise BadTemplate, saying where, for anything else.

    What a request brings is parsed in a child process, so that all of it is plain values.
    """
    try:
        fields = read_toml(toml, "template.toml")
    except SpecError as error:
        raise BadTemplate(f"the template {error.args[0]}", fix="export a template as TOML to see an example") from None
    _ensure_keys(
        "", fields, {"format", "name", "kind", "terms", "clauses"}, needed={"format", "name", "kind", "clauses"}
    )
    if fields["format"] != FORMAT:
        raise BadTemplate(f"format is {fields['format']!r}; this version reads format {FORMAT}")
    if not isinstance(fields["name"], str) or not 0 < len(fields["name"].strip()) <= MAX_NAME_CHARS:
        raise BadTemplate(f"name: wanted a text of 1 to {MAX_NAME_CHARS} characters")
    if fields["kind"] not in list(ContractKind):
        raise BadTemplate(f"kind is {fields['kind']!r}; wanted one of {', '.join(ContractKind)}")
    terms = fields.get("terms", {})
    if not isinstance(terms, dict) or not all(type(value) in (int, str) for value in terms.values()):
        raise BadTemplate("terms: wanted a table of whole numbers and texts")
    if not isinstance(fields["clauses"], list):
        raise BadTemplate("clauses: wanted a list of tables, each under [[clauses]]")
    return (
        fields["name"].strip(),
        fields["kind"],
        [_clause(number, row).as_row() for number, row in enumerate(fields["clauses"], 1)],
        terms,
    )


def _clause(number: int, row: Any) -> Clause:
    where = f"clause {number}: "
    if not isinstance(row, dict):
        raise BadTemplate(f"{where}wanted a table")
    _ensure_keys(where, row, {"key", "title", "text", "stands"}, needed={"key", "title", "text"})
    for name in ("key", "title", "text"):
        if not isinstance(row[name], str):
            raise BadTemplate(f"{where}{name} is {row[name]!r}; wanted a text")
    if not isinstance(row.get("stands", True), bool):
        raise BadTemplate(f"{where}stands is {row['stands']!r}; wanted true or false")
    return Clause(row["key"], row["title"].strip(), row["text"].strip(), row.get("stands", True))


def _ensure_keys(where: str, table: dict[str, Any], known_keys: set[str], needed: set[str]) -> None:
    if strange := sorted(set(table) - known_keys):
        raise BadTemplate(f"{where}there is no key {strange[0]} here; known are {', '.join(sorted(known_keys))}")
    if missing := sorted(needed - set(table)):
        raise BadTemplate(f"{where}{missing[0]} is missing")


def write_markdown(name: str, clauses: Sequence[Clause]) -> str:
    """Return the clauses that stand as Markdown, variables in braces: for lawyers, to read and mark."""
    parts = [f"# {name}", f"*{NOTICE}*"]
    for number, clause in enumerate((each for each in clauses if each.stands), start=1):
        parts += [f"## {number}. {clause.title}", clause.text]
    return "\n\n".join(parts) + "\n"
