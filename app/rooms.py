"""Which rooms there are, and who listens to which event."""

from fastapi import APIRouter

from app.accounts.endpoints import router as accounts
from app.accounts.me_endpoints import router as me
from app.accounts.sign_up_endpoints import router as sign_up
from app.accounts.studio_endpoints import router as studios
from app.builds.endpoints import router as builds
from app.builds.manifest_endpoints import router as manifests
from app.conformance.endpoints import router as conformance
from app.contracts.endpoints import router as contracts
from app.contracts.money_endpoints import router as money
from app.contracts.template_endpoints import router as contract_templates
from app.dashboards.endpoints import router as dashboards
from app.deliveries.endpoints import router as deliveries
from app.notifications.endpoints import router as notifications
from app.operations.endpoints import router as operations
from app.projects.endpoints import router as projects
from app.projects.spec_endpoints import router as specs
from app.renders.endpoints import router as renders
from app.reviews.endpoints import router as reviews
from app.sound_lists.endpoints import router as sound_lists

ROUTERS: tuple[APIRouter, ...] = (
    accounts,
    sign_up,
    me,
    studios,
    projects,
    specs,
    sound_lists,
    money,
    contract_templates,
    contracts,
    deliveries,
    conformance,
    renders,
    reviews,
    builds,
    manifests,
    dashboards,
    notifications,
    operations,
)
JOB_MODULES = (
    "app.deliveries.jobs",
    "app.conformance.jobs",
    "app.renders.jobs",
    "app.reviews.jobs",
    "app.builds.jobs",
    "app.notifications.jobs",
)
PARSERS = ("app.sound_lists.sheets", "app.contracts.template_files", "audio_checks.spec")  # of what strangers send
SUBSCRIBERS: dict[str, tuple[str, ...]] = {
    "archive.received": ("deliveries.unpack_archive",),
    "take.received": ("renders.prepare_take",),
    "takes.checked": ("notifications.tell_checks",),
    "take.rendered": ("renders.hear_take",),
    "palette.changed": ("renders.hear_palette",),
    "mend.asked": ("conformance.make_mend",),
    "mend.made": ("renders.draw_mend",),
    "dry_stem.changed": ("conformance.compare_takes",),
    "take.waived": ("renders.make_renders",),
    "spec.changed": ("conformance.recheck_takes", "renders.renew_renders"),
    "cue.changed": ("conformance.recheck_takes", "renders.renew_renders"),
    "placeholders.asked": ("builds.make_stand_ins",),
    "pack.asked": ("builds.seal_pack",),
    "manifest.asked": ("builds.hear_pack",),
    "batch.asked": ("renders.plan_batch",),
    "reel.asked": ("renders.make_reel",),
    "master_export.asked": ("renders.export_master",),
    "list.revised": ("notifications.tell_list_revised",),
    "question.asked": ("notifications.tell_question",),
    "question.answered": ("notifications.tell_answer",),
    "changes.sent": ("notifications.tell_changes",),
    "take.approved": ("notifications.tell_approval", "builds.hear_take"),
    "cue.cut": ("notifications.tell_cut",),
    "contract.sent": ("notifications.tell_contract",),
    "contract.change_asked": ("notifications.tell_contract",),
    "contract.agreed": ("notifications.tell_contract", "reviews.adopt_accepted"),
    "decider.reminded": ("notifications.tell_reminder",),
    "cue.accepted_by_silence": ("notifications.tell_silence",),
    "build.posted": ("notifications.tell_build",),
    "designer.invited": ("notifications.mail_link",),
    "member.invited": ("notifications.mail_link",),
    "password.reset_asked": ("notifications.mail_link",),
    "address.verification_asked": ("notifications.mail_link",),
    "sign_up.asked": ("notifications.mail_link",),
    "mail.written": ("notifications.send_mail",),
}
PATIENT_JOBS = frozenset({"builds.hear_take"})
