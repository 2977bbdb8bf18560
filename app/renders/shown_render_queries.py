"""Renders and drawings for a page of many takes, read in a few columns."""

from collections.abc import Collection, Mapping
from functools import cache
from typing import Any, NamedTuple
from uuid import UUID

from sqlalchemy import Select, and_, select
from sqlalchemy.orm import Session

from app.core.in_array import in_array
from app.deliveries.models import Take
from app.projects.models import Spec
from app.renders.models import Picture, Render
from app.renders.queries import current
from app.renders.rules import RenderState

LEVELS = tuple(
    Render.measurements[name].as_float() for name in ("true_peak_dbtp", "integrated_lufs", "short_loudness_lufs")
)
PICTURE = (Picture.id, Picture.duration_s, Picture.peaks_sha256, Picture.spectrum_sha256, Picture.preview_sha256)


class ShownPicture(NamedTuple):
    """The drawings of a sound, without its thumb."""

    id: UUID
    duration_s: float | None
    peaks_sha256: str | None
    spectrum_sha256: str | None
    preview_sha256: str | None

    @classmethod
    def read(cls, id_: UUID | None, *more: Any) -> "ShownPicture | None":
        """Return the columns of an outer join; None if nothing was drawn."""
        return None if id_ is None else cls(id_, *more)


class ShownRender(NamedTuple):
    """A game file of a take, or why there is none."""

    id: UUID
    state: RenderState
    refusal: str | None
    attenuation_db: float | None
    true_peak_dbtp: float | None
    integrated_lufs: float | None
    short_loudness_lufs: float | None
    picture: ShownPicture | None


FACTS = len(ShownRender._fields) - 1  # columns before those of the picture


def shown_renders(
    session: Session, specs: Mapping[UUID, Spec], takes: Collection[Take]
) -> dict[UUID, dict[str, ShownRender | None]]:
    """Return the current render of each target of the newest spec, by take (its cue loaded); None: not made yet."""
    rows = session.execute(_shown_renders(), {"take_ids": [take.id for take in takes]})
    stored = {
        (take_id, target, key): ShownRender._make((*facts[:FACTS], ShownPicture.read(*facts[FACTS:])))
        for take_id, target, key, *facts in rows
    }
    return current(specs, takes, stored)


@cache  # built once: that takes longer than to send it
def _shown_renders() -> Select[*tuple[Any, ...]]:
    names = (Render.take_id, Render.target, Render.key)
    facts = (Render.id, Render.state, Render.refusal, Render.attenuation_db, *LEVELS)
    drawn = and_(Picture.studio_id == Render.studio_id, Picture.sound_sha256 == Render.sha256)
    return select(*names, *facts, *PICTURE).outerjoin(Picture, drawn).where(in_array(Render.take_id, "take_ids"))
