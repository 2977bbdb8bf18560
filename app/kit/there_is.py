"""Whether there is anything to a row, as a column beside it."""

from typing import Any

import sqlalchemy as sa


def there_is(wanted: sa.Select[*tuple[Any, ...]], beside: Any) -> sa.ColumnElement[bool]:
    """Say whether a statement finds anything for each row of a table beside it.

    Of `EXISTS` among columns PostgreSQL may gather all that could be found on the server, to look rows up in that.
    """
    one = wanted.with_only_columns(sa.true()).correlate(beside).limit(1).scalar_subquery()
    return sa.func.coalesce(one, sa.false())
