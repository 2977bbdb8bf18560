"""A person's notices."""

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import BadCursor, DbSession, Page, cursor_of, problems, uuid_cursor
from app.notifications.notices import service as notices
from app.notifications.schemas import InAppNoticeRead, NoticesMark, UnreadRead

router = APIRouter(prefix="/v1", tags=["notifications"])
PAGE = 50


@router.get("/me/notices", responses=problems(BadCursor))
def list_my_notices(
    session: DbSession, cursor: str | None = None, actor: Actor = allows(Audience.PERSON)
) -> Page[InAppNoticeRead]:
    """Return the caller's notices, newest first; read ones are kept for 90 days."""
    notice_rows = notices.page(session, actor, before=uuid_cursor(cursor), limit=PAGE + 1)
    shown = notice_rows[:PAGE]
    following = cursor_of(shown[-1].id) if len(notice_rows) > PAGE else None
    return Page(items=[InAppNoticeRead.model_validate(notice) for notice in shown], next=following)


@router.get("/me/notices/unread")
def count_my_unread_notices(session: DbSession, actor: Actor = allows(Audience.PERSON)) -> UnreadRead:
    """Count the notices that the caller has not read."""
    return UnreadRead(unread=notices.unread(session, actor))


@router.post("/me/notices/read", status_code=204)
def mark_my_notices_read(body: NoticesMark, session: DbSession, actor: Actor = allows(Audience.PERSON)) -> None:
    """Mark notices as read: those named, and all up to one."""
    notices.mark_read(session, actor, ids=body.ids, up_to=body.up_to)
