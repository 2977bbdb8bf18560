"""`naming`: the file is named as the project's code will look for it, and as every system can hold it.

Why: names are written into the game's code before the sounds exist. A capital, a space or an
accent that one disk forgives is a missing sound on another; `con.wav` cannot be made on Windows at
all, and of `Laser.wav` and `laser.wav` in one folder only one survives a copy to it.
How to fix: rename the file as proposed, or as the sound list names the cue. `__alt2` or `_altB`
marks an alternate of a delivery; what ships carries neither. A name that the list gives and the spec
refuses (`naming:listed`) is kept: the list or the naming rule is changed, so that the two agree.
Source: the delivery spec, `[naming]`: a pattern, tokens, or the grammar of the Universal Category
System; names reserved on Windows and characters no system forbids (`portable`).
"""

import os
import unicodedata
from collections import defaultdict
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec import patterns
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec
from audio_checks.spec.sound_names import parse_file_name, word_slug

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile
    from audio_checks.report.judged import JudgedFile

SEVERITY = "error"
LABEL = "Name"
IN_CATEGORIES = True
FIGURES = ()
LONGEST_SHOWN = 80
RESERVED = frozenset(
    {"con", "prn", "aux", "nul", "conin$", "conout$"}
    | {f"{port}{number}" for port in ("com", "lpt") for number in "0123456789¹²³"}
)
FORBIDDEN = '<>:"/\\|?*'  # on Windows, as are control characters
MOST_BYTES = 255  # of a name, in UTF-8


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply where the spec has a rule for names; a render is never named as an alternate."""
    naming = spec.naming
    rule = naming.pattern is not None or naming.tokens or naming.grammar is not None or naming.extension is not None
    return bool(rule) or naming.portable or spec.target is not None


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield the faults of one name.

    `naming:pattern`, `naming:tokens` or `naming:ucs` for the rule it breaks, `naming:extension`, `naming:reserved`
    and `naming:not-portable`, and for renders `naming:alternate`.
    """
    yield from of_name(file.name, spec)


def of_name(name: str, spec: DeliverySpec) -> Iterator[Finding]:
    """Yield the faults of one name; no file is needed for it."""
    stem, alternate, _, extension = parse_file_name(name)
    broken = list(_against_rule(stem, extension, spec))
    yield from broken
    ending = spec.naming.extension
    if ending is not None and extension != ending:
        yield Finding(
            code="naming:extension",
            message=f'ending "{_short(extension)}", wanted "{ending}"',
            fix=f"rename it to end in {ending}" if extension.lower() == ending.lower() else f"export it as {ending}",
        )
    if spec.naming.portable and not broken:
        yield from _portable(name)
    if spec.target is not None and alternate is not None:
        yield Finding(
            code="naming:alternate",
            message=f"the name marks alternate {alternate}; what ships is the picked one, under the cue's own name",
            fix=f"render the picked take again: it is named {_short(stem)}{extension}",
        )


def check_set(files: "Sequence[JudgedFile]") -> Iterator[tuple[int, Finding]]:
    """Yield `naming:twins` for names in one folder that differ only in case or in how Unicode writes them."""
    by_name: dict[str, list[int]] = defaultdict(list)
    for index, file in enumerate(files):
        if file.spec.naming.portable:
            by_name[_folded(file.path)].append(index)
    for places in by_name.values():
        names = {os.path.normpath(files[file_index].path) for file_index in places}
        if len(names) < 2:
            continue
        for index in places:
            twin = os.path.basename(min(names - {os.path.normpath(files[index].path)}))
            yield (
                index,
                Finding(
                    code="naming:twins",
                    message=f"{_short(twin)} in the same folder has the same name on Windows and macOS",
                    fix="rename one of the two: they differ only in case, or in how accents are written",
                ),
            )


def _against_rule(stem: str, extension: str, spec: DeliverySpec) -> Iterator[Finding]:
    naming = spec.naming
    if naming.pattern is not None and not (pattern := patterns.compiled(naming.pattern)).matches(stem):
        proposed = word_slug(stem)
        renamed = proposed and pattern.matches(proposed)
        ending = naming.extension or extension
        yield Finding(
            code="naming:pattern",
            message=f'name "{_short(stem)}", pattern {naming.pattern}',
            fix=f"rename it to {_short(proposed)}{ending}" if renamed else "rename it after the pattern",
        )
    if naming.tokens:
        from audio_checks.spec import name_tokens  # only where a spec asks for it

        why = name_tokens.misfit(stem, naming.tokens, naming.separator)
        if why is not None:
            form = naming.separator.join(f"[{token.name}]" if token.optional else token.name for token in naming.tokens)
            yield Finding(
                code="naming:tokens",
                message=f'name "{_short(stem)}": {_short(why, 2)}',
                fix=f"rename it after the form {form}",
            )
    if naming.grammar == "ucs":
        from audio_checks.spec import ucs

        why = ucs.misfit(stem, naming.ucs_ids)
        if why is not None:
            yield Finding(
                code="naming:ucs",
                message=f'name "{_short(stem)}": {_short(why, 2)}',
                fix="rename it after CatID-UserCategory_VendorCategory-FXName_CreatorID_SourceID",
            )


def _portable(name: str) -> Iterator[Finding]:
    if name.partition(".")[0].rstrip(" ").lower() in RESERVED:
        yield Finding(
            code="naming:reserved",
            message=f'name "{_short(name)}": Windows keeps it for a device, and no file can be called so there',
            fix="rename it; with anything before or after the word it is allowed",
        )
    why = _not_portable(name)
    if why is not None:
        yield Finding(
            code="naming:not-portable",
            message=f'name "{_short(name)}" {why}',
            fix="rename it with letters, digits, _ and -",
        )


def _not_portable(name: str) -> str | None:
    forbidden = next(
        (character for character in name if character in FORBIDDEN or unicodedata.category(character) in ("Cc", "Cs")),
        None,
    )
    if forbidden is not None:
        shown = f'"{forbidden}"' if forbidden.isprintable() else "a control character"
        return f"holds {shown}, which Windows allows in no name"
    if name != name.strip(" ") or name.endswith("."):
        return "begins or ends with a space or a dot, which Windows drops"
    stem = parse_file_name(name).stem
    if stem != stem.strip(" ") or stem.endswith("."):
        return "has a space or a dot before its ending"
    length = len(name.encode("utf-8", "surrogatepass"))
    return f"has {length} bytes, at most {MOST_BYTES} can be held" if length > MOST_BYTES else None


def _folded(path: str) -> str:
    """Return a path as a disk sees it that ignores case and how Unicode is written."""
    return unicodedata.normalize("NFC", unicodedata.normalize("NFC", os.path.normpath(path)).casefold())


def _short(name: str, times: int = 1) -> str:
    longest = LONGEST_SHOWN * times
    return name if len(name) <= longest else name[: longest - 3] + "..."
