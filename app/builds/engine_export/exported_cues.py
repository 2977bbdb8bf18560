"""The engine export of a pack: its cues as engines import them."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.builds.engine_export import queries as handoff_queries
from app.builds.engine_export.cues import ArchivedFile, ExportedCue, Handoff, distinct, one_line, set_name, stated
from app.builds.engine_export.engines import handoff_files
from app.builds.packs.service import Pack, memory_entry
from app.builds.packs.zip_stream import Entry
from app.projects.queries import current_spec
from app.renders.models import Render
from app.renders.queries import parsed_spec
from app.sound_lists.models import Cue
from app.sound_lists.rules import label

EVENT_COLUMNS = ("event", "event name", "event path", "audio event")  # of the list's own, after the engine's
LANGUAGE_COLUMNS = ("language", "locale")
PLACEHOLDER = "PLACEHOLDER: not the final sound; it must not ship."


def handoff_entries(session: Session, pack: Pack, handoff: Handoff) -> list[Entry]:
    """Return the files by which an engine imports a pack; none where the pack is handed over without."""
    if handoff is Handoff.NONE:
        return []
    known_paths = handoff_queries.handed_paths(session, pack.project.id, pack.target, handoff)
    in_game = handoff_queries.cues_of_the_game(session, pack.project.id, handoff)
    known_paths |= {sound.path for sound in pack.sounds if sound.cue.id in in_game}
    made = handoff_files(handoff, handed_cues(session, pack, handoff), known_paths)
    return [memory_entry(path, content) for path, content in made.items()]


def handed_cues(session: Session, pack: Pack, handoff: Handoff) -> list[ExportedCue]:
    """Return the cues of which a pack has files, in the order of the list."""
    spec = parsed_spec(current_spec(session, pack.project.id).toml)
    content = _content(pack)
    names = distinct((number, set_name([file.stem for file in files])) for number, (_, files) in content.items())
    targets = {
        category: spec.for_category(category or None).targets[pack.target]
        for category in {cue.category for cue, _ in content.values()}
    }
    placeholders = {placeholder_file.cue.id for placeholder_file in pack.placeholder_files}
    return [
        ExportedCue(
            label=number,
            name=names[number],
            title=cue.name,
            category=cue.category,
            loop=cue.loop,
            notes=_notes(number, cue, has_placeholder=cue.id in placeholders),
            files=tuple(files),
            event=stated(cue.extra, f"{handoff} event", *EVENT_COLUMNS),
            language=stated(cue.extra, *LANGUAGE_COLUMNS),
            target_streamed=targets[cue.category].streamed,
            codec_ratio=targets[cue.category].codec_ratio,
        )
        for number, (cue, files) in content.items()
    ]


def _notes(number: str, cue: Cue, *, has_placeholder: bool) -> str:
    """Return the list's notes on a cue, on one line."""
    lines = [PLACEHOLDER] if has_placeholder else []
    lines += [f"{number} {cue.name}.", cue.description]
    lines += [f"{what}: {text}" for what, text in (("Use", cue.use), ("Trigger", cue.trigger)) if text]
    return one_line(" ".join(lines))


def _content(pack: Pack) -> dict[str, tuple[Cue, list[ArchivedFile]]]:
    """Return each cue by its label, with its files in the order of its variations."""
    by_cue: dict[UUID, tuple[Cue, dict[int, ArchivedFile]]] = {}
    for sound in pack.sounds:
        if render := sound.packed:
            by_cue.setdefault(sound.cue.id, (sound.cue, {}))[1][sound.variation] = _game_file(sound.path, render)
    for placeholder_file in pack.placeholder_files:
        made = ArchivedFile(
            path=placeholder_file.path,
            sha256=placeholder_file.sha256,
            duration_s=placeholder_file.cue.duration_s or 0.0,
        )
        by_cue.setdefault(placeholder_file.cue.id, (placeholder_file.cue, {}))[1][placeholder_file.variation] = made
    prefix = pack.project.cue_prefix
    return {label(prefix, cue.number): (cue, [files[at] for at in sorted(files)]) for cue, files in by_cue.values()}


def _game_file(path: str, render: Render) -> ArchivedFile:
    facts = render.facts
    return ArchivedFile(
        path=path,
        sha256=render.sha256 or "",
        duration_s=facts["duration_s"],
        sample_rate_hz=facts["sample_rate_hz"],
        loop_points=tuple((first, last) for first, last in facts["loop_points"]),
    )
