"""What an operator starts from: each command runs, each setting is one, each health check works, outside containers."""

import configparser
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import threading
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path
from typing import Any
from uuid import UUID

import httpx
import pytest
import yaml
from typer.testing import CliRunner

from app.cli import cli
from app.cli.running import STOP_WITHIN_S
from app.core.storage import open_store
from app.core.web import bodies, serving
from app.deliveries.rules import MAX_ARCHIVE_BYTES
from app.settings import Settings, bucket_address, read_settings
from tests.support.s3 import KEY, free_port, run_program, s3_program
from tests.support.server import RunningServer

ROOT = Path(__file__).resolve().parents[2]
DEPLOY = ROOT / "deploy"
UNITS = sorted((DEPLOY / "systemd").iterdir())
OUR_SERVICES = [path for path in UNITS if path.suffix == ".service" and "failed" not in path.name]
HOST = DEPLOY / "host"
STUDIO_ID = UUID(int=1)
SET = {"SOUNDLIST_DOMAIN": "sounds.example", "SOUNDLIST_FILES_DOMAIN": "files.sounds.example"}
IMAGE = {"IMAGE_TAG": "v1.2.3"}
SECRETS = {
    *("SOUNDLIST_SECRET_KEY", "POSTGRES_PASSWORD"),
    *("S3_ROOT_ACCESS_KEY", "S3_ROOT_SECRET_KEY", "S3_ACCESS_KEY", "S3_SECRET_KEY"),
}


def filled(written: Any, given: dict[str, str]) -> Any:
    """Put values in the place of ${NAME}, ${NAME:-default} and ${NAME:?why}, as compose does."""
    if isinstance(written, dict):
        return {name: filled(value, given) for name, value in written.items()}
    if isinstance(written, list):
        return [filled(value, given) for value in written]
    if not isinstance(written, str):
        return written

    def value(found: re.Match[str]) -> str:
        name, how, rest = found.groups()
        if given.get(name):
            return given[name]
        assert how != ":?", f"{name} {rest}"
        return rest if how == ":-" else ""

    return re.sub(r"\$\{([A-Z0-9_]+)(?:(:[-?])([^}]*))?\}", value, written)


@pytest.fixture(scope="module")
def compose() -> dict[str, Any]:
    written = yaml.safe_load((ROOT / "docker-compose.yml").read_text())
    return dict(filled(written, SET | IMAGE | dict.fromkeys(SECRETS, "0123456789abcdef" * 2)))


@pytest.fixture(scope="module")
def ours(compose: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """The services that run our image."""
    return {name: service for name, service in compose["services"].items() if "build" in service}


@pytest.mark.parametrize("name", sorted({"SOUNDLIST_DOMAIN", "SOUNDLIST_FILES_DOMAIN", "IMAGE_TAG"} | SECRETS))
def test_what_is_not_set_is_said_before_anything_starts(name: str):
    given = SET | IMAGE | dict.fromkeys(SECRETS, "x" * 32) | {name: ""}
    with pytest.raises(AssertionError, match=f"{name} is not set; (make|give)"):
        filled(yaml.safe_load((ROOT / "docker-compose.yml").read_text()), given)


def test_the_example_of_settings_names_all_that_is_asked_for():
    asked = set(re.findall(r"\$\{([A-Z0-9_]+)", (ROOT / "docker-compose.yml").read_text()))
    named = set(re.findall(r"^([A-Z0-9_]+)=", (DEPLOY / "env.example").read_text(), re.MULTILINE))
    assert named == asked
    settings = {f"SOUNDLIST_{name.upper()}" for name in Settings.model_fields}
    assert {name for name in named if name.startswith("SOUNDLIST_")} - settings == set(SET)


def test_every_setting_of_the_containers_is_one(ours: dict[str, dict[str, Any]], monkeypatch: pytest.MonkeyPatch):
    for name, service in ours.items():
        with monkeypatch.context() as patched:
            for variable, value in service["environment"].items():
                patched.setenv(variable, value)
            settings = Settings()
        known = {f"SOUNDLIST_{field.upper()}" for field in Settings.model_fields}
        assert {each for each in service["environment"] if each.startswith("SOUNDLIST_")} <= known, name
        assert settings.bucket is not None
        assert settings.bucket.public_endpoint == "https://files.sounds.example"
        assert (settings.store_direct, settings.base_url) == (True, "https://sounds.example")


def test_web_worker_migration_and_backup_are_there(ours: dict[str, dict[str, Any]]):
    assert set(ours) == {"web", "worker", "migrate", "backup"}
    assert "container_name" not in ours["worker"], "a worker with a name of its own could not be scaled"
    assert not ours["worker"].get("ports")


@pytest.mark.slow
def test_every_service_runs_a_command_that_there_is(ours: dict[str, dict[str, Any]]):
    for name, service in ours.items():
        program, command, *options = service["command"]
        shown = CliRunner().invoke(cli, [command, "--help"])
        assert (program, shown.exit_code) == ("soundlist", 0), name
        for option in options:
            assert not option.startswith("--") or option in shown.output, f"{name}: {option}"


def test_every_service_that_lasts_says_whether_it_is_well(compose: dict[str, Any]):
    for name, service in compose["services"].items():
        lasts = service.get("restart") != "no"
        assert ("test" in service.get("healthcheck", {})) is lasts, name


def test_nothing_runs_with_more_rights_than_it_needs(compose: dict[str, Any]):
    for name, service in compose["services"].items():
        if name != "bucket":  # it gives a folder to the store's user, once, without a network
            assert service["read_only"] is True, name
            assert "no-new-privileges:true" in service["security_opt"], name
        if name not in ("bucket", "postgres"):  # whose image begins as root and becomes its own user
            assert service["cap_drop"] == ["ALL"], name
        for port in service.get("ports", []):
            assert name == "proxy" or port.startswith("127.0.0.1:"), f"{name} is open to everyone"


def test_no_service_takes_all_memory_processes_or_disk(compose: dict[str, Any]):
    for name, service in compose["services"].items():
        assert re.fullmatch(r"[0-9]+[mg]", service["mem_limit"]), name
        assert 0 < service["pids_limit"] <= 512, name
        assert service["logging"]["options"].keys() == {"max-size", "max-file"}, name
        for mount in service.get("tmpfs", []):
            if mount.startswith("/tmp"):  # noqa: S108
                [size, unit] = re.findall(r"^/tmp:size=([0-9]+)([mg]),mode=1777$", mount)[0]
                share = mebibytes(f"{size}{unit}") / mebibytes(service["mem_limit"])
                assert share <= 0.6, f"{name}: what is in /tmp counts as memory"


def mebibytes(written: str) -> int:
    return int(written[:-1]) * {"m": 1, "g": 1024}[written[-1]]


def test_every_image_has_a_version(compose: dict[str, Any]):
    for name, service in compose["services"].items():
        assert re.fullmatch(r"[\w./-]+:[\w.-]+", service["image"]), name
    web = compose["services"]["web"]
    assert (web["image"], web["build"]["args"]) == ("soundlist:v1.2.3", {"VERSION": "v1.2.3"})


def test_the_key_of_the_whole_store_stays_with_the_store():
    services = yaml.safe_load((ROOT / "docker-compose.yml").read_text())["services"]
    knowing = {name for name, service in services.items() if "S3_ROOT" in json.dumps(service)}
    assert knowing == {"s3", "bucket-key"}


def test_every_volume_and_every_service_waited_for_is_there(compose: dict[str, Any]):
    for name, service in compose["services"].items():
        for volume in service.get("volumes", []):
            source = volume.partition(":")[0]
            assert source in compose["volumes"] or (ROOT / source).exists(), f"{name}: {volume}"
        for other, how in service.get("depends_on", {}).items():
            waited_for = compose["services"][other]
            one_shot = waited_for.get("restart") == "no"
            assert (how["condition"] == "service_completed_successfully") is one_shot, f"{name} waits for {other}"


@pytest.mark.slow
@pytest.mark.parametrize("name", ["web", "worker"])
def test_a_health_check_distinguishes_well_from_ill(ours: dict[str, dict[str, Any]], name: str):
    [how, *command] = ours[name]["healthcheck"]["test"]
    assert how == "CMD"
    [address] = re.findall(r"http://127\.0\.0\.1:[0-9]+(/[a-z]+)", command[-1])
    for status, code in ((200, 0), (503, 1)):
        with answering(address, status) as port:
            here = [re.sub(r"127\.0\.0\.1:[0-9]+", f"127.0.0.1:{port}", part) for part in command]
            assert subprocess.run([sys.executable, *here[1:]], capture_output=True).returncode == code
    assert address == "/healthz"


class answering:  # noqa: N801
    """A server that answers one path with one status."""

    def __init__(self, path: str, status: int) -> None:
        class Answer(BaseHTTPRequestHandler):
            def do_GET(self) -> None:
                self.send_response(status if self.path == path else 404)
                self.end_headers()

            def log_message(self, *_: object) -> None:
                """Say nothing."""

        self._server = HTTPServer(("127.0.0.1", 0), Answer)
        self._thread = threading.Thread(target=self._server.serve_forever, args=(0.01,))

    def __enter__(self) -> int:
        self._thread.start()
        return self._server.server_port

    def __exit__(self, *_: object) -> None:
        self._server.shutdown()
        self._thread.join()
        self._server.server_close()


@pytest.mark.slow
def test_the_health_checks_ask_what_the_server_answers(server: RunningServer, ours: dict[str, dict[str, Any]]):
    assert server.browser().get("/healthz").status_code == 200
    assert "/healthz" in ours["web"]["healthcheck"]["test"][-1]
    assert ours["worker"]["environment"]["SOUNDLIST_METRICS_PORT"] in ours["worker"]["healthcheck"]["test"][-1]


@pytest.mark.slow
def test_the_store_runs_as_configured(compose: dict[str, Any], tmp_path: Path):
    service, port = compose["services"]["s3"], free_port()
    made = compose["services"]["bucket"]["entrypoint"][-1].partition(" && ")[0].replace("/store", str(tmp_path))
    subprocess.run(shlex.split(made), check=True)
    command = [
        part.replace("/store", str(tmp_path)).replace(":7070", f"127.0.0.1:{port}") for part in service["command"]
    ]
    address = bucket_address(compose["services"]["web"]["environment"]["SOUNDLIST_STORE_URL"])
    assert (tmp_path / "buckets" / address.bucket).is_dir()
    environment = service["environment"] | {"ROOT_ACCESS_KEY": KEY.id, "ROOT_SECRET_KEY": KEY.secret}
    endpoint = f"http://127.0.0.1:{port}"
    (tmp_path / "versitygw").symlink_to(s3_program())
    keys = {
        "ADMIN_ENDPOINT_URL": endpoint,
        "ADMIN_ACCESS_KEY": KEY.id,
        "ADMIN_SECRET_KEY": KEY.secret,
        "PATH": f"{tmp_path}:{os.environ['PATH']}",
    }
    with run_program([s3_program(), *command], f"{endpoint}/health", tmp_path / "log", environment):
        asked = httpx.options(
            f"{endpoint}/{address.bucket}/key",
            headers={"Origin": "https://sounds.example", "Access-Control-Request-Method": "PUT"},
        )
        assert asked.headers["access-control-allow-origin"] == "https://sounds.example"
        assert address.region == service["environment"]["VGW_REGION"]
        for secret in ("the first secret", "the second secret"):  # at each start, and with another secret in .env
            give_key = [part.replace("$$", "$") for part in compose["services"]["bucket-key"]["entrypoint"]]
            subprocess.run(give_key, env=keys | {"KEY": "application", "SECRET": secret}, check=True)
        url = compose["services"]["web"]["environment"]["SOUNDLIST_STORE_URL"].replace("http://s3:7070", endpoint)
        store = open_store(
            Settings(
                data_dir=tmp_path / "data",
                store_url=url,
                aws_access_key_id="application",
                aws_secret_access_key="the second secret",
            )
        )
        store.ensure_ready()
        stored = store.put(STUDIO_ID, [b"a sound"])
        assert b"".join(store.stream(STUDIO_ID, stored.sha256)) == b"a sound"
    assert service["healthcheck"]["test"][-1].endswith(":7070/health")


@pytest.fixture(scope="module")
def stages() -> list[list[str]]:
    text = (ROOT / "Dockerfile").read_text().replace("\\\n", " ")
    lines = [line for line in text.splitlines() if line and not line.startswith("#")]
    begins = [number for number, line in enumerate(lines) if line.startswith("FROM ")]
    return [lines[start:end] for start, end in zip(begins, [*begins[1:], len(lines)], strict=True)]


class TestImage:
    def test_what_runs_has_no_compiler_and_is_not_root(self, stages: list[list[str]]):
        last = "\n".join(stages[-1])
        assert not re.search(r"\b(gcc|g\+\+|clang|make|libc6-dev)\b", last)
        assert re.search(r"^USER 10001$", last, re.MULTILINE)
        assert "postgresql-client" in last
        assert any("gcc" in line for stage in stages[:-1] for line in stage)

    def test_everything_that_is_copied_is_there(self, stages: list[list[str]]):
        ignored = [line for line in (ROOT / ".dockerignore").read_text().splitlines() if "*" not in line]
        for line in (line for stage in stages for line in stage if line.startswith("COPY ") and "--from" not in line):
            for source in line.split()[1:-1]:
                assert (ROOT / source).exists(), line
                assert not any(source == each or source.startswith(f"{each}/") for each in ignored), line

    def test_it_says_whether_it_is_well_as_compose_does(self, stages: list[list[str]], compose: dict[str, Any]):
        [line] = [line for line in stages[-1] if line.startswith("HEALTHCHECK ")]
        command = json.loads(line[line.index("[") :])
        assert ["CMD", *command] == compose["services"]["web"]["healthcheck"]["test"]

    def test_it_serves(self, stages: list[list[str]], compose: dict[str, Any]):
        [line] = [line for line in stages[-1] if line.startswith("CMD ")]
        assert json.loads(line.removeprefix("CMD ")) == compose["services"]["web"]["command"]


class TestProxy:
    def test_each_site_leads_to_a_service_that_is_there(self, compose: dict[str, Any]):
        text = (DEPLOY / "Caddyfile").read_text()
        assert text.count("{") == text.count("}")
        sites = re.findall(r"^\{\$([A-Z_]+)\} \{$", text, re.MULTILINE)
        assert set(sites) == compose["services"]["proxy"]["environment"].keys() == set(SET)
        assert "dynamic a web 8000" in text
        assert "8000" in compose["services"]["web"]["command"]
        assert "reverse_proxy s3:7070" in text
        assert ":7070" in compose["services"]["s3"]["command"]

    def test_it_takes_what_web_processes_take_and_bounds_the_rest(self):
        text = (DEPLOY / "Caddyfile").read_text()
        sizes = dict(re.findall(r"request_body (@\w+) \{\s+max_size ([0-9]+)", text))
        assert int(sizes["@uploads"]) * 10**9 > MAX_ARCHIVE_BYTES
        assert int(sizes["@rest"]) * 10**6 > bodies.REPORT_BODY_BYTES
        assert re.search(r"read_header 20s", text)
        assert re.search(r"max_header_size 64KB", text)

    def test_it_gives_an_unused_line_up_before_a_web_process_closes_it(self):
        [kept_s] = re.findall(r"keepalive ([0-9]+)s", (DEPLOY / "Caddyfile").read_text())
        assert int(kept_s) < serving.HEAD_S

    def test_it_is_the_one_that_rolling_restarts_are_tried_with(self, compose: dict[str, Any]):
        [version] = re.findall(r"caddy v([0-9.]+)$", (ROOT / ".ci" / "caddy").read_text(), re.MULTILINE)
        assert compose["services"]["proxy"]["image"] == f"caddy:{version}"

    def test_caddy_itself_takes_it_where_there_is_one(self):
        caddy = shutil.which("caddy")
        if caddy is not None:
            command = [caddy, "validate", "--adapter", "caddyfile", "--config", str(DEPLOY / "Caddyfile")]
            subprocess.run(command, env=os.environ | SET, check=True)


def test_a_web_process_is_given_the_time_that_stopping_takes(ours: dict[str, dict[str, Any]]):
    longest_s = STOP_WITHIN_S
    web = ours["web"]
    assert float(web["environment"]["SOUNDLIST_DRAIN_S"]) + longest_s < float(web["stop_grace_period"].rstrip("s"))
    unit = (DEPLOY / "systemd" / "soundlist-web.service").read_text()
    [drain_s], [within_s] = re.findall(r"DRAIN_S=(.+)", unit), re.findall(r"TimeoutStopSec=(.+)", unit)
    assert float(drain_s) > 0
    assert float(drain_s) + longest_s < float(within_s)


def test_a_worker_may_write_where_librosa_keeps_what_it_compiles(ours: dict[str, dict[str, Any]]):
    """Where it may not, librosa cannot be imported; nearly everything else is read-only."""
    [in_image] = re.findall(r"NUMBA_CACHE_DIR=(\S+)", (ROOT / "Dockerfile").read_text())
    assert any(Path(in_image).is_relative_to(mount.partition(":")[0]) for mount in ours["worker"]["tmpfs"])
    unit = (DEPLOY / "systemd" / "soundlist-worker@.service").read_text()
    [by_unit] = re.findall(r"NUMBA_CACHE_DIR=(\S+)", unit)
    assert by_unit == in_image
    assert "PrivateTmp=true" in unit


class TestUnits:
    def unit(self, path: Path) -> configparser.ConfigParser:
        read = configparser.ConfigParser(strict=False, interpolation=None)
        read.optionxform = str
        read.read_string(path.read_text())
        return read

    @pytest.mark.parametrize("path", OUR_SERVICES, ids=lambda path: path.name)
    def test_a_unit_runs_a_command_that_there_is(self, path: Path):
        service = self.unit(path)["Service"]
        program, command, *options = shlex.split(service["ExecStart"])
        shown = CliRunner().invoke(cli, [command, "--help"])
        assert (program, shown.exit_code) == ("/opt/soundlist/.venv/bin/soundlist", 0)
        assert all(option in shown.output for option in options if option.startswith("--"))
        assert (service["User"], service["NoNewPrivileges"], service["ProtectSystem"], service["UMask"]) == (
            "soundlist",
            "true",
            "strict",
            "0077",
        )
        named = re.findall(r"(SOUNDLIST_[A-Z_]+)=", path.read_text())
        assert set(named) <= {f"SOUNDLIST_{name.upper()}" for name in Settings.model_fields}

    def test_units_name_units_that_there_are(self):
        names = {path.name for path in UNITS}
        for path in UNITS:
            for other in re.findall(r"soundlist-[a-z]+@?\.(?:service|timer)", path.read_text()):
                assert other in names, f"{path.name}: {other}"
        assert {f"{path.stem}.service" for path in UNITS if path.suffix == ".timer"} <= names

    def test_each_start_migrates_and_what_fails_is_tried_again(self):
        assert "RemainAfterExit" not in self.unit(DEPLOY / "systemd" / "soundlist-migrate.service")["Service"]
        for name in ("soundlist-web.service", "soundlist-worker@.service"):
            unit = self.unit(DEPLOY / "systemd" / name)
            assert "soundlist-migrate.service" in unit["Unit"]["Wants"].split()
            assert "soundlist-migrate.service" in unit["Unit"]["After"].split()
            assert (unit["Service"]["Restart"], unit["Unit"]["StartLimitIntervalSec"]) == ("always", "0")

    def test_failures_of_what_runs_alone_are_mailed(self):
        for name in ("soundlist-migrate.service", "soundlist-backup.service"):
            unit = self.unit(DEPLOY / "systemd" / name)
            assert (unit["Service"]["Type"], unit["Unit"]["OnFailure"]) == ("oneshot", "soundlist-failed@%n.service")

    def test_the_mail_about_a_failure_can_be_sent(self, tmp_path: Path):
        command = self.unit(DEPLOY / "systemd" / "soundlist-failed@.service")["Service"]["ExecStart"]
        command = command.replace("/usr/sbin/sendmail -t", f"cat > {tmp_path}/mail").replace("journalctl", "echo")
        command = command.replace("%i", "soundlist-backup.service").replace("%H", "host").replace("\\\\", "\\")
        subprocess.run(shlex.split(command), check=True)
        mail = (tmp_path / "mail").read_text()
        assert mail.startswith("To: root\nSubject: soundlist-backup.service failed on host\n\n")
        assert "--unit=soundlist-backup.service" in mail

    def test_backups_have_a_folder_that_their_user_may_write_to(self):
        service = self.unit(DEPLOY / "systemd" / "soundlist-backup.service")["Service"]
        [folder] = [shlex.split(service["ExecStart"])[2]]
        assert service["ReadWritePaths"] == f"-{folder}", "without the minus a missing folder stops systemd, not us"
        [line] = [line for line in (HOST / "tmpfiles.conf").read_text().splitlines() if line.startswith("d ")]
        assert line.split()[1:5] == [folder, "0700", service["User"], service["User"]]

    def test_systemd_itself_makes_the_user(self, tmp_path: Path):
        program = shutil.which("systemd-sysusers")
        if program is None:
            return
        (tmp_path / "etc").mkdir()
        subprocess.run([program, f"--root={tmp_path}", str(HOST / "sysusers.conf")], check=True)
        [line] = [line for line in (tmp_path / "etc/passwd").read_text().splitlines() if line.startswith("soundlist:")]
        assert line.split(":")[5] == "/var/lib/soundlist"

    def test_systemd_itself_takes_them_where_there_is_one(self, tmp_path: Path):
        analyze = shutil.which("systemd-analyze")
        if analyze is None:
            return
        for path in UNITS:
            text = path.read_text().replace("/opt/soundlist", str(ROOT)).replace("User=soundlist\n", "")
            (tmp_path / path.name).write_text(text)
        checked = subprocess.run(
            [analyze, "verify", "--man=no", *sorted(tmp_path.iterdir())], capture_output=True, text=True
        )
        about_ours = [line for line in checked.stderr.splitlines() if "soundlist" in line]
        assert about_ours == []


class TestHost:
    """The files for a machine without containers."""

    def test_the_example_of_settings_can_be_used_once_it_is_filled_in(self, monkeypatch: pytest.MonkeyPatch):
        text = (HOST / "soundlist.env").read_text()
        for uncommented in (text, re.sub(r"^#(?=[A-Z])", "", text, flags=re.MULTILINE)):
            with monkeypatch.context() as patched:
                for name, value in re.findall(r"^([A-Z_]+)=(.*)$", uncommented, re.MULTILINE):
                    patched.setenv(name, value or "0123456789abcdef")
                settings = read_settings(serving=True)
            assert (settings.base_url, settings.sign_up) == ("https://sounds.example", "invited")

    def test_its_proxy_does_what_the_other_does(self):
        text, contained = (HOST / "Caddyfile").read_text(), (DEPLOY / "Caddyfile").read_text()
        assert text.count("{") == text.count("}")
        [address] = re.findall(r"^\t\tto (\S+)$", text, re.MULTILINE)
        command = shlex.split((DEPLOY / "systemd" / "soundlist-web.service").read_text().split("ExecStart=")[1])
        assert address == f"{command[command.index('--host') + 1]}:{command[command.index('--port') + 1]}"
        for line in ("max_size 6GB", "max_size 20MB", "lb_try_duration 20s", "flush_interval -1", "keepalive 15s"):
            assert line in text
            assert line in contained

    def test_caddy_itself_takes_it_where_there_is_one(self):
        caddy = shutil.which("caddy")
        if caddy is not None:
            command = [caddy, "validate", "--adapter", "caddyfile", "--config", str(HOST / "Caddyfile")]
            subprocess.run(command, check=True)


def test_the_documented_upgrade_leaves_no_stopped_container_behind():
    """One that stays would be started again, with the old version, by the next upgrade."""
    docs = (ROOT / "docs" / "how-to" / "operate.md").read_text()
    [commands] = [block for block in docs.split("```") if "--no-recreate" in block]
    order = (
        "git checkout",
        "IMAGE_TAG",
        "compose build",
        "migrate",
        "compose ps",
        "--scale web",
        "docker rm $old",
        "worker",
    )
    steps = [next(step for step in order if step in line) for line in commands.strip().splitlines()]
    assert steps == list(order)
    assert re.search(r"old=\$\(docker compose ps --quiet web\)", docs), "by its id, since numbers grow"
    [replaced] = re.findall(r"s/\^(\w+)=", commands)
    assert re.search(rf"^{replaced}=", (DEPLOY / "env.example").read_text(), re.MULTILINE)


def test_the_cors_rules_are_those_that_the_page_needs():
    [rule] = json.loads((DEPLOY / "cors.json").read_text())["CORSRules"]
    assert rule["AllowedOrigins"] == ["https://sounds.example"]
    assert set(rule["AllowedMethods"]) == {"GET", "PUT"}
