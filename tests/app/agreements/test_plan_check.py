"""What the check of a payment plan says, one warning at a time."""

from datetime import date, timedelta

import pytest

from app.agreements.plan.validation import PlannedPayment, check_plan, resolved, worsened

FIRST = date(2027, 3, 1)


def plan(deposit: int, *amounts: int) -> list[PlannedPayment]:
    names = ("Palette", "Alpha", "Beta", "Gold")
    milestones = [
        PlannedPayment(name, amount, FIRST + timedelta(weeks=4 * place), cues=6)
        for place, (name, amount) in enumerate(zip(names, amounts, strict=False))
    ]
    return [PlannedPayment("Deposit", deposit, None, cues=0, is_deposit=True), *milestones]


@pytest.mark.parametrize(
    ("payments", "codes"),
    [
        (plan(144_000, 144_000, 180_000, 252_000), []),
        (plan(144_001, 144_000, 180_000, 252_000), []),
        (plan(143_999, 144_000, 180_000, 252_000), ["deposit-low"]),
        (plan(500, 100, 150, 250), []),  # half is the upper end
        (plan(502, 100, 150, 250), ["deposit-high"]),
        (plan(144_000, 180_000, 144_000, 252_000), ["not-rising"]),
        (plan(144_000, 144_000, 216_000, 215_999), ["not-rising", "completion-not-largest"]),
        (plan(200, 300, 301), ["too-much-held-back"]),
        (plan(200, 300, 300), []),
        (plan(200, 600), ["one-milestone"]),
        ([*plan(200), PlannedPayment("Alpha", 600, FIRST, cues=1)], []),  # one cue cannot be parted
        ([], []),
    ],
)
def test_warnings(payments, codes):
    assert [advice.code for advice in check_plan(payments, "USD")] == codes


def test_the_band_can_be_agreed_otherwise():
    payments = plan(300, 200, 300, 500)
    assert [advice.code for advice in check_plan(payments, "USD", holdback_bp=4_900)] == ["too-much-held-back"]


def test_dates_and_cues():
    same_day = [
        PlannedPayment("Alpha", 100, FIRST, cues=3),
        PlannedPayment("Beta", 100, FIRST, cues=0),
        PlannedPayment("Gold", 100, None, cues=3),
    ]
    codes = [advice.code for advice in check_plan(same_day, "USD")]
    assert codes == ["deposit-low", "dates-not-rising", "no-date", "no-cues"]


def test_advice_names_figures_and_a_reason():
    (advice,) = check_plan(plan(144_000, 180_000, 144_000, 252_000), "USD")
    assert advice.message == "Alpha pays USD 1,440.00, less than Palette with USD 1,800.00."
    assert advice.why


def test_plans_are_compared_by_rule_and_subject() -> None:
    bad = check_plan(plan(100, 400, 300, 200), "USD")
    worse = check_plan(plan(100, 400, 300, 300), "USD")  # the deposit falls, and the last milestone rises
    assert [one.code for one in bad] == ["deposit-low", "not-rising", "not-rising", "completion-not-largest"]
    assert [one.code for one in worsened(bad, worse)] == ["deposit-low"]
    assert [(one.code, one.subject) for one in resolved(bad, worse)] == [("not-rising", "Beta")]
    assert worsened(bad, bad) == resolved(bad, bad) == []
