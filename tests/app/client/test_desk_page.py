"""`soundlist desk --page`: what is owed as one file for the browser."""

from datetime import UTC, date, datetime
from html.parser import HTMLParser
from pathlib import Path

import pytest

from app.client.desk import HEADS
from app.client.desk_page import Line, html_of
from tests.app.client.served import RunDesk
from tests.app.dashboards.test_own_desk import make_token, set_due
from tests.app.reviews.making import Stage
from tests.support.listening import listening
from tests.support.server import World

HOSTILE = '</td><script>alert(1)</script><img src=x onerror="alert(2)">\'"&\u202e\x00'
AT = datetime(2026, 11, 27, 10, 0, tzinfo=UTC)


class Page(HTMLParser):
    """The elements and the text of a page, as a browser reads them."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.links: list[str] = []
        self.attributes: set[str] = set()
        self.said: list[str] = []
        self.feed(html)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.attributes |= {name for name, _ in attrs}
        self.links += [value or "" for name, value in attrs if name in ("href", "src")]

    def handle_data(self, data: str) -> None:
        self.said.append(data)

    @property
    def text(self) -> str:
        return " ".join(self.said)


@pytest.fixture
def opened(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> list[str]:
    """The addresses that the browser was asked to open."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    addresses: list[str] = []
    monkeypatch.setattr("webbrowser.open", lambda address: addresses.append(address) or True)
    return addresses


def line(**changes: str) -> Line:
    """Return a line whose columns say what they are, but for some."""
    return Line([changes.get(head, head) for head in HEADS], changes.get("page", "https://one.example/x"), False)


def test_words_of_a_server_are_text_wherever_they_stand():
    lines = [line(**dict.fromkeys([*HEADS, "page"], HOSTILE))]
    page = Page(html_of(HEADS, lines, [HOSTILE], AT))
    assert not {"script", "img"} & set(page.tags)
    assert page.tags.count("td") == len(HEADS)
    assert not {name for name in page.attributes if name.startswith("on")}
    assert page.text.count("<script>alert(1)</script>") == len(HEADS) + 1
    assert "\u202e" not in page.text
    assert "\x00" not in page.text


def test_it_needs_nothing_from_outside():
    html = html_of(HEADS, [line()], [], AT)
    page = Page(html)
    assert page.links == ["https://one.example/x"], "the way to the cue's page alone"
    assert not {"script", "link", "iframe", "img", "object"} & set(page.tags)
    assert "url(" not in html
    assert "@import" not in html
    assert "default-src 'none'" in html
    assert "prefers-color-scheme:dark" in html


def test_late_days_are_marked_and_an_empty_name_can_be_followed():
    html = html_of(HEADS, [line(name="")._replace(is_late=True), line()], [], AT)
    assert html.count('class="late"') == 1
    assert ">open</a>" in html


@pytest.mark.parametrize(
    ("remarks", "said"), [([], "Nothing is owed."), (["x is left out"], "No server that answered")]
)
def test_nothing_owed_is_said(remarks: list[str], said: str):
    assert said in Page(html_of(HEADS, [], remarks, AT)).text


@pytest.mark.slow
def test_the_page_is_written_and_opened_without_the_token(
    world: World,
    run_desk: RunDesk,
    opened: list[str],
    tmp_path: Path,
):
    stage, secret = Stage(world), make_token(world)[1]
    set_due(world, stage.cue("second<b>"), date(2999, 1, 2))
    set_due(world, stage.cue("first"), date(2026, 1, 1))
    with listening(world.server.application, lifespan="off", log_level="critical") as port:
        run_desk("add", f"http://127.0.0.1:{port}", "--name", "one", token=secret)
        code, out, _ = run_desk("--page")
    path = tmp_path / "cache" / "soundlist" / "desk.html"
    assert code == 0
    assert "open in your browser" in out
    assert opened == [path.as_uri()]
    assert path.stat().st_mode & 0o777 == 0o600
    html = path.read_text(encoding="utf-8")
    assert secret not in html
    page = Page(html)
    assert page.text.index("first") < page.text.index("second<b>")
    assert page.links == [f"http://127.0.0.1:{port}/projects/{world.project_id}/desk"] * 2
    assert html.count('class="late"') == 1


def test_a_page_in_a_file_of_ones_own_is_not_opened_and_names_the_server_that_did_not_answer(
    world: World,
    run_desk: RunDesk,
    opened: list[str],
    tmp_path: Path,
):
    with listening(world.server.application, lifespan="off", log_level="critical") as port:
        run_desk("add", f"http://127.0.0.1:{port}", "--name", "one<i>", token=make_token(world)[1])
    code, out, err = run_desk("--page", str(tmp_path / "mine.html"))
    assert code == 3
    assert "mine.html is written" in out
    assert "one<i> is left out: cannot be reached" in err
    assert "one<i> is left out: cannot be reached" in Page((tmp_path / "mine.html").read_text()).text
    assert opened == []


def test_where_it_cannot_be_written_that_is_said(world: World, run_desk: RunDesk, opened: list[str], tmp_path: Path):
    with listening(world.server.application, lifespan="off", log_level="critical") as port:
        run_desk("add", f"http://127.0.0.1:{port}", "--name", "one", token=make_token(world)[1])
        code, _, err = run_desk("--page", str(tmp_path / "missing" / "desk.html"))
    assert code == 2
    assert "No such file or directory" in err
    assert opened == []
