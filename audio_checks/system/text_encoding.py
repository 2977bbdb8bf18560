"""Text in the code pages that spreadsheets, script editors and ZIP packers still write.

UTF-8 and UTF-16 are recognized by their bytes. Any other code page is a guess by how likely the text is that it gives:
letters that continue words speak for it, symbols and capitals inside words against it.
"""

import unicodedata
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

CODE_PAGES: Mapping[str, str] = {
    "utf-8": "utf-8-sig",
    "utf-16": "utf-16",
    "utf-16-le": "utf-16-le",
    "utf-16-be": "utf-16-be",
    "windows-1252": "cp1252",
    "mac-roman": "mac_roman",
    "shift-jis": "cp932",
    "gb18030": "gb18030",
    "euc-kr": "cp949",
    "big5": "cp950",
    "euc-jp": "euc_jp",
    "windows-1250": "cp1250",
    "windows-1251": "cp1251",
    "koi8-r": "koi8-r",
    "windows-1253": "cp1253",
    "windows-1254": "cp1254",
    "iso-8859-1": "latin-1",
    "iso-8859-15": "iso8859-15",
    "cp437": "cp437",
    "cp850": "cp850",
}
"""The encodings that a caller may name, with what Python calls them."""
GUESSED = (
    *("windows-1252", "mac-roman", "shift-jis", "gb18030", "euc-kr", "big5"),
    *("windows-1250", "windows-1251", "koi8-r", "windows-1253", "euc-jp"),
)
GUESSED_FOR_ZIP = ("cp437", "cp850", "windows-1252", "shift-jis", "gb18030", "euc-kr")
ALPHABETS = {"windows-1251": "CYRILLIC", "koi8-r": "CYRILLIC", "windows-1253": "GREEK"}
FREQUENT_LETTERS = {"CYRILLIC": frozenset("оеаинтсрвлкмдпуыія"), "GREEK": frozenset("αοιετσνηυρπκμλςάίόέή")}
EAST_ASIAN = frozenset({"shift-jis", "gb18030", "euc-kr", "big5", "euc-jp"})
USUAL_HANGUL = frozenset(
    "이다는의에가을를고하한기리나지사어인아자로도서시해대정부들전수그있일보은장원스제으주성상구여오과선문동게할만소비"
    "공경면안적조요미무르실신세생방음열린닫발걸소음버튼클릭문검총배경환효과타격폭불물바람비점프걷뛰내림름려올라마우치트터"
    "라러레루니네노누드디두더데돌던거것개계관국군권금까나남년당대도된될때또라래력련명모목민반번법변본분불비사산상새"
    "생선설소속수순술습시식신실아안않애약양어언업에여역연영예오와외요용우운원위유육은음의이인일임입자작장재저전점"
)
SAMPLE_BYTES = 100_000
USUAL_LETTERS = frozenset("äöüßÄÖÜéèêëàâçùûîïôœæñáíóúìòãõåøÉÈÀÇÑÁÍÓÚÅØÆ")
TYPOGRAPHIC = frozenset("‘’“”„‚–—…•«»°²³½¼±×€£§©®™¿¡·\u00a0")


@dataclass(frozen=True)
class DecodedText:
    """The text of some bytes, and how its encoding became known."""

    text: str
    encoding: str  # a name of CODE_PAGES
    is_guess: bool = False
    others: tuple[str, ...] = ()  # encodings in which the bytes are text too, the likeliest first


class TextDamaged(ValueError):
    """The bytes are not text in the encoding that they are in otherwise, or that the caller named."""

    def __init__(self, encoding: str, before: str) -> None:
        super().__init__(f"a character is damaged or cut off; the file is {encoding.upper()} otherwise")
        self.encoding = encoding
        self.before = before  # the text before the damaged character


def decode_text(data: bytes, encoding: str | None = None, *, guessed: Iterable[str] = GUESSED) -> DecodedText:
    """Return the text of bytes, without a byte order mark.

    Parameters
    ----------
    data : bytes
        The whole text.
    encoding : str, optional
        A name of `CODE_PAGES`; without one it is recognized or guessed.
    guessed : iterable of str
        Code pages to choose from where the bytes are neither UTF-8 nor UTF-16.

    Raises
    ------
    TextDamaged
        A character is damaged. Says where.
    """
    if encoding is not None:
        return DecodedText(_strictly(data, encoding), encoding)
    if wide := _wide_encoding(data):
        return DecodedText(_strictly(data, wide), wide)
    try:
        return DecodedText(data.decode("utf-8-sig"), "utf-8")
    except UnicodeDecodeError:
        guess = data.decode("utf-8", "replace")
    damaged = guess.count("\ufffd")
    if sum(not letter.isascii() for letter in guess) >= 2 * damaged and _is_mostly_utf_8(data):
        return DecodedText(_strictly(data, "utf-8"), "utf-8")
    fitting = _fitting(data, guessed)
    if not fitting:
        return DecodedText(data.decode("latin-1"), "iso-8859-1", is_guess=True)
    best = fitting[0]
    return DecodedText(data.decode(CODE_PAGES[best]), best, is_guess=True, others=tuple(fitting[1:]))


def _is_mostly_utf_8(data: bytes) -> bool:
    """Whether most characters beyond ASCII are whole sequences of UTF-8, which other code pages form by chance only."""
    kept = data.decode("utf-8", "ignore")
    whole = sum(len(letter.encode()) for letter in kept if not letter.isascii())
    return 2 * whole >= sum(byte >= 0x80 for byte in data)


def _wide_encoding(data: bytes) -> str | None:
    """Return the bytes' kind of UTF-16, by their mark or by their zero bytes; None for another encoding."""
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return "utf-16"
    start = data[:400]
    for encoding, zeros, others in (("utf-16-le", start[1::2], start[::2]), ("utf-16-be", start[::2], start[1::2])):
        if len(zeros) > 1 and 2 * zeros.count(0) > len(zeros) and others.count(0) == 0:
            return encoding
    return None


def _strictly(data: bytes, encoding: str) -> str:
    codec = CODE_PAGES[encoding]
    try:
        return data.decode(codec).removeprefix("\ufeff")
    except UnicodeDecodeError as error:
        name = "utf-16" if encoding.startswith("utf-16") else encoding
        raise TextDamaged(name, data[: error.start].decode(codec, "ignore")) from None


def _fitting(data: bytes, guessed: Iterable[str]) -> list[str]:
    """Return the code pages in which the bytes are text, the likeliest first."""
    scored = []
    for rank, name in enumerate(guessed):
        try:
            data.decode(CODE_PAGES[name])
        except UnicodeDecodeError:
            continue
        sample = data[:SAMPLE_BYTES].decode(CODE_PAGES[name], "ignore")
        if name in EAST_ASIAN:
            score = _east_asian_score(sample, name)
        else:
            score = _alphabet_score(sample, ALPHABETS[name]) if name in ALPHABETS else _western_score(sample)
        scored.append((score, -rank, name))
    return [name for _, _, name in sorted(scored, reverse=True)]


def _western_score(text: str) -> float:
    """Return a text's likelihood, from 0 to 1 per character beyond ASCII; below 0 for one that is not likely."""
    score = count = 0.0
    for before, letter, after in zip(f" {text[:-1]}", text, f"{text[1:]} ", strict=True):
        if letter.isascii():
            continue
        count += 1
        if letter.isalpha() and _turns_to_capital(before, letter, after):
            score -= 2
        elif letter.isalpha() and letter.isupper() and not (before.isalpha() or after.isalpha()):
            score -= 1
        elif letter.isalpha() and _stands_among_accents(before, after):
            score -= 0.5  # Latin words have plain letters between
        elif letter in USUAL_LETTERS:
            score += 2
        elif letter.isalpha() and unicodedata.category(letter) in ("Lu", "Ll") and "LATIN" in unicodedata.name(letter):
            score += 1
        elif letter in TYPOGRAPHIC:
            is_inside = before.isalpha() and after.isalpha()
            leads = letter in "…•" and after.isalpha()
            score += 2.5 if is_inside and letter == "’" else -1 if is_inside else 0 if leads else 2
        else:
            score -= 2 if before.isalpha() or after.isalpha() else 1
    return score / (2 * count) if count else 0


def _stands_among_accents(before: str, after: str) -> bool:
    neighbours = [letter for letter in (before, after) if letter.isalpha()]
    return bool(neighbours) and not any(letter.isascii() for letter in neighbours)


def _alphabet_score(text: str, alphabet: str) -> float:
    """Return a text's likelihood, as `_western_score` does, by letters of one alphabet that form whole words."""
    score = count = 0.0
    for before, letter, after in zip(f" {text[:-1]}", text, f"{text[1:]} ", strict=True):
        if letter.isascii():
            continue
        count += 1
        is_among_latin = any(neighbour.isascii() and neighbour.isalpha() for neighbour in (before, after))
        is_of_alphabet = alphabet in unicodedata.name(letter, "")
        if not letter.isalpha():
            score += 1 if letter in TYPOGRAPHIC and not (before.isalpha() and after.isalpha()) else -2
        elif is_among_latin or not is_of_alphabet or _turns_to_capital(before, letter, after):
            score -= 2
        elif before.isalpha() or after.isalpha():
            score += 2 if letter.lower() in FREQUENT_LETTERS[alphabet] else 1
    return score / (2 * count) if count else 0


def _turns_to_capital(before: str, letter: str, after: str) -> bool:
    return (letter.isupper() and before.islower()) or (letter.islower() and after.isupper())


def _east_asian_score(text: str, encoding: str) -> float:
    """Return a text's likelihood, as `_western_score` does, by the characters that its language writes most."""
    score = count = 0.0
    for before, letter, after in zip(f" {text[:-1]}", text, f"{text[1:]} ", strict=True):
        if letter.isascii():
            continue
        count += 1
        code = ord(letter)
        is_alone = (before.isascii() and before.isalpha()) or (after.isascii() and after.isalpha())
        if 0x3040 <= code <= 0x30FF:  # kana
            score += 2 if encoding in ("shift-jis", "euc-jp") else -1
        elif 0xAC00 <= code <= 0xD7A3:  # hangul
            score += (1.9 if letter in USUAL_HANGUL else 0.6) if encoding == "euc-kr" else -1
        elif 0x4E00 <= code <= 0x9FFF:
            common = 1.6 if _is_common(letter, encoding) else 0.2
            score += 0 if is_alone else common
        elif 0x3000 <= code <= 0x303F or 0xFF01 <= code <= 0xFF5E:
            score += 1.5
        else:  # half-width kana, private characters, accented letters: what chance makes
            score -= 2
    return score / (2 * count) if count else 0


def _is_common(letter: str, encoding: str) -> bool:
    """Whether a character is of the first level of its character set, which holds those in daily use."""
    try:
        first = letter.encode(CODE_PAGES[encoding])[0]
    except UnicodeEncodeError:
        return False
    match encoding:
        case "shift-jis":
            return 0x88 <= first <= 0x97
        case "gb18030":
            return 0xB0 <= first <= 0xD7
        case "big5":
            return 0xA4 <= first <= 0xC6
        case _:
            return 0xB0 <= first <= 0xCF
