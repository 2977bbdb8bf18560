"""Whoever looks at the jobs reads what each does, not how its function is called."""

import importlib
import re
from pathlib import Path

from app import rooms, worker
from app.kit.queue import job_names

WORDS = Path(__file__).parents[2] / "frontend/src/features/operations/words.ts"


def test_the_page_has_words_for_every_job_there_is() -> None:
    for module in rooms.JOB_MODULES:
        importlib.import_module(module)
    ours = {name for name in job_names() if not name.partition(".")[0].endswith("tests")}
    assert set(worker.CHORES) < ours
    worded = set(re.findall(r"^  '(\w+\.\w+)':", WORDS.read_text(encoding="utf-8"), re.MULTILINE))
    assert ours - worded == set(), f"say in {WORDS.name} what these do"
    assert worded - ours == set(), f"{WORDS.name} has words for jobs that there are no more"
