"""The endpoints of manifests, which a game's CI compares its build with."""

from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Query
from sqlalchemy.orm import Session

from app.accounts.rules import Actor, Audience, Scope
from app.accounts.web.policies import allows
from app.builds.endpoints import Target
from app.builds.errors import (
    BlobDamaged,
    ManifestNotReady,
    PackIncomplete,
    PackNotFound,
    PackNotSealed,
)
from app.builds.packs import manifests, sealing
from app.builds.packs import service as packs
from app.builds.packs.manifests import Approved
from app.builds.schemas import Manifest
from app.core.runtime import Runtime
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.projects.errors import ProjectNotFound, TeamNeeded
from app.renders.errors import TargetUnknown

router = APIRouter(prefix="/v1", tags=["builds"])


@router.get(
    "/projects/{project_id}/manifest.json",
    response_model=Manifest,
    responses=problems(ProjectNotFound, TeamNeeded, TargetUnknown, PackIncomplete, ManifestNotReady, BlobDamaged),
)
def get_manifest(
    project_id: UUID,
    session: DbSession,
    runtime: CurrentRuntime,
    target: Target = None,
    allow_missing: Annotated[
        bool, Query(description="Leave out accepted sounds that have no game file, as the pack does.")
    ] = False,
    actor: Actor = allows(Audience.TEAM, build=Scope.MANIFEST_READ),
) -> Manifest:
    """Return fingerprints of the approved pack's files, for `audio-checks audit`; 409 until all are computed.

    It is empty if nothing is accepted. It includes accepted placeholder files: the audit reports them as such.
    """
    pack = packs.visible_pack(session, actor, project_id, target)
    if pack.sounds:
        packs.ensure_packable(pack, allow_missing=allow_missing, placeholders=True)
    return _manifest(runtime, session, actor, manifests.approved_now(pack))


@router.get(
    "/packs/{pack_id}/manifest.json",
    response_model=Manifest,
    responses=problems(PackNotFound, TeamNeeded, PackNotSealed, ManifestNotReady, BlobDamaged),
)
def get_sealed_manifest(
    pack_id: UUID,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = allows(Audience.TEAM, build=Scope.MANIFEST_READ),
) -> Manifest:
    """Return the identifying data of the game files of a handed-out pack, for `audio-checks audit`."""
    pack = sealing.visible_sealed(session, actor, pack_id)
    sealing.ensure_sealed(pack)
    return _manifest(runtime, session, actor, manifests.approved_in_pack(session, pack))


def _manifest(runtime: Runtime, session: Session, actor: Actor, approved: Approved) -> Manifest:
    try:
        return manifests.manifest_read(session, runtime.store, approved)
    except ManifestNotReady:
        session.close()  # two connections for one request might be one too many
        with runtime.database.writing(actor.reach) as asking:
            manifests.request_fingerprints(asking, approved)
        raise
