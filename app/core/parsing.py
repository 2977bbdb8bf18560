"""Parsing of untrusted input: in a child process under limits, so that no input can stop the web process."""

import codecs
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any, Literal, TypeVar

import structlog

from app.core.errors import FieldProblem, Refused
from audio_checks import CODE_PAGES, Sandbox, SandboxFailed, SandboxTimedOut, ensure_declared, new_spec, parse_spec

TIMEOUT_S = 5.0
MEMORY_BYTES = 512 << 20  # of address space, of which the interpreter and what it has loaded take some 100 MiB
RESULT_BYTES = 64 << 20
FIX = "send less at once, or save it again in another format"

Result = TypeVar("Result")
log = structlog.get_logger(__name__)


class Parsers:
    """The children in which one web process parses.

    The server process from which they are forked starts with the first call, or with `start`.
    """

    def __init__(self) -> None:
        self._modules: Sequence[str] = ()

    def connect(self, modules: Sequence[str]) -> None:
        """Set the modules that the server process loads; call before the first parse."""
        self._modules = modules

    @cached_property
    def _sandbox(self) -> Sandbox:
        return Sandbox(
            timeout_s=TIMEOUT_S,
            memory_bytes=MEMORY_BYTES,
            file_bytes=0,
            result_bytes=RESULT_BYTES,
            preload=(__name__, *self._modules),
            rehearsal=preload,
        )

    def start(self) -> None:
        """Start the server process, so that no request has to wait for it."""
        self._sandbox.call(preload)

    def call(self, function: Callable[..., Result], *args: Any, refusal: type[Refused]) -> Result:
        """Run a function in a child and return its result; raise `refusal` if it refuses or gives no answer.

        The function is one that can be imported by name, takes and returns plain values, and refuses by a Refused. It
        declares what it returns: any other type is rejected.
        """
        try:
            answer = self._sandbox.call(_answer, function, args)
            if answer[0] == "value":
                ensure_declared(answer[1], function)
        except SandboxTimedOut:
            message = f"this takes longer than {TIMEOUT_S:g} s to read; nothing was saved"
            raise refusal(message, fix=FIX) from None
        except SandboxFailed as error:  # a library that is out of memory may crash too
            log.warning("a parser failed", function=function.__qualname__, error=str(error))
            message = f"this is damaged, or takes more than {MEMORY_BYTES >> 20} MiB to read; nothing was saved"
            raise refusal(message, fix=FIX) from None
        match answer:
            case ("value", value):
                return value  # type: ignore[no-any-return]
            case ("refused", message, errors, fix):
                raise refusal(message, errors=errors, fix=fix)

    def close(self) -> None:
        """End the server process and its children."""
        self._sandbox.close()


def preload() -> None:
    """Import modules that are otherwise loaded on first use."""
    parse_spec(new_spec())
    for name in ("ascii", *CODE_PAGES.values()):
        codecs.lookup(name)


def _answer(
    function: Callable[..., Any], args: Sequence[Any]
) -> tuple[Literal["value"], Any] | tuple[Literal["refused"], str, list[FieldProblem], str | None]:
    """Run in the child."""
    try:
        return "value", function(*args)
    except Refused as refused:
        return "refused", refused.message, refused.errors, refused.fix
