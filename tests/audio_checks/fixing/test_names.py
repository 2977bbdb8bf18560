import pytest

from audio_checks import check_name, parse_spec
from audio_checks.fixing.names import valid_name

LOWER = parse_spec("""
format = 1
[naming]
pattern = '[a-z0-9]+(_[a-z0-9]+)*'
extension = ".wav"
[targets.game]
sample_rate_hz = 44100
bit_depth = 16
""")
UPPER = parse_spec("format = 1\n[naming]\npattern = '[A-Z][A-Z0-9_]*'\n")
CAMEL = parse_spec("format = 1\n[naming]\npattern = '[A-Z]{2}_[A-Za-z0-9_]+'\n")


@pytest.mark.parametrize(
    ("spec", "name", "valid"),
    [
        (LOWER, "laser_fire.wav", "laser_fire.wav"),
        (LOWER, "Laser Fire.WAV", "laser_fire.wav"),
        (LOWER, "laser-fire.bwf", "laser_fire.wav"),
        (LOWER, "Überläufer (final).wav", "uberlaufer_final.wav"),
        (LOWER, "Laser_altB.wav", "laser__alt2.wav"),
        (LOWER, "laser_altB.wav", "laser_altB.wav"),  # the mark of an alternate is valid in a delivery
        (LOWER, "Laser_v03.wav", "laser.wav"),
        (LOWER, "laser.mp3", None),
        (LOWER, "!!!.wav", None),
        (LOWER, "笑い声.wav", None),
        (LOWER.for_target("game"), "laser_altB.wav", "laser.wav"),
        (UPPER, "laser fire.wav", "LASER_FIRE.wav"),
        (CAMEL, "SW laser fire.wav", "SW_laser_fire.wav"),
        (parse_spec("format = 1\n"), "What ever.wav", "What ever.wav"),
    ],
)
def test_the_nearest_valid_name(spec, name, valid):
    assert valid_name(name, spec) == valid


@pytest.mark.parametrize(
    ("name", "valid"),
    [
        ("DoorWoodClose-01.wav", "door_wood_close_01.wav"),
        ("doorWoodClose 1.wav", "door_wood_close_1.wav"),
        ("DoorWoodClose01.wav", "door_wood_close_01.wav"),
        ("UIClick.wav", "ui_click.wav"),
        ("DoorWood_48k24.wav", "door_wood.wav"),
        ("DoorWood-02 (44.1kHz 16bit).wav", "door_wood_02.wav"),
        ("Robot2Step.wav", "robot2_step.wav"),
        ("NPC_Talk.wav", "npc_talk.wav"),
        ("48k24.wav", "48k24.wav"),
    ],
)
def test_a_name_is_made_valid_as_files_are_matched_to_cues(name, valid):
    assert valid_name(name, LOWER) == valid
    if valid != name:
        found = check_name(name, LOWER)
        assert [finding.fix for finding in found] == [f"rename it to {valid}"]
