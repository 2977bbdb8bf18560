"""News for the people of one project."""

from dataclasses import dataclass

from sqlalchemy.orm import Session

from app.kit.runtime import Runtime
from app.notifications import service
from app.notifications.spot_rules import SpotLine
from app.projects.models import Project
from app.sound_lists.models import Cue
from app.sound_lists.rules import label


@dataclass(frozen=True)
class Notifier:
    """Writes mails about one project for one event; news of a topic is gathered into one mail a person."""

    runtime: Runtime
    session: Session
    project: Project
    event_id: str

    def notify(self, recipient: str, topic: str, subject: str, *lines: str | SpotLine, page: str | None = None) -> None:
        """Add lines to the recipient's mail on the topic; without a page the link leads to the desk."""
        service.write_news(
            self.session,
            event_id=self.event_id,
            studio_id=self.project.studio_id,
            project_id=self.project.id,
            topic=f"{topic}:{self.project.id}",
            recipient=recipient,
            subject=f"{self.project.name}: {subject}",
            lines=lines,
            base_url=self.runtime.settings.base_url,
            path="/desk" if page is None else f"/projects/{self.project.id}/{page}".rstrip("/"),
            delay_s=self.runtime.settings.digest_delay_s,
        )


def cue_label(project: Project, cue: Cue | None) -> str:
    """Return number and name of a cue, as mails call it."""
    return f"{label(project.cue_prefix, cue.number)} {cue.name}" if cue else "a file without a cue"
