"""The search for the demo's designer: a posting, two bids on it, the team's scores, and the award."""

from collections.abc import Callable, Sequence
from datetime import timedelta
from typing import Any

from app.core import clock
from app.demo.visitors import Visitor

TITLE = "Effects"
TEXT = "Every effect of the game but music, for headphones and small speakers. Six palette sounds first."
BUDGET_MINOR = 800_000
ADDRESSES = ("sound.designer@soundlist.example", "second.designer@soundlist.example")
# Of each bid, in the order of the designers: the price of a cue, the hours, and what is said with it.
OFFERS = (
    (30_000, 14_400, "I have worked on two games in space, and hear this one in the low mids."),
    (35_000, 12_000, "All recorded again in my hall; I would begin in January."),
)
# Of each bid, in the order of the designers: what a person gives it under every heading, and a note.
SCORES = {
    "producer": ((4, "Answers within a day."), (3, "Over the budget.")),
    "approver": ((5, "The closest to the palette in my head."), (4, "Fine recordings, a little polite.")),
}
CALL = "Twenty minutes. Asked about the footsteps at once; begins on Monday."


def link_to(producer: Visitor, studio_id: str, address: str, kind: str) -> str | None:
    """Return the newest link of a kind, such as "/posting/", that was mailed to an address."""
    mails = producer.ask("GET", f"/studios/{studio_id}/outbox")["mails"]
    links = (mail["link"] for mail in mails if mail["recipient"] == address)
    return next((link for link in links if link and kind in link), None)


class Hiring:
    """Goes through a posting by the same requests as the people's clicks."""

    def __init__(
        self,
        producer: Visitor,
        approver: Visitor,
        studio_id: str,
        project_id: str,
        wait_for: Callable[[Callable[[], Any]], Any],
    ) -> None:
        self._producer = producer
        self._approver = approver
        self._studio_id = studio_id
        self._project_id = project_id
        self._await = wait_for

    def award(self, chosen: Visitor, designers: Sequence[Visitor]) -> str:
        """Have designers bid on the whole list, award it to one of them, and return the draft contract."""
        posting = self._posting()
        if posting["contract_id"]:
            return str(posting["contract_id"])
        for at, (designer, address) in enumerate(zip(designers, ADDRESSES, strict=True)):
            self._invite(posting["id"], address)
            self._bid(posting, designer, address, at)
        bids = self._producer.ask("GET", f"/postings/{posting['id']}/bids")
        by_price = sorted(bids["bids"], key=lambda bid: bid["total_minor"])  # the order of OFFERS
        for at, bid in enumerate(by_price):
            self._score(bid["id"], bids["headings"], at)
        self._note_call(by_price[0])
        bid_id = by_price[designers.index(chosen)]["id"]
        self._producer.ask("PUT", f"/bids/{bid_id}/shortlist", json={"is_shortlisted": True})
        awarded = self._producer.ask("POST", f"/bids/{bid_id}/award")
        return str(awarded["contract_id"])

    def _posting(self) -> dict[str, Any]:
        today = clock.now().date()
        body = {
            "title": TITLE,
            "text": TEXT,
            "currency": "USD",
            "budget_minor": BUDGET_MINOR,
            "is_budget_shown": True,
            "bids_until_on": (today + timedelta(days=14)).isoformat(),
            "work_from_on": today.isoformat(),
            "work_to_on": (today + timedelta(days=90)).isoformat(),
        }
        path = f"/projects/{self._project_id}/postings"
        made = next(iter(self._producer.ask("GET", path)), None) or self._producer.ask("POST", path, json=body)
        posting: dict[str, Any] = self._producer.ask("GET", f"/postings/{made['id']}")
        if posting["state"] == "draft":
            posting = self._producer.ask("POST", f"/postings/{made['id']}/open")
        return posting

    def _invite(self, posting_id: str, address: str) -> None:
        path = f"/postings/{posting_id}"
        if address not in {candidate["email"] for candidate in self._producer.ask("GET", path)["candidates"]}:
            self._producer.ask("POST", f"{path}/candidates", json={"email": address})

    def _bid(self, posting: dict[str, Any], designer: Visitor, address: str, at: int) -> None:
        link = self._await(lambda: link_to(self._producer, self._studio_id, address, "/posting/"))
        designer.ask("POST", f"/posting-links/{link.rsplit('/', 1)[1]}/join")
        path = f"/postings/{posting['id']}"
        own_bid = designer.ask("GET", path)["own_bid"]
        if own_bid and own_bid["state"] == "sent":
            return
        price_minor, hours_hundredths, note = OFFERS[at]
        lines = [
            {
                "key": line["key"],
                "kind": "asked",
                "unit": "per_cue",
                "quantity_hundredths": 100 * line["cues"],
                "price_minor": price_minor,
            }
            for line in posting["lines"]
        ]
        content = {
            "lines": lines,
            "hours_hundredths": hours_hundredths,
            "from_on": posting["work_from_on"],
            "to_on": posting["work_to_on"],
            "note": note,
            "revision": own_bid["revision"] if own_bid else 0,
        }
        saved = designer.ask("PUT", f"{path}/bid", json=content)["own_bid"]
        designer.ask("POST", f"{path}/bid/send", json={"revision": saved["revision"]})

    def _note_call(self, bid: dict[str, Any]) -> None:
        if not bid["notes"]:
            body = {"kind": "call", "held_on": clock.now().date().isoformat(), "text": CALL}
            self._producer.ask("POST", f"/bids/{bid['id']}/notes", json=body)

    def _score(self, bid_id: str, headings: Sequence[str], at: int) -> None:
        for visitor, given in ((self._producer, SCORES["producer"]), (self._approver, SCORES["approver"])):
            score, note = given[at]
            body = {"scores": dict.fromkeys(headings, score), "note": note}
            visitor.ask("PUT", f"/bids/{bid_id}/scores", json=body)
