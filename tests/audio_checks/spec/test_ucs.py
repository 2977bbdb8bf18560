"""Names after the Universal Category System, and the list of its ids."""

import pytest

from audio_checks.errors import SpecError
from audio_checks.spec.ucs import misfit, read_cat_ids

IDS = ("GUNAuto", "DOORWood", "UIClick")


@pytest.mark.parametrize(
    "stem",
    [
        "GUNAuto_M4 Burst_ML_SHIELD",
        "GUNAuto-EXT_Rifle-M4 Burst_ML_SHIELD",
        "DOORWood_Creak, slow_ML_NONE_48k stereo",
        "UIClick_Confirm-soft_ML_SW",
    ],
)
def test_right_names(stem):
    assert misfit(stem, IDS) is None
    assert misfit(stem, ()) is None


@pytest.mark.parametrize(
    ("stem", "why"),
    [
        ("laser_fire", "2 blocks between underscores"),
        ("laser", "1 block between"),
        ("GUNAuto_a_b_c_d_e", "6 blocks"),
        ("GUNAuto__ML_SW", "the FXName is empty"),
        ("GUNAuto_Burst_ML_", "the SourceID is empty"),
        ("gunAuto_Burst_ML_SW", '"gunAuto" is not a CatID'),
        ("GUNAto_Burst_ML_SW", 'no CatID "GUNAto"; the nearest is "GUNAuto"'),
        ("GUNAuto-_Burst_ML_SW", "user category"),
        ("GUNAuto_-Burst_ML_SW", "vendor category"),
        ("GUNAuto_Rifle-_ML_SW", "vendor category"),
    ],
)
def test_what_is_wrong(stem, why):
    assert why in misfit(stem, IDS)


@pytest.mark.parametrize("between", [",", ";", "\t"])
def test_the_list_is_read_by_its_column(tmp_path, between):
    rows = (
        ["Category", "SubCategory", "Cat ID"],
        ["GUNS", "AUTOMATIC", "GUNAuto"],
        ["", "", ""],
        ["x", "y", "DOORWood"],
    )
    path = tmp_path / "ucs.csv"
    path.write_bytes(b"\xef\xbb\xbf" + "\r\n".join(between.join(row) for row in rows).encode())
    assert read_cat_ids(path) == ["GUNAuto", "DOORWood"]


@pytest.mark.parametrize(
    ("content", "why"),
    [
        (b"Category,Id\nGUNS,GUNAuto\n", "no column CatID"),
        (b"", "no column CatID"),
        (b"CatID\n", "empty"),
        (b"CatID\nguns auto\n", '"guns auto"'),
        (b"CatID\n\xff\xfe", "UTF-8"),
        (b"CatID\n" + b"x" * (5 << 20), "is larger than 4 MiB"),
        (None, "cannot be read"),
    ],
)
def test_what_is_no_list(tmp_path, content, why):
    path = tmp_path / "ucs.csv"
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(SpecError, match=why):
        read_cat_ids(path)
