"""Whether rows exist, as a column of a query."""

from typing import Any

import sqlalchemy as sa


def row_exists(rows: sa.Select[*tuple[Any, ...]], outer: Any) -> sa.ColumnElement[bool]:
    """Return a boolean column: whether `wanted` finds a row for each row of `outer`.

    For `EXISTS` as a column PostgreSQL may hash every row of the inner table; a subquery with a limit looks rows up.
    """
    first_row = rows.with_only_columns(sa.true()).correlate(outer).limit(1).scalar_subquery()
    return sa.func.coalesce(first_row, sa.false())
