"""The answer to which category a name is of."""

from pydantic import Field

from app.core.web.http import Schema


class CategoryGuess(Schema):
    """The category that a name is likely to be of."""

    category: str = Field(description="Empty where no word of it says one.")
