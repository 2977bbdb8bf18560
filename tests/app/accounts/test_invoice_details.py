"""Invoice details: filled in once by each party, checked as they are typed, and read by no one else."""

import pytest

from app.accounts.invoice_details.rules import (
    PartyDetails,
    detail_errors,
    missing_of_buyer,
    missing_of_seller,
    normalised_account,
)
from tests.app.reviews.making import body_of, refused
from tests.support.server import World

FULL = {
    "name": "Quay Sound",
    "street": "1 Quay Street",
    "postal_code": "10115",
    "city": "Berlin",
    "country_code": "de",
    "vat_id": "de 136 695 976",
    "account_number": "GB82 WEST 1234 5698 7654 32",
}


def test_numbers_are_kept_without_spaces(world: World) -> None:
    saved = body_of(world.designer.put("/v1/me/invoice-details", json=FULL))
    assert (saved["country_code"], saved["vat_id"]) == ("DE", "DE136695976")
    assert saved["account_number"] == "GB82WEST12345698765432"
    assert body_of(world.designer.get("/v1/me/invoice-details")) == saved


def test_only_producers_read_and_save_the_details_of_a_studio(world: World) -> None:
    address = f"/v1/studios/{world.studio_id}/invoice-details"
    assert body_of(world.producer.put(address, json=FULL))["name"] == "Quay Sound"
    assert body_of(world.producer.get(address))["city"] == "Berlin"
    assert body_of(world.producer.get("/v1/me/invoice-details"))["city"] == ""
    assert refused(world.designer.get(address)) == (404, "studio-not-found")
    assert refused(world.designer.put(address, json=FULL)) == (404, "studio-not-found")


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("country_code", "Germany"),
        ("country_code", "XX"),
        ("vat_id", "136695976"),
        ("vat_id", "XX136695976"),
        ("account_number", "GB82WEST12345698765433"),
    ],
)
def test_what_cannot_be_is_refused_beside_its_field(world: World, field: str, value: str) -> None:
    answer = world.designer.put("/v1/me/invoice-details", json=FULL | {field: value})
    assert refused(answer) == (422, "bad-invoice-details")
    assert [error["where"] for error in answer.json()["errors"]] == [field]


def test_an_account_without_an_iban_stays_as_it_was_typed() -> None:
    details = PartyDetails(account_number=normalised_account(" 021000021 / 12-345 "))
    assert details.account_number == "021000021 / 12-345"
    assert not details.has_iban
    assert list(detail_errors(details)) == []


@pytest.mark.parametrize("iban", ["GB82WEST12345698765432", "DE89370400440532013000", "NO9386011117947"])
def test_the_examples_of_the_iban_registry_are_right(iban: str) -> None:
    assert list(detail_errors(PartyDetails(account_number=iban))) == []


def test_greece_has_another_prefix_for_vat() -> None:
    assert list(detail_errors(PartyDetails(country_code="GR", vat_id="EL123456789"))) == []


def test_missing_fields_follow_what_the_invoice_is() -> None:
    address = PartyDetails(name="Quay Sound", street="1 Quay Street", city="Berlin", country_code="DE")
    assert missing_of_seller(address, is_credit=False, is_untaxed=True) == ["account_number", "no_tax_reason", "vat_id"]
    assert missing_of_seller(address, is_credit=True, is_untaxed=False) == ["vat_id"]
    assert missing_of_buyer(address, is_reverse_charge=False) == []
    assert missing_of_buyer(address, is_reverse_charge=True) == ["vat_id"]
    with_tax_number = PartyDetails(**(vars(address) | {"tax_number": "12/345/67890"}))
    assert missing_of_seller(with_tax_number, is_credit=True, is_untaxed=False) == []
