"""A contract whose two versions are as long as versions may be, and differ everywhere."""

import random
from uuid import UUID

import sqlalchemy as sa
from sqlalchemy.orm import Session

from app.agreements.clauses.rules import Clause
from app.agreements.drafts.comparison import MAX_CHARS
from app.agreements.models import Contract, ContractVersion
from app.agreements.rules import ContractKind, ReleaseClause
from app.projects.models import Engagement
from tests.support.server import World

SIDE_CHARS = MAX_CHARS // 2 - 1_000
WORDS = [f"w{number}" for number in range(3_000)]


def random_text(seed: int, words: list[str] = WORDS, between: str = "\n\n") -> str:
    """Return the longest text that is compared, of words drawn at random."""
    draw = random.Random(seed)
    return between.join(" ".join(draw.choices(words, k=200)) for _ in range(3_000))[:SIDE_CHARS]


def add_two_long_versions(session: Session, world: World) -> UUID:
    """Add a draft of the world's designer in two versions, and return its id."""
    engagement = session.scalars(sa.select(Engagement).where(Engagement.designer_id == world.designer_id)).one()
    of = {"studio_id": world.studio_id, "project_id": world.project_id}
    contract = Contract(
        **of,
        engagement_id=engagement.id,
        designer_id=world.designer_id,
        number=1,
        title="Effects",
        kind=ContractKind.SINGLE,
        currency="USD",
        release_clause=ReleaseClause.PER_CUE,
        created_by=world.producer_id,
    )
    session.add(contract)
    session.flush()
    for number in (1, 2):
        session.add(
            ContractVersion(
                **of,
                contract_id=contract.id,
                number=number,
                clauses=[Clause("terms", "Terms", "long").as_row()],
                terms={},
                text=random_text(number),
                text_sha256="",
                created_by=world.producer_id,
            )
        )
    return contract.id
