"""Requests to addresses that people typed go to public hosts alone, and end."""

import socket

import pytest

from app.core import outgoing
from app.core.outgoing import AddressRefused, RequestFailed, ensure_address, is_public, post
from tests.support.receiver import receiver

INSIDE = (
    *("127.0.0.1", "127.9.9.9", "10.0.0.5", "172.16.0.1", "192.168.1.1", "169.254.169.254", "0.0.0.0", "100.64.0.1"),  # noqa: S104
    *("224.0.0.1", "239.255.255.250", "255.255.255.255", "240.0.0.1", "198.18.0.1", "192.0.2.7"),
    *("::1", "::", "fe80::1", "fc00::1", "fd12::7", "ff02::1", "2001:db8::1"),
    *("::ffff:127.0.0.1", "::ffff:10.0.0.5", "::ffff:93.184.215.14", "::7f00:1"),
    *("64:ff9b::a00:5", "64:ff9b:1::a00:5", "2002:a00:5::1", "2001:0:a00:5::1"),
)
OUTSIDE = ("93.184.215.14", "8.8.8.8", "2606:4700:4700::1111", "2a00:1450:4001:82a::200e")


@pytest.mark.parametrize("address", INSIDE)
def test_addresses_inside_are_not_public(address: str):
    assert not is_public(address)


@pytest.mark.parametrize("address", OUTSIDE)
def test_addresses_outside_are(address: str):
    assert is_public(address)


NO_ADDRESS = "hooks.example.com has no public address"


@pytest.mark.parametrize("address", INSIDE)
def test_a_name_that_leads_inside_is_refused_before_anything_is_sent(address: str):
    # One public address beside it does not help.
    with pytest.raises(AddressRefused, match=NO_ADDRESS):
        post("https://hooks.example.com/in", b"{}", {}, resolver=lambda _host, _port: ["93.184.215.14", address])


def test_the_words_do_not_tell_a_name_that_leads_inside_from_an_unknown_one():
    def unknown(_host: str, _port: int) -> list[str]:
        raise socket.gaierror(socket.EAI_NONAME, "Name or service not known")

    for resolver in (unknown, lambda _host, _port: [], lambda _host, _port: ["10.0.0.5"]):
        with pytest.raises(AddressRefused) as refused:
            post("https://hooks.example.com/in", b"{}", {}, resolver=resolver)
        assert str(refused.value) == NO_ADDRESS


@pytest.mark.parametrize(
    "url",
    [
        "http://hooks.example.com/in",
        "ftp://hooks.example.com/in",
        "file:///etc/passwd",
        "https://",
        "https:///in",
        "https://user:secret@hooks.example.com/in",
        "https://localhost/in",
        "https://a.localhost/in",
        "https://127.0.0.1/in",
        "https://[::1]/in",
        "https://[::ffff:10.0.0.5]/in",
        "https://10.0.0.5:8443/in",
        "https://hooks.example.com:99999/in",
        "https://hooks.example.com/a b",
        "https://hooks.example.com\\@10.0.0.5/",
        "https://hooks.example.com/\n",
        "https://höoks.example.com/in",
        "https://hooks.example.com/" + "a" * 2_000,
        "http://localhost/in",
        "",
    ],
)
def test_what_is_no_public_https_address_is_refused(url: str):
    with pytest.raises(AddressRefused):
        ensure_address(url)


def test_what_is_one_passes():
    for url in ("https://hooks.example.com/in?a=b", "https://hooks.example.com:8443/", "https://93.184.215.14/in"):
        ensure_address(url)
    ensure_address("http://localhost:8000/in", may_be_localhost=True)
    with pytest.raises(AddressRefused):
        ensure_address("http://hooks.example.com/in", may_be_localhost=True)


def test_numbers_that_a_resolver_reads_as_inside_are_refused():
    # getaddrinfo reads 2130706433, 0x7f.1 and 127.1 as 127.0.0.1.
    for host in ("2130706433", "0x7f.1", "127.1"):
        with pytest.raises((AddressRefused, RequestFailed)):
            post(f"https://{host}/in", b"{}", {})


def test_localhost_is_called_where_it_may_be_and_must_be_this_machine():
    with receiver() as server:
        answer = post(f"{server.url}/in?a=b", b'{"a": 1}', {"X-One": "1"}, may_be_localhost=True)
        assert (answer.status, answer.beginning) == (200, "taken")
        (request,) = server.received
        assert (request.path, request.body, request.headers["x-one"]) == ("/in?a=b", b'{"a": 1}', "1")
        assert request.headers["host"] == server.url.removeprefix("http://")
        with pytest.raises(AddressRefused):
            post(server.url, b"{}", {}, may_be_localhost=True, resolver=lambda *_: ["10.0.0.5"])
        with pytest.raises(AddressRefused):
            post(server.url, b"{}", {})
        assert len(server.received) == 1


def test_the_connection_goes_to_the_address_that_was_checked():
    with receiver() as server:
        port = server.url.rpartition(":")[2]
        looked_up = []

        def resolver(host: str, _port: int) -> list[str]:
            looked_up.append(host)
            return ["127.0.0.1"]

        post(f"http://localhost:{port}/in", b"{}", {}, may_be_localhost=True, resolver=resolver)
        assert looked_up == ["localhost"], "looked up once"
        assert server.received[0].headers["host"] == f"localhost:{port}"


def test_a_redirect_is_an_answer_and_is_not_followed():
    with receiver() as server:
        server.status, server.headers = 302, {"Location": f"{server.url}/elsewhere"}
        assert post(f"{server.url}/in", b"{}", {}, may_be_localhost=True).status == 302
        assert [request.path for request in server.received] == ["/in"]


def test_of_a_long_answer_the_beginning_is_read():
    with receiver() as server:
        server.answer = b"\x00\xff" + b"a" * 5_000_000
        answer = post(server.url, b"{}", {}, may_be_localhost=True)
        assert answer.beginning == "��" + "a" * (outgoing.KEPT_BYTES - 2)


def test_a_slow_answer_and_a_closed_port_are_failures(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(outgoing, "TIMEOUT_S", 0.3)
    with receiver() as server:
        server.pause_s = 1.0
        with pytest.raises(RequestFailed, match=r"no answer within 0\.3 s"):
            post(server.url, b"{}", {}, may_be_localhost=True)
        closed = server.url
    with pytest.raises(RequestFailed):
        post(closed, b"{}", {}, may_be_localhost=True)


def test_an_environment_with_a_proxy_changes_nothing(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("HTTP_PROXY", "http://10.0.0.5:3128")
    monkeypatch.setenv("ALL_PROXY", "http://10.0.0.5:3128")
    with receiver() as server:
        assert post(server.url, b"{}", {}, may_be_localhost=True).status == 200
