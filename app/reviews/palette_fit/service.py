"""Fit with the palette: the distance of takes from approved sounds."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.deliveries.schemas import CueBrief
from app.deliveries.service import delivery_for, take_for
from app.projects.models import Project
from app.projects.rules import OPENS_APPROVED
from app.renders.queries import has_palette
from app.reviews.palette_fit import queries
from app.reviews.palette_fit.queries import Compared
from app.reviews.palette_fit.rules import (
    FEWEST,
    UNITS,
    Fit,
    FitBasis,
    Likeness,
    Measure,
    Stands,
    fit_of,
    in_words,
    middle_of,
    nearest,
    shift,
)
from app.reviews.palette_fit.schemas import (
    DeliveryFitRead,
    DeliveryShift,
    FitPoint,
    MeasureFit,
    SoundsLike,
    TakeFitRead,
)
from app.sound_lists.models import Cue
from app.sound_lists.rules import label

MOST_ALIKE = 5
NO_PALETTE = "No cue is marked as palette. Mark the reference sounds, and new sounds are compared with them."
TOO_FEW = f"Fewer than {FEWEST} other cues are approved in this category or the palette: too few to compare with."
NOT_CHECKED = "This version has not been checked, or is for no cue yet."
BEING_HEARD = " Spectrum and timbre are still being measured."


def take_fit(session: Session, actor: Actor, take_id: UUID) -> TakeFitRead:
    """Compare a take with the approved sounds of its category; for its designer with those that they may hear."""
    take, access = take_for(session, actor, take_id)
    sound = queries.take_compared(session, take_id)
    delivery, _ = delivery_for(session, actor, take.delivery_id)
    hears_all = access.only_designer_id is None or access.project.designers_hear in OPENS_APPROVED
    approved = [
        compared
        for compared in queries.approved_sounds(session, take.project_id)
        if hears_all or compared.take.designer_id == access.only_designer_id
    ]
    before = [compared for compared in approved if compared.take.designer_id != delivery.designer_id]
    first = delivery.id if before and access.is_team and queries.is_first_delivery(session, delivery) else None
    if sound is None:
        return TakeFitRead.nothing(take, NOT_CHECKED, first_delivery_id=first)
    if not has_palette(session, take.project_id):
        return TakeFitRead.nothing(take, NO_PALETTE, first_delivery_id=first)
    fit = _fit(access.project, sound, approved, first_delivery_id=first)
    return fit.model_copy(update={"sounds_like": _sounds_like(access.project, sound, approved)})


def delivery_fit(session: Session, actor: Actor, delivery_id: UUID) -> DeliveryFitRead:
    """Compare each take of a delivery with other designers' approved sounds; for the team."""
    delivery, access = delivery_for(session, actor, delivery_id)
    access.ensure_team()
    before = [
        approved_sound
        for approved_sound in queries.approved_sounds(session, delivery.project_id)
        if approved_sound.take.designer_id != delivery.designer_id
    ]
    takes = [_fit(access.project, sound, before) for sound in queries.takes_compared(session, delivery_id)]
    return DeliveryFitRead(
        delivery_id=delivery.id,
        project_id=delivery.project_id,
        number=delivery.number,
        designer=PersonBrief.model_validate(delivery.designer),
        is_first=queries.is_first_delivery(session, delivery),
        made_before_by=sorted({sound.take.designer.name for sound in before}),
        takes=takes,
        shifts=[
            DeliveryShift(measure=measure, unit=UNITS[measure], compared=len(fits), apart=apart, shift=moved)
            for measure in Measure
            if (fits := [sound for take in takes for sound in take.measures if sound.measure is measure])
            for apart, moved in [shift([(fit.value, fit.middle, fit.stands) for fit in fits])]
        ],
    )


def _fit(
    project: Project, sound: Compared, approved: Sequence[Compared], *, first_delivery_id: UUID | None = None
) -> TakeFitRead:
    """Compare one sound with the approved cues of its category, else of the palette."""
    cues = _by_cue([cue_sound for cue_sound in approved if cue_sound.cue.id != sound.cue.id])
    of_category = [cue_sound for cue_sound in cues if cue_sound[0].category == sound.cue.category]
    of_palette = [cue_sound for cue_sound in cues if cue_sound[0].palette]
    basis, others = (FitBasis.CATEGORY, of_category) if len(of_category) >= FEWEST else (FitBasis.PALETTE, of_palette)
    cue = _brief(project, sound.cue)
    if len(others) < FEWEST:
        return TakeFitRead.nothing(sound.take, TOO_FEW, cue=cue, first_delivery_id=first_delivery_id)
    fits = fit_of(sound.likeness, [likeness for _, likeness in others])
    return TakeFitRead(
        take_id=sound.take.id,
        file_name=sound.take.file_name,
        cue=cue,
        basis=basis,
        category=sound.cue.category,
        says=in_words(fits) + ("" if sound.is_analysed else BEING_HEARD),
        is_apart=any(fit.stands is not Stands.WITHIN for fit in fits.values()),
        measures=[
            _read(project, measure, fit, [cue_sound for cue_sound, _ in others]) for measure, fit in fits.items()
        ],
        first_delivery_id=first_delivery_id,
        sounds_like=[],
    )


def _sounds_like(project: Project, sound: Compared, approved: Sequence[Compared]) -> list[SoundsLike]:
    """Return the nearest sound of each other cue, as far as it is one of the nearest."""
    others = [compared for compared in approved if compared.cue.id != sound.cue.id]
    near: dict[UUID, SoundsLike] = {}
    for place, distance_db in nearest(sound.likeness, [other.likeness for other in others]):
        take, cue = others[place].take, others[place].cue
        near.setdefault(cue.id, SoundsLike(cue=_brief(project, cue), take_id=take.id, distance_db=distance_db))
    return list(near.values())[:MOST_ALIKE]


def _by_cue(sounds: Sequence[Compared]) -> list[tuple[Cue, Likeness]]:
    """Return each cue with the medians of its variations."""
    variations: dict[Cue, list[Likeness]] = {}
    for sound in sounds:
        variations.setdefault(sound.cue, []).append(sound.likeness)
    return [(cue, middle_of(likenesses)) for cue, likenesses in variations.items()]


def _read(project: Project, measure: Measure, fit: Fit, cues: Sequence[Cue]) -> MeasureFit:
    return MeasureFit(
        measure=measure,
        unit=UNITS[measure],
        value=fit.value,
        middle=fit.middle,
        lowest=fit.lowest,
        highest=fit.highest,
        stands=fit.stands,
        others=[
            FitPoint(cue=_brief(project, cue), is_palette=cue.palette, value=value)
            for cue, value in zip(cues, fit.others, strict=True)
            if value is not None
        ],
    )


def _brief(project: Project, cue: Cue) -> CueBrief:
    return CueBrief(id=cue.id, label=label(project.cue_prefix, cue.number), name=cue.name)
