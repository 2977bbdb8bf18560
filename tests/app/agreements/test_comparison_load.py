"""What a comparison of two versions costs, and that nobody waits for another's."""

import itertools
import random
import threading
from concurrent.futures import ThreadPoolExecutor, as_completed

import pytest

from app.agreements.drafts import comparison
from app.agreements.drafts.comparison import MAX_CHARS, MAX_LINES, Compared, compare
from app.agreements.drafts.differences import differences
from app.agreements.errors import TooLongToCompare
from app.core.db import new_id
from app.core.web.per_user_limit import PerUserLimit, TooManyAtOnce
from tests.attack.long_contract import add_two_long_versions, random_text
from tests.support.server import World
from tests.support.steps import at_most

LIMIT_S = 300.0  # of waiting for what would hang


@pytest.mark.parametrize("seed", range(40))
def test_stretches_are_the_whole_of_both(seed: int) -> None:
    draw = random.Random(seed)
    alphabet = draw.choice([2, 5, 30, 300])
    old = [draw.randrange(alphabet) for _ in range(draw.randrange(300))]
    new = list(old)
    for _ in range(draw.randrange(30)):
        new.insert(draw.randint(0, len(new)), draw.randrange(alphabet))
        del new[draw.randrange(len(new))]
    found = list(differences(old, new))
    assert [one for stretch in found for one in old[stretch.old_from : stretch.old_to]] == old
    assert [one for stretch in found for one in new[stretch.new_from : stretch.new_to]] == new
    for each in found:
        assert each.is_same == (old[each.old_from : each.old_to] == new[each.new_from : each.new_to])
    assert all(one.is_same != other.is_same for one, other in itertools.pairwise(found))


def test_a_few_changed_words_of_a_long_text_are_the_only_ones_shown() -> None:
    text = "\n\n".join(f"Clause {place}: the designer delivers what the studio asks for." for place in range(600))
    later = text.replace("Clause 311: the designer", "Clause 311: the composer")
    changed = [line for line in compare(text, later) if line.change != "same"]
    assert [(run.is_in, run.text) for run in changed[0].runs if run.is_in != "both"] == [
        ("earlier", "designer"),
        ("later", "composer"),
    ]
    assert len(changed) == 1


@pytest.mark.slow
@pytest.mark.parametrize(
    "between", [" ", "\n\n", " the\n\n"], ids=["one paragraph", "paragraphs", "paragraphs that end alike"]
)
@pytest.mark.parametrize(
    "some", [["a", "b"], [f"w{place}" for place in range(3_000)]], ids=["two words", "three thousand"]
)
def test_the_cost_of_the_longest_texts_does_not_grow_with_their_square(some: list[str], between: str) -> None:
    earlier, later = random_text(1, some, between), random_text(2, some, between)
    with at_most(6_000_000):  # the most that one takes is 2,200,000; the square of 50,000 words is 2,500,000,000
        compare(earlier, later)


@pytest.mark.parametrize("text", ["x" * (MAX_CHARS + 1), "a\n" * MAX_LINES], ids=["characters", "lines"])
def test_longer_ones_are_refused_in_numbers(text: str) -> None:
    with pytest.raises(TooLongToCompare, match=r"400,000|20,000"):
        comparison.ensure_comparable(text, "")


def test_one_person_has_two_at_once_and_another_has_two_more() -> None:
    share, person = PerUserLimit(2, "comparisons"), new_id()
    refused = pytest.raises(TooManyAtOnce, match="2 comparisons at once is the most")
    with share.of(person), share.of(person), share.of(new_id()), refused, share.of(person):
        pass
    with share.of(person):
        pass


@pytest.mark.slow
def test_twenty_comparisons_by_one_person_keep_no_one_else_waiting(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    contract_id = world.server.in_database(lambda session: add_two_long_versions(session, world))
    url = f"/v1/contracts/{contract_id}/comparison"
    greedy, other = world.producer, world.reviewer

    running, go_on = threading.Event(), threading.Event()

    def held(earlier: str, later: str) -> list[Compared]:
        running.set()
        assert go_on.wait(LIMIT_S)
        return compare(earlier, later)

    monkeypatch.setattr(comparison, "compare", held)
    with ThreadPoolExecutor(20) as pool:
        asked = [pool.submit(lambda: greedy.get(url, params={"from_version": 1, "to_version": 2})) for _ in range(20)]
        try:
            assert running.wait(LIMIT_S)
            refused = [one.result().status_code for one in itertools.islice(as_completed(asked, timeout=LIMIT_S), 19)]
            answers = [other.get("/v1/me").status_code for _ in range(5)]  # while the twentieth is compared
        finally:
            go_on.set()
        assert sorted(one.result().status_code for one in asked) == [200] + [429] * 19
    assert (refused, answers) == ([429] * 19, [200] * 5)
