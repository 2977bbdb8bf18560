"""An invoice as the text that is printed."""

from app.agreements.clauses.facts import format_long_date
from app.agreements.clauses.text import literal
from app.agreements.drafts.documents import archival_pdf_of
from app.agreements.drafts.documents import pdf_of as document
from app.core.money import money, percent
from app.money.invoices.cross_industry_invoice import REVERSE_CHARGE
from app.money.schemas import InvoiceRead


def pdf_of(invoice: InvoiceRead) -> bytes:
    """Return an invoice as PDF; the same invoice gives the same bytes."""
    return document(title_of(invoice), markdown_of(invoice))


def archival_pdf(invoice: InvoiceRead) -> bytes:
    """Return an invoice as PDF/A-2b dated with its day, or as a plain PDF where the fonts lack a letter of it."""
    return archival_pdf_of(title_of(invoice), markdown_of(invoice), dated=invoice.issued_on)


def title_of(invoice: InvoiceRead) -> str:
    """Return the title of an invoice."""
    return f"{'Invoice' if invoice.total_minor >= 0 else 'Credit note'} {invoice.full_number}"


def markdown_of(invoice: InvoiceRead) -> str:
    """Return the text of an invoice; every sum of it is that of the lines above."""

    def amount(amount_minor: int) -> str:
        return money(amount_minor, invoice.currency)

    rows = [f"| {literal(line.text)} | {amount(line.amount_minor)} |" for line in invoice.lines]
    rows.append(f"| **Net** | {amount(invoice.net_minor)} |")
    rows += [f"| Tax, {percent(tax.tax_bp)} | {amount(tax.amount_minor)} |" for tax in invoice.taxes]
    rows.append(f"| **To pay** | **{amount(invoice.total_minor)}** |")
    paragraphs = [
        f"# {title_of(invoice)}",
        f"Issued on {format_long_date(invoice.issued_on)}. To be paid by {format_long_date(invoice.due_on)}.",
        f"Purchase order: {literal(invoice.po_number)}" if invoice.po_number else "",
        "## From",
        *(literal(line) for line in invoice.seller.splitlines() if line.strip()),
        "## To",
        *(literal(line) for line in invoice.buyer.splitlines() if line.strip()),
        "## For",
        "\n".join(["| What | Amount |", "| --- | --- |", *rows]),
        REVERSE_CHARGE if invoice.reverse_charge else "",
        literal(invoice.note),
    ]
    return "\n\n".join(paragraph for paragraph in paragraphs if paragraph)
