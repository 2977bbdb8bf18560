"""The web process: rooms behind one FastAPI application, and the built frontend."""

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

import structlog
from fastapi import FastAPI, Response
from fastapi.responses import FileResponse, JSONResponse, RedirectResponse

from app import registry
from app.accounts.authentication import DEMO_COOKIE, SESSION_COOKIE
from app.accounts.web.policies import authenticate, caller_key
from app.core.change_feed import ChangeFeed
from app.core.changes import forget_old_changes
from app.core.runtime import Runtime
from app.core.uploads import Uploads
from app.core.web import error_responses, health
from app.core.web.api_document import ApiDocument, Application
from app.core.web.compression import PrecompressedFiles
from app.core.web.host_cookies import HostCookies
from app.core.web.http import PROBLEM_TYPE
from app.core.web.idempotency import delete_expired_responses
from app.core.web.response_headers import WithResponseHeaders, security_headers
from app.dashboards.live_changes.queries import GRANTING, sights_of
from app.deliveries.uploads.endpoints import TusHeaders
from app.migrate import ensure_at_head
from app.operations.figures import web_collectors
from app.projects.queries import rights_of
from app.routers import BASE_ROUTERS, ROUTERS

SWEEP_EVERY_S = 3600.0
log = structlog.get_logger(__name__)


def create_app(runtime: Runtime) -> FastAPI:
    """Wire one web process."""

    @asynccontextmanager
    async def lifespan(_app: FastAPI) -> AsyncIterator[None]:
        sweeping = asyncio.create_task(_sweep(runtime))
        await asyncio.to_thread(runtime.parsers.start)
        yield
        sweeping.cancel()
        runtime.close()

    app = Application(
        title="Soundlist",
        version="1",
        description="Sound lists, deliveries, reviews and packs; one spec and one verdict everywhere.",
        openapi_url=None,  # ApiDocument
        docs_url=None,  # the frontend's docs/index.html, which loads nothing from elsewhere
        redoc_url=None,
        lifespan=lifespan,
        generate_unique_id_function=lambda route: route.name,
    )
    app.state.runtime = runtime
    app.state.change_feed = ChangeFeed(runtime.database, sights_of, GRANTING)
    app.state.collectors = web_collectors(runtime)
    app.state.readiness = health.Readiness(runtime, {**health.PROBES, "migrations": ensure_at_head})
    runtime.parsers.connect(registry.PARSERS)
    registry.rooms_in_use(is_commercial=runtime.settings.commercial).connect()
    error_responses.install(
        app,
        credential_cookies=(SESSION_COOKIE, DEMO_COOKIE),
        rights_of=rights_of,
        caller_key=caller_key,
        authenticate=authenticate,
    )
    assets = runtime.settings.frontend_dir / "assets"
    if assets.is_dir():  # before the 600 routes of the API, each of which would be compared with its address
        app.mount("/assets", PrecompressedFiles(directory=assets), name="assets")
    for router in ROUTERS if runtime.settings.commercial else BASE_ROUTERS:
        app.include_router(router)
    app.include_router(health.router)
    app.add_route("/v1/openapi.json", ApiDocument(app).respond, include_in_schema=False)
    headers = security_headers(runtime.store.public_origin, is_https=runtime.settings.is_https)
    app.state.security_headers = headers
    app.add_middleware(TusHeaders)
    app.add_middleware(WithResponseHeaders, headers=headers)
    if runtime.settings.is_https:
        app.add_middleware(HostCookies)
    if runtime.settings.trusted_proxies:  # who visits, read from right to left up to the first who is not one of them
        from granian.utils.proxies import wrap_asgi_with_proxy_headers

        app.add_middleware(wrap_asgi_with_proxy_headers, trusted_hosts=list(runtime.settings.trusted_proxies))
    _serve_frontend(app, runtime.settings.frontend_dir)
    return app


async def _sweep(runtime: Runtime) -> None:
    """Clear away, now and then, old answers, and what was left unfinished on this process's own disk."""
    while True:
        await asyncio.sleep(SWEEP_EVERY_S)
        try:
            await asyncio.to_thread(Uploads(runtime.database, runtime.store).sweep)
            await asyncio.to_thread(delete_expired_responses, runtime.database)
            await asyncio.to_thread(forget_old_changes, runtime.database)
        except Exception:
            log.exception("old uploads and answers could not be cleared away")


def _serve_frontend(app: FastAPI, folder: Path) -> None:
    @app.get("/help", include_in_schema=False)
    def help_() -> Response:
        """Answer with the address of the guides, whose links start from their folder."""
        return RedirectResponse("/help/")

    @app.get("/{path:path}", include_in_schema=False)
    def page(path: str) -> Response:
        """Answer every address that is not the API's with the one page, which routes by itself."""
        if path.startswith("v1/") or not (folder / "index.html").is_file():
            detail = f"nothing is at /{path}" if path.startswith("v1/") else "the frontend is not built; run make"
            problem = {"title": "Not found", "status": 404, "code": "not-found", "detail": detail}
            return JSONResponse(problem, 404, media_type=PROBLEM_TYPE)
        named = _file_in(folder, path)
        if named is not None:
            return FileResponse(named)
        return FileResponse(folder / "index.html")


def _file_in(folder: Path, path: str) -> Path | None:
    """Return the file of the frontend at this address; None if there is none, or the path leaves the folder."""
    try:
        named = (folder / path).resolve()
        if path and (named / "index.html").is_file():
            named /= "index.html"
        return named if path and named.is_file() and named.is_relative_to(folder.resolve()) else None
    except (OSError, ValueError):  # a name that no file system takes
        return None
