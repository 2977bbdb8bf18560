"""Voice lines, read from the database; callers have checked access."""

from collections import defaultdict
from collections.abc import Collection, Iterable, Sequence
from uuid import UUID

from sqlalchemy import exists, select, tuple_
from sqlalchemy.orm import Session, joinedload

from app.conformance.models import CheckRun
from app.core.in_array import in_array
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.renders.models import Picture
from app.reviews.models import ChangeRequest
from app.sound_lists.models import Cue
from app.voice_lines.models import (
    Casting,
    Character,
    Performer,
    Release,
    VoiceLine,
    VoiceSettings,
    VoiceText,
    VoiceTextVersion,
)
from app.voice_lines.rules import TakeFacts, TextFrom


def settings_of(session: Session, project_id: UUID) -> VoiceSettings | None:
    """Return the settings of a project's voice lines; None where nobody has set any."""
    return session.scalar(select(VoiceSettings).where(VoiceSettings.project_id == project_id))


def characters_of(session: Session, project_id: UUID) -> Sequence[Character]:
    """Return the characters of a project by name."""
    return session.scalars(select(Character).where(Character.project_id == project_id).order_by(Character.folded)).all()


def character_by_id(session: Session, character_id: UUID) -> Character | None:
    """Return a character."""
    return session.get(Character, character_id)


def castings_of(session: Session, project_id: UUID) -> Sequence[Casting]:
    """Return the castings of characters by language, with the performers."""
    of_project = select(Casting).where(Casting.project_id == project_id).options(joinedload(Casting.performer))
    return session.scalars(of_project.order_by(Casting.language)).all()


def casting_of(session: Session, character_id: UUID, language: str) -> Casting | None:
    """Return the casting of a character in a language; None where nobody is named."""
    is_casting = (Casting.character_id == character_id, Casting.language == language)
    return session.scalar(select(Casting).where(*is_casting).options(joinedload(Casting.performer)))


def performers_of(session: Session, project_id: UUID) -> Sequence[Performer]:
    """Return the performers of a project by name."""
    return session.scalars(select(Performer).where(Performer.project_id == project_id).order_by(Performer.folded)).all()


def lines_of(session: Session, project_id: UUID) -> Sequence[VoiceLine]:
    """Return the lines of a script in their order, with their characters."""
    of_project = select(VoiceLine).where(VoiceLine.project_id == project_id).options(joinedload(VoiceLine.character))
    return session.scalars(of_project.order_by(VoiceLine.position, VoiceLine.id)).all()


def lines_around(session: Session, line: VoiceLine) -> Sequence[VoiceLine]:
    """Return a line with the one before and the one after it in the script, with their characters."""
    sort_key = tuple_(VoiceLine.position, VoiceLine.id)
    of_project = (
        select(VoiceLine)
        .where(VoiceLine.project_id == line.project_id)
        .options(joinedload(VoiceLine.character))
        .limit(1)
    )
    before = of_project.where(sort_key < (line.position, line.id)).order_by(
        VoiceLine.position.desc(), VoiceLine.id.desc()
    )
    after = of_project.where(sort_key > (line.position, line.id)).order_by(VoiceLine.position, VoiceLine.id)
    return [*session.scalars(before), line, *session.scalars(after)]


def line_by_id(session: Session, line_id: UUID) -> VoiceLine | None:
    """Return a line with its character."""
    return session.scalar(select(VoiceLine).where(VoiceLine.id == line_id).options(joinedload(VoiceLine.character)))


def texts_of(
    session: Session,
    project_id: UUID,
    languages: Collection[str] | None = None,
    line_ids: Collection[UUID] | None = None,
) -> Sequence[VoiceText]:
    """Return the texts of a project with their cues: of all lines and languages, or of those named."""
    of_cue = joinedload(VoiceText.cue).load_only(Cue.number, Cue.name, Cue.state)  # a cue has much that no line shows
    query = select(VoiceText).where(VoiceText.project_id == project_id).options(of_cue)
    if languages is not None:
        query = query.where(VoiceText.language.in_(languages))
    if line_ids is not None:
        query = query.where(VoiceText.line_id.in_(line_ids))
    return session.scalars(query.order_by(VoiceText.language, VoiceText.id)).all()


def text_locked(session: Session, line_id: UUID, language: str) -> VoiceText | None:
    """Return the text of a line in a language, locked until the transaction ends."""
    of_line = select(VoiceText).where(VoiceText.line_id == line_id, VoiceText.language == language)
    return session.scalar(of_line.with_for_update().execution_options(populate_existing=True))


def text_of_cue(session: Session, cue_id: UUID) -> VoiceText | None:
    """Return the text that a cue is for, with its line; None for a cue that is not a voice line."""
    with_line = joinedload(VoiceText.line).joinedload(VoiceLine.character)
    return session.scalar(select(VoiceText).where(VoiceText.cue_id == cue_id).options(with_line))


def languages_of(session: Session, project_id: UUID) -> list[str]:
    """Return the languages that a script has texts in."""
    return sorted(session.scalars(select(VoiceText.language).where(VoiceText.project_id == project_id).distinct()))


def languages_by_cue(session: Session, project_id: UUID) -> dict[UUID, str]:
    """Return the language of each cue that is a voice line."""
    spoken = select(VoiceText.cue_id, VoiceText.language).where(VoiceText.project_id == project_id)
    return dict(session.execute(spoken).all())


def newest_version(session: Session, text: VoiceText) -> VoiceTextVersion:
    """Return the newest version of a text."""
    of_it = (VoiceTextVersion.text_id == text.id, VoiceTextVersion.number == text.newest_number)
    return session.scalars(select(VoiceTextVersion).where(*of_it)).one()


def versions_of(session: Session, text_ids: Collection[UUID]) -> dict[UUID, list[TextFrom]]:
    """Return versions of texts with their starts, the oldest first."""
    version = VoiceTextVersion
    query = select(version.text_id, version.text, version.written_at, version.takes_fit_at.is_not(None))
    by_text: dict[UUID, list[TextFrom]] = defaultdict(list)
    ordered = query.where(in_array(version.text_id, "text_ids")).order_by(version.number)
    for text_id, text, written_at, takes_fit in session.execute(ordered, {"text_ids": list(text_ids)}):
        by_text[text_id].append(TextFrom(text, written_at, bool(takes_fit)))
    return by_text


def takes_of(
    session: Session, project_id: UUID, cue_ids: Iterable[UUID], designer_id: UUID | None
) -> dict[UUID, list[TakeFacts]]:
    """Return the takes of cues with their lengths, those of one designer where one is given."""
    drawn = (Picture.studio_id == Take.studio_id) & (Picture.sound_sha256 == Take.master_sha256)
    facts = select(Take.cue_id, Take.id, Take.variation, Take.number, Take.state, Take.received_at, Picture.duration_s)
    query = facts.outerjoin(Picture, drawn).where(Take.project_id == project_id, in_array(Take.cue_id, "cue_ids"))
    if designer_id is not None:
        query = query.where(Take.designer_id == designer_id)
    takes: dict[UUID, list[TakeFacts]] = defaultdict(list)
    for cue_id, take_id, variation, number, state, received_at, duration_s in session.execute(
        query, {"cue_ids": list(cue_ids)}
    ):
        if cue_id is not None and number is not None:
            takes[cue_id].append(TakeFacts(take_id, variation, number, state, received_at, duration_s))
    return takes


def variations_of(session: Session, cue_ids: Iterable[UUID]) -> dict[UUID, int]:
    """Return the variations of cues."""
    query = select(Cue.id, Cue.variations).where(in_array(Cue.id, "cue_ids"))
    return dict(session.execute(query, {"cue_ids": list(cue_ids)}).all())


def cues_with_takes(session: Session, project_id: UUID) -> set[UUID]:
    """Return the cues of voice lines for which a take was delivered that is not set aside."""
    of_cue = (Take.cue_id == VoiceText.cue_id, Take.state != TakeState.SET_ASIDE)
    delivered = select(VoiceText.cue_id).where(VoiceText.project_id == project_id, exists().where(*of_cue))
    return set(session.scalars(delivered))


def requested_changes(session: Session, take_ids: Collection[UUID]) -> dict[UUID, str]:
    """Return the newest change request that was sent on each take."""
    sent = select(ChangeRequest.take_id, ChangeRequest.text).where(
        in_array(ChangeRequest.take_id, "take_ids"), ChangeRequest.feedback_id.is_not(None)
    )
    return dict(session.execute(sent.order_by(ChangeRequest.id), {"take_ids": list(take_ids)}).all())


def first_errors(session: Session, take_ids: Collection[UUID]) -> dict[UUID, str]:
    """Return the first error that the checks found in each take."""
    findings = select(CheckRun.take_id, CheckRun.report["findings"]).where(
        in_array(CheckRun.take_id, "take_ids"), CheckRun.is_current
    )
    return {
        take_id: next((finding["message"] for finding in run_findings or () if finding["severity"] == "error"), "")
        for take_id, run_findings in session.execute(findings, {"take_ids": list(take_ids)})
    }


def releases_of(session: Session, project_id: UUID) -> Sequence[Release]:
    """Return the releases of a project that are not removed, the one added last first."""
    kept = select(Release).where(Release.project_id == project_id, Release.removed_at.is_(None))
    return session.scalars(kept.options(joinedload(Release.adder)).order_by(Release.id.desc())).all()


def release_by_id(session: Session, release_id: UUID, *, locked: bool = False) -> Release | None:
    """Return a release that is not removed."""
    kept = select(Release).where(Release.id == release_id, Release.removed_at.is_(None))
    if locked:
        kept = kept.with_for_update().execution_options(populate_existing=True)
    return session.scalar(kept)
