"""Cells that spreadsheets would take for formulas."""

# The last four are full-width, as Excel reads them too.
FORMULA_STARTS = (*"=+-@\t\r\n", *"\uff1d\uff0b\uff0d\uff20")


def quoted_cell(text: str) -> str:
    """Return a cell's text behind an apostrophe where a spreadsheet would take it for a formula."""
    return f"'{text}" if text.startswith((*FORMULA_STARTS, "'")) else text
