"""The roster over HTTP: kept, searched, imported, availability, who sees what, and asking for a bid."""

import base64
from datetime import timedelta
from typing import Any

import pytest
from httpx import Response
from httpx2 import Client

from app.accounts.models import Person
from app.accounts.quotas.service import QuotaKind, set_limit
from app.accounts.rules import AddressProof
from app.core import clock
from tests.app.hiring.test_bids import WHOLE, compared, send
from tests.app.hiring.test_postings import add_cues, create, mails_to, opened
from tests.support.deliver import BYTES, TUS, metadata
from tests.support.server import World
from tests.support.waves import sine, wav_bytes

WAV = wav_bytes(sine(hz=440, seconds=0.1), rate=48_000, bits=16)
DAY = timedelta(days=1)
A_PERSON: dict[str, Any] = {
    "name": "Designer A",
    "email": "a@example.test",
    "specialities": ["Weapons", "creatures"],
    "services": ["composes"],
    "languages": ["German"],
    "equipment": "Two ribbon microphones",
    "weekly_hours": 30,
    "exclusivity": "alone",
    "notes": "Asks good questions.",
}
RATE = {"amount_minor": 4_500, "currency": "EUR", "unit": "hour"}


def add(world: World, by: Client | None = None, **facts: Any) -> Response:
    body = {**A_PERSON, **facts}
    return (by or world.producer).post(f"/v1/studios/{world.studio_id}/roster", json=body)


def roster(world: World, by: Client | None = None, **params: str) -> dict[str, Any]:
    answer = (by or world.producer).get(f"/v1/studios/{world.studio_id}/roster", params=params)
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def names(found: dict[str, Any]) -> list[str]:
    return [one["name"] for one in found["items"]]


def test_a_designer_is_kept_found_changed_and_removed(world: World) -> None:
    added = add(world).json()
    assert (added["name"], added["revision"], added["designer"]) == ("Designer A", 1, None)
    add(world, name="Designer B", email="b@example.test", specialities=["UI"], services=[], languages=[], equipment="")
    all_entries = roster(world)
    assert names(all_entries) == ["Designer A", "Designer B"]
    assert (all_entries["found"], all_entries["total"], all_entries["next"]) == (2, 2, None)
    assert {entry["value"] for entry in all_entries["specialities"]} == {"Weapons", "creatures", "UI"}
    for wanted in ({"q": "ribbon"}, {"speciality": "weapons"}, {"service": "composes"}, {"language": "german"}):
        assert names(roster(world, **wanted)) == ["Designer A"], wanted
    assert names(roster(world, q="nobody")) == []
    path = f"/v1/roster/{added['id']}"
    changed = world.producer.put(path, json={**A_PERSON, "name": "Designer A2", "revision": 1}).json()
    assert (changed["name"], changed["revision"]) == ("Designer A2", 2)
    stale = world.producer.put(path, json={**A_PERSON, "revision": 1})
    assert (stale.status_code, stale.json()["code"]) == (409, "roster-entry-changed")
    assert world.producer.delete(path).status_code == 204
    assert world.producer.get(path).status_code == 404
    assert names(roster(world)) == ["Designer B"]


@pytest.mark.slow
def test_an_address_is_on_file_once(world: World) -> None:
    assert add(world).status_code == 201
    again = add(world, email="A@Example.test")
    assert (again.status_code, again.json()["errors"][0]["where"]) == (409, "email")
    other = add(world, email="b@example.test").json()
    taken = world.producer.put(f"/v1/roster/{other['id']}", json={**A_PERSON, "revision": 1})
    assert taken.json()["code"] == "already-on-roster"
    assert add(world, email="none").json()["code"] == "bad-address"


@pytest.mark.parametrize("url", ["http://example.test", "javascript:alert(1)", "https://me:secret@example.test"])
def test_a_link_is_a_plain_https_address(world: World, url: str) -> None:
    refused = add(world, links=[{"title": "Reel", "url": url}])
    assert (refused.status_code, refused.json()["errors"][0]["where"]) == (422, "links.0.url")
    assert roster(world)["total"] == 0


def test_rates_are_for_producers(world: World) -> None:
    entry = add(world, rate=RATE).json()
    path = f"/v1/roster/{entry['id']}"
    assert entry["rate"] == RATE
    assert roster(world)["items"][0]["rate"] == RATE
    lead = world.approver
    seen = lead.get(path).json()
    assert (seen["rate"], seen["may_see_rate"]) == (None, False)
    assert roster(world, lead)["items"][0]["rate"] is None
    assert names(roster(world, lead, q="4500")) == []
    refused = lead.put(path, json={**A_PERSON, "rate": RATE, "revision": 1})
    assert (refused.status_code, refused.json()["code"]) == (403, "producer-needed")
    assert lead.put(path, json={**A_PERSON, "notes": "Called.", "revision": 1}).status_code == 200
    kept = world.producer.get(path).json()
    assert (kept["notes"], kept["rate"]) == ("Called.", RATE)


@pytest.mark.both_databases
def test_only_those_who_act_for_the_studio_see_it(world: World) -> None:
    entry = add(world).json()
    at_studio, path = f"/v1/studios/{world.studio_id}/roster", f"/v1/roster/{entry['id']}"
    for client, status in ((world.reviewer, 403), (world.stranger, 404), (world.designer, 404)):
        for method, where, body in (
            ("GET", at_studio, None),
            ("POST", at_studio, A_PERSON),
            ("GET", path, None),
            ("PUT", path, {**A_PERSON, "revision": 1}),
            ("PUT", f"{path}/busy", {"ranges": []}),
            ("DELETE", path, None),
            ("GET", f"{path}/postings", None),
        ):
            assert client.request(method, where, json=body).status_code == status, (method, where)
    assert world.approver.get(path).status_code == 200


def test_days_that_are_taken_are_shown_and_clash(world: World) -> None:
    entry = add(world).json()
    path, today = f"/v1/roster/{entry['id']}", clock.now().date()
    monday = today - today.weekday() * DAY + 7 * DAY
    ranges = [{"from_on": str(monday), "to_on": str(monday + 4 * DAY), "note": "another game"}]
    changed = world.producer.put(f"{path}/busy", json={"ranges": ranges}).json()
    assert changed["weeks"][:3] == ["free", "booked", "free"]
    assert changed["busy"] == [{**ranges[0], "kind": "booked", "is_from_calendar": False}]
    (asked,) = roster(world, free_from=str(monday + 2 * DAY), free_to=str(monday + 20 * DAY))["items"]
    assert [(one["from_on"], one["to_on"]) for one in asked["clashes"]] == [
        (str(monday + 2 * DAY), str(monday + 4 * DAY))
    ]
    backwards = world.producer.put(
        f"{path}/busy", json={"ranges": [{"from_on": str(today), "to_on": str(today - DAY)}]}
    )
    assert (backwards.status_code, backwards.json()["errors"][0]["where"]) == (422, "ranges.0.to_on")
    assert world.producer.get(path).json()["busy"] == changed["busy"]


def test_loans_are_kept_with_their_days_of_return(world: World) -> None:
    entry = add(world).json()
    path = f"/v1/roster/{entry['id']}"
    assert entry["loans"] == []
    lent = {"item": "Field recorder", "lent_on": "2026-12-01", "due_on": "2026-12-20", "returned_on": None}
    body = {"loans": [lent, {"item": "Microphone", "lent_on": "2026-12-02"}]}
    kept = world.approver.put(f"{path}/loans", json=body)
    assert kept.status_code == 200, kept.text
    assert [loan["item"] for loan in kept.json()["loans"]] == ["Field recorder", "Microphone"]
    back = lent | {"returned_on": "2026-12-18"}
    assert world.producer.put(f"{path}/loans", json={"loans": [back]}).json()["loans"] == [back]
    early = world.producer.put(f"{path}/loans", json={"loans": [lent | {"returned_on": "2026-11-30"}]})
    assert (early.status_code, early.json()["code"]) == (422, "roster-invalid")
    assert early.json()["errors"][0]["where"] == "loans.0.returned_on"
    for by, status in ((world.reviewer, 403), (world.stranger, 404), (world.designer, 404)):
        assert by.put(f"{path}/loans", json={"loans": []}).status_code == status
    assert world.producer.get(path).json()["loans"] == [back]
    assert world.producer.delete(path).status_code == 204


def calendar_of(first: Any, last: Any) -> dict[str, str]:
    text = (
        "BEGIN:VCALENDAR\r\nVERSION:2.0\r\nPRODID:-//test//EN\r\nBEGIN:VEVENT\r\nUID:1\r\nDTSTAMP:20261101T000000Z\r\n"
        f"SUMMARY:A secret project\r\nDTSTART;VALUE=DATE:{first:%Y%m%d}\r\nDTEND;VALUE=DATE:{last + DAY:%Y%m%d}\r\n"
        "END:VEVENT\r\nEND:VCALENDAR\r\n"
    )
    return {"file_name": "mine.ics", "content_base64": base64.b64encode(text.encode()).decode()}


def test_a_calendar_file_is_read_again_and_dropped_without_touching_what_was_typed(world: World) -> None:
    entry = add(world).json()
    path, today = f"/v1/roster/{entry['id']}", clock.now().date()
    typed = {"from_on": str(today + 40 * DAY), "to_on": str(today + 41 * DAY), "kind": "half_days", "note": ""}
    world.producer.put(f"{path}/busy", json={"ranges": [typed]})
    first = world.producer.put(f"{path}/calendar", json=calendar_of(today + DAY, today + 3 * DAY))
    assert first.status_code == 200, first.text
    assert first.json()["calendar_name"] == "mine.ics"
    assert "secret" not in first.text
    assert [one["is_from_calendar"] for one in first.json()["busy"]] == [True, False]
    second = world.producer.put(f"{path}/calendar", json=calendar_of(today + 5 * DAY, today + 6 * DAY)).json()
    assert [one["from_on"] for one in second["busy"]] == [str(today + 5 * DAY), typed["from_on"]]
    broken = {"file_name": "mine.ics", "content_base64": base64.b64encode(b"PK").decode()}
    refused = world.producer.put(f"{path}/calendar", json=broken)
    assert (refused.status_code, refused.json()["code"]) == (422, "calendar-unreadable")
    dropped = world.producer.request("DELETE", f"{path}/calendar").json()
    assert (dropped["calendar_name"], [one["from_on"] for one in dropped["busy"]]) == (None, [typed["from_on"]])


def send_sheet(world: World, text: str, by: Client | None = None, **more: Any) -> Response:
    body = {"format": "paste", "text": text, "dry_run": False, **more}
    return (by or world.producer).post(f"/v1/studios/{world.studio_id}/roster/import", json=body)


SHEET = (
    "Designer\tE-Mail\tSpecialities\tRate\tShoe size\n"
    "Designer A\ta@example.test\tweapons, creatures\t45 EUR/h\t42\n"
    "Designer B\tb@example.test\tUI\t\t40\n"
)


def test_a_sheet_is_shown_first_then_imported_then_matched_by_address(world: World) -> None:
    dry = send_sheet(world, SHEET, dry_run=True).json()
    assert (dry["added"], dry["imported"], dry["errors"]) == (2, False, [])
    assert [column["field"] for column in dry["columns"]] == ["name", "email", "specialities", "rate", "ignore"]
    assert roster(world)["total"] == 0
    assert send_sheet(world, SHEET).json()["imported"]
    first = roster(world)["items"][0]
    assert (first["specialities"], first["rate"]) == (["weapons", "creatures"], RATE)
    again = send_sheet(world, SHEET.replace("Designer B", "Designer Bee").replace("42", "43")).json()
    assert (again["added"], again["changed"], again["same"]) == (0, 1, 1)
    assert again["rows"][1] == {
        "row": 3,
        "action": "change",
        "name": "Designer Bee",
        "email": "b@example.test",
        "changed": ["name"],
    }
    assert names(roster(world)) == ["Designer A", "Designer Bee"]


def test_an_empty_cell_leaves_what_is_on_file(world: World) -> None:
    add(world)
    send_sheet(world, "name\temail\tlanguages\nDesigner A\ta@example.test\t\n")
    assert roster(world)["items"][0]["languages"] == ["German"]


def test_with_an_error_in_any_row_nothing_is_imported_and_rows_are_numbered_as_in_the_sheet(world: World) -> None:
    head = "name\temail\thours per week\nA\ta@example.test\t20\n\n"
    sheet = f"{head}B\tnone\t500\nA again\tA@example.test\t\n\tc@example.test\t\n"
    answer = send_sheet(world, sheet).json()
    assert not answer["imported"]
    assert [(one["row"], one["column"]) for one in answer["errors"]] == [
        (4, "email"),
        (4, "hours per week"),
        (5, "email"),
        (6, "name"),
    ]
    assert "row 2 has the same address" in answer["errors"][2]["message"]
    assert roster(world)["total"] == 0
    without = send_sheet(world, "name\tskills\nA\tweapons\n").json()
    assert "wanted a column with the email" in without["errors"][0]["message"]
    assert send_sheet(world, "").json()["code"] == "sheet-unreadable"


def test_columns_are_mapped_by_hand_and_several_become_notes(world: World) -> None:
    mapping = {"Shoe size": "notes", "Rate": "notes"}
    assert send_sheet(world, SHEET, mapping=mapping).json()["imported"]
    (found,) = roster(world, q="shoe 42")["items"]
    entry = world.producer.get(f"/v1/roster/{found['id']}").json()
    assert (entry["notes"], entry["rate"]) == ("Rate: 45 EUR/h\nShoe size: 42", None)
    twice = send_sheet(world, SHEET, mapping={"Shoe size": "name", "Designer": "name"})
    assert twice.json()["code"] == "column-unknown"


def test_an_audio_lead_imports_no_rates(world: World) -> None:
    refused = send_sheet(world, SHEET, by=world.approver).json()
    assert (refused["imported"], refused["errors"][0]["column"]) == (False, "Rate")
    assert send_sheet(world, SHEET, by=world.approver, mapping={"Rate": "ignore"}).json()["imported"]
    assert send_sheet(world, SHEET, by=world.reviewer).status_code == 403
    assert send_sheet(world, SHEET, by=world.stranger).status_code == 404


def test_a_csv_file_is_read_by_its_bytes(world: World) -> None:
    data = base64.b64encode("Name;Email\nZoë;z@example.test\n".encode("cp1252")).decode()
    body = {"format": "csv", "content_base64": data, "dry_run": False}
    assert world.producer.post(f"/v1/studios/{world.studio_id}/roster/import", json=body).json()["imported"]
    assert names(roster(world)) == ["Zoë"]


@pytest.mark.both_databases
def test_an_account_is_linked_by_its_proven_address_where_it_works_for_the_studio(world: World) -> None:
    def prove(session: Any) -> str:
        person = session.get_one(Person, world.designer_id)
        person.email_verified_at, person.email_proof = clock.now(), AddressProof.MAIL
        return str(person.email)

    address = world.server.in_database(lambda session: session.get_one(Person, world.designer_id).email)
    entry = add(world, email=address).json()
    assert entry["designer"] is None, "an address that is not proven could be of another person"
    world.server.in_database(prove)
    assert world.producer.get(f"/v1/roster/{entry['id']}").json()["designer"]["id"] == str(world.designer_id)
    assert roster(world)["items"][0]["works_here"]
    elsewhere = world.server.in_database(lambda session: session.get_one(Person, world.stranger_id).email)
    stranger = add(world, email=elsewhere).json()
    assert stranger["designer"] is None, "an account that never worked here is not revealed"


@pytest.mark.slow
def test_people_on_file_are_asked_for_a_bid(world: World) -> None:
    add_cues(world)
    today = clock.now().date()
    posting = create(world, work_from_on=str(today), work_to_on=str(today + 30 * DAY)).json()
    entry = add(world, available_from_on=str(today + 10 * DAY)).json()
    (choice,) = world.producer.get(f"/v1/roster/{entry['id']}/postings").json()
    assert (choice["id"], choice["is_asked"], len(choice["clashes"])) == (posting["id"], False, 1)
    assert choice["clashes"][0]["to_on"] == str(today + 9 * DAY)
    asked = world.producer.post(f"/v1/postings/{posting['id']}/roster-candidates", json={"entry_ids": [entry["id"]]})
    assert asked.status_code == 201, asked.text
    assert [one["email"] for one in asked.json()["candidates"]] == ["a@example.test"]
    (choice,) = world.producer.get(f"/v1/roster/{entry['id']}/postings").json()
    assert choice["is_asked"]
    opened = world.producer.post(f"/v1/postings/{posting['id']}/open")
    assert opened.status_code == 200
    world.server.wait_for_jobs()
    (mail,) = mails_to(world, "a@example.test")
    assert mail.link, "a personal link"


def test_nobody_is_asked_where_one_is_not_on_file(world: World) -> None:
    add_cues(world)
    posting = create(world).json()
    entry = add(world).json()
    path = f"/v1/postings/{posting['id']}/roster-candidates"
    refused = world.producer.post(path, json={"entry_ids": [entry["id"], str(world.project_id)]})
    assert (refused.status_code, refused.json()["code"]) == (404, "roster-entry-not-found")
    assert world.producer.get(f"/v1/postings/{posting['id']}").json()["candidates"] == []
    assert world.stranger.post(path, json={"entry_ids": [entry["id"]]}).status_code == 404


def send_sound(world: World, entry: str, content: bytes, by: Client | None = None) -> Response:
    said = metadata(roster_entry_id=entry, file_name="reel.wav")
    headers = {**TUS, **BYTES, "Upload-Length": str(len(content)), "Upload-Metadata": said}
    return (by or world.producer).post("/v1/uploads", headers=headers, content=content)


def test_a_sound_of_a_reel_is_uploaded_played_and_removed(world: World) -> None:
    entry = add(world).json()["id"]
    path = f"/v1/roster/{entry}/reel"
    sent = send_sound(world, entry, WAV)
    assert sent.status_code == 201, sent.text
    upload = sent.headers["location"].rpartition("/")[2]
    (sound,) = world.producer.post(path, json={"upload_id": upload, "title": "Weapons"}).json()["reel"]
    assert (sound["title"], sound["media_type"], sound["file_bytes"]) == ("Weapons", "audio/wav", len(WAV))
    assert roster(world)["items"][0]["reel"] == [sound]
    played = world.approver.get(f"/v1/reel-sounds/{sound['id']}/file")
    assert (played.status_code, played.content) == (200, WAV)
    assert "sandbox" in played.headers["content-security-policy"]
    for client, status in ((world.designer, 404), (world.stranger, 404), (world.reviewer, 403)):
        assert client.get(f"/v1/reel-sounds/{sound['id']}/file").status_code == status
        assert send_sound(world, entry, WAV, client).status_code == status
    assert world.producer.delete(f"/v1/reel-sounds/{sound['id']}").json()["reel"] == []


def test_what_browsers_do_not_play_is_no_sound_of_a_reel(world: World) -> None:
    entry = add(world).json()["id"]
    upload = send_sound(world, entry, b"<svg onload=alert(1)>").headers["location"].rpartition("/")[2]
    refused = world.producer.post(f"/v1/roster/{entry}/reel", json={"upload_id": upload, "title": "Reel"})
    assert (refused.status_code, refused.json()["code"]) == (422, "no-sound")
    two_places = metadata(roster_entry_id=entry, project_id=str(world.project_id), file_name="reel.wav")
    headers = {**TUS, **BYTES, "Upload-Length": "1", "Upload-Metadata": two_places}
    assert world.producer.post("/v1/uploads", headers=headers, content=b"x").json()["code"] == "bad-upload-header"


def test_reels_have_a_limit_of_their_own(world: World) -> None:
    entry = add(world).json()["id"]
    world.server.in_database(lambda session: set_limit(session, world.studio_id, QuotaKind.REEL_BYTES, len(WAV) - 1))
    refused = send_sound(world, entry, WAV)
    assert (refused.status_code, refused.json()["code"]) == (507, "storage-quota-reached")


@pytest.mark.slow
def test_a_comparison_shows_what_is_taken_of_a_bidders_days_to_those_who_see_the_roster(world: World) -> None:
    add_cues(world)
    posting = opened(world, work_from_on="2027-01-04", work_to_on="2027-03-31")
    send(world, posting, world.other_designer, WHOLE)

    def prove(session: Any) -> str:
        person = session.get_one(Person, world.other_designer_id)
        person.email_verified_at, person.email_proof = clock.now(), AddressProof.MAIL
        return str(person.email)

    (bid,) = compared(world, posting)["bids"]
    assert (bid["roster_entry_id"], bid["busy"]) == (None, [])
    entry = add(world, email=world.server.in_database(prove)).json()
    taken = {"from_on": "2027-03-22", "to_on": "2027-04-09", "kind": "booked", "note": "another game"}
    world.producer.put(f"/v1/roster/{entry['id']}/busy", json={"ranges": [taken]})
    (bid,) = compared(world, posting, world.approver)["bids"]
    assert bid["roster_entry_id"] == entry["id"]
    assert bid["busy"] == [{**taken, "to_on": "2027-03-31"}]
