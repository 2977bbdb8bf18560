"""Changes in a project under running contracts, list and delivery spec, written into the contracts' records."""

from collections.abc import Mapping
from itertools import groupby
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements.drafts.documents import sha256_of
from app.agreements.plan import queries as plan_queries
from app.agreements.record import service as record
from app.agreements.record.sealed_facts import sealed
from app.projects.models import Project
from app.projects.queries import spec_version
from app.sound_lists.rules import label


def record_list_revision(session: Session, event: Mapping[str, Any]) -> None:
    """Write a revision of the sound list into the record of each running contract whose cues it changes."""
    project_id, number = UUID(event["project_id"]), event["revision"]
    prefix = session.get_one(Project, project_id).cue_prefix
    changes = plan_queries.covered_changes(session, project_id, number)
    for contract_id, of_contract in groupby(changes, key=lambda row: row.contract_id):
        rows = list(of_contract)
        facts = {
            "revision": number,
            "cues": [f"{label(prefix, row.number)} {row.name}" for row in rows],
            "sha256": {str(row.cue_id): sealed(row.after) for row in rows},
        }
        record.append(session, contract_id, "list_revised", facts, by=UUID(event["actor_id"]))


def record_spec_version(session: Session, event: Mapping[str, Any]) -> None:
    """Write a new version of the delivery spec into the record of each running contract of its project."""
    project_id, version = UUID(event["project_id"]), event["version"]
    spec = spec_version(session, project_id, version)
    facts = {"spec_version": version, "toml_sha256": sha256_of(spec.toml) if spec else ""}
    for contract_id in plan_queries.running_contracts(session, project_id):
        record.append(session, contract_id, "spec_changed", facts, by=UUID(event["person_id"]))
