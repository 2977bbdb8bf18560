import { useId } from 'react'

import { DraftForm } from '@/app/drafts/DraftForm'
import { showToast } from '@/app/toast'
import { Card, CardHead } from '@/ui/Card'
import { Field, Submit } from '@/ui/Form'

import { type InvoiceDetails, useInvoiceDetails, useSaveInvoiceDetails } from './api'
import classes from './InvoiceDetails.module.css'

interface DetailField {
  name: keyof InvoiceDetails
  label: string
  hint?: string
  autoComplete?: string
}

const ADDRESS: readonly DetailField[] = [
  { name: 'name', label: 'Business name', autoComplete: 'organization' },
  { name: 'street', label: 'Street and number', autoComplete: 'street-address' },
  { name: 'postal_code', label: 'Postal code', autoComplete: 'postal-code' },
  { name: 'city', label: 'City', autoComplete: 'address-level2' },
  { name: 'country_code', label: 'Country code', hint: 'Two letters, such as DE', autoComplete: 'country' },
  { name: 'vat_id', label: 'VAT ID', hint: 'With its country, such as DE123456789' },
]
const SELLER: readonly DetailField[] = [
  { name: 'tax_number', label: 'Tax number', hint: 'Where you have no VAT ID' },
  { name: 'account_number', label: 'IBAN or account number', hint: 'To which invoices are paid' },
  { name: 'no_tax_reason', label: 'Reason why no tax is charged', hint: 'Only where your contracts name no tax' },
]
const COUNTRIES = new Intl.DisplayNames('en', { type: 'region', fallback: 'none' })

/** The English name of a country; nothing while its two letters are incomplete or unknown. */
const countryOf = (code: string): string | undefined =>
  /^[A-Za-z]{2}$/.test(code) ? COUNTRIES.of(code.toUpperCase()) : undefined

/** What electronic invoices say of the caller who sells, or of a studio that buys. */
export function InvoiceDetailsCard({ studioId }: { studioId?: string }) {
  const { data: saved } = useInvoiceDetails(studioId)
  const id = useId()
  return (
    <Card aria-labelledby={id}>
      <CardHead id={id} title="Invoice details" note="for electronic invoices" />
      {saved && <DetailsForm key={JSON.stringify(saved)} studioId={studioId} saved={saved} />}
    </Card>
  )
}

function DetailsForm({ studioId, saved }: { studioId?: string; saved: InvoiceDetails }) {
  const save = useSaveInvoiceDetails(studioId)
  return (
    <DraftForm
      className={`grid items-end gap-3 ${classes.form}`}
      aria-label="Invoice details"
      draftKey={`invoice-details:${studioId ?? 'me'}`}
      initialValues={saved}
      mutation={save}
      onSubmit={(details, onSent) =>
        save.mutate(details, {
          onSuccess: () => {
            onSent()
            showToast('Invoice details saved.')
          },
        })
      }
    >
      {(details) => (
        <>
          {(studioId === undefined ? [...ADDRESS, ...SELLER] : ADDRESS).map(({ name, hint, ...field }) => (
            <Field
              key={name}
              optional
              {...field}
              name={name}
              description={(name === 'country_code' && countryOf(details.country_code)) || hint}
              spellCheck={false}
              maxLength={120}
            />
          ))}
          <p className="small mid col-span-full">
            {studioId === undefined
              ? 'Optional. They are on your electronic invoices, and your studios see them nowhere else.'
              : 'Optional. They are on the electronic invoices of your designers.'}
          </p>
          <Submit className="flex justify-end col-span-full">Save invoice details</Submit>
        </>
      )}
    </DraftForm>
  )
}
