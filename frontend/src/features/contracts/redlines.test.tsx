import { fireEvent, cleanup, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeEach, describe, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { CONTRACT, given, MAY, page, PAGE, redlineAnswers, round, UNMARKED, VERSION } from '@/test/redlines'
import { refusal, serve, wrote } from '@/test/server'

const axeFinds = async () => {
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  return violations.map(({ id, nodes }) => [id, nodes[0]?.html])
}

beforeEach(() => {
  localStorage.clear()
  // A text field that grows asks when fonts are there, which jsdom does not know.
  Object.defineProperty(document, 'fonts', { value: new EventTarget(), configurable: true })
})

describe('the designer of a contract that was sent', () => {
  test('edits, strikes and adds clauses, and sends them together', { tags: ['slow'] }, async () => {
    const { asked, answers } = serve(redlineAnswers())
    answers['POST /v1/contracts/c1/redlines'] = () => {
      answers['GET /v1/contracts/c1/redlines'] = page(round())
      answers['GET /v1/contracts/c1'] = { ...CONTRACT, state: 'draft', may: MAY }
      return page(round())
    }
    openApp(PAGE)
    await userEvent.click(await screen.findByRole('button', { name: 'Edit Rounds' }))
    const text = screen.getByLabelText('Text')
    expect(text).toHaveFocus()
    await userEvent.clear(text)
    await userEvent.paste('Each of the {rounds_included} rounds is free.')
    const value = screen.getByLabelText('Rounds of changes')
    await userEvent.clear(value)
    await userEvent.type(value, '4')
    fireEvent.change(screen.getByLabelText('Comment (optional)'), { target: { value: 'As agreed on the phone.' } })
    await userEvent.click(screen.getByRole('button', { name: 'Strike Parties' }))
    await waitFor(() => expect(screen.getByRole('button', { name: 'Undo the change of Parties' })).toHaveFocus())
    await userEvent.click(screen.getByRole('button', { name: 'Add a clause after Rounds' }))
    const added = within(screen.getByRole('region', { name: 'New clause after Rounds' }))
    await userEvent.type(added.getByLabelText('Clause title'), 'Tea')
    await userEvent.type(added.getByLabelText('Text'), 'At four.')
    await userEvent.type(screen.getByLabelText('Note to the studio (optional)'), 'See you.')
    expect(await axeFinds()).toEqual([])
    await userEvent.click(screen.getByRole('button', { name: 'Send 3 changes to Shield Wing studio' }))
    expect(await screen.findByText('3 changes sent to Shield Wing studio.')).toBeVisible()
    expect(wrote(asked, 'POST /v1/contracts/c1/redlines')[0]?.body).toEqual({
      version: 2,
      note: 'See you.',
      changes: [
        {
          kind: 'replace',
          clause_key: 'rounds',
          after_key: null,
          title: 'Rounds',
          text: 'Each of the {rounds_included} rounds is free.',
          terms: { rounds_included: 4 },
          comment: 'As agreed on the phone.',
        },
        { kind: 'strike', clause_key: 'parties', after_key: null, title: '', text: '', terms: {}, comment: '' },
        {
          kind: 'insert',
          clause_key: null,
          after_key: 'rounds',
          title: 'Tea',
          text: 'At four.',
          terms: {},
          comment: '',
        },
      ],
    })
    expect(await screen.findAllByText('Waiting for the studio’s answer')).toHaveLength(2)
    expect(screen.queryByRole('button', { name: /Accept change/ })).not.toBeInTheDocument()
  })

  test('waits for the text before anything below it can be pressed', async () => {
    let arrive: (preview: unknown) => void = () => undefined
    const preview = new Promise((resolve) => (arrive = resolve))
    serve({ ...redlineAnswers(), 'POST /v1/contracts/c1/redline-preview': () => preview })
    openApp(PAGE)
    expect(await screen.findByRole('heading', { name: 'Propose changes' })).toBeVisible()
    expect(screen.queryByRole('button', { name: 'Send changes' })).toBeNull()
    arrive({ clauses: UNMARKED, problems: [] })
    expect(await screen.findByRole('button', { name: 'Send changes' })).toBeVisible()
  })

  test('finds what was typed after a reload, and says which change has a fault', { tags: ['slow'] }, async () => {
    const { answers } = serve(redlineAnswers())
    openApp(PAGE)
    await userEvent.click(await screen.findByRole('button', { name: 'Edit Rounds' }))
    await userEvent.type(screen.getByLabelText('Text'), ' More.')
    cleanup()
    const message = 'there is no variable {round}; is it {rounds_included}?'
    answers['POST /v1/contracts/c1/redline-preview'] = {
      clauses: UNMARKED,
      problems: [{ where: 'changes.0', message }],
    }
    openApp(PAGE)
    expect(await screen.findByLabelText('Text')).toHaveValue('It includes {rounds_included} rounds. More.')
    expect(screen.getByLabelText('Text')).not.toHaveFocus()
    expect(await screen.findByText('There is no variable {round}; is it {rounds_included}?')).toBeVisible()
    expect(screen.getByRole('button', { name: /^Send 1 change/ })).toBeDisabled()
  })

  test('uploads a Word document, looks at what it changes, and sends it', { tags: ['slow'] }, async () => {
    const { asked, answers } = serve(redlineAnswers())
    const change = (kind: string, key: string | null, text: string) => ({
      kind,
      clause_key: key,
      after_key: null,
      title: kind === 'insert' ? 'Tea' : 'Rounds',
      text,
      terms: {},
      comment: 'A. Lawyer: Two are few.',
    })
    answers['POST /v1/contracts/c1/redlines/word'] = {
      version: 2,
      changes: [change('replace', 'rounds', 'Four rounds.'), change('insert', null, 'At four.')],
      note: 'On Parties: A. Lawyer: Who?',
      findings: [{ clause_key: null, message: 'A footnote is not read: “See 2.”', fix: 'Write it into a clause.' }],
    }
    answers['POST /v1/contracts/c1/redlines'] = page(round())
    openApp(PAGE)
    const file = new File(['PK'], 'Marked up.docx')
    await userEvent.upload(await screen.findByLabelText('Word document', { selector: 'input' }), file)
    expect(await screen.findByText('2 changes added below.', { exact: false })).toBeVisible()
    expect(wrote(asked, 'POST /v1/contracts/c1/redlines/word')[0]?.body).toEqual({ content_base64: btoa('PK') })
    expect(screen.getByText('A footnote is not read: “See 2.”', { exact: false })).toBeVisible()
    expect(screen.getByRole('region', { name: 'New clause: Tea' })).toBeVisible()
    expect(screen.getByLabelText('Note to the studio (optional)')).toHaveValue('On Parties: A. Lawyer: Who?')
    expect(wrote(asked, 'POST /v1/contracts/c1/redlines')).toEqual([])
    expect(await axeFinds()).toEqual([])
    await userEvent.click(screen.getByRole('button', { name: /^Send 2 changes/ }))
    await waitFor(() => expect(wrote(asked, 'POST /v1/contracts/c1/redlines')).toHaveLength(1))
  })

  test('keeps what is typed over what a Word document has, and reads why a file is refused', async () => {
    const { answers } = serve(redlineAnswers())
    const rounds = {
      ...{ kind: 'replace', clause_key: 'rounds', after_key: null, title: 'Rounds' },
      ...{ text: 'Four.', terms: {}, comment: '' },
    }
    answers['POST /v1/contracts/c1/redlines/word'] = { version: 2, changes: [rounds], note: '', findings: [] }
    openApp(PAGE)
    await userEvent.click(await screen.findByRole('button', { name: 'Edit Rounds' }))
    await userEvent.type(screen.getByLabelText('Text'), ' Mine.')
    const input = screen.getByLabelText('Word document', { selector: 'input' })
    await userEvent.upload(input, new File(['PK'], 'a.docx'))
    expect(await screen.findByText(/You have changed “Rounds” here already/)).toBeVisible()
    expect(screen.getByLabelText('Text')).toHaveValue('It includes {rounds_included} rounds. Mine.')
    answers['POST /v1/contracts/c1/redlines/word'] = refusal(
      422,
      'bad-word-file',
      'this is a PDF; wanted a Word document',
    )
    await userEvent.upload(input, new File(['%PDF'], 'b.docx'))
    expect(await screen.findByText('This is a PDF; wanted a Word document.')).toBeVisible()
    await userEvent.click(screen.getByRole('button', { name: 'Close this report' }))
    expect(screen.queryByText(/here already/)).not.toBeInTheDocument()
  })

  test('sees what happened to each change, and can propose again', async () => {
    const countered = given('countered', {
      wording: { title: 'Rounds', text: 'Three.', terms: {} },
      comment: 'Half way.',
    })
    const closed = round([countered, given('refused', { comment: 'No tea.' })], { sent_version: 3 })
    serve(redlineAnswers({ 'GET /v1/contracts/c1/redlines': page(closed) }))
    openApp(PAGE)
    expect(await screen.findByText('Version 3 was sent')).toBeVisible()
    const first = within(screen.getByRole('article', { name: 'Change 1' }))
    expect(first.getByText('Countered')).toBeVisible()
    expect(first.getByText('Half way.')).toBeVisible()
    expect(within(screen.getByRole('article', { name: 'Change 2' })).getByText('No tea.')).toBeVisible()
    expect(await screen.findByRole('heading', { name: 'Propose changes' })).toBeVisible()
  })
})

describe('a producer', () => {
  const draft = { ...CONTRACT, state: 'draft', my_party: 'studio', waits_for: ['studio'] }
  const contract = { ...draft, may: { ...MAY, change: true, send: true } }

  const opened = (of: object = round()) => {
    const served = serve(
      redlineAnswers({ 'GET /v1/contracts/c1': contract, 'GET /v1/contracts/c1/redlines': page(of, true) }),
    )
    const answerWith = (number: number, next: object) => {
      served.answers[`POST /v1/contracts/c1/redlines/${number}/answer`] = () => {
        served.answers['GET /v1/contracts/c1/redlines'] = page(next, true)
        return page(next, true)
      }
    }
    return { ...served, answerWith }
  }
  const bodies = (asked: Parameters<typeof wrote>[0], number: number) =>
    wrote(asked, `POST /v1/contracts/c1/redlines/${number}/answer`).map(({ body }) => body)

  test('reads one text with marks, by whom and when', async () => {
    opened()
    openApp(PAGE)
    expect(await screen.findByText('2', { selector: 'del' })).toBeVisible()
    expect(screen.getByText('four', { selector: 'ins' })).toBeVisible()
    expect(screen.getByText('Between us.')).toBeVisible()
    expect(screen.getByText('Two are few.')).toBeVisible()
    expect(screen.getByText(/^2 changes to version 2 by Sound designer, Saturday 21 November/)).toBeVisible()
    expect(await axeFinds()).toEqual([])
    await userEvent.click(screen.getByRole('button', { name: 'Changes only' }))
    expect(screen.queryByText('Between us.')).not.toBeInTheDocument()
  })

  test('a figure that a change sets is said before and after, and y answers the first open change', async () => {
    const { asked, answers, answerWith } = opened()
    const proposed = round()
    const clauses = proposed.clauses.map((clause) =>
      clause?.key === 'rounds'
        ? { ...clause, redline: { ...clause.redline, wording: { title: '', text: '', terms: { rounds_included: 4 } } } }
        : clause,
    )
    answers['GET /v1/contracts/c1/redlines'] = page({ ...proposed, clauses }, true)
    answerWith(1, round([given('accepted'), null]))
    openApp(PAGE)
    const first = within(await screen.findByRole('article', { name: 'Change 1' }))
    expect((await first.findByText('Rounds of changes')).nextSibling).toHaveTextContent('2 → 4')
    await userEvent.keyboard('y')
    await waitFor(() => expect(bodies(asked, 1)).toHaveLength(1))
  })

  test('answers by keys alone: next, accept, counter', async () => {
    const { asked, answerWith } = opened()
    const half = round([given('accepted'), null])
    answerWith(1, half)
    answerWith(2, round([given('accepted'), given('countered')]))
    openApp(PAGE)
    await screen.findByRole('article', { name: 'Change 1' })
    await userEvent.keyboard('n')
    expect(screen.getByRole('article', { name: 'Change 1' })).toHaveFocus()
    await userEvent.keyboard('np')
    expect(screen.getByRole('article', { name: 'Change 1' })).toHaveFocus()
    await userEvent.keyboard('y')
    await waitFor(() => expect(screen.getByRole('article', { name: 'Change 2' })).toHaveFocus())
    expect(screen.getByText('1 change without an answer.')).toBeVisible()
    await userEvent.keyboard('e')
    const form = within(await screen.findByRole('form', { name: 'Counter change 2' }))
    await userEvent.clear(form.getByLabelText('Text'))
    fireEvent.change(form.getByLabelText('Text'), { target: { value: 'At five, not four.' } })
    await userEvent.type(form.getByLabelText('Comment (optional)'), 'Later.')
    await userEvent.click(form.getByRole('button', { name: 'Send the counter' }))
    expect(await screen.findByText('Every change is answered.')).toBeVisible()
    expect(bodies(asked, 1)).toEqual([{ answer: 'accepted', title: '', text: '', terms: {}, comment: '' }])
    expect(bodies(asked, 2)).toEqual([
      { answer: 'countered', title: 'Tea', text: 'At five, not four.', terms: {}, comment: 'Later.' },
    ])
    expect(screen.getByRole('button', { name: 'Send to Sound designer' })).toBeVisible()
  })

  test('says why a change is refused, and keeps that over a reload', async () => {
    const { asked, answers, answerWith } = opened()
    openApp(PAGE)
    await screen.findByRole('article', { name: 'Change 1' })
    await userEvent.keyboard('ns')
    const field = await screen.findByLabelText('Why it is refused')
    expect(field).toHaveFocus()
    fireEvent.change(field, { target: { value: 'Two are enough, and a car.' } })
    answers['POST /v1/contracts/c1/redlines/1/answer'] = refusal(409, 'wrong-state', 'it was sent meanwhile')
    await userEvent.click(screen.getByRole('button', { name: 'Refuse the change' }))
    expect(await screen.findByText('It was sent meanwhile.')).toBeVisible()
    cleanup()
    answerWith(1, round([given('refused'), null]))
    openApp(PAGE)
    await userEvent.click(await screen.findByRole('button', { name: 'Keep as it was, change 1' }))
    expect(screen.getByLabelText('Why it is refused')).toHaveValue('Two are enough, and a car.')
    await userEvent.click(screen.getByRole('button', { name: 'Refuse the change' }))
    await waitFor(() => expect(screen.queryByLabelText('Why it is refused')).not.toBeInTheDocument())
    expect(bodies(asked, 1).at(-1)).toMatchObject({ answer: 'refused', comment: 'Two are enough, and a car.' })
  })

  test('is led from the contract to what is not answered, and cannot send before', async () => {
    const redlines = {
      rounds: 1,
      count: 3,
      unanswered: 2,
      is_open: true,
      by: 'Sound designer',
      at: '2026-11-21T10:00:00Z',
    }
    serve(
      redlineAnswers({ 'GET /v1/contracts/c1': { ...contract, redlines }, 'GET /v1/contracts/c1/versions': [VERSION] }),
    )
    const app = openApp('/projects/p1/contracts/c1')
    expect(await screen.findByText(/^Sound designer proposed 3 changes.* 2 without an answer\.$/)).toBeVisible()
    expect(screen.queryByRole('button', { name: 'Send to Sound designer' })).not.toBeInTheDocument()
    await userEvent.click(screen.getByRole('link', { name: 'Answer 2 changes' }))
    await waitFor(() => expect(app.at()).toBe(PAGE))
  })
})

describe('time to signature', () => {
  test('is said once both have signed', async () => {
    const agreed = { ...CONTRACT, state: 'agreed', agreed_at: '2026-11-26T11:00:00Z', waits_for: [], may: MAY }
    serve(redlineAnswers({ 'GET /v1/contracts/c1': agreed, 'GET /v1/contracts/c1/versions': [VERSION] }))
    openApp('/projects/p1/contracts/c1')
    expect(await screen.findByText(/^First sent Friday 20 November.*\. Time to signature: 6 days\.$/)).toBeVisible()
  })

  test('names before for whom it waits, and since when', async () => {
    serve(
      redlineAnswers({
        'GET /v1/contracts/c1': { ...CONTRACT, waits_for: ['studio'] },
        'GET /v1/contracts/c1/versions': [VERSION],
      }),
    )
    openApp('/projects/p1/contracts/c1')
    expect(await screen.findByText(/Waiting for the studio since Friday 20 November/)).toBeVisible()
  })
})
