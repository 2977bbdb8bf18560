"""Requests and answers of the API on sound libraries."""

from datetime import datetime
from typing import Annotated
from uuid import UUID

from pydantic import Field, StringConstraints

from app.accounts.schemas import PersonBrief
from app.core.web.http import Schema

LIBRARY_BODY_BYTES = 32 << 20  # some 70 minutes of sound
MAX_NAME_CHARS = 200
MAX_LICENCE_CHARS = 500
LibraryName = Annotated[
    str, StringConstraints(strip_whitespace=True, min_length=1, max_length=MAX_NAME_CHARS, pattern="^[^\\x00-\\x1f]+$")
]
Licence = Annotated[
    str, StringConstraints(strip_whitespace=True, max_length=MAX_LICENCE_CHARS, pattern="^[^\\x00-\\x1f]*$")
]


class LibrarySheetAdd(Schema):
    """A sheet of fingerprints of a library's files."""

    name: LibraryName = Field(description="Of the library, as sources are declared by it.")
    licence: Licence = ""
    content_base64: str = Field(description="What `audio-checks manifest FOLDER` wrote, in Base64.")


class SoundLibraryRead(Schema):
    """A sound library that takes are compared with."""

    id: UUID
    name: str
    licence: str
    sounds: int
    person: PersonBrief = Field(description="Who registered it.")
    added_at: datetime = Field(description="When its newest sheet came.")
    may_remove: bool
