"""Things ended by a member's departure or new roles in a studio, and those another person must take over first."""

from collections.abc import Collection, Iterator
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.errors import MemberNotFound
from app.accounts.queries import live_tokens_of, membership, studio_invitations
from app.accounts.rules import Actor, Role
from app.accounts.service import ensure_producer_of
from app.agreements.signing.service import contracts_to_sign
from app.core.db import bypass_row_policies
from app.hiring.queries import postings_linked_by
from app.operations import queries
from app.operations.schemas import DepartureItem, DepartureKind
from app.projects.namings import namings_ending
from app.shares.queries import open_links_by
from app.webhooks.queries import enabled_webhooks_by

OTHER_PROJECT = "in a project that you are not in"


def departure(
    session: Session, actor: Actor, studio_id: UUID, person_id: UUID, roles: Collection[Role]
) -> list[DepartureItem]:
    """Return the rights and access that a member loses with other roles, or by leaving; raise MemberNotFound."""
    ensure_producer_of(session, actor, studio_id)
    if membership(session, studio_id, person_id) is None:
        raise MemberNotFound(f"no person {person_id} in this studio")
    names = queries.project_names(session, studio_id)
    with bypass_row_policies(session):  # what ends is in projects too that the producer is not in
        items = list(_items(session, studio_id, person_id, frozenset(roles)))
    return [
        DepartureItem(
            kind=kind,
            id=id_ if project_id is None or project_id in names else None,
            name=name if project_id is None or project_id in names else OTHER_PROJECT,
            project_id=project_id if project_id in names else None,
            project_name=names.get(project_id),
        )
        for kind, id_, name, project_id in items
    ]


def _items(
    session: Session, studio_id: UUID, person_id: UUID, roles: frozenset[Role]
) -> Iterator[tuple[DepartureKind, UUID, str, UUID | None]]:
    namings = namings_ending(session, studio_id, person_id, roles)
    for project in namings.approves:
        yield DepartureKind.APPROVER, project.id, project.name, project.id
    if Role.PRODUCER not in roles:
        for contract in contracts_to_sign(session, studio_id, person_id):
            yield DepartureKind.SIGNER, contract.id, contract.title, contract.project_id
        for member_invitation in studio_invitations(session, studio_id):
            if member_invitation.invited_by == person_id:
                yield DepartureKind.INVITATION, member_invitation.id, member_invitation.email, None
    for project in namings.leads:
        yield DepartureKind.LIAISON, project.id, project.name, project.id
    for category in namings.categories:
        yield DepartureKind.CATEGORY_APPROVER, category.id, category.category, category.project_id
    for deputy in namings.deputies:
        other = deputy.person if deputy.deputy_id == person_id else deputy.deputy
        yield DepartureKind.DEPUTY, deputy.id, other.name, deputy.project_id
    for invitation in namings.invitations:
        yield DepartureKind.INVITATION, invitation.id, invitation.email, invitation.project_id
    if not roles:
        for token in live_tokens_of(session, studio_id, person_id):
            yield DepartureKind.TOKEN, token.id, token.name, token.project_id
        for link in open_links_by(session, studio_id, person_id):
            yield DepartureKind.GUEST_LINK, link.id, link.title, link.project_id
        for posting in postings_linked_by(session, studio_id, person_id):
            yield DepartureKind.POSTING_LINK, posting.id, posting.title, posting.project_id
        for webhook in enabled_webhooks_by(session, studio_id, person_id):
            yield DepartureKind.WEBHOOK, webhook.id, webhook.url, webhook.project_id
        for engagement in queries.engagements_of(session, studio_id, person_id):
            yield DepartureKind.ENGAGEMENT, engagement.id, engagement.kind.value, engagement.project_id
