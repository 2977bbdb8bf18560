"""The sources of takes: stated by their designers, for a whole delivery or one take, on record once accepted."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.schemas import PersonBrief
from app.core import clock
from app.core.errors import FieldProblem
from app.core.events import send
from app.deliveries import queries
from app.deliveries.errors import NoSourceNamed, SourcesFixed, SourcesMissing
from app.deliveries.models import Delivery, SourceStatement, Take
from app.deliveries.rules import TakeState
from app.deliveries.schemas import DeliverySources, Sources, SourcesRead, TakeSources
from app.deliveries.service import delivery_for, ensure_own_designer, own_delivery, take_for
from app.deliveries.signals import SourcesDue
from app.deliveries.sources import queries as source_queries
from app.deliveries.sources.statements import open_points, says_something, words_of, words_of_points
from app.deliveries.take_states import note_take

NAMED = 3  # sounds that a refusal names


def state_delivery_sources(session: Session, actor: Actor, delivery_id: UUID, sources: Sources) -> DeliverySources:
    """State the sources of a delivery: they hold for each of its takes that has no statement of its own."""
    delivery, _ = own_delivery(session, actor, delivery_id)
    _state(session, delivery, None, sources)
    for take in queries.takes_in(session, delivery_id):
        if (
            take.state is TakeState.APPROVED
            and source_queries.source_statement_of(session, delivery_id, take.id) is None
        ):
            record_sources(session, take)
    return delivery_sources(session, actor, delivery_id)


def state_take_sources(session: Session, actor: Actor, take_id: UUID, sources: Sources) -> TakeSources:
    """State the sources of one take, as its designer; raise SourcesFixed once it is approved and they are complete."""
    take, access = take_for(session, actor, take_id, locked=True)
    ensure_own_designer(access, take)
    is_approved = take.state is TakeState.APPROVED
    if is_approved and not open_points(sources_of(session, [take]).get(take_id)):
        raise SourcesFixed(
            "this version is approved, and its sources are on record with it",
            fix="ask the approver to request a change, or deliver another version",
        )
    delivery, _ = delivery_for(session, actor, take.delivery_id)
    _state(session, delivery, take.id, sources)
    if is_approved:
        record_sources(session, take)
    return take_sources(session, actor, take_id)


def _state(session: Session, delivery: Delivery, take_id: UUID | None, sources: Sources) -> None:
    if not says_something(sources):
        raise NoSourceNamed(
            "no source is named",
            fix="say what it was made from: from scratch, own recordings, a library, a generated part, a performer",
        )
    statement = source_queries.source_statement_of(session, delivery.id, take_id) or SourceStatement(
        studio_id=delivery.studio_id,
        project_id=delivery.project_id,
        delivery_id=delivery.id,
        take_id=take_id,
        designer_id=delivery.designer_id,
    )
    statement.sources, statement.stated_at = sources.model_dump(), clock.now()
    session.add(statement)
    session.flush()


def delivery_sources(session: Session, actor: Actor, delivery_id: UUID) -> DeliverySources:
    """Return the stated sources of a delivery and of each of its takes."""
    delivery, access = delivery_for(session, actor, delivery_id)
    stated = source_queries.source_statement_of(session, delivery_id, None)
    remembered = None
    if access.actor.person_id == delivery.designer_id:
        remembered = source_queries.last_source_statement(session, delivery.studio_id, delivery.designer_id)
    takes = queries.takes_in(session, delivery_id)
    return DeliverySources(
        delivery_id=delivery_id,
        stated=_read(stated) if stated else None,
        remembered=sources_in(remembered) if remembered else None,
        takes=_takes_read(session, takes),
    )


def take_sources(session: Session, actor: Actor, take_id: UUID) -> TakeSources:
    """Return the stated sources of a take that the caller sees."""
    take, _ = take_for(session, actor, take_id)
    (read,) = _takes_read(session, [take])
    return read


def sources_in(statement: SourceStatement) -> Sources:
    """Return the sources in a statement."""
    return Sources.model_validate(statement.sources)


def sources_of(session: Session, takes: Sequence[Take]) -> dict[UUID, Sources]:
    """Return the stated sources of takes; those without a statement are left out."""
    statements = source_queries.source_statements(session, [take.id for take in takes])
    return {take_id: sources_in(statement) for take_id, statement in statements.items()}


def _takes_read(session: Session, takes: Sequence[Take]) -> list[TakeSources]:
    statements = source_queries.source_statements(session, [take.id for take in takes])
    return [_take_read(take, statements.get(take.id)) for take in takes]


def _take_read(take: Take, statement: SourceStatement | None) -> TakeSources:
    points = open_points(sources_in(statement) if statement else None)
    return TakeSources(
        take_id=take.id,
        stated=_read(statement) if statement else None,
        is_own=statement is not None and statement.take_id is not None,
        is_fixed=take.state is TakeState.APPROVED and not points,
        open_points=[words_of_points([point]) for point in points],
    )


def _read(statement: SourceStatement) -> SourcesRead:
    sources = sources_in(statement)
    return SourcesRead(
        sources=sources,
        stated_at=statement.stated_at,
        stated_by=PersonBrief.model_validate(statement.designer),
        words=words_of(sources),
    )


def record_sources(session: Session, take: Take) -> None:
    """Record the sources of an approved take in its contract; complete ones are its own from then on.

    Raises SourcesMissing where the contract asks for them before acceptance and they are not all stated.
    """
    send(session, SourcesDue(take))
    statement = source_queries.source_statements(session, [take.id]).get(take.id)
    if statement is None:
        return
    sources = sources_in(statement)
    if statement.take_id is None and not open_points(sources):
        session.add(
            SourceStatement(
                studio_id=take.studio_id,
                project_id=take.project_id,
                delivery_id=take.delivery_id,
                take_id=take.id,
                designer_id=take.designer_id,
                sources=statement.sources,
                stated_at=statement.stated_at,
            )
        )
        session.flush()
    note_take(session, take, "sources", {"sources": words_of(sources)}, by=take.designer_id)


def ensure_stated(session: Session, takes: Sequence[Take]) -> None:
    """Raise SourcesMissing unless the sources of takes are all stated, as their contract wants."""
    stated = sources_of(session, takes)
    missing = {take: points for take in takes if (points := open_points(stated.get(take.id)))}
    if not missing:
        return
    errors: list[FieldProblem] = [
        {"where": f"takes.{take.id}", "message": f"{take.file_name}: {words_of_points(points)}"}
        for take, points in missing.items()
    ]
    named = "; ".join(error["message"] for error in errors[:NAMED])
    more = f"; and {len(errors) - NAMED} more" if len(errors) > NAMED else ""
    raise SourcesMissing(
        f"the contract wants the sources of every sound first: {named}{more}",
        errors=errors,
        fix="have the designer state them with the delivery, or with the version",
    )
