"""A drill by the commands of docs/how-to/operate.md, in real processes.

A server is installed and filled, its files rot and are lost, it is restored, moved to PostgreSQL, exported, imported
and upgraded, and a person leaves it. After each step the downloads are compared with those before, and the records of
contracts are verified.
"""

import hashlib
import io
import json
import os
import re
import shutil
import time
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest

from app.accounts.authentication import CSRF_COOKIE, CSRF_HEADER
from app.core.runtime import Runtime
from app.core.web.health import WORKER_SILENT_AFTER
from app.transfers.move import unfinished_jobs
from tests.journeys.test_contract import TODAY, sound
from tests.support.documented import documented_commands
from tests.support.host import Host, Ran
from tests.support.postgres import Postgres
from tests.support.waiting import until

PASSWORD = "seven quiet lanterns by the harbour"
ADA, DESIGNER, GUEST = "ada@studio.example", "designer@example.com", "second@example.com"
AN_ID = "019f0c9e-2b6a-7cc1-8f1e-2f6a3b1c0d9e"
BACKUPS = "/var/backups/soundlist"

# In the order in which the drill first runs them.
DRILLED = (
    *(f"soundlist --show-completion {target}" for target in (
        "bash > ~/.local/share/bash-completion/completions/soundlist",
        "zsh > ~/.zfunc/_soundlist",
        "fish > ~/.config/fish/completions/soundlist.fish",
    )),
    "cp deploy/env.example .env",
    'sed --in-place "s/^IMAGE_TAG=.*/IMAGE_TAG=$(git describe --tags)/" .env',
    "cp deploy/host/sysusers.conf /etc/sysusers.d/soundlist.conf",
    "cp deploy/host/tmpfiles.conf /etc/tmpfiles.d/soundlist.conf",
    "install --mode 0640 deploy/host/soundlist.env /etc/soundlist.env",
    "cp deploy/systemd/* /etc/systemd/system",
    "systemctl daemon-reload",
    "systemctl enable --now soundlist-web soundlist-worker@1 soundlist-worker@2 soundlist-backup.timer",
    "cp deploy/host/Caddyfile /etc/caddy/Caddyfile",
    'soundlist accounts add ada@studio.example --name Ada --studio "Night Studio"',
    "soundlist mails",
    "soundlist mails ada@studio.example",
    "soundlist verify",
    "soundlist scrub",
    "soundlist restore FOLDER --sounds",
    "soundlist scrub --delete-orphans",
    "soundlist scrub --rate 20",
    "soundlist move --database-url postgresql://soundlist:password@host/soundlist "
    "--store-url 's3://sounds?endpoint=https://s3.example'",
    f"soundlist export {AN_ID} studio.zip",
    "soundlist import studio.zip",
    "soundlist operators add ada@studio.example",
    "soundlist operators list",
    "soundlist operators remove ada@studio.example",
    "soundlist erase person designer@example.com",
    f"soundlist erase project {AN_ID}",
    f"soundlist erase studio {AN_ID} --yes",
    "systemctl start soundlist-migrate",
    "systemctl restart soundlist-web 'soundlist-worker@*'",
    "systemctl restart soundlist-web",
    "systemctl restart 'soundlist-worker@*'",
    "soundlist move --data-dir /srv/soundlist",
    "soundlist sign-out ada@studio.example",
)  # fmt: skip
# Why a command of the pages does not run here.
NOT_RUN = {
    "docker": "containers need an engine; test_deploy runs the commands of the Compose file outside containers",
    "old=$(docker compose ps --quiet web)": "containers need an engine",
    "systemd-sysusers": "it writes to /etc/passwd; test_deploy runs it on a folder where it is installed",
    "systemd-tmpfiles --create soundlist.conf": "it gives folders to a user that is not here",
    "chgrp soundlist /etc/soundlist.env": "the group is made by systemd-sysusers",
    "systemctl reload caddy": "it needs systemd; test_deploy validates the Caddyfile where Caddy is installed",
    "alias soundlist=": "it needs systemd",
    "cd /opt/soundlist": "every command here runs there",
    "git fetch --tags": "the checkout is the code under test",
    "git checkout v": "the checkout is the code under test",
    "make setup": "every run of the tests begins with it",
    "soundlist accounts remove-second-factor ada@studio.example": "test_second_factors runs it",
    "soundlist accounts bind-domain": "test_sign_in_providers runs it",
    "soundlist accounts unbind-domain": "test_sign_in_providers runs it",
}


def test_each_documented_command_is_run_or_has_a_reason_not_to() -> None:
    documented = set(documented_commands())
    assert set(DRILLED) - documented == set(), "no page has these commands any more"
    not_run = {command for command in documented if command.startswith(tuple(NOT_RUN))}
    assert documented - not_run - set(DRILLED) == set(), "no test runs these commands"
    assert not_run.isdisjoint(DRILLED)
    unused = {start for start in NOT_RUN if not any(command.startswith(start) for command in not_run)}
    assert unused == set(), "no page has these commands any more"


class Operator:
    """Types the documented commands on a host, and notes which ones."""

    def __init__(self, host: Host, typed: set[str]) -> None:
        self.host = host
        self._typed = typed

    def run(self, command: str, *, code: int = 0, typed: str = "", **given: str) -> Ran:
        """Run a command of the pages; it must end with a code."""
        [documented] = [line for line in DRILLED if line == command]
        self._typed.add(documented)
        ran = self.host.run(documented, given, typed=typed)
        assert ran.code == code, f"{command}: {ran.code}\n{ran.printed}{ran.warned}\n{self.host.log()[-3000:]}"
        return ran


class Browser:
    """A person who uses the server over HTTP."""

    def __init__(self, host: Host) -> None:
        self._client = host.client()
        self._client.get("/v1/session")

    def ask(self, method: str, path: str, **more: Any) -> Any:
        """Send a request that must succeed and return its body."""
        answer = self.send(method, path, **more)
        assert answer.is_success, f"{method} {path}: {answer.status_code} {answer.text}"
        return answer.json() if "json" in answer.headers.get("content-type", "") else answer.content

    def send(self, method: str, path: str, **more: Any) -> httpx.Response:
        """Send a request and return its answer."""
        self._client.headers[CSRF_HEADER] = self._client.cookies.get(CSRF_COOKIE, "")
        return self._client.request(method, f"/v1{path}", **more)

    def sign_in(self, address: str) -> None:
        """Sign in with the password of the drill."""
        self.ask("POST", "/sign-in", json={"email": address, "password": PASSWORD})


def mailed_secret(operator: Operator, address: str) -> str:
    """Return the secret of the newest link that waits for an address, as `soundlist mails` prints it."""
    until(lambda: _links(operator, address))
    return _links(operator, address)[-1].rpartition("/")[2]


def _links(operator: Operator, address: str) -> list[str]:
    printed = operator.run("soundlist mails ada@studio.example", **{ADA: address}).printed
    links = [line.rpartition("\t")[2] for line in printed.splitlines()]
    return [link for link in links if re.search(r"/[\w-]{30,}$", link) and not re.search(r"/[0-9a-f-]{36}$", link)]


class SmallProject:
    """A studio with a contract, delivered, accepted and returned sounds, an invoice and a payment."""

    cues = ("radar_ping", "dock_clamp", "mine_arm")

    def __init__(self, operator: Operator) -> None:
        self.operator = operator
        self.producer = Browser(operator.host)
        self.producer.sign_in(ADA)
        self.studio_id: str = self.producer.ask("GET", "/me")["studios"][0]["id"]
        self.project_id = self.open_project("Shield Wing", "SW")
        self.path = f"/projects/{self.project_id}"
        added = self.producer.ask(
            "POST", f"{self.path}/cues", json={"cues": [{"name": name, "state": "locked"} for name in self.cues]}
        )
        self.cue_ids = {cue["name"]: cue["id"] for cue in added}
        self.designer, self.guest = self.invite(DESIGNER), self.invite(GUEST)
        self.contract_id = self.agree()
        self.takes = [
            self.deliver(self.designer, "radar_ping.wav", 440),
            self.deliver(self.designer, "dock_clamp.wav", 550),
            self.deliver(self.guest, "mine_arm.wav", 660),
        ]
        self.wait_for_checks()
        for take in self.takes[:2]:
            self.producer.ask("POST", f"/takes/{take['id']}/verdict", json={"kind": "approve", "note": "Good."})
        invoice = self.designer.ask("POST", f"/contracts/{self.contract_id}/invoices", json={"seller": "A designer"})
        self.invoice_id = invoice["id"]
        payment = {"amount_minor": 10_000, "reference": "T-1", "paid_on": TODAY.isoformat()}
        self.producer.ask("POST", f"/invoices/{self.invoice_id}/payments", json=payment)

    def open_project(self, name: str, prefix: str) -> str:
        """Open a project and return its id."""
        opened = {"studio_id": self.studio_id, "name": name, "cue_prefix": prefix, "description": ""}
        project_id: str = self.producer.ask("POST", "/projects", json=opened)["id"]
        return project_id

    def invite(self, address: str) -> Browser:
        """Invite a designer, who makes an account by the link that the operator hands over."""
        self.producer.ask("POST", f"{self.path}/invitations", json={"email": address, "kind": "contract"})
        designer = Browser(self.operator.host)
        secret = mailed_secret(self.operator, address)
        designer.ask("POST", f"/invitations/{secret}/accept", json={"name": address, "password": PASSWORD})
        return designer

    def agree(self) -> str:
        """Have studio and designer agree a contract, and return its id."""
        engagements = self.producer.ask("GET", self.path)["engagements"]
        [engagement] = [tie for tie in engagements if tie["designer"]["name"] == DESIGNER]
        begun = {"engagement_id": engagement["id"], "kind": "single", "title": "Effects", "currency": "EUR"}
        contract_id: str = self.producer.ask("POST", f"{self.path}/contracts", json=begun)["id"]
        cues = [{"cue_id": self.cue_ids[name]} for name in self.cues[:2]]
        alpha = {"name": "Alpha", "amount_minor": 36_001, "due_on": TODAY.isoformat(), "cues": cues}
        self.producer.ask("PUT", f"/contracts/{contract_id}/milestones", json={"milestones": [alpha]})
        self.producer.ask("POST", f"/contracts/{contract_id}/send", json={"note": ""})
        for party in (self.designer, self.producer):
            text_sha256 = party.ask("GET", f"/contracts/{contract_id}")["version"]["text_sha256"]
            accepted = {"name": "One of the parties", "text_sha256": text_sha256}
            party.ask("POST", f"/contracts/{contract_id}/accept", json=accepted)
        return contract_id

    def deliver(self, designer: Browser, name: str, hz: float) -> dict[str, Any]:
        """Deliver a sound and return its take."""
        delivery_id = designer.ask("POST", f"{self.path}/deliveries", json={"note": "first batch"})["id"]
        params = {"delivery_id": delivery_id, "file_name": name}
        uploaded = designer.ask("PUT", "/uploads", params=params, content=sound(hz))
        body = {"upload_id": uploaded["upload_id"], "file_name": name}
        take: dict[str, Any] = designer.ask("POST", f"/deliveries/{delivery_id}/takes", json=body)
        return take

    def wait_for_checks(self) -> None:
        """Return when every take is checked and each game file is made."""

        def is_prepared(take: dict[str, Any]) -> bool:
            sounds = self.producer.ask("GET", f"/takes/{take['id']}/sounds")
            return all(render["state"] == "made" for render in sounds["renders"]) and bool(sounds["renders"])

        until(lambda: all(is_prepared(take) for take in self.takes))

    def downloads(self, producer: Browser | None = None) -> dict[str, str]:
        """Return the SHA-256 of everything that the producer downloads; a refusal counts as its code."""
        reader = producer or self.producer
        versions = reader.ask("GET", f"/contracts/{self.contract_id}")["version"]["number"]
        addresses = [
            *(f"/takes/{take['id']}/master" for take in self.takes),
            *(f"/takes/{take['id']}/check" for take in self.takes),
            f"{self.path}/sound-list.csv",
            f"{self.path}/journal.csv",
            f"{self.path}/spec.toml",
            f"{self.path}/documentation-key.csv",
            f"/contracts/{self.contract_id}/versions/{versions}/contract.pdf",
            f"/contracts/{self.contract_id}/record",
            f"/invoices/{self.invoice_id}/invoice.pdf",
        ]
        for take in self.takes:
            renders = reader.ask("GET", f"/takes/{take['id']}/sounds")["renders"]
            addresses += [f"/renders/{render['id']}/file" for render in renders]
        hashes = {address: _digest(reader.send("GET", address)) for address in addresses}
        pack = reader.send("GET", f"{self.path}/pack.zip", params={"masters": True})
        if pack.is_success:
            with zipfile.ZipFile(io.BytesIO(pack.content)) as archive:
                for name in archive.namelist():
                    hashes[f"pack.zip/{name}"] = hashlib.sha256(archive.read(name)).hexdigest()
        else:
            hashes["pack.zip"] = _digest(pack)
        return hashes


def _digest(answer: httpx.Response) -> str:
    """Return the SHA-256 of a file, or of JSON whatever the order of its keys, which PostgreSQL does not keep."""
    if not answer.is_success:
        return str(answer.json()["code"])
    is_json = "json" in answer.headers["content-type"]
    content = json.dumps(answer.json(), sort_keys=True).encode() if is_json else answer.content
    return hashlib.sha256(content).hexdigest()


def differing(before: dict[str, str], after: dict[str, str]) -> dict[str, str]:
    """Return what is different, or missing, afterwards."""
    return {name: after.get(name, "missing") for name in before | after if before.get(name) != after.get(name)}


@pytest.fixture
def hosts(tmp_path: Path) -> Iterator[list[Host]]:
    machines = [Host(tmp_path / name) for name in ("first", "second")]
    yield machines
    for host in machines:
        host.stop()


def install(operator: Operator) -> None:
    """Install a host by the page, in its order, and start the services."""
    start = DRILLED.index("cp deploy/host/sysusers.conf /etc/sysusers.d/soundlist.conf")
    for command in DRILLED[start : DRILLED.index("systemctl daemon-reload")]:
        operator.run(command)
    operator.host.fill_in(
        SOUNDLIST_SECRET_KEY="0123456789abcdef" * 4, SOUNDLIST_BASE_URL=f"http://127.0.0.1:{operator.host.port}"
    )
    for command in DRILLED[DRILLED.index("systemctl daemon-reload") :][:3]:
        operator.run(command)


def blob_of(host: Host, sha256: str) -> Path:
    """Return the file that holds a stored sound."""
    [path] = (host.data / "blobs").glob(f"*/*/{sha256}")
    return path


@pytest.mark.slow
@pytest.mark.timeout(3_600)  # some forty processes start one after the other
def test_nothing_is_lost_that_is_not_named(hosts: list[Host], postgres: Postgres) -> None:
    typed: set[str] = set()
    host, other_host = hosts
    operator, other_operator = Operator(host, typed), Operator(other_host, typed)

    def verify(who: Operator = operator) -> None:
        assert "0 are not whole" in who.run("soundlist verify").printed

    for folder in (".local/share/bash-completion/completions", ".zfunc", ".config/fish/completions"):
        (host.root / "home" / folder).mkdir(parents=True)
    for command in DRILLED[:5]:
        operator.run(command)
    assert "IMAGE_TAG=" in (host.checkout / ".env").read_text()

    # Installed and filled.
    install(operator)
    operator.run('soundlist accounts add ada@studio.example --name Ada --studio "Night Studio"', typed=f"{PASSWORD}\n")
    project = SmallProject(operator)
    assert "radar_ping" not in operator.run("soundlist mails").printed
    whole = project.downloads()
    assert not [name for name, digest in whole.items() if len(digest) != len(hashlib.sha256().hexdigest())], whole
    verify()
    host.run("systemctl start soundlist-backup")

    # Some files rot: one byte of a master, a whole master, an orphan that nothing names.
    flipped, deleted, _ = (take["master_sha256"] for take in project.takes)
    spoilt = bytearray(blob_of(host, flipped).read_bytes())
    spoilt[-1] ^= 1
    blob_of(host, flipped).write_bytes(spoilt)
    studio_blobs = blob_of(host, deleted).parents[1]
    blob_of(host, deleted).unlink()
    orphan = hashlib.sha256(b"nothing names me").hexdigest()
    (studio_blobs / orphan[:2]).mkdir(exist_ok=True)
    (studio_blobs / orphan[:2] / orphan).write_bytes(b"nothing names me")
    two_days_ago = time.time() - 2 * 86_400
    os.utime(studio_blobs / orphan[:2] / orphan, (two_days_ago, two_days_ago))
    scrubbed = operator.run("soundlist scrub", code=1)
    assert re.findall(r"^(\w+): .*/(\w{64})$", scrubbed.warned, re.MULTILINE) == sorted(
        [("altered", flipped), ("missing", deleted)], key=lambda damage: damage[1]
    )
    assert f"orphaned: {studio_blobs.name}/{orphan}" in scrubbed.printed
    rotten = differing(whole, project.downloads())
    assert rotten[f"/takes/{project.takes[0]['id']}/master"] == "blob-altered"
    assert rotten[f"/takes/{project.takes[1]['id']}/master"] == "blob-missing"
    assert all(name.startswith("pack.zip") for name in rotten if not name.endswith("/master")), rotten
    verify()

    # Restored; then every sound is lost while the database stays, and they are restored again.
    operator.run("soundlist restore FOLDER --sounds", FOLDER=BACKUPS)
    assert differing(whole, project.downloads()) == {}
    assert f"deleted: {studio_blobs.name}/{orphan}" in operator.run("soundlist scrub --delete-orphans").printed
    shutil.rmtree(host.data / "blobs")
    lost = operator.run("soundlist scrub", code=1)
    assert set(re.findall(r"^missing: .*/(\w{64})$", lost.warned, re.MULTILINE)) >= {flipped, deleted}
    operator.run("soundlist restore FOLDER --sounds", FOLDER=BACKUPS)
    operator.run("soundlist scrub --rate 20")
    assert differing(whole, project.downloads()) == {}
    verify()

    # The whole machine is lost; a new one comes out of the backup.
    host.stop()
    shutil.rmtree(host.data)
    host.data.mkdir(mode=0o700)
    restored = host.run(f"soundlist restore {BACKUPS}")
    assert restored.code == 0, restored.warned
    operator.run("systemctl restart soundlist-web")
    assert differing(whole, project.downloads()) == {}
    verify()
    host.run("systemctl start soundlist-worker@1")
    let_workers_finish(host)

    # To PostgreSQL and another store.
    url = postgres.new_database(f"drill_{host.port}")
    store = f"file://{host.root}/srv/sounds"
    move = next(command for command in DRILLED if command.startswith("soundlist move --database-url"))
    given = {
        "postgresql://soundlist:password@host/soundlist": f"'{url}'",
        "s3://sounds?endpoint=https://s3.example": store,
    }
    assert "equal in both databases" in operator.run(move, **given).printed
    host.fill_in(SOUNDLIST_DATABASE_URL=url, SOUNDLIST_STORE_URL=store)
    verify()
    operator.run("systemctl restart soundlist-web")
    assert differing(whole, project.downloads()) == {}

    # The studio goes to another server, beside what is there.
    operator.run(f"soundlist export {AN_ID} studio.zip", **{AN_ID: project.studio_id})
    install(other_operator)
    shutil.copy(host.checkout / "studio.zip", other_host.checkout)
    other_operator.run("soundlist import studio.zip")
    verify(other_operator)
    producer = Browser(other_host)
    producer.ask("POST", "/password-resets", json={"email": ADA})
    secret = mailed_secret(other_operator, ADA)
    producer.ask("POST", f"/password-resets/{secret}", json={"password": PASSWORD})
    producer.sign_in(ADA)
    assert differing(whole, project.downloads(producer)) == {}
    other_operator.run("soundlist operators add ada@studio.example")
    assert ADA in other_operator.run("soundlist operators list").printed
    other_operator.run("soundlist operators remove ada@studio.example")
    other_host.stop()

    # One designer leaves; of the other, a contract is running.
    refused = operator.run("soundlist erase person designer@example.com", code=2, typed="y\n")
    assert "is a party of the running contract Effects" in refused.warned
    erased = operator.run("soundlist erase person designer@example.com", typed="y\n", **{DESIGNER: GUEST})
    assert "kept: 1 delivered version (the studio's right to use it comes from the contract)" in erased.printed
    assert differing(whole, project.downloads()) == {}
    assert project.guest.send("GET", "/me").status_code == 401

    # A project and a studio without a contract are erased; the one with a contract stays.
    spare = project.open_project("Spare", "SP")
    operator.run(f"soundlist erase project {AN_ID}", typed="y\n", **{AN_ID: spare})
    assert project.producer.send("GET", f"/projects/{spare}").status_code == 404
    kept = operator.run(f"soundlist erase studio {AN_ID} --yes", code=2, **{AN_ID: project.studio_id})
    assert "has 1 signed contract" in kept.warned
    assert differing(whole, project.downloads()) == {}
    verify()

    # Upgraded, and back to SQLite.
    operator.run("systemctl start soundlist-migrate")
    operator.run("systemctl restart soundlist-web 'soundlist-worker@*'")
    operator.run("systemctl restart 'soundlist-worker@*'")
    assert differing(whole, project.downloads()) == {}
    host.run("systemctl start soundlist-worker@1")
    let_workers_finish(host)
    operator.run("soundlist move --data-dir /srv/soundlist")
    host.fill_in(SOUNDLIST_DATABASE_URL="", SOUNDLIST_STORE_URL=f"file://{host.root}/srv/soundlist/blobs")
    shutil.rmtree(host.data)
    shutil.move(host.root / "srv/soundlist", host.data)
    host.fill_in(SOUNDLIST_STORE_URL="")
    operator.run("systemctl restart soundlist-web")
    assert differing(whole, project.downloads()) == {}
    verify()

    operator.run("soundlist sign-out ada@studio.example")
    assert project.producer.send("GET", "/me").status_code == 401
    assert typed == set(DRILLED)


def let_workers_finish(host: Host) -> None:
    """Stop the web process, let the workers finish what waits, and stop them, as the page says before a move."""
    host.stop("soundlist-web")
    runtime = Runtime.of(host.settings())
    try:
        until(lambda: not unfinished_jobs(runtime))
        host.stop()
        until(lambda: not runtime.queue.heartbeats(within=WORKER_SILENT_AFTER))
    finally:
        runtime.close()
