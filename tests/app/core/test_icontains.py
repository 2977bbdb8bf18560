"""Whether a text holds a word: on both databases, as it is typed."""

import pytest
import sqlalchemy as sa
from sqlalchemy.dialects import postgresql

from app.core.db import Database
from app.core.icontains import icontains
from tests.support.server import World

pytestmark = pytest.mark.both_databases

TEXT = "Door Step 100% wet_in C:\\fx, ÜBER Zürich"


@pytest.fixture
def database(world: World) -> Database:
    return world.server.runtime.database


@pytest.mark.parametrize(
    ("word", "is_there"),
    [
        *(("step", True), ("DOOR", True), ("oor s", True), ("steps", False), ("", True)),
        *(("0%", True), ("%s", False), ("t_i", True), ("d__r", False), ("C:\\F", True), ("\\\\", False)),
        *(("zürich", True), ("ÜBER", True), ("über", True), ("zurich", False)),
    ],
)
def test_it_finds_what_is_typed_in_whatever_case(database: Database, word: str, *, is_there: bool):
    if word == "über":
        is_there = not database.is_sqlite  # which knows the case of ASCII alone
    with database.reading() as session:
        assert bool(session.scalar(sa.select(icontains(sa.literal(TEXT), word)))) is is_there


@pytest.mark.parametrize(("word", "bytewise"), [("zip", True), ("Zürich", False)])
def test_postgresql_folds_the_letters_of_all_languages_only_where_they_are_asked_for(word: str, *, bytewise: bool):
    asked = icontains(sa.column("text", sa.String()), word).compile(dialect=postgresql.dialect())
    assert ('COLLATE "C"' in str(asked)) is bytewise
