"""Bodies about starter kits."""

from uuid import UUID

from pydantic import Field

from app.core.web.http import Schema


class UsualRange(Schema):
    """From and to: a guess, until the studio has a history of its own."""

    low: int
    high: int


class KitRead(Schema):
    """A kind of game to start a list from."""

    key: str
    name: str
    about: str
    cues: int
    files: int = Field(description="Variations counted.")
    categories: dict[str, int] = Field(description="Cues by category.")
    usual_cues: UsualRange
    usual_hours: UsualRange
    usual_memory_mb: UsualRange


class KitRow(Schema):
    """A cue of a kit as it would be added, under the name that the project's spec asks for."""

    name: str
    file_name: str
    category: str
    description: str
    use: str
    duration_s: float
    loop: bool
    variations: int
    is_listed: bool = Field(description="The list has a cue with this file name already.")


class KitRows(Schema):
    """The cues of a kit, for one project."""

    key: str
    name: str
    rows: list[KitRow]


class AdditionUndo(Schema):
    """The cues whose addition is undone: all that the newest revision added."""

    cue_ids: list[UUID] = Field(min_length=1, max_length=1000)
