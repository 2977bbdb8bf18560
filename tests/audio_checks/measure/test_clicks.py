"""Which of several doubts that one click may have raised is looked at."""

from audio_checks.measure.click_rules import ALONE, IN_GLIDES, Candidate, strongest


def test_of_neighbours_the_one_that_stands_out_most():
    doubts = [(1, 12, 9.0), (0, 10, 1.3), (0, 12, 1.5), (0, 11, 1.4), (0, 15, 1.2), (0, 12, 1.1)]
    foremost = strongest([Candidate(channel, ALONE, cell, stands, 1.0) for channel, cell, stands in doubts])
    assert [(one.channel, one.cell, one.stands) for one in foremost] == [(0, 12, 1.5), (0, 15, 1.2), (1, 12, 9.0)]


def test_doubts_that_are_held_to_other_limits_are_looked_at_apart():
    doubts = [Candidate(0, ALONE, 10, 2.0, 1.0), Candidate(0, IN_GLIDES, 10, 1.4, 1.0)]
    assert sorted(strongest(doubts)) == sorted(doubts)
