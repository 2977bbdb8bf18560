"""Godot 4: import files beside the sounds, and a randomizer for each set.

Source: Godot 4.3 to 4.5, classes ResourceImporterWAV, ResourceImporterOggVorbis, ResourceImporterMP3, ResourceUID and
AudioStreamRandomizer.

The import files are as Godot writes them, uid and cached path included, so that unpacking a pack a second time changes
nothing. Godot's default codec for WAV is lossy in 4.5; these files ask for PCM, which keeps dither and level.
"""

import hashlib
from collections.abc import Collection, Sequence
from pathlib import PurePosixPath

from app.builds.engine_export.cues import ArchivedFile, ExportedCue, distinct, file_safe

UID_DIGITS = "abcdefghijklmnopqrstuvwxy012345678"  # those of ResourceUID
DISABLED, FORWARD = 1, 2  # of edit/loop_mode
TO_THE_END = -1
IMPORTERS = {
    ".wav": ("wav", "AudioStreamWAV", "sample"),
    ".ogg": ("oggvorbisstr", "AudioStreamOggVorbis", "oggvorbisstr"),
    ".mp3": ("mp3", "AudioStreamMP3", "mp3str"),
}


def import_files(cues: Sequence[ExportedCue], _known_paths: Collection[str] = ()) -> dict[str, bytes]:
    """Return an import file for each sound that Godot reads, and a randomizer for each set."""
    made: dict[str, bytes] = {}
    names = distinct((cue.label, file_safe(cue.name)) for cue in cues)
    for cue in cues:
        for file in cue.files:
            if _ending(file) in IMPORTERS:
                made[f"{file.path}.import"] = _import_file(cue, file)
        if cue.is_set:
            folder = PurePosixPath(cue.files[0].path).parent
            path = str(folder / f"{names[cue.label]}.tres")
            made[path] = _randomizer(cue, path)
    return made


def _ending(file: ArchivedFile) -> str:
    return PurePosixPath(file.path).suffix.lower()


def _import_file(cue: ExportedCue, file: ArchivedFile) -> bytes:
    importer, kind, cached_as = IMPORTERS[_ending(file)]
    source = f"res://{file.path}"
    mark = hashlib.md5(source.encode(), usedforsecurity=False).hexdigest()
    cached = f"res://.godot/imported/{file.name}-{mark}.{cached_as}"
    lines = [
        "[remap]",
        "",
        f"importer={quoted(importer)}",
        f"type={quoted(kind)}",
        f"uid={quoted(uid_of(source))}",
        f"path={quoted(cached)}",
        "",
        "[deps]",
        "",
        f"source_file={quoted(source)}",
        f"dest_files=[{quoted(cached)}]",
        "",
        "[params]",
        "",
        *(_wav_settings(cue, file) if importer == "wav" else _compressed_settings(cue)),
    ]
    return ("\n".join(lines) + "\n").encode()


def _wav_settings(cue: ExportedCue, file: ArchivedFile) -> list[str]:
    begin, end = 0, TO_THE_END
    if cue.loop and file.loop_points:
        begin, last = file.loop_points[0]
        end = last + 1
    return [
        "force/8_bit=false",
        "force/mono=false",
        "force/max_rate=false",
        "force/max_rate_hz=44100",
        "edit/trim=false",
        "edit/normalize=false",
        f"edit/loop_mode={FORWARD if cue.loop else DISABLED}",
        f"edit/loop_begin={begin}",
        f"edit/loop_end={end}",
        "compress/mode=0",
    ]


def _compressed_settings(cue: ExportedCue) -> list[str]:
    return [f"loop={'true' if cue.loop else 'false'}", "loop_offset=0", "bpm=0", "beat_count=0", "bar_beats=4"]


def _randomizer(cue: ExportedCue, path: str) -> bytes:
    """Return a resource that plays one file of a set at random, never the same twice in a row, at the file's level."""
    count = len(cue.files)
    head = f'[gd_resource type="AudioStreamRandomizer" load_steps={count + 1} format=3 uid={quoted(uid_of(path))}]'
    lines = [head, ""]
    for number, file in enumerate(cue.files, start=1):
        source = f"res://{file.path}"
        stream_address = f"uid={quoted(uid_of(source))} path={quoted(source)}"
        lines.append(f'[ext_resource type="AudioStream" {stream_address} id="{number}"]')
    lines += ["", "[resource]", f"streams_count = {count}"]
    for index in range(count):
        lines += [f'stream_{index}/stream = ExtResource("{index + 1}")', f"stream_{index}/weight = 1.0"]
    facts = {"cue": cue.label, "title": cue.title, "event": "/".join(cue.stated_event), "notes": cue.notes}
    lines += [f"metadata/{name} = {quoted(text)}" for name, text in facts.items() if text]
    return ("\n".join(lines) + "\n").encode()


def quoted(text: str) -> str:
    """Return text as a string of Godot's files."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    plain = escaped.replace("\n", "\\n").replace("\r", "\\r").replace("\t", "\\t").replace("\0", "")
    return f'"{plain}"'


def uid_of(source: str) -> str:
    """Return a resource's uid: 63 bits of the hash of its path, as ResourceUID writes a number."""
    number = int.from_bytes(hashlib.sha256(f"soundlist {source}".encode()).digest()[:8], "big") >> 1
    digits = ""
    while True:
        number, digit = divmod(number, len(UID_DIGITS))
        digits = UID_DIGITS[digit] + digits
        if not number:
            return f"uid://{digits}"
