"""Imports scripts and reads voice lines over HTTP, as a producer's page does."""

import base64
import io
from collections.abc import Sequence
from typing import Any

import xlsxwriter
from httpx import Response
from httpx2 import Client

from tests.support.deliver import checked, deliver, open_delivery
from tests.support.server import World
from tests.support.waves import sine, wav_bytes

SHEET = """Line ID,Character,Scene,Direction,English,German
captain_010,Captain,Bridge,quietly,By the light of a hundred suns.,Beim Licht von hundert Sonnen.
captain_020,Captain,,,Hold the line.,Haltet die Stellung.
maya_010,Maya,Hangar,out of breath,It is still open!,Es ist noch offen!
"""


def send(world: World, by: Client | None = None, *, dry_run: bool = False, **body: Any) -> Response:
    """Send a script as it is."""
    ask = {"format": "csv", "dry_run": dry_run} | body
    return (by or world.producer).post(f"/v1/projects/{world.project_id}/voice-lines/import", json=ask)


def sent(world: World, text: str = SHEET, **body: Any) -> dict[str, Any]:
    """Send a script as text, and return what the server read."""
    answer = send(world, text=text, **body)
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def imported(world: World, text: str = SHEET, **body: Any) -> dict[str, Any]:
    """Import a script without errors."""
    read = sent(world, text, **body)
    assert read["imported"], read["errors"]
    return read


def encoded(data: bytes) -> str:
    """Return bytes as a request has them."""
    return base64.b64encode(data).decode()


def workbook(rows: Sequence[Sequence[Any]], merged: Sequence[str] = ()) -> bytes:
    """Return a workbook of one sheet; of merged ranges the first cell has the text."""
    out = io.BytesIO()
    book = xlsxwriter.Workbook(out, {"in_memory": True})
    sheet = book.add_worksheet()
    for place, cells in enumerate(rows):
        sheet.write_row(place, 0, cells)
    for area in merged:
        sheet.merge_range(area, "")
        first = area.partition(":")[0]
        row, column = int(first[1:]) - 1, ord(first[0]) - ord("A")
        sheet.write(row, column, rows[row][column])
    book.close()
    return out.getvalue()


def lines(world: World, by: Client | None = None, **query: Any) -> dict[str, dict[str, Any]]:
    """Return the voice lines of a language by their ids in the script."""
    answer = (by or world.producer).get(f"/v1/projects/{world.project_id}/voice-lines", params=query)
    assert answer.status_code == 200, answer.text
    return {line["key"]: line for line in answer.json()["lines"]}


def pick_ups(world: World, by: Client | None = None, **query: Any) -> dict[tuple[str, str], str]:
    """Return why which line must be recorded, by language and id."""
    answer = (by or world.producer).get(f"/v1/projects/{world.project_id}/pick-ups", params=query)
    assert answer.status_code == 200, answer.text
    return {(line["language"], line["key"]): line["reason"] for line in answer.json()["lines"]}


def sound(seconds: float, rate: int = 44_100) -> bytes:
    """Return a tone that the spec of the test studio takes."""
    return wav_bytes(sine(hz=440, dbfs=-12, seconds=seconds, rate=rate), rate=rate, bits=16)


def recorded(world: World, name: str, seconds: float = 1.0, *, approve: bool = False) -> dict[str, Any]:
    """Deliver a take, wait for its check, and approve it where that is wanted."""
    take = deliver(world, name, sound(seconds), delivery_id=open_delivery(world))
    checked(world, take["id"])
    if approve:
        decided(world, take, kind="approve", note="")
    return take


def decided(world: World, take: dict[str, Any], **verdict: Any) -> None:
    """Give a verdict on a take as the approver."""
    answer = world.approver.post(f"/v1/takes/{take['id']}/verdict", json=verdict)
    assert answer.status_code in (200, 201), answer.text
