"""Bodies and answers of budgets."""

from typing import Annotated

from pydantic import Field, StringConstraints

from app.core.web.http import LARGEST_NUMBER, Schema

Currency = Annotated[str, StringConstraints(strip_whitespace=True, pattern="^[A-Z]{3}$")]


class BudgetSet(Schema):
    """A project's permitted cost in one currency."""

    currency: Currency
    amount_minor: Annotated[int, Field(ge=1, le=LARGEST_NUMBER)] | None = Field(
        description="In whole minor units; null removes the budget of this currency."
    )


class BudgetRead(Schema):
    """A budget of a project."""

    currency: str
    amount_minor: int
