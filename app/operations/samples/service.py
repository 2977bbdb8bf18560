"""Making and deleting the sample project of a studio."""

import hashlib
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.rules import Actor
from app.accounts.service import ensure_producer_of
from app.briefs.service import NewAnswer, change_answers
from app.core import clock
from app.core.db import bypass_row_policies, new_id
from app.core.storage import Store
from app.core.uploads import FinishedUpload, Upload
from app.deliveries import service as deliveries
from app.operations.erasure.service import erase_project
from app.operations.errors import NotASample
from app.operations.samples.cues import BRIEF, DELIVERY_NOTE, DESCRIPTION, PROJECT_NAME, sample_cues
from app.operations.samples.sounds import SOUNDS, sample_master
from app.projects.models import Engagement, Project
from app.projects.queries import sample_of_studio
from app.projects.rules import EngagementKind
from app.projects.service import create_project, project_access
from app.sound_lists.schemas import CueAdd
from app.sound_lists.service import add_cues


def open_sample(session: Session, actor: Actor, studio_id: UUID, store: Store) -> Project:
    """Return the sample project of a studio, made now where there is none; the caller is its in-house designer."""
    ensure_producer_of(session, actor, studio_id)
    sample = sample_of_studio(session, studio_id)
    if sample is not None:
        return sample
    sample = create_project(
        session, actor, studio_id, name=PROJECT_NAME, description=DESCRIPTION, cue_prefix="SA", preset="48k"
    )
    sample.is_sample = True
    answers = {key: NewAnswer(value=value, is_unknown=False, note="") for key, value in BRIEF.items()}
    change_answers(session, actor, sample.id, revision=0, changes=answers)
    add_cues(session, actor, sample.id, [CueAdd(**cue).model_dump() for cue in sample_cues()])
    designer = session.get_one(Person, actor.person)
    session.add(Engagement(studio_id=studio_id, project_id=sample.id, designer=designer, kind=EngagementKind.IN_HOUSE))
    session.flush()
    _deliver(session, actor, sample, store)
    return sample


def delete_sample(session: Session, actor: Actor, project_id: UUID) -> None:
    """Delete a sample project with everything in it, at once; raise NotASample for any other project."""
    access = project_access(session, actor, project_id)
    access.ensure_producer()
    if not access.project.is_sample:
        raise NotASample(
            f"{access.project.name} is not the sample project",
            fix="erase a project on its settings page, where it can be cancelled for some days",
        )
    with bypass_row_policies(session):
        erase_project(session, project_id)


def _deliver(session: Session, actor: Actor, sample: Project, store: Store) -> None:
    opened = deliveries.open_delivery(session, actor, sample.id, DELIVERY_NOTE)
    delivery, access = deliveries.own_delivery(session, actor, opened.id)
    for name in SOUNDS:
        content, now = sample_master(name), clock.now()
        upload = Upload(
            id=new_id(),
            studio_id=sample.studio_id,
            owner_id=deliveries.uploader(actor),
            scope=str(delivery.id),
            file_name=f"{name}.wav",
            length=len(content),
            sha256=hashlib.sha256(content).hexdigest(),
            created_at=now,
            finished_at=now,
        )
        session.add(upload)
        session.flush()
        finished = FinishedUpload(upload.id, upload.file_name, str(upload.sha256), upload.length)
        deliveries.receive_take(session, access, delivery, upload=finished, file_name=upload.file_name)
        store.put(sample.studio_id, [content])  # before the commit, so that no row names bytes not stored
    deliveries.close_delivery(session, actor, delivery.id)
