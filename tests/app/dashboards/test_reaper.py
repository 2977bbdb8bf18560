"""What a designer owes as a project for REAPER: regions named as the files, change requests as markers."""

import base64
import re
from itertools import pairwise

import pytest

from app.dashboards.desk.reaper_rules import OwedFile, RenderFormat, reaper_project
from tests.support.deliver import add_cues, deliver
from tests.support.server import World
from tests.support.waves import sine, wav_bytes

MARKER = re.compile(r'^  MARKER (\d+) (\d+\.\d{6}) (["\'`])(.*)\3 ([01])$', re.MULTILINE)
WANTED = RenderFormat(48_000, 24)
SOUND = wav_bytes(sine(hz=440, dbfs=-6, seconds=0.5))


def regions(text: str) -> list[tuple[str, float, float]]:
    found = [one for one in MARKER.findall(text) if one[4] == "1"]
    return [(begin[3], float(begin[1]), float(end[1])) for begin, end in zip(found[::2], found[1::2], strict=True)]


def markers(text: str) -> list[tuple[float, str]]:
    return [(float(at), name) for _, at, _, name, flag in MARKER.findall(text) if flag == "0"]


def test_regions_lie_one_after_the_other_and_end_together_with_their_number() -> None:
    files = [OwedFile("laser_01", 1.5), OwedFile("wind", None), OwedFile("hum", 30.0, ((29.0, "fade"), (99.0, "late")))]
    text = reaper_project("Game", ["SW-001 laser"], files, WANTED)
    assert regions(text) == [("laser_01", 0.0, 1.5), ("wind", 3.5, 5.5), ("hum", 7.5, 37.5)]
    assert markers(text) == [(36.5, "fade"), (37.5, "late")]
    numbers = [int(one[0]) for one in MARKER.findall(text) if one[4] == "1"]
    assert numbers == [1, 1, 2, 2, 3, 3]
    assert all(before[2] < after[1] for before, after in pairwise(regions(text)))


def test_the_render_is_named_by_region_and_has_the_spec_s_format() -> None:
    text = reaper_project("Game", [], [], RenderFormat(44_100, 16))
    assert '  RENDER_PATTERN "$region"\n' in text
    assert "  RENDER_RANGE 3 " in text
    assert "  SAMPLERATE 44100 1 0\n" in text
    (codec,) = re.findall(r"<RENDER_CFG\n    (\S+)\n  >", text)
    assert base64.b64decode(codec)[:5] == b"evaw\x10"


@pytest.mark.parametrize(
    ("said", "kept"),
    [
        ('too "loud"', "'too \"loud\"'"),
        ('it\'s "it"', '`it\'s "it"`'),
        ("`a` 'b' \"c\"", "`'a' 'b' \"c\"`"),
        ("one\n>\n<TRACK", '"one > <TRACK"'),
        ("\x00\u202e\t", '""'),
    ],
)
def test_no_text_leaves_its_line_or_its_quotation_marks(said: str, kept: str) -> None:
    text = reaper_project("Game", [said], [OwedFile("a", 1.0, ((0.0, said),))], WANTED)
    assert f"MARKER 1 0.000000 {kept} 0" in text
    depth = 0
    for line in text.splitlines():
        depth += line.lstrip().startswith("<") - (line.strip() == ">")
    assert depth == 0


def rpp(world: World) -> str:
    answer = world.designer.get(f"/v1/projects/{world.project_id}/desk/sounds.rpp")
    assert answer.status_code == 200, answer.text
    assert answer.headers["content-disposition"] == 'attachment; filename="sounds.rpp"'
    return str(answer.text)


@pytest.mark.slow
@pytest.mark.both_databases
def test_what_is_owed_is_a_region_and_what_came_back_has_its_changes(world: World) -> None:
    add_cues(world, {"name": "laser", "variations": 2}, {"name": "wind", "duration_s": 12.0}, {"name": "gone"})
    cues = world.producer.get(f"/v1/projects/{world.project_id}/sound-list").json()["cues"]
    gone = next(cue for cue in cues if cue["name"] == "gone")
    assert world.producer.post(f"/v1/cues/{gone['id']}/cut", json={"reason": "no longer needed"}).status_code == 200
    assert regions(rpp(world)) == [("laser_01", 0.0, 2.0), ("laser_02", 4.0, 6.0), ("wind", 8.0, 20.0)]
    take = deliver(world, "laser_01.wav", SOUND)
    world.server.wait_for_jobs()
    assert [name for name, _, _ in regions(rpp(world))] == ["laser_02", "wind"]
    change = {"kind": "request_change", "note": "softer attack", "start_s": 0.25, "seen_state": "conforming"}
    assert world.approver.post(f"/v1/takes/{take['id']}/verdict", json=change).status_code == 200
    sent = world.approver.post(f"/v1/projects/{world.project_id}/feedback", json={})
    assert sent.status_code < 300, sent.text
    text = rpp(world)
    assert regions(text)[0] == ("laser_01", 0.0, 0.5)
    assert markers(text) == [(0.25, "softer attack")]


def test_a_desk_is_the_designer_s_own(world: World) -> None:
    url = f"/v1/projects/{world.project_id}/desk/sounds.rpp"
    assert world.producer.get(url).status_code == 403
    assert world.stranger.get(url).status_code == 404
