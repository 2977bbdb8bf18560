"""A check's verdict on files before they are sent: their cues, the faults of their names, and the limits."""

from collections.abc import Collection
from uuid import UUID

from sqlalchemy.orm import Session

import audio_checks
from app.accounts.models import Person
from app.accounts.rules import Actor
from app.conformance.rules import JUDGED_IN_BROWSER, levels_in_browser, parsed_spec, with_offers
from app.conformance.schemas import (
    CheckPreview,
    CheckPreviewed,
    CueLength,
    FileNamed,
    FilePreview,
    FindingRead,
    PreviewedCheck,
    SpecView,
)
from app.conformance.service import spec_for
from app.deliveries.queries import filled_variations
from app.deliveries.rules import base_name, dry_stem_for, list_name_for, named_for, stored_name
from app.deliveries.schemas import CueBrief
from app.deliveries.slots import Slot, slot_given, slot_named, stems_of_slots
from app.projects.queries import current_spec
from app.projects.service import ProjectAccess, project_access
from app.sound_lists.models import Cue
from app.sound_lists.names.matching import ListNames, MatchedCue, list_names
from app.sound_lists.rules import label
from app.sound_lists.service import cue_facts


def preview_checks(session: Session, actor: Actor, project_id: UUID, body: CheckPreview) -> CheckPreviewed:
    """State the rules for each file, and the findings in its name; nothing is kept."""
    access = project_access(session, actor, project_id)
    access.ensure_party()
    whole = parsed_spec(current_spec(session, project_id).toml)
    slots = [_slot(session, access, named) for named in body.files]
    stems = iter(stems_of_slots(session, [slot for slot in slots if slot]))
    likely_stems = _likely_stems(session, access, body, slots)
    views: dict[str | None, int] = {}
    specs: list[SpecView] = []
    files: list[FilePreview] = []
    for named, slot, likely_stem in zip(body.files, slots, likely_stems, strict=True):
        name = stored_name(named.file_name)
        view = spec_for(whole, slot.cue if slot else None, name)
        if view.category not in views:
            views[view.category] = len(specs)
            specs.append(_view_read(view))
        stem = next(stems) if slot else None
        checked_name = name if stem is None else named_for(name, stem)
        findings = _of_name(checked_name, view, slot.cue if slot else None)
        is_dry_stem = slot is None and dry_stem_for(name) is not None
        proposed = None if is_dry_stem else _proposed(name, (stem if findings else None) or likely_stem, view)
        files.append(
            FilePreview(
                cue=_cue(access, slot) if slot else None,
                length=_length(slot) if slot else None,
                variation=slot.variation if slot else None,
                spec=views[view.category],
                is_dry_stem=is_dry_stem,
                list_name=proposed if proposed not in (base_name(name), base_name(checked_name)) else None,
                findings=findings,
            )
        )
    checks_by_name = audio_checks.all_checks()
    checks = [PreviewedCheck.model_validate(checks_by_name[name]) for name in (*JUDGED_IN_BROWSER, "naming")]
    return CheckPreviewed(checks=checks, specs=specs, files=files)


def _slot(session: Session, access: ProjectAccess, named: FileNamed) -> Slot | None:
    name = stored_name(named.file_name)
    if named.cue_id is not None:
        return slot_given(session, access, named.cue_id, None, name)
    return slot_named(session, access.project.id, name, session.get_one(Person, access.actor.person).name)


def _likely_stems(
    session: Session, access: ProjectAccess, body: CheckPreview, slots: list[Slot | None]
) -> list[str | None]:
    """Return the list's stem of the likeliest cue for each file whose name does not say surely which."""
    paths = [stored_name(named.file_name) for named in body.files]
    unsure = [slot is None and dry_stem_for(path) is None for path, slot in zip(paths, slots, strict=True)]
    if not any(unsure):
        return [None] * len(paths)
    names = list_names(session, access.project.id)
    people = [session.get_one(Person, access.actor.person).name]
    prefixes = names.index.shared_prefixes(paths)
    likely = [
        _likeliest(names, path, people, prefixes) if is_unsure else None
        for path, is_unsure in zip(paths, unsure, strict=True)
    ]
    taken = filled_variations(session, {slot.cue_id for slot in likely if slot and slot.variation is None})
    others = [names.sure(stored_name(name), people) for name in body.proposed]
    places = [(slot.cue.id, slot.variation) for slot in slots if slot]
    for cue_id, variation in (*places, *((slot.cue_id, slot.variation) for slot in (*likely, *others) if slot)):
        if cue_id in taken and variation is not None:
            taken[cue_id].add(variation)
    return [None if slot is None else _likely_stem(names, slot, taken) for slot in likely]


def _likeliest(names: ListNames, path: str, people: list[str], prefixes: Collection[str]) -> MatchedCue | None:
    return names.sure(path, people, prefixes) or next(iter(names.guesses(path, people, prefixes)), None)


def _likely_stem(names: ListNames, likely: MatchedCue, taken: dict[UUID, set[int]]) -> str | None:
    """Return the stem; a name that does not say which variation gets the next free one, if there is one left."""
    if likely.variation is not None:
        return likely.stem
    filled = taken[likely.cue_id]
    free = next((number for number in range(1, likely.variations + 1) if number not in filled), None)
    if free is None:
        return None
    filled.add(free)
    return names.stem(likely.cue_id, free)


def _proposed(name: str, stem: str | None, view: audio_checks.DeliverySpec) -> str | None:
    return None if stem is None else list_name_for(name, stem, view.naming.extension)


def _cue(access: ProjectAccess, slot: Slot) -> CueBrief:
    cue = slot.cue
    return CueBrief(id=cue.id, label=label(access.project.cue_prefix, cue.number), name=cue.name)


def _length(slot: Slot) -> CueLength:
    return CueLength.model_validate(cue_facts(slot.cue))


def _view_read(view: audio_checks.DeliverySpec) -> SpecView:
    facts = {"category": view.category, "accept": view.accept, "limits": view.limits}
    return SpecView.model_validate(facts | {"levels": levels_in_browser(view)})


def _of_name(name: str, view: audio_checks.DeliverySpec, cue: Cue | None) -> list[FindingRead]:
    named = audio_checks.check_name(base_name(name), view, cue_facts(cue) if cue else None)
    report = audio_checks.FileReport(path=base_name(name), verdict="rejected", findings=named)
    offers = [audio_checks.fix_offer(finding, report, view) for finding in named]
    findings = with_offers([{**finding.to_dict(), "waived": False} for finding in named], offers)
    return [FindingRead.model_validate(finding) for finding in findings]
