"""What the approval of a palette answers."""

from datetime import datetime

from app.accounts.schemas import PersonBrief
from app.core.web.http import Schema


class PaletteApprovalRead(Schema):
    """The approval of a palette as a set."""

    approver: PersonBrief
    created_at: datetime
