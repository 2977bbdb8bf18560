"""What this room tells and asks the rooms above it, in its own transaction."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from uuid import UUID

from app.accounts.rules import Actor
from app.core.events import Signal
from app.core.recorded_rows import RowChanges
from app.deliveries.models import Take

Work = tuple[UUID, UUID]  # a cue, and the designer whose takes of it are meant


@dataclass(frozen=True)
class WorkDone(Signal[None]):
    """An event of a designer's work on a cue, for the record of its contract.

    `by` is the person or the build token that did it; None: the server. `rows` are the rows that it tells of.
    """

    cue_id: UUID
    designer_id: UUID
    kind: str
    facts: Mapping[str, object]
    by: UUID | None
    on_behalf_of: UUID | None = None
    rows: RowChanges | None = None


@dataclass(frozen=True)
class SourcesDue(Signal[None]):
    """The sources of an approved take go on record; a receiver refuses where its contract wants more of them."""

    take: Take


@dataclass(frozen=True)
class DownloadsClosed(Signal[dict[Work, str]]):
    """Asks for the reasons for closed files of some work, as the caller may read them."""

    actor: Actor | None
    work: Collection[Work]


@dataclass(frozen=True)
class SourceFilesAgreed(Signal[dict[Work, bool]]):
    """Asks whether contracts hand the source files of some work over; work without a contract is left out."""

    work: Collection[Work]


@dataclass(frozen=True)
class ContractsNamed(Signal[dict[UUID, str]]):
    """Asks for the short names of the contracts that ordered takes, by the take's id."""

    cue_prefix: str
    work_of: Mapping[UUID, Work]


@dataclass(frozen=True)
class ReelUpload(Signal[UUID]):
    """Asks for the studio of an upload to a designer's reel; a receiver refuses who may not add to it.

    `length` is None where the upload goes on.
    """

    actor: Actor
    roster_entry_id: UUID
    length: int | None
