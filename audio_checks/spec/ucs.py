"""Names after the Universal Category System, and its list of category ids.

    CatID-UserCategory_VendorCategory-FXName_CreatorID_SourceID_UserData

User category, vendor category and user data may be left out.
Source: the Universal Category System, file naming, version 8.2; its list of categories is a table with a column CatID.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Collection
from pathlib import Path

from audio_checks.errors import SpecError
from audio_checks.system.text_files import read_text

BLOCKS = ("CatID", "FXName", "CreatorID", "SourceID", "UserData")
CAT_ID = re.compile(r"[A-Z]{2}[A-Za-z0-9]*", re.ASCII)
MOST_LIST_BYTES = 4 << 20


def misfit(stem: str, cat_ids: Collection[str]) -> str | None:
    """Return the misfit of a name to the system, in words; None for a right name.

    Parameters
    ----------
    stem : str
        The name without its ending.
    cat_ids : collection of str
        The ids that there are; with none, only the form of the id counts.
    """
    blocks = stem.split("_")
    if not 4 <= len(blocks) <= 5:
        blocks_text = "1 block" if len(blocks) == 1 else f"{len(blocks)} blocks"
        return f"{blocks_text} between underscores, wanted CatID_FXName_CreatorID_SourceID"
    for name, block in zip(BLOCKS, blocks, strict=False):
        if not block.strip():
            return f"the {name} is empty"
    cat_id, dash, user_category = blocks[0].partition("-")
    if not CAT_ID.fullmatch(cat_id):
        return f'"{cat_id}" is not a CatID, such as GUNAuto'
    if cat_ids and cat_id not in cat_ids:
        from difflib import get_close_matches  # only where a mistake is reported

        (near,) = get_close_matches(cat_id[:40], cat_ids, n=1, cutoff=0.0)
        return f'the list has no CatID "{cat_id}"; the nearest is "{near}"'
    if dash and not user_category.strip():
        return "the user category after the CatID is empty"
    vendor_category, dash, fx_name = blocks[1].partition("-")
    if dash and not (vendor_category.strip() and fx_name.strip()):
        return "the vendor category or the FXName is empty"
    return None


def read_cat_ids(path: Path) -> list[str]:
    """Return the ids of a list of categories: a CSV file with a column CatID, in the file's order.

    Raises
    ------
    SpecError
        The file cannot be read, or has no such column, or no id in it.
    """
    where = str(path)
    text = read_text(path, fix="save it as CSV UTF-8", most_bytes=MOST_LIST_BYTES)
    between = max(",;\t", key=text.partition("\n")[0].count)
    try:
        rows = list(csv.reader(io.StringIO(text, newline=""), delimiter=between))
    except csv.Error as error:
        raise SpecError(f"is not CSV: {error}", where=where) from None
    names = [name.strip().lower().replace(" ", "") for name in rows[0]] if rows else []
    if "catid" not in names:
        raise SpecError("its first row names no column CatID", where=where)
    column = names.index("catid")
    ids = dict.fromkeys(row[column].strip() for row in rows[1:] if len(row) > column and row[column].strip())
    wrong = next((cat_id for cat_id in ids if not CAT_ID.fullmatch(cat_id)), None)
    if wrong is not None:
        raise SpecError(f'"{wrong[:40]}" in the column CatID is not an id, such as GUNAuto', where=where)
    if not ids:
        raise SpecError("its column CatID is empty", where=where)
    return list(ids)
