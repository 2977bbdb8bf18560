"""Fit with the palette: how far takes stand from what was approved before."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.deliveries.schemas import CueBrief
from app.deliveries.service import delivery_for, take_for
from app.projects.models import Project
from app.renders.queries import has_palette
from app.reviews import fit_queries as queries
from app.reviews.fit_queries import Compared
from app.reviews.fit_rules import (
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
    shift,
)
from app.reviews.schemas import DeliveryFitRead, DeliveryShift, FitPoint, MeasureFit, TakeFitRead
from app.sound_lists.models import Cue
from app.sound_lists.rules import label

NO_PALETTE = "The list marks no cue as the palette. Mark those that set the tone, and sounds are compared."
TOO_FEW = f"Fewer than {FEWEST} other cues are approved, in this category or in the palette: there is no middle yet."
NOT_CHECKED = "This version has not been checked, or is for no cue yet."
BEING_HEARD = " Spectrum and timbre are still being measured."


def take_fit(session: Session, actor: Actor, take_id: UUID) -> TakeFitRead:
    """Return how a take lies among the approved sounds of its category; for the team."""
    take, standing = take_for(session, actor, take_id)
    standing.ensure_team()
    sound = queries.take_compared(session, take_id)
    delivery, _ = delivery_for(session, actor, take.delivery_id)
    approved = queries.approved_sounds(session, take.project_id)
    before = [one for one in approved if one.take.designer_id != delivery.designer_id]
    first = delivery.id if before and queries.is_first_delivery(session, delivery) else None
    if sound is None:
        return TakeFitRead.nothing(take, NOT_CHECKED, first_delivery_id=first)
    if not has_palette(session, take.project_id):
        return TakeFitRead.nothing(take, NO_PALETTE, first_delivery_id=first)
    return _fit(standing.project, sound, approved, first_delivery_id=first)


def delivery_fit(session: Session, actor: Actor, delivery_id: UUID) -> DeliveryFitRead:
    """Return how each take of a delivery lies among what other designers made and was approved; for the team."""
    delivery, standing = delivery_for(session, actor, delivery_id)
    standing.ensure_team()
    before = [
        one
        for one in queries.approved_sounds(session, delivery.project_id)
        if one.take.designer_id != delivery.designer_id
    ]
    takes = [_fit(standing.project, one, before) for one in queries.takes_compared(session, delivery_id)]
    return DeliveryFitRead(
        delivery_id=delivery.id,
        project_id=delivery.project_id,
        number=delivery.number,
        designer=PersonBrief.model_validate(delivery.designer),
        is_first=queries.is_first_delivery(session, delivery),
        made_before_by=sorted({one.take.designer.name for one in before}),
        takes=takes,
        shifts=[
            DeliveryShift(measure=measure, unit=UNITS[measure], compared=len(fits), apart=apart, shift=moved)
            for measure in Measure
            if (fits := [one for take in takes for one in take.measures if one.measure is measure])
            for apart, moved in [shift([(one.value, one.middle, one.stands) for one in fits])]
        ],
    )


def _fit(
    project: Project, sound: Compared, approved: Sequence[Compared], *, first_delivery_id: UUID | None = None
) -> TakeFitRead:
    """Return where one sound lies among the approved cues of its category, else of the palette."""
    cues = _by_cue([one for one in approved if one.cue.id != sound.cue.id])
    of_category = [one for one in cues if one[0].category == sound.cue.category]
    of_palette = [one for one in cues if one[0].palette]
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
        says=in_words(fits) + ("" if sound.is_heard else BEING_HEARD),
        is_apart=any(fit.stands is not Stands.WITHIN for fit in fits.values()),
        measures=[_read(project, measure, fit, [one for one, _ in others]) for measure, fit in fits.items()],
        first_delivery_id=first_delivery_id,
    )


def _by_cue(sounds: Sequence[Compared]) -> list[tuple[Cue, Likeness]]:
    """Return each cue with what lies in the middle of its variations."""
    variations: dict[Cue, list[Likeness]] = {}
    for one in sounds:
        variations.setdefault(one.cue, []).append(one.likeness)
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
