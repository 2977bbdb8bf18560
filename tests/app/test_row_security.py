"""The second lock: with the first taken away, PostgreSQL still shows each tenant their own rows and no others."""

from collections.abc import Iterator
from datetime import UTC, date, datetime, time
from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa
from psycopg import sql
from sqlalchemy.orm import Session

from app import tables  # noqa: F401
from app.accounts.rules import MembersSee
from app.core.access_scope import NOBODY, AccessScope
from app.core.db import Base, Database, UtcDateTime, bypass_row_policies, new_id, set_access_scope
from app.migrate import migrate
from app.row_security import (
    ADD_ONLY,
    DESIGNERS_READ,
    NEVER_ALTERED,
    PERSONAL,
    READ_ONLY,
    SERVERS_OWN,
    TEAMS_OWN,
    UNGUARDED,
    condition,
)
from app.shares.rules import ViewedPage
from tests.support.postgres import Postgres

GUARDED = sorted(set(Base.metadata.tables) - UNGUARDED - ADD_ONLY - SERVERS_OWN)
TENANT = sorted(set(GUARDED) - PERSONAL)
CONFIDENTIAL = {
    "accounts_invoice_details",
    "hiring_bids",
    "hiring_samples",
    "references_openings",
    "shares_saved_views",
    "shares_playlist_positions",
    *("builds_sound_libraries", "builds_library_sounds"),
    *TEAMS_OWN,
}  # an engagement alone does not show them
HERE, THERE = new_id(), new_id()  # two studios
PROJECTS = {HERE: (new_id(), new_id()), THERE: (new_id(),)}
MEMBER, DESIGNER, ELSEWHERE = new_id(), new_id(), new_id()
READERS = {
    "a member": AccessScope(person_id=MEMBER),
    "an engaged designer": AccessScope(person_id=DESIGNER),
    "a build": AccessScope(project_id=PROJECTS[HERE][0]),
}


def row_of(table: sa.Table, studio_id: UUID, project_id: UUID) -> dict[str, Any]:
    """Return a row of any table that belongs to a studio and one of its projects; the rest of it is made up."""
    made_up: dict[type, Any] = {UUID: new_id(), int: 1, bool: False, float: 1.0, bytes: b"sound", dict: {}, list: []}
    made_up |= {date: date(2026, 11, 20), time: time(8)}
    row: dict[str, Any] = {}
    for column in table.columns:
        if isinstance(column.type, UtcDateTime):
            value: Any = datetime.now(UTC)
        elif isinstance(column.type, sa.Enum):
            value = next(iter(column.type.enum_class or column.type.enums))
        else:
            value = made_up.get(column.type.python_type, str(new_id()))
        row[column.name] = None if column.nullable else value
    row |= {name: value for name, value in (("studio_id", studio_id), ("project_id", project_id)) if name in row}
    if table.name == "projects_projects":
        row["id"] = project_id
    if table.name == "accounts_studios":
        row["id"] = studio_id
    if table.name in ("accounts_memberships", *PERSONAL):
        row["person_id"] = MEMBER if studio_id == HERE else ELSEWHERE
    if table.name == "shares_saved_views":
        row["page"] = ViewedPage.REVIEW_QUEUE
    if table.name == "projects_engagements":
        row["designer_id"] = DESIGNER if project_id == PROJECTS[HERE][0] else new_id()
    return row


@pytest.fixture(scope="module")
def database(postgres: Postgres) -> Iterator[Database]:
    """Two studios, one of them with two projects, and in every table a row for each."""
    database = Database(postgres.new_database("row_security"))
    migrate(database)
    with postgres.superuser("row_security") as connection:  # rows are made up: only who owns them matters
        for table in Base.metadata.sorted_tables:
            for constraint in table.constraints - {table.primary_key}:
                drop = sql.SQL("alter table {} drop constraint {} cascade")
                connection.execute(drop.format(sql.Identifier(table.name), sql.Identifier(str(constraint.name))))
    with database.writing() as session:
        for table in Base.metadata.sorted_tables:
            per_project = "project_id" in table.columns or table.name == "projects_projects"
            for studio_id, project_ids in PROJECTS.items():
                for project_id in project_ids if per_project else project_ids[:1]:
                    session.execute(sa.insert(table).values(row_of(table, studio_id, project_id)))
    yield database
    database.dispose()


def seen(session: Session, name: str) -> set[UUID]:
    """Return whose rows a session sees in a table."""
    owner = {"accounts_studios": "id", **dict.fromkeys(PERSONAL, "person_id")}.get(name, "studio_id")
    return set(session.scalars(sa.select(Base.metadata.tables[name].columns[owner])))


def projects_seen(session: Session, name: str) -> set[UUID]:
    column = "id" if name == "projects_projects" else "project_id"
    return set(session.scalars(sa.select(Base.metadata.tables[name].columns[column])))


@pytest.mark.parametrize("name", TENANT)
def test_where_members_see_their_own_projects_the_others_are_hidden(database: Database, name: str):
    table = Base.metadata.tables[name]
    if "project_id" not in table.columns and name != "projects_projects":
        return
    one, _ = PROJECTS[HERE]
    with database.engine.begin() as connection:
        studios, members = (Base.metadata.tables[kind] for kind in ("accounts_studios", "projects_members"))
        connection.execute(sa.update(studios).where(studios.c.id == HERE).values(members_see=MembersSee.OWN))
        connection.execute(sa.update(members).where(members.c.project_id == one).values(person_id=MEMBER))
    try:
        with database.reading(AccessScope(person_id=MEMBER)) as session:
            assert projects_seen(session, name) - {None} <= {one}
            assert projects_seen(session, name), "who is in a project sees it"
    finally:
        with database.engine.begin() as connection:
            connection.execute(sa.update(studios).where(studios.c.id == HERE).values(members_see=MembersSee.ALL))


@pytest.mark.parametrize("name", ["shares_guest_links", "webhooks_webhooks", "reviews_verdicts", "projects_projects"])
def test_an_engaged_member_sees_the_project_as_its_members_do(database: Database, name: str):
    studios, engagements, members = (
        Base.metadata.tables[kind] for kind in ("accounts_studios", "projects_engagements", "projects_members")
    )
    one, other = PROJECTS[HERE]
    with database.engine.begin() as connection:
        connection.execute(sa.update(studios).where(studios.c.id == HERE).values(members_see=MembersSee.OWN))
        connection.execute(sa.update(members).where(members.c.person_id == MEMBER).values(person_id=new_id()))
        connection.execute(sa.update(engagements).where(engagements.c.project_id == other).values(designer_id=MEMBER))
    try:
        with database.reading(AccessScope(person_id=MEMBER)) as session:
            assert projects_seen(session, name) - {None} == {other}
        with database.reading(AccessScope(person_id=DESIGNER)) as session:  # engaged, and no member of the studio
            assert (one in projects_seen(session, name)) is (name not in TEAMS_OWN)
    finally:
        with database.engine.begin() as connection:
            connection.execute(sa.update(studios).where(studios.c.id == HERE).values(members_see=MembersSee.ALL))
            connection.execute(
                sa.update(engagements).where(engagements.c.designer_id == MEMBER).values(designer_id=new_id())
            )


def test_every_table_says_who_may_see_its_rows():
    for table in Base.metadata.sorted_tables:
        assert (condition(table) is None) == (table.name in UNGUARDED | ADD_ONLY | SERVERS_OWN), table.name


def test_a_table_that_says_nothing_is_refused():
    with pytest.raises(ValueError, match="has no studio_id"):
        condition(sa.Table("reviews_secrets", sa.MetaData(), sa.Column("id", sa.Uuid, primary_key=True)))


@pytest.mark.parametrize("name", GUARDED)
def test_who_is_not_known_sees_nothing(database: Database, name: str):
    with database.reading(NOBODY) as session:
        assert seen(session, name) == set()
    with database.reading() as session:
        assert len(seen(session, name)) >= 2, "the server itself sees all"


@pytest.mark.parametrize("name", TENANT)
def test_nobody_sees_another_studio(database: Database, name: str):
    for who, reach in READERS.items():
        with database.reading(reach) as session:
            assert seen(session, name) <= {HERE}, who
    with database.reading(AccessScope(person_id=MEMBER)) as session:
        assert seen(session, name) == {HERE}
    with database.reading(AccessScope(person_id=ELSEWHERE)) as session:
        assert seen(session, name) == {THERE}


@pytest.mark.parametrize(
    "name", sorted({*TENANT} - {"accounts_studios", "accounts_memberships"} - CONFIDENTIAL - DESIGNERS_READ)
)
def test_designers_and_builds_see_their_project_alone(database: Database, name: str):
    table = Base.metadata.tables[name]
    one, other = PROJECTS[HERE]
    with database.reading(AccessScope(person_id=MEMBER)) as session:
        if "project_id" in table.columns:
            assert projects_seen(session, name) == {one, other}
    for reach in (AccessScope(person_id=DESIGNER), AccessScope(project_id=one)):
        with database.reading(reach) as session:
            if "project_id" in table.columns or name == "projects_projects":
                assert projects_seen(session, name) == {one}
            else:
                assert seen(session, name) == {HERE}


@pytest.mark.parametrize("name", sorted(DESIGNERS_READ))
def test_designers_read_playlists_of_their_project_and_the_team_alone_writes_them(database: Database, name: str):
    table = Base.metadata.tables[name]
    one = PROJECTS[HERE][0]
    with database.reading(AccessScope(person_id=DESIGNER)) as session:
        assert projects_seen(session, name) == {one}
    with database.reading(AccessScope(project_id=one)) as session:
        assert projects_seen(session, name) == set(), "no build reads them"
    for person, rows in ((DESIGNER, 0), (MEMBER, 2)):
        with database.writing(AccessScope(person_id=person)) as session:
            assert session.execute(sa.update(table).values(studio_id=HERE)).rowcount == rows
    with (
        pytest.raises(sa.exc.ProgrammingError, match="row-level security"),
        database.writing(AccessScope(person_id=DESIGNER)) as session,
    ):
        session.execute(sa.insert(table).values(row_of(table, HERE, one)))


def test_where_a_designer_stopped_in_a_playlist_is_their_own(database: Database):
    table = Base.metadata.tables["shares_playlist_positions"]
    one, other = PROJECTS[HERE]
    with database.writing(AccessScope(person_id=DESIGNER)) as session:
        session.execute(sa.insert(table).values(row_of(table, HERE, one) | {"person_id": DESIGNER}))
        assert set(session.scalars(sa.select(table.c.person_id))) == {DESIGNER}
        session.rollback()
    for wrong in ({"person_id": new_id()}, {"person_id": DESIGNER, "project_id": other}):
        with (
            pytest.raises(sa.exc.ProgrammingError, match="row-level security"),
            database.writing(AccessScope(person_id=DESIGNER)) as session,
        ):
            session.execute(sa.insert(table).values(row_of(table, HERE, one) | wrong))


@pytest.mark.slow
def test_the_team_shares_views_of_the_review_queue_alone(database: Database):
    table = Base.metadata.tables["shares_saved_views"]
    row = row_of(table, HERE, PROJECTS[HERE][0])
    views = {
        person: row | {"id": new_id(), "page": ViewedPage.SOUND_LIST, "person_id": person}
        for person in (MEMBER, DESIGNER)
    }
    with database.writing() as session:
        session.execute(sa.insert(table), list(views.values()))
    with database.reading(AccessScope(person_id=MEMBER)) as session:
        pages = session.execute(sa.select(table.c.page, table.c.person_id)).all()
        lists = [person for page, person in pages if page is not ViewedPage.REVIEW_QUEUE]
    assert lists == [MEMBER]
    with database.writing() as session:
        session.execute(sa.delete(table).where(table.c.id.in_([view["id"] for view in views.values()])))


@pytest.mark.parametrize("name", sorted(CONFIDENTIAL))
def test_bids_and_scores_are_seen_by_their_parties_alone(database: Database, name: str):
    table = Base.metadata.tables[name]
    rows_seen, all_rows = (projects_seen, set(PROJECTS[HERE])) if "project_id" in table.columns else (seen, {HERE})
    with database.reading(AccessScope(person_id=MEMBER)) as session:
        assert rows_seen(session, name) == all_rows
    for reach in (AccessScope(person_id=DESIGNER), AccessScope(project_id=PROJECTS[HERE][0])):
        with database.reading(reach) as session:
            assert rows_seen(session, name) == set()
    if "designer_id" in table.columns:
        own = row_of(table, HERE, PROJECTS[HERE][0]) | {"designer_id": DESIGNER}
        with database.writing() as session:
            session.execute(sa.insert(table).values(own))
        with database.reading(AccessScope(person_id=DESIGNER)) as session:
            assert session.scalars(sa.select(table.columns["designer_id"])).all() == [DESIGNER]
        with database.writing() as session:
            session.execute(sa.delete(table).where(table.columns["id"] == own["id"]))


@pytest.mark.parametrize("name", sorted(PERSONAL))
def test_what_is_personal_is_seen_by_its_person(database: Database, name: str):
    with database.reading(AccessScope(person_id=MEMBER)) as session:
        assert seen(session, name) == {MEMBER}


@pytest.mark.parametrize("name", TENANT)
def test_nobody_writes_into_another_studio(database: Database, name: str):
    table = Base.metadata.tables[name]
    studio = table.columns["id" if name == "accounts_studios" else "studio_id"]
    with database.writing(AccessScope(person_id=MEMBER)) as session:
        for statement in (sa.update(table).values({studio.name: HERE}), sa.delete(table)):
            if name in NEVER_ALTERED | READ_ONLY:
                continue  # the next test
            result = session.execute(statement.where(studio == THERE))
            assert result.rowcount == 0
    row = {name: value for name, value in row_of(table, THERE, new_id()).items() if value is not None}
    if name == "accounts_memberships":
        row["person_id"] = MEMBER  # nobody gives themselves a place
    why = "permission denied" if name in READ_ONLY else "row-level security"
    with (
        pytest.raises(sa.exc.ProgrammingError, match=why),
        database.writing(AccessScope(person_id=MEMBER)) as session,
    ):
        session.execute(sa.insert(table).values(row))


DESIGNERS = sorted(name for name in TENANT if "designer_id" in Base.metadata.tables[name].columns)


@pytest.mark.parametrize("name", DESIGNERS)
def test_a_designer_writes_no_other_designers_rows(database: Database, name: str):
    table = Base.metadata.tables[name]
    row = row_of(table, HERE, PROJECTS[HERE][0]) | {"designer_id": new_id()}
    of_another = table.columns["designer_id"] != DESIGNER
    with database.writing() as session:
        session.execute(sa.insert(table).values(row))
    try:
        with database.writing(AccessScope(person_id=DESIGNER)) as session:
            others = session.scalar(sa.select(sa.func.count()).select_from(table).where(of_another))
            assert bool(others) == (name not in CONFIDENTIAL)
            assert session.execute(sa.update(table).values(studio_id=HERE).where(of_another)).rowcount == 0
            assert session.execute(sa.delete(table).where(of_another)).rowcount == 0
        with (
            pytest.raises(sa.exc.ProgrammingError, match="row-level security"),
            database.writing(AccessScope(person_id=DESIGNER)) as session,
        ):
            session.execute(sa.insert(table).values(row_of(table, HERE, PROJECTS[HERE][0]) | {"designer_id": new_id()}))
        with database.writing(AccessScope(person_id=MEMBER)) as session:
            assert session.execute(sa.update(table).values(studio_id=HERE).where(of_another)).rowcount >= 1
    finally:
        with database.writing() as session:
            session.execute(sa.delete(table).where(table.columns["designer_id"] == row["designer_id"]))


def test_nobody_writes_another_persons_account(database: Database):
    people = Base.metadata.tables["accounts_people"]
    with database.writing() as session:
        for person_id in (MEMBER, DESIGNER):
            session.execute(sa.insert(people).values(row_of(people, HERE, new_id()) | {"id": person_id}))
    for reach, own in (
        (AccessScope(person_id=DESIGNER), 1),
        (NOBODY, 0),
        (AccessScope(project_id=PROJECTS[HERE][0]), 0),
    ):
        with database.writing(reach) as session:
            assert session.scalar(sa.select(sa.func.count()).select_from(people)) >= 2, "anyone may be invited"
            assert session.execute(sa.update(people).values(name="taken over")).rowcount == own
            assert session.execute(sa.delete(people).where(people.columns["id"] != DESIGNER)).rowcount == 0
    with database.writing(NOBODY) as session:
        session.execute(sa.insert(people).values(row_of(people, HERE, new_id())))


@pytest.mark.parametrize("name", sorted(NEVER_ALTERED | READ_ONLY))
def test_what_was_said_is_not_altered_even_by_its_own(database: Database, name: str):
    table = Base.metadata.tables[name]
    owner, own = ("studio_id", HERE) if "studio_id" in table.columns else ("person_id", MEMBER)
    for statement in (sa.update(table).values({owner: own}), sa.delete(table)):
        with (
            pytest.raises(sa.exc.ProgrammingError, match="permission denied"),
            database.writing(AccessScope(person_id=MEMBER)) as session,
        ):
            session.execute(statement.where(table.columns[owner] == own))


def test_the_servers_own_tables_are_closed_to_requests(database: Database):
    for schema, name in (
        (None, "core_heartbeats"),
        (None, "core_saved_responses"),
        (None, "core_changed_rooms"),
        ("dbos", "workflow_status"),
        ("dbos", "workflow_inputs"),
    ):
        with (
            pytest.raises(sa.exc.ProgrammingError, match="permission denied"),
            database.reading(AccessScope(person_id=MEMBER)) as session,
        ):
            session.execute(sa.select(sa.literal(1)).select_from(sa.table(name, schema=schema)))


def test_reach_is_widened_only_for_the_named_caller(database: Database):
    with database.reading(NOBODY) as session:
        assert seen(session, "projects_projects") == set()
        set_access_scope(session, AccessScope(person_id=ELSEWHERE))
        assert seen(session, "projects_projects") == {THERE}
        with bypass_row_policies(session):
            assert seen(session, "projects_projects") == {HERE, THERE}
        assert seen(session, "projects_projects") == {THERE}
    with database.reading(NOBODY) as session:
        assert seen(session, "projects_projects") == set(), "the reach of the last one is forgotten"


def test_who_joins_a_studio_sees_it_at_once(database: Database):
    newcomer = new_id()
    memberships = Base.metadata.tables["accounts_memberships"]
    with database.writing(AccessScope(person_id=newcomer)) as session:
        assert seen(session, "projects_projects") == set()
        with bypass_row_policies(session):
            session.execute(
                sa.insert(memberships).values(row_of(memberships, HERE, new_id()) | {"person_id": newcomer})
            )
        assert seen(session, "projects_projects") == {HERE}
        session.rollback()


def test_statements_stay_prepared_when_a_request_has_only_read(database: Database):
    described = sa.select(Base.metadata.tables["projects_projects"].c.description)  # which no other test asks for
    prepared = sa.text("select count(*) from pg_prepared_statements where statement = :statement")
    kept = []
    for _ in range(4):  # psycopg prepares what it sends again; the connection used last is used next
        with database.reading(AccessScope(person_id=MEMBER)) as session:
            session.execute(described)
            kept.append(session.scalar(prepared, {"statement": str(described)}))
    assert kept == [0, 1, 1, 1]


def test_a_reading_request_changes_nothing(database: Database):
    with (
        pytest.raises(sa.exc.DBAPIError, match="read-only transaction"),
        database.reading(AccessScope(person_id=MEMBER)) as session,
    ):
        session.execute(sa.delete(Base.metadata.tables["projects_projects"]))


def test_who_fails_beyond_reach_comes_back_with_nothing(database: Database):
    def fail_in(session: Session) -> None:
        with bypass_row_policies(session):
            assert seen(session, "projects_projects") == {HERE, THERE}
            raise ZeroDivisionError

    with database.reading(NOBODY) as session:
        with pytest.raises(ZeroDivisionError):
            fail_in(session)
        assert seen(session, "projects_projects") == set()
