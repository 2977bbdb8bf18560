"""The frontend's files are sent as its build compressed them: asked of the whole application."""

import gzip
from collections.abc import Iterator

import pytest
from anyio.from_thread import start_blocking_portal

from app.core.runtime import Runtime
from app.core.web.compression import accepted_encodings
from app.main import create_app
from app.migrate import migrate
from app.settings import Settings
from tests.support.server import RunningServer

SCRIPT = b"export const words = '" + b"laser " * 1_000 + b"'"
BROTLI = b"as the frontend's build wrote it"


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RunningServer]:
    """The application with a built frontend."""
    folder = tmp_path_factory.mktemp("compression")
    assets = folder / "frontend" / "assets"
    assets.mkdir(parents=True)
    (assets.parent / "index.html").write_text("<!doctype html>" + "<p>page</p>" * 200)
    (assets / "index-1a2b.js").write_bytes(SCRIPT)
    (assets / "index-1a2b.js.br").write_bytes(BROTLI)
    (assets / "index-1a2b.js.gz").write_bytes(gzip.compress(SCRIPT))
    (assets / "tiny-3c4d.js").write_bytes(b"export {}")
    runtime = Runtime.of(Settings(data_dir=folder, secret_key="only for tests", frontend_dir=assets.parent))
    migrate(runtime.database)
    with start_blocking_portal() as portal:
        yield RunningServer(runtime, create_app(runtime), portal)
    runtime.database.dispose()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("accept", "encoding"),
    [("gzip, deflate, br, zstd", "br"), ("gzip", "gzip"), ("br;q=0, gzip", "gzip"), ("identity", None)],
)
def test_assets_are_sent_as_the_build_compressed_them(served: RunningServer, accept: str, encoding: str | None):
    with served.browser().stream("GET", "/assets/index-1a2b.js", headers={"Accept-Encoding": accept}) as answer:
        raw = b"".join(answer.iter_raw())
    assert answer.headers.get("content-encoding") == encoding
    assert answer.headers["content-type"].partition(";")[0] == "text/javascript"
    assert "Accept-Encoding" in answer.headers["vary"]
    assert answer.headers["cache-control"] == "public, max-age=31536000, immutable"
    assert raw == {"br": BROTLI, None: SCRIPT}.get(encoding, raw)
    if encoding == "gzip":
        assert gzip.decompress(raw) == SCRIPT


@pytest.mark.slow
def test_each_encoding_of_an_asset_has_its_own_tag(served: RunningServer):
    tags = {}
    for accept in ("br", "gzip", "identity"):
        with served.browser().stream("GET", "/assets/index-1a2b.js", headers={"Accept-Encoding": accept}) as answer:
            tags[accept] = answer.headers["etag"]
    assert len(set(tags.values())) == 3
    again = {"Accept-Encoding": "br", "If-None-Match": tags["br"]}
    assert served.browser().get("/assets/index-1a2b.js", headers=again).status_code == 304


@pytest.mark.slow
def test_a_range_of_an_asset_is_of_its_plain_bytes(served: RunningServer):
    asked = {"Accept-Encoding": "br", "Range": "bytes=0-5"}
    answer = served.browser().get("/assets/index-1a2b.js", headers=asked)
    assert (answer.status_code, answer.content, answer.headers.get("content-encoding")) == (206, SCRIPT[:6], None)


@pytest.mark.parametrize(
    ("header", "accepted"),
    [
        ("gzip, br", {"gzip", "br"}),
        ("gzip;q=0.5, br;q=0", {"gzip"}),
        ("br; q=0.000, GZIP; q=1.0", {"gzip"}),
        ("", {""}),
    ],
)
def test_accepted_encodings(header: str, accepted: set[str]):
    assert accepted_encodings(header) == accepted
