"""Alerts, dashboard and documentation name metrics that a server serves, and Prometheus takes them."""

import json
import re
import shutil
import subprocess
from collections.abc import Iterator
from datetime import timedelta
from importlib import import_module
from pathlib import Path

import pytest
import sqlalchemy as sa
import yaml
from prometheus_client.parser import text_string_to_metric_families

from app import registry
from app.core import clock, metrics
from app.core.backups import Backup, record_backup
from app.core.jobs.queue import job_names
from app.core.runtime import Runtime
from app.main import create_app
from app.migrate import migrate
from app.notifications.models import Mail
from app.operations.figures import web_collectors
from app.settings import Settings

ROOT = Path(__file__).resolve().parents[2]
DEPLOY = ROOT / "deploy"
SUFFIXES = {"counter": ("_total",), "histogram": ("_bucket", "_sum", "_count")}
RULES = yaml.safe_load((DEPLOY / "alerts.yml").read_text())["groups"][0]["rules"]
PANELS = json.loads((DEPLOY / "grafana.json").read_text())["panels"]
QUERIES = [rule["expr"] for rule in RULES] + [target["expr"] for panel in PANELS for target in panel["targets"]]


@pytest.fixture
def runtime(tmp_path: Path) -> Iterator[Runtime]:
    runtime = Runtime.of(Settings(data_dir=tmp_path, secret_key="only for tests"))
    migrate(runtime.database)
    yield runtime
    runtime.close()


def served(runtime: Runtime) -> dict[tuple[str, str], float]:
    """Return the values of a scrape by name and labels."""
    families = text_string_to_metric_families(metrics.exposition(web_collectors(runtime)).decode())
    return {
        (sample.name, ",".join(sample.labels.values())): sample.value
        for family in families
        for sample in family.samples
    }


def names_served(runtime: Runtime) -> set[str]:
    create_app(runtime)
    for module in registry.rooms_in_use(is_commercial=True).job_modules:  # whose counters a worker serves
        import_module(module)
    families = text_string_to_metric_families(metrics.exposition(web_collectors(runtime)).decode())
    return {f"{family.name}{suffix}" for family in families for suffix in SUFFIXES.get(family.type, ("",))}


@pytest.mark.slow
def test_every_metric_that_is_named_is_served(runtime: Runtime):
    page = (ROOT / "docs" / "reference" / "settings.md").read_text()
    documented = re.findall(r"`(soundlist_\w+)`", page.partition("\n## Metrics\n")[2])
    queried = {name for query in QUERIES for name in re.findall(r"\b(?:soundlist|process)_\w+", query)}
    bare_histograms = {"soundlist_request_seconds", "soundlist_job_seconds"}
    names = names_served(runtime)
    assert len(queried) > 10
    assert (queried | set(documented)) - bare_histograms <= names
    ours = {
        name
        for name in names
        if name.startswith("soundlist_") and not name.endswith(("_bucket", "_sum", "_count", "_created"))
    }
    assert ours <= set(documented), "docs/reference/settings.md lists every metric"


def test_every_alert_says_what_is_wrong():
    for rule in RULES:
        assert rule["labels"]["severity"] in ("critical", "warning"), rule["alert"]
        assert rule["annotations"]["summary"], rule["alert"]
    names = [rule["alert"] for rule in RULES]
    assert len(set(names)) == len(names)
    for job in re.findall(r'job="([a-z_.-]+)"', " ".join(QUERIES)):
        for module in registry.rooms_in_use(is_commercial=True).job_modules:
            import_module(module)
        assert job.startswith("soundlist-") or job in job_names()


@pytest.mark.slow
def test_mails_backups_and_the_disk_are_reported(runtime: Runtime):
    before = served(runtime)
    assert ("soundlist_backup_age_seconds", "") not in before, "absent() tells that there is none"
    assert before["soundlist_mails", "waiting"] == before["soundlist_mail_oldest_seconds", ""] == 0
    an_hour_ago = clock.now() - timedelta(hours=1)
    with runtime.database.writing() as session:
        for number, failure in enumerate([None, None, "550 no such mailbox"]):
            recipient, topic = f"{number}@studio.example", f"test:{number}"
            mail = Mail(
                topic=topic, recipient=recipient, subject="News", lines=[], event_ids=[], send_after=an_hour_ago
            )
            mail.failure = failure
            session.add(mail)
    record_backup(runtime.database, 2)
    with runtime.database.writing() as session:
        session.execute(sa.update(Backup).values(finished_at=an_hour_ago))
    after = served(runtime)
    assert (after["soundlist_mails", "waiting"], after["soundlist_mails", "failed"]) == (2, 1)
    assert 3600 <= after["soundlist_mail_oldest_seconds", ""] < 7200
    assert 3600 <= after["soundlist_backup_age_seconds", ""] < 7200
    assert after["soundlist_backup_damaged_blobs", ""] == 2
    record_backup(runtime.database, 0)
    assert served(runtime)["soundlist_backup_age_seconds", ""] < 3600, "the newest counts"
    disk = shutil.disk_usage(runtime.settings.data_dir)
    assert 0 < after["soundlist_disk_free_bytes", "data"] <= disk.total
    assert after["soundlist_disk_free_bytes", "store"] > 0


def test_each_process_of_compose_is_scraped_by_itself():
    compose = yaml.safe_load((ROOT / "docker-compose.yml").read_text())
    jobs = yaml.safe_load((DEPLOY / "prometheus.yml").read_text())["scrape_configs"]
    ports = {job["dns_sd_configs"][0]["names"][0]: job["dns_sd_configs"][0]["port"] for job in jobs}
    worker = compose["services"]["worker"]["environment"]
    assert ports == {"web": 8000, "worker": int(worker["SOUNDLIST_METRICS_PORT"])}
    assert worker["SOUNDLIST_METRICS_HOST"] == "0.0.0.0"  # noqa: S104  within Compose's own network
    watching = compose["services"]["prometheus"]
    assert "./deploy/alerts.yml:/etc/prometheus/alerts.yml:ro" in watching["volumes"]
    assert all(job["honor_labels"] for job in jobs), "our metrics have a label job, which would be renamed"
    assert {job["authorization"]["credentials_file"] for job in jobs} == {f"/run/secrets/{watching['secrets'][0]}"}


def test_prometheus_itself_takes_them_where_it_is(tmp_path: Path):
    promtool = shutil.which("promtool")
    if promtool is None:
        return
    queries = [{"record": f"panel:{number}", "expr": query} for number, query in enumerate(QUERIES)]
    rules = {"groups": [{"name": "panels", "rules": queries}]}
    (tmp_path / "panels.yml").write_text(yaml.safe_dump(rules).replace("$__rate_interval", "1m"))
    for file in (DEPLOY / "alerts.yml", tmp_path / "panels.yml"):
        subprocess.run([promtool, "check", "rules", str(file)], check=True)
    config = (DEPLOY / "prometheus.yml").read_text()
    (tmp_path / "token").write_text("figures for machines only")
    config = config.replace("/etc/prometheus/alerts.yml", str(DEPLOY / "alerts.yml"))
    (tmp_path / "prometheus.yml").write_text(config.replace("/run/secrets/metrics_token", str(tmp_path / "token")))
    subprocess.run([promtool, "check", "config", str(tmp_path / "prometheus.yml")], check=True)
