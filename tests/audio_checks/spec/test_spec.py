"""The delivery spec: reading, merging, views, and what it refuses in words."""

import hashlib
import json

import pytest

from audio_checks.errors import SpecError, SpecErrors
from audio_checks.spec.delivery_spec import Range, Target, load_spec, new_spec, parse_spec
from audio_checks.spec.name_tokens import Token

GAME = """
format = 1
name = "Shield Wing"
[accept]
sample_rates_hz = [44100, 48000, 96000]
channels = [1, 2]
duration_s = { min = 0.01, max = 30.0 }
[limits]
true_peak_dbtp = -1.0
head_silence_ms = 5
[targets.game]
sample_rate_hz = 44100
bit_depth = 16
[targets.handheld]
sample_rate_hz = 22050
bit_depth = 16
channels = 1
[checks]
true-peak = "warning"
[categories.vo]
kind = "voice"
accept.channels = [1]
limits = { head_silence_ms = 50 }
checks.true-peak = "error"
targets.game.channels = 1
[categories.music]
accept.duration_s = { max = 300.0 }
limits.true_peak_dbtp = "any"
"""


@pytest.fixture
def spec():
    return parse_spec(GAME)


def refused(text, *, where):
    """Return why a spec is refused, at a place."""
    with pytest.raises(SpecError) as caught:
        parse_spec(text)
    assert caught.value.where == f"spec.toml: {where}" if where else "spec.toml"
    return str(caught.value)


class TestViews:
    def test_what_is_absent_is_not_limited(self, spec):
        assert spec.accept.encodings is None
        assert spec.limits.sample_peak_dbfs is None
        assert not spec.limits.loudness_lufs
        assert spec.limits.tolerance_db == 0.05

    def test_a_category_overrides_key_by_key(self, spec):
        vo = spec.for_category("vo")
        assert vo.kind == "voice"
        assert vo.accept.channels == (1,)
        assert (vo.limits.head_silence_ms, vo.limits.true_peak_dbtp) == (50.0, -1.0)
        assert vo.checks == {"true-peak": "error"}
        assert vo.targets["game"] == Target("game", 44_100, 16, channels=1)
        assert vo.targets["handheld"] == spec.targets["handheld"]

    def test_ranges_merge_by_bound_and_any_lifts_a_limit(self, spec):
        music = spec.for_category("music")
        assert music.accept.duration_s == Range(0.01, 300.0)
        assert music.limits.true_peak_dbtp is None

    def test_a_category_without_tables_uses_the_base(self, spec):
        creature = spec.for_category("creature")
        assert (creature.category, creature.limits, creature.accept) == ("creature", spec.limits, spec.accept)
        assert spec.for_category(None) is spec

    def test_a_target_replaces_what_may_be_accepted(self, spec):
        view = spec.for_target("handheld")
        assert view.accept.sample_rates_hz == (22_050,)
        assert view.accept.bit_depths == (16,)
        assert view.accept.encodings == ("pcm",)
        assert view.accept.containers == ("wav",)
        assert view.accept.channels == (1,)
        assert view.accept.duration_s == spec.accept.duration_s
        assert view.limits == spec.limits

    def test_channels_of_the_master_means_any_accepted(self, spec):
        assert spec.for_target("game").accept.channels == (1, 2)
        assert spec.for_target("game", "vo").accept.channels == (1,)

    def test_an_unknown_target(self, spec):
        with pytest.raises(SpecError, match="targets of this spec: game, handheld"):
            spec.for_target("pc")

    @pytest.mark.parametrize(
        ("keys", "dither"),
        [("bit_depth = 16", "tpdf"), ("bit_depth = 24", "none"), ('bit_depth = 32\nencoding = "float"', "none")],
    )
    def test_dither_by_default(self, keys, dither):
        target = parse_spec(f"format = 1\n[targets.pc]\nsample_rate_hz = 48000\n{keys}").targets["pc"]
        assert target.dither == dither
        assert (target.channels, target.over_peak) == ("master", "attenuate")


class TestFiles:
    @pytest.mark.parametrize(
        ("path", "category"),
        [
            ("vo/en/line.wav", "vo"),
            ("vo/en/ui_click.wav", "ui"),  # the last match wins
            ("sfx/deep/boom.wav", None),
            ("music/theme.wav", "music"),
            ("music/stems/theme.wav", None),
            ("music/a.flac", None),
        ],
    )
    def test_globs(self, tmp_path, path, category):
        (tmp_path / "audio-checks.toml").write_text(
            'format = 1\n[files]\n"vo/**" = "vo"\n"music/*.wav" = "music"\n"ui_*" = "ui"\n', encoding="utf-8"
        )
        assert load_spec(tmp_path / "audio-checks.toml").category_of(tmp_path / path) == category

    def test_extend_merges_and_keeps_the_nearest_word(self, tmp_path):
        (tmp_path / "base.toml").write_text(GAME, encoding="utf-8")
        (tmp_path / "sub").mkdir()
        own = tmp_path / "sub" / "audio-checks.toml"
        own.write_text('extend = "../base.toml"\nlimits.true_peak_dbtp = -2.0\n', encoding="utf-8")
        spec = load_spec(own)
        assert (spec.name, spec.limits.true_peak_dbtp, spec.limits.head_silence_ms) == ("Shield Wing", -2.0, 5.0)

    def test_a_circle_of_extends(self, tmp_path):
        for one, other in (("a", "b"), ("b", "a")):
            (tmp_path / f"{one}.toml").write_text(f'format = 1\nextend = "{other}.toml"\n', encoding="utf-8")
        with pytest.raises(SpecError, match="circle"):
            load_spec(tmp_path / "a.toml")

    def test_the_table_of_a_pyproject(self, tmp_path):
        path = tmp_path / "pyproject.toml"
        path.write_text("[tool.other]\nx = 1\n[tool.audio-checks]\nformat = 1\nlimits.head_silence_ms = 9\n")
        assert load_spec(path).limits.head_silence_ms == 9.0

    def test_windows_line_ends_and_a_byte_order_mark(self, tmp_path):
        path = tmp_path / "spec.toml"
        path.write_bytes(b"\xef\xbb\xbf" + GAME.replace("\n", "\r\n").encode())
        assert load_spec(path).sha256 == parse_spec(GAME).sha256

    @pytest.mark.parametrize("content", [b"\xff\xfe\x00", b"format = ", None])
    def test_what_cannot_be_read(self, tmp_path, content):
        path = tmp_path / "spec.toml"
        if content is not None:
            path.write_bytes(content)
        with pytest.raises(SpecError) as caught:
            load_spec(path)
        assert caught.value.where == str(path)


NAMED_BY_TOKENS = """
format = 1
[naming]
tokens = [
  { name = "kind", one_of = ["sfx", "amb"] },
  { name = "what", case = "lower", repeats = true },
  { name = "variation", digits = 2, optional = true },
]
portable = false
[categories.library.naming]
tokens = "any"
grammar = "ucs"
ucs_ids = ["GUNAuto", "DOORWood"]
"""


class TestNaming:
    def test_tokens(self):
        naming = parse_spec(NAMED_BY_TOKENS).naming
        assert naming.tokens[0] == Token("kind", one_of=("sfx", "amb"))
        assert naming.tokens[2] == Token("variation", digits=2, optional=True)
        assert (naming.separator, naming.portable) == ("_", False)

    def test_a_category_may_name_by_another_rule(self):
        naming = parse_spec(NAMED_BY_TOKENS).for_category("library").naming
        assert (naming.tokens, naming.grammar, naming.ucs_ids) == ((), "ucs", ("GUNAuto", "DOORWood"))

    @pytest.mark.parametrize(
        ("tables", "portable"),
        [
            ("", False),
            ("naming.pattern = 'x'", True),
            ("naming.extension = '.wav'", True),
            ("naming.portable = true", True),
            ("naming = { grammar = 'ucs', portable = false }", False),
            ("naming.pattern = 'any'", False),
        ],
    )
    def test_names_are_portable_wherever_anything_is_said_of_them(self, tables, portable):
        assert parse_spec(f"format = 1\n{tables}").naming.portable is portable

    def test_the_list_of_ids_is_a_file_beside_the_spec(self, tmp_path):
        (tmp_path / "lists").mkdir()
        (tmp_path / "lists" / "ucs.csv").write_text("Category,CatID\nGUNS,GUNAuto\nDOORS,DOORWood\n")
        (tmp_path / "base.toml").write_text("format = 1\nnaming = { grammar = 'ucs', ucs_list = 'lists/ucs.csv' }\n")
        (tmp_path / "game").mkdir()
        own = tmp_path / "game" / "audio-checks.toml"
        own.write_text("extend = '../base.toml'\n")
        spec = load_spec(own)
        assert spec.naming.ucs_ids == ("GUNAuto", "DOORWood")
        inline = parse_spec("format = 1\nnaming = { grammar = 'ucs', ucs_ids = ['GUNAuto', 'DOORWood'] }")
        assert spec.sha256 == inline.sha256  # so the server and the command line have one spec

    def test_a_list_that_is_not_there(self, tmp_path):
        path = tmp_path / "spec.toml"
        path.write_text("format = 1\n[categories.x.naming]\ngrammar = 'ucs'\nucs_list = 'no.csv'\n")
        with pytest.raises(SpecError, match=r"no\.csv") as caught:
            load_spec(path)
        assert caught.value.where == f"{path}: categories.x.naming.ucs_list"


class TestMetadata:
    def test_fields_by_their_standards(self):
        spec = parse_spec("format = 1\nmetadata.required = ['bext.Originator', 'iXML.ASWG.catId', 'iXML.PROJECT']")
        assert spec.required_metadata == ("bext.Originator", "iXML.ASWG.catId", "iXML.PROJECT")
        assert parse_spec("format = 1").required_metadata == ()

    def test_a_misspelt_one_names_the_nearest(self):
        assert '"bext.Originator"' in refused(
            "format = 1\nmetadata.required = ['bext.Orginator']", where="metadata.required[0]"
        )


class TestRefusals:
    @pytest.mark.parametrize(
        ("line", "where", "nearest"),
        [
            ("[limits]\ntrue_peak = -1", "limits.true_peak", "true_peak_dbtp"),
            ("[limit]\n", "limit", "limits"),
            ("[checks]\ntruepeak = 'off'", "checks.truepeak", "true-peak"),
            ("[categories.vo]\naccept.chanels = [1]", "categories.vo.accept.chanels", "channels"),
            ("[accept]\nduration_s = { maximum = 3 }", "accept.duration_s.maximum", "max"),
        ],
    )
    def test_an_unknown_key_names_the_nearest(self, line, where, nearest):
        assert f'"{nearest}"' in refused(f"format = 1\n{line}", where=where)

    @pytest.mark.parametrize(
        ("line", "where"),
        [
            ("limits.true_peak_dbtp = 'loud'", "limits.true_peak_dbtp"),
            ("limits.true_peak_dbtp = true", "limits.true_peak_dbtp"),
            ("limits.true_peak_dbtp = nan", "limits.true_peak_dbtp"),
            ("accept.channels = []", "accept.channels"),
            ("accept.channels = [1.5]", "accept.channels[0]"),
            ("accept.sample_rates_hz = [48000, 10]", "accept.sample_rates_hz[1]"),
            ("accept.duration_s = { min = 3, max = 2 }", "accept.duration_s"),
            ("accept.containers = ['aiff']", "accept.containers[0]"),
            ("accept.layouts = ['surround']", "accept.layouts[0]"),
            ("naming.pattern = '['", "naming.pattern"),
            ("naming.grammar = 'latin'", "naming.grammar"),
            ("naming.pattern = 'x'\nnaming.grammar = 'ucs'", "naming"),
            ("naming.tokens = []", "naming.tokens"),
            ("naming.tokens = ['kind']", "naming.tokens[0]"),
            ("naming.tokens = [{ digits = 2 }]", "naming.tokens[0].name"),
            ("naming.tokens = [{ name = 'x' }, { name = 'n', digits = 2, case = 'lower' }]", "naming.tokens[1]"),
            ("naming.tokens = [{ name = 'n', size = 2 }]", "naming.tokens[0].size"),
            ("naming.ucs_list = 'ucs.csv'", "naming.ucs_list"),
            ("naming.portable = 'yes'", "naming.portable"),
            ("metadata.required = ['Originator']", "metadata.required[0]"),
            ("metadata.required = ['bext.Orginator']", "metadata.required[0]"),
            ("metadata.required = ['INFO.ICOP', 'iXML.ASWG.catID']", "metadata.required[1]"),
            ("engine.adds = ['echo']", "engine.adds[0]"),
            ("checks.true-peak = 'fatal'", "checks.true-peak"),
            ("targets.PC.bit_depth = 16", "targets.PC"),
            ("targets.pc.bit_depth = 16", "targets.pc.sample_rate_hz"),
            ("targets.pc = { sample_rate_hz = 48000, bit_depth = 12 }", "targets.pc.bit_depth"),
            ("targets.pc = { sample_rate_hz = 48000, bit_depth = 16, encoding = 'float' }", "targets.pc.bit_depth"),
            ("targets.pc = { sample_rate_hz = 22050, bit_depth = 16, dither = 'shaped' }", "targets.pc.dither"),
            ("limits = 3", "limits"),
            ("extend = 'base.toml'", "extend"),
        ],
    )
    def test_a_wrong_value_names_its_place(self, line, where):
        assert refused(f"format = 1\n{line}", where=where)

    def test_the_format_must_be_said(self):
        assert refused("name = 'x'", where="format")
        assert refused("format = 2", where="format")

    def test_a_category_may_not_add_a_target(self):
        text = "format = 1\n[categories.vo.targets.pc]\nsample_rate_hz = 48000\nbit_depth = 16"
        assert "not add one" in refused(text, where="categories.vo.targets.pc")

    def test_a_category_may_not_break_a_target(self):
        text = GAME + "\n[categories.ui]\ntargets.handheld.dither = 'shaped'"
        assert refused(text, where="categories.ui.targets.handheld.dither")

    @pytest.mark.usefixtures("without_lossy")
    def test_a_check_this_version_lacks_may_warn_but_not_fail(self):
        spec = parse_spec("format = 1\n[checks]\nlossy = 'warning'\nhum = 'off'")
        assert spec.not_run == ("lossy",)
        assert refused("format = 1\n[checks]\nlossy = 'error'", where="checks.lossy")


class TestIdentity:
    def test_the_hash_is_over_canonical_json(self):
        spec = parse_spec("limits = { tail_silence_ms = 100 }\nformat = 1")
        plain = json.dumps({"format": 1, "limits": {"tail_silence_ms": 100.0}}, sort_keys=True, separators=(",", ":"))
        assert spec.sha256 == hashlib.sha256(plain.encode()).hexdigest()

    def test_the_same_spec_written_otherwise_is_equal(self):
        assert parse_spec("format = 1\nlimits.head_silence_ms = 5").sha256 == (
            parse_spec("# five\nformat = 1\n[limits]\nhead_silence_ms = 5.0\n[files]\n'*' = 'vo'").sha256
        )
        assert parse_spec("format = 1\nlimits.head_silence_ms = 6").sha256 != (
            parse_spec("format = 1\nlimits.head_silence_ms = 5").sha256
        )

    @pytest.mark.parametrize("text", [GAME, new_spec(), new_spec("48k", name='a "b" \\ \x7f \u202e ü')])
    def test_toml_reads_back_to_the_same_spec(self, text):
        spec = parse_spec(text)
        again = parse_spec(spec.to_toml())
        assert again == spec
        assert again.sha256 == spec.sha256

    def test_tokens_and_flags_survive_the_way_back(self):
        spec = parse_spec(NAMED_BY_TOKENS)
        again = parse_spec(spec.to_toml())
        assert (again.naming, again.sha256) == (spec.naming, spec.sha256)

    def test_globs_and_patterns_survive_the_way_back(self):
        text = "format = 1\nnaming.pattern = '''a'\\d+'''\n[files]\n'a \"b\"/**' = 'vo'\n[categories.x]"
        spec = parse_spec(text)
        assert parse_spec(spec.to_toml()).tables == spec.tables


class TestFolders:
    @pytest.mark.parametrize(
        ("folder", "category", "path"),
        [
            ("", "ui", "a.wav"),
            ("Assets/Audio/{category}", "ui", "Assets/Audio/ui/a.wav"),
            ("Assets/{category}", None, "Assets/a.wav"),
            ("sfx_{category}/v1.2", "ui", "sfx_ui/v1.2/a.wav"),
            ("Originals/Voices/English(US)", "vo", "Originals/Voices/English(US)/a.wav"),
        ],
    )
    def test_a_target_says_where_its_files_stand(self, folder, category, path):
        toml = f'format = 1\n[targets.game]\nsample_rate_hz = 48000\nbit_depth = 16\nfolder = "{folder}"\n'
        assert parse_spec(toml).targets["game"].path_of("a.wav", category) == path

    @pytest.mark.parametrize("folder", ["/a", "a/", "..", "a/../b", "a//b", " a", "C:/x", "a\\\\b", "{cue}", "a.", "é"])
    def test_no_folder_leads_out_of_the_pack(self, folder):
        toml = f'format = 1\n[targets.game]\nsample_rate_hz = 48000\nbit_depth = 16\nfolder = "{folder}"\n'
        with pytest.raises(SpecError, match="folders"):
            parse_spec(toml)


EVERYTHING_WRONG = """format = 1
[limits]
true_peak = -1
sample_peak_dbfs = "x"
[naming]
pattern = '''
[a-z]+'''
extension = 7
[targets."game"]
sample_rate_hz = 44100
bit_depth = 16
dither = "tdpf"
[categories.vo]
checks.true-peek = "error"
"""


def test_everything_that_is_wrong_is_said_at_once_with_its_line():
    with pytest.raises(SpecErrors) as caught:
        parse_spec(EVERYTHING_WRONG, where="mine.toml")
    assert [(error.where, str(error).rpartition(" (")[2]) for error in caught.value.errors] == [
        ("mine.toml: limits.true_peak", "line 3)"),
        ("mine.toml: limits.sample_peak_dbfs", "line 4)"),
        ("mine.toml: naming.extension", "line 8)"),
        ("mine.toml: targets.game.dither", "line 12)"),
        ("mine.toml: categories.vo.checks.true-peek", "line 14)"),
    ]
    assert len(str(caught.value).splitlines()) == 5


def test_targets_that_cannot_be_made_are_said_at_once():
    text = "format = 1\n[targets.a]\nsample_rate_hz = 48000\nbit_depth = 64\n[targets.b]\nsample_rate_hz = 48000\n"
    with pytest.raises(SpecErrors) as caught:
        parse_spec(text)
    assert [error.where for error in caught.value.errors] == [
        "spec.toml: targets.a.bit_depth",
        "spec.toml: targets.b.bit_depth",
    ]
    assert [str(error).rpartition(" (")[2] for error in caught.value.errors] == ["line 4)", "line 5)"]


def test_lines_of_a_table_in_pyproject(tmp_path):
    path = tmp_path / "pyproject.toml"
    path.write_text(
        '[project]\nname = "x"\n[tool.audio-checks]\nformat = 1\n[tool.audio-checks.limits]\ntrue_peak = 1\n'
    )
    with pytest.raises(SpecError, match=r"\(line 6\)$"):
        load_spec(path)
