"""Masters handed out with what is known of them: who made them, for which project and cue, and how.

Samples are copied byte for byte and every chunk stays; bext and iXML say more than before. Game
files never pass through here: names of projects and people stay out of what ships.
Sources: EBU Tech 3285 v2 (bext); EBU R 98 (coding history); iXML 3.01; ASWG-G006 (game audio in iXML).
"""

import hashlib
import os
import struct
import xml.etree.ElementTree as ET
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from audio_checks import wav
from audio_checks.audio.sound_files import open_sound
from audio_checks.errors import RenderRefused
from audio_checks.metadata import MOST_BYTES
from audio_checks.metadata.bext import FIXED_BYTES, coding_history_line
from audio_checks.metadata.ixml import ASWG_FIELDS, ROOT, read_ixml
from audio_checks.metadata.moving import BEXT_LOUDNESS, BEXT_VERSION, UNSET
from audio_checks.metadata.text import text_of

DESCRIPTION, ORIGINATOR, REFERENCE, DATE, TIME = (0, 256), (256, 32), (288, 32), (320, 10), (330, 8)
READ_BYTES = 1 << 20
HEADER = b'<?xml version="1.0" encoding="UTF-8"?>\n'


@dataclass(frozen=True)
class Provenance:
    """The known facts of a master; an empty one is left as the file has it.

    Attributes
    ----------
    project, studio : str
        What it was made for, and whose game that is.
    originator : str
        Who made it: a person or a company.
    number, name : str
        Of the cue.
    notes : str
        What it is for.
    made_on : str
        A day, as in 2026-11-21.
    contract : str
        The number of the contract that it was ordered by; ASWG-G006 has it as `billingCode`.
    state : str
        Of the work: approved, in review, placeholder.
    fields : mapping of str
        More fields of ASWG-G006, such as catId, library, usageRights.

    Raises
    ------
    ValueError
        A field that ASWG-G006 does not know, or a day that is none.
    """

    project: str = ""
    studio: str = ""
    originator: str = ""
    number: str = ""
    name: str = ""
    notes: str = ""
    made_on: str = ""
    contract: str = ""
    state: str = ""
    fields: Mapping[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if unknown := sorted(set(self.fields) - ASWG_FIELDS):
            raise ValueError(f"ASWG-G006 has no field {unknown[0]}")
        parts = self.made_on.split("-")
        if self.made_on and not ([len(part) for part in parts] == [4, 2, 2] and "".join(parts).isdigit()):
            raise ValueError(f'a day is written as 2026-11-21, not "{self.made_on}"')

    def aswg(self) -> dict[str, str]:
        """Return the fields of ASWG-G006 that are known."""
        values = {
            "project": self.project,
            "originator": self.originator,
            "originatorStudio": self.studio,
            "fxName": self.name,
            "orderRef": self.number,
            "notes": self.notes,
            "originationDate": self.made_on,
            "billingCode": self.contract,
            "state": self.state,
            **self.fields,
        }
        return {name: _plain(text) for name, text in values.items() if _plain(text)}


@dataclass(frozen=True)
class Exported:
    """A master that was handed out.

    Attributes
    ----------
    path : Path
        Of the copy.
    master_sha256, sha256 : str
        Digest of the master's bytes, and of the copy's.
    pcm_sha256 : str
        Digest of the sample bytes, the same for both.
    left : tuple of str
        What could not be written, in words.
    """

    path: Path
    master_sha256: str
    sha256: str
    pcm_sha256: str
    left: tuple[str, ...] = ()


def export_master(path: str | os.PathLike[str], out_path: str | os.PathLike[str], provenance: Provenance) -> Exported:
    """Write a copy of a master that says where it comes from.

    Parameters
    ----------
    path, out_path : path
        The master, which is only read, and the WAV file to write; of a FLAC master, its sound as WAV.
    provenance : Provenance
        What to write into bext (description, originator, reference, date, coding history) and iXML
        (PROJECT, NOTE and the fields of ASWG-G006).

    Returns
    -------
    Exported
        The same master and provenance give the same bytes.

    Raises
    ------
    RenderRefused
        `export:over-master`.
    Unreadable
        The master breaks a rule of structure.
    SandboxFailed
        A FLAC master could not be unpacked for want of time, memory or disk.
    """
    out = Path(out_path)
    if out.exists() and os.path.samefile(out, path):
        raise RenderRefused("the export would overwrite its master", "export:over-master", "name another place")
    with open_sound(path) as sound:
        layout = sound.layout
        kept = {chunk.id: chunk for chunk in reversed(layout.chunks) if chunk.size <= MOST_BYTES}
        payloads = {name: wav.chunk_payload(sound.file, kept[name]) for name in ("bext", "iXML") if name in kept}
        left: list[str] = []
        values = {"bext": _bext(payloads.get("bext", b""), layout, provenance)}
        try:
            values["iXML"] = _ixml(payloads.get("iXML", b""), layout, provenance)
        except ValueError as error:
            left.append(f"{error}; it is left as it is")
        wav.copy_wav(sound.file, layout, out, values)
        samples = hashlib.sha256()
        for raw in wav.raw_blocks(sound.file, layout):
            samples.update(raw)
        return Exported(out, sound.original_sha256(), _sha256(out), samples.hexdigest(), tuple(left))


def _plain(text: str) -> str:
    """Return a text that XML and a chunk of text can hold."""
    return "".join(character if character.isprintable() else " " for character in text).strip()


def _bext(old: bytes, layout: wav.WavLayout, provenance: Provenance) -> bytes:
    is_new = len(old) < FIXED_BYTES
    content = bytearray(FIXED_BYTES if is_new else old)
    if is_new:
        struct.pack_into("<H", content, BEXT_VERSION, 2)
        content[BEXT_LOUDNESS : BEXT_LOUDNESS + len(UNSET)] = UNSET
    cue = " ".join(part for part in (provenance.number, provenance.name) if part)
    about = "; ".join(part for part in (cue, provenance.project, provenance.contract, provenance.state) if part)
    for (at, width), text in (
        (DESCRIPTION, "" if text_of(bytes(content[:256])) else about),
        (ORIGINATOR, provenance.originator),
        (REFERENCE, provenance.number),
        (DATE, provenance.made_on),
    ):
        if _plain(text):
            content[at : at + width] = _fitting(_plain(text), width).ljust(width, b"\0")
    if not text_of(bytes(content[FIXED_BYTES:])):
        line = coding_history_line(layout.sample_rate_hz, layout.bit_depth, layout.channels)
        content[FIXED_BYTES:] = f"{line}\r\n".encode()
    return bytes(content)


def _fitting(text: str, width: int) -> bytes:
    """Return as much of a text as fits, in whole characters."""
    return text.encode()[:width].decode("utf-8", "ignore").encode()


def _ixml(old: bytes, layout: wav.WavLayout, provenance: Provenance) -> bytes:
    document = old.strip(b"\0").strip()
    if document:
        read_ixml(document)  # refuses document types, so that nothing can expand, and what is too large or too deep
        root = ET.fromstring(document, ET.XMLParser(target=ET.TreeBuilder(insert_comments=True)))  # noqa: S314 - see above
    else:
        root = ET.Element(ROOT)
        _say(root, "IXML_VERSION", "3.01")
        speed = ET.SubElement(root, "SPEED")
        _say(speed, "FILE_SAMPLE_RATE", str(layout.sample_rate_hz))
        _say(speed, "AUDIO_BIT_DEPTH", str(layout.bit_depth))
    for name, text in (("PROJECT", provenance.project), ("NOTE", provenance.notes)):
        if _plain(text):
            _say(root, name, _plain(text))
    fields = provenance.aswg()
    if fields:
        block = root.find("ASWG")
        block = ET.SubElement(root, "ASWG") if block is None else block
        for name, text in fields.items():
            _say(block, name, text)
    return HEADER + ET.tostring(root, encoding="unicode").encode() + b"\n"


def _say(parent: "ET.Element[str]", name: str, text: str) -> None:
    element = parent.find(name)
    (ET.SubElement(parent, name) if element is None else element).text = text


def _sha256(path: Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()
