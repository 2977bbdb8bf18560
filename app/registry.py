"""The rooms, and the subscribers of each event."""

from fastapi import APIRouter

from app.accounts.calendars.endpoints import router as calendars
from app.accounts.email_changes.endpoints import router as email_changes
from app.accounts.endpoints import router as accounts
from app.accounts.invoice_details.endpoints import router as invoice_details
from app.accounts.me_endpoints import router as me
from app.accounts.passkeys.endpoints import router as passkeys
from app.accounts.pictures.endpoints import router as my_picture
from app.accounts.providers.endpoints import router as sign_in_providers
from app.accounts.second_factors.endpoints import router as second_factors
from app.accounts.security_log.endpoints import router as security_events
from app.accounts.security_log.service import (
    record_joining,
    record_member_change,
    record_personal_event,
    record_second_factor,
    record_token,
)
from app.accounts.sign_up_endpoints import router as sign_up
from app.accounts.studio_endpoints import router as studios
from app.agreements.clauses.template_endpoints import router as contract_templates
from app.agreements.drafts.award_endpoints import router as awards
from app.agreements.drafts.version_endpoints import router as contract_versions
from app.agreements.endpoints import router as contracts
from app.agreements.record.endpoints import router as verifying
from app.agreements.record.project_changes import record_list_revision, record_spec_version
from app.agreements.redlines.endpoints import router as contract_redlines
from app.agreements.signing.endpoints import router as contract_signing
from app.agreements.signing.service import end_signers_of_member
from app.amendments.endpoints import router as amendments
from app.briefs.endpoints import router as briefs
from app.builds.audits.endpoints import router as audits
from app.builds.clearance.endpoints import router as clearance
from app.builds.contract_archive.endpoints import router as handovers
from app.builds.endpoints import router as builds
from app.builds.game_files.endpoints import router as game_files
from app.builds.libraries.endpoints import router as sound_libraries
from app.builds.listening.endpoints import router as listening
from app.builds.packs.manifest_endpoints import router as manifests
from app.builds.same_sounds.endpoints import router as same_sounds
from app.conformance.endpoints import router as conformance
from app.core.events import Handler
from app.dashboards.credits.endpoints import router as credit_lists
from app.dashboards.due.endpoints import router as due_calendars
from app.dashboards.endpoints import router as dashboards
from app.dashboards.hours.endpoints import router as project_hours
from app.dashboards.live_changes.endpoints import router as events
from app.dashboards.pictures.endpoints import router as pictures
from app.deliveries.endpoints import router as deliveries
from app.deliveries.sources.service import ensure_stated_to_invoice
from app.hiring.bids.endpoints import router as bids
from app.hiring.bids.sample_endpoints import router as bid_samples
from app.hiring.endpoints import router as hiring
from app.hiring.postings.service import end_links_of_member as revoke_posting_links
from app.hiring.roster.endpoints import router as roster
from app.money.calendar import end_links_of_member as revoke_calendars
from app.money.endpoints import router as money
from app.money.invoices.electronic_invoice_endpoints import router as electronic_invoices
from app.money.ledger.service import charge_deposits
from app.money.work.endpoints import router as work
from app.notifications.endpoints import router as notifications
from app.notifications.notices.endpoints import router as notices
from app.notifications.preferences.endpoints import router as mail_preferences
from app.notifications.service import drop_news_of_member
from app.operations.endpoints import router as operations
from app.operations.erasure.endpoints import router as erasures
from app.operations.retention.endpoints import router as master_retention
from app.projects.approval.endpoints import router as approval
from app.projects.budgets.endpoints import router as budgets
from app.projects.endpoints import router as projects
from app.projects.namings import end_namings
from app.projects.specs.endpoints import router as specs
from app.references.endpoints import router as references
from app.references.spotting_endpoints import router as spotting
from app.renders.endpoints import router as renders
from app.reviews.adoptions.endpoints import router as adoptions
from app.reviews.checklists.endpoints import router as checklists
from app.reviews.endpoints import router as reviews
from app.reviews.listened.endpoints import router as heard_takes
from app.reviews.reasons.endpoints import router as reasons
from app.scenes.endpoints import router as scenes
from app.shares.guest_endpoints import router as guests
from app.shares.guest_link_endpoints import router as guest_links
from app.shares.guest_links import end_links_of_member as revoke_guest_links
from app.shares.playlist_endpoints import router as playlists
from app.shares.view_endpoints import router as saved_views
from app.sound_lists.categories.endpoints import router as category_guess
from app.sound_lists.coverage.endpoints import router as coverage
from app.sound_lists.endpoints import router as sound_lists
from app.sound_lists.kits.endpoints import router as kits
from app.sound_lists.matrix.endpoints import router as matrices
from app.sound_lists.names.endpoints import router as refused_names
from app.sound_lists.names.spec_endpoints import router as saved_specs
from app.sound_lists.own_columns.endpoints import router as own_columns
from app.sound_lists.people.endpoints import router as cue_people
from app.sound_lists.spoken_placeholders.endpoints import router as spoken_placeholders
from app.voice_lines.endpoints import router as voice_lines
from app.voice_lines.release_endpoints import router as voice_releases
from app.webhooks.endpoints import router as webhooks
from app.webhooks.rules import EVENTS
from app.webhooks.service import disable_webhooks_of_member, queue_event

ROUTERS: tuple[APIRouter, ...] = (
    accounts,
    sign_up,
    me,
    email_changes,
    passkeys,
    sign_in_providers,
    second_factors,
    my_picture,
    studios,
    security_events,
    calendars,
    invoice_details,
    projects,
    budgets,
    approval,
    specs,
    briefs,
    sound_lists,
    refused_names,
    saved_specs,
    category_guess,
    spoken_placeholders,
    coverage,
    kits,
    matrices,
    own_columns,
    cue_people,
    references,
    spotting,
    hiring,
    bid_samples,
    bids,
    roster,
    awards,
    money,
    work,
    electronic_invoices,
    contract_templates,
    contracts,
    contract_signing,
    contract_versions,
    contract_redlines,
    verifying,
    amendments,
    deliveries,
    conformance,
    renders,
    reviews,
    heard_takes,
    checklists,
    reasons,
    guest_links,
    guests,
    playlists,
    saved_views,
    voice_lines,
    voice_releases,
    adoptions,
    scenes,
    builds,
    audits,
    listening,
    clearance,
    same_sounds,
    sound_libraries,
    handovers,
    manifests,
    game_files,
    dashboards,
    due_calendars,
    credit_lists,
    project_hours,
    pictures,
    events,
    notifications,
    notices,
    mail_preferences,
    webhooks,
    operations,
    erasures,
    master_retention,
)
JOB_MODULES = (
    "app.projects.jobs",
    "app.hiring.jobs",
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
    "app.agreements.signing.jobs",
    "app.money.jobs",
    "app.amendments.jobs",
    "app.notifications.contract_jobs",
    "app.notifications.day_jobs",
    "app.notifications.game_jobs",
    "app.notifications.hiring_jobs",
    "app.notifications.jobs",
    "app.notifications.mail_jobs",
    "app.notifications.notices.jobs",
    "app.notifications.security_jobs",
    "app.webhooks.jobs",
    "app.operations.jobs",
)
PARSERS = (
    "app.accounts.pictures.drawing",
    "PIL.ImageOps",
    "app.deliveries.adoptions.game_projects",
    "app.sound_lists.sheets.rules",
    "app.sound_lists.spoken_placeholders.rules",
    "audio_checks.placeholders.recorded",
    "app.voice_lines.script_text",
    "app.hiring.roster.files",
    "app.agreements.clauses.template_files",
    "app.agreements.signing.seal_files",
    "app.agreements.word.file",
    "app.builds.libraries.sheet",
    "audio_checks.audit.same_sound",
    "audio_checks.spec.delivery_spec",
)  # of what strangers send
SUBSCRIBERS: dict[str, tuple[str, ...]] = {
    "reference.added": ("references.draw_preview",),
    "guest_copy.asked": ("shares.make_guest_copy",),
    "archive.received": ("deliveries.unpack_archive",),
    "take.received": ("renders.prepare_take",),
    "takes.checked": ("notifications.notify_checks",),
    "take.in_review": ("builds.compare_take",),
    "take.fingerprinted": ("builds.compare_with_libraries",),
    "library.added": ("builds.compare_library",),
    "take.returned": (),
    "take.rendered": ("renders.measure_timbre",),
    "palette.changed": ("renders.measure_palette",),
    "fix.asked": ("conformance.make_fix",),
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
    "list.revised": ("notifications.notify_list_revised",),
    "question.asked": ("notifications.notify_question",),
    "question.answered": ("notifications.notify_answer",),
    "change.requested": ("reviews.send_change_request",),
    "changes.sent": ("notifications.notify_changes",),
    "note.answered": ("notifications.notify_reply",),
    "person.mentioned": ("notifications.notify_mention",),
    "take.approved": ("notifications.notify_approval", "builds.fingerprint_take", "builds.compare_take"),
    "folder.adopted": ("reviews.check_adopted_takes",),
    "cue.cut": ("notifications.notify_cut",),
    "contract.notice_given": ("notifications.notify_contract",),
    "contract.settled": ("notifications.notify_contract",),
    "change_order.proposed": ("notifications.notify_contract",),
    "change_order.agreed": ("notifications.notify_contract",),
    "contract.sent": ("notifications.notify_contract",),
    "contract.change_requested": ("notifications.notify_contract",),
    "contract.signed_once": ("notifications.notify_signature",),
    "amendment.signer_is_next": ("notifications.notify_signer",),
    "work.logged": ("notifications.notify_work_logged",),
    "work.refused": ("notifications.notify_work_refused",),
    "invoice.drafted": (),
    "invoice.issued": ("notifications.notify_invoice",),
    "payment.recorded": (),
    "designer.joined": ("notifications.notify_joined",),
    "contract.agreed": (
        "notifications.notify_contract",
        "reviews.add_accepted_cues",
        "agreements.seal_contract",
    ),
    "approver.reminded": ("notifications.notify_reminder",),
    "cue.deemed_accepted": ("notifications.notify_deemed_acceptance",),
    "build.posted": ("notifications.notify_build",),
    "audit.posted": ("notifications.notify_audit",),
    "game_task.added": ("notifications.notify_game_task",),
    "approver.joined": ("projects.name_invited_approver",),
    "posting.shared": ("notifications.mail_link",),
    "posting.awarded": ("notifications.notify_award",),
    "sample.added": ("hiring.check_sample",),
    "bid.sent": ("notifications.notify_bid",),
    "posting_question.asked": ("notifications.notify_posting_question",),
    "posting_question.answered": ("notifications.notify_posting_answer",),
    "designer.invited": ("notifications.mail_link",),
    "member.invited": ("notifications.mail_link",),
    "member.joined": (),
    "member.changed": (),
    "password.reset_asked": ("notifications.mail_link",),
    "address.verification_asked": ("notifications.mail_link",),
    "old_address.asked": ("notifications.mail_link",),
    "new_address.asked": ("notifications.mail_link",),
    "address.changed": ("notifications.notify_new_address",),
    "sign_up.asked": ("notifications.mail_link",),
    "signing_code.asked": ("notifications.mail_link",),
    "password.changed": ("notifications.notify_new_password",),
    "device.signed_in": ("notifications.notify_new_device",),
    "second_factor.changed": ("notifications.notify_second_factor",),
    "desk_token.made": ("notifications.notify_desk_token",),
    "token.made": ("notifications.notify_token",),
    "sign_in_provider.changed": ("notifications.notify_sign_in_provider",),
    "producer.named": ("notifications.notify_producer",),
    "mail.written": ("notifications.send_mail",),
}
HANDLERS: dict[str, tuple[Handler, ...]] = {
    "contract.agreed": (charge_deposits,),  # in the transaction of the second signature
    "list.revised": (record_list_revision,),
    "spec.changed": (record_spec_version,),
    # Who leaves, or has other roles now, loses at once what the membership gave; the first two may refuse it.
    "member.changed": (
        end_namings,
        end_signers_of_member,
        revoke_posting_links,
        revoke_guest_links,
        revoke_calendars,
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
    "invoice.drafted": (ensure_stated_to_invoice,),  # an invoice without the sources that the contract wants is refused
}
for _event in EVENTS:  # what webhooks are called for
    HANDLERS[_event] = (*HANDLERS.get(_event, ()), queue_event)
LOW_PRIORITY_JOBS = frozenset(
    {
        *("builds.fingerprint_take", "builds.compare_take"),
        *("builds.compare_with_libraries", "builds.compare_library"),
    }
)
