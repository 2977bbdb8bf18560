"""The PDF of a signed contract is sealed, and any changed byte of it is found."""

import io
import random
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import timedelta
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa
from asn1crypto import keys, tsp
from asn1crypto import x509 as asn1_x509
from cryptography import x509
from cryptography.hazmat.primitives import hashes
from cryptography.hazmat.primitives.asymmetric import ec, rsa
from cryptography.hazmat.primitives.serialization import Encoding, NoEncryption, PrivateFormat
from pyhanko.pdf_utils.reader import PdfFileReader
from pyhanko.sign.timestamps import DummyTimeStamper
from pypdf import PdfReader
from typer.testing import CliRunner

from app.agreements.models import Seal
from app.agreements.signing import seal_files, seals
from app.agreements.signing.seal_files import read_seal
from app.cli import cli, keeping
from app.core import clock
from tests.app.agreements.conftest import Contracts
from tests.support.server import World

FLIPS, FLIPS_READ = 2_000, 60


@pytest.fixture
def agreed(world: World, contracts: Contracts) -> dict[str, Any]:
    signed = contracts.agree(contracts.begin())
    world.server.wait_for_jobs()
    return signed


@pytest.fixture
def sealed(world: World, contracts: Contracts, agreed: dict[str, Any]) -> bytes:
    world.server.forget_tries()
    pdf: bytes = contracts.ask(world.designer, "GET", f"/contracts/{agreed['id']}/versions/1/contract.pdf")
    return pdf


def verify(world: World, pdf: bytes) -> dict[str, Any]:
    answer = world.nobody.post("/v1/verify", content=pdf, headers={"Content-Type": "application/pdf"})
    assert answer.status_code == 200, answer.text
    said: dict[str, Any] = answer.json()
    return said


def words_of(pdf: bytes) -> str:
    return " ".join(" ".join(page.extract_text() for page in PdfReader(io.BytesIO(pdf)).pages).split())


@pytest.mark.slow
def test_once_all_have_signed_downloads_are_sealed(
    world: World, contracts: Contracts, agreed: dict[str, Any], sealed: bytes
) -> None:
    as_sent = contracts.ask(world.designer, "GET", f"/contracts/{agreed['id']}/versions/1/contract.pdf?as_sent=true")
    assert not read_seal(as_sent).is_sealed
    read = read_seal(sealed)
    assert (read.is_sealed, read.is_intact, read.covers_file) == (True, True, True)
    assert b"pdfaid" in sealed  # archival: PDF/A says so in its metadata
    words = words_of(sealed)
    assert words_of(as_sent).split("SHA-256 of the text")[0] in words
    for said in (
        "Certificate of signing",
        agreed["version"]["text_sha256"],
        "N. Designer, for the designer",
        "P. Producer, for the studio",
        f"{world.designer_id}@example.test, not proven",
        "none was asked for",
        "UTC",
        "Ed25519",
    ):
        assert said.replace(" ", "") in words.replace(" ", ""), said


@pytest.mark.slow
def test_the_page_says_what_an_untouched_file_binds(world: World, agreed: dict[str, Any], sealed: bytes) -> None:
    said = verify(world, sealed)
    assert said["verdict"] == "untouched"
    binds = said["binds"]
    assert (binds["title"], binds["version"]) == (agreed["title"], 1)
    assert binds["text_sha256"] == agreed["version"]["text_sha256"]
    assert (binds["studio_name"], binds["designer_name"]) == ("Test studio", "Sound designer")
    assert [(bind["party"], bind["name"]) for bind in binds["signatures"]] == [
        ("designer", "N. Designer"),
        ("studio", "P. Producer"),
    ]


def flipped(pdf: bytes, place: int, bit: int) -> bytes:
    changed = bytearray(pdf)
    changed[place] ^= 1 << bit
    return bytes(changed)


@pytest.mark.slow
def test_each_of_two_thousand_changed_bytes_is_found(world: World, sealed: bytes) -> None:
    chance = random.Random(24)

    def verdicts(session: Any) -> set[seals.Verdict]:
        files = (flipped(sealed, chance.randrange(len(sealed)), chance.randrange(8)) for _ in range(FLIPS))
        return {seals.verify(session, file, "").verdict for file in files}

    assert world.server.in_database(verdicts) == {seals.Verdict.CHANGED}


@pytest.mark.slow
def test_a_changed_file_is_known_by_its_key_where_nothing_else_names_it(world: World, sealed: bytes) -> None:
    unnamed = sealed.replace(b"soundlist-seal:", b"soundlist-leas:")
    assert unnamed != sealed
    assert verify(world, unnamed)["verdict"] == "changed"


@pytest.mark.slow
def test_by_the_seal_alone_each_change_under_it_is_found(sealed: bytes) -> None:
    begins = sealed.index(b"/Contents <") + len(b"/Contents ")
    ends = sealed.index(b">", begins) + 1
    chance = random.Random(26)
    under = [
        place for place in (chance.randrange(len(sealed)) for _ in range(FLIPS_READ)) if not begins <= place < ends
    ]
    for place in under:
        read = read_seal(flipped(sealed, place, chance.randrange(8)))
        assert not (read.is_sealed and read.is_intact and read.covers_file), place
    longer = read_seal(sealed + b"\n% more")
    assert not (longer.is_intact and longer.covers_file)


@pytest.mark.slow
def test_a_byte_that_no_seal_covers_is_found_by_the_server(world: World, sealed: bytes) -> None:
    ends = sealed.index(b">", sealed.index(b"/Contents <"))
    padded = flipped(sealed, ends - 1, 0)  # of the zeros that fill the place of the seal
    assert read_seal(padded).is_intact
    assert verify(world, padded)["verdict"] == "changed"


@pytest.mark.parametrize("content", [b"", b"no PDF at all", b"%PDF-1.7\n%%EOF", b"%PDF-1.7\n" + b"[" * 100_000])
def test_other_files_are_not_ours(world: World, content: bytes) -> None:
    world.server.forget_tries()
    said = verify(world, content)
    assert (said["verdict"], said["binds"]) == ("not_ours", None)


@pytest.mark.slow
def test_a_seal_by_another_key_is_not_ours(world: World, contracts: Contracts, agreed: dict[str, Any]) -> None:
    as_sent = contracts.ask(world.designer, "GET", f"/contracts/{agreed['id']}/versions/1/contract.pdf?as_sent=true")
    other = seal_files.seal(as_sent, seal_files.own_signer("another server"), mark="soundlist-seal:", timestamp_url="")
    assert read_seal(other.content).is_intact
    assert verify(world, other.content)["verdict"] == "not_ours"


def test_a_file_that_is_too_large_is_refused(world: World) -> None:
    world.server.forget_tries()
    assert world.nobody.post("/v1/verify", content=b"0" * ((8 << 20) + 1)).status_code == 413


@pytest.mark.slow
def test_files_are_verified_a_few_times_at_once(world: World) -> None:
    world.server.forget_tries()
    codes = [world.nobody.post("/v1/verify", content=b"no PDF").status_code for _ in range(31)]
    assert codes == [200] * 30 + [429]
    world.server.forget_tries()


@pytest.fixture
def given(world: World, tmp_path: Path) -> Iterator[str]:
    """A certificate and key of the operator; the hash of its public key."""
    key = ec.generate_private_key(ec.SECP256R1())
    name = x509.Name([x509.NameAttribute(x509.NameOID.COMMON_NAME, "Operator")])
    certificate = (
        x509.CertificateBuilder()
        .subject_name(name)
        .issuer_name(name)
        .public_key(key.public_key())
        .serial_number(7)
        .not_valid_before(clock.now() - timedelta(days=365))
        .not_valid_after(clock.now() + timedelta(days=3650))
        .sign(key, hashes.SHA256())
    )
    settings = world.server.runtime.settings
    settings.seal_certificate, settings.seal_key = tmp_path / "seal.pem", tmp_path / "key.pem"
    settings.seal_certificate.write_bytes(certificate.public_bytes(Encoding.PEM))
    settings.seal_key.write_bytes(key.private_bytes(Encoding.PEM, PrivateFormat.PKCS8, NoEncryption()))
    yield "given"
    settings.seal_certificate = settings.seal_key = None


@pytest.mark.slow
def test_the_operators_certificate_seals_where_one_is_set(world: World, contracts: Contracts, given: str) -> None:
    own = read_seal_of(world, contracts)
    settings = world.server.runtime.settings
    settings.seal_certificate = settings.seal_key = None
    assert own.is_intact
    assert own.key_sha256 != read_seal_of(world, contracts).key_sha256


def read_seal_of(world: World, contracts: Contracts) -> seal_files.SealRead:
    signed = contracts.agree(contracts.begin())
    world.server.wait_for_jobs()
    return read_seal(contracts.ask(world.designer, "GET", f"/contracts/{signed['id']}/versions/1/contract.pdf"))


@pytest.mark.slow
def test_a_name_in_letters_that_the_fonts_lack_is_sealed_all_the_same(world: World, contracts: Contracts) -> None:
    sent = contracts.send(contracts.begin())
    contracts.accept(sent, world.designer, "ᠮᠣᠩᠭᠣᠯ")  # Mongolian script
    contracts.accept(sent, world.producer, "P. Producer")
    world.server.wait_for_jobs()
    pdf = contracts.ask(world.designer, "GET", f"/contracts/{sent['id']}/versions/1/contract.pdf")
    assert read_seal(pdf).is_intact
    assert "This PDF has no font made for Mongolian" in words_of(pdf)


def on_command_line(monkeypatch: pytest.MonkeyPatch, world: World, *args: str) -> Any:
    monkeypatch.setattr(keeping, "read_settings_or_exit", lambda: world.server.runtime.settings)
    return CliRunner().invoke(cli, ["verify", *args])


@pytest.mark.slow
def test_the_command_reports_on_a_pdf(
    world: World, sealed: bytes, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "contract.pdf"
    path.write_bytes(sealed)
    said = on_command_line(monkeypatch, world, str(path)).output
    assert f"{path}: untouched. Effects for Alpha, version 1 between Test studio and Sound designer" in said
    assert on_command_line(monkeypatch, world, "--offline", str(path)).exit_code == 0
    path.write_bytes(flipped(sealed, 3_000, 0))
    result = on_command_line(monkeypatch, world, str(path))
    assert (result.exit_code, f"{path}: it is not the file that was sealed here" in result.output) == (1, True)
    result = on_command_line(monkeypatch, world, "--offline", str(path))
    assert (result.exit_code, f"{path}: it was changed after it was sealed on" in result.output) == (1, True)
    path.write_bytes(b"%PDF-1.7")
    assert "it was not sealed by this server" in on_command_line(monkeypatch, world, str(path)).output
    assert "it has no seal" in on_command_line(monkeypatch, world, "--offline", str(path)).output


@pytest.mark.slow
def test_a_seal_whose_file_was_swapped_is_named(
    world: World, agreed: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    of_it = Seal.contract_id == UUID(agreed["id"])
    swapped = sa.update(Seal).where(of_it).values(file_sha256="0" * 64)
    world.server.in_database(lambda session: session.execute(swapped))
    said = on_command_line(monkeypatch, world).output
    assert f"the sealed PDF {'0' * 64} is not in the store" in said


@contextmanager
def timestamp_server() -> Iterator[str]:
    """Serve RFC 3161 timestamps, and yield the address."""
    key = rsa.generate_private_key(65_537, 2_048)
    name = x509.Name([x509.NameAttribute(x509.NameOID.COMMON_NAME, "Timestamps")])
    certificate = (
        x509.CertificateBuilder()
        .subject_name(name)
        .issuer_name(name)
        .public_key(key.public_key())
        .serial_number(9)
        .not_valid_before(clock.now() - timedelta(days=365))
        .not_valid_after(clock.now() + timedelta(days=3650))
        .add_extension(x509.ExtendedKeyUsage([x509.ExtendedKeyUsageOID.TIME_STAMPING]), critical=True)
        .sign(key, hashes.SHA256())
    )
    stamper = DummyTimeStamper(
        tsa_cert=asn1_x509.Certificate.load(certificate.public_bytes(Encoding.DER)),
        tsa_key=keys.PrivateKeyInfo.load(key.private_bytes(Encoding.DER, PrivateFormat.PKCS8, NoEncryption())),
    )

    class Stamping(BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            asked = tsp.TimeStampReq.load(self.rfile.read(int(self.headers["Content-Length"])))
            answer = stamper.request_tsa_response(asked).dump()
            self.send_response(200)
            self.send_header("Content-Type", "application/timestamp-reply")
            self.send_header("Content-Length", str(len(answer)))
            self.end_headers()
            self.wfile.write(answer)

    with ThreadingHTTPServer(("127.0.0.1", 0), Stamping) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()


@pytest.mark.slow
def test_a_timestamp_server_dates_the_seal_where_one_is_set(world: World, contracts: Contracts) -> None:
    settings = world.server.runtime.settings
    with timestamp_server() as address:
        settings.timestamp_url = address
        try:
            signed = contracts.agree(contracts.begin())
            world.server.wait_for_jobs()
        finally:
            settings.timestamp_url = ""
    pdf = contracts.ask(world.designer, "GET", f"/contracts/{signed['id']}/versions/1/contract.pdf")
    (signature,) = PdfFileReader(io.BytesIO(pdf)).embedded_signatures
    assert [one["type"].native for one in signature.signer_info["unsigned_attrs"]] == ["signature_time_stamp_token"]
    world.server.forget_tries()
    assert verify(world, pdf)["binds"]["is_timestamped"] is True
