import pytest

from benchmarks.faults.masters import MOST, NAMED, flagged_masters, masters_folder
from benchmarks.faults.trial import CHECKS

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def flagged() -> dict[str, set[str]]:
    folder = masters_folder()
    if folder is None or not folder.is_dir():
        pytest.skip("SOUNDS_DIR does not name a folder with masters/ in it")
    count, flagged = flagged_masters(folder)
    assert count >= 72, f"{folder} holds {count} masters; 72 are wanted"
    return flagged


@pytest.mark.parametrize("check", CHECKS)
def test_few_real_masters_are_flagged_and_each_is_named(flagged: dict[str, set[str]], check: str) -> None:
    assert len(flagged[check]) <= MOST
    assert flagged[check] == set(NAMED[check])
