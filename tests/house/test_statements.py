"""Which tests run on PostgreSQL: together they send all that the tests on SQLite send."""

from pathlib import Path

import pytest
import sqlalchemy as sa
from hypothesis import given
from hypothesis import strategies as st

from tests.support.statements import Recorder, fewest, recorded

SENT = st.dictionaries(st.text("abc", min_size=1), st.sets(st.integers(0, 12)), max_size=9)


@pytest.mark.slow
@given(SENT, st.sets(st.text("abc", min_size=1), max_size=3))
def test_everything_is_sent_and_no_test_is_chosen_for_nothing(sent: dict[str, set[int]], always: set[str]):
    chosen = fewest(sent, always)
    everything = set().union(*sent.values())
    assert set().union(*(sent[test] for test in chosen)) == everything
    assert len(chosen - always) <= len(everything)
    assert always & sent.keys() <= chosen


def test_the_one_that_sends_most_is_enough():
    assert fewest({"little": {"a"}, "most": {"a", "b"}, "as much": {"b"}}) == {"most"}


def test_a_statement_is_one_whatever_its_values_and_rows_and_a_request_whatever_its_ids(tmp_path: Path):
    recorder = Recorder(tmp_path / "alone.jsonl")
    engine = sa.create_engine("sqlite://")
    recorder.watch(engine)
    wanted = sa.select(sa.column("x")).select_from(sa.text("(select 1 as x)"))
    with engine.connect() as connection:
        for numbers in ([1], [1, 2, 3]):
            connection.execute(wanted.where(sa.column("x").in_(numbers)))
        connection.execute(wanted.where(sa.column("x") == 1))
    for name in ("019f0c9e-2b6a-7cc1-8f1e-2f6a3b1c0d9e", "laser_fire.wav"):
        recorder.note_request("designer", "GET", f"/v1/sound-lists/{name}/cues")

    assert len(recorder.sent) == 3
    assert "designer: GET /v1/sound-lists/…/cues" in recorder.sent
    recorder.write("test_x")
    assert recorded(tmp_path) == {"test_x": recorder.sent}
