"""Lets a listening socket finish: it takes no further connection, and loses none that it has taken."""

import ctypes
import socket
import struct
import sys

SO_ATTACH_FILTER = 26  # asm-generic/socket.h; Python has no name for it
# Classic BPF over the TCP header, as (code, jump if true, jump if false, operand): byte 13 has the flags, 0x02 is SYN.
_ALL_BUT_SYN = ((0x30, 0, 0, 13), (0x45, 0, 1, 0x02), (0x06, 0, 0, 0), (0x06, 0, 0, 0xFFFF_FFFF))


def stop_handshakes(listening: socket.socket) -> None:
    """Have the kernel drop requests for a connection, so that the accept queue runs empty.

    A closing socket resets the connections in its queue, though they may carry a request already. A request for
    a connection that was dropped is sent again after a second, and refused then. Only Linux supports this.
    """
    if not sys.platform.startswith("linux"):
        return
    program = ctypes.create_string_buffer(b"".join(struct.pack("HBBI", *step) for step in _ALL_BUT_SYN))
    pointer = struct.pack("HP", len(_ALL_BUT_SYN), ctypes.addressof(program))
    listening.setsockopt(socket.SOL_SOCKET, SO_ATTACH_FILTER, pointer)
