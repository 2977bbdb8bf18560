"""How the processes of the server log: one line an event, with the ids of its request and job."""

import logging
import os
import sys
from collections.abc import Mapping
from contextlib import AbstractContextManager
from typing import Any

import structlog

REQUEST_ID = "request_id"
Cause = dict[str, str]  # what a job's log lines carry on from the request, or the job, that asked for it


def configure() -> None:
    """Send our own and the libraries' log through one formatter; JSON unless a person watches."""
    shared: list[structlog.typing.Processor] = [
        structlog.contextvars.merge_contextvars,
        structlog.stdlib.add_logger_name,
        structlog.processors.add_log_level,
        structlog.processors.TimeStamper(fmt="iso", utc=True),
    ]
    is_watched = sys.stderr.isatty()
    last: list[structlog.typing.Processor] = (
        [structlog.dev.ConsoleRenderer()]
        if is_watched
        else [structlog.processors.dict_tracebacks, structlog.processors.JSONRenderer()]
    )
    structlog.configure(
        processors=[*shared, structlog.stdlib.ProcessorFormatter.wrap_for_formatter],
        logger_factory=structlog.stdlib.LoggerFactory(),
        wrapper_class=structlog.stdlib.BoundLogger,
        cache_logger_on_first_use=True,
    )
    handler = logging.StreamHandler()
    handler.setFormatter(
        structlog.stdlib.ProcessorFormatter(
            foreign_pre_chain=shared,
            processors=[structlog.stdlib.ProcessorFormatter.remove_processors_meta, *last],
        )
    )
    logging.basicConfig(handlers=[handler], level=os.environ.get("SOUNDLIST_LOG_LEVEL", "WARNING"), force=True)


def bound(cause: Mapping[str, str], **more: Any) -> AbstractContextManager[None]:
    """Give every log line of a block the ids of what it is done for."""
    return structlog.contextvars.bound_contextvars(**{**cause, **more})


def cause() -> Cause:
    """Return what the jobs asked for here carry on: the id of the request behind this work, if there is one."""
    request_id = structlog.contextvars.get_contextvars().get(REQUEST_ID)
    return {REQUEST_ID: request_id} if request_id else {}
