"""Makes studios, lists and takes of any size, shaped like real ones, straight into the tables."""

import hashlib
import json
import random
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from datetime import datetime, timedelta
from functools import cache
from typing import Any
from uuid import UUID

import audio_checks
from app.accounts.authentication import sha256_of
from app.accounts.models import Membership, Person, SignIn, Studio
from app.accounts.rules import Role
from app.conformance.models import CheckRun
from app.core import clock
from app.core.db import new_id
from app.deliveries.cue_counts.rules import TakeForSums
from app.deliveries.cue_counts.service import views_of
from app.deliveries.models import Delivery, Take, TakeCounts
from app.deliveries.rules import TakeState
from app.projects.models import ApproverChange, Engagement, Liaison, Project, Spec
from app.projects.rules import EngagementKind
from app.renders.models import Picture, Render, RenderSet
from app.renders.rules import RENDERED_STATES, RenderState, recipes
from app.reviews.models import ChangeRequest, Comment, Feedback, GivenReason, Round, Verdict
from app.reviews.reasons.rules import OURS, ReasonKind
from app.reviews.rules import VerdictKind
from app.sound_lists.models import Cue, Question, Revision, Stem
from app.sound_lists.rules import CueState
from benchmarks.bulk import Bulk

TOML = audio_checks.new_spec("48k", name="Scale")
CATEGORIES = ("ui", "weapon", "impact", "ambience", "creature", "vehicle", "foley", "vo")
SOURCES = ("laser", "door", "shield", "engine", "hull", "step", "splash", "servo", "rock", "wing", "beam", "hatch")
ACTIONS = ("fire", "hit", "open", "close", "loop", "start", "stop", "charge", "fall", "slide", "break", "land")
MANNERS = ("soft", "hard", "metal", "wet", "near", "far", "small", "huge", "short", "long")
SAID = ("too bright above the tail", "the attack is lost under the music", "like the second half", "a little shorter")
# How the newest take of a variation stands; what came before it was returned, changed or set aside.
NEWEST = (
    (TakeState.APPROVED, 60),
    (TakeState.CONFORMING, 14),
    (TakeState.CHANGE_REQUESTED, 12),
    (TakeState.RETURNED, 9),
    (TakeState.SET_ASIDE, 3),
    (TakeState.RECEIVED, 2),
)
EARLIER = ((TakeState.CHANGE_REQUESTED, 50), (TakeState.RETURNED, 35), (TakeState.SET_ASIDE, 15))
TAKES_A_CUE = 10
LABELLED = 0.1  # of all takes
THUMB_POINTS = 128
LASTING = timedelta(days=400)


@dataclass(frozen=True)
class Team:
    """A studio and its people, signed in with the secrets given."""

    studio_id: UUID
    producer_id: UUID
    approver_id: UUID
    designer_ids: tuple[UUID, ...]


@dataclass(frozen=True)
class Made:
    """What a project was filled with."""

    studio_id: UUID
    project_id: UUID
    cues: int
    takes: int
    waiting_cues: int
    producer_secret: str
    approver_secret: str
    designer_secret: str


def make_team(bulk: Bulk, name: str) -> Team:
    """Add a studio with a producer, an approver and four designers."""
    studio_id = new_id()
    bulk.add(Studio, id=studio_id, name=name)
    people = []
    for part in ("producer", "approver", *(f"designer {place}" for place in range(1, 5))):
        person_id = new_id()
        bulk.add(Person, id=person_id, email=f"{person_id}@scale.example", name=f"{name} {part}")
        people.append(person_id)
    for person_id, role in zip(people, (Role.PRODUCER, Role.LIAISON), strict=False):
        bulk.add(Membership, studio_id=studio_id, person_id=person_id, roles=[role])
    return Team(studio_id, people[0], people[1], tuple(people[2:]))


def sign_in(bulk: Bulk, person_id: UUID) -> str:
    """Return the secret of a new sign-in."""
    secret = f"secret of {new_id()}"
    bulk.add(SignIn, person_id=person_id, secret_sha256=sha256_of(secret), expires_at=clock.now() + LASTING)
    return secret


class ProjectMaker:
    """Adds one project with its list, its takes and all that was found and said of them."""

    def __init__(
        self, bulk: Bulk, team: Team, *, takes: int, seed: int, newest: Sequence[tuple[TakeState, int]] = NEWEST
    ) -> None:
        self._bulk = bulk
        self._team = team
        self._wanted = takes
        self._newest = newest
        self._dice = random.Random(seed)
        self._words = random.Random(seed)  # for reasons and labels: the sounds are the same with and without them
        self._project_id, self._spec_id = new_id(), new_id()
        self._tenant = {"studio_id": team.studio_id, "project_id": self._project_id}
        self._begun = clock.now() - timedelta(days=300)
        self._takes = self._waiting_cues = 0
        self._deliveries = [new_id() for _ in range(max(1, takes // 40))]
        self._sendings = [new_id() for _ in range(max(1, takes // 200))]

    def make(self) -> Made:
        """Add everything; as many cues as the takes are for."""
        self._make_head()
        cues = 0
        while self._takes < self._wanted:
            cues += 1
            self._make_cue(cues)
        return Made(
            self._team.studio_id,
            self._project_id,
            cues,
            self._takes,
            self._waiting_cues,
            sign_in(self._bulk, self._team.producer_id),
            sign_in(self._bulk, self._team.approver_id),
            sign_in(self._bulk, self._team.designer_ids[0]),
        )

    def _make_head(self) -> None:
        add, team = self._bulk.add, self._team
        add(Project, id=self._project_id, studio_id=team.studio_id, name="Scale", cue_prefix="SC",
            created_by=team.producer_id)  # fmt: skip
        add(Spec, id=self._spec_id, **self._tenant, version=1, toml=TOML, sha256=_spec().sha256,
            created_by=team.producer_id)  # fmt: skip
        add(Liaison, **self._tenant, person_id=team.approver_id)
        add(ApproverChange, **self._tenant, person_id=team.approver_id, reason="named at the start",
            changed_by=team.producer_id)  # fmt: skip
        for designer_id in team.designer_ids:
            add(Engagement, **self._tenant, designer_id=designer_id, kind=EngagementKind.CONTRACT)
        for number, delivery_id in enumerate(self._deliveries, start=1):
            designer_id = team.designer_ids[number % len(team.designer_ids)]
            add(Delivery, id=delivery_id, **self._tenant, designer_id=designer_id, number=number,
                created_at=self._begun + timedelta(hours=number))  # fmt: skip
        for feedback_id in self._sendings:
            add(Feedback, id=feedback_id, **self._tenant, sent_by=team.approver_id)
        add(Revision, **self._tenant, number=1, summary="imported", changed_by=team.producer_id)

    def _make_cue(self, number: int) -> None:
        dice, add, cue_id = self._dice, self._bulk.add, new_id()
        words = (dice.choice(SOURCES), dice.choice(ACTIONS), dice.choice(MANNERS), str(number))
        category, loop = dice.choice(CATEGORIES), words[1] == "loop"
        variations = dice.choices((1, 2, 3, 4, 6, 8), (50, 5, 10, 25, 5, 5))[0]
        is_cut = dice.random() < 0.03
        add(
            Cue, id=cue_id, **self._tenant, number=number, position=number, name="_".join(words), category=category,
            description=f"{words[2]} {words[0]} that can be heard over the music when the player comes near",
            use=f"plays when the {words[0]} begins to {words[1]}", duration_s=round(dice.uniform(0.2, 8), 2), loop=loop,
            variations=variations, state=CueState.CUT if is_cut else CueState.LOCKED,
            cut_reason="the level was dropped" if is_cut else None, cut_at=clock.now() if is_cut else None,
            palette=number <= 8, created_at=self._begun,
        )  # fmt: skip
        for variation in range(1, variations + 1):
            stem = "_".join(words) + (f"_{variation:02}" if variations > 1 else "")
            if not is_cut:
                add(Stem, **self._tenant, cue_id=cue_id, variation=variation, stem=stem, folded=stem)
        if dice.random() < 0.08:
            add(Question, **self._tenant, cue_id=cue_id, text=f"does the {words[0]} stand in water or on stone?",
                asked_by=self._team.designer_ids[0], asked_at=self._begun,
                answered_at=None if dice.random() < 0.3 else clock.now())  # fmt: skip
        waits, summed = False, []
        for variation in range(1, variations + 1):
            for place, state in enumerate(states := self._states(), start=1):
                summed.append(self._make_take(cue_id, words, category, variation, place, state, loop=loop))
                waits |= place == len(states) and state is TakeState.CONFORMING and not is_cut
        for viewer_id, sums in views_of(self._team.studio_id, summed):
            add(TakeCounts, cue_id=cue_id, viewer_id=viewer_id, **self._tenant, variations=variations,
                placeholder=False, state=CueState.CUT if is_cut else CueState.LOCKED, **asdict(sums))  # fmt: skip
        self._waiting_cues += waits
        if dice.random() < 0.3:
            add(Round, **self._tenant, cue_id=cue_id, feedback_id=dice.choice(self._sendings), number=1)

    def _states(self) -> list[TakeState]:
        """Return how the takes of one variation stand, the oldest first; together as many as a cue has on average."""
        dice = self._dice
        earlier = int(dice.expovariate(1 / max(0.5, TAKES_A_CUE / 2.6 - 1)))
        states, weights = zip(*EARLIER, strict=True)
        newest, newest_weights = zip(*self._newest, strict=True)
        return [*dice.choices(states, weights, k=earlier), dice.choices(newest, newest_weights)[0]]

    def _make_take(
        self, cue_id: UUID, words: tuple[str, ...], category: str, variation: int, number: int, state: TakeState,
        *, loop: bool,
    ) -> TakeForSums:  # fmt: skip
        self._takes += 1
        dice, add, take_id = self._dice, self._bulk.add, new_id()
        sha256 = hashlib.sha256(take_id.bytes).hexdigest()
        at = self._begun + timedelta(seconds=dice.randrange(25_000_000))
        place = self._takes % len(self._deliveries)
        name = f"{'_'.join(words)}_{variation:02}.wav"
        designer_id = self._team.designer_ids[(place + 1) % len(self._team.designer_ids)]
        summed = TakeForSums(take_id, designer_id, variation, number, state, state_since=at, received_at=at)
        add(
            Take, **self._tenant, **summed._asdict(), delivery_id=self._deliveries[place], cue_id=cue_id,
            file_name=name, master_sha256=sha256, master_bytes=864_044, **self._label(designer_id),
        )  # fmt: skip
        self._make_picture(sha256)
        if state is TakeState.RECEIVED:
            return summed
        is_rejected = state is TakeState.RETURNED
        add(CheckRun, **self._tenant, take_id=take_id, spec_id=self._spec_id, key=sha256, pcm_sha256=sha256,
            verdict="rejected" if is_rejected else "conforming", report=_report(name, sha256, rejected=is_rejected),
            tool_version=audio_checks.TOOL_VERSION, created_at=at)  # fmt: skip
        if state in RENDERED_STATES:
            self._make_renders(take_id, sha256, category, loop=loop)
        if state in (TakeState.APPROVED, TakeState.CHANGE_REQUESTED):
            self._judge(cue_id, take_id, designer_id, at, is_pick=state is TakeState.APPROVED)
        if dice.random() < 0.2:
            add(Comment, **self._tenant, take_id=take_id, text=dice.choice(SAID), written_by=self._team.approver_id,
                decides=True, created_at=at)  # fmt: skip
        return summed

    def _judge(self, cue_id: UUID, take_id: UUID, designer_id: UUID, at: datetime, *, is_pick: bool) -> None:
        """Approve a take or request a change, most often with a reason."""
        kind, words = ReasonKind.PICK if is_pick else ReasonKind.CHANGE, self._words
        reasons = words.sample(OURS[kind], words.choices((0, 1, 2), (30, 55, 15))[0])
        verdict_id, approver_id, change_id = new_id(), self._team.approver_id, None
        if not is_pick:
            change_id = new_id()
            self._say(ChangeRequest, cue_id, take_id, at, id=change_id, text=self._dice.choice(SAID), start_s=0.1,
                      end_s=0.4, written_by=approver_id, feedback_id=self._dice.choice(self._sendings),
                      reasons=reasons)  # fmt: skip
        self._say(Verdict, cue_id, take_id, at, id=verdict_id, action_id=new_id(), reasons=reasons,
                  kind=VerdictKind.APPROVE if is_pick else VerdictKind.REQUEST_CHANGE, given_by=approver_id,
                  state_before=TakeState.CONFORMING, since_before=at)  # fmt: skip
        for reason in reasons:
            self._bulk.add(GivenReason, **self._tenant, verdict_id=verdict_id, reason=reason, kind=kind,
                           cue_id=cue_id, designer_id=designer_id, change_request_id=change_id)  # fmt: skip

    def _label(self, designer_id: UUID) -> dict[str, Any]:
        """Return a label for one take in ten."""
        if self._words.random() >= LABELLED:
            return {}
        return {
            "label": self._words.choice(OURS[ReasonKind.LABEL]),
            "labelled_by": designer_id,
            "labelled_at": self._begun,
        }

    def _say(self, model: Any, cue_id: UUID, take_id: UUID, at: datetime, **what: Any) -> None:
        self._bulk.add(model, **self._tenant, cue_id=cue_id, take_id=take_id, created_at=at, **what)

    def _make_renders(self, take_id: UUID, master_sha256: str, category: str, *, loop: bool) -> None:
        for target, recipe in _recipes(category, loop).items():
            key = recipe.key(master_sha256)
            self._bulk.add(
                Render, **self._tenant, take_id=take_id, target=target, key=key, state=RenderState.MADE, sha256=key,
                pcm_sha256=key, file_bytes=576_044, facts=_facts_text(), measurements=_measurements_text(),
            )  # fmt: skip
            self._make_picture(key)
        self._bulk.add(RenderSet, take_id=take_id, studio_id=self._team.studio_id, spec_id=self._spec_id, edition=1)

    def _make_picture(self, sha256: str) -> None:
        self._bulk.add(
            Picture, studio_id=self._team.studio_id, sound_sha256=sha256, duration_s=3.0, facts=_facts_text(),
            thumb=_thumb(), peaks_sha256=sha256, spectrum_sha256=sha256, preview_sha256=sha256,
            preview_media_type="audio/wav", drawn_bytes=310_000,
        )  # fmt: skip


def others(total: int) -> Iterator[tuple[int, int]]:
    """Yield a studio's place and a project's size until the server holds so many takes besides the measured ones."""
    place, sizes = 0, (2_000, 5_000, 10_000, 25_000)
    while total > 0:
        takes = min(total, sizes[place % len(sizes)])
        yield place // 3, takes
        total, place = total - takes, place + 1


@cache
def _spec() -> audio_checks.DeliverySpec:
    return audio_checks.parse_spec(TOML)


@cache
def _recipes(category: str, loop: bool) -> Any:
    return recipes(_spec(), category=category, loop=loop)


@cache
def _thumb() -> str:
    dice = random.Random(1)
    high = [dice.randrange(0, 127) for _ in range(THUMB_POINTS)]
    shape = {"points": THUMB_POINTS, "min": [-one for one in high], "max": high, "rms": [one // 2 for one in high]}
    return json.dumps(shape)


@cache
def _facts() -> dict[str, Any]:
    return {
        "container": "wav", "encoding": "pcm", "sample_rate_hz": 48_000, "bit_depth": 24, "effective_bits": 24,
        "channels": 2, "frames": 144_000, "duration_s": 3.0, "chunks": ["fmt ", "data"],
    }  # fmt: skip


@cache
def _facts_text() -> str:
    return json.dumps(_facts())


@cache
def _measurements() -> dict[str, Any]:
    return {
        "head_silence_ms": 0.04, "tail_silence_ms": 2.48, "clipped_runs": 0, "is_silence": False,
        "sample_peak_dbfs": -7.0536955236570895, "sample_peak_s": 0.002125, "rms_dbfs": -20.69079789913482,
        "crest_db": 13.637102375477731, "dc_offset_percent": 0.00043781713033333805, "silent_channels": [],
        "integrated_lufs": -22.1, "max_momentary_lufs": -20.94527558202545, "max_short_term_lufs": -29.69588821594245,
        "loudness_range_lu": 3.1, "short_loudness_lufs": -20.94527558202545, "channel_correlation": 0.9238735201819555,
        "seam_step_db": None, "seam_slope_db": -54.3258052348405, "bandwidth_hz": 23824.21875,
        "true_peak_dbtp": -7.000588030054601, "true_peak_s": 0.0021197916666666665,
    }  # fmt: skip


@cache
def _measurements_text() -> str:
    return json.dumps(_measurements())


@cache
def _finding() -> dict[str, Any]:
    return {
        "check": "sample-peak", "code": "sample-peak:over", "severity": "error", "message":
        "sample peak 0.0 dBFS, limit -0.1 dBFS", "fix": "lower the level by 0.1 dB or more", "measured": 0.0,
        "limit": -0.1, "unit": "dBFS", "start_s": 0.1, "end_s": 0.2,
    }  # fmt: skip


@cache
def _report_text(*, rejected: bool) -> str:
    """Return the report on a file, with {name} and {sha256} in place of its name and hash."""
    report = {
        "path": "{name}", "sha256": "{sha256}", "pcm_sha256": "{sha256}", "category": "ui",
        "verdict": "rejected" if rejected else "conforming", "facts": _facts(), "measurements": _measurements(),
        "judgements": {}, "findings": [_finding()] if rejected else [],
    }  # fmt: skip
    return json.dumps(report)


def _report(name: str, sha256: str, *, rejected: bool) -> str:
    return _report_text(rejected=rejected).replace("{name}", name).replace("{sha256}", sha256)
