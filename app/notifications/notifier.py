"""News for the people of one project."""

from dataclasses import dataclass

from sqlalchemy.orm import Session

from app.core.runtime import Runtime
from app.notifications import service
from app.notifications.audio_excerpts.rules import SpotLine
from app.notifications.rules import Fold
from app.projects.models import Project
from app.sound_lists.models import Cue
from app.sound_lists.rules import label

GATHERED_LONGER = frozenset({"approved"})  # nobody waits for them, and a review takes a while
REVIEW_DELAYS = 15  # times as long as other news


@dataclass(frozen=True)
class Notifier:
    """Writes mails about one project for one event; news of a topic is gathered into one mail a person."""

    runtime: Runtime
    session: Session
    project: Project
    event_id: str

    def fold(self, one: str, many: str) -> Fold:
        """Return the subject of news that comes in numbers, each line of it one."""
        return Fold(self.project.name, one, many)

    def notify(
        self, recipient: str, topic: str, subject: str | Fold, *lines: str | SpotLine, page: str | None = None
    ) -> None:
        """Add lines to the recipient's mail on the topic; without a page the link leads to the desk."""
        service.write_news(
            self.session,
            event_id=self.event_id,
            studio_id=self.project.studio_id,
            project_id=self.project.id,
            topic=f"{topic}:{self.project.id}",
            recipient=recipient,
            subject=subject if isinstance(subject, Fold) else f"{self.project.name}: {subject}",
            lines=lines,
            base_url=self.runtime.settings.base_url,
            path="/desk" if page is None else f"/projects/{self.project.id}/{page}".rstrip("/"),
            delay_s=self.runtime.settings.digest_delay_s * (REVIEW_DELAYS if topic in GATHERED_LONGER else 1),
        )


def cue_label(project: Project, cue: Cue | None) -> str:
    """Return number and name of a cue, as mails call it."""
    return f"{label(project.cue_prefix, cue.number)} {cue.name}" if cue else "a file without a cue"
