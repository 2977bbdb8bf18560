"""The text of a delivery spec: read, written from a form, and kept as a version."""

import hashlib
from collections.abc import Mapping
from functools import lru_cache
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

import audio_checks
from app.accounts.models import Person
from app.core.errors import FieldProblem
from app.projects.errors import BadSpec
from app.projects.models import Project, Spec
from app.projects.rules import stated

FILE_NAME = "spec.toml"  # as parse_spec calls a text without a file
MAX_CHARACTERS = 200_000


def read_spec(toml: str) -> audio_checks.DeliverySpec:
    """Return the spec of a TOML text, or raise BadSpec naming the place.

    Text from a request is parsed in a child process first.
    """
    try:
        return _parsed(toml)
    except audio_checks.SpecError as error:
        raise refusal_of(error) from None


def ensure_short(toml: str) -> None:
    """Raise BadSpec for a text that is longer than any spec needs."""
    if len(toml) > MAX_CHARACTERS:
        message = f"a spec may have {MAX_CHARACTERS:,} characters; this one has {len(toml):,}"
        raise BadSpec(message, errors=[{"where": "", "message": message}])


@lru_cache(maxsize=32)
def _parsed(toml: str) -> audio_checks.DeliverySpec:
    return audio_checks.parse_spec(toml, where=FILE_NAME)


def refusal_of(error: audio_checks.SpecError) -> BadSpec:
    """Return the fault of a spec as what a caller meets."""
    message = str(error.args[0])
    where = error.where.removeprefix(FILE_NAME).removeprefix(": ")
    errors: list[FieldProblem] = [{"where": where, "message": message}]
    return BadSpec(f"{where}: {message}" if where else f"the spec {message}", errors=errors)


def toml_of_form(tables: Mapping[str, Any]) -> str:
    """Return the TOML of a form, or raise BadSpec."""
    try:
        toml = audio_checks.DeliverySpec(tables=stated(tables)).to_toml()
        toml.encode()
    except (RecursionError, UnicodeEncodeError):
        message = "the form has a value that no spec can have"
        raise BadSpec(message, errors=[{"where": "", "message": message}]) from None
    return toml


def add_version(session: Session, project: Project, author_id: UUID, *, toml: str, number: int, note: str) -> Spec:
    """Write one version of a project's spec, or raise BadSpec."""
    spec = Spec(
        studio_id=project.studio_id,
        project_id=project.id,
        version=number,
        toml=toml,
        sha256=read_spec(toml).sha256,
        note=note,
        author=session.get_one(Person, author_id),
    )
    session.add(spec)
    session.flush()
    return spec


def etag_of(spec: Spec) -> str:
    """Return the strong entity tag of a spec's text."""
    return f'"{hashlib.sha256(spec.toml.encode()).hexdigest()}"'
