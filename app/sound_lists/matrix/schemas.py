"""The answer to a line that makes several cues."""

from pydantic import Field

from app.core.web.http import Schema


class MatrixRow(Schema):
    """A cue that the line makes, under the name that the project's spec asks for."""

    name: str
    file_name: str = Field(description="Empty where it is that of the name.")
    stems: list[str] = Field(description="The file names, without ending, that its variations will own.")
    variations: int
    owner: str | None = Field(description="The cue that owns one of these file names already; null for none.")


class MatrixRead(Schema):
    """The cues that a line makes; nothing is added."""

    rows: list[MatrixRow]
