"""Contradictions between a list and the naming rule of its delivery spec, and solutions on either side."""

from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

import audio_checks
from app.accounts.rules import Actor
from app.projects.models import Project
from app.projects.queries import current_spec
from app.projects.service import project_access, save_spec
from app.projects.specs.service import read_spec, toml_of_form
from app.sound_lists import queries
from app.sound_lists.errors import NamesNotResolved
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState, label
from app.sound_lists.save_edits import Edit, facts_of, row_faults, save, whole_facts
from app.sound_lists.schemas import CueRead, NameRefusalRead, PatternOffer, RefusedName, RefusedNames


@dataclass(frozen=True)
class _Named:
    """The names of a cue, in the list or in a sheet."""

    name: str
    file_name: str
    variations: int
    category: str
    row: int | None = None
    cue_id: UUID | None = None
    label: str | None = None


def refusals_of_list(session: Session, project: Project, spec: audio_checks.DeliverySpec | None = None) -> RefusedNames:
    """Return the names of the list that its spec refuses, or that another one would refuse."""
    cues = [cue for cue in queries.cues_of(session, project.id) if cue.state is not CueState.CUT]
    return _refusals(_spec(session, project.id) if spec is None else spec, [_of_cue(project, cue) for cue in cues])


def refusals_of_edits(session: Session, project: Project, edits: Iterable[Edit]) -> RefusedNames:
    """Return the names among rows to save that the spec refuses."""
    named = [
        _Named(
            edit.facts["name"],
            edit.facts["file_name"],
            edit.facts["variations"],
            edit.facts["category"],
            row=edit.row,
            cue_id=edit.cue.id if edit.cue else None,
            label=label(project.cue_prefix, edit.cue.number) if edit.cue else None,
        )
        for edit in edits
        if edit.facts["state"] != CueState.CUT
    ]
    return _refusals(_spec(session, project.id), named)


def with_proposals(session: Session, project: Project, edits: Sequence[Edit]) -> list[Edit]:
    """Return rows to save, those with a refused name under the file name that is proposed for them."""
    proposed = {refused.row: refused.proposed for refused in refusals_of_edits(session, project, edits).names}
    return [
        replace(edit, facts={**edit.facts, "file_name": proposed[edit.row]}) if proposed.get(edit.row) else edit
        for edit in edits
    ]


def with_refusals(session: Session, project_id: UUID, cues: Sequence[CueRead]) -> list[CueRead]:
    """Return cues, each with what the spec says against its file name."""
    spec = _spec(session, project_id)
    for cue in cues:
        if cue.state is not CueState.CUT:
            refusal = _refusal(spec, _Named(cue.name, cue.file_name, cue.variations, cue.category))
            cue.refused_name = NameRefusalRead.model_validate(refusal) if refusal else None
    return list(cues)


def rename_refused(session: Session, actor: Actor, project_id: UUID, cue_ids: Collection[UUID] | None) -> RefusedNames:
    """Give refused cues the proposed file names, as one revision; raise NamesNotResolved where one is taken."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    project = access.project
    queries.lock_list(session, project.id)
    proposed = {
        refused.cue_id: refused.proposed
        for refused in refusals_of_list(session, project).names
        if refused.proposed and (cue_ids is None or refused.cue_id in cue_ids)
    }
    edits = [
        Edit(row, whole_facts({"file_name": proposed[cue.id]}, facts_of(cue)), cue)
        for row, cue in enumerate(queries.cues_of(session, project.id), start=1)
        if cue.id in proposed
    ]
    if faults := row_faults(session, project, edits):
        named = {edit.row: label(project.cue_prefix, edit.cue.number) for edit in edits if edit.cue}
        raise NamesNotResolved(
            f"nothing was renamed; {named[faults[0].row]}: {faults[0].message}",
            errors=[{"where": named[fault.row], "message": fault.message} for fault in faults],
        )
    save(session, project, actor.person, edits)
    session.flush()
    session.expire_all()
    return refusals_of_list(session, project)


def admit_refused(session: Session, actor: Actor, project_id: UUID, category: str | None) -> RefusedNames:
    """Save a spec whose pattern admits the refused names; raise NamesNotResolved where none is offered."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    newest = current_spec(session, project_id)
    offers = refusals_of_list(session, access.project).patterns
    offer = next((offer for offer in offers if offer.category == category), None)
    if offer is None:
        raise NamesNotResolved("no pattern is offered for these names", fix="rename the cues, or write a pattern")
    toml = _with_pattern(newest.toml, offer)
    note = "naming pattern admits the file names of the list"
    save_spec(session, actor, project_id, toml=toml, based_on_version=newest.version, note=note)
    session.flush()
    return refusals_of_list(session, access.project)


def _with_pattern(toml: str, offer: PatternOffer) -> str:
    """Return the text of a spec with another pattern; its comments stay where the pattern stands in it once."""
    spec = read_spec(toml)
    tables: dict[str, Any] = {**spec.tables}
    if offer.category is None:
        tables["naming"] = {**tables["naming"], "pattern": offer.proposed}
    else:
        table = tables["categories"][offer.category]
        changed = {**table, "naming": {**table["naming"], "pattern": offer.proposed}}
        tables["categories"] = {**tables["categories"], offer.category: changed}
    for quote in ("'", '"'):
        if toml.count(f"{quote}{offer.pattern}{quote}") == 1 and "'" not in offer.proposed:
            text = toml.replace(f"{quote}{offer.pattern}{quote}", f"'{offer.proposed}'")
            if read_spec(text).tables == tables:
                return text
    return toml_of_form(tables)


def _spec(session: Session, project_id: UUID) -> audio_checks.DeliverySpec:
    return read_spec(current_spec(session, project_id).toml)


def _of_cue(project: Project, cue: Cue) -> _Named:
    return _Named(
        cue.name,
        cue.file_name,
        cue.variations,
        cue.category,
        cue_id=cue.id,
        label=label(project.cue_prefix, cue.number),
    )


def _refusal(spec: audio_checks.DeliverySpec, named: _Named) -> audio_checks.NameRefusal | None:
    view = spec.for_category(named.category or None)
    return audio_checks.refused_name(named.name, named.file_name, named.variations, view)


def _refusals(spec: audio_checks.DeliverySpec, cues: Sequence[_Named]) -> RefusedNames:
    names: list[RefusedName] = []
    refused: dict[str | None, list[str]] = defaultdict(list)
    for named in cues:
        refusal = _refusal(spec, named)
        if refusal is None:
            continue
        names.append(
            RefusedName(
                row=named.row,
                cue_id=named.cue_id,
                label=named.label,
                name=named.name,
                category=named.category,
                stem=refusal.stem,
                rule=refusal.rule,
                message=refusal.message,
                proposed=refusal.proposed,
            )
        )
        if refusal.rule == "pattern":
            refused[_place(spec, named.category)].append(refusal.stem)
    return RefusedNames(names=names, patterns=list(_offers(spec, cues, refused)))


def _place(spec: audio_checks.DeliverySpec, category: str) -> str | None:
    """Return the category whose own pattern judges a cue; None where the pattern of the whole spec does."""
    own = spec.tables.get("categories", {}).get(category, {}).get("naming", {})
    return category if "pattern" in own else None


def _offers(
    spec: audio_checks.DeliverySpec, cues: Sequence[_Named], refused: Mapping[str | None, Sequence[str]]
) -> Iterator[PatternOffer]:
    for category, stems in refused.items():
        pattern = spec.for_category(category).naming.pattern
        listed = [
            stem
            for named in cues
            if _place(spec, named.category) == category
            for stem in audio_checks.stems_of(named.name, named.file_name, named.variations)
        ]
        proposed = audio_checks.pattern_admitting(pattern, listed) if pattern else None
        if pattern and proposed:
            yield PatternOffer(category=category, pattern=pattern, proposed=proposed, names=len(stems))
