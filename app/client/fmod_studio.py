"""`soundlist fmod`: has an FMOD Studio that runs on this machine import an unpacked pack, through its script server.

The script server evaluates each line that it is sent as JavaScript, and answers in text. Only this machine is asked.
"""

import argparse
import json
import re
import secrets
import socket
import time
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from app.client.errors import DONE, NOT_AS_APPROVED, Refusal, ServerUnreachable
from app.client.terminal import say, shown

HOST = "127.0.0.1"
PORT = 3663
CONNECT_S = 5.0
ANSWER_S = 300.0  # an import copies every new file
MOST_SCRIPT_BYTES = 1 << 20
MOST_ANSWER_BYTES = 4 << 20
BLOCK_BYTES = 1 << 16
SCRIPT, DOCUMENT = "Scripts/soundlist_import.js", "soundlist-handoff.json"
ENABLE = "in Preferences, Interface, switch the script server on, restart FMOD Studio and open the project"
# Runs the pack's script with a menu of ours and without dialogs, which would wait for a person. The mark is put
# together there, so that a line which is only echoed is not an answer.
LINE = (
    "(function(){var items=[],texts=[],said={project:studio.project.filePath};"
    "if(said.project.replace(/\\\\/g,'/').toLowerCase()===PROJECT.toLowerCase()){try{"
    "new Function('studio','alert',SCRIPT)({project:studio.project,system:studio.system,"
    "menu:{addMenuItem:function(item){items.push(item);}}},function(text){texts.push(text);});"
    "items.forEach(function(item){item.execute();});said.shown=texts.join('\\n');"
    "}catch(error){said.error=String(error&&error.message||error);}}"
    "return 'soundlist-'+NONCE+':'+encodeURIComponent(JSON.stringify(said))+';';})()"
)


def import_in_studio(options: argparse.Namespace) -> int:
    """Have FMOD Studio import the pack that is unpacked beside a project; return the exit code."""
    project = project_in(options.folder.resolve())
    script = (project.parent / SCRIPT).read_bytes()
    if len(script) > MOST_SCRIPT_BYTES:
        raise Refusal(f"{SCRIPT} is too large to be the script of a pack")
    answer = answer_of(script.decode("utf-8", "replace"), project, port=options.port)
    if "error" in answer:
        raise Refusal(f"FMOD Studio stopped the script: {answer['error']}")
    if "shown" not in answer:
        other = answer.get("project") or "no project"
        raise Refusal(f"FMOD Studio has {other} open; open {project} there, and run this again")
    text = str(answer["shown"])
    say("\n".join(shown(line) for line in text.split("\n")))
    say("Nothing was saved: look at the events in FMOD Studio, assign banks, and save there.")
    return NOT_AS_APPROVED if "not imported" in text.lower() else DONE


def project_in(folder: Path) -> Path:
    """Return the project of FMOD Studio in a folder that has a pack beside it; raise Refusal where one is missing."""
    projects = sorted(folder.glob("*.fspro")) if folder.is_dir() else []
    projects = [project for project in projects if not project.name.startswith("._")]
    if len(projects) != 1:
        counted_projects = f"{len(projects)} .fspro files" if projects else "no .fspro file"
        raise Refusal(f"{folder} has {counted_projects}; name the folder of one FMOD Studio project")
    for path in (SCRIPT, DOCUMENT):
        if not (folder / path).is_file():
            raise Refusal(
                f"{folder} has no {path}; unpack a pack there that was made with import files for FMOD Studio"
            )
    return projects[0]


def answer_of(script: str, project: Path, *, port: int, answer_s: float = ANSWER_S) -> dict[str, Any]:
    """Send a script to FMOD Studio, and return what it answers.

    Raise ServerUnreachable where nobody listens, and Refusal where what listens does not answer as FMOD Studio does.
    """
    nonce = secrets.token_hex(8)
    given = {"PROJECT": project.as_posix(), "SCRIPT": script, "NONCE": nonce}
    line = re.sub("|".join(given), lambda match: json.dumps(given[match[0]]), LINE)
    mark = re.compile(rb"soundlist-" + nonce.encode() + rb":([A-Za-z0-9%._~!*'()-]*);")
    try:
        with socket.create_connection((HOST, port), CONNECT_S) as studio:
            studio.sendall(line.encode() + b"\n")
            return _read_answer(studio, mark, time.monotonic() + answer_s)
    except ConnectionRefusedError:
        raise ServerUnreachable(f"no FMOD Studio listens on port {port} of this machine; {ENABLE}") from None
    except OSError as error:
        raise ServerUnreachable(f"FMOD Studio on port {port} does not answer ({error}); {ENABLE}") from None


def _read_answer(studio: socket.socket, mark: re.Pattern[bytes], until: float) -> dict[str, Any]:
    received = b""
    while (left_s := until - time.monotonic()) > 0 and len(received) < MOST_ANSWER_BYTES:
        studio.settimeout(left_s)
        try:
            block = studio.recv(BLOCK_BYTES)
        except TimeoutError:
            break
        received += block
        if match := mark.search(received):
            return _parsed(match[1])
        if not block:
            break
    text = received.decode("utf-8", "replace").strip()[-400:]
    raise Refusal(f"what listens there did not answer as FMOD Studio does{': ' + text if text else ''}")


def _parsed(content: bytes) -> dict[str, Any]:
    try:
        answer = json.loads(unquote(content.decode("ascii")))
    except ValueError:
        answer = None
    if not isinstance(answer, dict):
        raise Refusal("the answer of FMOD Studio cannot be read; run Scripts, Soundlist, Import pack there")
    return answer
