"""Names of takes and cues, and the sound list as CSV."""

import pytest

from audio_checks.errors import SpecError
from audio_checks.spec.delivery_spec import CueFacts
from audio_checks.spec.sound_list import COLUMNS, read_sound_list, write_sound_list
from audio_checks.spec.sound_names import TakeName, parse_file_name, slug, stems_of


@pytest.mark.parametrize(
    ("file_name", "parts"),
    [
        ("laser_fire.wav", ("laser_fire", None, None, ".wav")),
        ("laser_fire_02.wav", ("laser_fire_02", None, None, ".wav")),
        ("laser_fire__alt2.wav", ("laser_fire", 2, None, ".wav")),
        ("laser_fire__alt12.WAV", ("laser_fire", 12, None, ".WAV")),
        ("laser_fire_altB.wav", ("laser_fire", 2, None, ".wav")),
        ("laser_fire__altC.wav", ("laser_fire", 3, None, ".wav")),
        ("laser_fire_v03.wav", ("laser_fire", None, 3, ".wav")),
        ("laser_fire_02_v3_altA.wav", ("laser_fire_02", 1, 3, ".wav")),
        ("laser_fire_02_altA_V3.wav", ("laser_fire_02", 1, 3, ".wav")),
        ("cobalt.wav", ("cobalt", None, None, ".wav")),
        ("door_alt.wav", ("door_alt", None, None, ".wav")),
        ("door_alto.wav", ("door_alto", None, None, ".wav")),
        ("_v03.wav", ("_v03", None, None, ".wav")),
        ("__alt2.wav", ("__alt2", None, None, ".wav")),
        ("final.mix.wav", ("final.mix", None, None, ".wav")),
        ("noending", ("noending", None, None, "")),
        (".wav", (".wav", None, None, "")),
        ("../../etc/laser.wav", ("laser", None, None, ".wav")),
        ("C:\\takes\\laser.wav", ("laser", None, None, ".wav")),
        ("cafe\u0301.wav", ("caf\u00e9", None, None, ".wav")),
        ("", ("", None, None, "")),
    ],
)
def test_parts_of_a_name(file_name, parts):
    assert parse_file_name(file_name) == TakeName(*parts)


@pytest.mark.parametrize(
    ("name", "stem"),
    [
        ("Laser fire", "laser_fire"),
        ("  Café — Door #2 ", "cafe_door_2"),
        ("Straße", "strasse"),
        ("爆発", "爆発"),
        ("!?", ""),
    ],
)
def test_slugs(name, stem):
    assert slug(name) == stem


@pytest.mark.parametrize(
    ("cue", "stems"),
    [
        (("Laser fire", "", 1), ["laser_fire"]),
        (("Laser fire", "wpn_laser", 1), ["wpn_laser"]),
        (("Laser fire", "wpn_laser.wav", 1), ["wpn_laser"]),
        (("Laser fire", "wpn.laser", 1), ["wpn.laser"]),
        (("Step", "", 3), ["step_01", "step_02", "step_03"]),
        (("!?", "", 3), []),
    ],
)
def test_a_cue_owns_its_stems(cue, stems):
    assert stems_of(*cue) == stems


def test_a_hundred_variations_have_three_digits():
    stems = stems_of("rain", "", 100)
    assert (stems[0], stems[-1]) == ("rain_001", "rain_100")


LIST = """\
number,name,file_name,category,description,use,trigger,duration_s,length_locked,frame_rate_fps,loop,reverb,\
variations,state,owner
SW-001,Laser fire,laser_fire,weapon,"short, bright",ship,on_fire,0.6,no,,no,dry,4,locked,Audio
SW-002,Bridge,amb_bridge_loop,ambience,,,,60,yes,30,yes,,1,concept,
SW-003,Mine arm,,ui,,,,,,,,,,cut,
"""


class TestSoundList:
    def test_columns(self):
        laser, bridge, mine = read_sound_list(LIST).cues
        assert laser == CueFacts(
            "SW-001", "Laser fire", "laser_fire", "weapon", 0.6, reverb="dry", variations=4, state="locked"
        )
        assert laser.more == {"description": "short, bright", "use": "ship", "trigger": "on_fire", "owner": "Audio"}
        assert (bridge.duration_s, bridge.length_locked, bridge.frame_rate_fps, bridge.loop) == (60.0, True, 30.0, True)
        assert (mine.duration_s, mine.variations, mine.state) == (None, 1, "cut")

    def test_what_is_written_reads_back(self):
        sounds = read_sound_list(LIST)
        written = write_sound_list(sounds.cues)
        again = read_sound_list(written)
        assert again.cues == sounds.cues
        assert [cue.more for cue in again.cues] == [cue.more for cue in sounds.cues]
        assert written.splitlines()[0] == ",".join([*COLUMNS, "owner"])

    def test_files_find_their_cues(self):
        sounds = read_sound_list(LIST)
        laser, bridge, _ = sounds.cues
        assert sounds.slot("laser_fire_03") == (laser, 3)
        assert sounds.slot_of_file("takes/laser_fire_04__alt2.wav") == (laser, 4)
        assert sounds.slot_of_file("amb_bridge_loop_v02.wav") == (bridge, 1)
        assert sounds.slot("laser_fire") is None
        assert sounds.slot("Laser_fire_01") is None

    def test_the_match_is_exact_after_nfc(self):
        sounds = read_sound_list("number,file_name\n1,caf\u00e9\n")
        assert sounds.slot_of_file("cafe\u0301.wav") is not None

    def test_a_name_that_ends_like_a_version_is_matched_whole(self):
        sounds = read_sound_list("number,file_name\n1,engine_v8\n2,engine\n")
        assert sounds.slot_of_file("engine_v8.wav")[0].number == "1"
        assert sounds.slot_of_file("engine_v9.wav")[0].number == "2"

    @pytest.mark.parametrize("between", [";", "\t"])
    def test_other_separators_line_ends_and_a_byte_order_mark(self, tmp_path, between):
        path = tmp_path / "sounds.csv"
        text = f"Number{between}Duration_s\r\nSW-1{between}0,5\r\n\r\n"
        path.write_bytes(b"\xef\xbb\xbf" + text.encode())
        (cue,) = read_sound_list(path).cues
        assert (cue.number, cue.duration_s) == ("SW-1", 0.5)

    def test_wrong_rows_are_all_named(self):
        with pytest.raises(SpecError) as caught:
            read_sound_list(
                "number,duration_s,loop,variations,state\n1,long,,,\n2,,maybe,,\n3,,,0,\n4,,,,done\n5,-1,,,\n"
            )
        message = str(caught.value)
        for part in ("row 2: duration_s", "row 3: loop", "row 4: variations", "row 5: state", "row 6: duration_s"):
            assert part in message

    @pytest.mark.parametrize(
        ("text", "why"),
        [
            ("", "is empty"),
            ("mood,length\na,1\n", "no column has numbers, names or file names"),
            ("number,number\n1,2\n", "twice"),
            ("number,name\n,\nx,\n,y\n", None),
            ("number,description\n,only this\n", "row 2: number"),
            ("number,file_name\n1,laser\n2,laser\n", 'cues 1 and 2 both own the file name "laser"'),
            ("number,file_name,variations\n1,laser,2\n2,laser_02,\n", "both own"),
        ],
    )
    def test_what_is_no_list(self, text, why):
        if why is None:
            assert [cue.number for cue in read_sound_list(text).cues] == ["x", "y"]
            return
        with pytest.raises(SpecError, match=why):
            read_sound_list(text)

    def test_a_cut_cue_gives_up_its_name(self):
        sounds = read_sound_list("number,file_name,state\n1,laser,cut\n2,laser,locked\n")
        assert sounds.slot("laser")[0].number == "2"

    def test_a_file_that_cannot_be_read(self, tmp_path):
        (tmp_path / "sounds.csv").write_bytes(b"number\n\0\n")
        for name in ("sounds.csv", "none.csv"):
            with pytest.raises(SpecError) as caught:
                read_sound_list(tmp_path / name)
            assert caught.value.where == str(tmp_path / name)
