"""Makes the demo project by the same requests as a user's clicks: nothing is inserted in the state it ends in."""

import json
import time
from collections.abc import Callable, Iterable
from datetime import timedelta
from typing import Any, Self

import httpx

from app.accounts.rules import Scope
from app.core import clock
from app.core.runtime import Runtime
from app.demo import brief, cues, extras, voice
from app.demo.game_ci import GameCi
from app.demo.hiring import ADDRESSES, Hiring, link_to
from app.demo.joint_work import divide_voice_lines
from app.demo.people import SECOND_DESIGNER, make_people
from app.demo.progress import Progress
from app.demo.references import demo_references
from app.demo.sounds import DemoSound, demo_sounds, thrusters_in_one_file, warp_in_stem
from app.demo.visitors import Visitor, signed_in_visitor
from app.demo.whole_files import write_whole
from app.settings import Settings

CHECKED_WITHIN_S = 600.0  # seconds on a free machine
POLL_EVERY_S = 0.25
DONE_FILE = "demo.json"
INVOICES = ("Deposit", "Palette")  # in the order in which they are issued
PROJECT_NAME = "Shield Wing"
KeepGoing = Callable[[], bool]


class DemoStopped(Exception):
    """The process tree was asked to stop while the demo was being made."""


class DemoIncomplete(Exception):
    """A step of the demo's story failed: says which, and why."""


def make_demo_project(runtime: Runtime, *, progress: Progress, keep_going: KeepGoing) -> tuple[str, str] | None:
    """Make the demo where it is not complete yet; return the project's id and its build's token, None once stopped."""
    done = runtime.settings.data_dir / DONE_FILE
    if done.exists():
        made_before = json.loads(done.read_text())
        return made_before["project"], made_before["token"]
    progress.begin(f"{runtime.settings.base_url} is open already")
    progress.begin("Making the demo project: 36 cues, every sound by our own generators")
    people = make_people(runtime)
    try:
        second = signed_in_visitor(runtime, people[SECOND_DESIGNER])
        with _Maker(runtime.settings, people, second, keep_going, progress) as maker:
            project, token = maker.make()
    except DemoStopped:
        return None
    except (RuntimeError, httpx.HTTPError) as error:
        if not keep_going():
            return None
        raise DemoIncomplete(str(error)) from error
    write_whole(done, json.dumps({"project": project, "token": token}))
    return project, token


def _asking(toml: str) -> str:
    """Return a spec that asks for what judgements find."""
    asked = "".join(f'{check} = "warning"\n' for check in ("upsampled", "lossy", "reversed"))
    warned = 'head-silence = "warning"\n'
    return toml.replace(warned, warned + asked, 1)


class _Maker:
    """Plays the parts one after the other."""

    def __init__(
        self,
        settings: Settings,
        people: dict[str, str],
        second_designer: Visitor,
        keep_going: KeepGoing,
        progress: Progress,
    ) -> None:
        self._people = people
        self._second_designer = second_designer
        self._keep_going = keep_going
        self._progress = progress
        self._producer = Visitor(settings, "producer")
        self._approver = Visitor(settings, "approver")
        self._designer = Visitor(settings, "designer")
        self._settings = settings
        self._sounds = demo_sounds()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_error: object) -> None:
        for visitor in (self._producer, self._approver, self._designer, self._second_designer):
            visitor.close()

    def make(self) -> tuple[str, str]:
        """Go through the story of the project so far; return the project's id and its build's token."""
        self._begin("Opening the project and writing its brief")
        self._create_project()
        self._write_brief()
        self._write_checklists()
        self._begin("Inviting the designer and posting the sound list")
        self._invite_designer()
        self._post_list()
        self._add_references()
        self._begin("Agreeing on the contract")
        self._agree_on_contract()
        self._pay_due_invoices("Deposit")
        self._begin("Delivering and approving the palette")
        self._deliver("The palette first.", self._files(cues.PALETTE))
        self._accept(cues.PALETTE)
        self._pay_due_invoices("Palette")
        self._begin("Checking the first build of the game")
        token = self._make_token()
        self._ci = GameCi(self._settings.base_url, self._project, token)
        self._build("481")
        self._begin("Delivering sounds of the alpha")
        self._deliver(
            "A: struck bowl over own hum, band-passed. B: same, lower bowl. C: bowl replaced by glass.",
            [
                *self._files(("shield_hit", "foot_deck_walk", "airlock_cycle", "mine_arm", *cues.ACCEPTED_OF_ALPHA)),
                self._sounds["suit_hit"],
                self._sounds["missile_launch"],
            ],
        )
        self._accept((*cues.ACCEPTED_OF_ALPHA, cues.FOOTSTEPS))
        self._begin("Requesting changes and delivering again")
        self._request_changes(*cues.CHANGES)
        self._deliver("Missile, with more of the release.", [self._sounds["missile_launch_take2"]])
        self._request_changes(cues.SECOND_CHANGE)
        self._deliver(
            "Suit hit with the clank; thrusters; the arrival; the swarm; the oath; and the sting.",
            [
                self._sounds["suit_hit_take2"],
                self._sounds["missile_launch_take3"],
                self._sounds["final_FINAL_sting2"],
                warp_in_stem(),
                *self._files(("warp_in", "drone_swarm_loop", "vo_oath")),
                thrusters_in_one_file(),
            ],
        )
        self._split(thrusters_in_one_file().file_name, "thruster_burst")
        self._request_changes(cues.THIRD_CHANGE)
        self._ask(*cues.QUESTION)
        self._cut(*cues.CUT)
        self._begin("Checking and auditing the second build of the game")
        self._build("482", strays=[self._sounds["airlock_cycle"]])
        self._await(self._ci.has_manifest)
        self._ci.audit(self._producer.ask, {"481": {}, "482": {cues.FOOTSTEPS: cues.FOOTSTEPS_LOUDER_DB}})
        self._begin("Adding voice lines")
        self._add_voice_lines()
        self._divide_voice_lines()
        extras.add_extras(self._producer, self._people["studio"], self._project, self._cues)
        extras.hand_off_newest(self._designer, self._project)
        extras.add_own_time(self._designer, self._project)
        return self._project, token

    def _begin(self, step: str) -> None:
        self._ensure_not_stopped()
        self._progress.begin(step)

    def _add_voice_lines(self) -> None:
        path = f"/projects/{self._project}"
        voice.add_script(self._producer.ask, path)
        listed = self._producer.ask("GET", f"{path}/sound-list", params={"limit": 500})["cues"]
        self._cues = {cue["name"]: cue["id"] for cue in listed}
        self._deliver("First session of scene 14.", voice.voice_takes())
        self._accept(voice.APPROVED)
        voice.change_text(self._producer.ask, path)

    def _divide_voice_lines(self) -> None:
        people = self._producer, self._second_designer
        divide_voice_lines(*people, self._people["studio"], self._project, self._cues, self._await)

    def _files(self, names: Iterable[str]) -> list[DemoSound]:
        return [
            sound
            for name in names
            for key, sound in self._sounds.items()
            if key == name or (key.startswith(f"{name}_") and key.removeprefix(f"{name}_")[:3] != "tak")
        ]

    def _create_project(self) -> None:
        producer = self._producer
        body = {
            "studio_id": self._people["studio"],
            "name": PROJECT_NAME,
            "description": cues.DESCRIPTION,
            "cue_prefix": "SW",
            "preset": "44k1",
        }
        there = (
            listed_project
            for listed_project in producer.ask("GET", "/projects")["items"]
            if listed_project["name"] == PROJECT_NAME
        )
        project = next(there, None) or producer.ask("POST", "/projects", json=body)
        self._project = project["id"]
        director = self._people["Audio director"]
        producer.ask("PUT", f"/projects/{self._project}/liaisons/{director}")
        project = producer.ask("GET", f"/projects/{self._project}")
        if project["approver"]["id"] != director:
            why = {"person_id": director, "reason": "Named when the project opened."}
            producer.ask("PUT", f"/projects/{self._project}/approver", json=why)
        spec = producer.ask("GET", f"/projects/{self._project}/spec")
        if spec["version"] == 1:
            dry = {
                "toml": _asking(spec["toml"]),
                "note": "Every room of the game has its own reverb; ask where a sound comes from.",
                "based_on_version": 1,
            }
            producer.ask("PUT", f"/projects/{self._project}/spec", json=dry)

    def _write_checklists(self) -> None:
        for category, items in cues.CHECKLISTS.items():
            body = {"category": category, "items": items}
            self._producer.ask("PUT", f"/projects/{self._project}/checklist", json=body)

    def _write_brief(self) -> None:
        path = f"/projects/{self._project}/brief"
        if self._producer.ask("GET", path)["newest_version"]:
            return
        written = self._producer.ask("PATCH", path, json={"revision": 0, "answers": brief.changes()})
        body = {"revision": written["revision"], "note": "As agreed in the first call."}
        self._producer.ask("POST", f"{path}/versions", once="demo-brief", json=body)
        kick_off = {"decided_on": clock.now().date().isoformat()} | brief.DECISION
        self._producer.ask("POST", f"/projects/{self._project}/decisions", once="demo-decision", json=kick_off)

    def _invite_designer(self) -> None:
        project = self._producer.ask("GET", f"/projects/{self._project}")
        if project["engagements"]:
            return
        body = {"email": ADDRESSES[0], "kind": "contract", "note": "Six palette sounds first."}
        path = f"/projects/{self._project}/invitations"
        if not self._producer.ask("GET", path):  # a second one would withdraw the link of the first
            self._producer.ask("POST", path, json=body)
        link = self._await(lambda: link_to(self._producer, self._people["studio"], ADDRESSES[0], "/invitation/"))
        self._designer.ask("POST", f"/invitations/{link.rsplit('/', 1)[1]}/accept", json={})

    def _post_list(self) -> None:
        path = f"/projects/{self._project}"
        listed = self._producer.ask("GET", f"{path}/sound-list")["cues"]
        if not listed:
            self._producer.ask("POST", f"{path}/cues", json={"cues": cues.CUES})
            listed = self._producer.ask("GET", f"{path}/sound-list")["cues"]
        self._cues = {cue["name"]: cue["id"] for cue in listed}

    def _add_references(self) -> None:
        path = f"/projects/{self._project}/references"
        there = {reference["version"]["file_name"] for reference in self._producer.ask("GET", path)["items"]}
        for demo_reference in demo_references():
            if demo_reference.file_name not in there:
                facts = {
                    "caption": demo_reference.caption,
                    "terms": demo_reference.terms,
                    "words": demo_reference.words,
                    "start_s": demo_reference.start_s,
                    "end_s": demo_reference.end_s,
                }
                body = {
                    "upload_id": self._producer.send_reference(self._project, demo_reference),
                    "cue_id": self._cues[demo_reference.cue],
                }
                self._producer.ask("POST", path, json=body | facts)

    def _deliver(self, note: str, sounds: list[DemoSound]) -> None:
        path = f"/projects/{self._project}/deliveries"
        there_already = (
            listed_delivery
            for listed_delivery in self._designer.ask("GET", path)["items"]
            if listed_delivery["note"] == note
        )
        delivery = next(there_already, None) or self._designer.ask("POST", path, json={"note": note})
        delivery_read = self._designer.ask("GET", f"/deliveries/{delivery['id']}")
        there = {file["file_name"] for file in [*delivery_read["takes"], *delivery_read["dry_stems"]]}
        for sound in sounds:
            if sound.file_name not in there:
                self._ensure_not_stopped()
                self._upload(delivery["id"], sound)
        self._designer.ask("POST", f"/deliveries/{delivery['id']}/close")
        self._await(self._queue_is_empty)

    def _upload(self, delivery_id: str, sound: DemoSound) -> None:
        destination = {"delivery_id": delivery_id, "file_name": sound.file_name}
        upload = self._designer.ask("PUT", "/uploads", params=destination, content=sound.wav_bytes())
        body = {"upload_id": upload["upload_id"], "file_name": sound.file_name}
        self._designer.ask("POST", f"/deliveries/{delivery_id}/takes", json=body)

    def _split(self, file_name: str, cue: str) -> None:
        """Make the sounds of one file variations of a cue, once, as the designer does on arrival."""
        whole = next((take for take in self._takes() if take["file_name"] == file_name), None)
        if whole is not None:  # once it is split it is not listed
            path = f"/takes/{whole['id']}/split"
            self._designer.ask("POST", path, json={})
            self._await(lambda: self._designer.ask("GET", path)["state"] == "made")
            self._designer.ask("POST", f"{path}/use", json={"cue_id": self._cues[cue]})
        self._await(self._queue_is_empty)

    def _takes(self, **filters: str) -> list[dict[str, Any]]:
        answer = self._producer.ask("GET", f"/projects/{self._project}/takes", params={"limit": "200"} | filters)
        takes: list[dict[str, Any]] = answer["items"]
        return takes

    def _queue(self) -> dict[str, list[dict[str, Any]]]:
        answer = self._approver.ask("GET", "/review-queue", params={"project_id": self._project})
        return {item["cue"]["name"]: item["takes"] for item in answer["items"]}

    def _queue_is_empty(self) -> bool:
        if any(take["state"] == "received" for take in self._takes()):
            return False
        queue = self._queue()
        conforming = [take for take in self._takes() if take["state"] == "conforming" and take["cue"]]
        return len(conforming) == sum(len(takes) for takes in queue.values())

    def _accept(self, names: Iterable[str]) -> None:
        for name, takes in self._queue().items():
            if name in names:
                take_ids = [take["id"] for take in takes]
                accept = {"note": "", "take_ids": take_ids, "heard_take_ids": take_ids}
                self._approver.ask("POST", f"/cues/{self._cues[name]}/accept-set", json=accept)

    def _request_changes(self, *changes: tuple[str, str, float]) -> None:
        queue = self._queue()
        waiting = [change for change in changes if queue.get(change[0])]
        for name, text, start_s in waiting:
            if text in self._asked():  # said already, by a demo that was stopped
                continue
            verdict = {"kind": "request_change", "note": text, "start_s": start_s}
            self._approver.ask("POST", f"/takes/{queue[name][0]['id']}/verdict", json=verdict)
        drafts = self._approver.ask("GET", f"/projects/{self._project}/change-requests", params={"state": "draft"})
        if drafts["items"]:
            self._approver.ask("POST", f"/projects/{self._project}/feedback", json={"note": ""})

    def _asked(self) -> set[str]:
        path, params = f"/projects/{self._project}/change-requests", {"state": "sent"}
        return {question["text"] for question in self._approver.ask("GET", path, params=params)["items"]}

    def _agree_on_contract(self) -> None:
        """Award the work, send the draft, answer a redline, and have both accept the same text."""
        hiring = Hiring(self._producer, self._approver, self._people["studio"], self._project, self._await)
        self._contract = hiring.award(self._designer, [self._designer, self._second_designer])
        contract = f"/contracts/{self._contract}"
        read = self._producer.ask("GET", contract)
        if read["state"] == "draft" and not read["redlines"]:
            self._producer.ask("PUT", f"{contract}/milestones", json={"milestones": self._plan()})
            read = self._producer.ask("POST", f"{contract}/send", json={"note": ""})
        if read["state"] == "sent" and not read["redlines"]:
            extras.propose_redline(self._designer, read)
        read = self._producer.ask("GET", contract)
        if read["state"] == "draft":
            if read["redlines"]["unanswered"]:
                self._producer.ask("POST", f"{contract}/redlines/1/answer", json={"answer": "accepted"})
            self._producer.ask("POST", f"{contract}/send", json={"note": ""})
        for visitor, name in ((self._producer, "Producer"), (self._designer, "Sound designer")):
            read = visitor.ask("GET", contract)
            if read["may"]["accept"]:
                accept = {"name": name, "text_sha256": read["version"]["text_sha256"]}
                visitor.ask("POST", f"{contract}/accept", json=accept)

    def _plan(self) -> list[dict[str, Any]]:
        # Nothing is dated back: the record is chained over the moments at which things were done, and these are now.
        # So the palette is due on the day on which the demo is made, and is accepted and paid in time on it.
        today = clock.now().date()
        deposit = {"name": "Deposit", "amount_minor": cues.DEPOSIT_MINOR, "is_deposit": True}
        milestones = [
            {
                "name": name,
                "due_on": (today + timedelta(days=days)).isoformat(),
                "cues": [
                    {"cue_id": self._cues[cue], "price_minor": price_minor, "estimate_min": cues.ESTIMATE_MIN}
                    for cue in of_it
                ],
            }
            for name, of_it, price_minor, days in cues.MILESTONES
        ]
        return [deposit, *milestones]

    def _pay_due_invoices(self, what: str) -> None:
        """Issue an invoice as the designer, and pay it as the producer."""
        body = {"seller": "Sound designer", "buyer": "Shield Wing studio", "po_number": "SW-2026"}
        path = f"/contracts/{self._contract}/invoices"
        issued = self._designer.ask("GET", path)
        at = INVOICES.index(what)
        invoice = issued[at] if at < len(issued) else self._designer.ask("POST", path, json=body)
        now = self._producer.ask("GET", f"/invoices/{invoice['id']}")
        if now["open_minor"]:
            paid = {"amount_minor": now["open_minor"], "reference": what, "paid_on": clock.now().date().isoformat()}
            self._producer.ask("POST", f"/invoices/{invoice['id']}/payments", json=paid)

    def _ask(self, name: str, text: str) -> None:
        path = f"/cues/{self._cues[name]}/questions"
        self._designer.ask("POST", path, once="demo-question", json={"text": text})

    def _cut(self, name: str, reason: str) -> None:
        self._producer.ask("POST", f"/cues/{self._cues[name]}/cut", once="demo-cut", json={"reason": reason})

    def _make_token(self) -> str:
        scopes = [Scope.SPEC_READ, Scope.LIST_READ, Scope.CHECKS_WRITE, Scope.MANIFEST_READ]
        path = f"/projects/{self._project}/tokens"
        body = {"name": "The game’s CI", "scopes": scopes}
        token: str = self._producer.ask("POST", path, json=body)[
            "secret"
        ]  # shown once: a demo begun again makes another
        return token

    def _build(self, label: str, *, strays: Iterable[DemoSound] = ()) -> None:
        self._ci.build(label, self._producer.ask, strays=strays)

    def _await(self, condition: Callable[[], Any]) -> Any:
        deadline = time.monotonic() + CHECKED_WITHIN_S
        while time.monotonic() < deadline:
            self._ensure_not_stopped()
            if value := condition():
                return value
            time.sleep(POLL_EVERY_S)
        raise RuntimeError(f"the demo's files were not checked within {CHECKED_WITHIN_S:.0f} s; is the worker running?")

    def _ensure_not_stopped(self) -> None:
        if not self._keep_going():
            raise DemoStopped
