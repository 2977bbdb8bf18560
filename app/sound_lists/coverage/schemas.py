"""The answer of the list held against the brief."""

from pydantic import Field

from app.core.web.http import Schema


class CoverageRead(Schema):
    """The brief's items that the list lacks."""

    scenes_without_ambience: list[str]
    silent_scenes: list[str] = Field(description="Scenes with neither ambience nor music in the brief.")
    categories_without_cue: list[str]
    priority_without_cue: list[str]
    priority_as_wish: list[str] = Field(description="Priority sounds of which every cue is a wish.")
