import { useMutation } from '@/api'
import { electronicInvoice, type Invoice } from '@/money/api'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { saveFile } from '@/ui/saveFile'

import classes from './Page.module.css'

/** Save an invoice as a program reads it; where a party has not entered what that needs, say who can. */
export function ElectronicInvoice({ invoice }: { invoice: Invoice }) {
  const { full_number: number } = invoice
  const save = useMutation({
    mutationFn: () => electronicInvoice(invoice.id),
    onSuccess: (pdf) => saveFile(pdf, `invoice-${number.replaceAll(/[^\w.-]+/g, '-')}.pdf`),
  })
  return (
    <>
      <Button
        variant="quiet"
        icon="download"
        aria-busy={save.isPending}
        aria-label={`Download E-invoice ${number}`}
        onClick={() => save.mutate()}
      >
        E-invoice
      </Button>
      <Refusal error={save.error} className={classes.problem} />
    </>
  )
}
