import { screen, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { refusal, serve } from '@/test/server'

const PDF = new File(['%PDF-1.7'], 'effects.pdf', { type: 'application/pdf' })
const BINDS = {
  title: 'Effects for Alpha',
  kind: 'single',
  version: 2,
  text_sha256: 'a'.repeat(64),
  studio_name: 'Shield Wing studio',
  designer_name: 'Sound designer',
  agreed_at: '2026-11-20T11:00:00Z',
  sealed_at: '2026-11-20T11:00:05Z',
  is_timestamped: false,
  signatures: [
    { party: 'designer', name: 'N. Designer', signed_at: '2026-11-20T10:30:00Z' },
    { party: 'studio', name: 'P. Producer', signed_at: '2026-11-20T11:00:00Z' },
  ],
}
const NOBODY = { 'GET /v1/session': { signed_in: false, demo: false, person: null } }
const choose = async () => userEvent.upload(await screen.findByLabelText(/^PDF of the contract/), PDF)

test('anyone can see that a contract is untouched, and what it binds', async () => {
  const verified = { verdict: 'untouched', file_sha256: 'b'.repeat(64), binds: BINDS }
  serve({ ...NOBODY, 'POST /v1/verify': verified })
  openApp('/verify')
  await choose()
  const card = within(await screen.findByRole('region', { name: 'effects.pdf' }))
  expect(card.getByText('Untouched')).toBeVisible()
  expect(card.getByText('Effects for Alpha (Contract, version 2)')).toBeVisible()
  expect(card.getByText('Shield Wing studio and Sound designer')).toBeVisible()
  expect(card.getByText(/^N\. Designer, /)).toBeVisible()
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(violations.map(({ id }) => id)).toEqual([])
})

test.each([
  ['changed', 'Changed', /is not the file that was sealed/],
  ['not_ours', 'Not sealed here', /has not sealed this file/],
])('a file that is %s binds nobody', async (verdict, text, meaning) => {
  serve({ ...NOBODY, 'POST /v1/verify': { verdict, file_sha256: 'b'.repeat(64), binds: null } })
  openApp('/verify')
  await choose()
  expect(await screen.findByText(text)).toBeVisible()
  expect(screen.getByText(meaning)).toBeVisible()
  expect(screen.queryByText('Between')).not.toBeInTheDocument()
})

test('what the server refuses is said', async () => {
  serve({ ...NOBODY, 'POST /v1/verify': refusal(429, 'too-many-attempts', 'too many tries; wait for 9 s') })
  openApp('/verify')
  await choose()
  expect(await screen.findByText('Too many tries; wait for 9 s.')).toBeVisible()
})
