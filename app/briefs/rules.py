"""Answers of the brief: what fits a question, what is open, and how an answer reads; without a database."""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from app.briefs.errors import AnswerInvalid, QuestionUnknown
from app.briefs.questions import BY_KEY, EVERYTHING, QUESTIONS, AnswerKind, Question
from app.core.errors import FieldProblem

Answer = Mapping[str, Any]  # value, is_unknown, note, revision, answered_by, answered_at
Answers = Mapping[str, Answer]

MAX_TEXT, MAX_LINE = 4_000, 200
MAX_LINES, MAX_SCENES, MAX_CATEGORIES, MAX_TOKENS, MAX_WORDS = 100, 200, 60, 12, 50
MAX_NUMBER = 1_000_000
CASES = ("lower", "upper", "capital", "any")
SEPARATORS = ("_", "-", ".")
_CATEGORY = re.compile(r"[^\W_][\w-]*")
_TOKEN_NAME = re.compile(r"[a-z][a-z0-9 _-]{0,29}")
_WORD = re.compile(r"[A-Za-z0-9]{1,30}")
_UNSEEN = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u200b-\u200f\u2028-\u202e\u2060-\u2069\ufeff\ud800-\udfff]")


@dataclass(frozen=True)
class Completeness:
    """The progress of a brief's answers; an answer "I don't know yet" counts as open."""

    answered: int
    total: int
    open: tuple[str, ...]  # keys, in their order
    open_required: tuple[str, ...]


class _Unfit(Exception):
    """The reason a value does not fit its question."""


def question_of(key: str) -> Question:
    """Return a question, or raise QuestionUnknown."""
    question = BY_KEY.get(key)
    if question is None:
        raise QuestionUnknown(
            f'the brief has no question "{key}"', errors=[{"where": key, "message": "no such question"}]
        )
    return question


def applies(question: Question, answers: Answers) -> bool:
    """Whether a question is asked, given the answers so far."""
    if question.only_if is None:
        return True
    key, values = question.only_if
    return answers.get(key, {}).get("value") in values


def is_answered(question: Question, answers: Answers) -> bool:
    """Whether a question has an answer other than "I don't know yet"."""
    answer = answers.get(question.key)
    return answer is not None and not answer["is_unknown"]


def completeness(answers: Answers) -> Completeness:
    """Return the number of asked questions with an answer, and those that are open."""
    asked = [question for question in QUESTIONS if applies(question, answers)]
    still_open = [question for question in asked if not is_answered(question, answers)]
    return Completeness(
        answered=len(asked) - len(still_open),
        total=len(asked),
        open=tuple(question.key for question in still_open),
        open_required=tuple(question.key for question in still_open if question.required),
    )


def tidy_text(text: str) -> str:
    """Return text with plain line ends and without invisible characters."""
    return _UNSEEN.sub("", text.replace("\r\n", "\n").replace("\r", "\n")).strip()


def fitted(key: str, value: Any) -> Any:
    """Return an answer's value as it is stored, None where it is empty; raise AnswerInvalid where it does not fit."""
    question = question_of(key)
    try:
        return None if value is None else _FITTERS[question.kind](question, value)
    except _Unfit as misfit:
        raise AnswerInvalid(
            f"{question.text} {misfit}", errors=[FieldProblem(where=key, message=str(misfit))]
        ) from None


def _text(value: Any, longest: int) -> str:
    if not isinstance(value, str):
        raise _Unfit("the answer is a text")
    text = tidy_text(value)
    if len(text) > longest:
        raise _Unfit(f"{len(text):,} characters; at most {longest:,} are kept")
    return text


def _list(value: Any, longest: int) -> list[Any]:
    if not isinstance(value, list):
        raise _Unfit("the answer is a list")
    if len(value) > longest:
        raise _Unfit(f"{len(value):,} entries; at most {longest:,} are kept")
    return value


def _keys(question: Question, value: Any) -> list[str]:
    known = [choice.key for choice in question.choices]
    picked = _list(value, len(known))
    if any(key not in known for key in picked):
        raise _Unfit(f"choose from: {', '.join(known)}")
    return [key for key in known if key in picked]


def _fit_choice(question: Question, value: Any) -> str | None:
    return _keys(question, [value])[0] if value != "" else None


def _fit_choices(question: Question, value: Any) -> list[str] | None:
    return _keys(question, value) or None


def _fit_text(_question: Question, value: Any) -> str | None:
    return _text(value, MAX_TEXT) or None


def _fit_number(_question: Question, value: Any) -> float | None:
    if isinstance(value, bool) or not isinstance(value, int | float) or not 0 < value <= MAX_NUMBER:
        raise _Unfit(f"the answer is a number above 0, at most {MAX_NUMBER:,}")
    return float(value)


def _fit_lines(_question: Question, value: Any) -> list[str] | None:
    lines = [_text(line, MAX_LINE) for line in _list(value, MAX_LINES)]
    return [line for line in lines if line] or None


def _fit_per_category(question: Question, value: Any) -> dict[str, list[str]] | None:
    if not isinstance(value, dict):
        raise _Unfit("the answer is a table of categories")
    if len(value) > MAX_CATEGORIES:
        raise _Unfit(f"{len(value)} categories; at most {MAX_CATEGORIES} are kept")
    for category in value:
        if len(category) > MAX_LINE or not _CATEGORY.fullmatch(category):
            raise _Unfit("a category has letters, digits and - only")
    return {category.lower(): _keys(question, picked) for category, picked in value.items()} or None


def _fit_per_scene(_question: Question, value: Any) -> list[dict[str, Any]] | None:
    scenes = []
    for scene in _list(value, MAX_SCENES):
        if not isinstance(scene, dict) or scene.keys() - {"scene", "ambience", "music"}:
            raise _Unfit("a scene has a name, an ambience, and whether music plays")
        name = _text(scene.get("scene", ""), MAX_LINE)
        music = scene.get("music", False)
        if not isinstance(music, bool):
            raise _Unfit("music is true or false")
        ambience = _text(scene.get("ambience", ""), MAX_LINE * 5)
        if name:
            scenes.append({"scene": name, "ambience": ambience, "music": music})
        elif ambience:
            raise _Unfit("give each scene a name")
    return scenes or None


def _fit_names(_question: Question, value: Any) -> dict[str, Any] | None:
    if not isinstance(value, dict) or value.keys() - {"tokens", "separator", "extension"}:
        raise _Unfit("the answer has tokens, a separator and an extension")
    separator, extension = value.get("separator", "_"), value.get("extension", ".wav")
    if separator not in SEPARATORS:
        raise _Unfit("the separator is one of _ - .")
    if extension != ".wav" and extension != ".flac":
        raise _Unfit("the extension is .wav or .flac")
    tokens = [_token(token) for token in _list(value.get("tokens", []), MAX_TOKENS)]
    if not tokens:
        return None
    if all(token.get("optional") for token in tokens):
        raise _Unfit("a name needs a part that is always there")
    names = [token["name"] for token in tokens]
    if len(set(names)) < len(names):
        raise _Unfit("two parts have the same name")
    return {"tokens": tokens, "separator": separator, "extension": extension}


def _token(token: Any) -> dict[str, Any]:
    if not isinstance(token, dict) or token.keys() - {"name", "case", "digits", "one_of", "optional", "repeats"}:
        raise _Unfit("a part has a name, and either letters, digits or words")
    name = token.get("name")
    kept: dict[str, Any] = {}
    if not isinstance(name, str) or not _TOKEN_NAME.fullmatch(name):
        raise _Unfit("a part’s name begins with a small letter, and has at most 30")
    if token.get("one_of"):
        words = _list(token["one_of"], MAX_WORDS)
        if not all(isinstance(word, str) and _WORD.fullmatch(word) for word in words):
            raise _Unfit("the words of a part have letters and digits only")
        kept["one_of"] = list(dict.fromkeys(words))
    elif token.get("digits") is not None:
        digits = token["digits"]
        if isinstance(digits, bool) or not isinstance(digits, int) or not 1 <= digits <= 6:
            raise _Unfit("a number has 1 to 6 digits")
        kept["digits"] = digits
    else:
        case = token.get("case", "lower")
        if case not in CASES:
            raise _Unfit(f"letters are one of: {', '.join(CASES)}")
        kept["case"] = case
    flags = {flag: True for flag in ("optional", "repeats") if token.get(flag) is True}
    return {"name": name, **kept, **flags}


_FITTERS: Mapping[AnswerKind, Callable[[Question, Any], Any]] = {
    AnswerKind.CHOICE: _fit_choice,
    AnswerKind.CHOICES: _fit_choices,
    AnswerKind.TEXT: _fit_text,
    AnswerKind.NUMBER: _fit_number,
    AnswerKind.LINES: _fit_lines,
    AnswerKind.PER_CATEGORY: _fit_per_category,
    AnswerKind.PER_SCENE: _fit_per_scene,
    AnswerKind.NAMES: _fit_names,
}

UNKNOWN = "Not known yet"


def in_words(question: Question, answer: Answer | None) -> str:
    """Return an answer as a text of one or more lines; empty where there is none."""
    if answer is None:
        return ""
    answer_text = UNKNOWN if answer["is_unknown"] else "\n".join(_lines_of(question, answer["value"]))
    return "\n".join(part for part in (answer_text, answer["note"]) if part)


def _lines_of(question: Question, value: Any) -> Iterator[str]:
    labels = {choice.key: choice.label for choice in question.choices}
    match question.kind:
        case AnswerKind.CHOICE:
            yield labels.get(value, value)
        case AnswerKind.CHOICES:
            yield from (labels.get(key, key) for key in value)
        case AnswerKind.TEXT:
            yield value
        case AnswerKind.NUMBER:
            yield f"{value:g} {question.unit}".strip()
        case AnswerKind.LINES:
            yield from value
        case AnswerKind.PER_CATEGORY:
            for category, picked in value.items():
                effects = ", ".join(labels.get(key, key).lower() for key in picked) or "nothing"
                yield f"{'Everything' if category == EVERYTHING else category}: {effects}"
        case AnswerKind.PER_SCENE:
            for scene in value:
                heard = [scene["ambience"] or "no ambience", *(["music"] if scene["music"] else [])]
                yield f"{scene['scene']}: {', '.join(heard)}"
        case AnswerKind.NAMES:
            yield value["separator"].join(token_in_words(token) for token in value["tokens"]) + value["extension"]


def token_in_words(token: Mapping[str, Any]) -> str:
    """Return one part of a name as a person reads it: [variation 01]."""
    shape = "/".join(token["one_of"]) if "one_of" in token else "1".zfill(token["digits"]) if "digits" in token else ""
    named = f"{token['name']} {shape}".strip() + (" …" if token.get("repeats") else "")
    return f"({named})" if token.get("optional") else f"[{named}]"


def is_same(first: Answer | None, other: Answer | None) -> bool:
    """Whether two answers state the same, no matter who gave them."""
    stated = [(answer["value"], answer["is_unknown"], answer["note"]) if answer else None for answer in (first, other)]
    return stated[0] == stated[1]


def differences(before: Answers, after: Answers) -> Sequence[Question]:
    """Return the questions whose answers differ, in their order."""
    return [question for question in QUESTIONS if not is_same(before.get(question.key), after.get(question.key))]


def number_of(question: Question) -> int:
    """Return the number that a question has on the page, from 1."""
    return QUESTIONS.index(question) + 1
