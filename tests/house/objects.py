"""One of everything that an address can name, all of one designer's work in one project."""

from datetime import date, timedelta
from functools import cache, cached_property
from typing import Any
from uuid import UUID

from httpx2 import Client
from sqlalchemy.orm import Session

from app.accounts.authentication import new_secret
from app.accounts.models import (
    Operator,
    Person,
    PersonPicture,
    Token,
)
from app.accounts.passwords import hash_of
from app.accounts.queries import actor_for_person
from app.accounts.rules import Scope
from app.accounts.service import add_token
from app.agreements.rules import ContractKind
from app.briefs.models import Brief, BriefVersion, Decision, FollowUp
from app.builds.models import Build, SealedPack
from app.builds.rules import PackState
from app.conformance.models import CheckRun
from app.core import clock
from app.core.db import new_id
from app.core.jobs.queue import queue_of
from app.core.uploads import Upload, Uploads
from app.deliveries.cue_counts.service import update_take_counts
from app.deliveries.models import Adoption, Delivery, DryStem, Handoff, SourceFile, Take, TrayAction
from app.deliveries.rules import SourceFileKind, TakeState, TrayActionKind
from app.notifications.models import Mail
from app.projects.models import CreditLine, Deputy, Engagement, Project, ProjectMember
from app.projects.queries import current_spec
from app.projects.rules import EngagementKind
from app.projects.service import create_project
from app.renders.models import Batch, MasterExport, Picture, Reel, Render, RenderSet
from app.renders.rules import RenderState
from app.reviews.models import ChangeRequest, ChecklistItem, Comment
from app.sound_lists.models import Cue, Question, SpokenPlaceholder, Stem
from tests.house.audit_objects import add_audit
from tests.house.contract_objects import add_contract
from tests.house.library_objects import add_library
from tests.house.link_objects import add_links
from tests.house.posting_objects import add_posting
from tests.house.reference_objects import add_reference
from tests.house.reports import report, report_file
from tests.house.roster_objects import add_roster_entry
from tests.house.scene_objects import add_scene
from tests.house.share_objects import add_shares
from tests.house.voice_objects import add_voice_line
from tests.house.webhook_objects import add_webhook
from tests.support.server import RunningServer, World

TOMORROW = timedelta(days=1)
FILE = b"the bytes of a sound"
PASSWORD = "correct horse battery"


class House(World):
    """A studio with one of everything; `ids` is keyed by the names that paths give to their parameters."""

    def __init__(self, server: RunningServer) -> None:
        super().__init__(server)
        store = server.runtime.store
        self.sha256, self.file_bytes = store.put(self.studio_id, [FILE]).sha256, len(FILE)
        self.links: dict[str, str] = {}
        self.desk_secret = ""
        with server.runtime.database.writing() as session:
            self.rival_id = self._person(session, "A second sound designer")
            session.get_one(Person, self.designer_id).password_hash = _password_hash()
            session.add(PersonPicture(person_id=self.approver_id, sha256="0" * 64, content=b"RIFF"))
            self._add_all(session)
            self._add_outsiders(session)
        unfinished = Uploads(server.runtime.database, store).create(
            studio_id=self.studio_id,
            owner_id=self.designer_id,
            scope=str(self.ids["delivery_id"]),
            file_name="shield_hit.wav",
            length=len(FILE),
            max_length=len(FILE),
        )
        self.ids["upload_id"] = unfinished.id

    def _add_all(self, session: Session) -> None:
        of = {"studio_id": self.studio_id, "project_id": self.project_id}
        engagement = Engagement(**of, designer_id=self.rival_id, kind=EngagementKind.CONTRACT)
        cue = Cue(**of, number=1, position=1, name="Shield hit", file_name="shield_hit")
        session.add_all([engagement, cue, ProjectMember(**of, person_id=self.approver_id)])
        session.flush()
        delivery = Delivery(**of, designer_id=self.designer_id, number=1)
        question = Question(**of, cue_id=cue.id, text="What hits the shield?", asked_by=self.designer_id)
        session.add_all([delivery, question, Stem(**of, cue_id=cue.id, variation=1, stem="shield_hit")])
        session.flush()
        spent, self.finished_upload = self._finished(session, delivery), self._finished(session, delivery)
        take = Take(
            **of,
            delivery_id=delivery.id,
            designer_id=self.designer_id,
            upload_id=spent.id,
            cue_id=cue.id,
            number=2,
            state=TakeState.CONFORMING,
            file_name="shield_hit.wav",
            master_sha256=self.sha256,
            master_bytes=len(FILE),
        )
        changed = Take(
            **of,
            delivery_id=delivery.id,
            designer_id=self.designer_id,
            cue_id=cue.id,
            number=1,
            state=TakeState.CHANGE_REQUESTED,
            file_name="shield_hit.wav",
            master_sha256=self.sha256,
            master_bytes=len(FILE),
        )
        dry_stem = DryStem(
            **of,
            delivery_id=delivery.id,
            stem="shield_hit",
            file_name="shield_hit__dry.wav",
            sha256=self.sha256,
            file_bytes=len(FILE),
        )
        tray_action = TrayAction(**of, kind=TrayActionKind.MOVED, done_by=self.designer_id, takes=[])
        adoption = Adoption(**of, folder="Sounds", files=[], opened_by=self.producer_id)
        session.add_all([take, changed, dry_stem, tray_action, adoption])
        session.flush()
        source_file = SourceFile(
            **of,
            take_id=take.id,
            upload_id=spent.id,
            kind=SourceFileKind.SESSION,
            file_name="shield_hit.rpp",
            sha256=self.sha256,
            file_bytes=len(FILE),
        )
        handoff = Handoff(
            **of,
            cue_id=cue.id,
            from_id=self.designer_id,
            done_percent=75,
            missing="The tail.",
            written_by=self.designer_id,
        )
        session.add_all([source_file, handoff])
        update_take_counts(session, cue.id)
        spec = current_spec(session, self.project_id)
        picture = Picture(
            studio_id=self.studio_id,
            sound_sha256=self.sha256,
            duration_s=1.0,
            peaks_sha256=self.sha256,
            spectrum_sha256=self.sha256,
            preview_sha256=self.sha256,
            preview_media_type="audio/wav",
            thumb={"points": 1, "min": [0], "max": [0], "rms": [0]},
            facts={"sample_rate_hz": 44_100, "bit_depth": 16, "channels": 1, "frames": 44_100},
        )
        render = Render(
            **of,
            take_id=take.id,
            target="game",
            key="0" * 64,
            state=RenderState.MADE,
            sha256=self.sha256,
            pcm_sha256=self.sha256,
            file_bytes=len(FILE),
        )
        draft = ChangeRequest(**of, cue_id=cue.id, take_id=take.id, text="Duller.", written_by=self.approver_id)
        deputy = Deputy(
            **of,
            person_id=self.approver_id,
            deputy_id=self.producer_id,
            from_on=date(2999, 1, 1),  # no deputy is active today
            until_on=date(2999, 1, 2),
            named_by=self.producer_id,
        )
        credit_line = CreditLine(**of, role="Voice", name="A performer", added_by=self.producer_id)
        session.add_all([deputy, credit_line])
        item = ChecklistItem(**of, category="", text="No clicks", place=0, written_by=self.producer_id)
        session.add(item)
        comment = Comment(**of, take_id=take.id, text="Loud.", written_by=self.designer_id, decides=False)
        note = Comment(**of, take_id=changed.id, text="Long.", written_by=self.reviewer_id, decides=False)
        build = Build(**of, label="1.0", files=0, rejected=0, warnings=0, report=report())
        batch = Batch(**of, number=1)
        pack = SealedPack(**of, target="game", number=1, sealed_by=self.producer_id)
        pack.state, pack.sealed_at = PackState.SEALED, clock.now()
        reel = Reel(
            **of,
            cue_id=cue.id,
            key="0" * 64,
            gap_ms=500,
            crossfade_ms=0,
            with_slates=True,
            takes=[{"take_id": str(take.id), "preview_sha256": self.sha256, "variation": 1, "number": 1}],
            file_name="shield_hit_reel.wav",
            sha256=self.sha256,
            file_bytes=len(FILE),
        )
        export = MasterExport(**of, take_id=take.id, key="0" * 64, provenance={}, file_name="shield_hit.wav")
        export.sha256, export.file_bytes = self.sha256, len(FILE)
        mail = Mail(
            studio_id=self.studio_id,
            topic="link",
            recipient="nobody@example.test",
            subject="A link",
            lines=["A link."],
            event_ids=[],
            sealed_at=clock.now(),
            failure="no server answered",
        )
        run = CheckRun(
            **of,
            take_id=take.id,
            spec_id=spec.id,
            key="0" * 64,
            verdict="conforming",
            pcm_sha256=self.sha256,
            report=report_file(),
            tool_version="1",
        )
        sets = RenderSet(take_id=take.id, studio_id=self.studio_id, spec_id=spec.id, edition=1)
        follow_up = FollowUp(**of, question="naming", text="Which separator?", asked_by=self.designer_id)
        answers = {
            "genre": {
                "value": "A platformer",
                "is_unknown": False,
                "note": "",
                "revision": 1,
                "answered_by": str(self.producer_id),
                "answered_at": clock.now().isoformat(),
            }
        }
        session.add(
            SpokenPlaceholder(
                **of,
                cue_id=cue.id,
                sha256=self.sha256,
                file_bytes=len(FILE),
                duration_s=1,
                recorded_by=self.producer_id,
            )
        )
        answered = Brief(**of, revision=1, answers=answers, changed_by=self.producer_id)
        version = BriefVersion(**of, number=1, answers=answers, published_by=self.producer_id)
        decision = Decision(
            **of, decided_on=date(2026, 11, 2), attended="Producer", text="No reverb.", written_by=self.producer_id
        )
        session.add_all([follow_up, answered, version, decision])
        session.add_all([picture, render, draft, comment, note, build, batch, pack, reel, export, mail, run, sets])
        posting_secret = new_secret()
        hiring = add_posting(
            session,
            studio_id=self.studio_id,
            project_id=self.project_id,
            secret=posting_secret,
            made_by=self.producer_id,
            designer_id=self.designer_id,
            sample=self.finished_upload,
        )
        references = add_reference(
            session, {"studio_id": self.studio_id, "project_id": self.project_id}, cue_id=cue.id, sha256=self.sha256,
            file_bytes=len(FILE), added_by=self.producer_id, opened_by=self.designer_id,
        )  # fmt: skip
        roster = add_roster_entry(
            session, studio_id=self.studio_id, added_by=self.producer_id, sha256=self.sha256, file_bytes=len(FILE)
        )
        voice = add_voice_line(
            session, {"studio_id": self.studio_id, "project_id": self.project_id}, sha256=self.sha256,
            file_bytes=len(FILE), added_by=self.producer_id,
        )  # fmt: skip
        scene = add_scene(
            session, of, take_id=take.id, sha256=self.sha256, file_bytes=len(FILE), changed_by=self.producer_id
        )
        audit = add_audit(session, of, cue_id=cue.id, producer_id=self.producer_id, designer_id=self.designer_id)
        webhook = add_webhook(session, studio_id=self.studio_id, created_by=self.producer_id)
        links = add_links(session, of, self, posting_secret)
        shares = add_shares(session, of, take.id, self)
        library = add_library(session, of, take_id=take.id, person_id=self.designer_id)
        contract = add_contract(session, of, cue.id, self)
        token = self._token(session, self.project_id, list(Scope))
        session.flush()
        self.ids: dict[str, Any] = {
            "studio_id": self.studio_id,
            "project_id": self.project_id,
            "person_id": self.approver_id,
            "deputy_id": deputy.id,
            "credit_line_id": credit_line.id,
            "checklist_item_id": item.id,
            "part": "designer",
            "version": 1,
            "fact": "size",
            "cue_id": cue.id,
            "question_id": question.id,
            "follow_up_id": follow_up.id,
            "decision_id": decision.id,
            "kit_key": "platformer",
            "delivery_id": delivery.id,
            "take_id": take.id,
            "source_file_id": source_file.id,
            "handoff_id": handoff.id,
            "designer_id": self.rival_id,
            "picture_id": picture.id,
            "render_id": render.id,
            "reel_id": reel.id,
            "master_export_id": export.id,
            "tray_action_id": tray_action.id,
            "adoption_id": adoption.id,
            "change_request_id": draft.id,
            "comment_id": comment.id,
            "note_id": note.id,
            "build_id": build.id,
            "batch_id": batch.id,
            "pack_id": pack.id,
            "mail_id": mail.id,
            "redline_number": 1,
            "kind": ContractKind.SINGLE.value,
            "engagement_id": engagement.id,
            "token_id": token[0].id,
            "job_id": str(new_id()),
            **contract,
            **links,
            **hiring,
            **references,
            **audit,
            **scene,
            **voice,
            **shares,
            **library,
            **roster,
            **webhook,
        }
        queue_of(session).enqueue(
            session,
            "house.rest",
            {},
            key=self.ids["job_id"],
            studio_id=self.studio_id,
            delay_s=TOMORROW.total_seconds(),
        )

    def _add_outsiders(self, session: Session) -> None:
        """Make the tokens: of another studio's project, and of this one with every scope or with one."""
        stranger = actor_for_person(session, self.stranger_id)
        (elsewhere,) = stranger.roles
        project = create_project(session, stranger, elsewhere, name="Elsewhere", cue_prefix="EW")
        self.foreign_secret = self._token(session, project.id, list(Scope))[1]
        self.own_secret = self._token(session, self.project_id, list(Scope))[1]
        self.secret_with = {scope: self._token(session, self.project_id, [scope])[1] for scope in Scope}

    def _finished(self, session: Session, delivery: Delivery) -> Upload:
        upload = Upload(
            studio_id=self.studio_id,
            owner_id=self.designer_id,
            scope=str(delivery.id),
            file_name="shield_hit.wav",
            length=len(FILE),
            sha256=self.sha256,
            finished_at=clock.now(),
        )
        session.add(upload)
        session.flush()
        return upload

    @staticmethod
    def _token(session: Session, project_id: UUID, scopes: list[Scope]) -> tuple[Token, str]:
        project = session.get_one(Project, project_id)
        return add_token(
            session,
            studio_id=project.studio_id,
            project_id=project_id,
            created_by=project.created_by,
            name="CI",
            scopes=scopes,
        )

    def build(self, secret: str) -> Client:
        """Return a client that carries a token."""
        client = self.server.browser()
        client.headers["Authorization"] = f"Bearer {secret}"
        return client

    @cached_property
    def rival(self) -> Client:
        """The browser of a designer who is engaged on the same project, and made none of it."""
        return self.signed_in(self.rival_id)

    @cached_property
    def operator(self) -> Client:
        """The browser of an operator who belongs to no studio."""
        with self.server.runtime.database.writing() as session:
            person_id = self._person(session, "Operator")
            session.add(Operator(person_id=person_id))
        return self.signed_in(person_id)

    @cached_property
    def guest(self) -> Client:
        """A browser that has opened the invitation's link and nothing else."""
        client = self.server.browser()
        client.get("/v1/session")
        assert client.get(f"/v1/invitations/{self.links['invitations']}").status_code == 200
        return client


@cache
def _password_hash() -> str:
    return hash_of(PASSWORD)
