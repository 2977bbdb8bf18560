"""An endpoint has one thread, and no answer leaves before the caller is authenticated."""

import threading
from collections.abc import Iterator
from contextlib import asynccontextmanager, contextmanager
from typing import Annotated, Any

import pytest
from fastapi import APIRouter, Depends, FastAPI, Request
from fastapi.testclient import TestClient
from pydantic import BaseModel, model_serializer

from app.kit import error_responses
from app.kit.errors import Refused
from app.kit.single_thread_route import LazyAuthentication, LazySession, SingleThreadRoute

THREADS: dict[str, int] = {}


class Stranger(Refused):
    """The caller is not authenticated."""

    status = 401


class Noted(BaseModel):
    """An answer that notes where its JSON is made."""

    who: str

    @model_serializer
    def _written(self) -> dict[str, Any]:
        note("json")
        return {"who": self.who}


class Body(BaseModel):
    """What is sent."""

    figure: int


def note(what: str) -> None:
    THREADS[what] = threading.get_ident()


async def authenticated(request: Request) -> LazyAuthentication:
    def look() -> str:
        note("asking")
        if "who" not in request.query_params:
            raise Stranger("you are not signed in; sign in to continue")
        return str(request.query_params["who"])

    return LazyAuthentication(request, look)


async def session() -> LazySession:
    @asynccontextmanager
    async def slot() -> Any:
        note("seat")
        yield

    @contextmanager
    def opened() -> Iterator[Any]:
        note("begun")
        yield "a session"
        note("ended")

    return LazySession(slot, opened)


Who = Annotated[str, Depends(authenticated)]
Opened = Annotated[str, Depends(session)]


@pytest.fixture
def client() -> TestClient:
    router = APIRouter(route_class=SingleThreadRoute)

    @router.post("/noted")
    def write_note(body: Body, opened: Opened, who: Who) -> Noted:
        note("endpoint")
        return Noted(who=f"{who}, {body.figure}, {opened}")

    @router.get("/streamed")
    async def stream(
        authenticate: Annotated[LazyAuthentication, Depends(authenticated)], *, forgets: bool = False
    ) -> dict[str, str]:
        return {"who": "anyone" if forgets else authenticate()}

    app = FastAPI()
    app.include_router(router)
    error_responses.install(app, credential_cookies=())
    return TestClient(app, raise_server_exceptions=False)


def test_all_of_a_request_is_done_in_one_thread(client: TestClient) -> None:
    THREADS.clear()
    answer = client.post("/noted", params={"who": "Ida"}, json={"figure": 3})
    assert (answer.status_code, answer.json()) == (200, {"who": "Ida, 3, a session"})
    assert list(THREADS) == ["seat", "asking", "begun", "endpoint", "ended", "json"]
    loop = THREADS.pop("seat")
    assert set(THREADS.values()) == {THREADS["endpoint"]} != {loop}


def test_a_stranger_does_not_learn_what_is_wrong_with_what_they_sent(client: TestClient) -> None:
    assert client.post("/noted", params={"who": "Ida"}, json={"figure": "three"}).status_code == 422
    assert client.post("/noted", json={"figure": "three"}).json()["code"] == "stranger"


def test_an_answer_that_nobody_was_asked_for_never_leaves(client: TestClient) -> None:
    assert client.get("/streamed", params={"who": "Ida"}).json() == {"who": "Ida"}
    assert client.get("/streamed").status_code == 401
    answer = client.get("/streamed", params={"who": "Ida", "forgets": True})
    assert (answer.status_code, answer.json()["code"]) == (500, "our-fault")
