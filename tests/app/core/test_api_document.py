"""The OpenAPI document over HTTP."""

import json
import shutil
import subprocess
import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from anyio.from_thread import start_blocking_portal

from app.core.runtime import Runtime
from app.main import create_app
from app.settings import Settings
from tests.support.listening import listening
from tests.support.server import RunningServer

FRONTEND = Path(__file__).resolve().parents[3] / "frontend"
PACKAGES = FRONTEND / "node_modules"
CLIENT = Path(__file__).resolve().parents[2] / "support" / "generated_client.ts"
NODE = shutil.which("node") or "node"
COMPILER_OPTIONS = {
    "strict": True,
    "target": "es2022",
    "module": "esnext",
    "moduleResolution": "bundler",
    "types": ["node"],
    "rewriteRelativeImportExtensions": True,
    "noEmitOnError": True,
}

MORE_THAN_THREADS = 50  # of the pool that answers requests, which has 40
SOON_S = 60.0
PROBLEM = "#/components/responses/Problem"


@pytest.fixture
def fresh(tmp_path: Path) -> Iterator[RunningServer]:
    """An application that was not asked for its document yet."""
    runtime = Runtime.of(Settings(data_dir=tmp_path, secret_key="only for tests"))
    with start_blocking_portal() as portal:
        yield RunningServer(runtime, create_app(runtime), portal)
    runtime.close()


@pytest.mark.slow
def test_requests_are_answered_while_many_wait_for_the_document(fresh: RunningServer, monkeypatch: pytest.MonkeyPatch):
    begun, finish, builds = threading.Event(), threading.Event(), []

    def slow() -> dict[str, str]:
        builds.append(1)
        begun.set()
        finish.wait(2 * SOON_S)
        return {"openapi": "é"}

    monkeypatch.setattr(fresh.application, "openapi", slow)
    with ThreadPoolExecutor(MORE_THAN_THREADS + 1) as pool:
        try:
            asked = [pool.submit(fresh.browser().get, "/v1/openapi.json") for _ in range(MORE_THAN_THREADS)]
            assert begun.wait(SOON_S)
            assert pool.submit(fresh.browser().get, "/healthz").result(SOON_S).status_code == 200
        finally:
            finish.set()
        assert {one.result().text for one in asked} == {'{"openapi":"é"}'}
    assert builds == [1]


@pytest.mark.slow
def test_the_document_is_the_applications(fresh: RunningServer):
    answer = fresh.browser().get("/v1/openapi.json")
    assert answer.headers["content-type"] == "application/json"
    assert answer.json() == fresh.application.openapi()
    assert fresh.browser().head("/v1/openapi.json").status_code == 200


def test_every_operation_says_what_refusals_look_like(server: RunningServer):
    document = json.loads((FRONTEND / "openapi.json").read_text())
    operations = [operation for methods in document["paths"].values() for operation in methods.values()]
    assert {status for operation in operations for status in operation["responses"] if status[0] in "45"} == set()
    assert all(operation["responses"]["default"] == {"$ref": PROBLEM} for operation in operations)
    (media_type,) = document["components"]["responses"]["Problem"]["content"]
    assert server.browser().get("/v1/me").headers["content-type"] == media_type
    assert not [name for name in document["components"]["schemas"] if "ValidationError" in name]


@pytest.mark.slow
def test_an_operation_lists_its_problem_codes():
    document = json.loads((FRONTEND / "openapi.json").read_text())
    sign_in = document["paths"]["/v1/sign-in"]["post"]["description"]
    codes = (
        "401 `wrong-sign-in`, `second-factor-needed`; 403 `wrong-second-factor`; 422 `invalid-request`; "
        "429 `too-many-attempts`"
    )
    assert sign_in.startswith("Sign in with address and password")
    assert sign_in.endswith(f"\n\nProblem codes: {codes}.")
    # What has no parameters and no body cannot be invalid.
    assert document["paths"]["/v1/me"]["get"]["description"].count("Problem codes") == 0


@pytest.mark.slow
def test_a_generated_client_reads_what_is_wrong_with_a_request(server: RunningServer, tmp_path: Path):
    (tmp_path / "node_modules").symlink_to(PACKAGES)
    (tmp_path / "package.json").write_text('{"type": "module"}')
    (tmp_path / "tsconfig.json").write_text(json.dumps({"compilerOptions": COMPILER_OPTIONS, "files": [CLIENT.name]}))
    shutil.copy(CLIENT, tmp_path)
    run(tmp_path, "openapi-typescript/bin/cli.js", FRONTEND / "openapi.json", "--output", "schema.ts")
    run(tmp_path, "typescript-native/bin/tsc")
    with listening(server.application) as port:
        read = run(tmp_path, tmp_path / CLIENT.with_suffix(".js").name, f"http://127.0.0.1:{port}")
    assert json.loads(read) == {
        "status": 422,
        "code": "invalid-request",
        "fields": [
            "email: this has 300 characters; at most 254 are taken",
            "password: this has 2000 characters; at most 200 are taken",
        ],
        "type": "application/problem+json",
    }


def run(folder: Path, script: str | Path, *arguments: str | Path) -> str:
    """Run a script with Node, in a folder; a script's relative path is that of an installed package."""
    done = subprocess.run([NODE, PACKAGES / script, *arguments], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout
