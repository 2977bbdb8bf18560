"""Some hundred hostile requests, other ones each week; `python -m tests.attack.hostile_requests` sends more."""

import datetime as dt
from collections.abc import Iterator
from typing import Any

import pytest

from app.core.web import bodies
from tests.attack.hostile_requests import Outcome, running_application, send_to_application
from tests.house.routes import document

REQUESTS = 600
KEPT_AS_JSON = {"terms", "summary"}  # whole numbers in there are never in a column


def this_week() -> int:
    year, week, _ = dt.datetime.now(dt.UTC).isocalendar()
    return year * 100 + week


@pytest.mark.slow
@pytest.mark.parametrize("database", ["sqlite", "postgres"])
def test_no_request_breaks_the_server(database: str):
    with running_application(database) as server:
        outcome: Outcome = send_to_application(server, this_week(), REQUESTS)
    assert outcome.failures == {}
    assert outcome.statuses[200] > REQUESTS // 20  # else nothing came as far as the database


def whole_numbers(
    schema: dict[str, Any], name: str, seen: tuple[str, ...] = ()
) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield every whole number of a schema, with its name."""
    if "$ref" in schema:
        model = schema["$ref"].rpartition("/")[2]
        if model not in seen:
            yield from whole_numbers(document()["components"]["schemas"][model], name, (*seen, model))
        return
    for choice in schema.get("anyOf", ()):
        yield from whole_numbers(choice, name, seen)
    if schema.get("type") == "integer" and "const" not in schema:
        yield name, schema
    if "items" in schema:
        yield from whole_numbers(schema["items"], name, seen)
    for key, one in schema.get("properties", {}).items():
        if key not in KEPT_AS_JSON:
            yield from whole_numbers(one, f"{name}.{key}", seen)


def test_every_whole_number_that_is_taken_has_a_largest():
    found = []
    for methods in document()["paths"].values():
        for said in methods.values():
            json_body = said.get("requestBody", {}).get("content", {}).get("application/json")
            if json_body:
                found += whole_numbers(json_body["schema"], said["operationId"])
            for parameter in said.get("parameters", ()):
                found += whole_numbers(parameter["schema"], f"{said['operationId']}?{parameter['name']}")
    assert len(found) > 20
    assert [name for name, schema in found if schema.get("maximum", bodies.LARGEST_INTEGER + 1) > 2**53 - 1] == []
