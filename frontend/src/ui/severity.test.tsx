import { render, screen } from '@testing-library/react'
import { expect, it } from 'vitest'

import { Finding } from './Finding'
import type { Severity } from './severity'

it.each<[Severity, string]>([
  ['error', 'Error: Reverb'],
  ['warning', 'Warning: Reverb'],
  ['information', 'To listen to: Reverb'],
])('reads out how grave a finding is: %s', (severity, text) => {
  render(
    <Finding severity={severity} head="Reverb">
      Listen.
    </Finding>,
  )
  expect(screen.getByRole('article', { name: 'Reverb' })).toHaveTextContent(text)
})
