"""A script becomes voice lines, each with a cue per language: all of them, or none."""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core.db import new_id
from app.core.plural import counted
from app.projects.models import Project
from app.projects.service import project_access
from app.sound_lists.names.service import refusals_of_edits
from app.sound_lists.queries import lock_list, stem_owners
from app.sound_lists.rules import NEW_CUE, folded, tidy_line
from app.sound_lists.save_edits import Edit, row_faults, save, whole_facts
from app.sound_lists.schemas import ImportTab, RefusedNames
from app.sound_lists.sheets.imports import encoding_read, filled_down, hidden_rows
from app.sound_lists.sheets.rules import Sheet
from app.voice_lines import queries
from app.voice_lines.models import Character, VoiceLine, VoiceSettings, VoiceText, VoiceTextVersion
from app.voice_lines.rules import CATEGORY, merged_order
from app.voice_lines.schemas import LineChange, ScriptAsk, ScriptColumn, ScriptFault, ScriptRead, ScriptRow
from app.voice_lines.script_rows import Column, KnownLines, RowFault, Speaker, SpokenRow, Words, columns_of, spoken_rows
from audio_checks import stem_in_language, stems_of

SAMPLES = 3


@dataclass
class NewText:
    """A line in a language that the project has no text for yet."""

    plan: "LinePlan"
    language: str
    cue_id: UUID | None = None  # of a cue that owns the name already
    edit: Edit | None = None  # of a cue to add

    @property
    def stem(self) -> str:
        """The name of its cue."""
        return stem_in_language(self.language, self.plan.spoken.file_name)

    @property
    def stem_sets(self) -> list[list[str]]:
        """The names of its files, without endings: as the script numbers them, or else one file or any set."""
        numbers = [self.plan.spoken.variations] if self.plan.spoken.variations else [1, 2]
        return [stems_of("", self.stem, number) for number in numbers]


@dataclass
class LinePlan:
    """The effect of a script's row: a new line, or changes to one."""

    spoken: SpokenRow
    line: VoiceLine | None
    changes: list[LineChange] = field(default_factory=list)
    changed_texts: list[tuple[VoiceText, str]] = field(default_factory=list)
    new_texts: list[NewText] = field(default_factory=list)


def import_script(
    session: Session,
    actor: Actor,
    project_id: UUID,
    sheet: Sheet,
    ask: ScriptAsk,
    *,
    language: str,
) -> ScriptRead:
    """Return the changes of a script, and apply its rows without errors if it is not a dry run."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    project = access.project
    lock_list(session, project.id)
    lines = queries.lines_of(session, project.id)
    texts = {(text.line_id, text.language): text for text in queries.texts_of(session, project.id)}
    speaker = Speaker(tidy_line(ask.speaker), ask.speaker_in_key)
    columns = columns_of(sheet, language, ask.mapping or {}, {of for _, of in texts}, speaker)
    spoken, faults = spoken_rows(sheet, columns, _known(lines, texts, language), language, speaker)
    by_key = {line.folded: line for line in lines}
    delivered = queries.cues_with_takes(session, project.id)
    plans = [_plan(row, by_key.get(folded(row.key)), texts, delivered) for row in spoken]
    faults += _faults_of_variations(plans, texts)
    faults += _add_cues_to(session, project, plans)
    failed = sorted({fault.row for fault in faults})
    plans = [plan for plan in plans if plan.spoken.row not in failed]
    imports = not ask.dry_run and bool(plans) and not (ask.atomic and faults)
    missing = [line.key for line in lines if line.id not in {plan.line.id for plan in plans if plan.line}]
    edits = [new.edit for plan in plans for new in plan.new_texts if new.edit]
    refused = refusals_of_edits(session, project, edits)
    rows = {new.edit.row: plan.spoken.row for plan in plans for new in plan.new_texts if new.edit}
    for name in refused.names:
        name.row = rows.get(name.row or 0)
    answer = _answer(sheet, columns, plans, faults, missing=missing, imported=imports, refused=refused, left_out=failed)
    if imports:
        writer = _Writer(session, project, actor.person)
        if not lines:
            writer.set_original_language(language)
        writer.write(plans, lines)
    return answer


def _known(lines: Sequence[VoiceLine], texts: Mapping[tuple[UUID, str], VoiceText], language: str) -> KnownLines:
    by_words: dict[Words, list[str]] = defaultdict(list)
    for line in lines:
        text = texts.get((line.id, language))
        by_words[line.character.folded, line.scene, text.text if text else ""].append(line.key)
    return KnownLines({line.folded: line.file_name for line in lines}, by_words)


def _plan(
    row: SpokenRow, line: VoiceLine | None, texts: Mapping[tuple[UUID, str], VoiceText], delivered: set[UUID]
) -> LinePlan:
    plan = LinePlan(row, line)
    if line is not None:
        facts = {"scene": (line.scene, row.scene), "direction": (line.direction, row.direction)}
        facts["character"] = (line.character.name, row.character)
        for name, (before, after) in facts.items():
            same = folded(before) == folded(after or "") if name == "character" else before == after
            if after is not None and not same:
                plan.changes.append(LineChange(field=name, before=before, after=after, makes_stale=False))
    for language, text in row.texts.items():
        line_text = texts.get((line.id, language)) if line else None
        if line_text is None:
            plan.new_texts.append(NewText(plan, language))
            if line is not None:
                plan.changes.append(LineChange(field=language, before="", after=text, makes_stale=False))
        elif line_text.text != text:
            plan.changed_texts.append((line_text, text))
            stale = line_text.cue_id in delivered
            plan.changes.append(LineChange(field=language, before=line_text.text, after=text, makes_stale=stale))
    return plan


def _faults_of_variations(plans: Sequence[LinePlan], texts: Mapping[tuple[UUID, str], VoiceText]) -> Iterator[RowFault]:
    """Yield the rows that name another number of files than the cue of their line has variations."""
    for plan in plans:
        files = plan.spoken.variations
        known = [texts.get((plan.line.id, language)) for language in plan.spoken.texts] if plan.line and files else []
        for cue in (text.cue for text in known if text and text.cue.variations != files):
            yield RowFault(plan.spoken.row, "variations", _unlike(files or 1, cue.name, cue.variations))
            break


def _unlike(files: int, cue_name: str, variations: int) -> str:
    return (
        f"{counted(files, 'file')} in the script, and {cue_name} has {counted(variations, 'variation')}; "
        "change Variations on the sound list first"
    )


def _add_cues_to(session: Session, project: Project, plans: Sequence[LinePlan]) -> list[RowFault]:
    """Give each new text the cue that owns its name, or a cue to add; return what is wrong with names."""
    new = [text for plan in plans for text in plan.new_texts]
    stems = {folded(stem) for text in new for stems in text.stem_sets for stem in stems}
    owners = {key: owner[0] for key, owner in stem_owners(session, project.id, stems).items()} if new else {}
    variations = queries.variations_of(session, owners.values())
    pinned = {text.cue_id for text in queries.texts_of(session, project.id)}
    rows: dict[int, NewText] = {}
    faults = []
    for number, new_text in enumerate(new, start=1):
        row = new_text.plan.spoken.row
        owner_sets = [[owners.get(folded(stem)) for stem in stems] for stems in new_text.stem_sets]
        owner = next((owning[0] for owning in owner_sets if owning[0] and len(set(owning)) == 1), None)
        files = new_text.plan.spoken.variations
        if owner is not None and owner in pinned:
            message = f'the file name "{new_text.stem}" belongs to another voice line already'
            faults.append(RowFault(row, "file_name", message))
        elif owner is not None and files and files != variations[owner]:
            faults.append(RowFault(row, "variations", _unlike(files, new_text.stem, variations[owner])))
        elif owner is not None:
            new_text.cue_id = owner
            pinned.add(owner)
        else:
            new_text.edit = Edit(number, whole_facts(_cue_facts(new_text), NEW_CUE))
            rows[number] = new_text
    of_cues = row_faults(session, project, [text_added.edit for text_added in rows.values() if text_added.edit])
    faults += [RowFault(rows[fault.row].plan.spoken.row, "file_name", fault.message) for fault in of_cues]
    by_row = {fault.row: fault for fault in reversed(faults)}  # one a row, and not one for each language
    return list(by_row.values())


def _cue_facts(new_text: NewText) -> dict[str, Any]:
    spoken = new_text.plan.spoken
    description = (
        f"Voice line {spoken.key} of {spoken.character}, {new_text.language}: its text is with the voice lines."
    )
    return {
        "name": new_text.stem,
        "file_name": new_text.stem,
        "variations": spoken.variations or 1,
        "category": CATEGORY,
        "description": description,
        "use": spoken.scene or "",
    }


class _Writer:
    """The writer of a plan; the list is locked."""

    def __init__(self, session: Session, project: Project, person_id: UUID) -> None:
        self._session = session
        self._project = project
        self._person_id = person_id
        self._of = {"studio_id": project.studio_id, "project_id": project.id}
        self._characters = {character.folded: character for character in queries.characters_of(session, project.id)}

    def set_original_language(self, language: str) -> None:
        """Take the language of the first script for the original one, where nobody has set it."""
        if queries.settings_of(self._session, self._project.id) is None:
            self._session.add(VoiceSettings(**self._of, original_language=language))

    def write(self, plans: Sequence[LinePlan], lines: Sequence[VoiceLine]) -> None:
        """Add and change characters, lines, cues and texts, and put the lines in order."""
        self._add_characters(plans)
        placed = [(plan, plan.line or self._new_line(plan.spoken)) for plan in plans]
        for plan, line in placed:
            self._change_line(line, plan.spoken)
        ordered = merged_order([line.id for line in lines], [line.id for _, line in placed])
        places = {line_id: position for position, line_id in enumerate(ordered, start=1)}
        for line in (*lines, *(line for _, line in placed)):
            line.position = places[line.id]
        self._session.flush()
        self._add_cues([text for plan in plans for text in plan.new_texts if text.edit])
        for plan, line in placed:
            self._write_texts(plan, line)
        self._session.flush()

    def _add_characters(self, plans: Sequence[LinePlan]) -> None:
        for plan in plans:
            key = folded(plan.spoken.character)
            if key not in self._characters:
                character = Character(**self._of, name=plan.spoken.character, folded=key)
                self._characters[key] = character
                self._session.add(character)
        self._session.flush()

    def _new_line(self, spoken: SpokenRow) -> VoiceLine:
        named = {"key": spoken.key, "folded": folded(spoken.key), "file_name": spoken.file_name}
        line = VoiceLine(**self._of, **named, id=new_id(), scene="", direction="", position=0)
        line.character_id = self._characters[folded(spoken.character)].id
        self._session.add(line)
        return line

    def _change_line(self, line: VoiceLine, spoken: SpokenRow) -> None:
        line.character_id = self._characters[folded(spoken.character)].id
        if spoken.scene is not None:
            line.scene = spoken.scene
        if spoken.direction is not None:
            line.direction = spoken.direction

    def _add_cues(self, new: Sequence[NewText]) -> None:
        edits = [text_added.edit for text_added in new if text_added.edit]
        for new_text, cue in zip(new, save(self._session, self._project, self._person_id, edits), strict=True):
            new_text.cue_id = cue.id

    def _write_texts(self, plan: LinePlan, line: VoiceLine) -> None:
        for new_text in plan.new_texts:
            if new_text.cue_id is None:
                raise LookupError("a text without a cue")
            of_it = {"line_id": line.id, "language": new_text.language, "cue_id": new_text.cue_id}
            text = VoiceText(
                **self._of, **of_it, id=new_id(), text=plan.spoken.texts[new_text.language], newest_number=1
            )
            self._session.add_all([text, _version(text, self._person_id)])
        for line_text, words in plan.changed_texts:
            self._session.add(new_version(line_text, words, self._person_id))


def new_version(text: VoiceText, words: str, person_id: UUID) -> VoiceTextVersion:
    """Give a text new words, and return the version to add."""
    text.text = words
    text.newest_number += 1
    return _version(text, person_id)


def _version(text: VoiceText, person_id: UUID) -> VoiceTextVersion:
    of = {"studio_id": text.studio_id, "project_id": text.project_id, "text_id": text.id}
    return VoiceTextVersion(**of, number=text.newest_number, text=text.text, written_by=person_id)


def _answer(
    sheet: Sheet,
    columns: Sequence[Column],
    plans: Sequence[LinePlan],
    faults: Sequence[RowFault],
    *,
    missing: list[str],
    imported: bool,
    refused: RefusedNames,
    left_out: list[int],
) -> ScriptRead:
    rows = [_row_read(plan) for plan in plans]
    names = {column.meaning: column.name for column in columns}
    samples = {column.place: dict.fromkeys(cells[column.place][:200] for _, cells in sheet.rows) for column in columns}
    return ScriptRead(
        header_row=sheet.header_row,
        tabs=[ImportTab.model_validate(tab) for tab in sheet.notes["tabs"]],
        encoding=encoding_read(sheet),
        skipped=hidden_rows(sheet),
        guesses=filled_down(sheet),
        left_out=left_out,
        refused_names=refused,
        columns=[
            ScriptColumn(
                name=column.name,
                meaning=column.meaning,
                samples=[text for text in samples[column.place] if text][:SAMPLES],
            )
            for column in columns
        ],
        rows=rows,
        errors=[
            ScriptFault(row=fault.row, column=names.get(fault.field or "", fault.field), message=fault.message)
            for fault in sorted(faults, key=lambda fault: fault.row)
        ],
        added=sum(row.action == "add" for row in rows),
        changed=sum(row.action == "change" for row in rows),
        same=sum(row.action == "same" for row in rows),
        cues_added=sum(text.edit is not None for plan in plans for text in plan.new_texts),
        stale=sum(change.makes_stale for row in rows for change in row.changes),
        not_in_script=missing,
        imported=imported,
    )


def _row_read(plan: LinePlan) -> ScriptRow:
    spoken = plan.spoken
    return ScriptRow(
        row=spoken.row,
        action="add" if plan.line is None else "change" if plan.changes else "same",
        key=spoken.key,
        character=spoken.character,
        scene=spoken.scene or (plan.line.scene if plan.line else ""),
        text=next(iter(spoken.texts.values()), ""),
        files=spoken.variations or 1,
        languages=list(spoken.texts),
        changes=plan.changes,
    )
