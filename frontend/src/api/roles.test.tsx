import { QueryClient, QueryClientProvider } from '@tanstack/react-query'
import { render, screen } from '@testing-library/react'
import { expect, test } from 'vitest'

import { serve } from '@/test/server'
import { Person } from '@/ui/Person'

import { useRoles } from './roles'

const person = (id: string) => ({ id, name: id })

function Everyone() {
  const roleOf = useRoles('p1')
  return ['Ada', 'Lee', 'Director', 'Guest'].map((id) => (
    <p key={id}>
      <Person name={id} role={roleOf(id)} />
    </p>
  ))
}

test('beside a name stands what the person is in the project', async () => {
  serve({
    'GET /v1/projects/p1': {
      id: 'p1',
      approver: person('Director'),
      liaisons: [person('Director'), person('Lee')],
      engagements: [{ designer: person('Ada') }],
    },
  })
  render(
    <QueryClientProvider client={new QueryClient()}>
      <Everyone />
    </QueryClientProvider>,
  )
  expect((await screen.findByText('approver')).closest('p')).toHaveTextContent('DIDirectorapprover')
  expect(screen.getByText('designer').closest('p')).toHaveTextContent('ADAdadesigner')
  expect(screen.getByText('liaison').closest('p')).toHaveTextContent('LELeeliaison')
  expect(screen.getByText('Guest').closest('p')).toHaveTextContent(/^GUGuest$/)
})
