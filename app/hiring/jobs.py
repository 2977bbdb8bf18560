"""The jobs of this room."""

from functools import cache
from typing import Any
from uuid import UUID

import structlog

import audio_checks
from app.core.jobs.queue import Payload, job
from app.core.runtime import Runtime
from app.core.storage import BlobAltered, BlobMissing
from app.hiring.models import Sample
from app.hiring.rules import SampleState
from app.projects.queries import current_spec

TIMEOUT_S = 60.0
MEMORY_BYTES = 1 << 30
BY_NAME = frozenset({"naming"})  # a sample is not named as a delivery is
FACTS = ("code", "severity", "message", "fix")

log = structlog.get_logger(__name__)


@job("hiring.check_sample")
def check_sample(runtime: Runtime, payload: Payload) -> None:
    """Check a sample of a bid by the project's spec, in a child; or say why that cannot be."""
    sample_id = UUID(payload["sample_id"])
    with runtime.database.reading() as session:
        sample = session.get(Sample, sample_id)  # it may be removed meanwhile
        if sample is None or sample.state is not SampleState.PENDING:
            return
        session.expunge(sample)
        spec = current_spec(session, sample.project_id)
        toml, version = spec.toml, spec.version
    made = _checked(runtime, sample, toml) | {"spec_version": version}
    with runtime.database.writing() as session:
        row = session.get(Sample, sample_id, with_for_update=True)
        if row is not None and row.state is SampleState.PENDING:
            for name, value in made.items():
                setattr(row, name, value)


def _checked(runtime: Runtime, sample: Sample, toml: str) -> dict[str, Any]:
    category = sample.line_key or None
    wanted = [name for name in audio_checks.all_checks() if name not in BY_NAME]
    try:
        with (
            runtime.store.local_copy(sample.studio_id, sample.sha256) as path,
            _sandbox().child(reads=[path]) as child,
        ):
            report = child.call(
                audio_checks.check_file,
                path,
                audio_checks.parse_spec(toml),
                category=category,
                name=sample.file_name,
                checks=wanted,
            ).to_dict()
    except (audio_checks.SandboxFailed, BlobAltered, BlobMissing) as error:
        log.warning("a sample could not be checked", sample_id=str(sample.id), error=str(error))
        return {"state": SampleState.UNCHECKED, "problem": "the check failed on this file; that is not its fault"}
    findings = [{fact: finding[fact] for fact in FACTS} for finding in report["findings"]]
    if report["verdict"] == "conforming":
        return {"state": SampleState.CONFORMING, "findings": findings}
    if report["verdict"] == "rejected":
        return {"state": SampleState.RETURNED, "findings": findings}
    return {"state": SampleState.UNCHECKED, "problem": "the check could not judge this file"}


@cache
def _sandbox() -> audio_checks.Sandbox:
    return audio_checks.Sandbox(timeout_s=TIMEOUT_S, memory_bytes=MEMORY_BYTES, rehearsal=audio_checks.rehearse_check)
