"""The bodies of saved views."""

from typing import Annotated
from uuid import UUID

from pydantic import Field

from app.core.web.http import Schema
from app.shares.rules import MAX_QUERY_CHARS, ViewedPage
from app.shares.schemas import NO_NUL

ViewName = Annotated[str, Field(min_length=1, max_length=80, pattern=NO_NUL)]
Query = Annotated[str, Field(max_length=MAX_QUERY_CHARS, pattern=NO_NUL)]


class SavedViewAdd(Schema):
    """A filter to keep under a name; a view of the same name is replaced."""

    page: ViewedPage
    name: ViewName
    query: Query = Field(description="Of the page's address, without its question mark.")


class SavedViewRead(Schema):
    """A filter that the caller kept."""

    id: UUID
    page: ViewedPage
    name: str
    query: str
