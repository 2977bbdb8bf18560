import { screen, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { expect, test } from 'vitest'

import { keptDraft } from '@/app/drafts'
import { openApp } from '@/test/openApp'
import { aMe } from '@/test/review'
import { refusal, serve, wrote } from '@/test/server'

const EMPTY = {
  name: '',
  street: '',
  postal_code: '',
  city: '',
  country_code: '',
  vat_id: '',
  tax_number: '',
  account_number: '',
  no_tax_reason: '',
}
const as = (me: ReturnType<typeof aMe>) => ({
  'GET /v1/session': { signed_in: true, demo: true, person: me.person },
  'GET /v1/me': me,
  'GET /v1/review-queue/count': { cues: 0, is_all: true },
})

test('a designer enters what electronic invoices say, and a refusal stands at its field', async () => {
  const { asked } = serve({
    ...as({ ...aMe({ part: 'designer' }), studios: [] }),
    'GET /v1/me/invoice-details': EMPTY,
    'PUT /v1/me/invoice-details': refusal(422, 'bad-invoice-details', 'no country in front', {
      errors: [{ where: 'vat_id', message: '123 has no country in front' }],
    }),
  })
  openApp('/account')
  const card = await screen.findByRole('region', { name: 'Invoice details' })
  const country = await within(card).findByLabelText('Country code')
  await userEvent.type(country, 'de')
  expect(country).toHaveAccessibleDescription('Germany')
  await userEvent.type(within(card).getByLabelText('VAT ID'), '123')
  expect(keptDraft('invoice-details:me')).toMatchObject({ country_code: 'de', vat_id: '123' })
  await userEvent.click(within(card).getByRole('button', { name: 'Save invoice details' }))
  expect(await within(card).findByText('123 has no country in front.')).toBeVisible()
  expect(within(card).getByLabelText('VAT ID')).toHaveValue('123')
  expect(wrote(asked, 'PUT /v1/me/invoice-details')[0]?.body).toEqual({ ...EMPTY, country_code: 'de', vat_id: '123' })
  expect((await axe.run(card, { rules: { 'color-contrast': { enabled: false } } })).violations).toEqual([])
})

test('a studio is asked for no account', async () => {
  const studios: ReturnType<typeof aMe>['studios'] = [{ id: 'studio-1', name: 'Studio', roles: ['producer'] }]
  serve({ ...as({ ...aMe(), studios }), 'GET /v1/studios/studio-1/invoice-details': { ...EMPTY, city: 'Dublin' } })
  openApp('/studio')
  const card = await screen.findByRole('region', { name: 'Invoice details' })
  expect(await within(card).findByLabelText('City')).toHaveValue('Dublin')
  expect(within(card).queryByLabelText('IBAN or account number')).not.toBeInTheDocument()
})
