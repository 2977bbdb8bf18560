"""The endpoints of the rooms; no worker imports them."""

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
from app.accounts.sign_up_endpoints import router as sign_up
from app.accounts.studio_endpoints import router as studios
from app.agreements.clauses.template_endpoints import router as contract_templates
from app.agreements.drafts.award_endpoints import router as awards
from app.agreements.drafts.version_endpoints import router as contract_versions
from app.agreements.endpoints import router as contracts
from app.agreements.record.endpoints import router as verifying
from app.agreements.redlines.endpoints import router as contract_redlines
from app.agreements.signing.endpoints import router as contract_signing
from app.amendments.endpoints import router as amendments
from app.briefs.endpoints import router as briefs
from app.briefs.kick_off.endpoints import router as kick_off
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
from app.dashboards.contract_endpoints import router as contract_dashboards
from app.dashboards.credits.endpoints import router as credit_lists
from app.dashboards.due.endpoints import router as due_calendars
from app.dashboards.effort.endpoints import router as efforts
from app.dashboards.endpoints import router as dashboards
from app.dashboards.hours.endpoints import router as project_hours
from app.dashboards.live_changes.endpoints import router as events
from app.dashboards.pictures.endpoints import router as pictures
from app.deliveries.endpoints import router as deliveries
from app.hiring.bids.endpoints import router as bids
from app.hiring.bids.sample_endpoints import router as bid_samples
from app.hiring.endpoints import router as hiring
from app.hiring.roster.endpoints import router as roster
from app.money.endpoints import router as money
from app.money.invoices.electronic_invoice_endpoints import router as electronic_invoices
from app.money.own_time.endpoints import router as own_time
from app.money.work.endpoints import router as work
from app.notifications.endpoints import router as notifications
from app.notifications.notices.endpoints import router as notices
from app.notifications.preferences.endpoints import router as mail_preferences
from app.operations.endpoints import router as operations
from app.operations.erasure.endpoints import router as erasures
from app.operations.retention.endpoints import router as master_retention
from app.operations.samples.endpoints import router as samples
from app.projects.approval.endpoints import router as approval
from app.projects.budgets.endpoints import router as budgets
from app.projects.endpoints import router as projects
from app.projects.members.endpoints import router as project_members
from app.projects.specs.endpoints import router as specs
from app.references.endpoints import router as references
from app.references.spotting_endpoints import router as spotting
from app.renders.endpoints import router as renders
from app.reviews.adoptions.endpoints import router as adoptions
from app.reviews.checklists.endpoints import router as checklists
from app.reviews.endpoints import router as reviews
from app.reviews.listened.endpoints import router as heard_takes
from app.reviews.palette_approvals.endpoints import router as palette_approvals
from app.reviews.reasons.endpoints import router as reasons
from app.scenes.endpoints import router as scenes
from app.shares.guest_endpoints import router as guests
from app.shares.guest_link_endpoints import router as guest_links
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

BASE_ROUTERS: tuple[APIRouter, ...] = (
    deliveries,  # the first that a request is compared with: an upload is the most frequent
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
    project_members,
    approval,
    specs,
    briefs,
    kick_off,
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
    conformance,
    renders,
    reviews,
    heard_takes,
    checklists,
    palette_approvals,
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
    manifests,
    game_files,
    dashboards,
    credit_lists,
    efforts,
    project_hours,
    pictures,
    events,
    notifications,
    notices,
    mail_preferences,
    webhooks,
    operations,
    erasures,
    samples,
)
COMMERCIAL_ROUTERS: tuple[APIRouter, ...] = (
    hiring,
    bid_samples,
    bids,
    roster,
    awards,
    money,
    own_time,
    work,
    electronic_invoices,
    contract_templates,
    contracts,
    contract_signing,
    contract_versions,
    contract_redlines,
    verifying,
    amendments,
    handovers,
    due_calendars,
    master_retention,
    contract_dashboards,
)  # of what SOUNDLIST_COMMERCIAL switches off
ROUTERS = (*BASE_ROUTERS, *COMMERCIAL_ROUTERS)
