"""The page of jobs says what each does, not the name of its function."""

import importlib
import re
from pathlib import Path

import pytest

from app import registry, worker  # noqa: F401  the worker's own jobs
from app.core.jobs.queue import job_names

pytestmark = pytest.mark.lint

WORDS = Path(__file__).parents[2] / "frontend/src/features/operations/words.ts"


def test_the_page_has_words_for_no_job_that_is_gone() -> None:
    rooms = registry.rooms_in_use(is_commercial=True)
    for module in rooms.job_modules:
        importlib.import_module(module)
    worded = set(re.findall(r"^  '(\w+\.\w+)':", WORDS.read_text(encoding="utf-8"), re.MULTILINE))
    assert worded >= set(rooms.chores)
    assert worded - job_names() == set()
