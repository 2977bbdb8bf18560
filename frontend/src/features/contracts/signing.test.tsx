import { act, fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { describe, expect, test, vi } from 'vitest'

import { keepDraft } from '@/app/drafts'
import { accepted, CONTRACT, contractAnswers, MAY, PAGE } from '@/test/contract'
import { openApp } from '@/test/openApp'
import { refusal, serve } from '@/test/server'

const ENTRY = {
  seq: 1,
  at: '2026-11-20T10:00:00.000000+00:00',
  kind: 'sent',
  payload: { by: 'Producer', version: 2 },
  previous_sha256: '0'.repeat(64),
  sha256: 'c'.repeat(64),
}

describe('a designer', () => {
  test('reads the text and accepts the version that was read, under a name', async () => {
    const { asked, answers } = serve(contractAnswers())
    const agreed = { ...CONTRACT, waits_for: ['studio'], may: MAY }
    answers['POST /v1/contracts/c1/accept'] = { ...agreed, acceptances: [accepted('designer', 'N. Designer')] }
    openApp(PAGE)
    expect(await screen.findByText('It includes 2 rounds.')).toBeVisible()
    expect(screen.getByText(/^SHA-256 a+$/)).toBeVisible()
    const form = within(screen.getByRole('form', { name: 'Accept' }))
    expect(form.getByRole('button', { name: 'Sign version 2' })).toBeDisabled()
    await userEvent.type(form.getByLabelText('Your full name'), 'N. Designer')
    await userEvent.click(form.getByRole('button', { name: 'Sign version 2' }))
    expect(await screen.findByText('for the designer, n@sound.example, email not verified')).toBeVisible()
    const sent = asked.find(({ path }) => path.endsWith('/accept'))
    expect(sent?.body).toEqual({ name: 'N. Designer', text_sha256: 'a'.repeat(64) })
    expect(screen.getByText('Waiting for the studio to sign')).toBeVisible()
  })

  test('draws a name, undoes a stroke, and sends what is left with the typed name', async () => {
    const { asked, answers } = serve(contractAnswers())
    const drawing = [[[100, 30]]]
    const signed = { ...accepted('designer', 'N. Designer'), drawing }
    answers['POST /v1/contracts/c1/accept'] = { ...CONTRACT, waits_for: ['studio'], may: MAY, acceptances: [signed] }
    openApp(PAGE)
    const form = within(await screen.findByRole('form', { name: 'Accept' }))
    const field = form.getByRole('img', { name: /^Draw your name/ })
    field.getBoundingClientRect = () => new DOMRect(0, 0, 500, 150)
    field.setPointerCapture = vi.fn()
    field.hasPointerCapture = () => true
    fireEvent.pointerDown(field, { clientX: 50, clientY: 15, button: 0 })
    fireEvent.pointerDown(field, { clientX: 100, clientY: 15, button: 0 })
    fireEvent.pointerMove(field, { clientX: 300, clientY: 900 })
    expect(field.querySelector('path')).toHaveAttribute('d', 'M 100 30 L 100 30 M 200 30 L 600 300')
    await userEvent.click(form.getByRole('button', { name: 'Undo stroke' }))
    await userEvent.type(form.getByLabelText('Your full name'), 'N. Designer')
    await userEvent.click(form.getByRole('button', { name: 'Sign version 2' }))
    expect(await screen.findByRole('img', { name: 'N. Designer, drawn by hand' })).toBeVisible()
    expect(asked.find(({ path }) => path.endsWith('/accept'))?.body).toEqual({
      name: 'N. Designer',
      text_sha256: 'a'.repeat(64),
      drawing,
    })
  })

  test('a drawing that is refused stays to be drawn again', async () => {
    const refused = refusal(422, 'bad-drawing', 'the drawing is too small to be a name', { fix: 'clear it' })
    serve(contractAnswers({ 'POST /v1/contracts/c1/accept': refused }))
    openApp(PAGE)
    const form = within(await screen.findByRole('form', { name: 'Accept' }))
    const field = form.getByRole('img', { name: /^Draw your name/ })
    field.getBoundingClientRect = () => new DOMRect(0, 0, 1000, 300)
    field.setPointerCapture = vi.fn()
    fireEvent.pointerDown(field, { clientX: 50, clientY: 15, button: 0 })
    await userEvent.type(form.getByLabelText('Your full name'), 'N. Designer{Enter}')
    expect(await form.findByText('The drawing is too small to be a name.')).toBeVisible()
    expect(field.querySelector('path')).toHaveAttribute('d', 'M 50 15 L 50 15')
    await userEvent.click(form.getByRole('button', { name: 'Clear drawing' }))
    expect(field.querySelector('path')).toHaveAttribute('d', '')
    expect(form.getByLabelText('Your full name')).toHaveValue('N. Designer')
  })

  test('signs with the code that is mailed, and has another one mailed', async () => {
    const needed = refusal(403, 'signing-code-needed', 'a code is mailed to you; nothing was signed')
    const mailed = { email: 'n@sound.example', expires_at: '2026-11-20T10:10:00Z', tries: 5 }
    const { asked, answers } = serve(
      contractAnswers({ 'POST /v1/contracts/c1/accept': needed, 'POST /v1/contracts/c1/signing-codes': mailed }),
    )
    openApp(PAGE)
    await userEvent.type(await screen.findByLabelText('Your full name'), 'N. Designer{Enter}')
    const code = await screen.findByLabelText('Code')
    await waitFor(() => expect(code).toHaveFocus())
    expect(code).toHaveAccessibleDescription(/^Mailed to n@sound.example/)
    expect(screen.queryByText(/nothing was signed/)).not.toBeInTheDocument()
    answers['POST /v1/contracts/c1/accept'] = refusal(403, 'wrong-signing-code', 'it can be tried 4 more times')
    await userEvent.type(code, '111111{Enter}')
    expect(await screen.findByText('It can be tried 4 more times.')).toBeVisible()
    await userEvent.click(screen.getByRole('button', { name: 'Resend code' }))
    await waitFor(() => expect(code).toHaveValue(''))
    const signed = { ...accepted('designer', 'N. Designer'), code_entered_at: '2026-11-20T10:05:00Z' }
    answers['POST /v1/contracts/c1/accept'] = { ...CONTRACT, waits_for: ['studio'], may: MAY, acceptances: [signed] }
    await userEvent.type(code, '482913{Enter}')
    expect(await screen.findByText('for the designer, n@sound.example, confirmed by a mailed code')).toBeVisible()
    expect(asked.filter(({ path }) => path.endsWith('/signing-codes')).map(({ body }) => body)).toEqual([
      { text_sha256: 'a'.repeat(64) },
      { text_sha256: 'a'.repeat(64) },
    ])
    expect(asked.filter(({ path }) => path.endsWith('/accept')).at(-1)?.body).toEqual({
      name: 'N. Designer',
      text_sha256: 'a'.repeat(64),
      code: '482913',
    })
  })

  test('sees who signs for the studio, and which side is first', async () => {
    serve(
      contractAnswers({
        'GET /v1/contracts/c1': { ...CONTRACT, signers: [{ id: 'x1', name: 'Producer' }], signs_first: 'studio' },
      }),
    )
    openApp(PAGE)
    expect(await screen.findByText('1. Producer, for the studio')).toBeVisible()
    expect(screen.getByText('The studio signs first.')).toBeVisible()
  })

  test('sees that the text moved on meanwhile, and keeps the name typed', async () => {
    const detail = 'the text that you read is not the current one; nothing was accepted'
    serve(contractAnswers({ 'POST /v1/contracts/c1/accept': refusal(409, 'text-changed', detail) }))
    openApp(PAGE)
    const name = await screen.findByLabelText('Your full name')
    await userEvent.type(name, 'N. Designer{Enter}')
    expect(await screen.findByText(/nothing was accepted\.$/)).toBeVisible()
    expect(name).toHaveValue('N. Designer')
  })

  test('sends it back with what they want otherwise', async () => {
    const { asked } = serve(
      contractAnswers({
        'POST /v1/contracts/c1/ask-change': { ...CONTRACT, state: 'draft', waits_for: ['studio'], may: MAY },
      }),
    )
    openApp(PAGE)
    const form = within(await screen.findByRole('form', { name: 'Request a change' }))
    await userEvent.type(form.getByLabelText('Requested change'), 'One round.')
    await userEvent.click(form.getByRole('button', { name: 'Request change' }))
    expect(await screen.findByText('Draft, with the studio')).toBeVisible()
    expect(asked.find(({ path }) => path.endsWith('/ask-change'))?.body).toEqual({
      text: 'One round.',
      clause_key: null,
    })
  })

  test('signs nothing while a change is typed and not requested', async () => {
    const { asked } = serve(contractAnswers())
    openApp(PAGE)
    fireEvent.change(await screen.findByLabelText('Your full name'), { target: { value: 'N. Designer' } })
    const sign = screen.getByRole('button', { name: 'Sign version 2' })
    expect(sign).toBeEnabled()
    fireEvent.change(screen.getByLabelText('Requested change'), { target: { value: 'One round.' } })
    expect(await screen.findByText(/^You have typed a change that you have not requested\./)).toBeVisible()
    expect(sign).toBeDisabled()
    fireEvent.submit(screen.getByRole('form', { name: 'Accept' }))
    fireEvent.change(screen.getByLabelText('Requested change'), { target: { value: '' } })
    await waitFor(() => expect(sign).toBeEnabled())
    expect(asked.filter(({ method }) => method === 'POST')).toEqual([])
  })

  test.each([
    ['contract:c1', /^The draft has changes that are not saved/, 'Open the draft', '/draft'],
    ['plan:c1', /^The plan has changes that are not saved/, 'Open the plan', '/plan'],
  ])('a producer sends no text while %s is not saved', async (key, says, link, at) => {
    serve(contractAnswers({ 'GET /v1/contracts/c1': { ...CONTRACT, state: 'draft', may: { ...MAY, change: true } } }))
    openApp(PAGE)
    const send = await screen.findByRole('button', { name: /^Send to / })
    expect(send).toBeEnabled()
    act(() => void keepDraft(key, { draft: 'typed' }))
    expect(send).toBeDisabled()
    expect(screen.getByText(says)).toBeVisible()
    expect(screen.getByRole('link', { name: link })).toHaveAttribute('href', `${PAGE}${at}`)
    act(() => void keepDraft(key, null))
    expect(send).toBeEnabled()
  })

  test('reads the milestones of a fixed plan in words', async () => {
    const plan = [
      { name: 'First batch', amount: '1,200.00 EUR', due_on: '2026-12-01', cues: 3 },
      { name: 'Second batch', amount: '800.00 EUR', due_on: '', cues: 2 },
    ]
    const entry = { ...ENTRY, kind: 'planned', payload: { milestones: plan } }
    const record = {
      contract_id: 'c1',
      title: 'Effects',
      length: 1,
      sha256: 'c'.repeat(64),
      entries: [entry],
      faults: [],
    }
    serve(contractAnswers({ 'GET /v1/contracts/c1/record': record }))
    openApp(`${PAGE}/record`)
    expect(
      await screen.findByText(
        'First batch, amount 1,200.00 EUR, due on 2026-12-01, cues 3; Second batch, amount 800.00 EUR, cues 2',
      ),
    ).toBeVisible()
  })

  test('keeps a copy of the record, and sees when it is not whole', async () => {
    const record = { contract_id: 'c1', title: 'Effects', length: 1, sha256: 'c'.repeat(64), entries: [ENTRY] }
    serve(contractAnswers({ 'GET /v1/contracts/c1/record': { ...record, faults: ['entry 1 was altered'] } }))
    openApp(`${PAGE}/record`)
    expect(await screen.findByText(/Entry 1 was altered\./)).toBeVisible()
    expect(screen.getByText('Sent to both parties')).toBeVisible()
    const copy = screen.getByRole('link', { name: 'Download a copy' })
    expect(copy).toHaveAttribute('href', '/v1/contracts/c1/record.json')
  })

  test.each([
    ['with entries', 1, []],
    ['with a fault', 1, ['entry 1 was altered']],
    ['before anything was sent', 0, []],
  ])('axe finds nothing in a record %s', async (_, length, faults) => {
    const entries = length === 0 ? [] : [ENTRY, { ...ENTRY, seq: 2, kind: 'agreed', payload: { deposit_bp: 2000 } }]
    const record = {
      contract_id: 'c1',
      title: 'Effects',
      length: entries.length,
      sha256: 'c'.repeat(64),
      entries,
      faults,
    }
    serve(contractAnswers({ 'GET /v1/contracts/c1/record': record }))
    openApp(`${PAGE}/record`)
    expect(await screen.findByRole('heading', { name: /^Entries/ })).toBeVisible()
    const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
    expect(violations.map(({ id, nodes }) => [id, nodes[0]?.html])).toEqual([])
  })
})
