"""What we use of FastAPI and Starlette beside their documentation is in the pinned versions, and in one module."""

import inspect
import re
import tomllib
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path
from typing import Any

import pytest
from fastapi import APIRouter, Depends, FastAPI
from fastapi.dependencies.models import Dependant
from fastapi.routing import APIRoute, RouteContext, iter_route_contexts
from fastapi.testclient import TestClient
from pydantic import BaseModel
from starlette.routing import Match, Route, compile_path

from app.kit.fastapi_internals import InterceptedRoute, Router

ROOT = Path(__file__).parents[3]
PRIVATE = re.compile(
    r"(fastapi|starlette)\._|fastapi\.dependencies|\.dependant\b|\.body_field\b|\.response_field\b|starlette\.routing|"
    r"original_router|iter_route_contexts|super\(\)\.(matches|handle)\("
)
USED: dict[Callable[..., Any], tuple[str, ...]] = {  # and the parameters that are passed
    Route.handle: ("scope", "receive", "send"),
    APIRouter.matches: ("scope",),
    compile_path: ("path",),
    iter_route_contexts: ("routes",),
}


class Echoed(BaseModel):
    """An answer."""

    number: int


async def outer() -> str:
    return "outer"


async def inner(of: str = Depends(outer)) -> str:
    return of


def route_of(**more: Any) -> InterceptedRoute:
    router = APIRouter(route_class=InterceptedRoute)

    @router.post("/echo", **more)
    def echo(body: Echoed, who: str = Depends(inner)) -> Echoed:
        return body

    (route,) = router.routes
    assert isinstance(route, InterceptedRoute)
    return route


@pytest.mark.parametrize("package", ["fastapi", "starlette"])
def test_one_exact_version_is_pinned_and_installed(package: str):
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    assert f"{package}=={version(package)}" in project["optional-dependencies"]["server"]


@pytest.mark.parametrize("used", USED, ids=lambda used: used.__qualname__)
def test_each_takes_the_parameters_that_we_pass(used: Callable[..., Any]):
    known = [name for name in inspect.signature(used).parameters if name != "self"]
    assert known == list(USED[used])


def test_a_route_has_the_attributes_that_we_read():
    route = route_of()
    assert isinstance(route.dependant, Dependant)
    assert [dependency.call for dependency in route.dependant.dependencies] == [inner]
    assert route.body_field is not None
    assert route.response_field is not None
    assert route.response_field.validate(Echoed(number=3), loc=("response",)) == (Echoed(number=3), [])
    assert route.response_field.serialize_json(Echoed(number=3)) == b'{"number":3}'
    assert isinstance(RouteContext.path, property)


def test_dependencies_are_found_with_those_that_they_have():
    assert list(route_of().dependencies_called()) == [inner, outer]


def test_an_answer_is_the_json_that_fastapi_would_send():
    route = route_of(status_code=201)
    answer = route.as_json(Echoed(number=3))
    assert (answer.status_code, answer.body) == (201, b'{"number":3}')
    assert route.as_json("no number") == "no number"  # FastAPI refuses it


def test_a_room_is_left_out_unless_one_of_its_addresses_is_requested(monkeypatch: pytest.MonkeyPatch):
    looked: list[str] = []
    matches = APIRouter.matches
    monkeypatch.setattr(APIRouter, "matches", lambda self, scope: looked.append(scope["path"]) or matches(self, scope))
    within, room, app = APIRouter(), Router(prefix="/v1"), FastAPI()
    within.add_api_route("/doors/{door}", lambda door: door)
    room.add_api_route("/walls/{wall}", lambda wall: wall)
    room.include_router(within, prefix="/in")
    app.include_router(room)
    client = TestClient(app)
    assert client.get("/v1/walls/north").status_code == client.get("/v1/in/doors/south").status_code == 200
    assert {"/v1/walls/north", "/v1/in/doors/south"} <= set(looked)
    assert client.get("/v1/roof").status_code == 404
    assert "/v1/roof" not in looked
    assert room.matches({"type": "http", "path": "/v1/roof", "method": "GET"}) == (Match.NONE, {})


def test_a_room_within_a_room_is_refused_at_once():
    with pytest.raises(TypeError, match="make it an APIRouter"):
        Router().include_router(Router())


@pytest.mark.slow
def test_nothing_else_touches_them():
    touching = [
        str(path.relative_to(ROOT)) for path in (ROOT / "app").rglob("*.py") if PRIVATE.search(path.read_text())
    ]
    assert touching == ["app/kit/fastapi_internals.py"]
    assert issubclass(InterceptedRoute, APIRoute)
