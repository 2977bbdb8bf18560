"""The bodies of messages: our own JSON, and what Slack, Discord and Teams take."""

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from typing import Any

from app.webhooks.rules import WebhookEvent, WebhookForm

MAX_TEXT_CHARS = 1_500  # Discord takes 2,000 with the link


@dataclass(frozen=True)
class Message:
    """An event, in one or more lines, with the page that it is about."""

    event: WebhookEvent
    text: str
    url: str
    data: Mapping[str, Any] = field(default_factory=dict)


def body_of(form: WebhookForm, message: Message, at: datetime) -> str:
    """Return the body of a message as the receiver takes it."""
    text = message.text if len(message.text) <= MAX_TEXT_CHARS else f"{message.text[: MAX_TEXT_CHARS - 1]}…"
    match form:
        case WebhookForm.SLACK:
            content: dict[str, Any] = {"text": f"{_for_slack(text)}\n{message.url}"}
        case WebhookForm.DISCORD:
            # Nobody is called by an @ that a text holds.
            content = {"content": f"{text}\n{message.url}", "allowed_mentions": {"parse": []}}
        case WebhookForm.TEAMS:
            content = {"type": "message", "attachments": [_adaptive_card(text, message.url)]}
        case _:
            data = {**message.data, "text": message.text, "url": message.url}
            content = {"type": message.event.value, "timestamp": at.isoformat(), "data": data}
    return json.dumps(content, ensure_ascii=False)


def _for_slack(text: str) -> str:
    """Return a text in which Slack finds no markup, no link and nobody to call."""
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def _adaptive_card(text: str, url: str) -> dict[str, Any]:
    return {
        "contentType": "application/vnd.microsoft.card.adaptive",
        "content": {
            "$schema": "http://adaptivecards.io/schemas/adaptive-card.json",
            "type": "AdaptiveCard",
            "version": "1.4",
            "body": [{"type": "TextBlock", "text": text, "wrap": True}],
            "actions": [{"type": "Action.OpenUrl", "title": "Open in Soundlist", "url": url}],
        },
    }
