"""Links that an S3 server honours without further credentials: AWS Signature Version 4, in the query.

obstore signs paths alone; multipart uploads, and names for downloads, are asked for in the query.
Source: AWS, "Authenticating Requests: Using Query Parameters (AWS Signature Version 4)".
"""

import hashlib
import hmac
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from urllib.parse import quote, urlsplit

from app.core import clock

ALGORITHM = "AWS4-HMAC-SHA256"
BODY_UNSIGNED = "UNSIGNED-PAYLOAD"


@dataclass(frozen=True)
class Key:
    """A key to an S3 server; the token comes with keys that expire."""

    id: str
    secret: str
    token: str = ""


@dataclass(frozen=True)
class Signer:
    """Signs requests to one S3 server."""

    endpoint: str
    region: str
    key: Key

    def url(
        self,
        method: str,
        path: str,
        query: Mapping[str, str] | None = None,
        *,
        headers: Mapping[str, str] | None = None,
        expires_in_s: int,
        at: datetime | None = None,
    ) -> str:
        """Return a link for one method and path; its user must send exactly these headers (lower case)."""
        stamp = (at or clock.now()).strftime("%Y%m%dT%H%M%SZ")
        scope = f"{stamp[:8]}/{self.region}/s3/aws4_request"
        signed = {**(headers or {}), "host": urlsplit(self.endpoint).netloc}
        names = ";".join(sorted(signed))
        asked = {
            **(query or {}),
            "X-Amz-Algorithm": ALGORITHM,
            "X-Amz-Credential": f"{self.key.id}/{scope}",
            "X-Amz-Date": stamp,
            "X-Amz-Expires": str(expires_in_s),
            "X-Amz-SignedHeaders": names,
        }
        if self.key.token:
            asked["X-Amz-Security-Token"] = self.key.token
        canonical_path = quote(path, safe="/-_.~")
        canonical_query = "&".join(f"{_quoted(name)}={_quoted(value)}" for name, value in sorted(asked.items()))
        canonical_headers = "".join(f"{name}:{signed[name]}\n" for name in sorted(signed))
        request = "\n".join([method, canonical_path, canonical_query, canonical_headers, names, BODY_UNSIGNED])
        to_sign = "\n".join([ALGORITHM, stamp, scope, hashlib.sha256(request.encode()).hexdigest()])
        signature = hmac.new(self._signing_key(stamp[:8]), to_sign.encode(), "sha256").hexdigest()
        return f"{self.endpoint}{canonical_path}?{canonical_query}&X-Amz-Signature={signature}"

    def _signing_key(self, day: str) -> bytes:
        key = f"AWS4{self.key.secret}".encode()
        for part in (day, self.region, "s3", "aws4_request"):
            key = hmac.new(key, part.encode(), "sha256").digest()
        return key


def _quoted(text: str) -> str:
    return quote(text, safe="-_.~")
