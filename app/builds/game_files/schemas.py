"""Bodies of the endpoints for `soundlist pull` and `soundlist why`."""

from uuid import UUID

from pydantic import Field

from app.core.web.http import Schema


class GameFile(Schema):
    """One approved game file of a target."""

    path: str = Field(description="In the game: the target's folder and the name that the cue owns.")
    sha256: str
    bytes: int
    sound: str = Field(description="Equal for two files with the same samples, format and loop.")
    cue: str = Field(description="The number of its cue, as in SW-014.")
    cue_name: str
    take_id: UUID
    url: str = Field(description="Where it is downloaded, by Range where a download was cut.")
    adopted_sha256: str | None = Field(description="Of the file that was adopted for it; the game may hold it still.")
    is_adopted_sound: bool = Field(description="Whether that file has the same samples as this one.")


class OpenGameFile(Schema):
    """A file that the game has no final sound for, and why."""

    path: str
    cue: str
    reason: str


class GameFilesRead(Schema):
    """The content that `soundlist pull` gives a folder."""

    project_id: UUID
    project: str
    target: str
    spec_version: int
    files: list[GameFile]
    missing: list[OpenGameFile] = Field(description="Accepted sounds without a game file that may be downloaded.")
    placeholders: list[OpenGameFile] = Field(description="Files without an accepted sound, or marked as placeholders.")


class GameFileOrigin(Schema):
    """A game file's origin: cue, approval, contract, sources."""

    path: str
    target: str
    cue: str
    cue_name: str
    variation: int
    version: int | None
    take_id: UUID
    is_current: bool = Field(description="Whether it is the accepted version now.")
    spec_version: int = Field(description="The newest version of the delivery spec.")
    approved_by: str
    approved_on: str
    designer: str
    contract: str = Field(description="Title and day of the contract that pays it, or why there is none.")
    from_scratch: str
    own_recordings: str
    libraries: str = Field(description="Library files with their licences.")
    generated: str
    performers: str
    note: str
    open_points: str
    master: str
    master_sha256: str
