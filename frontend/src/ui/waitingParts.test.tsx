import { screen, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { expect, test, vi } from 'vitest'

import { ApiProblem } from '@/api/problem'
import { draw } from '@/test/draw'

import { ConfirmInline } from './ConfirmInline'
import { PageHead } from './PageHead'
import { PageWait } from './PageWait'
import { Refusal } from './Refusal'
import { SaveStatus } from './SaveStatus'
import { SecretOnce } from './SecretOnce'
import { sentence } from './sentence'
import { ShowMore } from './ShowMore'
import { Skeleton } from './Skeleton'
import { Table } from './Table'

test.each([
  ['no cue is called so', 'No cue is called so.'],
  ['true peak -0.5 dBTP', 'True peak −0.5 dBTP.'],
  ['Is it there?', 'Is it there?'],
])('the sentence of a refusal: %s', (text, shown) => expect(sentence(text)).toBe(shown))

test('a refusal says what and how to fix it, where it was asked', () => {
  const error = new ApiProblem(409, { code: 'late', detail: 'the version moved on', fix: 'open the newest one' })
  draw(<Refusal error={error} about="laser.wav" />)
  expect(screen.getByRole('alert')).toHaveTextContent('laser.wav: The version moved on. Open the newest one.')
})

test('what broke in the page is no refusal, and is said too', () => {
  draw(<Refusal error={new TypeError('x is undefined')} />)
  expect(screen.getByRole('alert')).toHaveTextContent('Something went wrong in the page. What you typed is kept.')
})

test.each([null, undefined])('where nothing was refused (%s), nothing stands', (error) => {
  draw(<Refusal error={error} />)
  expect(screen.queryByRole('alert')).toBeNull()
})

test.each([
  [404, 'Version not found'],
  [503, 'Version'],
])('a page that was answered %i is headed "%s"', (status, heading) => {
  draw(<PageWait isNamed title="Version" error={new ApiProblem(status, { code: 'x', detail: 'it is away' })} />)
  expect(screen.getByRole('heading', { name: heading })).not.toHaveClass('visually-hidden')
})

test('what cannot be undone is asked in place: the way back has the focus, Escape goes it', async () => {
  const confirm = vi.fn()
  const user = userEvent.setup()
  draw(
    <ConfirmInline
      action="Terminate contract"
      keep="Keep contract"
      consequence="The designer is told."
      onConfirm={confirm}
    >
      Terminate
    </ConfirmInline>,
  )
  await user.click(screen.getByRole('button', { name: 'Terminate' }))
  expect(screen.getByRole('group', { name: 'Terminate contract' })).toHaveTextContent('The designer is told.')
  expect(screen.getByRole('button', { name: 'Keep contract' })).toHaveFocus()
  await user.keyboard('{Escape}')
  expect(screen.getByRole('button', { name: 'Terminate' })).toHaveFocus()
  await user.keyboard('{Enter}')
  await user.click(screen.getByRole('button', { name: 'Terminate contract' }))
  expect(confirm).toHaveBeenCalledOnce()
})

test('a secret stands until it is said to be saved', async () => {
  const done = vi.fn()
  draw(
    <SecretOnce secret="sl_live_1" what="Token" name="CI" onDone={done}>
      For the build.
    </SecretOnce>,
  )
  expect(screen.getByText('Copy the secret of “CI” now. It is not shown again.')).toBeVisible()
  expect(screen.getByText('sl_live_1')).toBeVisible()
  await userEvent.click(screen.getByRole('button', { name: 'I’ve saved it' }))
  expect(done).toHaveBeenCalledOnce()
})

test('more of a list is asked for while there is more, once at a time', async () => {
  const fetchNextPage = vi.fn()
  const list = { hasNextPage: true, isFetchingNextPage: false, fetchNextPage }
  const { rerender } = draw(<ShowMore list={list}>Earlier packs</ShowMore>)
  await userEvent.click(screen.getByRole('button', { name: 'Earlier packs' }))
  rerender(<ShowMore list={{ ...list, isFetchingNextPage: true }}>Earlier packs</ShowMore>)
  await userEvent.click(screen.getByRole('button', { name: 'Earlier packs' }))
  expect(fetchNextPage).toHaveBeenCalledOnce()
  rerender(<ShowMore list={{ ...list, hasNextPage: false }}>Earlier packs</ShowMore>)
  expect(screen.queryByRole('button')).toBeNull()
})

test('a text that saves itself says how it stands, and is sent again by hand', async () => {
  const retry = vi.fn()
  const { rerender } = draw(<SaveStatus state="saving" />)
  expect(screen.getByRole('status')).toHaveTextContent('Saving…')
  rerender(<SaveStatus state="saved" at="21:04" />)
  expect(screen.getByRole('status')).toHaveTextContent('Saved, 21:04')
  rerender(<SaveStatus state="failed" onRetry={retry} />)
  expect(screen.getByRole('status')).toHaveTextContent('Not saved')
  await userEvent.click(screen.getByRole('button', { name: 'Try again' }))
  expect(retry).toHaveBeenCalledOnce()
})

test('the head of a page names it, and holds its acts', () => {
  draw(
    <PageHead title="Packs" actions={<button type="button">Seal</button>}>
      What went out.
    </PageHead>,
  )
  expect(screen.getByRole('heading', { level: 1, name: 'Packs' })).toBeVisible()
  expect(within(screen.getByRole('banner')).getByRole('button', { name: 'Seal' })).toBeVisible()
})

test('lines that wait are said to those who listen', () => {
  const { container } = draw(<Skeleton rows={3} />)
  expect(container.querySelector('[aria-busy="true"]')).toHaveTextContent('Loading')
})

test('a table of figures names its rows, and scrolls by keys', () => {
  draw(
    <Table
      label="Sizes"
      rows={[
        { target: 'handheld', files: 3 },
        { target: 'console', files: 5 },
      ]}
      keyOf={({ target }) => target}
      columns={[
        { head: 'Target', rowHead: true, cell: ({ target }) => target },
        { head: 'Files', numeric: true, cell: ({ files }) => files },
      ]}
    />,
  )
  const table = within(screen.getByRole('region', { name: 'Sizes' })).getByRole('table', { name: 'Sizes' })
  expect(within(table).getByRole('row', { name: 'console 5' })).toBeVisible()
  expect(within(table).getByRole('rowheader', { name: 'handheld' })).toBeVisible()
  expect(screen.getByRole('region', { name: 'Sizes' })).toHaveAttribute('tabindex', '0')
})
