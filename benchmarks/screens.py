"""What screens ask for: measured by benchmarks.scale, and held to indexes by tests/app/test_plans.py."""

from dataclasses import dataclass

from fastapi.testclient import TestClient

from app.accounts.authentication import CSRF_HEADER, SESSION_COOKIE, csrf_token
from app.settings import Settings
from benchmarks.studios import Made


@dataclass(frozen=True)
class Screen:
    """One request, and who makes it."""

    path: str
    by: str = "approver"
    paged: bool = False  # further pages of it are asked for too

    def secret(self, made: Made) -> str:
        """Return the sign-in of the client."""
        return {"approver": made.approver_secret, "producer": made.producer_secret, "designer": made.designer_secret}[
            self.by
        ]

    def address(self, made: Made) -> str:
        """Return what is asked for in a project that was made."""
        return self.path.format(project=made.project_id, studio=made.studio_id)


SCREENS = {
    "review queue": Screen("/v1/review-queue?project_id={project}", paged=True),
    "review queue of all projects": Screen("/v1/review-queue"),
    "how many wait for review": Screen("/v1/review-queue/count?project_id={project}"),
    "sound list": Screen("/v1/projects/{project}/sound-list", paged=True),
    "where its cues stand": Screen("/v1/projects/{project}/sound-list/progress", paged=True),
    "where a designer's cues stand": Screen("/v1/projects/{project}/sound-list/progress", "designer"),
    "how many cues stand where": Screen("/v1/projects/{project}/sound-list/counts"),
    "search": Screen("/v1/projects/{project}/find?q={{words}}"),
    "search in all projects": Screen("/v1/find?q={{words}}"),
    "a designer's search": Screen("/v1/find?q={{words}}", "designer"),
    "reasons": Screen("/v1/projects/{project}/reasons"),
    "reasons of a category": Screen("/v1/projects/{project}/reasons?category=weapon"),
    "a designer's reasons": Screen("/v1/projects/{project}/reasons", "designer"),
    "versions with a reason": Screen("/v1/projects/{project}/reasons/versions?kind=pick&reason=Cleanest"),
    "judged lately": Screen("/v1/projects/{project}/judged-lately"),
    "today": Screen("/v1/projects/{project}/today"),
    "desk": Screen("/v1/projects/{project}/desk", "designer"),
    "project page": Screen("/v1/projects/{project}/overview"),
    "takes": Screen("/v1/projects/{project}/takes", paged=True),
    "takes without a cue": Screen("/v1/projects/{project}/takes?unmatched=true"),
    "drafts": Screen("/v1/projects/{project}/change-requests?state=draft"),
    "changes": Screen("/v1/projects/{project}/change-requests"),
    "questions": Screen("/v1/projects/{project}/questions?only_open=true"),
    "deliveries": Screen("/v1/projects/{project}/deliveries"),
    "what a studio keeps": Screen("/v1/studios/{studio}/storage", "producer"),
}
WORDS = ("laser", "door close", "SC-77", "water", "too bright", "wing_land", "zzz", "metal hull", "music", "step")


def sign_in(client: TestClient, settings: Settings, secret: str) -> TestClient:
    """Have a client send what a browser with this sign-in sends."""
    client.cookies.set(SESSION_COOKIE, secret)
    client.headers[CSRF_HEADER] = csrf_token(settings, secret)
    return client
