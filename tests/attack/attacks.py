"""Attacks by name, as a stranger and as signed-in people; each sends a few requests and yields the statuses."""

import base64
import io
import itertools
import socket
import string
import time
import zipfile
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from datetime import timedelta
from functools import cache
from typing import Any

import httpx
import numpy as np
from sqlalchemy import update

from app.accounts.authentication import CSRF_HEADER, SESSION_COOKIE, sha256_of
from app.accounts.models import SignIn
from app.accounts.rate_limits import GUEST_VISITS_FROM_NETWORK, MAILS_TO_ADDRESS, WEBHOOK_MESSAGES_OF_STUDIO
from app.core import clock
from app.settings import Settings
from tests.attack.hostile_requests import hostile_requests
from tests.attack.target import ANSWER_WITHIN_S, NO_ANSWER, ODD, Target, sent, sent_raw
from tests.house.routes import operations
from tests.support.mutants import mutant

SLOW_LINES, SLOW_FOR_S = 20, 1.0
KNOCKS, SIGN_INS = 60, 30
AT_ONCE = 4  # comparisons of one person
AS_MANY_AS_ASKED = httpx.Limits(max_connections=None, max_keepalive_connections=None)
ENDS = {"sign_out", "end_my_other_sign_ins", "end_my_sign_in"}  # of attackers themselves
HOSTILE_REQUESTS = 60  # of other seeds each time
Attack = Callable[[Target], Iterator[int]]
ATTACKS: dict[str, Attack] = {}


def attack(name: str) -> Callable[[Attack], Attack]:
    """Register an attack."""

    def register(run: Attack) -> Attack:
        ATTACKS[name] = run
        return run

    return register


# Sheets.


def workbook(sheet: str, *, level: int | None = None) -> bytes:
    """Return an XLSX file of one sheet, whose XML is given."""
    main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
    of_office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
    of_package = "http://schemas.openxmlformats.org/package/2006"
    types = "application/vnd.openxmlformats-officedocument.spreadsheetml"
    parts = {
        "[Content_Types].xml": f'<Types xmlns="{of_package}/content-types">'
        '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
        f'<Override PartName="/xl/workbook.xml" ContentType="{types}.sheet.main+xml"/>'
        f'<Override PartName="/xl/worksheets/sheet1.xml" ContentType="{types}.worksheet+xml"/></Types>',
        "_rels/.rels": f'<Relationships xmlns="{of_package}/relationships"><Relationship Id="r1" '
        f'Type="{of_office}/officeDocument" Target="xl/workbook.xml"/></Relationships>',
        "xl/workbook.xml": f'<workbook xmlns="{main}" xmlns:r="{of_office}"><sheets>'
        '<sheet name="s" sheetId="1" r:id="r1"/></sheets></workbook>',
        "xl/_rels/workbook.xml.rels": f'<Relationships xmlns="{of_package}/relationships"><Relationship Id="r1" '
        f'Type="{of_office}/worksheet" Target="worksheets/sheet1.xml"/></Relationships>',
        "xl/worksheets/sheet1.xml": sheet.replace("MAIN", f'xmlns="{main}"'),
    }
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED, compresslevel=level) as archive:
        for name, text in parts.items():
            archive.writestr(name, text)
    return made.getvalue()


def cells(*references: str) -> str:
    """Return a sheet with a word in each of these cells, each in a row of its own."""
    rows = "".join(
        f'<row r="{reference.lstrip(string.ascii_uppercase)}">'
        f'<c r="{reference}" t="inlineStr"><is><t>name</t></is></c></row>'
        for reference in references
    )
    return f"<worksheet MAIN><sheetData>{rows}</sheetData></worksheet>"


def imported(target: Target, **sheet: Any) -> int:
    body = {"dry_run": True, **sheet}
    return sent(target.world.producer, "POST", f"{target.project}/sound-list/import", json=body)


def imported_workbook(target: Target, sheet: str) -> int:
    return imported(target, format="xlsx", content_base64=base64.b64encode(workbook(sheet)).decode())


@attack("sheet: a cell at the far corner")
def far_cell(target: Target) -> Iterator[int]:
    yield imported_workbook(target, cells("A1", "XFD1048576"))


@attack("sheet: row numbers of nine digits")
def far_rows(target: Target) -> Iterator[int]:
    yield imported_workbook(target, cells("A1", "A999999999"))


@attack("sheet: 99 MB in 500 kB")
def sheet_bomb(target: Target) -> Iterator[int]:
    yield imported(target, format="xlsx", content_base64=bomb())


@cache
def bomb() -> str:
    """Return a workbook that is mostly spaces, in Base64."""
    sheet = "<worksheet MAIN><sheetData>" + " " * 99_000_000 + "</sheetData></worksheet>"
    return base64.b64encode(workbook(sheet, level=1)).decode()


@attack("sheet: entities in entities")
def entities(target: Target) -> Iterator[int]:
    laughs = "".join(f'<!ENTITY l{n} "{f"&l{n - 1};" * 10}">' for n in range(1, 10))
    doctype = f'<!DOCTYPE w [<!ENTITY l0 "ha"><!ENTITY f SYSTEM "file:///etc/passwd">{laughs}]>'
    yield imported_workbook(target, doctype + cells("A1").replace("name", "&l9;&f;"))


@attack("sheet: a cell of 20,000 digits and spaces")
def long_cell(target: Target) -> Iterator[int]:
    for cell in ("1 " * 10_000, "0" * 20_000 + "x", "1:" * 10_000, " " * 20_000 + "x", "a_" * 10_000):
        yield imported(target, format="csv", text=f"name,duration\n{cell},{cell}\n")


@attack("sheet: a million columns, rows and quotes")
def wide_text(target: Target) -> Iterator[int]:
    for text in ("name," + "," * 1_000_000, "name\n" * 500_000, 'name\n"' + "x" * 200_000, '"' * 500_000):
        yield imported(target, format="csv", text=text)


# TOML.


def toml_texts() -> Iterator[str]:
    yield "format = 1\n" + "a." * 30_000 + "a = 1\n"
    yield 'format = 1\nname = "x"\n[files]\n' + "a." * 500 + 'a = "x"\n'
    yield "a = " + "[" * 30_000
    yield "a = " + "{a=" * 20_000
    yield "[" + "a." * 30_000 + "a]\n"
    yield "".join(f"[a.b{n}.c]\n" for n in range(5_000))
    yield "[[a]]\n" * 10_000


@attack("TOML: a delivery spec with thousands of dots and brackets")
def hostile_spec(target: Target) -> Iterator[int]:
    for text in toml_texts():
        yield sent(target.world.producer, "POST", f"{target.project}/spec/check-toml", json={"toml": text})
        yield sent(target.world.producer, "PUT", f"{target.project}/spec", json={"toml": text, "based_on_version": 1})


@attack("TOML: a contract template with thousands of dots and brackets")
def hostile_template(target: Target) -> Iterator[int]:
    path = f"/v1/studios/{target.world.studio_id}/contract-templates/import"
    for text in toml_texts():
        yield sent(target.world.producer, "POST", path, json={"toml": text})


@attack("TOML: a naming pattern that backtracks")
def hostile_pattern(target: Target) -> Iterator[int]:
    text = "format = 1\nname = \"x\"\n[naming]\npattern = '((a+)+)+b'\n"
    yield sent(target.world.producer, "POST", f"{target.project}/spec/check-toml", json={"toml": text})


# Bodies and lines.


@attack("body: 40 MB to sign in")
def long_sign_in(target: Target) -> Iterator[int]:
    def body() -> Iterator[bytes]:
        yield b'{"email":"'
        for _ in range(40):
            yield b"a" * 1_000_000

    headers = {"Content-Type": "application/json"}
    yield sent(target.world.nobody, "POST", "/v1/sign-in", content=body(), headers=headers)


@attack("body: JSON that is deep or wide")
def odd_json(target: Target) -> Iterator[int]:
    headers = {"Content-Type": "application/json"}
    for body in (b"[" * 100_000, b'{"a":' * 50_000, b"[" + b"0," * 4_000_000 + b"0]", b"9" * 100_000, b'"\\ud800"',
                 b"{" + b",".join(b'"%d":0' % number for number in range(600_000)) + b"}"):  # fmt: skip
        yield sent(target.world.nobody, "POST", "/v1/sign-up", content=body, headers=headers)
        yield sent(target.world.producer, "POST", f"{target.project}/cues", content=body, headers=headers)


@attack("lines: heads and bodies that never end")
def slow_lines(target: Target) -> Iterator[int]:
    lines = [socket.create_connection(("127.0.0.1", target.port), timeout=5) for _ in range(SLOW_LINES)]
    head = b"POST /v1/sign-in HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Type: application/json\r\n"
    try:
        for number, line in enumerate(lines):
            line.sendall(head if number % 2 else head + b"Content-Length: 1000\r\n\r\n{")
        time.sleep(SLOW_FOR_S)
        for line in lines:
            line.sendall(b"X-More: a\r\n")
    except OSError:
        yield NO_ANSWER
    finally:
        for line in lines:
            line.close()


@attack("sign-in: wrong passwords")
def wrong_passwords(target: Target) -> Iterator[int]:
    for number in range(20):
        body = {"email": f"person{number}@example.test", "password": "wrong" * 20}
        yield sent(target.world.nobody, "POST", "/v1/sign-in", json=body)


# Addresses, headers, cursors, ranges, names.


@attack("addresses: NUL, 5,000 letters, dots, percents")
def odd_addresses(target: Target) -> Iterator[int]:
    paths = ("/%00", "/v1/%00", "/assets/%00", "/" + "a" * 5_000, "/assets/" + "a" * 5_000, "/assets/../../etc/passwd",
             "/assets/%2e%2e/%2e%2e/etc/passwd", "/%ff%fe", "/v1/projects/%ed%a0%80", "//", "/v1//", "/v1/takes/²",
             "*", "http://[::1", "/?" + "a=b&" * 2_000, "/v1/invitations/%00", "/v1/calendars/%00")  # fmt: skip
    for path in paths:
        yield sent_raw(target, b"GET " + path.encode() + b" HTTP/1.1")


@attack("headers: origins, hosts, cookies, lengths")
def odd_headers(target: Target) -> Iterator[int]:
    heads = (b"Origin: http://[::1", b"Host: [::1", b"Cookie: " + b"a=b; " * 1_500, b"Content-Length: -1",
             b"Content-Length: " + b"9" * 30, b"Transfer-Encoding: chunked", b"X-A: \xff\xfe\x00",
             b"X-A: b\r\n" * 500 + b"X-B: c", b"Authorization: Bearer \xc3\xa9", b"X-Forwarded-For: " + b"1," * 2_000,
             b"Accept-Encoding: " + b"a" * 60_000, b"Origin: http://127.0.0.1:99999999")  # fmt: skip
    for head in heads:
        for method in (b"GET", b"POST"):
            # Where a chunked body is expected, it is not one.
            yield sent_raw(target, method + b" /v1/sign-in HTTP/1.1\r\n" + head, b"zz\r\n\r\n")


@attack("cursors and searches: huge numbers, NUL, half of a pair")
def odd_cursors(target: Target) -> Iterator[int]:
    lists = ("/v1/review-queue", f"{target.project}/takes", f"{target.project}/sound-list/revisions",
             f"{target.project}/questions", f"{target.project}/packs", "/v1/projects",
             f"/v1/studios/{target.world.studio_id}/jobs", f"/v1/studios/{target.world.studio_id}/outbox")  # fmt: skip
    for path in lists:
        for name in ("cursor", "after", "limit", "q"):
            yield sent(target.world.producer, "GET", path, params={name: target.bad_word()})
    for _ in range(5):
        yield sent(target.world.producer, "GET", f"{target.project}/find", params={"q": target.bad_word()})
        yield sent(target.world.producer, "GET", f"/v1/takes/{target.bad_word()[:50]}")


@attack("ranges: 5,000 digits, 500 parts, backwards")
def odd_ranges(target: Target) -> Iterator[int]:
    ranges = ("bytes=" + "9" * 5_000 + "-", "bytes=0-" + "9" * 5_000, "bytes=-" + "9" * 5_000, "bytes=9-1",
              "bytes=" + "0-," * 500 + "0-", "bytes=²-".encode().decode("latin-1"), "items=0-1",
              "bytes=-0")  # fmt: skip
    for value in ranges:
        for path in (f"/v1/takes/{target.take_id}/master", f"{target.project}/sound-list.csv"):
            yield sent(target.world.designer, "GET", path, headers={"Range": value})


@attack("names: of files, cues, people and labels")
def odd_names(target: Target) -> Iterator[int]:
    for word in ODD:
        query = {"delivery_id": target.delivery_id, "file_name": f"{word}.wav"}
        yield sent(target.world.designer, "PUT", "/v1/uploads", params=query, content=b"RIFF")
        yield sent(target.world.producer, "POST", f"{target.project}/cues", json={"cues": [{"name": word}]})
        yield sent(target.world.producer, "PUT", "/v1/me", json={"name": word})
        yield sent(target.world.producer, "POST", f"{target.project}/packs", json={"target": word, "label": word})


# Files.


def delivered(target: Target, name: str, content: bytes) -> Iterator[int]:
    query = {"delivery_id": target.delivery_id, "file_name": name}
    designer = target.world.designer
    answer = designer.put("/v1/uploads", params=query, content=content, timeout=ANSWER_WITHIN_S)
    yield answer.status_code
    if answer.status_code == 201:
        upload_id = answer.json()["upload_id"]
        path = f"/v1/deliveries/{target.delivery_id}/{'archives' if name.endswith('.zip') else 'takes'}"
        yield sent(designer, "POST", path, json={"upload_id": upload_id, "file_name": name})


@attack("files: damaged WAV")
def damaged_files(target: Target) -> Iterator[int]:
    numbers = np.random.default_rng(target.numbers.getrandbits(32))
    for number in range(4):
        yield from delivered(target, f"laser_fire_{number}.wav", mutant(numbers))


@attack("files: ZIPs that grow or climb")
def hostile_zips(target: Target) -> Iterator[int]:
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("../../laser.wav", b"RIFF")
        archive.writestr("/etc/laser.wav", b"RIFF")
        archive.writestr("bomb.wav", bytes(50_000_000))
    yield from delivered(target, "bomb.zip", made.getvalue())
    yield from delivered(target, "half.zip", made.getvalue()[: len(made.getvalue()) // 2])


# Access, and what is sent for others.


@attack("secrets: another cookie and another token with every request")
def made_up_secrets(target: Target) -> Iterator[int]:
    with httpx.Client(base_url=target.world.nobody.base_url, limits=AS_MANY_AS_ASKED) as client:

        def knock(number: int) -> int:
            secret = f"made-up-{target.numbers.getrandbits(64)}-{number}"
            by_token = {"Authorization": f"Bearer slt_{secret}"}
            headers = by_token if number % 2 else {"Cookie": f"{SESSION_COOKIE}={secret}"}
            return sent(client, "GET", f"{target.project}/sound-list", headers=headers)

        with ThreadPoolExecutor(KNOCKS) as pool:
            yield from pool.map(knock, range(KNOCKS))


@attack("secrets: one person with thirty sign-ins")
def many_sign_ins(target: Target) -> Iterator[int]:
    world = target.world
    browsers = [world.signed_in(world.reviewer_id) for _ in range(SIGN_INS)]
    with ThreadPoolExecutor(SIGN_INS) as pool:
        asked = [pool.submit(sent, browser, "GET", f"{target.project}/sound-list") for browser in browsers * 3]
        yield from (answer.result() for answer in asked)


@attack("access: tokens, links and producers by a sign-in of an hour ago")
def old_sign_in(target: Target) -> Iterator[int]:
    world = target.world
    browser = world.signed_in(world.producer_id)
    secret_sha256 = sha256_of(browser.cookies[SESSION_COOKIE])
    aged = update(SignIn).where(SignIn.secret_sha256 == secret_sha256)
    with world.server.runtime.database.writing() as session:
        session.execute(aged.values(created_at=clock.now() - timedelta(hours=1)))
    studio = f"/v1/studios/{world.studio_id}"
    for path, body in (
        (f"{target.project}/tokens", {"name": "CI", "scopes": ["list:read"]}),
        ("/v1/me/desk-tokens", {"name": "Mine"}),
        (f"{studio}/webhooks", {"url": "https://hooks.example.com/in", "events": ["take.approved"]}),
        (f"{target.project}/guest-links", {"kind": "approved", "title": "All of it"}),
        (f"{target.project}/calendar", None),
        (f"{studio}/invitations", {"email": "mallory@elsewhere.example", "roles": ["producer"]}),
    ):
        status = sent(browser, "POST", path, json=body)
        assert status == 403, f"{path} answered {status}"
        yield status


@attack("mails: sign-ups and resets to one mailbox under many names")
def one_mailbox(target: Target) -> Iterator[int]:
    statuses = [
        sent(target.world.nobody, "POST", "/v1/password-resets", json={"email": f"victim+{number}@example.test"})
        for number in range(MAILS_TO_ADDRESS.burst + 2)
    ]
    assert statuses.count(202) <= MAILS_TO_ADDRESS.burst, statuses
    yield from statuses


@attack("webhooks: a name that leads inside, and tests without end")
def webhook_flood(target: Target) -> Iterator[int]:
    world = target.world
    body = {"url": "https://localtest.invalid/in", "events": ["take.approved"]}
    made = world.producer.post(f"/v1/studios/{world.studio_id}/webhooks", json=body, timeout=ANSWER_WITHIN_S)
    yield made.status_code
    if made.status_code == 201:
        path = f"/v1/webhooks/{made.json()['id']}"
        limit, begun_s = WEBHOOK_MESSAGES_OF_STUDIO, time.monotonic()
        statuses = [sent(world.producer, "POST", f"{path}/test") for _ in range(limit.burst + 5)]
        most = limit.burst + (time.monotonic() - begun_s) / limit.interval_s + 1  # some pass while they are sent
        yield from statuses
        yield sent(world.producer, "DELETE", path)
        assert statuses.count(202) <= most, statuses


@attack("guest links: passwords guessed, and visits without end")
def guest_flood(target: Target) -> Iterator[int]:
    weak = {"kind": "cues", "title": "Mine", "cue_ids": [target.cue_ids[0]], "password": "x"}
    status = sent(target.world.producer, "POST", f"{target.project}/guest-links", json=weak)
    assert status in (422, 429), status
    yield status
    for number in range(GUEST_VISITS_FROM_NETWORK.burst + 5):
        body = {"guest_name": "Mallory", "password": f"guess {number}"}
        yield sent(target.world.nobody, "POST", "/v1/guest-access/none/visits", json=body)


@attack("studios: one account opens as many as it can")
def many_studios(target: Target) -> Iterator[int]:
    most = Settings.model_fields["studios_per_account"].default
    statuses = [
        sent(target.world.other_designer, "POST", "/v1/studios", json={"name": f"Studio {number}"})
        for number in range(most + 2)
    ]
    assert statuses.count(201) <= most, statuses
    yield from statuses


# What all share.


@attack("contracts: four comparisons at once by one person")
def comparisons(target: Target) -> Iterator[int]:
    path = f"/v1/contracts/{target.contract_id}/comparison"
    with ThreadPoolExecutor(AT_ONCE) as pool:
        versions = {"from_version": 1, "to_version": 2}
        asked = [pool.submit(sent, target.world.producer, "GET", path, params=versions) for _ in range(AT_ONCE)]
        yield from (one.result() for one in asked)


@attack("floods: forty PDFs and a hundred lists at once by one person")
def floods(target: Target) -> Iterator[int]:
    producer = target.world.producer
    # A client of its own: one with fewer connections than threads closes some that are in use.
    with httpx.Client(
        base_url=producer.base_url, cookies=producer.cookies, headers=producer.headers, limits=AS_MANY_AS_ASKED
    ) as client:
        for page, count in (("documentation-key.pdf", 40), ("sound-list", 100)):
            with ThreadPoolExecutor(count) as pool:
                path = f"{target.project}/{page}"
                asked = [pool.submit(sent, client, "GET", path) for _ in range(count)]
                yield from (one.result() for one in asked)


@attack("routes: every route with values that break parsers, databases and arithmetic")
def every_route(target: Target) -> Iterator[int]:
    world = target.world
    ids = {
        "studio_id": world.studio_id,
        "project_id": world.project_id,
        "cue_id": target.cue_ids[0],
        "take_id": target.take_id,
        "delivery_id": target.delivery_id,
        "contract_id": target.contract_id,
    }
    people = (world.producer, world.reviewer, world.designer, world.stranger, world.nobody)
    requests = hostile_requests(
        target.numbers.getrandbits(32), [operation for operation in operations() if operation.name not in ENDS], ids
    )
    for request in itertools.islice(requests, HOSTILE_REQUESTS):
        person = target.numbers.choice(people)
        cookies = "; ".join(f"{name}={value}" for name, value in person.cookies.items())
        given = {"host": "127.0.0.1", "cookie": cookies, CSRF_HEADER.lower(): person.headers.get(CSRF_HEADER, "")}
        headers = {name.encode(): value.encode() for name, value in given.items() if value}
        headers |= {name.lower(): value for name, value in request.headers}
        if request.body:
            headers.setdefault(b"content-length", b"%d" % len(request.body))
        head = f"{request.method} {request.target} HTTP/1.1".encode()
        lines = [head, *(name + b": " + value for name, value in headers.items())]
        yield sent_raw(target, b"\r\n".join(lines), request.body, host=b"")
