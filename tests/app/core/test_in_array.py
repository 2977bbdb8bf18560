"""Whether a column is among values: on both databases, in one statement for any number of them."""

from typing import Any

import pytest
import sqlalchemy as sa

from app.accounts.models import Person
from app.core.db import Database, new_id
from app.core.in_array import in_array
from benchmarks.plans import heard
from tests.support.server import World

pytestmark = pytest.mark.both_databases


@pytest.fixture
def database(world: World) -> Database:
    return world.server.runtime.database


def test_it_finds_those_and_no_others(world: World, database: Database):
    with database.reading() as session:
        people = session.execute(sa.select(Person.id, Person.email).limit(3)).all()
        ids, emails = [row.id for row in people], [row.email for row in people]
        assert len(ids) == 3
        assert set(session.scalars(sa.select(Person.id).where(in_array(Person.id, [*ids[:2], new_id()])))) == set(
            ids[:2]
        )
        assert session.scalars(
            sa.select(Person.email).where(in_array(Person.email, {emails[2], "'\"{,}\\"}))
        ).all() == [emails[2]]
        assert session.scalars(sa.select(Person.id).where(in_array(Person.id, []))).all() == []
        others = sa.select(sa.func.count()).where(~in_array(Person.id, ids), in_array(Person.id, ids))
        assert session.scalar(others) == 0


@pytest.mark.parametrize("ask", [lambda many: in_array(Person.id, many), lambda many: ~in_array(Person.id, many)])
def test_any_number_of_values_is_the_same_statement(database: Database, ask: Any):
    with heard(database.engine) as statements, database.reading() as session:
        for many in (0, 1, 700):
            session.scalars(sa.select(Person.id).where(ask([new_id() for _ in range(many)]))).all()
    assert len({text for text, _ in statements if text.startswith("SELECT accounts_people.id")}) == 1
