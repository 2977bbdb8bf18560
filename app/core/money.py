"""Sums in whole minor units of one currency."""

# ISO 4217, list one: the currencies whose minor unit is not a hundredth.
_MINOR_DIGITS = {
    **dict.fromkeys(("BIF", "CLP", "DJF", "GNF", "ISK", "JPY", "KMF", "KRW", "PYG"), 0),
    **dict.fromkeys(("RWF", "UGX", "UYI", "VND", "VUV", "XAF", "XOF", "XPF"), 0),
    **dict.fromkeys(("BHD", "IQD", "JOD", "KWD", "LYD", "OMR", "TND"), 3),
}
BASIS_POINTS = 10_000  # the whole


def minor_digits(currency: str) -> int:
    """Return the number of digits after the decimal point in a currency's amounts."""
    return _MINOR_DIGITS.get(currency, 2)


def money(amount_minor: int, currency: str) -> str:
    """Return an amount as contracts write it: USD 7,200.00, a true minus before what is owed back."""
    digits = minor_digits(currency)
    whole, rest = divmod(abs(amount_minor), 10**digits)
    sign = "−" if amount_minor < 0 else ""
    return f"{sign}{currency} {whole:,}" + (f".{rest:0{digits}d}" if digits else "")


def percent(basis_points: int) -> str:
    """Return basis points as a percentage: 25 %, 12.5 %."""
    whole, rest = divmod(basis_points, 100)
    return f"{whole}{f'.{rest:02d}'.rstrip('0') if rest else ''} %"


def part_of(amount_minor: int, basis_points: int) -> int:
    """Return a part of an amount, rounded once, half away from zero."""
    numerator = abs(amount_minor) * basis_points
    part = (2 * numerator + BASIS_POINTS) // (2 * BASIS_POINTS)
    return part if amount_minor >= 0 else -part
