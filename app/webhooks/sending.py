"""One attempt at a call: signed, sent outside any transaction, and written down."""

import time
from dataclasses import dataclass
from datetime import timedelta
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Studio
from app.accounts.rules import MembersSee
from app.core import clock, outgoing
from app.core.outgoing import AddressRefused, Answer, RequestFailed, Resolver
from app.core.runtime import Runtime
from app.notifications.kinds import declare_topics
from app.notifications.preferences.rules import News
from app.notifications.queries import address_of, producer_addresses
from app.notifications.service import write_news
from app.webhooks import queries
from app.webhooks.models import Webhook, WebhookAttempt, WebhookCall
from app.webhooks.rules import DISABLED_AFTER, CallState, is_delivered, pause_after, signature
from app.webhooks.service import schedule, valid_secrets

AGENT = "Soundlist-Webhooks/1"
declare_topics({"webhooks": News.LIST})


@dataclass(frozen=True)
class Outcome:
    """The outcome of an attempt."""

    took_ms: int
    answer: Answer | None = None
    problem: str = ""


def send(runtime: Runtime, call_id: UUID, attempt: UUID, *, resolver: Resolver = outgoing.resolve) -> None:
    """Send a call while this attempt is the one that is due, and schedule the next where it fails."""
    settings = runtime.settings
    with runtime.database.reading() as session:
        call = queries.call_to_send(session, call_id, attempt, locked=False)
        if call is None:
            return
        url, body = call.webhook.url, call.body.encode()
        secrets = valid_secrets(settings.secret_key.get_secret_value(), call.webhook, clock.now())
    now = clock.now()
    headers = {
        "Content-Type": "application/json",
        "User-Agent": AGENT,
        "webhook-id": str(call_id),
        "webhook-timestamp": str(int(now.timestamp())),
        "webhook-signature": signature(secrets, str(call_id), now, body),
    }
    outcome = _post(url, body, headers, resolver, may_be_localhost=settings.webhook_localhost)
    with runtime.database.writing() as session:
        call = queries.call_to_send(session, call_id, attempt, locked=True)
        if call is not None:
            _record(runtime, session, call, outcome)


def _post(url: str, body: bytes, headers: dict[str, str], resolver: Resolver, *, may_be_localhost: bool) -> Outcome:
    began = time.monotonic()
    answer, problem = None, ""
    try:
        answer = outgoing.post(url, body, headers, resolver=resolver, may_be_localhost=may_be_localhost)
    except (AddressRefused, RequestFailed) as error:
        problem = str(error)
    took_ms = int((time.monotonic() - began) * 1000)
    if answer is not None and not is_delivered(answer.status):
        is_redirect = 300 <= answer.status < 400
        problem = f"answered {answer.status}" + ("; redirects are not followed" if is_redirect else "")
    return Outcome(took_ms, answer, problem)


def _record(runtime: Runtime, session: Session, call: WebhookCall, outcome: Outcome) -> None:
    webhook, now = call.webhook, clock.now()
    call.tries += 1
    call.tried_at, call.took_ms, call.problem = now, outcome.took_ms, outcome.problem
    call.status = outcome.answer.status if outcome.answer else None
    call.answer = outcome.answer.beginning if outcome.answer else ""
    call.next_attempt = call.next_at = None
    session.add(
        WebhookAttempt(
            studio_id=call.studio_id,
            call_id=call.id,
            tried_at=now,
            took_ms=call.took_ms,
            status=call.status,
            answer=call.answer,
            problem=call.problem,
        )
    )
    if not outcome.problem:
        call.state, webhook.failing_since = CallState.DELIVERED, None
        return
    webhook.failing_since = webhook.failing_since or now
    pause = pause_after(call.tries)
    if now - webhook.failing_since >= DISABLED_AFTER:
        call.state, webhook.disabled_at = CallState.FAILED, now
        _notify_disabled(runtime, session, webhook, call)
    elif pause is None:
        call.state = CallState.FAILED
    else:
        schedule(session, call, delay_s=pause.total_seconds())
        call.next_at = now + pause


def _producers_told(session: Session, webhook: Webhook) -> set[str]:
    """Return the addresses of the producers who see a webhook: where they see their own, one of all is its maker's."""
    if webhook.project_id is None and session.get_one(Studio, webhook.studio_id).members_see is MembersSee.OWN:
        return {address_of(session, webhook.created_by)}
    return producer_addresses(session, webhook.studio_id, webhook.project_id)


def _notify_disabled(runtime: Runtime, session: Session, webhook: Webhook, call: WebhookCall) -> None:
    host = webhook.url.split("/")[2]
    line = (
        f"{host} has taken no message for {DISABLED_AFTER // timedelta(days=1)} days ({call.problem}), so nothing is "
        "sent there any more. Enable the webhook again once it answers; its log has what was not delivered."
    )
    for recipient in sorted(_producers_told(session, webhook)):
        write_news(
            session,
            event_id=f"{webhook.id}:{webhook.disabled_at}",
            studio_id=webhook.studio_id,
            project_id=webhook.project_id,
            topic=f"webhooks:{webhook.id}",
            recipient=recipient,
            subject="a webhook is disabled",
            lines=[line],
            base_url=runtime.settings.base_url,
            path=f"/webhooks?studio={webhook.studio_id}",
            delay_s=runtime.settings.digest_delay_s,
        )
