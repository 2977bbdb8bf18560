"""The web process: rooms behind one FastAPI application, and the built frontend."""

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

import structlog
from fastapi import FastAPI, Response
from fastapi.responses import FileResponse, JSONResponse
from starlette.datastructures import MutableHeaders
from starlette.staticfiles import StaticFiles
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app import rooms
from app.accounts.doors import DEMO_COOKIE, SESSION_COOKIE
from app.kit import events, health, http
from app.kit.runtime import Runtime
from app.kit.uploads import Uploads
from app.migrate import ensure_at_head

SWEEP_EVERY_S = 3600.0
log = structlog.get_logger(__name__)


def content_security_policy(store_origin: str | None) -> str:
    """Return what the page may load; from the store, if browsers are sent there, sounds and nothing else."""
    store = f" {store_origin}" if store_origin else ""
    return (
        f"default-src 'self'; connect-src 'self'{store}; img-src 'self' data: blob:; media-src 'self' blob:{store}; "
        "style-src 'self' 'unsafe-inline'; object-src 'none'; base-uri 'none'; frame-ancestors 'none'; "
        "form-action 'self'"
    )


def create_app(runtime: Runtime) -> FastAPI:
    """Wire one web process."""

    @asynccontextmanager
    async def lifespan(_app: FastAPI) -> AsyncIterator[None]:
        sweeping = asyncio.create_task(_sweep_uploads(runtime))
        yield
        sweeping.cancel()
        runtime.close()

    app = FastAPI(
        title="Soundlist",
        version="1",
        description="Sound lists, deliveries, reviews and packs; one spec and one verdict everywhere.",
        openapi_url="/v1/openapi.json",
        docs_url="/docs",
        redoc_url=None,
        lifespan=lifespan,
        generate_unique_id_function=lambda route: route.name,
    )
    app.state.runtime = runtime
    app.state.readiness = health.Readiness(runtime, {**health.PROBES, "migrations": ensure_at_head})
    events.connect(rooms.SUBSCRIBERS, patient=rooms.PATIENT_JOBS)
    http.install(app, credential_cookies=(SESSION_COOKIE, DEMO_COOKIE))
    for router in rooms.ROUTERS:
        app.include_router(router)
    app.include_router(health.router)
    app.add_middleware(_WithSecurityHeaders, policy=content_security_policy(runtime.store.public_origin))
    _serve_frontend(app, runtime.settings.frontend_dir)
    return app


async def _sweep_uploads(runtime: Runtime) -> None:
    """Clear away, now and then, what was left unfinished on this process's own disk, which no worker may see."""
    while True:
        await asyncio.sleep(SWEEP_EVERY_S)
        try:
            await asyncio.to_thread(Uploads(runtime.database, runtime.store).sweep)
        except Exception:
            log.exception("uploads could not be swept")


class _WithSecurityHeaders:
    """Tells browsers what a page of ours may load and do."""

    def __init__(self, app: ASGIApp, policy: str) -> None:
        self._app = app
        self._policy = policy

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        async def say(message: Message) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                headers.setdefault("X-Content-Type-Options", "nosniff")
                headers.setdefault("Referrer-Policy", "same-origin")
                if not scope["path"].startswith("/docs"):
                    headers.setdefault("Content-Security-Policy", self._policy)
            await send(message)

        await self._app(scope, receive, say)


def _serve_frontend(app: FastAPI, folder: Path) -> None:
    if (folder / "assets").is_dir():
        app.mount("/assets", StaticFiles(directory=folder / "assets"), name="assets")

    @app.get("/{path:path}", include_in_schema=False)
    def page(path: str) -> Response:
        """Answer every address that is not the API's with the one page, which routes by itself."""
        if path.startswith("v1/") or not (folder / "index.html").is_file():
            detail = f"nothing is at /{path}" if path.startswith("v1/") else "the frontend is not built; run make"
            return JSONResponse({"title": "Not found", "status": 404, "code": "not-found", "detail": detail}, 404)
        named = (folder / path).resolve()
        if path and named.is_file() and named.is_relative_to(folder.resolve()):
            return FileResponse(named)
        return FileResponse(folder / "index.html", headers={"Cache-Control": "no-cache"})
