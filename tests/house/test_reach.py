"""Who opens the database as the server itself, past the row policies: jobs and commands, and these few."""

import ast
from pathlib import Path

import pytest

pytestmark = pytest.mark.lint

ROOT = Path(__file__).resolve().parents[2]
NO_REQUEST = (
    "app/**/*jobs.py",
    "app/agreements/signing/seals.py",
    "app/conformance/checking.py",
    "app/webhooks/sending.py",
    "app/worker.py",
    "app/cli/*.py",
    "app/demo/*.py",
    "app/backup.py",
    "app/transfers/*.py",
    "app/operations/figures.py",
    "app/amendments/verification.py",
    "app/operations/scrubbing/service.py",
    "app/migrate.py",
)
BEFORE_SIGN_IN = {
    "app/accounts/authentication.py": "finds out who comes, by the secret that was sent",
    "app/accounts/people.py": "finds whose address and password these are; people are global",
    "app/accounts/web/policies.py": "notes after the answer that a token was used",
    "app/accounts/second_factors/service.py": "whether who signs in has a second factor, asked after the password",
    "app/accounts/providers/endpoints.py": "the provider of a domain, before there is a caller",
    "app/accounts/web/recorded_downloads.py": "writes the line of the security log, after a request that only reads",
    "app/agreements/record/endpoints.py": "looks for the seal of a file, which is shown to anyone who has that file",
    "app/accounts/web/request_limits.py": "counts tries, also those of requests that are refused",
    "app/shares/guests.py": "looks for a guest link by its secret, before its password is checked",
}
SERVERS_OWN_TABLES = {
    "app/core/web/idempotency.py": "answers kept for an Idempotency-Key",
    "app/core/jobs/queue.py": "jobs and heartbeats",
    "app/core/jobs/workers.py": "heartbeats",
    "app/core/changes.py": "the log of which rooms changed, without any content",
    "app/dashboards/live_changes/queries.py": "what a person may see, read for streams of many people",
    "app/core/backups.py": "when the newest backup ended",
    "app/core/web/health.py": "whether the database answers",
    "app/core/uploads/parts.py": "an upload's row, for its owner alone",
    "app/core/uploads/staged.py": "an upload's row, for its owner alone",
}


def opens_as_the_server(source: str) -> bool:
    """Whether code says database.reading() or .writing() without saying for whom."""
    return any(
        isinstance(node, ast.Call)
        and isinstance(node.func, ast.Attribute)
        and node.func.attr in ("reading", "writing")
        and not node.args
        and not node.keywords
        for node in ast.walk(ast.parse(source))
    )


def test_requests_open_the_database_for_their_caller():
    outside = {str(path.relative_to(ROOT)) for pattern in NO_REQUEST for path in ROOT.glob(pattern)}
    found = {
        str(path.relative_to(ROOT)) for path in ROOT.glob("app/**/*.py") if opens_as_the_server(path.read_text())
    } - outside
    assert found == {*BEFORE_SIGN_IN, *SERVERS_OWN_TABLES}


def test_the_test_sees_it():
    assert opens_as_the_server("with runtime.database.reading() as session: pass")
    assert not opens_as_the_server("with runtime.database.reading(actor.reach) as session: pass")
