import { act, fireEvent, render, screen } from '@testing-library/react'
import { beforeEach, expect, test, vi } from 'vitest'

import { draw } from '@/test/draw'
import { Field } from '@/ui/Form'

import { DraftNote, forgetDrafts, keepDraft, keptDraft, openDraftsOf, useDraft } from '.'
import { DraftForm } from './DraftForm'
import { isAnythingTyped, keepDrafts } from './store'

function Note({ about = 'c1' }: { about?: string }) {
  const [text, setText, draft] = useDraft(`note:${about}`, '')
  return (
    <>
      <input aria-label="Note" value={text} onChange={(event) => setText(event.currentTarget.value)} />
      <DraftNote draft={draft} />
      <button onClick={draft.discard}>Send</button>
    </>
  )
}

const idle = { isPending: false, error: null }

const field = () => screen.getByLabelText<HTMLInputElement>('Note')
const type = (text: string) => fireEvent.change(field(), { target: { value: text } })

beforeEach(() => {
  localStorage.clear()
  forgetDrafts()
  openDraftsOf('ada')
})

test('what was typed stands there again, says so, and can be discarded', () => {
  render(<Note />).unmount()
  const first = render(<Note />)
  expect(screen.queryByText(/Draft restored/)).toBeNull()
  type('a bit shorter')
  first.unmount()
  const second = render(<Note />)
  expect(field().value).toBe('a bit shorter')
  expect(screen.getByRole('status').textContent).toBe('Draft restored · Discard')
  fireEvent.click(screen.getByText('Discard'))
  expect(field().value).toBe('')
  second.unmount()
  render(<Note />)
  expect(field().value).toBe('')
})

test('what was sent is not kept, and each thing has its own draft', () => {
  const page = render(<Note />)
  type('one')
  page.rerender(<Note about="c2" />)
  expect(field().value).toBe('')
  type('two')
  fireEvent.click(screen.getByText('Send'))
  expect(keptDraft('note:c2')).toBeNull()
  page.rerender(<Note />)
  expect(field().value).toBe('one')
})

test('nobody reads what another person typed in the same browser, and signing out deletes it', () => {
  const page = render(<Note />)
  type('for Ada only')
  page.unmount()
  act(() => openDraftsOf('bob'))
  render(<Note />).unmount()
  expect(keptDraft('note:c1')).toBeNull()
  openDraftsOf('ada')
  expect(keptDraft('note:c1')).toBe('for Ada only')
  forgetDrafts()
  expect(Object.keys(localStorage).filter((key) => key.includes(':ada:'))).toEqual([])
})

test('a draft is deleted after a month', () => {
  const page = render(<Note />)
  type('old')
  page.unmount()
  vi.setSystemTime(Date.now() + 31 * 24 * 3_600_000)
  expect(keptDraft('note:c1')).toBeNull()
  vi.useRealTimers()
})

test('leaving asks only where the browser could not keep it', () => {
  const leaves = () => window.dispatchEvent(new Event('beforeunload', { cancelable: true }))
  render(<Note />)
  type('kept')
  expect(leaves()).toBe(true)
  vi.spyOn(Storage.prototype, 'setItem').mockImplementation(() => {
    throw new DOMException('full', 'QuotaExceededError')
  })
  type('too large')
  expect(leaves()).toBe(false)
})

test('what was typed since the page was opened makes leaving ask; what was restored or handed over does not', () => {
  const page = render(<Note />)
  expect(isAnythingTyped()).toBe(false)
  type('half a sentence')
  expect(isAnythingTyped()).toBe(true)
  keepDrafts()
  page.unmount()
  render(<Note />)
  expect(field().value).toBe('half a sentence')
  expect(isAnythingTyped()).toBe(false)
  type('half a sentence more')
  expect(isAnythingTyped()).toBe(true)
  fireEvent.click(screen.getByText('Send'))
  expect(isAnythingTyped()).toBe(false)
  keepDraft('sheet:p1', { text: 'pasted' }, true)
  expect(isAnythingTyped()).toBe(false)
})

test('a draft that is discarded leaves the form that showed it', () => {
  const form = (
    <DraftForm draftKey="form:c1" initialValues={{ note: 'as saved' }} mutation={idle} onSubmit={() => undefined}>
      <Field name="note" label="Note" />
    </DraftForm>
  )
  const page = draw(form)
  type('half a sentence')
  page.unmount()
  draw(form)
  expect(field().value).toBe('half a sentence')
  fireEvent.click(screen.getByText('Discard'))
  expect(field().value).toBe('as saved')
  expect(keptDraft('form:c1')).toBeNull()
})

test('after saving a form shows what was saved, and what is being typed stays', () => {
  function Settings({ saved }: { saved: string }) {
    const [text, setText, draft] = useDraft('settings:p1', saved)
    return (
      <>
        <input aria-label="Note" value={text} onChange={(event) => setText(event.currentTarget.value)} />
        <button onClick={draft.discard}>Sent</button>
      </>
    )
  }
  const page = render(<Settings saved="Ada" />)
  type('Grace')
  fireEvent.click(screen.getByText('Sent'))
  page.rerender(<Settings saved="Grace" />)
  expect(field().value).toBe('Grace')
  type('Grace H')
  page.rerender(<Settings saved="Somebody else" />)
  expect(field().value).toBe('Grace H')
})
