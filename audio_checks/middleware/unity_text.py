"""The text that Unity writes: documents, their values and references."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field

from audio_checks.middleware.reading import NotRead

MOST_DOCUMENTS = 2_000_000
LONGEST_VALUE = 1_024
KEPT = frozenset(
    {
        "GameObject", "AudioSource", "MonoBehaviour", "PrefabInstance", "Prefab", "PlayableAsset",
        "AudioMixerController", "AudioMixerGroupController", "AudioMixerEffectController",
        "AudioMixerSnapshotController", "AudioRandomContainer", "AudioContainerElement",
    }
)  # fmt: skip
_HEAD = re.compile(r"^--- !u!(\d{1,10}) &(-?\d{1,20})( stripped)?\n([A-Za-z]{1,64}):", re.MULTILINE)
_MODIFICATION = re.compile(
    r"^    - target: \{fileID: (-?\d{1,20}), guid: ([0-9a-f]{32}),\s{1,32}type: \d\}\n"
    r" {6}propertyPath: ([^\n]{0,512})\n"
    r" {6}value: ?([^\n]{0,1024})\n"
    r" {6}objectReference: \{fileID: (-?\d{1,20})(?:, guid: ([0-9a-f]{32}))?",
    re.MULTILINE,
)
Change = tuple[str, str, tuple[str, str]]  # property, value, and the id and guid of what it refers to
_PATTERNS: dict[tuple[str, int], re.Pattern[str]] = {}


@dataclass(slots=True)
class Document:
    """One object of a file: its class's name, its id, its text."""

    kind: str
    id: str
    text: str
    is_stripped: bool = False
    _modifications: dict[tuple[str, str], list[Change]] | None = field(default=None, repr=False)

    def modifications(self) -> dict[tuple[str, str], list[Change]]:
        """Return the changes of an instance of a prefab, by the object's id and the prefab's guid."""
        if self._modifications is None:
            self._modifications = {}
            for match in _MODIFICATION.finditer(self.text):
                change = match[3], match[4].strip(), (match[5], match[6] or "")
                self._modifications.setdefault((match[1], match[2]), []).append(change)
        return self._modifications

    def source_prefab(self) -> str:
        """Return the guid of the prefab that an instance is made from."""
        return flow(self.text, "m_SourcePrefab")[1] or flow(self.text, "m_ParentPrefab")[1]


def documents(text: str) -> Iterator[Document]:
    """Yield the documents of a text of those classes that matter here, in order."""
    heads = list(_HEAD.finditer(text))
    if len(heads) > MOST_DOCUMENTS:
        raise NotRead(f"has {len(heads):,} documents; at most {MOST_DOCUMENTS:,} are read")
    for at, head in enumerate(heads):
        if head[4] in KEPT:
            end = heads[at + 1].start() if at + 1 < len(heads) else len(text)
            kind = "PrefabInstance" if head[4] == "Prefab" else head[4]
            yield Document(kind, head[2], text[head.end() : end], bool(head[3]))


def value(text: str, key: str, *, indent: int = 2) -> str:
    """Return the first plain value of a key at this indent; empty where there is none."""
    pattern = _PATTERNS.get((key, indent))
    if pattern is None:
        pattern = re.compile(rf"^ {{{indent}}}{re.escape(key)}: ?([^\n]{{0,{LONGEST_VALUE}}})$", re.MULTILINE)
        _PATTERNS[key, indent] = pattern
    match = pattern.search(text)
    return match[1].strip() if match is not None else ""


def flow(text: str, key: str) -> tuple[str, str]:
    """Return the id and the guid that a reference such as `{fileID: 1, guid: …, type: 3}` names; empty where none."""
    pattern = _PATTERNS.get((key, -1))
    if pattern is None:
        pattern = re.compile(
            rf"^  {re.escape(key)}: \{{fileID: (-?\d{{1,20}})(?:,\s{{1,32}}guid: ([0-9a-f]{{32}}))?", re.MULTILINE
        )
        _PATTERNS[key, -1] = pattern
    match = pattern.search(text)
    return (match[1], match[2] or "") if match is not None else ("", "")
