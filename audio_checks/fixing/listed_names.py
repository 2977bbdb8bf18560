"""Names of a sound list held against the naming rule of the delivery spec, and what resolves a contradiction."""

import re
from collections.abc import Iterable
from dataclasses import dataclass

from audio_checks.fixing.names import valid_name
from audio_checks.run.name_check import check_name
from audio_checks.spec import patterns
from audio_checks.spec.delivery_spec import DeliverySpec
from audio_checks.spec.sound_names import stem_of_file, stems_of

RULES = ("pattern", "tokens", "ucs", "not-portable", "reserved")
_LETTERS = ("a-z", "A-Z", "0-9")


@dataclass(frozen=True)
class NameRefusal:
    """A file name of the list that the spec refuses."""

    stem: str  # of the first variation
    rule: str  # one of RULES
    message: str
    proposed: str | None  # a file name for the cue, all of whose stems the spec accepts


def refused_name(name: str, file_name: str, variations: int, spec: DeliverySpec) -> NameRefusal | None:
    """Return a spec's refusal of the names of a cue, None where it accepts them.

    Parameters
    ----------
    name, file_name : str
        What the list says of the cue.
    variations : int
        How many files the cue has.
    spec : DeliverySpec
        The view of the cue's category.
    """
    stems = stems_of(name, file_name, variations)
    for stem in dict.fromkeys([*stems[:1], *stems[-1:]]):
        findings = check_name(stem + spec.ending, spec)
        refused = next((finding for finding in findings if _rule_of(finding.code) in RULES), None)
        if refused is not None:
            proposed = _proposed(name, file_name, variations, spec)
            return NameRefusal(stem, _rule_of(refused.code), refused.message, proposed)
    return None


def _rule_of(code: str) -> str:
    return code.partition(":")[2]


def _proposed(name: str, file_name: str, variations: int, spec: DeliverySpec) -> str | None:
    whole = stems_of(name, file_name, 1)[0]
    first = stems_of(name, file_name, variations)[0]
    for stem in dict.fromkeys((whole, first)):
        valid = valid_name(stem + spec.ending, spec)
        if valid is None:
            continue
        base = stem_of_file(valid)
        if stem == first != whole:  # the number that its variations get anyway
            base = re.sub(r"[_-]?0*1$", "", base)
        stems = stems_of("", base, variations)
        if stems and all(valid_name(stem + spec.ending, spec) == stem + spec.ending for stem in (stems[0], stems[-1])):
            return base
    return None


def pattern_admitting(pattern: str, names: Iterable[str]) -> str | None:
    """Return a pattern for all of these names, in the manner of another one; None where none is sure to be meant.

    Words of the letters that the names use are joined by the marks that they use.
    """
    distinct_names = list(dict.fromkeys(names))
    old = patterns.compiled(pattern)
    used = set("".join(distinct_names))
    accented = sorted(letter for letter in used if not letter.isascii() and letter.isalnum())
    classes = "".join(span for span in _LETTERS if _uses(used, span) or old.matches(span[0]) or old.matches(span[-1]))
    marks = "".join(mark for mark in "_.-" if mark in used or old.matches(f"a{mark}a") or old.matches(f"a{mark}1"))
    others = {letter for letter in used if not letter.isalnum() and letter not in "_.-"}
    if not distinct_names or others or not classes:
        return None
    word = f"[{classes}{''.join(accented)}]+"
    joined = marks.replace(".", r"\.") if len(marks) == 1 else f"[{marks}]"
    proposed = f"{word}(?:{joined}{word})*" if marks else word
    try:
        made = patterns.compiled(proposed)
    except patterns.PatternUnsupported:
        return None
    return proposed if all(made.matches(name) for name in distinct_names) else None


def _uses(used: set[str], span: str) -> bool:
    return any(span[0] <= letter <= span[-1] for letter in used)
