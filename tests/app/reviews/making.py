"""Takes that wait for review, put there without their sounds being checked and rendered: judging needs none of it."""

from dataclasses import dataclass, field
from itertools import count
from typing import Any
from uuid import UUID

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.conformance.models import CheckRun
from app.core.db import new_id
from app.deliveries.cue_counts.service import update_take_counts
from app.deliveries.models import Delivery, Take
from app.deliveries.rules import TakeState
from app.projects.queries import current_spec
from app.renders.models import Picture, RenderSet
from app.sound_lists.models import Cue
from tests.support.server import World

FINDING = {
    "check": "true-peak",
    "code": "true-peak:over",
    "severity": "warning",
    "message": "true peak -0.6 dBTP, limit -1.0 dBTP",
    "fix": "lower the level by 0.4 dB or more",
    "measured": -0.6,
    "limit": -1.0,
    "unit": "dBTP",
    "start_s": 0.1,
    "end_s": 0.2,
}
_numbers = count(1)


@dataclass
class Stage:
    """One project with cues and takes that wait for its approver."""

    world: World
    delivery_id: UUID = field(default_factory=new_id)

    def __post_init__(self) -> None:
        world = self.world
        delivery = Delivery(
            id=self.delivery_id,
            studio_id=world.studio_id,
            project_id=world.project_id,
            designer_id=world.designer_id,
            number=1,
            note="three bowls, struck",
        )
        world.server.in_database(lambda session: session.add(delivery))

    def cue(self, name: str = "shield_hit", **facts: Any) -> UUID:
        """Put a cue on the list."""
        return self.world.server.in_database(lambda session: add_cue(session, self.world, name, **facts))

    def take(self, cue_id: UUID, variation: int = 1, **facts: Any) -> UUID:
        """Deliver a take that conforms, is drawn and rendered, or stands where `facts` say."""
        return self.world.server.in_database(
            lambda session: add_take(session, self.world, self.delivery_id, cue_id, variation, **facts)
        )

    def states(self, *take_ids: UUID) -> list[str]:
        """Return where takes stand."""

        def read(session: Session) -> list[str]:
            return [session.get_one(Take, take_id).state.value for take_id in take_ids]

        return self.world.server.in_database(read)

    def verdict(self, take_id: UUID, kind: str, **more: Any) -> Any:
        """Give a verdict as the approver."""
        return self.world.approver.post(f"/v1/takes/{take_id}/verdict", json={"kind": kind, **more})

    def approve(self, take_id: UUID, **more: Any) -> dict[str, Any]:
        """Approve a take, and return the answer."""
        return body_of(self.verdict(take_id, "approve", **more))

    def draft(self, take_id: UUID, note: str = "a duller clank", **more: Any) -> dict[str, Any]:
        """Note a change, and return the draft."""
        body: dict[str, Any] = body_of(self.verdict(take_id, "request_change", note=note, **more))["draft"]
        return body

    def send(self, note: str = "") -> dict[str, Any]:
        """Send all drafts."""
        answer = self.world.approver.post(f"/v1/projects/{self.world.project_id}/feedback", json={"note": note})
        assert answer.status_code == 201, answer.text
        body: dict[str, Any] = answer.json()
        return body

    def undo(self, take_id: UUID) -> Any:
        """Take back what was last decided of a take."""
        return self.world.approver.delete(f"/v1/takes/{take_id}/verdict")

    def queue(self) -> list[dict[str, Any]]:
        """Return what waits in this project."""
        answer = self.world.approver.get("/v1/review-queue", params={"project_id": str(self.world.project_id)})
        assert answer.status_code == 200, answer.text
        items: list[dict[str, Any]] = answer.json()["items"]
        return items

    def waiting(self) -> set[str]:
        """Return the ids of the takes that wait."""
        return {take["id"] for item in self.queue() for take in item["takes"]}

    def review(self, cue_id: UUID) -> dict[str, Any]:
        """Return everything that the review room shows of a cue."""
        return body_of(self.world.reviewer.get(f"/v1/cues/{cue_id}/review"))


def body_of(answer: Any) -> dict[str, Any]:
    """Return the body of an answer that grants what was asked."""
    assert answer.status_code == 200, answer.text
    body: dict[str, Any] = answer.json()
    return body


def refused(answer: Any) -> tuple[int, str]:
    """Return how a request was refused."""
    return answer.status_code, answer.json()["code"]


def add_cue(session: Session, world: World, name: str, **facts: Any) -> UUID:
    """Add a cue's row."""
    number = next(_numbers)
    cue = Cue(
        studio_id=world.studio_id, project_id=world.project_id, number=number, position=number, name=name, **facts
    )
    session.add(cue)
    session.flush()
    return cue.id


def add_take(
    session: Session, world: World, delivery_id: UUID, cue_id: UUID | None, variation: int, **facts: Any
) -> UUID:
    """Add a take's row, and those of what was made for it."""
    numbers = session.scalars(select(Take.number).where(Take.cue_id == cue_id, Take.variation == variation)).all()
    sha256 = facts.pop("master_sha256", f"{new_id().hex}{new_id().hex}")
    is_drawn, is_rendered = facts.pop("is_drawn", True), facts.pop("is_rendered", True)
    take = Take(
        studio_id=world.studio_id,
        project_id=world.project_id,
        delivery_id=delivery_id,
        cue_id=cue_id,
        variation=variation,
        number=1 + max((number for number in numbers if number), default=0) if cue_id else None,
        master_sha256=sha256,
        master_bytes=1_000,
        **{
            "state": TakeState.CONFORMING,
            "file_name": "shield_hit.wav",
            "designer_id": world.designer_id,
            **facts,
        },
    )
    session.add(take)
    session.flush()
    update_take_counts(session, cue_id)
    spec = current_spec(session, world.project_id)
    if is_drawn:
        session.add(Picture(studio_id=world.studio_id, sound_sha256=sha256, duration_s=0.84))
    if is_rendered:
        session.add(RenderSet(take_id=take.id, studio_id=world.studio_id, spec_id=spec.id, edition=take.edition or 1))
    measurements = {"integrated_lufs": None, "short_loudness_lufs": -14.2, "sample_peak_dbfs": -0.9}
    session.add(
        CheckRun(
            studio_id=world.studio_id,
            project_id=world.project_id,
            take_id=take.id,
            spec_id=spec.id,
            key=sha256,
            verdict="conforming",
            report={
                "path": "sound.wav",
                "verdict": "conforming",
                "facts": {"sample_rate_hz": 96_000},
                "measurements": {**measurements, "true_peak_dbtp": -0.6},
                "findings": [FINDING],
            },
            tool_version="1",
        )
    )
    return take.id
