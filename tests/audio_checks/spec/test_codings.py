"""Targets in a codec: what they need, what they refuse with which words, and what their files must be."""

import jsonschema_rs
import pytest

from audio_checks.errors import SpecError
from audio_checks.spec.delivery_spec import parse_spec, schema

VORBIS = 'format = 1\n[targets.game]\nsample_rate_hz = 44100\nencoding = "vorbis"\n'


def target(text):
    return parse_spec(text).targets["game"]


def test_a_lossy_target_has_a_quality_and_no_depth():
    spec = parse_spec(VORBIS)
    game = spec.targets["game"]
    assert (game.quality, game.bit_depth, game.dither, game.is_lossy) == (0.5, 32, "none", True)
    assert target(VORBIS + "quality = 0.8\n").quality == 0.8
    # What a category takes over from a plain target says nothing of it, and makes no other file.
    assert target(VORBIS + 'bit_depth = 16\ndither = "tpdf"\n') == game
    assert parse_spec(spec.to_toml()).sha256 == spec.sha256


def test_a_flac_target_has_a_depth_and_dither_as_a_wav_has():
    text = VORBIS.replace("vorbis", "flac")
    assert (target(text + "bit_depth = 16\n").dither, target(text + "bit_depth = 24\n").dither) == ("tpdf", "none")
    assert target(text + "bit_depth = 16\n").quality is None


@pytest.mark.parametrize(
    ("text", "where", "words"),
    [
        (
            VORBIS.replace("vorbis", "opus"),
            "sample_rate_hz",
            'Opus is made at 48000 Hz, found 44100 Hz; set sample_rate_hz = 48000, or encoding = "vorbis"',
        ),
        (
            VORBIS.replace("44100", "4000"),
            "sample_rate_hz",
            "Ogg Vorbis is made at 8000 to 192000 Hz, found 4000 Hz; set sample_rate_hz = 8000, or another encoding",
        ),
        (VORBIS + "quality = 7\n", "quality", "7 is outside 0 to 1"),
        (VORBIS.replace("vorbis", "flac"), "bit_depth", "a target must say it"),
        (VORBIS.replace("vorbis", "flac") + "bit_depth = 32\n", "bit_depth", "not a depth for flac; it can be 16, 24"),
        (
            VORBIS.replace("vorbis", "flac") + "bit_depth = 16\nquality = 0.5\n",
            "quality",
            'a quality is for vorbis and opus, and the encoding here is "flac"; '
            'take it out, or lift it with quality = "any"',
        ),
        (VORBIS.replace("vorbis", "mp3"), "encoding", "wanted one of pcm, float, vorbis, opus, flac"),
    ],
)  # fmt: skip
def test_what_is_refused_says_what_was_found_and_what_to_write(text, where, words):
    with pytest.raises(SpecError) as wrong:
        parse_spec(text)
    assert words in str(wrong.value)
    assert wrong.value.where == f"spec.toml: targets.game.{where}"


def test_a_category_goes_over_to_a_codec_and_back():
    spec = parse_spec(
        "format = 1\n[targets.game]\nsample_rate_hz = 48000\nbit_depth = 16\n"
        '[categories.music]\ntargets.game = { encoding = "opus", quality = 0.3 }\n'
    )
    assert (spec.targets["game"].ending(), spec.for_category("music").targets["game"].ending()) == (".wav", ".opus")
    with pytest.raises(SpecError, match="a quality is for vorbis and opus") as wrong:
        parse_spec(VORBIS + 'bit_depth = 16\nquality = 0.2\n[categories.ui]\ntargets.game.encoding = "pcm"\n')
    assert wrong.value.where == "spec.toml: categories.ui.targets.game.quality"
    back = parse_spec(
        VORBIS
        + 'bit_depth = 16\nquality = 0.2\n[categories.ui]\ntargets.game = { encoding = "pcm", quality = "any" }\n'
    )
    assert back.for_category("ui").targets["game"].quality is None


@pytest.mark.parametrize(
    ("encoding", "container", "kept", "depths", "ending"),
    [("vorbis", "ogg", "vorbis", None, ".ogg"), ("flac", "flac", "pcm", (16,), ".flac")],
)
def test_game_files_are_held_to_container_codec_and_ending(encoding, container, kept, depths, ending):
    text = VORBIS.replace("vorbis", encoding) + 'bit_depth = 16\n[naming]\nextension = ".wav"\n'
    view = parse_spec(text).for_target("game")
    assert (view.accept.containers, view.accept.encodings, view.accept.bit_depths) == ((container,), (kept,), depths)
    assert (view.naming.extension, view.ending) == (ending, ending)
    assert parse_spec(text).ending == ".wav"
    bare = parse_spec(VORBIS.replace("vorbis", encoding) + "bit_depth = 16\n").for_target("game")
    assert (bare.naming.extension, bare.ending) == (None, ending)


def test_a_spec_that_accepts_more_channels_than_the_codec_holds_is_warned_of():
    said = "[accept]\nchannels = [1, 6]\n"
    assert parse_spec(VORBIS + said).warnings == (
        "accepts 6 channels, but target game is Ogg Vorbis of 2 channels at most: "
        "its render of such a master will be refused",
    )
    assert parse_spec(VORBIS + "channels = 1\n" + said).warnings == ()
    assert parse_spec(VORBIS.replace("vorbis", "flac") + "bit_depth = 16\n" + said).warnings == ()


@pytest.mark.parametrize(
    ("said", "is_valid"),
    [
        ({"encoding": "vorbis"}, True),
        ({"encoding": "opus", "quality": 0.4}, True),
        ({"encoding": "opus", "quality": 1.4}, False),
        ({"encoding": "flac"}, False),
        ({"encoding": "flac", "bit_depth": 16}, True),
        ({"encoding": "pcm"}, False),
        ({}, False),
    ],
)
def test_the_schema_asks_for_a_depth_where_there_is_one(said, is_valid):
    tables = {"format": 1, "targets": {"game": {"sample_rate_hz": 48_000, **said}}}
    assert jsonschema_rs.validator_for(schema()).is_valid(tables) is is_valid
