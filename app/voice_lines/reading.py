"""Voice lines as they are shown: each with its text, its take, what is said before and after, and its state."""

from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import NamedTuple
from uuid import UUID

from sqlalchemy.orm import Session

from app.projects.service import ProjectAccess
from app.sound_lists.rules import CueState, label
from app.voice_lines import queries
from app.voice_lines.models import Casting, VoiceLine, VoiceText
from app.voice_lines.rules import (
    DEFAULT_LANGUAGE,
    DEFAULT_TOLERANCE_PERCENT,
    PICK_UPS,
    LineState,
    LineStatus,
    TakeFacts,
    approved_duration_s,
    file_statuses,
    is_length_off,
    length_percent,
    line_status,
    reason_of,
)
from app.voice_lines.schemas import (
    CharacterBrief,
    LineCue,
    LineFile,
    LineTake,
    PickUpsRead,
    SpokenBeside,
    StateCount,
    VoiceLineRead,
    VoiceLines,
)
from audio_checks import game_path, stem_in_language, stems_of

PAGE = 200
NOT_TRANSLATED = (LineStatus(LineState.NO_TEXT),)


class LanguageTexts(NamedTuple):
    """The texts of one language, and what was delivered of them."""

    texts: Mapping[UUID, VoiceText]  # by line
    statuses: Mapping[UUID, Sequence[LineStatus]]  # of the files of each line

    def state_of(self, line_id: UUID) -> LineState:
        """Return the state of a line."""
        return line_status(self.statuses.get(line_id, NOT_TRANSLATED)).state


class TakeReasons(NamedTuple):
    """The reasons to record again, by take."""

    requested: Mapping[UUID, str]
    errors: Mapping[UUID, str]

    def of_line(self, line: VoiceLine, statuses: Sequence[LineStatus]) -> str:
        """Return why files of a line must be recorded, with their names where the line has several."""
        stems: dict[str, list[str]] = defaultdict(list)
        for stem, status in zip(stems_of("", line.file_name, len(statuses)), statuses, strict=True):
            stems[self._of_file(status)].append(stem)
        if len(statuses) == 1:
            return next(iter(stems))
        return "; ".join(f"{reason} ({', '.join(files)})" for reason, files in stems.items() if reason)

    def _of_file(self, status: LineStatus) -> str:
        take_id = status.take.id if status.take else None
        requested, error = (texts.get(take_id, "") if take_id else "" for texts in self)
        return reason_of(status, requested=requested, error=error)


class ScriptReader:
    """Reads the script of one project, as one person sees it: all of its lines, or one with those beside it."""

    def __init__(self, session: Session, access: ProjectAccess, *, around: VoiceLine | None = None) -> None:
        self._session = session
        self._around = around
        self._read_texts: dict[str, dict[UUID, VoiceText]] = {}
        self._access = access
        self._project = access.project
        settings = queries.settings_of(session, access.project.id)
        self.original_language = settings.original_language if settings else DEFAULT_LANGUAGE
        self.tolerance_percent = settings.tolerance_percent if settings else DEFAULT_TOLERANCE_PERCENT

    @cached_property
    def lines(self) -> Sequence[VoiceLine]:
        """The lines in the order of the script."""
        if self._around is not None:
            return queries.lines_around(self._session, self._around)
        return queries.lines_of(self._session, self._project.id)

    def _texts(self, language: str) -> dict[UUID, VoiceText]:
        """Return the texts in one language by their lines, read once."""
        if language in self._read_texts:
            return self._read_texts[language]
        only = [line.id for line in self.lines] if self._around is not None else None
        texts = queries.texts_of(self._session, self._project.id, {language}, only)
        self._read_texts[language] = {text.line_id: text for text in texts}
        return self._read_texts[language]

    @cached_property
    def languages(self) -> list[str]:
        """The languages that the script has texts in, the original first."""
        languages = queries.languages_of(self._session, self._project.id)
        return sorted(languages, key=lambda language: (language != self.original_language, language))

    def in_language(self, language: str) -> list[VoiceLineRead]:
        """Return every line in one language."""
        return self._reads(language, self._said(language), self.lines)

    def _reads(self, language: str, language_texts: LanguageTexts, lines: Sequence[VoiceLine]) -> list[VoiceLineRead]:
        """Return some lines in one language."""
        judged = [
            (status.take.id, status.state)
            for line in lines
            for status in language_texts.statuses.get(line.id, NOT_TRANSLATED)
            if status.take
        ]
        requested = queries.requested_changes(self._session, [take_id for take_id, _ in judged])
        errors = queries.first_errors(
            self._session, [take_id for take_id, state in judged if state is LineState.RETURNED]
        )
        reasons = TakeReasons(requested, errors)
        return [self._read(line, language, language_texts, reasons) for line in lines]

    def page(
        self, language: str, *, state: LineState | None, character_id: UUID | None, search: str, start: int
    ) -> VoiceLines:
        """Return the lines of one language that fit a filter, from a place on."""
        language_texts = self._said(language)
        states = {line.id: language_texts.state_of(line.id) for line in self.lines}
        counts = Counter(states.values())
        words = search.casefold().split()
        matching = [
            line
            for line in self.lines
            if (state is None or states[line.id] is state)
            and (character_id is None or line.character_id == character_id)
            and (not words or self._has_words(line, language_texts.texts.get(line.id), words))
        ]
        return VoiceLines(
            language=language,
            lines=self._reads(language, language_texts, matching[start : start + PAGE]),
            next=start + PAGE if len(matching) > start + PAGE else None,
            total=len(matching),
            counts=[
                StateCount(state=line_state, lines=counts[line_state]) for line_state in LineState if counts[line_state]
            ],
            may_change=may_change(self._access),
        )

    def _has_words(self, line: VoiceLine, text: VoiceText | None, words: Sequence[str]) -> bool:
        original = self._original.get(line.id)
        texts = (
            line.key,
            line.character.name,
            line.scene,
            text and text.text,
            original and original.text,
            line.direction,
        )
        searched = " ".join(part for part in texts if part).casefold()
        return all(word in searched for word in words)

    def pick_ups(self, language: str | None, character_id: UUID | None) -> PickUpsRead:
        """Return the pick-ups of the next session: by language, then character, in the order of the script."""
        languages = [language] if language else self.languages
        reads: list[VoiceLineRead] = []
        for language in languages:
            language_texts = self._said(language)
            stale_lines = [
                line
                for line in self.lines
                if language_texts.state_of(line.id) in PICK_UPS
                and (character_id is None or line.character_id == character_id)
            ]
            reads += self._reads(language, language_texts, stale_lines)
        order = {language: rank for rank, language in enumerate(languages)}
        reads.sort(
            key=lambda read: (order[read.language], read.character.name.casefold())
        )  # stable: keeps the script's
        return PickUpsRead(lines=reads, languages=list(dict.fromkeys(read.language for read in reads)))

    @cached_property
    def _neighbours(self) -> dict[UUID, tuple[VoiceLine | None, VoiceLine | None]]:
        """The lines before and after each line, where they are in its scene."""
        neighbours: dict[UUID, tuple[VoiceLine | None, VoiceLine | None]] = {}
        for index, line in enumerate(self.lines):
            before = self.lines[index - 1] if index and self.lines[index - 1].scene == line.scene else None
            after = self.lines[index + 1] if index + 1 < len(self.lines) else None
            neighbours[line.id] = (before, after if after and after.scene == line.scene else None)
        return neighbours

    @cached_property
    def _original(self) -> dict[UUID, VoiceText]:
        return self._texts(self.original_language)

    @cached_property
    def _original_takes(self) -> dict[UUID, list[TakeFacts]]:
        """Return the takes of each line in the original language, by any designer."""
        cues = [text.cue_id for text in self._original.values()]
        takes = queries.takes_of(self._session, self._project.id, cues, None)
        return {line_id: takes[text.cue_id] for line_id, text in self._original.items()}

    @cached_property
    def _castings(self) -> dict[tuple[UUID, str], Casting]:
        castings = queries.castings_of(self._session, self._project.id)
        return {(casting.character_id, casting.language): casting for casting in castings}

    def _said(self, language: str) -> LanguageTexts:
        texts = self._texts(language)
        versions = queries.versions_of(self._session, [text.id for text in texts.values()])
        cues = [text.cue_id for text in texts.values()]
        takes = queries.takes_of(self._session, self._project.id, cues, self._access.only_designer_id)
        statuses = {
            line_id: file_statuses(
                takes[text.cue_id],
                versions[text.id],
                variations=text.cue.variations,
                is_cut=text.cue.state is CueState.CUT,
            )
            for line_id, text in texts.items()
        }
        return LanguageTexts(texts, statuses)

    def _read(
        self, line: VoiceLine, language: str, language_texts: LanguageTexts, reasons: TakeReasons
    ) -> VoiceLineRead:
        text = language_texts.texts.get(line.id)
        statuses = language_texts.statuses.get(line.id, NOT_TRANSLATED)
        status = line_status(statuses)
        take, casting = status.take, self._castings.get((line.character_id, language))
        before, after = self._neighbours[line.id]
        variation = statuses.index(status) + 1
        original_s = approved_duration_s(
            [original for original in self._original_takes.get(line.id, ()) if original.variation == variation]
        )
        is_translation = language != self.original_language
        percent = length_percent(take.duration_s if take else None, original_s) if is_translation else None
        original = self._original.get(line.id)
        return VoiceLineRead(
            id=line.id,
            key=line.key,
            character=CharacterBrief.model_validate(line.character),
            scene=line.scene,
            direction=line.direction,
            language=language,
            text=text.text if text else None,
            text_version=text.newest_number if text else None,
            original_text=original.text if original else None,
            before=self._beside(before),
            after=self._beside(after),
            path=_path(line, language),
            files=_files(line, language, statuses),
            cue=self._cue(text),
            state=status.state,
            reason=reasons.of_line(line, statuses),
            take=_take(take),
            recorded_text=status.recorded_text,
            original_duration_s=original_s,
            length_percent=percent,
            length_is_off=is_length_off(percent, self.tolerance_percent),
            performer=casting.performer.name if casting and casting.performer else None,
            directed_by=casting.directed_by if casting else "",
        )

    def _beside(self, line: VoiceLine | None) -> SpokenBeside | None:
        """Return a line of the same scene, in the original language, which every session reads."""
        text = self._original.get(line.id) if line else None
        return SpokenBeside(character=line.character.name, text=text.text) if line and text else None

    def _cue(self, text: VoiceText | None) -> LineCue | None:
        if text is None:
            return None
        cue = text.cue
        return LineCue(id=cue.id, number=cue.number, label=label(self._project.cue_prefix, cue.number), name=cue.name)


def _path(line: VoiceLine, language: str) -> str:
    return game_path(language, stem_in_language(language, line.file_name))


def _files(line: VoiceLine, language: str, statuses: Sequence[LineStatus]) -> list[LineFile]:
    stems = stems_of("", stem_in_language(language, line.file_name), len(statuses))
    return [
        LineFile(path=game_path(language, stem), state=status.state)
        for stem, status in zip(stems, statuses, strict=True)
    ]


def line_of_cue(session: Session, access: ProjectAccess, cue_id: UUID) -> VoiceLineRead | None:
    """Return the line that a cue is for; None for a cue that is not a voice line."""
    text = queries.text_of_cue(session, cue_id)
    if text is None:
        return None
    reader = ScriptReader(session, access, around=text.line)
    return next(candidate for candidate in reader.in_language(text.language) if candidate.id == text.line_id)


def may_change(access: ProjectAccess) -> bool:
    """Whether a person may change the script."""
    return access.is_producer or access.is_liaison or access.is_approver


def _take(take: TakeFacts | None) -> LineTake | None:
    if take is None:
        return None
    return LineTake(id=take.id, number=take.number, state=take.state, duration_s=take.duration_s)
