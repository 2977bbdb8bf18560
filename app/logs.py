"""Logging of the server's processes: one line for each event, with the ids of its request and job."""

import logging
import sys
from collections.abc import Mapping
from contextlib import AbstractContextManager
from typing import Any, TextIO

import structlog

from audio_checks import confinement_gaps

OURS = "app"  # the loggers of all modules here begin so
REQUEST_ID = "request_id"
TRACEBACK = structlog.tracebacks.ExceptionDictTransformer(show_locals=False)  # they may hold secrets
Cause = dict[str, str]  # what a job's log lines carry on from the request, or the job, that asked for it


class _Stderr(logging.StreamHandler[TextIO]):
    """Writes to the present stderr: a thread that ends late may outlive what it was when logging began."""

    def emit(self, record: logging.LogRecord) -> None:
        self.stream = sys.stderr
        super().emit(record)


def configure(level: str = "WARNING") -> None:
    """Send our own log, and the libraries' warnings, through one formatter; JSON unless a person watches."""
    shared: list[structlog.typing.Processor] = [
        structlog.contextvars.merge_contextvars,
        structlog.stdlib.add_logger_name,
        structlog.processors.add_log_level,
        structlog.processors.TimeStamper(fmt="iso", utc=True),
    ]
    is_watched = sys.stderr.isatty()
    last: list[structlog.typing.Processor] = (
        [structlog.dev.ConsoleRenderer(exception_formatter=structlog.dev.plain_traceback)]
        if is_watched
        else [structlog.processors.ExceptionRenderer(TRACEBACK), structlog.processors.JSONRenderer()]
    )
    structlog.configure(
        processors=[*shared, structlog.stdlib.ProcessorFormatter.wrap_for_formatter],
        logger_factory=structlog.stdlib.LoggerFactory(),
        wrapper_class=structlog.stdlib.BoundLogger,
        cache_logger_on_first_use=True,
    )
    handler = _Stderr()
    handler.setFormatter(
        structlog.stdlib.ProcessorFormatter(
            foreign_pre_chain=shared,
            processors=[structlog.stdlib.ProcessorFormatter.remove_processors_meta, *last],
        )
    )
    logging.basicConfig(handlers=[handler], level=max(logging.WARNING, logging.getLevelName(level)), force=True)
    logging.getLogger(OURS).setLevel(level)


def bound(cause: Mapping[str, str], **more: Any) -> AbstractContextManager[None]:
    """Give every log line of a block the ids of what it is done for."""
    return structlog.contextvars.bound_contextvars(**{**cause, **more})


def cause() -> Cause:
    """Return the cause that jobs asked for here carry on: the id of the request behind this work, if there is one."""
    request_id = structlog.contextvars.get_contextvars().get(REQUEST_ID)
    return {REQUEST_ID: request_id} if request_id else {}


def report_confinement() -> None:
    """Log powers that this kernel cannot take from the processes that read strangers' files; none where it can all."""
    for gap in confinement_gaps():
        structlog.get_logger(__name__).warning(gap)
