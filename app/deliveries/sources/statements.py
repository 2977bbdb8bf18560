"""The sources of a take, in words, and the points still open about them, stated without a database."""

from collections.abc import Collection
from enum import StrEnum

from app.deliveries.schemas import Sources


class SourcePoint(StrEnum):
    """Something that a clearance asks for and a statement of sources leaves open."""

    NOT_STATED = "not_stated"
    NO_LICENCE = "no_licence"
    NO_RELEASE = "no_release"


def open_points(sources: Sources | None) -> list[tuple[SourcePoint, str]]:
    """Return the open points of a statement, each with the library or performer that it is about."""
    if sources is None:
        return [(SourcePoint.NOT_STATED, "")]
    licences = [(SourcePoint.NO_LICENCE, library.name) for library in sources.libraries if not library.licence]
    return licences + [
        (SourcePoint.NO_RELEASE, performer.name) for performer in sources.performers if not performer.release
    ]


POINT_WORDS = {
    SourcePoint.NOT_STATED: "its sources are not stated",
    SourcePoint.NO_LICENCE: "the licence of {} is not named",
    SourcePoint.NO_RELEASE: "the release of {} is not named",
}


def words_of_points(points: Collection[tuple[SourcePoint, str]]) -> str:
    """Return open points as one phrase; empty for none."""
    return "; ".join(POINT_WORDS[point].format(about) for point, about in points)


def words_of(sources: Sources) -> str:
    """Return a statement as one line of text."""
    parts = []
    if sources.from_scratch:
        parts.append("made from scratch")
    if sources.own_recordings:
        parts.append("own recordings")
    parts += [
        f"library {library.name} ({library.licence or 'no licence named'}{f', {library.file}' if library.file else ''})"
        for library in sources.libraries
    ]
    parts += [f"generated with {generated_part.tool}: {generated_part.part}" for generated_part in sources.generated]
    parts += [
        f"performed by {performer.name} (release: {performer.release or 'none named'})"
        for performer in sources.performers
    ]
    if sources.note:
        parts.append(sources.note)
    return "; ".join(parts)


def says_something(sources: Sources) -> bool:
    """Return whether a statement names any source at all; a note alone names none."""
    listed = sources.libraries or sources.generated or sources.performers
    return bool(sources.from_scratch or sources.own_recordings or listed)
