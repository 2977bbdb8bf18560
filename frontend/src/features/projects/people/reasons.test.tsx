import { cleanup, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeEach, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { inProject } from '@/test/project'
import { OURS } from '@/test/review'
import { type Asked, refusal, serve, wrote } from '@/test/server'

beforeEach(() => localStorage.clear())

const PUT = 'PUT /v1/studios/s1/review-reasons'
const OWN = { ...OURS, pick: { is_own: true, reasons: ['Feels right'] } }
const card = async () => within(await screen.findByRole('region', { name: /Reasons and labels/ }))

function served(lists: typeof OURS, answers: object = {}) {
  return serve({
    ...inProject(),
    'GET /v1/projects/p1/categories': [],
    'GET /v1/projects/p1/approval-settings': { blockers: 'none', checklists: [] },
    'GET /v1/projects/p1/review-reasons': lists,
    ...answers,
  })
}

test('a producer writes a list of the studio, one a line, and takes ours again', async () => {
  const { asked, answers } = served(OURS)
  answers[PUT] = ({ body }: Asked) => {
    const { pick } = body as { pick: string[] }
    const lists = pick.length === 0 ? OURS : { ...OURS, pick: { is_own: true, reasons: pick } }
    answers['GET /v1/projects/p1/review-reasons'] = lists
    return lists
  }
  openApp('/projects/p1/approval')
  await userEvent.click(await (await card()).findByRole('button', { name: 'Approvals' }))
  const field = (await card()).getByLabelText('Why a version is approved')
  expect(field).toHaveValue(OURS.pick.reasons.join('\n'))
  await userEvent.clear(field)
  await userEvent.type(field, ' Feels right \n\nRight size')
  await userEvent.click((await card()).getByRole('button', { name: 'Save list' }))
  expect(await screen.findByText('Why a version is approved: the list is saved.')).toBeVisible()
  await userEvent.click(await (await card()).findByRole('button', { name: 'Reset to defaults' }))
  await waitFor(async () =>
    expect((await card()).getByLabelText('Why a version is approved')).toHaveValue(OURS.pick.reasons.join('\n')),
  )
  expect(wrote(asked, PUT).map(({ body }) => body)).toEqual([{ pick: ['Feels right', 'Right size'] }, { pick: [] }])
})

test('what was typed stays when it is refused, and after a reload', async () => {
  served(OWN, { [PUT]: () => refusal(422, 'reasons-invalid', '“dry” is in the list twice.') })
  openApp('/projects/p1/approval')
  await userEvent.click(await (await card()).findByRole('button', { name: 'Labels' }))
  await userEvent.type((await card()).getByLabelText('What an alternate is'), '\nDry')
  await userEvent.click((await card()).getByRole('button', { name: 'Save list' }))
  expect(await screen.findByText('“dry” is in the list twice.')).toBeVisible()
  cleanup()
  openApp('/projects/p1/approval')
  await userEvent.click(await (await card()).findByRole('button', { name: 'Labels' }))
  expect((await card()).getByLabelText('What an alternate is')).toHaveValue([...OURS.label.reasons, 'Dry'].join('\n'))
})

test('who is not a producer reads them', async () => {
  serve({
    ...inProject('reviewer'),
    'GET /v1/projects/p1/categories': [],
    'GET /v1/projects/p1/approval-settings': { blockers: 'none', checklists: [] },
    'GET /v1/projects/p1/review-reasons': OWN,
  })
  openApp('/projects/p1/approval')
  await userEvent.click(await (await card()).findByRole('button', { name: 'Approvals' }))
  expect((await card()).getByRole('listitem')).toHaveTextContent('1 Feels right')
  expect((await card()).queryByRole('button', { name: 'Save list' })).toBeNull()
})
