"""A party's details on invoices: an address, tax numbers, an account; and those that an electronic one needs."""

import re
from collections.abc import Iterator
from dataclasses import dataclass

# ISO 3166-1 alpha-2, as assigned.
_CODES = """
AD AE AF AG AI AL AM AO AQ AR AS AT AU AW AX AZ BA BB BD BE BF BG BH BI BJ BL BM BN BO BQ BR BS BT BV BW BY BZ
CA CC CD CF CG CH CI CK CL CM CN CO CR CU CV CW CX CY CZ DE DJ DK DM DO DZ EC EE EG EH ER ES ET FI FJ FK FM FO FR
GA GB GD GE GF GG GH GI GL GM GN GP GQ GR GS GT GU GW GY HK HM HN HR HT HU ID IE IL IM IN IO IQ IR IS IT JE JM JO JP
KE KG KH KI KM KN KP KR KW KY KZ LA LB LC LI LK LR LS LT LU LV LY MA MC MD ME MF MG MH MK ML MM MN MO MP MQ MR MS MT
MU MV MW MX MY MZ NA NC NE NF NG NI NL NO NP NR NU NZ OM PA PE PF PG PH PK PL PM PN PR PS PT PW PY QA RE RO RS RU RW
SA SB SC SD SE SG SH SI SJ SK SL SM SN SO SR SS ST SV SX SY SZ TC TD TF TG TH TJ TK TL TM TN TO TR TT TV TW TZ
UA UG UM US UY UZ VA VC VE VG VI VN VU WF WS YE YT ZA ZM ZW
"""
COUNTRY_CODES = frozenset(_CODES.split())
GREEK_VAT_PREFIX = "EL"  # the one prefix that is not the code of its country, beside Northern Ireland's XI
VAT_ID = re.compile(r"([A-Z]{2})[A-Z0-9+*]{2,13}")
IBAN = re.compile(r"[A-Z]{2}[0-9]{2}[A-Z0-9]{11,30}")


@dataclass(frozen=True)
class PartyDetails:
    """The details of one party on invoices; a field that was not filled in is empty."""

    name: str = ""
    street: str = ""
    postal_code: str = ""
    city: str = ""
    country_code: str = ""
    vat_id: str = ""
    tax_number: str = ""
    account_number: str = ""
    no_tax_reason: str = ""

    @property
    def has_iban(self) -> bool:
        """Whether the account is named by an IBAN."""
        return IBAN.fullmatch(self.account_number) is not None

    @property
    def address(self) -> list[str]:
        """The lines by which the party is named on paper."""
        city_line = f"{self.postal_code} {self.city}".strip()
        tax = [
            f"VAT ID {self.vat_id}" if self.vat_id else "",
            f"Tax number {self.tax_number}" if self.tax_number else "",
        ]
        return [line for line in (self.name, self.street, city_line, self.country_code, *tax) if line]


def normalised_code(text: str) -> str:
    """Return a number without the spaces and marks that people set into it."""
    return re.sub(r"[\s.\-/]", "", text).upper()


def normalised_account(text: str) -> str:
    """Return an IBAN without spaces; any other number of an account stays as it was typed."""
    return packed if IBAN.fullmatch(packed := normalised_code(text)) else text.strip()


def detail_errors(details: PartyDetails) -> Iterator[tuple[str, str]]:
    """Yield the faults of details that were filled in: the field, and the fault in words."""
    if details.country_code and details.country_code not in COUNTRY_CODES:
        yield (
            "country_code",
            f"{details.country_code} is not a country code; wanted two letters of ISO 3166, such as DE",
        )
    if details.vat_id:
        match = VAT_ID.fullmatch(details.vat_id)
        if match is None or match[1] not in {*COUNTRY_CODES, GREEK_VAT_PREFIX, "XI"}:
            yield "vat_id", f"{details.vat_id} has no country in front; wanted it as in DE123456789"
    if details.has_iban and not _is_sum_right(details.account_number):
        yield "account_number", "the check digits of this IBAN do not fit; compare it with your bank's"


def _is_sum_right(iban: str) -> bool:
    """Whether an IBAN leaves 1 when divided by 97 (ISO 13616)."""
    return int("".join(str(int(letter, 36)) for letter in iban[4:] + iban[:4])) % 97 == 1


def missing_of_seller(details: PartyDetails, *, is_credit: bool, is_untaxed: bool) -> list[str]:
    """Return the fields that an electronic invoice lacks of its seller: where no tax is charged, the reason."""
    needed = ["name", "street", "city", "country_code"]
    needed += [] if is_credit else ["account_number"]
    needed += ["no_tax_reason"] if is_untaxed else []
    missing = [field for field in needed if not getattr(details, field)]
    return missing if details.vat_id or details.tax_number else [*missing, "vat_id"]


def missing_of_buyer(details: PartyDetails, *, is_reverse_charge: bool) -> list[str]:
    """Return the fields that an electronic invoice lacks of its buyer; reverse charge wants a VAT ID."""
    needed = ["name", "street", "city", "country_code", *(["vat_id"] if is_reverse_charge else [])]
    return [field for field in needed if not getattr(details, field)]
