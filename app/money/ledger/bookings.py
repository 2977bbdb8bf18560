"""The invoices and payments of a contract as bookings, stated without a database; one line says debit and credit."""

import csv
import io
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import date
from decimal import Decimal
from enum import StrEnum

from app.core.money import minor_digits
from app.sound_lists.rules import spreadsheet_safe

COLUMNS = (
    *("date", "document", "kind", "party", "debit", "credit", "amount", "currency"),
    *("tax_rate", "tax_category", "due_date", "po_number", "contract", "text"),
)


class Account(StrEnum):
    """An account of either party's books; accountants give it their own number on import."""

    RECEIVABLE = "Accounts receivable"
    PAYABLE = "Accounts payable"
    SALES = "Sales of sound"
    PURCHASES = "Purchases of sound"
    TAX_DUE = "Output tax"
    TAX_BACK = "Input tax"
    INTEREST_INCOME = "Interest income"
    INTEREST_EXPENSE = "Interest expense"
    BANK = "Bank"


@dataclass(frozen=True)
class Books:
    """The accounts by which one side books."""

    balance: Account  # what is open between the parties
    work: Account
    tax: Account
    interest: Account
    is_seller: bool


SELLERS = Books(Account.RECEIVABLE, Account.SALES, Account.TAX_DUE, Account.INTEREST_INCOME, is_seller=True)
BUYERS = Books(Account.PAYABLE, Account.PURCHASES, Account.TAX_BACK, Account.INTEREST_EXPENSE, is_seller=False)


@dataclass(frozen=True)
class Document:
    """An invoice or a payment, as each of its bookings names it."""

    on: date
    number: str
    kind: str
    party: str
    currency: str
    contract: str
    due_on: date | None = None
    po_number: str = ""


@dataclass(frozen=True)
class Booking:
    """One amount that goes to one account and comes from another."""

    document: Document
    debit: Account
    credit: Account
    amount_minor: int
    text: str
    tax_bp: int | None = None
    tax_category: str = ""

    @property
    def cells(self) -> list[str]:
        """The row of a booking; an amount below zero is one above it with debit and credit exchanged."""
        document, is_back = self.document, self.amount_minor < 0
        debit, credit = (self.credit, self.debit) if is_back else (self.debit, self.credit)
        amount = Decimal(abs(self.amount_minor)).scaleb(-minor_digits(document.currency))
        return [
            *(document.on.isoformat(), _cell(document.number), document.kind, _cell(document.party)),
            *(debit.value, credit.value, f"{amount:f}", document.currency),
            *("" if self.tax_bp is None else f"{Decimal(self.tax_bp).scaleb(-2).normalize():f}", self.tax_category),
            document.due_on.isoformat() if document.due_on else "",
            *(_cell(document.po_number), _cell(document.contract), _cell(self.text)),
        ]


def billed(
    books: Books,
    document: Document,
    amount_minor: int,
    text: str,
    *,
    account: Account,
    tax_bp: int | None,
    category: str,
) -> Booking:
    """Return the booking of what an invoice charges to an account."""
    debit, credit = (books.balance, account) if books.is_seller else (account, books.balance)
    return Booking(document, debit, credit, amount_minor, text, tax_bp, category)


def paid(books: Books, document: Document, amount_minor: int, text: str) -> Booking:
    """Return the booking of a payment; what went back is below zero."""
    debit, credit = (Account.BANK, books.balance) if books.is_seller else (books.balance, Account.BANK)
    return Booking(document, debit, credit, amount_minor, text)


def _cell(text: str) -> str:
    return spreadsheet_safe(" ".join(text.split()))


def csv_of(bookings: Iterable[Booking]) -> str:
    """Return bookings as CSV, by their day."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\r\n")
    writer.writerow(COLUMNS)
    writer.writerows(booking.cells for booking in sorted(bookings, key=lambda entry: entry.document.on))
    return out.getvalue()
