"""A listening socket that finishes."""

import socket
import sys

import pytest

from app.kit.handshakes import stop_handshakes

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="only Linux can be asked for it")


def test_who_waits_in_the_queue_is_served_and_no_one_else_gets_in():
    with socket.create_server(("127.0.0.1", 0)) as listening:
        address = listening.getsockname()
        with socket.create_connection(address, timeout=10) as early:
            stop_handshakes(listening)
            with pytest.raises(TimeoutError):
                socket.create_connection(address, timeout=0.2)
            early.sendall(b"are you there?")
            accepted, _ = listening.accept()
            with accepted:
                assert accepted.recv(100) == b"are you there?"
                accepted.sendall(b"yes")
                assert early.recv(100) == b"yes"
