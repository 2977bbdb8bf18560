"""Row policies on PostgreSQL, the second line of defence: a request's transaction sees its own tenants' rows only.

The first is the caller's reach in every WHERE. Each policy follows from the columns of its table, so a
new table has one, or fails to migrate. Requests run as a role that owns nothing (app/core/db.py); jobs,
migrations and backups run as the owner of the tables, to whom policies do not apply.
"""

import hashlib
from collections.abc import Iterator

import sqlalchemy as sa
from psycopg import errors
from sqlalchemy.exc import ProgrammingError

from app import tables  # noqa: F401  every model, for its policy
from app.core.db import PERSON, PROJECT, REQUEST_ROLE, SET_REACH, Base, Database
from app.core.runtime import Runtime
from app.core.web.health import NotReady

POLICY = "within_reach"
WRITING = ("insert", "update", "delete")  # each has a separate policy where fewer rows are writable than readable
UNGUARDED = frozenset({"accounts_people"})  # people are global: an invitation must find any address
# Read by the server alone: answers it replays, under a hash of the credentials, and changes for open pages.
ADD_ONLY = frozenset({"core_saved_responses", "core_changed_rooms"})
NEVER_ALTERED = frozenset(  # what was said and owed stands
    {
        *("contracts_events", "contracts_acceptances", "contracts_amendment_acceptances"),
        "contracts_seals",
        "accounts_security_events",
        *("contracts_ledger_lines", "contracts_invoice_lines"),
    }
)
SERVERS_OWN = frozenset(
    {
        *("core_heartbeats", "core_backups", "accounts_rate_limits", "accounts_sign_ups"),
        *("operations_scrubs", "operations_damaged_blobs"),
    }
)
PERSONAL = frozenset(
    {
        *("accounts_sign_ins", "accounts_password_resets", "accounts_email_verifications", "accounts_operators"),
        "accounts_desk_tokens",
        *("accounts_totp_factors", "accounts_recovery_codes", "accounts_passkeys", "accounts_email_changes"),
        "accounts_pictures",  # whose name a caller sees, a query decides
        *("notifications_mail_preferences", "notifications_notices"),
        "contracts_own_times",
        "reviews_heard_takes",
    }
)
TEAMS_OWN = frozenset(  # no designer reads them
    {
        *("hiring_scores", "hiring_roster_entries", "hiring_busy_ranges", "hiring_reel_sounds"),
        *("hiring_bid_notes", "hiring_loans", "projects_members"),
        *("shares_guest_links", "shares_guest_sounds", "shares_guest_visits", "shares_guest_plays"),
        *("shares_guest_copies", "shares_live_sessions", "shares_live_listeners"),
        *("webhooks_webhooks", "webhooks_calls", "webhooks_attempts"),
        "projects_budgets",
        "accounts_security_events",
        *("accounts_sign_in_providers", "accounts_sign_in_domains"),
        *("reviews_checklist_items", "reviews_item_checks", "reviews_approval_rules"),
        "builds_master_fingerprints",
    }
)
DESIGNERS_READ = frozenset({"shares_playlists", "shares_playlist_entries"})  # which of them, a query decides
READ_ONLY = frozenset(
    {"accounts_operators", "accounts_quotas", "accounts_sign_in_domains"}
)  # set on the command line only

ME, THIS_PROJECT = "soundlist_person_id()", "soundlist_project_id()"
SAID = {ME: PERSON, THIS_PROJECT: PROJECT}
LISTS = {  # looked up when a transaction begins, and kept to its end
    "soundlist.studios": "select studio_id from accounts_memberships where person_id = me",
    "soundlist.open_studios": """
        select studio_id from accounts_memberships join accounts_studios on accounts_studios.id = studio_id
        where person_id = me and members_see = 'all'""",
    "soundlist.own_projects": """
        select project_id from projects_members join accounts_memberships using (studio_id, person_id)
        where person_id = me
        union select project_id from projects_engagements engagements join accounts_memberships members
        on members.studio_id = engagements.studio_id and person_id = designer_id
        where designer_id = me and ended_at is null""",
    "soundlist.near_studios": """
        select studio_id from accounts_memberships where person_id = me
        union select studio_id from projects_engagements where designer_id = me
        union select studio_id from projects_projects where id = this_project""",
    "soundlist.engagements": "select project_id from projects_engagements where designer_id = me",
}
# A scalar subquery is worked out once a query, not once a row.
STUDIOS, OPEN_STUDIOS, OWN_PROJECTS, NEAR_STUDIOS, ENGAGEMENTS = (
    f"any((select nullif(current_setting('{name}', true), '')::uuid[])::uuid[])" for name in LISTS
)


class CannotGuardRows(Exception):
    """The database's login may not make the role that requests run as."""


def teams(table: sa.Table) -> str:
    """Return the rows of a table that members of a studio see; of projects, where it wants, only those they are in."""
    project_id = "id" if table.name == "projects_projects" else "project_id"
    if project_id not in table.columns:
        return f"studio_id = {STUDIOS}"
    rows = f"studio_id = {OPEN_STUDIOS} or {project_id} = {OWN_PROJECTS}"
    if table.columns[project_id].nullable:
        rows += f" or (project_id is null and studio_id = {STUDIOS})"
    return rows


def condition(table: sa.Table) -> str | None:
    """Return rows of a table that a request may see, and write but for `written`; None where it sees all or none."""
    columns = set(table.columns.keys())
    project_id = "id" if table.name == "projects_projects" else "project_id"
    if table.name in UNGUARDED | ADD_ONLY | SERVERS_OWN:
        return None
    if table.name == "shares_saved_views":  # those of the review queue are the team's
        return f"person_id = {ME} or (page = 'review_queue' and ({teams(table)}))"
    if table.name in PERSONAL:
        return f"person_id = {ME}"
    if table.name == "accounts_studios":
        return f"id = {NEAR_STUDIOS}"
    if table.name == "accounts_memberships":
        return f"studio_id = {STUDIOS} or person_id = {ME}"
    if table.name == "accounts_invoice_details":  # an account number is shown on the owner's invoices only
        return f"{teams(table)} or person_id = {ME}"
    if table.name in TEAMS_OWN:
        return teams(table)
    if table.name in DESIGNERS_READ:
        return f"{teams(table)} or project_id = {ENGAGEMENTS}"
    if table.name == "shares_playlist_positions":  # where each designer stopped is their own
        return f"{teams(table)} or (project_id = {ENGAGEMENTS} and person_id = {ME})"
    if table.name in ("hiring_bids", "hiring_samples"):  # rates and samples are for the two parties only
        return f"{teams(table)} or designer_id = {ME}"
    if table.name in ("builds_sound_libraries", "builds_library_sounds"):  # of the studio, and each person's own
        return f"{teams(table)} or person_id = {ME}"
    if table.name == "references_openings":  # the team reads who opened what; each person their own
        return f"{teams(table)} or person_id = {ME}"
    if "studio_id" not in columns:
        raise ValueError(f"{table.name} has no studio_id; give it one, or say here who may see its rows")
    if project_id not in columns:
        return f"studio_id = {NEAR_STUDIOS}"
    return f"{teams(table)} or {project_id} = {ENGAGEMENTS} or {project_id} = {THIS_PROJECT}"


def written(table: sa.Table) -> str | None:
    """Return the rows that a request may write where these are fewer than it sees."""
    if table.name == "accounts_people":
        return f"id = {ME}"
    if table.name in (*DESIGNERS_READ, "reviews_reason_lists"):
        return teams(table)
    columns = set(table.columns.keys())
    if {"designer_id", "studio_id", "project_id"} <= columns:
        is_own = f"project_id = {ENGAGEMENTS} and designer_id = {ME}"
        return f"{teams(table)} or ({is_own}) or project_id = {THIS_PROJECT}"
    return None


def guard_rows(database: Database) -> None:
    """Bring role, grants and policies to what the tables want; touch no table that is guarded as it should be."""
    if database.is_sqlite:
        return
    with database.engine.begin() as connection:
        make_request_role(connection)
    with database.engine.begin() as connection:
        for statement in _functions():
            connection.exec_driver_sql(statement)
        guarded = _guarded(connection)
    for table in Base.metadata.sorted_tables:
        statements = list(_guard(table))
        mark = hashlib.sha256("\n".join(statements).encode()).hexdigest()
        if guarded.get(table.name) == mark:
            continue
        with database.engine.begin() as connection:  # one at a time: a lock on all tables would block every request
            for statement in statements:
                connection.exec_driver_sql(statement)
            if is_guarded(table):
                connection.exec_driver_sql(f"comment on policy {POLICY} on {table.name} is '{mark}'")


def is_guarded(table: sa.Table) -> bool:
    """Whether policies hold a table."""
    return condition(table) is not None or written(table) is not None


def ensure_rows_are_guarded(runtime: Runtime) -> None:
    """Raise NotReady unless policies hold requests and leave the server alone."""
    if runtime.database.is_sqlite:
        return
    active = sa.select(sa.func.row_security_active("accounts_studios"))
    with runtime.database.engine.connect() as connection:
        if connection.scalar(active):
            raise NotReady(
                "the login of SOUNDLIST_DATABASE_URL does not own the tables, so row security shows it nothing; "
                "use the login that ran: soundlist migrate"
            )
        try:
            connection.execute(sa.select(sa.func.set_config("role", REQUEST_ROLE, True)))
        except sa.exc.DBAPIError:
            raise NotReady(f"the login may not become the role {REQUEST_ROLE}; run: soundlist migrate") from None
        if not connection.scalar(active):
            raise NotReady("row security does not apply to requests; run: soundlist migrate")


def make_request_role(connection: sa.Connection) -> None:
    """Make the role that requests run as, and let the login become it."""
    role = sa.text("select pg_has_role(oid, 'member') from pg_roles where rolname = :name")
    is_member = connection.scalar(role, {"name": REQUEST_ROLE})
    try:
        if is_member is None:
            connection.exec_driver_sql(f"create role {REQUEST_ROLE} nologin")
        if not is_member:
            connection.exec_driver_sql(f"grant {REQUEST_ROLE} to current_user")
    except ProgrammingError as error:
        if not isinstance(error.orig, errors.InsufficientPrivilege):
            raise
        login = connection.engine.url.username
        raise CannotGuardRows(
            f"{login} may not make roles. Have an administrator of the database say, once: "
            f'create role {REQUEST_ROLE} nologin; grant {REQUEST_ROLE} to "{login}";'
        ) from None


def _functions() -> Iterator[str]:
    for name, setting in SAID.items():
        yield (
            f"create or replace function {name} returns uuid language sql stable"
            f" as $$ select nullif(current_setting('{setting}', true), '')::uuid $$"
        )
    keep = "perform set_config('{}', {}::text, true);"
    kept = [keep.format(name, value) for name, value in ((PERSON, "me"), (PROJECT, "this_project"))]
    kept += [keep.format(name, f"array({listed})") for name, listed in LISTS.items()]
    # As the owner, to whom no policy applies; with a fixed search path, so that no other table can shadow one.
    yield (
        f"create or replace function {SET_REACH}(me uuid, this_project uuid) returns void language plpgsql"
        f" security definer set search_path from current as $$ begin {' '.join(kept)} end $$"
    )


def _guarded(connection: sa.Connection) -> dict[str, str]:
    """Return the source of each table's policy."""
    policies = sa.text(
        "select relname, obj_description(pg_policy.oid, 'pg_policy') from pg_policy"
        " join pg_class on pg_class.oid = polrelid"
        " where relnamespace = current_schema()::regnamespace and polname = :name"
    )
    return dict(connection.execute(policies, {"name": POLICY}).all())


def _guard(table: sa.Table) -> Iterator[str]:
    yield f"revoke all on {table.name} from {REQUEST_ROLE}"
    if table.name not in SERVERS_OWN:
        allowed = "select, insert, update, delete"
        if table.name in ADD_ONLY | NEVER_ALTERED:
            allowed = "insert" if table.name in ADD_ONLY else "select, insert"
        elif table.name in READ_ONLY:
            allowed = "select"
        yield f"grant {allowed} on {table.name} to {REQUEST_ROLE}"
    for policy in (POLICY, *(f"{POLICY}_{act}" for act in WRITING)):
        yield f"drop policy if exists {policy} on {table.name}"
    if not is_guarded(table):
        return
    rows, is_written = condition(table) or "true", written(table)
    yield f"alter table {table.name} enable row level security"
    if is_written is None:
        # Members may read their own memberships, but must not insert one.
        check = f"studio_id = {STUDIOS}" if table.name == "accounts_memberships" else rows
        yield f"create policy {POLICY} on {table.name} to {REQUEST_ROLE} using ({rows}) with check ({check})"
        return
    added = "true" if table.name in UNGUARDED else is_written  # a new account has no owner yet
    yield f"create policy {POLICY} on {table.name} for select to {REQUEST_ROLE} using ({rows})"
    yield f"create policy {POLICY}_insert on {table.name} for insert to {REQUEST_ROLE} with check ({added})"
    for act in WRITING[1:]:
        yield f"create policy {POLICY}_{act} on {table.name} for {act} to {REQUEST_ROLE} using ({is_written})"
