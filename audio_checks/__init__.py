"""Checks game audio against a delivery spec, and renders the game's files from masters.

>>> from audio_checks import check_file, load_spec
>>> entry = check_file("shield.wav", load_spec("spec.toml"))  # doctest: +SKIP
>>> entry.verdict, [finding.message for finding in entry.findings]  # doctest: +SKIP

Every name below is loaded when it is first used, so that importing the package costs nothing.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from audio_checks.version import TOOL_VERSION

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile, DryStem
    from audio_checks.audio.sandbox import Sandbox, SandboxChild, confinement_gaps, ensure_declared
    from audio_checks.audit.build import audit_build, fingerprint_files
    from audio_checks.audit.fingerprint import FINGERPRINT_VERSION
    from audio_checks.audit.fingerprinted import FingerprintedFile
    from audio_checks.audit.manifest import manifest_entry, manifest_of, read_manifest, write_manifest
    from audio_checks.audit.played import with_plays, with_project
    from audio_checks.audit.report import Audit
    from audio_checks.audit.same_sound import (
        Difference,
        SoundSignature,
        difference_of,
        likely_sounds,
        sound_signature,
        sounds_of_manifest,
    )
    from audio_checks.checks import Check, CheckLimit, all_checks
    from audio_checks.errors import (
        AudioChecksError,
        FixRefused,
        RenderRefused,
        SandboxCrashed,
        SandboxFailed,
        SandboxOutOfMemory,
        SandboxTimedOut,
        SpecError,
        SplitRefused,
        Unreadable,
    )
    from audio_checks.fixing.fix_master import fix_master
    from audio_checks.fixing.fixed import FIXER_VERSION, FixedMaster
    from audio_checks.fixing.listed_names import NameRefusal, pattern_admitting, refused_name
    from audio_checks.fixing.offers import Offer, fix_in_words, fix_offer
    from audio_checks.fixing.split_master import SHORTEST_PAUSE_S, SoundPart, SplitMaster, split_master
    from audio_checks.fixing.spots import Spot, repair_spots
    from audio_checks.judge.compare.dry_stem import compare_reverb_with_dry
    from audio_checks.judge.compare.takes import compare_reverb_of_takes
    from audio_checks.matching.adoption import AdoptionPlan, ShippedFile, folded_stem, plan_adoption
    from audio_checks.matching.index import ListedCue, NameIndex
    from audio_checks.matching.reading import variation_in
    from audio_checks.measure.average_spectrum import BandLevels
    from audio_checks.measure.masking import BLOCK_S, CENTRES_HZ, Masking, masking
    from audio_checks.measure.true_peak import true_peak_dbtp
    from audio_checks.measure.waveform import WaveShape
    from audio_checks.middleware.project import read_project, read_project_texts
    from audio_checks.middleware.values import Part, PlayedSound, Project
    from audio_checks.placeholders.make import Placeholder, make_placeholder, make_placeholders
    from audio_checks.placeholders.recorded import tidy_recording
    from audio_checks.placeholders.speech import synthesize_speech
    from audio_checks.render.kept_coded import keep_coded
    from audio_checks.render.key import render_key
    from audio_checks.render.preview import (
        average_spectrum,
        excitation,
        is_preview,
        light_preview,
        preview,
        spectrogram,
        wave_shapes,
    )
    from audio_checks.render.provenance import Exported, Provenance, export_master
    from audio_checks.render.render import render_master
    from audio_checks.render.rendered import Loss, Rendered
    from audio_checks.render.work import RENDERER_VERSION
    from audio_checks.report.findings import FileReport, Finding, Report
    from audio_checks.report.judged import JudgedFile
    from audio_checks.run.memory_budget import Memory, MemoryUse, SoundSize, memory_use, requested_sizes
    from audio_checks.run.name_check import check_name
    from audio_checks.run.rehearsal import rehearse_check, write_rehearsal_sound
    from audio_checks.run.runner import check_file, check_files, is_placeholder, measure_file
    from audio_checks.run.sets import offset_from_set_lu, set_findings
    from audio_checks.spec.codings import CODINGS, LOSSY_ENCODINGS, Coding, ending_of, is_lossy
    from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec, Target, load_spec, new_spec, parse_spec
    from audio_checks.spec.game_paths import game_path, stem_in_language
    from audio_checks.spec.list_cells import (
        EMPTY,
        MAX_FIGURE_CHARS,
        CellContext,
        Reading,
        is_broken_formula,
        number_text,
        read_cell,
        read_day,
        read_number,
        reading_of,
    )
    from audio_checks.spec.list_columns import ColumnGuess, guess_column, names_in_row
    from audio_checks.spec.list_heads import HEADS, head_of, known_heads_in
    from audio_checks.spec.list_table import RowWithoutCue, TableUnreadable, headed, records, rows_without_cue
    from audio_checks.spec.sound_list import SoundList, read_sound_list, write_sound_list
    from audio_checks.spec.sound_names import (
        TakeName,
        dry_stem_name,
        parse_file_name,
        slug,
        stem_of_file,
        stems_of,
    )
    from audio_checks.spec.target_presets import TARGET_PRESETS, TargetPreset
    from audio_checks.system.text_encoding import (
        CODE_PAGES,
        GUESSED_FOR_ZIP,
        DecodedText,
        TextDamaged,
        decode_text,
    )
    from audio_checks.system.text_files import read_toml

__all__ = [
    "BLOCK_S",
    "CENTRES_HZ",
    "CODE_PAGES",
    "CODINGS",
    "EMPTY",
    "FINGERPRINT_VERSION",
    "FIXER_VERSION",
    "GUESSED_FOR_ZIP",
    "HEADS",
    "LOSSY_ENCODINGS",
    "MAX_FIGURE_CHARS",
    "RENDERER_VERSION",
    "SHORTEST_PAUSE_S",
    "TARGET_PRESETS",
    "TOOL_VERSION",
    "AdoptionPlan",
    "AudioChecksError",
    "AudioFile",
    "Audit",
    "BandLevels",
    "CellContext",
    "Check",
    "CheckLimit",
    "Coding",
    "ColumnGuess",
    "CueFacts",
    "DecodedText",
    "DeliverySpec",
    "Difference",
    "DryStem",
    "Exported",
    "FileReport",
    "Finding",
    "FingerprintedFile",
    "FixRefused",
    "FixedMaster",
    "JudgedFile",
    "ListedCue",
    "Loss",
    "Masking",
    "Memory",
    "MemoryUse",
    "NameIndex",
    "NameRefusal",
    "Offer",
    "Part",
    "Placeholder",
    "PlayedSound",
    "Project",
    "Provenance",
    "Reading",
    "RenderRefused",
    "Rendered",
    "Report",
    "RowWithoutCue",
    "Sandbox",
    "SandboxChild",
    "SandboxCrashed",
    "SandboxFailed",
    "SandboxOutOfMemory",
    "SandboxTimedOut",
    "ShippedFile",
    "SoundList",
    "SoundPart",
    "SoundSignature",
    "SoundSize",
    "SpecError",
    "SplitMaster",
    "SplitRefused",
    "Spot",
    "TableUnreadable",
    "TakeName",
    "Target",
    "TargetPreset",
    "TextDamaged",
    "Unreadable",
    "WaveShape",
    "all_checks",
    "audit_build",
    "average_spectrum",
    "check_file",
    "check_files",
    "check_name",
    "compare_reverb_of_takes",
    "compare_reverb_with_dry",
    "confinement_gaps",
    "decode_text",
    "difference_of",
    "dry_stem_name",
    "ending_of",
    "ensure_declared",
    "excitation",
    "export_master",
    "fingerprint_files",
    "fix_in_words",
    "fix_master",
    "fix_offer",
    "folded_stem",
    "game_path",
    "guess_column",
    "head_of",
    "headed",
    "is_broken_formula",
    "is_lossy",
    "is_placeholder",
    "is_preview",
    "keep_coded",
    "known_heads_in",
    "light_preview",
    "likely_sounds",
    "load_spec",
    "make_placeholder",
    "make_placeholders",
    "manifest_entry",
    "manifest_of",
    "masking",
    "measure_file",
    "memory_use",
    "names_in_row",
    "new_spec",
    "number_text",
    "offset_from_set_lu",
    "parse_file_name",
    "parse_spec",
    "pattern_admitting",
    "plan_adoption",
    "preview",
    "read_cell",
    "read_day",
    "read_manifest",
    "read_number",
    "read_project",
    "read_project_texts",
    "read_sound_list",
    "read_toml",
    "reading_of",
    "records",
    "refused_name",
    "rehearse_check",
    "render_key",
    "render_master",
    "repair_spots",
    "requested_sizes",
    "rows_without_cue",
    "set_findings",
    "slug",
    "sound_signature",
    "sounds_of_manifest",
    "spectrogram",
    "split_master",
    "stem_in_language",
    "stem_of_file",
    "stems_of",
    "synthesize_speech",
    "tidy_recording",
    "true_peak_dbtp",
    "variation_in",
    "wave_shapes",
    "with_plays",
    "with_project",
    "write_manifest",
    "write_rehearsal_sound",
    "write_sound_list",
]

_HOMES = {
    "audio_checks.audio.audio_file": ("AudioFile", "DryStem"),
    "audio_checks.audit.build": ("audit_build", "fingerprint_files"),
    "audio_checks.audit.fingerprint": ("FINGERPRINT_VERSION",),
    "audio_checks.audit.fingerprinted": ("FingerprintedFile",),
    "audio_checks.audit.manifest": ("manifest_entry", "manifest_of", "read_manifest", "write_manifest"),
    "audio_checks.audit.played": ("with_plays", "with_project"),
    "audio_checks.audit.report": ("Audit",),
    "audio_checks.audit.same_sound": (
        *("Difference", "SoundSignature", "difference_of", "sound_signature", "likely_sounds"),
        "sounds_of_manifest",
    ),
    "audio_checks.middleware.project": ("read_project", "read_project_texts"),
    "audio_checks.middleware.values": ("Part", "PlayedSound", "Project"),
    "audio_checks.judge.compare.dry_stem": ("compare_reverb_with_dry",),
    "audio_checks.errors": (
        "AudioChecksError",
        "FixRefused",
        "RenderRefused",
        "SandboxCrashed",
        "SandboxFailed",
        "SandboxOutOfMemory",
        "SandboxTimedOut",
        "SpecError",
        "SplitRefused",
        "Unreadable",
    ),
    "audio_checks.checks": ("Check", "CheckLimit", "all_checks"),
    "audio_checks.report.findings": ("FileReport", "Finding", "Report"),
    "audio_checks.matching.adoption": ("AdoptionPlan", "ShippedFile", "folded_stem", "plan_adoption"),
    "audio_checks.matching.index": ("ListedCue", "NameIndex"),
    "audio_checks.matching.reading": ("variation_in",),
    "audio_checks.measure.average_spectrum": ("BandLevels",),
    "audio_checks.measure.true_peak": ("true_peak_dbtp",),
    "audio_checks.measure.masking": ("BLOCK_S", "CENTRES_HZ", "Masking", "masking"),
    "audio_checks.measure.waveform": ("WaveShape",),
    "audio_checks.run.memory_budget": ("Memory", "MemoryUse", "SoundSize", "memory_use", "requested_sizes"),
    "audio_checks.fixing.fix_master": ("fix_master",),
    "audio_checks.fixing.fixed": ("FIXER_VERSION", "FixedMaster"),
    "audio_checks.fixing.listed_names": ("NameRefusal", "pattern_admitting", "refused_name"),
    "audio_checks.fixing.offers": ("Offer", "fix_in_words", "fix_offer"),
    "audio_checks.fixing.split_master": ("SHORTEST_PAUSE_S", "SoundPart", "SplitMaster", "split_master"),
    "audio_checks.fixing.spots": ("Spot", "repair_spots"),
    "audio_checks.placeholders.make": ("Placeholder", "make_placeholder", "make_placeholders"),
    "audio_checks.placeholders.recorded": ("tidy_recording",),
    "audio_checks.placeholders.speech": ("synthesize_speech",),
    "audio_checks.render.provenance": ("Exported", "Provenance", "export_master"),
    "audio_checks.run.rehearsal": ("rehearse_check", "write_rehearsal_sound"),
    "audio_checks.render.kept_coded": ("keep_coded",),
    "audio_checks.render.key": ("render_key",),
    "audio_checks.render.preview": (
        "average_spectrum",
        "excitation",
        "is_preview",
        "light_preview",
        "preview",
        "spectrogram",
        "wave_shapes",
    ),
    "audio_checks.render.render": ("render_master",),
    "audio_checks.render.work": ("RENDERER_VERSION",),
    "audio_checks.render.rendered": ("Loss", "Rendered"),
    "audio_checks.run.name_check": ("check_name",),
    "audio_checks.run.runner": ("check_file", "check_files", "is_placeholder", "measure_file"),
    "audio_checks.audio.sandbox": ("Sandbox", "SandboxChild", "confinement_gaps", "ensure_declared"),
    "audio_checks.report.judged": ("JudgedFile",),
    "audio_checks.run.sets": ("offset_from_set_lu", "set_findings"),
    "audio_checks.spec.list_cells": (
        *("EMPTY", "MAX_FIGURE_CHARS", "CellContext", "Reading", "is_broken_formula", "number_text", "read_cell"),
        *("read_day", "read_number", "reading_of"),
    ),
    "audio_checks.spec.list_columns": ("ColumnGuess", "guess_column", "names_in_row"),
    "audio_checks.spec.list_heads": ("HEADS", "head_of", "known_heads_in"),
    "audio_checks.spec.list_table": ("RowWithoutCue", "TableUnreadable", "headed", "records", "rows_without_cue"),
    "audio_checks.spec.sound_list": ("SoundList", "read_sound_list", "write_sound_list"),
    "audio_checks.spec.sound_names": (
        *("TakeName", "dry_stem_name", "parse_file_name", "slug", "stem_of_file", "stems_of"),
    ),
    "audio_checks.system.text_encoding": (
        *("CODE_PAGES", "GUESSED_FOR_ZIP", "DecodedText", "TextDamaged", "decode_text"),
    ),
    "audio_checks.spec.game_paths": ("game_path", "stem_in_language"),
    "audio_checks.spec.codings": ("CODINGS", "LOSSY_ENCODINGS", "Coding", "ending_of", "is_lossy"),
    "audio_checks.spec.delivery_spec": ("CueFacts", "DeliverySpec", "Target", "load_spec", "new_spec", "parse_spec"),
    "audio_checks.spec.target_presets": ("TARGET_PRESETS", "TargetPreset"),
    "audio_checks.system.text_files": ("read_toml",),
    "audio_checks.judge.compare.takes": ("compare_reverb_of_takes",),
}
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names}


def __getattr__(name: str) -> Any:
    """Load a public name from its module, once."""
    if name not in _HOME_OF:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(_HOME_OF[name]), name)
    globals()[name] = value
    return value
