"""`naming`: the file is named as the project's code will look for it.

Why: names are written into the game's code before the sounds exist. A capital, a space or an
accent that one disk forgives is a missing sound on another.
How to fix: rename the file as proposed, or as the sound list names the cue. `__alt2` or `_altB`
marks an alternate of a delivery; what ships carries neither.
Source: the delivery spec, `[naming]`.
"""

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.findings import Finding
from audio_checks.sound_list import parse_file_name, slug
from audio_checks.spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio import AudioFile

FIGURES = ()
LONGEST_SHOWN = 80


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:  # noqa: ARG001
    """Where the spec says how names are made; a render is never named as an alternate."""
    return spec.naming.pattern is not None or spec.naming.extension is not None or spec.target is not None


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `naming:pattern`, `naming:extension` and, for renders, `naming:alternate`."""
    stem, alternate, _, extension = parse_file_name(file.name)
    pattern, ending = spec.naming.pattern, spec.naming.extension
    if pattern is not None and not re.fullmatch(pattern, stem, re.ASCII):
        proposed = slug(stem)
        renamed = proposed and re.fullmatch(pattern, proposed, re.ASCII)
        yield Finding(
            code="naming:pattern",
            message=f'name "{_short(stem)}", pattern {pattern}',
            fix=f"rename it to {_short(proposed)}{ending or extension}" if renamed else "rename it after the pattern",
        )
    if ending is not None and extension != ending:
        yield Finding(
            code="naming:extension",
            message=f'ending "{_short(extension)}", wanted "{ending}"',
            fix=f"rename it to end in {ending}" if extension.lower() == ending.lower() else f"export it as {ending}",
        )
    if spec.target is not None and alternate is not None:
        yield Finding(
            code="naming:alternate",
            message=f"the name marks alternate {alternate}; what ships is the picked one, under the cue's own name",
            fix=f"render the picked take again: it is named {_short(stem)}{extension}",
        )


def _short(name: str) -> str:
    return name if len(name) <= LONGEST_SHOWN else name[: LONGEST_SHOWN - 3] + "..."
