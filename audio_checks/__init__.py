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
    from audio_checks.audio import AudioFile
    from audio_checks.audit.build import audit_build, listen_to
    from audio_checks.audit.fingerprint import FINGERPRINT_VERSION
    from audio_checks.audit.heard import Heard
    from audio_checks.audit.manifest import manifest_entry, manifest_of, read_manifest, write_manifest
    from audio_checks.audit.report import Audit
    from audio_checks.beside import DryStem, reverb_beside
    from audio_checks.errors import (
        AudioChecksError,
        MendRefused,
        RenderRefused,
        SandboxCrashed,
        SandboxFailed,
        SandboxOutOfMemory,
        SandboxTimedOut,
        SpecError,
        Unreadable,
    )
    from audio_checks.findings import FileReport, Finding, Report
    from audio_checks.measure.average_spectrum import BandLevels
    from audio_checks.measure.waveform import WaveShape
    from audio_checks.memory_budget import Memory, MemoryUse, SoundSize, memory_use, sizes_asked_for
    from audio_checks.mending.mend import mend_master
    from audio_checks.mending.mended import MENDER_VERSION, Mended
    from audio_checks.mending.offers import Offer, mend_in_words, mendable
    from audio_checks.mending.spots import repair_spots
    from audio_checks.placeholders.make import Placeholder, make_placeholder, make_placeholders
    from audio_checks.placeholders.speech import spoken
    from audio_checks.provenance import Exported, Provenance, export_master
    from audio_checks.rehearsal import rehearse_check, write_rehearsal_sound
    from audio_checks.render.key import render_key
    from audio_checks.render.preview import average_spectrum, plays_as_preview, preview, spectrogram, wave_shapes
    from audio_checks.render.render import RENDERER_VERSION, render_master
    from audio_checks.render.rendered import Loss, Rendered
    from audio_checks.runner import check_file, check_files, is_placeholder, measure_file
    from audio_checks.sandbox import Sandbox, SandboxChild, confinement_gaps
    from audio_checks.sets import Judged, off_its_set_lu, set_findings
    from audio_checks.sound_list import (
        SoundList,
        TakeName,
        dry_stem_for,
        parse_file_name,
        read_sound_list,
        slug,
        stem_of_file,
        stems_of,
        write_sound_list,
    )
    from audio_checks.spec import CueFacts, DeliverySpec, Target, load_spec, new_spec, parse_spec
    from audio_checks.target_presets import TARGET_PRESETS, TargetPreset
    from audio_checks.text_files import read_toml
    from audio_checks.versions import reverb_between

__all__ = [
    "FINGERPRINT_VERSION",
    "MENDER_VERSION",
    "RENDERER_VERSION",
    "TARGET_PRESETS",
    "TOOL_VERSION",
    "AudioChecksError",
    "AudioFile",
    "Audit",
    "BandLevels",
    "CueFacts",
    "DeliverySpec",
    "DryStem",
    "Exported",
    "FileReport",
    "Finding",
    "Heard",
    "Judged",
    "Loss",
    "Memory",
    "MemoryUse",
    "MendRefused",
    "Mended",
    "Offer",
    "Placeholder",
    "Provenance",
    "RenderRefused",
    "Rendered",
    "Report",
    "Sandbox",
    "SandboxChild",
    "SandboxCrashed",
    "SandboxFailed",
    "SandboxOutOfMemory",
    "SandboxTimedOut",
    "SoundList",
    "SoundSize",
    "SpecError",
    "TakeName",
    "Target",
    "TargetPreset",
    "Unreadable",
    "WaveShape",
    "audit_build",
    "average_spectrum",
    "check_file",
    "check_files",
    "confinement_gaps",
    "dry_stem_for",
    "export_master",
    "is_placeholder",
    "listen_to",
    "load_spec",
    "make_placeholder",
    "make_placeholders",
    "manifest_entry",
    "manifest_of",
    "measure_file",
    "memory_use",
    "mend_in_words",
    "mend_master",
    "mendable",
    "new_spec",
    "off_its_set_lu",
    "parse_file_name",
    "parse_spec",
    "plays_as_preview",
    "preview",
    "read_manifest",
    "read_sound_list",
    "read_toml",
    "rehearse_check",
    "render_key",
    "render_master",
    "repair_spots",
    "reverb_beside",
    "reverb_between",
    "set_findings",
    "sizes_asked_for",
    "slug",
    "spectrogram",
    "spoken",
    "stem_of_file",
    "stems_of",
    "wave_shapes",
    "write_manifest",
    "write_rehearsal_sound",
    "write_sound_list",
]

_HOMES = {
    "audio_checks.audio": ("AudioFile",),
    "audio_checks.audit.build": ("audit_build", "listen_to"),
    "audio_checks.audit.fingerprint": ("FINGERPRINT_VERSION",),
    "audio_checks.audit.heard": ("Heard",),
    "audio_checks.audit.manifest": ("manifest_entry", "manifest_of", "read_manifest", "write_manifest"),
    "audio_checks.audit.report": ("Audit",),
    "audio_checks.beside": ("DryStem", "reverb_beside"),
    "audio_checks.errors": (
        "AudioChecksError",
        "MendRefused",
        "RenderRefused",
        "SandboxCrashed",
        "SandboxFailed",
        "SandboxOutOfMemory",
        "SandboxTimedOut",
        "SpecError",
        "Unreadable",
    ),
    "audio_checks.findings": ("FileReport", "Finding", "Report"),
    "audio_checks.measure.average_spectrum": ("BandLevels",),
    "audio_checks.measure.waveform": ("WaveShape",),
    "audio_checks.memory_budget": ("Memory", "MemoryUse", "SoundSize", "memory_use", "sizes_asked_for"),
    "audio_checks.mending.mend": ("mend_master",),
    "audio_checks.mending.mended": ("MENDER_VERSION", "Mended"),
    "audio_checks.mending.offers": ("Offer", "mend_in_words", "mendable"),
    "audio_checks.mending.spots": ("repair_spots",),
    "audio_checks.placeholders.make": ("Placeholder", "make_placeholder", "make_placeholders"),
    "audio_checks.placeholders.speech": ("spoken",),
    "audio_checks.provenance": ("Exported", "Provenance", "export_master"),
    "audio_checks.rehearsal": ("rehearse_check", "write_rehearsal_sound"),
    "audio_checks.render.key": ("render_key",),
    "audio_checks.render.preview": ("average_spectrum", "plays_as_preview", "preview", "spectrogram", "wave_shapes"),
    "audio_checks.render.render": ("RENDERER_VERSION", "render_master"),
    "audio_checks.render.rendered": ("Loss", "Rendered"),
    "audio_checks.runner": ("check_file", "check_files", "is_placeholder", "measure_file"),
    "audio_checks.sandbox": ("Sandbox", "SandboxChild", "confinement_gaps"),
    "audio_checks.sets": ("Judged", "off_its_set_lu", "set_findings"),
    "audio_checks.sound_list": (
        "SoundList",
        "TakeName",
        "dry_stem_for",
        "parse_file_name",
        "read_sound_list",
        "slug",
        "stem_of_file",
        "stems_of",
        "write_sound_list",
    ),
    "audio_checks.spec": ("CueFacts", "DeliverySpec", "Target", "load_spec", "new_spec", "parse_spec"),
    "audio_checks.target_presets": ("TARGET_PRESETS", "TargetPreset"),
    "audio_checks.text_files": ("read_toml",),
    "audio_checks.versions": ("reverb_between",),
}
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names}


def __getattr__(name: str) -> Any:
    """Load a public name from its module, once."""
    if name not in _HOME_OF:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(_HOME_OF[name]), name)
    globals()[name] = value
    return value
