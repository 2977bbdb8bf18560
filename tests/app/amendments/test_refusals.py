"""Every refusal of agreements, amendments and money names an act that works, or says that it is final.

Each is brought about over HTTP, its text is read, and what it advises is done. A refusal without an entry fails.
"""

import pytest

from tests.app.amendments import (  # noqa: F401  each registers its scenes
    amendment_refusal_scenes,
    contract_refusal_scenes,
    file_refusal_scenes,
    invoice_refusal_scenes,
    money_refusal_scenes,
    signing_refusal_scenes,
    text_refusal_scenes,
)
from tests.app.amendments.refusal_parties import SCENES, Parties
from tests.app.amendments.refusal_sites import refusal_sites
from tests.support.server import World

pytestmark = pytest.mark.slow

# Refusals of a text too long to compare, of a kept head, and of joint work; their own tests bring them about.
OF_CONTENT = ("agreements.drafts.comparison.", "agreements.record.signed_checkpoints.", "agreements.joint.")
OTHERS = {
    "agreements.clauses.facts.ensure_open_answers_are_said BriefOpen": "test_open_answers",
    "agreements.redlines.service.answer BadRedlines 2": "test_redlines",
    "agreements.clauses.text_faults.ensure_text_whole BadDraft": "test_redlines",
    "agreements.drafts.lifecycle._ensure_amounts_entered AmountsNeeded": "test_currency",
    "agreements.rules.ensure_another_person SamePersonOnBothSides": "test_both_sides",
    "agreements.rules.ensure_address_proven AddressNotProven": "test_signing",
    "agreements.access.contract_for_producer SamePersonOnBothSides": "test_both_sides",
    "agreements.signing.service.end_signers_of_member HandOverNeeded": "test_leaving",
    "money.own_time.service.log_own_time WorkNotNamed": "test_own_time",
    "agreements.drafts.lifecycle._send DraftChanged": "a race while the PDF is drawn: the text is read again and sent",
}


def is_elsewhere(site: str) -> bool:
    return site in OTHERS or site.startswith(OF_CONTENT)


def test_every_refusal_has_an_entry() -> None:
    sites = refusal_sites()
    assert [site for site in sites if site not in SCENES and not is_elsewhere(site)] == []
    assert SCENES.keys() | OTHERS.keys() <= set(sites), "an entry for a refusal that is gone"


PLAYED = {play: sorted(site for site in SCENES if SCENES[site] is play) for play in SCENES.values()}


@pytest.mark.parametrize("play", PLAYED, ids=lambda play: play.__name__.strip("_"))
def test_its_advice_is_accepted(world: World, play) -> None:
    play(Parties(world))
