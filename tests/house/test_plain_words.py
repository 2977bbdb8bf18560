"""Emails, refusals, comments and pages use standard English; frontend/src/test/words.test.ts reads the screens."""

import ast
import io
import re
import sys
import tokenize
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

APP = Path(__file__).parents[2] / "app"
MODULES = (
    "errors",
    "rules",
    "service",
    "jobs",
    "links",
    "settlement",
    "fixes",
    "sending",
    "signing",
    "ledger_book",
    "save_edits",
)
ODD = (
    "silence first", "lost in mono", "flat tops", "stand-in", "stand-ins", "mended", "mender", "anew", "last word",
    "decider", "not said", "it may stay empty", "waits for your yes", "give it up", "take it back",
    "put away", "worthless", "let it through", "came back", "mail address", "line is back", "line dropped",
    "one's own", "nothing waits", "speaks for the team", "liaison", "accepted by silence", "made anew", "this mail",
)  # fmt: skip
PHRASE = re.compile(rf"(?<![\w-])({'|'.join(map(re.escape, ODD))})(?![\w-])", re.IGNORECASE)


def shown(source: str) -> Iterator[str]:
    """Yield the strings of a module that read as words, without its docstrings."""
    tree = ast.parse(source)
    docs = {
        id(node.body[0].value)
        for node in ast.walk(tree)
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef)
        and node.body
        and isinstance(node.body[0], ast.Expr)
    }
    for node in ast.walk(tree):
        is_text = isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in docs
        if is_text and re.search(r"\w\s+\w", node.value):
            yield node.value


@pytest.mark.parametrize(
    "path",
    sorted(path for path in APP.glob("*/*.py") if path.stem in MODULES),
    ids=lambda path: f"{path.parent.name}.{path.stem}",
)
def test_emails_and_refusals_have_no_odd_words(path: Path) -> None:
    assert [text for text in shown(path.read_text(encoding="utf-8")) if PHRASE.search(text)] == []


def test_odd_words_would_be_found() -> None:
    module = '"""Give the last word."""\nMESSAGE = "the stand-in was made anew"\nKIND = "decider"\n'
    assert [text for text in shown(module) if PHRASE.search(text)] == ["the stand-in was made anew"]


# These words fail in comments, docstrings and strings of the code, and on pages: the text to use is standard English.
OLD_WORDS = (
    "tell", "tells", "told", "untold", "telling", "tellings", "anew", "whoever", "whomever", "whosoever",
    "somebody", "anybody", "everybody", "nobody else", "for ever", "who asks", "came of it",
    "what came of", "comes of", "last word", "in the hand", "at the screen", "worthless", "gravest",
    "put on record", "stand-in", "stand-ins", "stands for", "stand for", "speaks for", "speak for", "decider",
    "mends", "mended", "mender", "foresees", "foreseen", "foretells", "forthwith", "heretofore", "thereof",
    "lawful", "lawfully", "reckon", "reckons", "reckoned", "reckoning", "heed", "heeds", "heeded", "heeding", "unwise",
    "became of", "become of", "takes hold", "took hold",
)  # fmt: skip
OLD = re.compile(rf"(?<![\w-])({'|'.join(map(re.escape, OLD_WORDS))})(?![\w-])", re.IGNORECASE)
ALLOWED = re.compile(r"cannot tell", re.IGNORECASE)  # the third verdict of a judgement, a value of the API
ROOT = Path(__file__).parents[2]
STRINGS = (tokenize.STRING, getattr(tokenize, "FSTRING_MIDDLE", tokenize.STRING))  # f-strings, from Python 3.12 on
CODE = ("app", "audio_checks", "benchmarks", "training", "deploy", "integrations", "migrations", "tests")
OWN = Path(__file__).name  # plants odd words itself
CLAUSES = ROOT / "app" / "agreements" / "library"  # legal text, worded by its own rules
COMMENT = re.compile(r"/\*.*?\*/|(?<![:'\"`])//[^\n]*", re.DOTALL)
# A text of code is left out; what stands in ${} of a template is a name again, and is found where it was declared.
NAME_OR_TEXT = re.compile(r"'(?:\\.|[^'\\\n])*'|\"(?:\\.|[^\"\\\n])*\"|`(?:\\.|[^`\\])*`|([A-Za-z_$][\w$]*)")


def texts_of_python(source: str) -> Iterator[tuple[int, str]]:
    """Yield the line and text of comments, and of strings and docstrings that read as words."""
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        is_text = token.type in STRINGS and re.search(r"\w\s+\w", token.string)
        if token.type == tokenize.COMMENT or is_text:
            yield token.start[0], token.string


def names_of_python(source: str) -> Iterator[tuple[int, str]]:
    """Yield the line and words of names that a module gives: classes, functions, arguments and variables."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            name = node.name
        elif isinstance(node, ast.arg):
            name = node.arg
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            name = node.id
        else:
            continue
        yield node.lineno, words_of(name)


def words_of(name: str) -> str:
    """Return a name in words: `takesHeard`, `TAKES_HEARD` and `takes_heard` are "takes heard"."""
    return " ".join(re.findall(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+", name))


def texts_of_comments(source: str) -> Iterator[tuple[int, str]]:
    """Yield the line and text of comments in C and TypeScript; frontend/src/test/words.test.ts reads what is shown."""
    for found in COMMENT.finditer(source):
        yield source.count("\n", 0, found.start()) + 1, found.group()


def names_of_typescript(source: str) -> Iterator[tuple[int, str]]:
    """Yield the line and words of names in TypeScript."""
    code = COMMENT.sub(lambda comment: "\n" * comment.group().count("\n"), source)
    for found in NAME_OR_TEXT.finditer(code):
        if found[1]:
            yield code.count("\n", 0, found.start()) + 1, words_of(found[1])


def texts_of_page(source: str) -> Iterator[tuple[int, str]]:
    """Yield the lines of a page."""
    yield from enumerate(source.splitlines(), start=1)


def old_words(path: Path, texts: Callable[[str], Iterator[tuple[int, str]]]) -> list[str]:
    """Return where a file uses an old word: file, line and word."""
    return [
        f"{path.relative_to(ROOT)}:{line}: {found.group()}"
        for line, text in texts(path.read_text(encoding="utf-8"))
        if (found := OLD.search(ALLOWED.sub("", re.sub(r"\s+", " ", text))))
    ]


@pytest.mark.parametrize("folder", CODE)
def test_comments_docstrings_and_strings_use_standard_english(folder: str) -> None:
    files = sorted(path for path in (ROOT / folder).rglob("*.py") if path.name != OWN)
    assert files
    assert [one for path in files for one in old_words(path, texts_of_python)] == []


@pytest.mark.parametrize("folder", CODE)
def test_names_use_standard_english(folder: str) -> None:
    files = sorted(path for path in (ROOT / folder).rglob("*.py") if path.name != OWN)
    assert [one for path in files for one in old_words(path, names_of_python)] == []


def test_comments_of_the_frontend_use_standard_english() -> None:
    source = ROOT / "frontend" / "src"
    files = [path for end in ("ts", "tsx", "css") for path in source.rglob(f"*.{end}")]
    assert len(files) > 100
    own = {"schema.gen.ts", "words.test.ts"}  # generated from app; plants odd words itself
    assert [one for path in files if path.name not in own for one in old_words(path, texts_of_comments)] == []


def test_names_in_tests_of_the_frontend_use_standard_english() -> None:
    frontend = ROOT / "frontend"
    scripts = [path for folder in ("src", "e2e") for path in (frontend / folder).rglob("*.ts*")]
    parents = {frontend / "e2e", frontend / "src" / "test"}
    tests = [path for path in scripts if ".test." in path.name or parents & set(path.parents)]
    assert len(tests) > 200
    assert [one for path in sorted(tests) for one in old_words(path, names_of_typescript)] == []


def test_comments_of_the_kernel_use_standard_english() -> None:
    files = [path for end in ("c", "h") for path in (ROOT / "audio_checks" / "kernel").glob(f"*.{end}")]
    assert len(files) > 20
    assert [one for path in files for one in old_words(path, texts_of_comments)] == []


def test_pages_use_standard_english() -> None:
    pages = [*ROOT.glob("*.md"), *(path for name in ("docs", *CODE) for path in (ROOT / name).rglob("*.md"))]
    read = [path for path in pages if CLAUSES not in path.parents]
    assert len(read) > 30
    assert [one for path in sorted(read) for one in old_words(path, texts_of_page)] == []


@pytest.mark.parametrize(
    ("texts", "source"),
    [
        (texts_of_python, "x = 1  # who is told\n"),
        (texts_of_python, 'def f():\n    """Tell whether it is."""\n'),
        (texts_of_python, 'x = f"{1} is made anew"\n'),
        (names_of_python, "def tell_runs(): ..."),
        (names_of_python, "class ToldRuns: ..."),
        (names_of_python, "def f(lawful): ..."),
        (names_of_python, "UNTOLD = 1"),
        (texts_of_comments, "const a = 1 // for whoever\n/** Read\n anew. */"),
        (names_of_typescript, "const toldPage = `it's ${'x'}`"),
        (names_of_typescript, "/* It's */ const a = 'it' // it's\nfunction f(isUntold: boolean) {}"),
        (texts_of_page, "# A page\nAs it was told."),
    ],
)
def test_old_words_would_be_found(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, texts: Callable[[str], Iterator[tuple[int, str]]], source: str
) -> None:
    monkeypatch.setattr(sys.modules[__name__], "ROOT", tmp_path)
    page = tmp_path / "page"
    page.write_text(source, encoding="utf-8")
    assert old_words(page, texts) != []
    page.write_text(
        re.sub("tell|told|untold|lawful", "notify", OLD.sub("notified", source), flags=re.I), encoding="utf-8"
    )
    assert old_words(page, texts) == []


def test_the_verdict_cannot_tell_is_allowed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys.modules[__name__], "ROOT", tmp_path)
    page = tmp_path / "page"
    page.write_text('"Cannot tell" is no finding.', encoding="utf-8")
    assert old_words(page, texts_of_page) == []
