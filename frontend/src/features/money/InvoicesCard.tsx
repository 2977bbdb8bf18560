import { Textarea, TextInput } from '@mantine/core'
import { useDebouncedValue } from '@mantine/hooks'
import { useQuery } from '@tanstack/react-query'
import { type FormEvent, useState } from 'react'

import { DraftNote, useDraft } from '@/app/drafts'
import {
  type ContractMoney,
  type Invoice,
  invoiceDraftQuery,
  invoicesQuery,
  type Payment,
  useChargeInterest,
  useIssueInvoice,
  useRecordPayment,
  useRefund,
} from '@/money/api'
import { amount, money, percent } from '@/money/words'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { day, plural } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'

import { ElectronicInvoice } from './ElectronicInvoice'
import classes from './Page.module.css'
import { PaymentForm } from './PaymentForm'

interface InvoicesCardProps {
  contract: ContractMoney
  side: 'team' | 'designer'
  isProducer: boolean
}

/** What was invoiced and paid; the designer issues the next one, a producer records what was paid. */
export function InvoicesCard({ contract, side, isProducer }: InvoicesCardProps) {
  const { data: invoices = [] } = useQuery(invoicesQuery(contract.contract_id))
  const id = `invoices-${contract.contract_id}`
  const billable = contract.billable_minor
  return (
    <Card aria-label={`Invoices, ${contract.title}`}>
      <CardHead
        id={id}
        title="Invoices"
        count={invoices.length > 0 ? invoices.length : undefined}
        end={billable !== 0 && `${money(billable, contract.currency)} not invoiced yet`}
      />
      {invoices.length === 0 && billable === 0 && <p className="mid p-3-inset">Nothing to invoice yet.</p>}
      <Rows>
        {invoices.toReversed().map((invoice) => (
          <InvoiceRow key={invoice.id} invoice={invoice} title={contract.title} side={side} isProducer={isProducer} />
        ))}
      </Rows>
      {side === 'designer' && billable !== 0 && <IssueForm contract={contract} />}
    </Card>
  )
}

const STATES = { open: 'open', partly_paid: 'partly paid', paid: 'paid', late: 'late' }

interface InvoiceRowProps {
  invoice: Invoice
  title: string
  side: 'team' | 'designer'
  isProducer: boolean
}

function InvoiceRow({ invoice, title, side, isProducer }: InvoiceRowProps) {
  const [paying, setPaying] = useState(false)
  const { currency, total_minor: total, open_minor: open } = invoice
  return (
    <>
      <Row className={classes.cue}>
        <span className="grow">
          <a className="link strong" href={`/v1/invoices/${invoice.id}/invoice.pdf`} target="_blank" rel="noreferrer">
            Invoice {invoice.full_number}
          </a>
          <span className="small mid">
            {' '}
            {STATES[invoice.state]}, {open === 0 ? `issued ${day(invoice.issued_on)}` : `due ${day(invoice.due_on)}`}
            {open !== 0 && open !== total && `, ${amount(open, currency)} unpaid`}
          </span>
        </span>
        <span className="nowrap">{money(total, currency)}</span>
        <ElectronicInvoice invoice={invoice} />
        {isProducer && open !== 0 && !paying && (
          <Button onClick={() => setPaying(true)} aria-label={`Record payment on invoice ${invoice.full_number}`}>
            Record payment
          </Button>
        )}
      </Row>
      {invoice.late_interest_minor > 0 && <LateInterest invoice={invoice} side={side} />}
      {paying && (
        <li>
          <PayForm invoice={invoice} title={title} onDone={() => setPaying(false)} />
        </li>
      )}
      {invoice.payments.map((payment) => (
        <PaymentRow key={payment.id} payment={payment} invoice={invoice} isProducer={isProducer} />
      ))}
    </>
  )
}

/** What an invoice that was not paid in time bears by today; the designer charges what is not charged yet. */
function LateInterest({ invoice, side }: { invoice: Invoice; side: 'team' | 'designer' }) {
  const charge = useChargeInterest(invoice)
  const { currency, late_interest_minor: bears, late_interest_charged_minor: charged } = invoice
  const left = bears - charged
  return (
    <Row dense className={classes.payment}>
      <span className="grow small mid">
        late interest by today, {amount(bears, currency)}
        {charged > 0 && `; ${amount(charged, currency)} charged`}
      </span>
      {side === 'designer' && left > 0 && (
        <Button
          variant="quiet"
          disabled={charge.isPending}
          onClick={() => charge.mutate()}
          aria-label={`Charge late interest on invoice ${invoice.full_number}`}
        >
          Charge {amount(left, currency)}
        </Button>
      )}
      <Refusal error={charge.error} />
    </Row>
  )
}

function PayForm({ invoice, title, onDone }: { invoice: Invoice; title: string; onDone: () => void }) {
  return (
    <PaymentForm
      name={`Payment on invoice ${invoice.full_number}, ${title}`}
      verb="Record payment"
      day="Paid on"
      mostMinor={invoice.open_minor}
      currency={invoice.currency}
      record={useRecordPayment(invoice.id)}
      onDone={onDone}
    />
  )
}

interface PaymentRowProps {
  payment: Payment
  invoice: Invoice
  isProducer: boolean
}

/** One payment as it was written down; what went back is a line of its own below it. */
function PaymentRow({ payment, invoice, isProducer }: PaymentRowProps) {
  const [returning, setReturning] = useState(false)
  const { currency, full_number: number } = invoice
  const { amount_minor: minor, left_minor: left, paid_on: on, reference } = payment
  const isRefund = payment.refund_of_id !== null
  return (
    <>
      <Row dense className={classes.payment}>
        <span className="grow small mid">
          {isRefund ? 'refunded' : 'paid'} {day(on)}, {reference}
          {!isRefund && left !== minor && `, ${amount(left, currency)} after refunds`}
        </span>
        <span className="small nowrap">{amount(minor, currency)}</span>
        {isProducer && !isRefund && left !== 0 && !returning && (
          <Button
            variant="quiet"
            onClick={() => setReturning(true)}
            aria-label={`Record refund of ${reference}, invoice ${number}`}
          >
            Record refund
          </Button>
        )}
      </Row>
      {returning && (
        <li>
          <RefundForm payment={payment} invoice={invoice} onDone={() => setReturning(false)} />
        </li>
      )}
    </>
  )
}

function RefundForm({ payment, invoice, onDone }: { payment: Payment; invoice: Invoice; onDone: () => void }) {
  return (
    <PaymentForm
      name={`Refund of ${payment.reference}, invoice ${invoice.full_number}`}
      verb="Record refund"
      day="Refunded on"
      note="The payment stays in the ledger. The refund is added as new lines."
      mostMinor={payment.left_minor}
      currency={invoice.currency}
      record={useRefund(payment.id)}
      onDone={onDone}
    />
  )
}

function IssueForm({ contract }: { contract: ContractMoney }) {
  const issue = useIssueInvoice(contract.contract_id)
  const [{ number = null, seller, buyer, order }, setTyped, typed] = useDraft<{
    number: string | null
    seller: string | null
    buyer: string | null
    order: string | null
  }>(`invoice:${contract.contract_id}`, { number: null, seller: null, buyer: null, order: null })
  const [asked] = useDebouncedValue(number?.trim() ?? '', 250)
  const { data: draft } = useQuery(invoiceDraftQuery(contract.contract_id, asked))
  if (!draft) return null
  const { currency } = draft
  const send = (event: FormEvent) => {
    event.preventDefault()
    issue.mutate(
      {
        full_number: number ?? draft.full_number,
        seller: seller ?? draft.seller,
        buyer: buyer ?? draft.buyer,
        po_number: order ?? draft.po_number,
        note: '',
      },
      { onSuccess: typed.discard },
    )
  }
  return (
    <form
      className={`grid gap-3 ${classes.form}`}
      onSubmit={send}
      noValidate
      aria-label={`New invoice, ${contract.title}`}
    >
      <div className={`${classes.wide} mb-2`}>
        {draft.lines.map((line, place) => (
          <p key={`${place} ${line.text}`} className="grid grid-cols-1-auto gap-0-3">
            <span className="mid">{line.text}</span> <span>{amount(line.amount_minor, currency)}</span>
          </p>
        ))}
        {draft.taxes.map((tax) => (
          <p key={tax.tax_bp} className="grid grid-cols-1-auto gap-0-3">
            <span className="mid">Tax, {percent(tax.tax_bp)}</span> <span>{amount(tax.amount_minor, currency)}</span>
          </p>
        ))}
        <p className="strong grid grid-cols-1-auto gap-0-3">
          <span>{`Payment term ${plural(draft.payment_days, 'day')}`}</span>{' '}
          <span>{money(draft.total_minor, currency)}</span>
        </p>
      </div>
      <TextInput
        label="Invoice number"
        description="The next one follows from it."
        maxLength={40}
        value={number ?? draft.full_number}
        error={draft.is_number_taken && draft.number_advice}
        onChange={({ currentTarget: { value } }) => setTyped((now) => ({ ...now, number: value }))}
      />
      {draft.number_advice !== '' && !draft.is_number_taken && (
        <p className={`small tone-warn ${classes.wide}`} role="status">
          <span className="toned">{draft.number_advice}</span>
        </p>
      )}
      <Textarea
        label="From: name, address, tax number"
        rows={3}
        value={seller ?? draft.seller}
        onChange={({ currentTarget: { value } }) => setTyped((now) => ({ ...now, seller: value }))}
      />
      <Textarea
        label="To"
        rows={3}
        value={buyer ?? draft.buyer}
        onChange={({ currentTarget: { value } }) => setTyped((now) => ({ ...now, buyer: value }))}
      />
      <TextInput
        label="Purchase order"
        value={order ?? draft.po_number}
        onChange={({ currentTarget: { value } }) => setTyped((now) => ({ ...now, order: value }))}
      />
      <DraftNote draft={typed} />
      <Refusal error={issue.error} className={classes.wide} />
      <div className="row wrap justify-end col-span-full">
        <Button type="submit" variant="primary" disabled={draft.is_number_taken}>
          Issue invoice {number?.trim() || draft.full_number}
        </Button>
      </div>
    </form>
  )
}
