import { Textarea, TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { type FormEvent, useState } from 'react'

import { ApiProblem } from '@/api'
import {
  type ContractMoney,
  type Invoice,
  invoiceDraftQuery,
  invoicesQuery,
  useIssueInvoice,
  useRecordPayment,
} from '@/money/api'
import { amount, minorOf, money, percent } from '@/money/words'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { day } from '@/ui/format'
import { ProblemNote } from '@/ui/ProblemNote'
import { Row, Rows } from '@/ui/Rows'

import classes from './Page.module.css'

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
      {invoices.length === 0 && billable === 0 && <p className={`mid ${classes.pad}`}>Nothing to invoice yet.</p>}
      <Rows>
        {invoices.toReversed().map((invoice) => (
          <InvoiceRow key={invoice.id} invoice={invoice} title={contract.title} isProducer={isProducer} />
        ))}
      </Rows>
      {side === 'designer' && billable !== 0 && <IssueForm contract={contract} />}
    </Card>
  )
}

const STATES = { open: 'open', partly_paid: 'partly paid', paid: 'paid', late: 'late' }

function InvoiceRow({ invoice, title, isProducer }: { invoice: Invoice; title: string; isProducer: boolean }) {
  const [paying, setPaying] = useState(false)
  const { currency, total_minor: total, open_minor: open } = invoice
  return (
    <>
      <Row>
        <span className="grow">
          <a className="link strong" href={`/v1/invoices/${invoice.id}/invoice.pdf`} target="_blank" rel="noreferrer">
            Invoice {invoice.number}
          </a>
          <span className="small mid">
            {' '}
            {STATES[invoice.state]},{' '}
            {open === 0 ? `issued ${day(invoice.issued_on)}` : `to be paid by ${day(invoice.due_on)}`}
            {open !== 0 && open !== total && `, ${amount(open, currency)} open`}
          </span>
        </span>
        <span className="nowrap">{money(total, currency)}</span>
        {isProducer && open !== 0 && !paying && (
          <Button onClick={() => setPaying(true)} aria-label={`Record a payment on invoice ${invoice.number}`}>
            Record payment
          </Button>
        )}
      </Row>
      {paying && (
        <li>
          <PaymentForm invoice={invoice} title={title} onDone={() => setPaying(false)} />
        </li>
      )}
    </>
  )
}

function today(): string {
  const now = new Date()
  return new Date(now.getTime() - now.getTimezoneOffset() * 60_000).toISOString().slice(0, 10)
}

function PaymentForm({ invoice, title, onDone }: { invoice: Invoice; title: string; onDone: () => void }) {
  const record = useRecordPayment(invoice.id)
  const [typed, setTyped] = useState(amount(invoice.open_minor, invoice.currency))
  const [reference, setReference] = useState('')
  const [paidOn, setPaidOn] = useState(today())
  const [missing, setMissing] = useState<{ amount?: string; reference?: string }>({})
  const send = (event: FormEvent) => {
    event.preventDefault()
    const minor = minorOf(typed, invoice.currency)
    const lacks = {
      amount: minor === null || minor === 0 ? `Write an amount in ${invoice.currency}, as in 180.00.` : undefined,
      reference: reference.trim() === '' ? 'Write the bank’s reference.' : undefined,
    }
    setMissing(lacks)
    if (minor === null || lacks.amount || lacks.reference) return
    record.mutate({ amount_minor: minor, reference: reference.trim(), paid_on: paidOn }, { onSuccess: onDone })
  }
  return (
    <form
      className={classes.form}
      onSubmit={send}
      noValidate
      aria-label={`Payment on invoice ${invoice.number}, ${title}`}
    >
      <TextInput
        label={`Amount, ${invoice.currency}`}
        value={typed}
        onChange={(event) => setTyped(event.currentTarget.value)}
        error={missing.amount}
        inputMode="decimal"
      />
      <TextInput
        label="Reference"
        value={reference}
        onChange={(event) => setReference(event.currentTarget.value)}
        error={missing.reference}
      />
      <TextInput
        label="Paid on"
        type="date"
        value={paidOn}
        onChange={(event) => setPaidOn(event.currentTarget.value)}
      />
      {record.error instanceof ApiProblem && (
        <div className={classes.wide}>
          <ProblemNote detail={record.error.detail} fix={record.error.fix} />
        </div>
      )}
      <div className={classes.foot}>
        <Button variant="quiet" onClick={onDone}>
          Not now
        </Button>
        <Button type="submit" variant="primary">
          Record payment
        </Button>
      </div>
    </form>
  )
}

function IssueForm({ contract }: { contract: ContractMoney }) {
  const { data: draft } = useQuery(invoiceDraftQuery(contract.contract_id))
  const issue = useIssueInvoice(contract.contract_id)
  const [seller, setSeller] = useState<string | null>(null)
  const [buyer, setBuyer] = useState<string | null>(null)
  const [order, setOrder] = useState<string | null>(null)
  if (!draft) return null
  const { currency } = draft
  const send = (event: FormEvent) => {
    event.preventDefault()
    issue.mutate({
      seller: seller ?? draft.seller,
      buyer: buyer ?? draft.buyer,
      po_number: order ?? draft.po_number,
      note: '',
    })
  }
  return (
    <form className={classes.form} onSubmit={send} noValidate aria-label={`Invoice ${draft.number}, ${contract.title}`}>
      <div className={`${classes.wide} ${classes.lines}`}>
        {draft.lines.map((line, place) => (
          <p key={`${place} ${line.text}`} className={classes.line}>
            <span className="mid">{line.text}</span> <span>{amount(line.amount_minor, currency)}</span>
          </p>
        ))}
        {draft.taxes.map((tax) => (
          <p key={tax.tax_bp} className={classes.line}>
            <span className="mid">Tax, {percent(tax.tax_bp)}</span> <span>{amount(tax.amount_minor, currency)}</span>
          </p>
        ))}
        <p className={`strong ${classes.line}`}>
          <span>To pay within {draft.payment_days} days</span> <span>{money(draft.total_minor, currency)}</span>
        </p>
      </div>
      <Textarea
        label="From: name, address, tax number"
        rows={3}
        value={seller ?? draft.seller}
        onChange={(event) => setSeller(event.currentTarget.value)}
      />
      <Textarea
        label="To"
        rows={3}
        value={buyer ?? draft.buyer}
        onChange={(event) => setBuyer(event.currentTarget.value)}
      />
      <TextInput
        label="Purchase order"
        value={order ?? draft.po_number}
        onChange={(event) => setOrder(event.currentTarget.value)}
      />
      {issue.error instanceof ApiProblem && (
        <div className={classes.wide}>
          <ProblemNote detail={issue.error.detail} fix={issue.error.fix} />
        </div>
      )}
      <div className={classes.foot}>
        <Button type="submit" variant="primary">
          Issue invoice {draft.number}
        </Button>
      </div>
    </form>
  )
}
