"""A delivery spec as one page to print: what files must be, how categories differ, and what the game's files are."""

import json
from collections.abc import Iterator, Mapping
from typing import Any

import audio_checks
from app.core.typesetting import typeset

# What people wrote comes in as data and is never read as markup.
LOOK = """
#let spec = json(bytes(sys.inputs.spec))
#set document(title: "Delivery spec: " + spec.title, date: none)
#set page(
  paper: "a4", margin: (x: 16mm, y: 14mm),
  footer: context text(8pt, fill: luma(90))[#spec.title #h(1fr) #counter(page).display("1 of 1", both: true)],
)
#set text(font: serif, size: 9.5pt)
#set par(leading: 0.5em)
#let facts(rows) = table(
  columns: (46mm, 1fr), stroke: (x, y) => (bottom: 0.25pt + luma(170)), inset: (x: 1mm, y: 1.1mm),
  ..for row in rows { (row.at(0), row.at(1)) },
)
#text(16pt)[Delivery spec]
#linebreak()
#text(10pt)[#spec.title, version #spec.version]
#v(2mm)
#text(11pt, weight: "bold")[Each master]
#facts(spec.rules)
#if spec.categories.len() > 0 [
  #text(11pt, weight: "bold")[Where a category differs]
  #facts(spec.categories)
]
#if spec.targets.len() > 0 [
  #text(11pt, weight: "bold")[Made of it for the game]
  #facts(spec.targets)
]
"""
ACCEPTED = (
    ("containers", "File", ""),
    ("encodings", "Encoding", ""),
    ("sample_rates_hz", "Sample rate", "Hz"),
    ("bit_depths", "Bit depth", "bit"),
    ("channels", "Channels", ""),
    ("layouts", "Channel layout", ""),
    ("duration_s", "Length", "s"),
    ("bit_rate_kbps", "Bit rate", "kbit/s"),
)
SEVERITIES = {"error": "Comes back", "warning": "A warning only", "off": "Not checked"}
CHANNELS = {"master": "channels of the master", 1: "mono", 2: "stereo"}
MOST_CHARS = 400


def spec_pdf(spec: audio_checks.DeliverySpec, *, title: str, version: int) -> bytes:
    """Return a spec as a PDF, the same bytes for the same spec; see `typeset` for what is raised."""
    content = spec_content(spec, title=title, version=version)
    return typeset(LOOK, {"spec": json.dumps(content, ensure_ascii=False)})


def spec_content(spec: audio_checks.DeliverySpec, *, title: str, version: int) -> dict[str, Any]:
    """Return the content of the page, as names and values."""
    rules = list(_rules(spec.tables))
    categories = [(name, _differing(spec, name, rules)) for name in spec.categories]
    return {
        "title": title[:MOST_CHARS],
        "version": version,
        "rules": rules,
        "categories": [category for category in categories if category[1]],
        "targets": [(name, _target(target)) for name, target in spec.tables.get("targets", {}).items()],
    }


def _rules(tables: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    accepted = tables.get("accept", {})
    for key, name, unit in ACCEPTED:
        if key in accepted:
            yield name, _value(accepted[key], unit)
    limits = tables.get("limits", {})
    for check in audio_checks.all_checks().values():
        for limit in check.limits:
            if limit.key in limits:
                yield limit.label, _value(limits[limit.key], limit.unit)
    naming = tables.get("naming", {})
    for key, name in (("pattern", "File name matches"), ("grammar", "File name follows"), ("extension", "Ends in")):
        if isinstance(naming.get(key), str):
            yield name, naming[key][:MOST_CHARS]
    if adds := tables.get("engine", {}).get("adds"):
        yield "The game adds", f"{', '.join(adds)}: deliver without"
    by_severity: dict[str, list[str]] = {}
    for check_name, severity in tables.get("checks", {}).items():
        by_severity.setdefault(severity, []).append(check_name.replace("-", " "))
    for severity, names in by_severity.items():
        yield SEVERITIES[severity], ", ".join(names)


def _differing(spec: audio_checks.DeliverySpec, category: str, base: list[tuple[str, str]]) -> str:
    """Return the rules of a category that are not those of each master, in one line."""
    own = [rule for rule in _rules(spec.for_category(category).tables) if rule not in base]
    return "; ".join(f"{name}: {value}" for name, value in own)


def _target(target: Mapping[str, Any]) -> str:
    channels = target.get("channels")
    facts = [
        f"{target['sample_rate_hz']:,} Hz" if "sample_rate_hz" in target else "",
        f"{target['bit_depth']} bit" if "bit_depth" in target else "",
        str(target.get("encoding", "")),
        "" if channels is None else CHANNELS.get(channels, f"{channels} channels"),
    ]
    return ", ".join(fact for fact in facts if fact)


def _value(value: Any, unit: str) -> str:
    """Return a limit in words: several choices, a range, or one number."""
    if isinstance(value, Mapping):
        least, most = value.get("min"), value.get("max")
        words = [
            f"at least {_number(least)}" if least is not None else "",
            f"at most {_number(most)}" if most is not None else "",
        ]
        return f"{', '.join(word for word in words if word)} {unit}".strip()
    if isinstance(value, list | tuple):
        *before, last = [_number(number) for number in value] or [""]
        return f"{', '.join(before)}{' or ' if before else ''}{last} {unit}".strip()
    return f"{_number(value)} {unit}".strip()


def _number(value: Any) -> str:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return str(value)[:MOST_CHARS]
    return f"{value:,g}".replace("-", "\N{MINUS SIGN}") if abs(value) < 1e6 else f"{value:,}"
