"""Scripts become lines with a cue per language: what is read, what is refused, and what a second script changes."""

from typing import Any

import pytest
from sqlalchemy import select

from app.sound_lists.models import Cue
from tests.support.deliver import add_cues, deliver
from tests.support.server import World
from tests.support.voice import SHEET, encoded, imported, lines, send, sent, sound, workbook

SCRIPT = """Title: The oath

# Bridge

CAPTAIN [[captain_010]]
(quietly)
By the light of a hundred suns.

MAYA (V.O.)
It is
still open!
"""


def cue_names(world: World) -> set[str]:
    names = select(Cue.name).where(Cue.project_id == world.project_id)
    return set(world.server.in_database(lambda session: session.scalars(names).all()))


def messages(read: dict[str, Any]) -> list[tuple[int, str | None]]:
    return [(error["row"], error["column"]) for error in read["errors"]]


def test_a_sheet_becomes_lines_with_a_cue_for_each_language(world: World) -> None:
    read = imported(world)
    assert (read["added"], read["cues_added"], read["header_row"]) == (3, 6, 1)
    meanings = [column["meaning"] for column in read["columns"]]
    assert meanings == ["key", "character", "scene", "direction", "en", "de"]
    german = lines(world, language="de")
    captain = german["captain_010"]
    assert captain["text"] == "Beim Licht von hundert Sonnen."
    assert captain["original_text"] == "By the light of a hundred suns."
    assert (captain["character"]["name"], captain["scene"], captain["direction"]) == ("Captain", "Bridge", "quietly")
    assert captain["path"] == "de/captain_010"
    assert captain["cue"]["name"] == "de_captain_010"
    assert captain["state"] == "no_take"
    assert german["captain_020"]["scene"] == "Bridge", "a scene holds until the next one"
    assert captain["before"] is None
    assert captain["after"] == {"character": "Captain", "text": "Hold the line."}
    assert german["captain_020"]["after"] is None, "the next line is in another scene"
    assert lines(world, world.designer, language="de") == german


def test_a_dry_run_writes_nothing(world: World) -> None:
    read = sent(world, dry_run=True)
    assert (read["added"], read["imported"], read["errors"]) == (3, False, [])
    assert lines(world) == {}
    assert cue_names(world) == set()


def test_a_fault_in_one_row_is_named_and_stops_no_other(world: World) -> None:
    text = "Line ID,Character,Text\na_1,Maya,Hello\na_1,Maya,Again\na_3,,Nobody\na_4,Maya,\n"
    text += f"a_5,Maya,{'x' * 5_001}\n"
    assert not sent(world, text, atomic=True)["imported"]
    assert cue_names(world) == set()
    read = sent(world, text)
    assert (read["imported"], read["left_out"]) == (True, [3, 4, 5, 6])
    assert messages(read) == [(3, "Line ID"), (4, "Character"), (5, None), (6, "Text")]
    assert cue_names(world) == {"en_a_1"}


def test_a_name_that_no_file_can_have_is_refused(world: World) -> None:
    read = sent(world, "Line ID,Character,Text\na/1,Maya,Hello\n")
    assert "without folders" in read["errors"][0]["message"]
    assert read["errors"][0]["row"] == 2


@pytest.mark.parametrize(
    ("script", "stem", "proposed"),
    [
        ({"text": "Title: Le pont\n\n# Pont\n\nÉMILE\nBonjour!\n", "format": "script"}, None, None),
        ({"text": "Title: Le pont\n\n# Pont\n\nÉMILE [[émile_001]]\nBonjour!\n", "format": "script"}, "é", "emile_001"),
        ({"text": "Line ID,Character,English\némile_001,Émile,Hello!\n"}, "é", "emile_001"),
    ],
)
def test_accents_that_the_spec_refuses_are_said_and_offered_without(
    world: World, script: dict[str, str], stem: str | None, proposed: str | None
) -> None:
    read = sent(world, dry_run=True, **script)
    assert (read["added"], read["errors"]) == (1, [])
    names = read["refused_names"]["names"]
    assert [(stem in name["stem"], name["proposed"].endswith(proposed)) for name in names] == [(True, True)] * bool(
        stem
    )
    assert [offer["names"] for offer in read["refused_names"]["patterns"]] == [1] * bool(stem)
    sent(world, **script)
    listed = world.producer.get(f"/v1/projects/{world.project_id}/sound-list/refused-names").json()["names"]
    assert [(name["stem"], name["proposed"]) for name in listed] == [(name["stem"], name["proposed"]) for name in names]


def test_text_like_fountain(world: World) -> None:
    read = imported(world, SCRIPT, format="script")
    assert [(row["row"], row["key"], row["action"]) for row in read["rows"]] == [
        (5, "captain_010", "add"), (9, "maya_001", "add"),
    ]  # fmt: skip
    found = lines(world)
    assert found["captain_010"]["direction"] == "quietly"
    assert (found["maya_001"]["text"], found["maya_001"]["direction"]) == ("It is still open!", "V.O.")
    assert {line["scene"] for line in found.values()} == {"Bridge"}


def test_a_line_of_two_spaces_goes_on_with_the_speech_above_it(world: World) -> None:
    script = "INT. HALL\n\nANNA\nFirst half.\n  \nSecond half.\n   \nBOB\nYes.\n  \n\nShe leaves.\n"
    read = sent(world, script, format="script", dry_run=True)
    assert [(row["row"], row["action"]) for row in read["rows"]] == [(3, "add"), (8, "add")]
    imported(world, script, format="script")
    spoken = {(line["character"]["name"].upper(), line["text"]) for line in lines(world).values()}
    assert spoken == {("ANNA", "First half. Second half."), ("BOB", "Yes.")}


def test_a_script_without_ids_finds_its_lines_by_their_words(world: World) -> None:
    imported(world, SCRIPT, format="script")
    again = imported(world, SCRIPT, format="script")
    assert (again["same"], again["added"], again["changed"]) == (2, 0, 0)
    other = sent(world, SCRIPT.replace("still open", "closed"), format="script", dry_run=True)
    assert (other["same"], other["added"]) == (1, 1)
    assert other["not_in_script"] == ["maya_001"]


@pytest.mark.slow
def test_a_second_script_changes_texts_by_id_and_says_which(world: World) -> None:
    imported(world)
    deliver(world, "en_captain_010.wav", sound(1.0))
    changed = SHEET.replace("hundred suns", "thousand suns").replace("Captain,,,Hold", "Captain,Deck,,Hold")
    read = imported(world, changed)
    assert (read["changed"], read["same"], read["stale"]) == (2, 1, 1)
    assert read["rows"][0]["changes"] == [
        {
            "field": "en",
            "before": "By the light of a hundred suns.",
            "after": "By the light of a thousand suns.",
            "makes_stale": True,
        }
    ]
    assert [change["field"] for change in read["rows"][1]["changes"]] == ["scene"]
    found = lines(world)["captain_010"]
    assert (found["text"], found["text_version"]) == ("By the light of a thousand suns.", 2)


@pytest.mark.slow
def test_a_part_of_a_script_adds_its_lines_where_they_belong(world: World) -> None:
    imported(world)
    read = imported(
        world, "Line ID,Character,Scene,English\ncaptain_010,Captain,Bridge,By the light of a hundred suns.\n"
        "captain_015,Captain,Bridge,Wait.\n"
    )  # fmt: skip
    assert read["not_in_script"] == ["captain_020", "maya_010"]
    assert list(lines(world)) == ["captain_010", "captain_015", "captain_020", "maya_010"]


@pytest.mark.slow
def test_an_empty_scene_leaves_a_line_in_its_scene(world: World) -> None:
    imported(world)
    read = imported(world, "Line ID,Character,Scene,English\nmaya_010,Maya,,It is open!\n")
    assert [change["field"] for change in read["rows"][0]["changes"]] == ["en"]
    assert lines(world)["maya_010"]["scene"] == "Hangar"


@pytest.mark.slow
def test_a_language_can_come_later(world: World) -> None:
    imported(world, "Line ID,Character,English\nm_1,Maya,Hello\nm_2,Maya,Go\n")
    read = imported(world, "Line ID,Character,French\nm_1,Maya,Bonjour\n")
    assert (read["changed"], read["cues_added"]) == (1, 1)
    french = lines(world, language="fr")
    assert (french["m_1"]["text"], french["m_2"]["text"], french["m_2"]["state"]) == ("Bonjour", None, "no_text")


def test_a_cue_that_has_the_name_already_is_taken(world: World) -> None:
    [cue] = add_cues(world, {"name": "The oath", "file_name": "en_m_1", "category": "vo"})
    read = imported(world, "Line ID,Character,English\nm_1,Maya,Hello\n")
    assert read["cues_added"] == 0
    assert lines(world)["m_1"]["cue"]["id"] == cue["id"]


def test_two_lines_cannot_have_one_file(world: World) -> None:
    read = sent(world, "Line ID,Character,File,English\nm_1,Maya,hello,Hello\nm_2,Maya,hello,Go\n")
    assert messages(read) == [(3, "File")]
    imported(world, "Line ID,Character,File,English\nm_1,Maya,hello,Hello\n")
    assert messages(sent(world, "Line ID,Character,File,English\nm_2,Maya,hello,Go\n")) == [(2, "File")]
    renamed = sent(world, "Line ID,Character,File,English\nm_1,Maya,hullo,Hello\n")
    assert messages(renamed) == [(2, "File")]


def test_the_export_is_what_the_import_reads(world: World) -> None:
    imported(world, "Line ID,Character,Direction,English,eo\nm_1,Maya,=1+1,-Hello,Saluton\n", mapping={"eo": "eo"})
    answer = world.designer.get(f"/v1/projects/{world.project_id}/voice-lines.csv")
    assert answer.headers["content-type"] == "text/csv; charset=utf-8"
    text = answer.content.decode("utf-8-sig")
    assert "'=1+1" in text, "no cell is a formula"
    again = imported(world, text)
    assert (again["same"], again["changed"], again["added"]) == (1, 0, 0)


def test_columns_can_be_mapped_by_hand(world: World) -> None:
    sheet = "A,B,C\nMaya,Hello,Bonjour\n"
    assert send(world, text=sheet).json()["code"] == "script-unreadable"
    read = imported(world, sheet, mapping={"A": "character", "B": "text", "C": "fr"})
    assert [column["meaning"] for column in read["columns"]] == ["character", "en", "fr"]
    for mapping, said in (({"A": "planet"}, "planet"), ({"X": "text"}, "no column"), ({"A": "de", "B": "de"}, "two")):
        refused = send(world, text=sheet, mapping=mapping)
        assert (refused.status_code, refused.json()["code"]) == (422, "script-unreadable")
        assert said in refused.json()["detail"]


def test_a_workbook_with_merged_scenes_and_a_title(world: World) -> None:
    rows = [
        ["The oath, draft 3", "", "", ""],
        ["ID", "Scene", "Speaker", "Line"],
        ["m_1", "Bridge", "Maya", "Hello"],
        ["m_2", "", "Maya", "When?"],
        ["m_3", "Hangar", "Captain", "=1+1"],
    ]
    read = imported(world, text=None, format="xlsx", content_base64=encoded(workbook(rows, ["A1:D1", "B3:B4"])))  # type: ignore[arg-type]
    assert read["header_row"] == 2
    found = lines(world)
    assert [line["scene"] for line in found.values()] == ["Bridge", "Bridge", "Hangar"]
    assert found["m_2"]["text"] == "When?", "words that are heads of a sound list are words here"


def test_only_the_team_imports(world: World) -> None:
    for client, status in ((world.designer, 403), (world.reviewer, 403), (world.stranger, 404)):
        assert send(world, client, text=SHEET).status_code == status
    assert send(world, world.approver, text=SHEET).status_code == 200


@pytest.mark.slow
def test_a_file_finds_its_cue_by_the_folder_of_its_language(world: World) -> None:
    imported(world)
    for path, cue in (("de/captain_010.wav", "de_captain_010"), ("en/captain_010.wav", "en_captain_010")):
        take = deliver(world, path, sound(1.0 + len(cue) / 1_000 + path.count("d") / 100))
        assert take["cue"]["name"] == cue
    assert deliver(world, "captain_010.wav", sound(1.4))["cue"] is None, "no language says which"


@pytest.mark.slow
@pytest.mark.both_databases
def test_on_both_databases_a_designer_reads_and_another_studio_sees_nothing(world: World) -> None:
    imported(world)
    assert len(lines(world, world.designer, language="de")) == 3
    assert world.stranger.get(f"/v1/projects/{world.project_id}/voice-lines").status_code == 404
    [first, *_] = lines(world).values()
    assert world.stranger.patch(f"/v1/voice-lines/{first['id']}", json={"scene": "x"}).status_code == 404
    assert world.designer.patch(f"/v1/voice-lines/{first['id']}", json={"scene": "x"}).status_code == 403


TABLE = "Line ID,Text\nVO_Anna_010,Hold the line.\nVO_Ben_010,I am trying!\nVO_Anna_020,Good.\n"


def test_a_table_without_speakers_asks_who_speaks(world: World) -> None:
    answer = send(world, text=TABLE)
    assert (answer.status_code, answer.json()["code"]) == (422, "speaker-missing")
    assert answer.json()["detail"] == "no column has the characters; the columns are Line ID, Text"
    assert "name one speaker for all lines" in answer.json()["fix"]
    without_ids = send(world, text="Text\nHold the line.\n", speaker_in_key=True)
    assert without_ids.json()["detail"].startswith("no column has the ids that begin with the characters")


def test_one_speaker_has_all_lines_of_a_file(world: World) -> None:
    imported(world, TABLE, speaker=" Anna ")
    assert {line["character"]["name"] for line in lines(world).values()} == {"Anna"}
    mixed = sent(world, "Line ID,Speaker,Text\nx_1,Ben,Yes.\nx_2,,No.\n", speaker="Anna", dry_run=True)
    assert [row["character"] for row in mixed["rows"]] == ["Ben", "Anna"], "the sheet comes first"


def test_a_speaker_is_read_from_the_id_of_the_line(world: World) -> None:
    read = imported(world, TABLE + "0099,Who is this?\n", speaker_in_key=True, speaker="Narrator")
    assert [row["character"] for row in read["rows"]] == ["Anna", "Ben", "Anna", "Narrator"]
    nameless = sent(world, "Line ID,Text\n0100,Who?\n", speaker_in_key=True, dry_run=True)
    assert nameless["errors"][0]["message"] == "no character; wanted the name of the one who speaks"


FILES = """Line ID,Character,Audio file,Text
grunt,Guard,"grunt_01.wav, grunt_02.wav, grunt_03.wav",Hngh!
halt,Guard,halt.wav,Halt!
"""


def test_several_files_of_a_line_are_the_variations_of_its_cue(world: World) -> None:
    read = imported(world, FILES)
    assert [(row["key"], row["files"]) for row in read["rows"]] == [("grunt", 3), ("halt", 1)]
    assert cue_names(world) == {"en_grunt", "en_halt"}, "one cue a line and language"
    grunt = lines(world)["grunt"]
    assert [file["path"] for file in grunt["files"]] == ["en/grunt_01", "en/grunt_02", "en/grunt_03"]
    exported = world.producer.get(f"/v1/projects/{world.project_id}/voice-lines.csv").text
    again = imported(world, exported)
    assert [(row["key"], row["files"], row["action"]) for row in again["rows"]] == [
        ("grunt", 3, "same"), ("halt", 1, "same"),
    ]  # fmt: skip


@pytest.mark.parametrize("cell", ["grunt_01; grunt_02", "grunt_01.wav\ngrunt_02.wav", "grunt_01|grunt_02"])
def test_a_cell_names_files_in_any_usual_way(world: World, cell: str) -> None:
    read = sent(world, f'Line ID,Character,File,Text\ngrunt,Guard,"{cell}",Hngh!\n', dry_run=True)
    assert [(row["files"], read["errors"]) for row in read["rows"]] == [(2, [])]


def test_a_column_counts_the_files_of_a_line(world: World) -> None:
    imported(world, "Line ID,Character,Variations,Text\ngrunt,Guard,2,Hngh!\nhalt,Guard,,Halt!\n")
    assert [len(line["files"]) for line in lines(world).values()] == [2, 1]


@pytest.mark.parametrize(
    ("cells", "column", "words"),
    [
        ('"grunt_01.wav, roar.wav",', "Audio file", "give each a row of its own"),
        ('"grunt_01.wav, grunt_02.wav",5', "Audio file", "2 files are named"),
        (f"{'x' * 101}.wav,", "Audio file", "at most 100 are kept"),
        ("grunt.wav,100", "Variations", "found \"100\""),
        ("grunt.wav,many", "Variations", "found \"many\""),
    ],
)  # fmt: skip
def test_files_that_are_no_set_of_variations_are_refused(world: World, cells: str, column: str, words: str) -> None:
    read = sent(world, f"Line ID,Character,Audio file,Variations,Text\ngrunt,Guard,{cells},Hngh!\n")
    assert messages(read) == [(2, column)]
    assert words in read["errors"][0]["message"]
    assert not read["imported"]


def test_a_line_takes_over_the_cue_of_its_files_and_says_where_their_numbers_differ(world: World) -> None:
    add_cues(world, {"name": "en_grunt", "file_name": "en_grunt", "category": "vo", "variations": 3})
    other = sent(world, FILES.replace(", grunt_03.wav", ""))
    assert other["errors"][0]["message"].startswith("2 files in the script, and en_grunt has 3 variations")
    imported(world, FILES)
    assert cue_names(world) == {"en_grunt", "en_halt"}
    changed = sent(world, FILES.replace(", grunt_03.wav", ""))
    assert changed["errors"][0]["message"].startswith("2 files in the script, and en_grunt has 3 variations")
