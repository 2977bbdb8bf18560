import { screen } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { describe, expect, test } from 'vitest'

import { CONTRACT, contractAnswers, MAY, ME, PAGE, PROJECT } from '@/test/contract'
import { openApp } from '@/test/openApp'
import { serve } from '@/test/server'

describe('before the NDA is agreed', () => {
  const closed = { ...ME, projects: [{ ...PROJECT, nda_open: true }] }
  const nda = { ...CONTRACT, kind: 'nda', title: 'NDA' }
  const found = (contracts: object[]) =>
    serve(contractAnswers({ 'GET /v1/me': closed, 'GET /v1/projects/p1/contracts': contracts }))

  test.each(['', '/desk', '/sound-list', '/spec', '/money', '/game-files'])(
    'a designer reads it in the place of projects/p1%s',
    async (page) => {
      const { asked } = found([nda])
      openApp(`/projects/p1${page}`)
      expect(
        await screen.findByRole('heading', { name: 'Read and sign the NDA to see this project', level: 1 }),
      ).toBeVisible()
      expect(screen.queryByRole('alert')).toBeNull()
      const ofProject = asked.map(({ path }) => path).filter((path) => path.startsWith('/v1/projects/'))
      expect(new Set(ofProject)).toEqual(new Set(['/v1/projects/p1/contracts', '/v1/projects/p1/next-steps']))
    },
  )

  test('the button opens its text, and accepting it opens the project', async () => {
    const { answers } = found([nda])
    answers['GET /v1/contracts/c1'] = nda
    answers['POST /v1/contracts/c1/accept'] = { ...nda, state: 'agreed', waits_for: [], may: MAY }
    const app = openApp('/projects/p1/desk')
    const read = await screen.findByRole('button', { name: 'Read the NDA' })
    const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
    expect(violations.map(({ id, nodes }) => [id, nodes[0]?.html])).toEqual([])
    await userEvent.click(read)
    expect(await screen.findByText('It includes 2 rounds.')).toBeVisible()
    expect(app.at()).toBe(PAGE)
    answers['GET /v1/me'] = ME
    await userEvent.type(screen.getByLabelText('Your full name'), 'N. Designer{Enter}')
    await screen.findByText('Agreed')
    await userEvent.click(screen.getByRole('link', { name: 'Sounds' }))
    expect(app.at()).toBe('/projects/p1/sound-list')
    expect(screen.queryByRole('heading', { name: 'Read and sign the NDA to see this project' })).toBeNull()
  })

  test('who accepted it reads that the studio is next', async () => {
    found([{ ...nda, waits_for: ['studio'] }])
    openApp('/projects/p1/desk')
    expect(await screen.findByRole('heading', { name: 'Waiting for the studio to sign the NDA' })).toBeVisible()
  })

  test('where none was sent there is nothing to do but wait', async () => {
    found([])
    openApp('/projects/p1/desk')
    expect(await screen.findByRole('heading', { name: 'Waiting for the studio’s NDA' })).toBeVisible()
    expect(screen.getByRole('button', { name: 'Go to contracts' })).toBeVisible()
  })
})
