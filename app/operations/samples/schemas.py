"""Bodies about the sample project."""

from uuid import UUID

from app.core.web.http import Schema


class SampleProjectRead(Schema):
    """The sample project of a studio."""

    id: UUID
    name: str
