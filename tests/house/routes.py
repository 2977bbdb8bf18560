"""The table of routes, read from the application itself, and a request that each would accept."""

import base64
import hashlib
import inspect
import json
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any
from uuid import UUID

from fastapi import params
from fastapi.routing import APIRoute, iter_route_contexts
from httpx import Response
from httpx2 import Client
from starlette.routing import BaseRoute

from app.accounts.rules import Policy
from app.accounts.web.policies import PolicyDependency
from app.routers import ROUTERS
from tests.house.library_objects import SHEET_BASE64
from tests.house.objects import FILE, PASSWORD, House
from tests.house.reports import report

DOCUMENT = Path(__file__).parents[2] / "frontend" / "openapi.json"
Schema = dict[str, Any]


@dataclass(frozen=True)
class Operation:
    """One method of one path, and what its endpoint declares."""

    name: str
    method: str
    path: str
    policy: Policy
    query: tuple[str, ...]
    body: Any  # an example, with ids still by name

    @property
    def parameters(self) -> tuple[str, ...]:
        """The names that stand in the path."""
        return tuple(part[1:-1] for part in self.path.split("/") if part.startswith("{"))


def api_routes(routes: Iterable[BaseRoute]) -> Iterator[APIRoute]:
    """Yield the routes of routers, those of included routers too."""
    for context in iter_route_contexts(list(routes)):
        if isinstance(context.original_route, APIRoute):
            yield context.original_route


def policy_of(route: APIRoute) -> Policy | None:
    """Return the policy that a route's endpoint declares, None when it forgot."""
    for parameter in inspect.signature(route.endpoint, eval_str=True).parameters.values():
        for given in (parameter.default, *getattr(parameter.annotation, "__metadata__", ())):
            if isinstance(given, params.Depends) and isinstance(given.dependency, PolicyDependency):
                return given.dependency.policy
    return None


@cache
def document() -> dict[str, Any]:
    """Return the OpenAPI document of the rooms, operations named after their endpoints.

    It is the committed one, which `make check` holds to be current: to write it takes 8 s in each process of a run.
    """
    document: dict[str, Any] = json.loads(DOCUMENT.read_text())
    return document


@cache
def operations() -> list[Operation]:
    """Return every operation of the API."""
    policies = {route.name: policy_of(route) for router in ROUTERS for route in api_routes(router.routes)}
    found = []
    for path, methods in document()["paths"].items():
        for method, said in methods.items():
            policy = policies.get(said["operationId"])
            if policy is None:
                continue  # test_every_endpoint_declares_its_policy names it
            json_body = said.get("requestBody", {}).get("content", {}).get("application/json")
            query = tuple(one["name"] for one in said.get("parameters", ()) if one["in"] == "query")
            body = example(json_body["schema"], "") if json_body else None
            found.append(Operation(said["operationId"], method.upper(), path, policy, query, body))
    return found


@dataclass(frozen=True)
class Named:
    """An id that a body names, filled in from the house."""

    name: str


EXAMPLES: dict[str, Any] = {
    "email": "someone@example.test",
    "roles": ["reviewer"],
    "scopes": ["spec:read"],
    "cue_prefix": "DS",
    "password": PASSWORD,
    "current": PASSWORD,
    "new": PASSWORD,
    "tables": {"format": 1},
    "cues": [{"name": "Radar ping"}],
    "report": report(),
    "paid_on": "2026-11-20",
    "worked_on": "2026-11-20",
    "shipped_on": "2026-11-20",
    "decided_on": "2026-11-20",
    "from_on": "2998-11-20",
    "until_on": "2998-11-21",
    "currency": "USD",
    "clauses": [{"key": "parties", "title": "Parties", "text": "Between us."}],
    "terms": {},
}


def example(schema: Schema, name: str) -> Any:
    """Return the least that a schema accepts, under the name of the property that holds it."""
    if "$ref" in schema:
        return example(document()["components"]["schemas"][schema["$ref"].rpartition("/")[2]], name)
    if name in EXAMPLES:
        return EXAMPLES[name]
    for choice in (*schema.get("anyOf", ()), *schema.get("oneOf", ())):
        if choice.get("type") != "null":
            return example(choice, name)
    if "enum" in schema or "const" in schema:
        return schema.get("const", schema.get("enum", [None])[0])
    match schema.get("type"):
        case "object":
            return {key: example(schema["properties"][key], key) for key in schema.get("required", ())}
        case "array":
            return [example(schema["items"], name.removesuffix("s"))] if schema.get("minItems") else []
        case "string":
            return Named(name) if schema.get("format") == "uuid" else "x" * max(1, schema.get("minLength", 1))
        case "integer" | "number":
            return max(1, schema.get("minimum", 1))
        case "boolean":
            return True
        case other:
            raise AssertionError(f"no example for {name}: {other}")


TUS = {"Tus-Resumable": "1.0.0"}


def _metadata(delivery_id: UUID) -> str:
    values = {"delivery_id": str(delivery_id), "file_name": "shield_hit.wav"}
    return ",".join(f"{key} {base64.b64encode(value.encode()).decode()}" for key, value in values.items())


def ask(client: Client, house: House, operation: Operation) -> Response:
    """Send a request that is right in everything but, perhaps, in who sends it."""
    ids = house.ids
    secret = house.links.get(operation.path.split("/")[2], "")
    path = operation.path.format(**ids, secret=secret)
    params = {name: str(ids[name]) for name in operation.query if name in ids and name != "version"}
    more: dict[str, Any] = {}
    match operation.name:
        case "begin_upload":
            more["headers"] = TUS | {
                "Upload-Length": str(len(FILE)),
                "Upload-Metadata": _metadata(ids["delivery_id"]),
            }
        case "continue_upload":
            more["headers"] = TUS | {"Upload-Offset": "0", "Content-Type": "application/offset+octet-stream"}
            more["content"] = FILE
        case "save_my_picture":
            more["content"] = b"GIF89a"
        case "see_upload" | "cancel_upload":
            more["headers"] = TUS
        case "put_upload" | "add_file":
            more["headers"] = {"X-Content-SHA256": hashlib.sha256(FILE).hexdigest()}
            more["content"] = FILE
            params["file_name"] = "shield_hit.wav"
        case _:
            if operation.body is not None:
                more["json"] = _filled(_adjusted(operation), house)
    params |= QUERIES.get(operation.name, {})
    return client.request(operation.method, path, params=params, **more)


# What a schema cannot say.
QUERIES: dict[str, dict[str, str]] = {
    "download_pack": {"target": "game"},
    "compare_revisions": {"from": "0", "to": "0"},
    "find": {"q": "shield"},
    "list_versions_with_reason": {"kind": "change", "reason": "Too loud"},
    "list_security_events": {"kind": "sign_in"},
    "download_security_events": {"kind": "sign_in"},
    "watch_changes": {"seconds": "0"},
    "guess_category": {"name": "door slam"},
    "read_cue_matrix": {"line": "deck, sand × walk, run × 2"},
    "compare_contract_versions": {"from_version": "1", "to_version": "1"},
}
ADJUSTED: dict[str, dict[str, Any]] = {
    "accept_drift": {"path": "shield_hit.wav"},
    "send_sound_back": {"path": "shield_hit.wav"},
    "add_archive": {"file_name": "sounds.zip"},
    "add_reference": {"url": "https://example.test/clip"},
    "add_reference_version": {"url": "https://example.test/clip"},
    "add_guest_link": {"cue_ids": [Named("cue_id")]},
    "add_playlist": {"take_ids": [Named("take_id")]},
    "move_playhead": {"take_id": Named("take_id"), "sequence": 1},
    "set_bed": {"reference_id": Named("reference_id")},
    "add_comparison": {"target": "game"},
    "add_webhook": {"url": "https://hooks.example.com/in", "events": ["pack.made"]},
    "add_take": {"file_name": "shield_hit.wav"},
    "check_spec_draft": {"tables": {"format": 1}},
    "import_voice_lines": {"format": "paste", "text": "character\ttext\nCaptain\tGo.", "dry_run": True},
    "add_voice_release": {"upload_id": Named("voice_upload_id"), "valid_from": "2026-01-01"},
    "import_sound_list": {"format": "paste", "text": "name\nRadar ping", "dry_run": True},
    "import_into_roster": {"format": "paste", "text": "name\temail\nA\ta@example.test", "dry_run": True},
    "invite_from_roster": {"entry_ids": [Named("roster_entry_id")]},
    "add_reel_sound": {"upload_id": Named("reel_upload_id")},
    "read_roster_calendar": {"content_base64": base64.b64encode(b"BEGIN:VCALENDAR\nEND:VCALENDAR\n").decode()},
    "record_spoken_placeholder": {"content_base64": base64.b64encode(b"RIFF\x04\x00\x00\x00WAVE").decode()},
    "change_cue": {"name": "Shield hit"},
    "add_sound_library": {"content_base64": SHEET_BASE64},
    "add_bid_note": {"held_on": "2026-01-01", "text": "Clear."},
    "add_bid_sample": {"line_key": "", "content_base64": base64.b64encode(b"RIFF\x04\x00\x00\x00WAVE").decode()},
}


def _adjusted(operation: Operation) -> Any:
    return {**operation.body, **ADJUSTED.get(operation.name, {})}


def _filled(value: Any, house: House) -> Any:
    if isinstance(value, Named):
        return str(house.finished_upload.id if value.name == "upload_id" else house.ids[value.name])
    if isinstance(value, dict):
        return {key: _filled(one, house) for key, one in value.items()}
    if isinstance(value, list):
        return [_filled(one, house) for one in value]
    return value
