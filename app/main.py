"""The web process: rooms behind one FastAPI application, and the built frontend."""

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

from fastapi import FastAPI, Request, Response
from fastapi.responses import FileResponse, JSONResponse
from starlette.staticfiles import StaticFiles

from app import rooms
from app.accounts.doors import DEMO_COOKIE, SESSION_COOKIE
from app.kit import events, health, http
from app.kit.runtime import Runtime
from app.settings import Settings

CONTENT_SECURITY_POLICY = (
    "default-src 'self'; img-src 'self' data: blob:; media-src 'self' blob:; style-src 'self' 'unsafe-inline'; "
    "object-src 'none'; base-uri 'none'; frame-ancestors 'none'; form-action 'self'"
)


def create_app(runtime: Runtime) -> FastAPI:
    """Wire one web process."""

    @asynccontextmanager
    async def lifespan(_app: FastAPI) -> AsyncIterator[None]:
        yield
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
    events.connect(runtime.queue, rooms.SUBSCRIBERS)
    http.install(app, credential_cookies=(SESSION_COOKIE, DEMO_COOKIE))
    for router in rooms.ROUTERS:
        app.include_router(router)
    app.include_router(health.router)
    _serve_frontend(app, runtime.settings.frontend_dir)
    return app


def _serve_frontend(app: FastAPI, folder: Path) -> None:
    @app.middleware("http")
    async def _with_security_headers(request: Request, call_next: http.CallNext) -> Response:
        response = await call_next(request)
        response.headers.setdefault("X-Content-Type-Options", "nosniff")
        response.headers.setdefault("Referrer-Policy", "same-origin")
        if not request.url.path.startswith("/docs"):
            response.headers.setdefault("Content-Security-Policy", CONTENT_SECURITY_POLICY)
        return response

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


def app_from_environment() -> FastAPI:
    """Build the application that uvicorn serves."""
    return create_app(Runtime.of(Settings()))
