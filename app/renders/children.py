"""Children of the sandbox that draw and render, and how a call in one is tried again."""

from collections.abc import Callable, Iterable
from functools import cache
from pathlib import Path
from typing import TypeVar

import structlog

from app.conformance.workspaces import SandboxPool
from app.renders import drawing
from audio_checks import (
    Sandbox,
    SandboxFailed,
)

log = structlog.get_logger(__name__)
R = TypeVar("R")
TRIES = 3
TIMEOUT_S = 300.0
MEMORY_BYTES = 1 << 30


@cache
def sandbox() -> Sandbox:
    """Return the sandbox of what draws and renders."""
    return Sandbox(timeout_s=TIMEOUT_S, memory_bytes=MEMORY_BYTES, rehearsal=drawing.preload)


@cache
def children() -> SandboxPool:
    """Return the pool of its children, which go from take to take of one delivery."""
    return SandboxPool(sandbox())


def in_child(
    sandbox: Sandbox,
    reads: Iterable[Path],
    writes: Iterable[Path],
    function: Callable[..., R],
    *args: object,
    **options: object,
) -> Callable[[], R]:
    """Return a call of a function in a child that reaches these files and no others."""

    def call() -> R:
        with sandbox.child(reads=reads, writes=writes) as child:
            return child.call(function, *args, **options)

    return call


def retried(call: Callable[[], R]) -> R:
    """Return the result of a sandboxed call, tried again when its child fails; the last failure is raised."""
    for _ in range(TRIES - 1):
        try:
            return call()
        except SandboxFailed as error:
            log.warning("a sandboxed call failed", error=str(error))
    return call()
