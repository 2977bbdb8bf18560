import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { describe, expect, test } from 'vitest'

import { block, CONTRACT, contractAnswers, MAY, PAGE, PROJECT, VERSION } from '@/test/contract'
import { openApp } from '@/test/openApp'
import { answer, serve } from '@/test/server'

describe('a producer', () => {
  test('names who signs a draft, in which order', async () => {
    const producer = (id: string, name: string) => ({ person: { id, name }, roles: ['producer'] })
    const reviewer = { person: { id: 'x4', name: 'Composer' }, roles: ['reviewer'] }
    const draft = { ...CONTRACT, state: 'draft', my_party: 'studio', may: { ...MAY, change: true, send: true } }
    const first = { ...draft, signers: [{ id: 'x1', name: 'Producer' }] }
    const { asked, answers } = serve(
      contractAnswers({
        'GET /v1/contracts/c1': draft,
        'GET /v1/projects/p1': { ...PROJECT, studio: { id: 's1', name: 'Shield Wing studio' } },
        'GET /v1/studios/s1/people': [producer('x1', 'Producer'), producer('x2', 'Executive producer'), reviewer],
        'PUT /v1/contracts/c1/signers': first,
      }),
    )
    openApp(PAGE)
    await userEvent.click(await screen.findByRole('combobox', { name: 'First signer of the studio' }))
    expect((await screen.findAllByRole('option')).map(({ textContent }) => textContent)).toEqual([
      'Producer',
      'Executive producer',
    ])
    await userEvent.click(screen.getByRole('option', { name: 'Producer' }))
    await userEvent.click(await screen.findByRole('combobox', { name: 'Second signer of the studio' }))
    answers['PUT /v1/contracts/c1/signers'] = { ...first, signs_first: 'studio' }
    await userEvent.click(await screen.findByRole('option', { name: 'Executive producer' }))
    const bodies = () => asked.filter(({ path }) => path.endsWith('/signers')).map(({ body }) => body)
    await waitFor(() =>
      expect(bodies()).toEqual([
        { person_ids: ['x1'], first: null },
        { person_ids: ['x1', 'x2'], first: null },
      ]),
    )
  })

  const draft = {
    ...CONTRACT,
    state: 'draft',
    my_party: 'studio',
    waits_for: ['studio'],
    may: { ...MAY, change: true },
  }
  const shown = { blocks: [block('text', 'It includes 3 rounds.')], clauses: [], problems: [] }

  test('begins like the last contract, unless another choice is made', async () => {
    const project = {
      id: 'p1',
      studio: { id: 's1', name: 'Shield Wing studio' },
      mine: { is_producer: true, is_team: true },
      nda_needed: false,
      engagements: [{ id: 'e1', kind: 'contract', ended_at: null, designer: { id: 'x3', name: 'Sound designer' } }],
    }
    const last = {
      id: 'c0',
      title: 'Palette',
      designer: { id: 'x3', name: 'Sound designer' },
      currency: 'EUR',
      created_at: '2026-10-01T10:00:00Z',
    }
    const { asked } = serve(
      contractAnswers({
        'GET /v1/projects/p1': project,
        'GET /v1/projects/p1/contracts': [],
        'GET /v1/studios/s1/contract-templates': [],
        'GET /v1/projects/p1/last-contract': { contract: last },
        'POST /v1/projects/p1/contracts': draft,
        'GET /v1/contracts/c1': draft,
      }),
    )
    openApp('/projects/p1/contracts')
    const form = within(await screen.findByRole('form', { name: 'New contract' }))
    expect(await form.findByDisplayValue('Same as last contract: Palette')).toBeVisible()
    expect(form.getByText(/its clauses, fees and terms/)).toBeVisible()
    expect(form.getByLabelText('Currency')).toHaveValue('EUR')
    await userEvent.click(form.getByRole('button', { name: 'Create draft' }))
    await waitFor(() =>
      expect(asked.find(({ method, path }) => method === 'POST' && path === '/v1/projects/p1/contracts')?.body).toEqual(
        expect.objectContaining({ same_as_id: 'c0', currency: 'EUR', template_id: null }),
      ),
    )
  })

  test('begins in the currency of the project’s newest contract where the designer has none', async () => {
    const designer = { id: 'x3', name: 'Sound designer' }
    const project = {
      ...{ id: 'p1', studio: { id: 's1', name: 'Shield Wing studio' }, nda_needed: false },
      mine: { is_producer: true, is_team: true },
      engagements: [{ id: 'e1', kind: 'contract', ended_at: null, designer }],
    }
    const earlier = { ...CONTRACT, designer: { id: 'x9', name: 'Another designer' } }
    serve(
      contractAnswers({
        'GET /v1/projects/p1': project,
        'GET /v1/projects/p1/contracts': [
          { ...earlier, id: 'c7', currency: 'GBP' },
          { ...earlier, id: 'c8', currency: 'EUR' },
        ],
        'GET /v1/studios/s1/contract-templates': [],
        'GET /v1/projects/p1/last-contract': { contract: null },
      }),
    )
    openApp('/projects/p1/contracts')
    const form = within(await screen.findByRole('form', { name: 'New contract' }))
    expect(form.getByLabelText('Currency')).toHaveValue('EUR')
  })

  test('deletes a template only when that is confirmed', async () => {
    const project = {
      ...{ id: 'p1', studio: { id: 's1', name: 'Shield Wing studio' }, nda_needed: false, engagements: [] },
      mine: { is_producer: true, is_team: true },
    }
    const { asked, answers } = serve(
      contractAnswers({
        'GET /v1/projects/p1': project,
        'GET /v1/projects/p1/contracts': [],
        'GET /v1/studios/s1/contract-templates': [{ id: 't1', name: 'Small jobs', kind: 'single' }],
        'GET /v1/projects/p1/last-contract': { contract: null },
        'DELETE /v1/studios/s1/contract-templates/t1': answer(null, 204),
      }),
    )
    const deletions = () => asked.filter(({ method }) => method === 'DELETE')
    openApp('/projects/p1/contracts')
    await userEvent.click(await screen.findByRole('button', { name: 'Delete Small jobs' }))
    expect(screen.getByText('It cannot be restored. Contracts made from it stay.')).toBeVisible()
    await userEvent.click(screen.getByRole('button', { name: 'Cancel' }))
    expect(deletions()).toEqual([])
    await userEvent.click(screen.getByRole('button', { name: 'Delete Small jobs' }))
    expect(screen.getByRole('button', { name: 'Cancel' })).toHaveFocus()
    answers['GET /v1/studios/s1/contract-templates'] = []
    await userEvent.click(screen.getByRole('button', { name: 'Delete “Small jobs”' }))
    expect(await screen.findByText('Template Small jobs deleted.')).toBeVisible()
    expect(deletions()).toHaveLength(1)
  })

  test('edits beside the text, and saves a version that names the one it came from', async () => {
    const { asked } = serve(
      contractAnswers({
        'GET /v1/contracts/c1': draft,
        'POST /v1/contracts/c1/preview': shown,
        'PUT /v1/contracts/c1/draft': { ...draft, version: { ...VERSION, number: 3 } },
        'GET /v1/contract-library/single': { kind: 'single', notice: '', clauses: [], variables: {} },
      }),
    )
    const app = openApp(`${PAGE}/draft?view=text`)
    expect(await screen.findByText('It includes 3 rounds.')).toBeVisible()
    expect(screen.getByRole('link', { name: 'Back to contract' })).toBeVisible()
    const save = screen.getByRole('button', { name: 'Save version' })
    expect(save).toBeDisabled()
    await userEvent.click(screen.getByRole('checkbox', { name: 'Bonus' }))
    expect(screen.getByRole('link', { name: 'Discard changes' })).toBeVisible()
    await userEvent.click(save)
    await screen.findByText('Saved as version 3.')
    expect(app.at()).toBe(`${PAGE}/draft`)
    expect(screen.getByRole('link', { name: 'Back to contract' })).toBeVisible()
    expect(screen.queryByRole('link', { name: 'Discard changes' })).not.toBeInTheDocument()
    const body = asked.find(({ method }) => method === 'PUT')?.body
    expect(body).toMatchObject({ based_on_version: 2, clauses: [{ stands: true }, { key: 'bonus', stands: true }] })
  })

  test('adds, moves, removes and takes back clauses, by keyboard alone', { tags: ['slow'] }, async () => {
    const library = {
      ...{ key: 'reel', title: 'Showing the work', text: 'From {reel_from} on.', stands: true },
      ...{ why: 'A reel is how designers find the next work.', music: false, instead_of: null },
      terms: [{ name: 'reel_from', default: 'release', label: 'From when', min: null, max: null, choices: [] }],
    }
    const { asked } = serve(
      contractAnswers({
        'GET /v1/contracts/c1': draft,
        'POST /v1/contracts/c1/preview': shown,
        'PUT /v1/contracts/c1/draft': { ...draft, version: { ...VERSION, number: 3 } },
        'GET /v1/contract-library/single': { kind: 'single', notice: '', clauses: [library], variables: {} },
      }),
    )
    openApp(`${PAGE}/draft?view=text`)
    // A text field that grows asks when fonts are there, which jsdom does not know.
    Object.defineProperty(document, 'fonts', { value: new EventTarget(), configurable: true })
    const press = async (name: string) => {
      screen.getByRole('button', { name }).focus()
      await userEvent.keyboard('{Enter}')
    }
    await screen.findByRole('button', { name: 'Add from the library' })
    await press('Add from the library')
    expect(screen.getByLabelText('From when')).toHaveValue('release')
    expect(screen.queryByRole('button', { name: 'Add from the library' })).not.toBeInTheDocument()
    await userEvent.type(screen.getByLabelText('Title of the custom clause'), 'Tea{Enter}')
    await userEvent.type(screen.getByLabelText('Text'), 'At four.')
    await press('Move Tea up')
    expect(screen.getByText('Tea is clause 3 of 4.')).toBeInTheDocument()
    await waitFor(() => expect(screen.getByRole('button', { name: 'Move Tea up' })).toHaveFocus())
    await press('Move Rounds down')
    await press('Remove Bonus')
    await press('Remove Rounds')
    await userEvent.click(screen.getByRole('button', { name: /^Undo/ }))
    await userEvent.click(screen.getByRole('button', { name: 'Save version' }))
    await screen.findByText('Saved as version 3.')
    expect(asked.find(({ method }) => method === 'PUT')?.body).toMatchObject({
      clauses: [{ key: 'rounds' }, { key: 'own_tea', title: 'Tea', text: 'At four.' }, { key: 'reel', stands: true }],
      terms: { reel_from: 'release', rounds_included: 2 },
    })
  })

  test('cannot save what has a fault, and sees which', async () => {
    const problems = [{ where: 'clauses.rounds', message: 'there is no variable {round}; is it {rounds_included}?' }]
    serve(contractAnswers({ 'GET /v1/contracts/c1': draft, 'POST /v1/contracts/c1/preview': { ...shown, problems } }))
    openApp(`${PAGE}/draft?view=text`)
    expect(await screen.findByText('There is no variable {round}; is it {rounds_included}?')).toBeVisible()
    await userEvent.click(screen.getByRole('checkbox', { name: 'Bonus' }))
    expect(screen.getByRole('button', { name: 'Save version' })).toBeDisabled()
  })

  test('sees two versions word by word', async () => {
    const runs = [
      { is_in: 'both', text: 'It includes ' },
      { is_in: 'earlier', text: '2' },
      { is_in: 'later', text: '1' },
    ]
    const lines = [{ kind: 'text', change: 'changed', runs }]
    serve(contractAnswers({ 'GET /v1/contracts/c1/comparison': { from_version: 1, to_version: 2, lines } }))
    openApp(`${PAGE}/compare`)
    expect(await screen.findByText('1 paragraph of Effects for Alpha differs between version 1 and 2.')).toBeVisible()
    expect(screen.getByText('2', { selector: 'del' })).toBeVisible()
    expect(screen.getByText('1', { selector: 'ins' })).toBeVisible()
  })
})
