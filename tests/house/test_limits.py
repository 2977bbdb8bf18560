"""The limits in docs/reference/limits.md are those in the code."""

import re
from datetime import timedelta
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from app.accounts.quotas.service import DEFAULTS, QuotaKind
from app.accounts.rate_limits import Limit
from app.settings import Settings

pytestmark = pytest.mark.lint

TEXT = (Path(__file__).resolve().parents[2] / "docs/reference/limits.md").read_text()
TABLE = TEXT.partition("\n## ")[0]
ROWS = re.findall(r"^\| ([^|]+) \| ([^|]+) \| `([\w.]+)` \|$", TABLE, re.MULTILINE)
UNITS = {"KiB": 1 << 10, "MiB": 1 << 20, "GiB": 1 << 30, "minutes": 60, "hours": 3600, "days": 86_400}
RATE = re.compile(r"([\d,]+) at once, then one every ([\d,]+) s")


def in_code(constant: str) -> Any:
    place, _, name = constant.rpartition(".")
    if place == "app.settings.Settings":
        return Settings.model_fields[name].default
    if place == "app.accounts.quotas.service.DEFAULTS":
        return DEFAULTS[QuotaKind(name)]
    value = getattr(import_module(place), name)
    if isinstance(value, Limit):
        return value.burst, value.interval_s
    return value.total_seconds() if isinstance(value, timedelta) else value


def in_words(limit: str) -> tuple[float, float] | float:
    """Return what a cell says: tries at once and seconds between more, or a number in bytes, seconds or pieces."""
    if rate := RATE.fullmatch(limit):
        return _number(rate[1]), _number(rate[2])
    number, _, unit = limit.partition(" ")
    return _number(number) * UNITS.get(unit, 1)


def _number(text: str) -> float:
    return float(text.replace(",", ""))


def test_every_row_is_read():
    rows = [line for line in TABLE.splitlines() if line.startswith("| ") and not line.startswith("| what |")]
    assert len(ROWS) == len(rows) > 20


@pytest.mark.parametrize(("limit", "constant"), [(limit, constant) for _, limit, constant in ROWS])
def test_the_table_says_what_the_code_does(limit: str, constant: str):
    assert in_words(limit) == in_code(constant)


def test_every_rate_is_in_the_table():
    module = import_module("app.accounts.rate_limits")
    rates = {f"{module.__name__}.{name}" for name, value in vars(module).items() if isinstance(value, Limit)}
    assert rates <= {constant for _, _, constant in ROWS}


def test_every_quota_is_in_the_table():
    assert {f"app.accounts.quotas.service.DEFAULTS.{kind}" for kind in DEFAULTS} <= {
        constant for _, _, constant in ROWS
    }


def test_nothing_is_in_the_table_twice():
    constants = [constant for _, _, constant in ROWS]
    assert sorted(set(constants)) == sorted(constants)
