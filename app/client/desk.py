"""`soundlist desk`: what a designer owes on all servers, what is due soonest first."""

import argparse
import getpass
import json
import os
import shutil
import sys
import webbrowser
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from datetime import date, datetime
from pathlib import Path
from typing import Any
from urllib.parse import quote, urlsplit

from app.client.desk_page import Line, cache_path, html_of, write_page
from app.client.desk_servers import DeskServer, file_path, read_servers, write_servers
from app.client.errors import DONE, REFUSED, UNREACHABLE, Refusal, ServerUnreachable
from app.client.server import Server
from app.client.settings import TOKEN, ensure_token, safe_address
from app.client.terminal import counted, say, shown, warn

FORMAT = 1
AT_ONCE = 8
RETRY_DELAYS_S = (0.5,)
MAX_PAGES = 25  # of 200 cues each
NO_DAY = "9999-12-31"
STATES = {
    "to_make": "to do",
    "placeholder": "to do",
    "partly_accepted": "to do in part",
    "question": "question asked",
    "returned": "returned by the check",
    "unjudged": "not checked: our fault",
    "change_requested": "change requested",
}
HEADS = ("due", "cue", "name", "state", "project", "studio", "server", "said last")


@dataclass
class Answer:
    """One server's answer, or the reason for its silence."""

    server: DeskServer
    cues: list[dict[str, Any]] = field(default_factory=list)
    person: str | None = None
    problem: str | None = None
    code: int = DONE
    is_whole: bool = True


def desk(options: argparse.Namespace) -> int:
    """Print the owed work on all servers; return the exit code."""
    servers = list(read_servers().values())
    if not servers:
        raise Refusal("no server yet; create a token on your page Account, then: soundlist desk add https://…")
    if options.server is not None:
        servers = [server for server in servers if server.name == options.server]
        if not servers:
            raise Refusal(f'no server is called "{options.server}"; soundlist desk list names them')
    with ThreadPoolExecutor(AT_ONCE) as pool:
        answers = list(pool.map(_ask, servers))
    cues = sorted(
        (cue for answer in answers for cue in answer.cues),
        key=lambda cue: (cue["due_on"] or NO_DAY, cue["server"], cue["project"], cue["cue"]),
    )
    if options.page is None:
        _report(answers, cues, as_json=options.format == "json")
    else:
        _show_page(answers, cues, options.page)
    for remark in _remarks(answers):
        warn(remark)
    codes = {answer.code for answer in answers}
    return REFUSED if REFUSED in codes else UNREACHABLE if UNREACHABLE in codes else DONE


def add(options: argparse.Namespace) -> int:
    """Keep a server with its token, once the server knows the token."""
    address = safe_address(options.address, allow_http=False)
    servers = read_servers()
    host = urlsplit(address)
    name = options.name or (f"{host.hostname}:{host.port}" if host.port else str(host.hostname))
    if not name.isprintable() or not name.strip():
        raise Refusal("the name of a server is one line that can be read")
    server = DeskServer(name, address, _read_token())
    answer = _ask(server, pages=1)
    if answer.code == UNREACHABLE:
        raise ServerUnreachable(answer.problem)
    if answer.problem is not None:
        raise Refusal(answer.problem)
    write_servers({**servers, name: server})
    say(f"{shown(name)}: signed in as {shown(str(answer.person))}; kept in {shown(str(file_path()))}")
    return DONE


def list_servers(_options: argparse.Namespace) -> int:
    """Print the servers without their tokens."""
    for server in read_servers().values():
        say(f"{shown(server.name)}  {shown(server.address)}")
    return DONE


def remove(options: argparse.Namespace) -> int:
    """Forget a server and its token."""
    servers = read_servers()
    if options.name not in servers:
        raise Refusal(f'no server is called "{options.name}"; soundlist desk list names them')
    del servers[options.name]
    write_servers(servers)
    say(f"{shown(options.name)} is removed. Its token is valid until you revoke it on your page Account.")
    return DONE


def _read_token() -> str:
    token = os.environ.get(TOKEN, "").strip()
    if token:
        named = TOKEN
    elif sys.stdin.isatty():
        named, token = "what was typed", getpass.getpass("Token of your page Account: ").strip()
    else:
        named, token = "standard input", sys.stdin.readline(1_000).strip()
    if not token:
        raise Refusal(f"a token is needed: type it, send it to standard input, or set {TOKEN}")
    ensure_token(token, named)
    return token


def _ask(server: DeskServer, pages: int = MAX_PAGES) -> Answer:
    """Return every cue that one server's person owes there."""
    answer = Answer(server)
    asked = Server(server.source, retry_delays_s=RETRY_DELAYS_S, redirects=False)
    cursor: str | None = None
    try:
        for _ in range(pages):
            page = asked.of_person("desk", cursor=cursor)
            answer.person = str(page["person"]["name"])
            answer.cues += [_cue(server, owed_cue) for owed_cue in page["items"]]
            cursor = page["next"]
            if cursor is None:
                break
        answer.is_whole = cursor is None
    except ServerUnreachable as error:
        answer.problem, answer.code = f"cannot be reached: {error}", UNREACHABLE
    except Refusal as refusal:
        answer.problem, answer.code = str(refusal), REFUSED
    except (KeyError, TypeError, ValueError):
        answer.problem, answer.code = "its answer is not understood; is this program too old?", REFUSED
    return answer


def _cue(server: DeskServer, owed_cue: Any) -> dict[str, Any]:
    last = owed_cue["latest_comment"]
    if owed_cue["due_on"] is not None:
        date.fromisoformat(owed_cue["due_on"])
    return {
        "server": server.name,
        "cue": str(owed_cue["cue"]["label"]),
        "name": str(owed_cue["cue"]["name"]),
        "project": str(owed_cue["project_name"]),
        "studio": str(owed_cue["studio_name"]),
        "state": str(owed_cue["status"]),
        "due_on": owed_cue["due_on"],
        "said_last": None if last is None else str(last["text"]),
        "said_by": None if last is None or last["by"] is None else str(last["by"]),
        "said_at": None if last is None else str(last["at"]),
        "page": f"{server.address}/projects/{quote(str(owed_cue['project_id']), safe='')}/desk",
    }


def _show_page(answers: Sequence[Answer], cues: Sequence[dict[str, Any]], page_path: str) -> None:
    """Write the page where it is wanted; without such a place, into the cache, and open it."""
    path = Path(page_path) if page_path else cache_path()
    if not page_path:
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    lines = [Line(_row(cue), cue["page"], _is_late(cue)) for cue in cues]
    write_page(path, html_of(HEADS, lines, _remarks(answers), datetime.now().astimezone()))
    is_open = not page_path and webbrowser.open(path.absolute().as_uri())
    say(f"{shown(str(path))} is {'open in your browser' if is_open else 'written'}")


def _report(answers: Sequence[Answer], cues: Sequence[dict[str, Any]], *, as_json: bool) -> None:
    if as_json:
        servers = [
            {
                "name": answer.server.name,
                "address": answer.server.address,
                "person": answer.person,
                "cues": len(answer.cues),
                "is_whole": answer.is_whole,
                "problem": answer.problem,
            }
            for answer in answers
        ]
        say(json.dumps({"format_version": FORMAT, "servers": servers, "cues": cues}, indent=2))
    elif cues:
        _print_table([_row(cue) for cue in cues])
    elif any(answer.problem is None for answer in answers):
        say("Nothing is owed.")


def _remarks(answers: Sequence[Answer]) -> list[str]:
    """Return the servers left out, or not shown in full, and the reasons."""
    remarks = []
    for answer in answers:
        name = shown(answer.server.name)
        if answer.problem is not None:
            remarks.append(f"{name} is left out: {shown(answer.problem)}")
        elif not answer.is_whole:
            rest = "open the desk in the browser for the rest"
            remarks.append(f"{name}: it shows no more than the first {counted(len(answer.cues), 'cue')}; {rest}")
    return remarks


def _is_late(cue: dict[str, Any]) -> bool:
    return cue["due_on"] is not None and cue["due_on"] < datetime.now().astimezone().date().isoformat()


def _row(cue: dict[str, Any]) -> list[str]:
    due = f"{cue['due_on']} late" if _is_late(cue) else cue["due_on"] or "no day"
    comment_text = " ".join((cue["said_last"] or "").split())
    if cue["said_by"]:
        comment_text = f"{cue['said_by']}: {comment_text}"
    state = STATES.get(cue["state"], cue["state"])
    row = (due, cue["cue"], cue["name"], state, cue["project"], cue["studio"], cue["server"], comment_text)
    return [shown(cell) for cell in row]


def _print_table(rows: list[list[str]]) -> None:
    """Print rows in columns; on a terminal what was said last ends where the line does."""
    table = [list(HEADS), *rows]
    widths = [max(len(row[column]) for row in table) for column in range(len(HEADS) - 1)]
    room = shutil.get_terminal_size().columns - sum(widths) - 2 * len(widths) if sys.stdout.isatty() else None
    for row in table:
        *cells, comment_text = row
        if room is not None and len(comment_text) > max(room, 20):
            comment_text = comment_text[: max(room, 20) - 1] + "…"
        say("  ".join([*(text.ljust(width) for text, width in zip(cells, widths, strict=True)), comment_text]).rstrip())
