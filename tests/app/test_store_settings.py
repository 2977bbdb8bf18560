"""Where the store is, read from its address, and refused in words."""

import os
import subprocess
import sys

import pytest
from pydantic import ValidationError

from app.core.db import Database
from app.migrate import migrate
from app.settings import BucketAddress, Settings, bucket_address

START = """
import sys
from app import worker
from app.cli import cli
from app.core.web import serving

serving.serve = worker.run = lambda *_, **__: print("it serves")
cli(sys.argv[1:])
"""
KEYS = {"aws_access_key_id": "id", "aws_secret_access_key": "hush"}


@pytest.fixture(autouse=True)
def _no_keys(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("AWS_ACCESS_KEY_ID", "AWS_SECRET_ACCESS_KEY", "AWS_REGION", "AWS_ENDPOINT_URL"):
        monkeypatch.delenv(name, raising=False)


def test_a_bucket_with_everything_said():
    url = "s3://sounds/studio/a?endpoint=http://s3:7070&region=eu-central-1&public_endpoint=https://files.example/"
    assert bucket_address(url) == BucketAddress(
        "sounds", "studio/a", "eu-central-1", "http://s3:7070", "https://files.example"
    )


def test_what_is_not_said_comes_from_where_aws_programs_look(monkeypatch):
    amazon = "https://s3.us-east-1.amazonaws.com"
    assert bucket_address("s3://sounds") == BucketAddress("sounds", "", "us-east-1", amazon, amazon)
    monkeypatch.setenv("AWS_REGION", "eu-west-3")
    assert bucket_address("s3://sounds/").endpoint == "https://s3.eu-west-3.amazonaws.com"
    monkeypatch.setenv("AWS_ENDPOINT_URL", "https://s3.example")
    assert bucket_address("s3://sounds").endpoint == "https://s3.example"


def test_keys_come_from_where_aws_programs_look(monkeypatch):
    monkeypatch.setenv("AWS_ACCESS_KEY_ID", "id")
    monkeypatch.setenv("AWS_SECRET_ACCESS_KEY", "hush")
    monkeypatch.setenv("SOUNDLIST_STORE_URL", "s3://sounds")
    settings = Settings()
    assert (settings.aws_access_key_id, settings.aws_secret_access_key.get_secret_value()) == ("id", "hush")
    assert settings.bucket is not None
    assert "hush" not in repr(settings)


@pytest.mark.parametrize(
    ("url", "reported"),
    [
        ("s3://Sounds", "names the bucket 'Sounds'"),
        ("s3://", "names the bucket ''"),
        ("s3://id:hush@sounds", "holds a key; take it out"),
        ("s3://sounds/a b", "has the prefix '/a b'"),
        ("s3://sounds?endpiont=https://s3.example", "has endpiont=; it may have endpoint="),
        ("s3://sounds?endpoint=s3.example", "has endpoint=s3.example; write endpoint=https://"),
        ("s3://sounds?public_endpoint=ftp://x", "has public_endpoint=ftp://x"),
        ("https://id:hush@s3.example/sounds", "begins with https://"),
        ("blobs", "begins with blobs://"),
    ],
)
def test_an_invalid_address_is_refused_with_a_reason(url, reported):
    with pytest.raises(ValidationError, match="SOUNDLIST_STORE_URL") as refused:
        Settings(store_url=url, **KEYS)
    (error,) = refused.value.errors()
    assert reported in error["msg"]
    assert "hush" not in error["msg"]


def test_a_bucket_without_keys_is_refused_with_a_reason():
    with pytest.raises(ValidationError, match="AWS_ACCESS_KEY_ID or AWS_SECRET_ACCESS_KEY is not set"):
        Settings(store_url="s3://sounds", aws_access_key_id="id")


def test_a_folder_has_no_bucket(tmp_path):
    assert Settings(store_url=f"file://{tmp_path}").bucket is None
    assert Settings(store_url=f"file://{tmp_path}").blob_dir == tmp_path


@pytest.mark.slow
@pytest.mark.parametrize("command", ["serve", "worker"])
@pytest.mark.parametrize(
    ("changed", "reported"),
    [
        ({}, None),
        ({"SOUNDLIST_STORE_URL": "s3://nobody-made-it?endpoint={endpoint}"}, "the store's bucket is not there"),
        ({"SOUNDLIST_STORE_URL": "s3://sounds?endpoint=http://127.0.0.1:1"}, "does not answer as an S3 server does"),
        ({"AWS_SECRET_ACCESS_KEY": "another"}, "the store refuses our key; see that AWS_ACCESS_KEY_ID"),
        ({"AWS_SECRET_ACCESS_KEY": ""}, "AWS_ACCESS_KEY_ID or AWS_SECRET_ACCESS_KEY is not set"),
    ],
    ids=["all is well", "no bucket", "no server", "wrong key", "no key"],
)
def test_a_store_that_cannot_be_used_is_said_at_start(s3, tmp_path, changed, reported, command):
    settings = s3.settings()
    environment = {
        "SOUNDLIST_DATA_DIR": str(tmp_path),
        "SOUNDLIST_SECRET_KEY": "k" * 32,
        "SOUNDLIST_STORE_URL": settings["store_url"],
        "AWS_ACCESS_KEY_ID": settings["aws_access_key_id"],
        "AWS_SECRET_ACCESS_KEY": settings["aws_secret_access_key"],
    } | {name: value.format(endpoint=s3.endpoint) for name, value in changed.items()}
    migrate(Database(f"sqlite:///{tmp_path / 'soundlist.sqlite'}"))
    # In a process of its own: `serve` forks one, which hangs where an earlier test has spoken to a store.
    started = subprocess.run(
        [sys.executable, "-c", START, command],
        env=os.environ | environment,
        capture_output=True,
        text=True,
        check=False,
    )
    if reported is None:
        assert (started.returncode, started.stdout.endswith("it serves\n")) == (0, True), (
            started.stdout + started.stderr
        )
    else:
        assert (started.returncode, reported in started.stderr) == (2, True), started.stderr
        assert s3.endpoint not in started.stderr
