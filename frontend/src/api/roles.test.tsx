import { QueryClient, QueryClientProvider } from '@tanstack/react-query'
import { render, screen } from '@testing-library/react'
import { expect, test } from 'vitest'

import { serve } from '@/test/server'

import { useRoles } from './roles'

const person = (id: string) => ({ id, name: id })

function Everyone() {
  const roleOf = useRoles('p1')
  return ['Designer', 'Liaison', 'Director', 'Composer', 'Guest'].map((id) => (
    <p key={id}>{`${id}: ${roleOf(id) || 'none'}`}</p>
  ))
}

test('beside a name stands what the person is in the project', async () => {
  serve({
    'GET /v1/projects/p1': {
      id: 'p1',
      approver: person('Director'),
      category_approvers: [{ category: 'ui', approver: person('Composer') }],
      liaisons: [person('Director'), person('Liaison')],
      engagements: [{ designer: person('Designer') }],
    },
  })
  render(
    <QueryClientProvider client={new QueryClient()}>
      <Everyone />
    </QueryClientProvider>,
  )
  expect(await screen.findByText('Director: approver')).toBeVisible()
  expect(screen.getByText('Composer: approver')).toBeVisible()
  expect(screen.getByText('Designer: designer')).toBeVisible()
  expect(screen.getByText('Liaison: liaison')).toBeVisible()
  expect(screen.getByText('Guest: none')).toBeVisible()
})
