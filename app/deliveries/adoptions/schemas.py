"""The bodies of adoptions."""

from datetime import datetime
from typing import Annotated, Literal
from uuid import UUID

from pydantic import Field, StringConstraints

from app.accounts.schemas import PersonBrief
from app.core.web.http import Schema

MAX_FILES = 10_000
MAX_PATH_CHARS = 500
NO_CONTROLS = r"^[^\x00-\x1f\x7f]*$"
Path = Annotated[str, StringConstraints(min_length=1, max_length=MAX_PATH_CHARS, pattern=NO_CONTROLS)]


class ShippedFileIn(Schema):
    """A file of the folder, as the client found it."""

    path: Path = Field(description="Relative to the folder.", examples=["ui/click.wav"])
    sha256: Annotated[str, StringConstraints(min_length=64, max_length=64)] = Field(description="In hex.")
    size_bytes: int = Field(ge=0, le=2**53 - 1)
    sample_rate_hz: int | None = Field(default=None, ge=1, le=10_000_000, description="As its header says.")
    bit_depth: int | None = Field(default=None, ge=1, le=64)


class GameProjectIn(Schema):
    """The texts of the game's middleware or engine project."""

    path: Annotated[str, StringConstraints(max_length=MAX_PATH_CHARS, pattern=NO_CONTROLS)] = Field(
        description="The project's file from its root: a .wproj, a .fspro, project.godot, or what export_sounds.py "
        "wrote; empty for a Unity project.",
        examples=["Game.wproj"],
    )
    content_base64: str = Field(
        max_length=12 << 20, description="A gzip of a JSON object: the texts by their paths from the project's root."
    )


class FolderAsk(Schema):
    """A folder of shipped files."""

    folder: Annotated[str, StringConstraints(min_length=1, max_length=200, pattern=NO_CONTROLS)] = Field(
        description="Its name.", examples=["Sounds"]
    )
    files: Annotated[list[ShippedFileIn], Field(min_length=1, max_length=MAX_FILES)]
    project: GameProjectIn | None = Field(default=None, description="What plays the files, where it is to be read.")


class PlannedCue(Schema):
    """A cue that adopting adds."""

    name: str
    file_name: str
    category: str
    paths: list[str] = Field(description="A file for each variation, in order.")
    loop: bool = Field(description="Whether the game's project plays it in a loop.")
    events: list[str] = Field(description="What begins it in the game's project.")


class OddFile(Schema):
    """A file with something unusual, and what."""

    path: str
    code: Literal["renamed", "numbering", "format", "unused"]
    message: str


class SkippedFileRead(Schema):
    """A file that is not adopted, and why."""

    path: str
    code: Literal["coded", "no-sound", "dry-stem", "name", "listed"]
    message: str


class ReadProject(Schema):
    """The facts read of the game's project."""

    name: str
    engine: Literal["wwise", "fmod", "unity", "unreal", "godot"]
    version: str
    played: int = Field(description="The number of adopted files that it plays.")
    unread_count: int = Field(description="The number of its files that could not be read.")
    unread: list[str] = Field(description="The first 20 of these, with the reason.")


class AdoptionPlanRead(Schema):
    """The effects of adopting a folder."""

    cues: list[PlannedCue]
    files: int = Field(description="The number of files that are adopted.")
    sets: int = Field(description="The number of cues with more than one file.")
    categories: dict[str, int] = Field(description="The number of cues of each category.")
    duplicates: list[list[str]] = Field(description="Adopted files with the same bytes.")
    oddities: list[OddFile]
    skipped: list[SkippedFileRead]
    project: ReadProject | None = Field(description="Null where no project was sent.")


class AdoptionRead(Schema):
    """An adoption: opened, adopted or undone."""

    id: UUID
    project_id: UUID
    folder: str
    created_at: datetime
    adopted_by: PersonBrief | None
    adopted_at: datetime | None
    undone_at: datetime | None


class AdoptionOpened(AdoptionRead):
    """An adoption with its plan, and what is still to be uploaded."""

    plan: AdoptionPlanRead
    missing: list[str] = Field(description="A path of each content that is not uploaded yet.")


class AdoptedSound(Schema):
    """An adopted sound whose check found something."""

    cue_id: UUID
    take_id: UUID
    label: str
    file_name: str
    verdict: str
    messages: list[str]


class AdoptionProgress(AdoptionRead):
    """An adoption, and how far the checks of what it adopted are."""

    takes: int
    checked: int
    conforming: int
    rendered: int = Field(description="Takes whose game files are made or refused.")
    odd: list[AdoptedSound] = Field(description="The first 200 sounds that do not conform or have a warning.")


class Adopted(AdoptionRead):
    """The results of one adoption."""

    cues: int
    takes: int
    skipped: list[SkippedFileRead]
