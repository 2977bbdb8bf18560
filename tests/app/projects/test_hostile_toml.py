"""TOML and tables that make parsers slow, deep or large are refused in words by each endpoint that takes them."""

from typing import Any

import pytest

from tests.support.server import World

TEXTS = {
    "60 kB of dots": "format = 1\n" + ".".join("a" * 30_000) + " = 1\n",
    "a deep table of files": 'format = 1\nname = "x"\n[files]\n' + "a." * 500 + 'a = "x"\n',
    "a deep head": "[files." + "a." * 5_000 + "a]\n",
    "deep arrays": "a = " + "[" * 30_000,
    "deep inline tables": "a = " + "{a=" * 20_000,
    "a wide array": "format = 1\na = [" + "0," * 90_000 + "0]\n",
    "many tables": "".join(f"[a.b{number}.c]\n" for number in range(10_000)),
    "a text of 1 MB": 'format = 1\nname = "' + "x" * 1_000_000 + '"\n',
    "a text of 190 kB": 'format = 1\nname = "' + "x" * 190_000 + '"\n',
    "a number of 5,000 digits": "format = " + "9" * 5_000 + "\n",
}


def deep(levels: int) -> dict[str, Any]:
    table: dict[str, Any] = {"a": "x"}
    for _ in range(levels):
        table = {"a": table}
    return table


TABLES = {
    "deep": {"format": 1, "name": "x", "files": deep(180)},
    "wide": {"format": 1, "name": "x", "files": {f"a{number}": number for number in range(50_000)}},
    "a long text": {"format": 1, "name": "x" * 1_000_000},
    "a long list": {"format": 1, "name": "x", "naming": {"allowed": ["x"] * 100_000}},
    "keys that are not keys": {"format": 1, "": {"\n": {"a.b]": []}}, "\ufeff": None},
}


def ensure_refused(world: World, method: str, path: str, body: dict[str, Any]) -> None:
    answer = world.producer.request(method, path, json=body)
    assert answer.status_code == 422, answer.text[:300]
    assert answer.json()["detail"]
    assert len(answer.content) < 20_000


@pytest.mark.slow
@pytest.mark.parametrize("text", TEXTS.values(), ids=TEXTS)
def test_hostile_text_is_refused_everywhere(world: World, text: str) -> None:
    spec = f"/v1/projects/{world.project_id}/spec"
    ensure_refused(world, "PUT", spec, {"toml": text, "based_on_version": 1})
    ensure_refused(world, "POST", f"{spec}/check-toml", {"toml": text})
    ensure_refused(world, "POST", f"/v1/studios/{world.studio_id}/contract-templates/import", {"toml": text})


@pytest.mark.slow
@pytest.mark.parametrize("tables", TABLES.values(), ids=TABLES)
def test_a_hostile_form_is_refused(world: World, tables: dict[str, Any]) -> None:
    spec = f"/v1/projects/{world.project_id}/spec"
    ensure_refused(world, "POST", f"{spec}/form", {"tables": tables, "based_on_version": 1})
    ensure_refused(world, "POST", f"{spec}/check-toml", {"tables": tables})
