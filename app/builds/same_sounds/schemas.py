"""The API's answers on a sound that another project has too."""

from uuid import UUID

from pydantic import Field

from app.core.web.http import Schema


class SameSoundRead(Schema):
    """An approved take of another project that holds the same sound."""

    take_id: UUID
    project_id: UUID
    project_name: str
    cue: str = Field(description="Label and name of its cue; the file name of a take without one.")
    version: int | None
    words: str = Field(description="How the take in question differs from it.")
    gain_db: float = Field(description="By how much the take in question is louder.")
    score: float = Field(description="0 to 1: how the two waves agree.")


class LibraryMatchRead(Schema):
    """A file of a registered sound library that holds the same sound."""

    library: str
    licence: str
    file: str
    words: str = Field(description="How the take in question differs from it.")
    gain_db: float = Field(description="By how much the take in question is louder.")
    score: float = Field(description="0 to 1: how the two waves agree.")
    is_declared: bool = Field(description="The stated sources of the take name the library.")


class SameSoundsRead(Schema):
    """The other places of a take's sound."""

    take_id: UUID
    is_compared: bool | None = Field(
        description="Whether it was compared with the studio's other projects; null for designers."
    )
    sounds: list[SameSoundRead]
    libraries: list[LibraryMatchRead]
