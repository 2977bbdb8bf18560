"""The jobs of the rooms, and who follows each event and signal; their endpoints are in app/routers.py.

Those of the rooms that SOUNDLIST_COMMERCIAL switches off are in app/commercial.py.
"""

import pkgutil
from collections.abc import Mapping
from importlib import import_module
from typing import Any, NamedTuple, TypeVar

from app import commercial, notifications
from app.accounts.security_log.service import (
    record_joining,
    record_member_change,
    record_personal_event,
    record_second_factor,
    record_token,
)
from app.core import events
from app.core.events import Handler, Receiver, Signal
from app.notifications.kinds import subscribers_of
from app.notifications.service import drop_news_of_member
from app.projects.namings import end_namings
from app.reviews.reasons.service import record_reasons
from app.reviews.signals import VerdictsOnFile
from app.shares.guest_links import end_links_of_member as revoke_guest_links
from app.webhooks.rules import EVENTS
from app.webhooks.service import disable_webhooks_of_member, queue_event

Key = TypeVar("Key")
Follower = TypeVar("Follower")
JOB_MODULES = (
    "app.projects.jobs",
    "app.references.jobs",
    "app.deliveries.jobs",
    "app.conformance.jobs",
    "app.renders.take_jobs",
    "app.renders.batches.jobs",
    "app.renders.master_exports.jobs",
    "app.renders.reels.jobs",
    "app.renders.timbre.jobs",
    "app.reviews.jobs",
    "app.shares.jobs",
    "app.scenes.jobs",
    "app.builds.jobs",
    "app.builds.libraries.jobs",
    "app.builds.same_sounds.jobs",
    "app.notifications.notices.jobs",
    "app.webhooks.jobs",
    "app.operations.jobs",
)
_NOTIFICATIONS = {f"app.notifications.{module.name}" for module in pkgutil.iter_modules(notifications.__path__)}
NOTICE_MODULES = tuple(sorted(name for name in _NOTIFICATIONS - {*commercial.NOTICE_MODULES} if name.endswith("jobs")))
PARSERS = (
    "app.accounts.pictures.drawing",
    "PIL.ImageOps",
    "app.deliveries.adoptions.game_projects",
    "app.sound_lists.sheets.rules",
    "app.sound_lists.spoken_placeholders.rules",
    "audio_checks.placeholders.recorded",
    "app.voice_lines.script_text",
    "app.hiring.roster.files",
    "icalendar",
    "app.agreements.clauses.template_files",
    "app.agreements.signing.seal_files",
    "app.agreements.word.file",
    "app.builds.libraries.sheet",
    "audio_checks.audit.same_sound",
    "audio_checks.spec.delivery_spec",
)  # of what strangers send
SUBSCRIBERS: dict[str, tuple[str, ...]] = {  # beside kinds of notices, which name their events themselves
    "reference.added": ("references.draw_preview",),
    "guest_copy.asked": ("shares.make_guest_copy",),
    "archive.received": ("deliveries.unpack_archive",),
    "take.received": ("renders.prepare_take",),
    "take.in_review": (),
    "library.added": ("builds.compare_library",),
    "take.returned": (),
    "take.rendered": ("renders.measure_timbre",),
    "palette.changed": ("renders.measure_palette",),
    "fix.asked": ("conformance.make_fix",),
    "split.asked": ("conformance.split_master",),
    "fix.made": ("renders.draw_fix",),
    "dry_stem.changed": ("conformance.compare_takes",),
    "take.waived": ("renders.make_renders",),
    "spec.changed": ("conformance.recheck_takes", "renders.update_renders"),
    "cue.changed": ("conformance.recheck_takes", "renders.update_renders"),
    "placeholder.said": ("builds.make_spoken_placeholders",),
    "placeholders.asked": ("builds.make_placeholder_files",),
    "pack.asked": ("builds.seal_pack",),
    "pack.made": (),
    "manifest.asked": ("builds.fingerprint_pack",),
    "batch.asked": ("renders.plan_batch",),
    "reel.asked": ("renders.make_reel",),
    "scene_sound.asked": ("scenes.measure_sound",),
    "comparison.asked": ("scenes.compare_sounds",),
    "master_export.asked": ("renders.export_master",),
    "change.requested": ("reviews.send_change_request",),
    "take.approved": ("builds.fingerprint_take", "builds.compare_take"),
    "folder.adopted": ("reviews.check_adopted_takes",),
    "approver.joined": ("projects.name_invited_approver",),
    "designer.invited": ("notifications.mail_link",),
    "member.invited": ("notifications.mail_link",),
    "member.joined": (),
    "member.changed": (),
    "password.reset_asked": ("notifications.mail_link",),
    "address.verification_asked": ("notifications.mail_link",),
    "old_address.asked": ("notifications.mail_link",),
    "new_address.asked": ("notifications.mail_link",),
    "sign_up.asked": ("notifications.mail_link",),
    "mail.written": ("notifications.send_mail",),
}
HANDLERS: dict[str, tuple[Handler, ...]] = {
    # Who leaves, or has other roles now, loses at once what the membership gave; the first may refuse it.
    "member.changed": (
        end_namings,
        revoke_guest_links,
        drop_news_of_member,
        disable_webhooks_of_member,
        record_member_change,
    ),
    # What the security log of each studio says.
    "password.changed": (record_personal_event,),
    "address.changed": (record_personal_event,),
    "desk_token.made": (record_personal_event,),
    "second_factor.changed": (record_second_factor,),
    "token.made": (record_token,),
    "member.joined": (record_joining,),
}
RECEIVERS: dict[type[Signal[Any]], tuple[Receiver, ...]] = {VerdictsOnFile: (record_reasons,)}
CHORES = (
    "server.sweep_uploads",
    "server.send_pending",
    "server.delete_finished_jobs",
    "server.delete_expired_rate_limits",
    "server.delete_old_security_events",
    "notifications.warn_of_token_ends",
    "notifications.notify_overdue_checks",
    "notifications.delete_old_notices",
    "webhooks.delete_old_calls",
    "operations.scrub_blobs",
    "operations.carry_out_erasures",
    "operations.end_masters",
)  # jobs that no event asks for
LOW_PRIORITY_JOBS = frozenset({"builds.fingerprint_take", "builds.compare_take", "builds.compare_library"})


class Rooms(NamedTuple):
    """The jobs of the rooms in use, and who follows their events and signals."""

    job_modules: tuple[str, ...]
    chores: tuple[str, ...]
    subscribers: dict[str, tuple[str, ...]]
    handlers: dict[str, tuple[Handler, ...]]
    receivers: dict[type[Signal[Any]], tuple[Receiver, ...]]

    def connect(self) -> None:
        """Have events and signals of this process reach who follows them."""
        events.connect(
            self.subscribers, handlers=self.handlers, receivers=self.receivers, low_priority=LOW_PRIORITY_JOBS
        )


def rooms_in_use(*, is_commercial: bool) -> Rooms:
    """Return the rooms of a server, with or without the commercial ones."""
    notices = (*NOTICE_MODULES, *commercial.NOTICE_MODULES) if is_commercial else NOTICE_MODULES
    for module in notices:
        import_module(module)
    webhooks: dict[str, tuple[Handler, ...]] = dict.fromkeys(EVENTS, (queue_event,))
    return Rooms(
        (*JOB_MODULES, *notices, *(commercial.JOB_MODULES if is_commercial else ())),
        (*CHORES, *(commercial.CHORES if is_commercial else ())),
        _merged(SUBSCRIBERS, commercial.SUBSCRIBERS if is_commercial else {}, subscribers_of(notices)),
        _merged(HANDLERS, commercial.HANDLERS if is_commercial else {}, webhooks),
        _merged(RECEIVERS, commercial.RECEIVERS if is_commercial else {}),
    )


def _merged(*followers: Mapping[Key, tuple[Follower, ...]]) -> dict[Key, tuple[Follower, ...]]:
    merged: dict[Key, tuple[Follower, ...]] = {}
    for by_key in followers:
        for key, of_key in by_key.items():
            merged[key] = (*merged.get(key, ()), *of_key)
    return merged
