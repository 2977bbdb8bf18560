"""Texts that people write are bounded before they are parsed."""

import contextlib
import os
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from audio_checks import SpecError, new_spec, parse_spec
from audio_checks.system.text_files import MOST_TOML_CHARACTERS, read_text, read_toml
from tests.support.steps import at_most
from tests.support.waves import silence, write_wav

HOSTILE = {
    "a key of dots": ("a" + ".a" * 30_000 + "=1", "more than 16 parts"),
    "a deep [files]": ("format=1\nfiles." + ".".join("a" * 200) + "=1", "more than 16 parts"),
    "quoted parts": (".".join(['"a"'] * 17) + "=1", "more than 16 parts"),
    "a head of dots": ("[" + ".".join("a" * 17) + "]", "more than 16 parts"),
    "arrays": ("a=" + "[" * 50_000, "more than 16 deep"),
    "inline tables": ("{a=" * 50_000, "more than 16 deep"),
    "hexadecimal": ("format=0x" + "f" * 99_999, "100,001 characters"),
    "decimal": ("format=" + "1" * 5_000, "5,000 characters"),
    "quotes": ('"' * 100_000, "is not TOML"),
    "escapes": ('a="""' + "\\" * 100_000, "is not TOML"),
    "too long": ("#" * (MOST_TOML_CHARACTERS + 1), "1,000,001 characters"),
    "categories": ("format=1\n" + "".join(f"[categories.c{one}]\n" for one in range(501)), "at most 500"),
    "a long key": (f'format=1\n"{"ab" * 50_000}"=1', "a key of 100,000 characters"),
    "a long text": (f'format=1\nname="{"x" * 1_001}"', "at most 1,000"),
    "tokens": ("format=1\n" + "[[naming.tokens]]\nname='x'\n" * 51, "at most 50"),
    "rates": (f"format=1\naccept.sample_rates_hz={list(range(1000, 1101))}", "at most 100"),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_toml_is_refused_quickly_with_a_reason(name: str):
    text, words = HOSTILE[name]
    # The most that one takes is 900,000 lines. Dots took 16 s and 3.4 GB, and the deep table raised RecursionError.
    with at_most(3_000_000), pytest.raises(SpecError) as refused:
        parse_spec(text)
    assert words in str(refused.value)


def test_dots_and_brackets_in_texts_and_comments_do_not_count():
    dots, brackets = ".".join("a" * 40), "[" * 40
    text = f"""# {dots} {brackets}
a = "{dots}\\"{brackets}"
b = '{dots}{brackets}'
c = \"\"\"{dots}"{brackets}
""{dots}\"\"\"
d = '''{dots}'{brackets}'''
e = [1.5, 2.5, {", ".join(["3.5"] * 40)}]
"""
    assert len(read_toml(text, "x")) == 5


def test_a_spec_with_60_categories_is_read():
    wanted = [f"kind_{place}" for place in range(60)]
    text = (
        new_spec()
        + "".join(f"\n[categories.{name}]\nlimits.true_peak_dbtp = -1.0\n" for name in wanted)
        + "[files]\n"
        + "".join(f'"{name}/**" = "{name}"\n' for name in wanted)
    )
    spec = parse_spec(text)
    assert set(wanted) <= set(spec.categories)
    assert spec.category_of("kind_7/door.wav") == "kind_7"


@pytest.mark.slow
@given(st.text("a.=[]{}\"'#\n\\1, ", max_size=60))
def test_any_text_is_read_or_refused(text: str):
    with contextlib.suppress(SpecError):
        parse_spec(text)


def test_a_file_larger_than_any_is_refused_before_it_is_read_whole(tmp_path):
    path = tmp_path / "audio-checks.toml"
    with path.open("wb") as file:
        file.truncate(1 << 40)
    with pytest.raises(SpecError, match="is larger than 32 MiB"):
        read_text(path)


@pytest.mark.slow
def test_a_hostile_tree_does_not_stop_the_command_line(tmp_path):
    write_wav(tmp_path / "door.wav", silence(seconds=0.1))
    (tmp_path / "audio-checks.toml").write_text(HOSTILE["a key of dots"][0])
    done = subprocess.run(
        [sys.executable, "-m", "audio_checks.cli", "check", str(tmp_path)], capture_output=True, text=True, timeout=300
    )
    assert done.returncode == 2
    assert "more than 16 parts" in done.stdout + done.stderr


def test_a_text_of_as_many_bytes_as_allowed_is_read_and_a_longer_one_is_not(tmp_path: Path):
    path = tmp_path / "text"
    path.write_bytes(b"x" * 1_000)
    assert read_text(path, most_bytes=1_000) == "x" * 1_000
    with pytest.raises(SpecError, match="is larger than"):
        read_text(path, most_bytes=999)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="a system without FIFOs")
def test_a_fifo_is_refused_and_not_waited_for(tmp_path: Path):
    os.mkfifo(tmp_path / "text")
    with pytest.raises(SpecError, match="is not a regular file but a pipe or a device"):
        read_text(tmp_path / "text")
