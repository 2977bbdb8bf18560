"""Signed links, held against the example that AWS publishes and against what a real server does with them."""

from datetime import UTC, datetime

import pytest

from app.core.storage.signing import Key, Signer
from tests.support.s3 import S3Server


def test_the_published_example():
    # AWS, "Authenticating Requests: Using Query Parameters (AWS Signature Version 4)", its example of a GET.
    key = Key("AKIAIOSFODNN7EXAMPLE", "wJalrXUtnFEMI/K7MDENG/bPxRfiCYEXAMPLEKEY")
    signer = Signer("https://examplebucket.s3.amazonaws.com", "us-east-1", key)
    at = datetime(2013, 5, 24, tzinfo=UTC)
    assert signer.url("GET", "/test.txt", expires_in_s=86400, at=at) == (
        "https://examplebucket.s3.amazonaws.com/test.txt?X-Amz-Algorithm=AWS4-HMAC-SHA256"
        "&X-Amz-Credential=AKIAIOSFODNN7EXAMPLE%2F20130524%2Fus-east-1%2Fs3%2Faws4_request"
        "&X-Amz-Date=20130524T000000Z&X-Amz-Expires=86400&X-Amz-SignedHeaders=host"
        "&X-Amz-Signature=aeeed9bbccd4d02ee5c0109b86d86835f995330da4c265957d157751f604d404"
    )


def test_a_token_of_temporary_keys_is_signed_too():
    signed = Signer("https://s3.example", "r", Key("id", "secret", "a/token+")).url("GET", "/b/k", expires_in_s=60)
    assert "&X-Amz-Security-Token=a%2Ftoken%2B&" in signed


@pytest.mark.slow
def test_a_link_serves_its_own_method_path_and_length_only(s3: S3Server):
    bucket, signer = s3.new_bucket(), s3.signer()
    path = f"/{bucket}/a (1) ü+.wav"
    put = signer.url("PUT", path, headers={"content-length": "5"}, expires_in_s=60)
    assert s3.client.put(put, content=b"longer").status_code == 403
    assert s3.client.put(put, content=b"less").status_code == 403
    assert s3.client.put(put, content=b"bytes").status_code == 200
    assert s3.client.get(put).status_code == 403
    name = "attachment; filename*=UTF-8''%C3%BC.wav"
    got = s3.client.get(signer.url("GET", path, {"response-content-disposition": name}, expires_in_s=60))
    assert (got.content, got.headers["content-disposition"]) == (b"bytes", name)
    late = signer.url("GET", path, expires_in_s=60, at=datetime(2020, 1, 1, tzinfo=UTC))
    assert s3.client.get(late).status_code == 403
