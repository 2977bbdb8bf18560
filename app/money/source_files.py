"""Source files that contracts hand over."""

from sqlalchemy.orm import Session

from app.agreements.clauses.terms import SourceFiles
from app.agreements.plan.queries import terms_of
from app.deliveries.signals import SourceFilesAgreed, Work
from app.money.covering import newest_contracts


def answer_source_files(session: Session, asked: SourceFilesAgreed) -> dict[Work, bool]:
    """Return whether the newest contract of some work hands its source files over, to the room that asks for it."""
    return {
        work: terms_of(session, contract).source_files is SourceFiles.HANDED_OVER
        for work, contract in newest_contracts(session, asked.work).items()
    }
