"""The metadata of a file: bext, iXML, LIST/INFO, LIST/adtl, cue, smpl and inst.

All of it is untrusted: each reader is bounded, and damaged data is reported in a sentence and
left out, for no chunk of this kind makes a sound unreadable.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, fields
from typing import Any, TypeVar

from audio_checks.metadata.bext import FIELDS as BEXT_FIELDS
from audio_checks.metadata.bext import read_bext
from audio_checks.metadata.ixml import ASWG_FIELDS, read_ixml
from audio_checks.metadata.lists import read_info, read_labels, read_lengths
from audio_checks.metadata.points import CuePoint, Instrument, read_cue, read_inst, read_smpl

__all__ = ["ASWG_FIELDS", "BEXT_FIELDS", "CHUNKS", "MOST_BYTES", "CuePoint", "Instrument", "Metadata", "read_metadata"]

T = TypeVar("T")

CHUNKS = frozenset({"bext", "iXML", "LIST", "cue ", "smpl", "inst"})
MOST_BYTES = 1 << 20  # of one chunk, and of all of them together four times as much
MOST_CHUNKS = 64
SHOWN_FIELDS, SHOWN_CHARACTERS, SHOWN_POINTS = 128, 256, 256  # in a report


@dataclass(frozen=True)
class Metadata:
    """A file's statements on itself.

    Attributes
    ----------
    fields : dict of str
        Texts by name: `bext.Originator`, `iXML.PROJECT`, `iXML.ASWG.catId`, `INFO.ICMT`, and for FLAC
        `Vorbis.TITLE`. Only those that hold something.
    cue_points : tuple of CuePoint
        Marked places.
    instrument : Instrument or None
        What `smpl` and `inst` say of notes.
    damaged : tuple of str
        A sentence for each chunk that cannot be read.
    """

    fields: dict[str, str] = field(default_factory=dict)
    cue_points: tuple[CuePoint, ...] = ()
    instrument: Instrument | None = None
    damaged: tuple[str, ...] = ()

    def to_dict(self) -> dict[str, Any]:
        """Return its values for a report: bounded, and only those that exist."""
        shown: dict[str, Any] = {}
        if self.fields:
            some = list(self.fields.items())[:SHOWN_FIELDS]
            shown["fields"] = {name[:SHOWN_CHARACTERS]: text[:SHOWN_CHARACTERS] for name, text in some}
        if self.cue_points:
            shown["cue_points"] = [
                {"frame": point.frame, "label": point.label[:SHOWN_CHARACTERS]}
                for point in self.cue_points[:SHOWN_POINTS]
            ]
        if self.instrument is not None:
            given = {attribute.name: getattr(self.instrument, attribute.name) for attribute in fields(Instrument)}
            shown["instrument"] = {name: value for name, value in given.items() if value is not None}
        if self.damaged:
            shown["damaged"] = list(self.damaged)
        return shown


def read_metadata(chunks: Iterable[tuple[str, bytes]]) -> Metadata:
    """Return the content of a file's chunks.

    Parameters
    ----------
    chunks : iterable of (id, payload)
        Of ids in `CHUNKS`, in the file's order; of each kind the first one that can be read counts.
        A payload is at most `MOST_BYTES` long; a longer chunk is passed as what fits.

    Returns
    -------
    Metadata
        Empty where there are no such chunks.
    """
    some = list(chunks)[:MOST_CHUNKS]
    if not some:
        return Metadata()
    reading = _Reading(some)
    texts = {
        f"{group}.{name}": text
        for group, group_fields in (
            ("bext", reading.first("bext", read_bext)),
            ("iXML", reading.first("iXML", read_ixml)),
            ("INFO", reading.first("LIST", read_info)),
        )
        for name, text in (group_fields or {}).items()
    }
    labels = reading.first("LIST", read_labels) or {}
    lengths = reading.first("LIST", read_lengths) or {}
    points = reading.first("cue ", lambda payload: read_cue(payload, labels, lengths)) or ()
    notes = _both(reading.first("smpl", read_smpl), reading.first("inst", read_inst))
    return Metadata(texts, points, notes, tuple(reading.damaged))


def _both(sampler: Instrument | None, instrument: Instrument | None) -> Instrument | None:
    """Return the two chunks' word together; `inst` says more, and wins."""
    if sampler is None or instrument is None:
        return sampler or instrument
    values = {attribute.name: getattr(instrument, attribute.name) for attribute in fields(Instrument)}
    return Instrument(**{name: getattr(sampler, name) if value is None else value for name, value in values.items()})


class _Reading:
    """One reading of the chunks: what is damaged is noted once."""

    def __init__(self, chunks: list[tuple[str, bytes]]) -> None:
        self._chunks = chunks
        self.damaged: dict[str, None] = {}

    def first(self, kind: str, read: Callable[[bytes], T]) -> T | None:
        """Return the content of the first chunk of a kind that says something."""
        for name, payload in self._chunks:
            if name == kind:
                try:
                    parsed = read(payload)
                except ValueError as error:
                    self.damaged[str(error)] = None
                    continue
                if parsed:
                    return parsed
        return None
