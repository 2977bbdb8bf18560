"""The jobs of the commercial rooms, and what they follow: contracts, money, change orders, and hiring.

SOUNDLIST_COMMERCIAL=false leaves them out, with their endpoints.
"""

from typing import Any

from app.agreements.deemed_acceptance.cues import answer_last_days
from app.agreements.record.project_changes import (
    record_answer,
    record_decisions,
    record_list_revision,
    record_question,
    record_spec_version,
)
from app.agreements.signing.service import answer_needed_people, end_signers_of_member
from app.agreements.sources import ensure_stated_to_accept
from app.core.events import Handler, Receiver, Signal
from app.deliveries import signals as deliveries
from app.hiring.postings.service import end_links_of_member as revoke_posting_links
from app.hiring.roster.reel import ensure_may_upload
from app.money import verdicts
from app.money.calendar import end_links_of_member as revoke_calendars
from app.money.covering import answer_contract_references
from app.money.downloads import answer_closed_downloads
from app.money.ledger.service import charge_deposits
from app.money.source_files import answer_source_files
from app.projects import signals as projects
from app.reviews import signals as reviews

JOB_MODULES = (
    "app.hiring.jobs",
    "app.agreements.deemed_acceptance.jobs",
    "app.agreements.signing.jobs",
    "app.money.jobs",
    "app.amendments.jobs",
)
NOTICE_MODULES = ("app.notifications.contract_jobs", "app.notifications.day_jobs", "app.notifications.hiring_jobs")
CHORES = (
    "agreements.apply_deemed_acceptance",
    "money.charge_retainers",
    "amendments.settle_ended",
    "agreements.seal_unsealed",
    "notifications.mail_heads",
    "notifications.remind_of_days",
)
SUBSCRIBERS: dict[str, tuple[str, ...]] = {
    "contract.agreed": ("money.add_accepted_cues", "agreements.seal_contract"),
    "payment.recorded": (),
    "posting.shared": ("notifications.mail_link",),
    "sample.added": ("hiring.check_sample",),
    "signing_code.asked": ("notifications.mail_link",),
}
HANDLERS: dict[str, tuple[Handler, ...]] = {
    "contract.agreed": (record_decisions, charge_deposits),  # in the transaction of the second signature
    "list.revised": (record_list_revision,),
    "question.asked": (record_question,),
    "question.answered": (record_answer,),
    "spec.changed": (record_spec_version,),
    "member.changed": (end_signers_of_member, revoke_posting_links, revoke_calendars),  # the first may refuse it
}
RECEIVERS: dict[type[Signal[Any]], tuple[Receiver, ...]] = {
    projects.NeededPeople: (answer_needed_people,),
    deliveries.WorkDone: (verdicts.record_work,),
    deliveries.SourcesDue: (ensure_stated_to_accept,),
    deliveries.DownloadsClosed: (answer_closed_downloads,),
    deliveries.SourceFilesAgreed: (answer_source_files,),
    deliveries.ContractsNamed: (answer_contract_references,),
    deliveries.ReelUpload: (ensure_may_upload,),
    reviews.TakeJudged: (verdicts.record_verdict,),
    reviews.CueDecided: (verdicts.settle_decision,),
    reviews.CueCut: (verdicts.settle_cut,),
    reviews.RoundCounted: (verdicts.price_round,),
    reviews.CommentWritten: (verdicts.record_comment,),
    reviews.LastDaysAsked: (answer_last_days,),
}
