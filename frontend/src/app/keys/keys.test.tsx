import { fireEvent, screen } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { useLayoutEffect, useState } from 'react'
import { beforeEach, expect, test, vi } from 'vitest'

import { draw } from '@/test/draw'

import { type Hotkey, HotkeyButton, KeyScope, useHotkeys, useKeysSwitch, useListedHotkeys } from './index'

beforeEach(() => localStorage.clear())

function Hears({ hotkeys }: { hotkeys: Hotkey[] }) {
  useHotkeys(hotkeys)
  return null
}

const key = (keys: string, run: Hotkey['run'], more: Partial<Hotkey> = {}): Hotkey => ({
  keys,
  label: keys,
  run,
  ...more,
})

test('a key does its thing, and not while typing', async () => {
  const run = vi.fn()
  draw(
    <>
      <Hears hotkeys={[key('a', run)]} />
      <input aria-label="Filter" />
    </>,
  )
  await userEvent.keyboard('a')
  expect(run).toHaveBeenCalledTimes(1)
  await userEvent.type(screen.getByLabelText('Filter'), 'a')
  expect(run).toHaveBeenCalledTimes(1)
})

test('Ctrl and Cmd are heard while typing', async () => {
  const run = vi.fn()
  draw(
    <>
      <Hears hotkeys={[key('mod+k', run)]} />
      <input aria-label="Filter" />
    </>,
  )
  screen.getByLabelText('Filter').focus()
  await userEvent.keyboard('{Control>}k{/Control}')
  await userEvent.keyboard('{Meta>}k{/Meta}')
  expect(run).toHaveBeenCalledTimes(2)
})

test('a link with the focus keeps Enter, a button Space too', async () => {
  const run = vi.fn()
  draw(
    <>
      <Hears hotkeys={[key('Space', run), key('Enter', run)]} />
      <a href="#here">Link</a>
      <button type="button">Button</button>
    </>,
  )
  screen.getByRole('link').focus()
  await userEvent.keyboard('{Enter}')
  expect(run).not.toHaveBeenCalled()
  await userEvent.keyboard(' ')
  expect(run).toHaveBeenCalledTimes(1)
  screen.getByRole('button').focus()
  await userEvent.keyboard(' {Enter}')
  expect(run).toHaveBeenCalledTimes(1)
})

test('a sequence wants both presses, soon after each other', () => {
  const today = vi.fn()
  const fix = vi.fn()
  draw(<Hears hotkeys={[key('g t', today), key('t', fix)]} />)
  fireEvent.keyDown(window, { key: 'g' })
  fireEvent.keyDown(window, { key: 't' })
  expect([today.mock.calls.length, fix.mock.calls.length]).toEqual([1, 0])
  fireEvent.keyDown(window, { key: 't' })
  expect([today.mock.calls.length, fix.mock.calls.length]).toEqual([1, 1])
  fireEvent.keyDown(window, { key: 'g' })
  fireEvent.keyDown(window, { key: 'x' })
  fireEvent.keyDown(window, { key: 't' })
  expect([today.mock.calls.length, fix.mock.calls.length]).toEqual([1, 2])
})

test('a sequence that is left too long is forgotten', () => {
  const today = vi.fn()
  draw(<Hears hotkeys={[key('g t', today)]} />)
  const at = (key: string, timeStamp: number) => {
    const event = new KeyboardEvent('keydown', { key, bubbles: true })
    Object.defineProperty(event, 'timeStamp', { value: timeStamp })
    window.dispatchEvent(event)
  }
  at('g', 5_000)
  at('t', 6_001)
  expect(today).not.toHaveBeenCalled()
  at('g', 7_000)
  at('t', 7_999)
  expect(today).toHaveBeenCalledOnce()
})

test('Enter and Space belong to the button that has the focus', async () => {
  const play = vi.fn()
  const press = vi.fn()
  draw(
    <>
      <Hears hotkeys={[key('Space', play), key('Enter', play)]} />
      <button onClick={press}>Approve</button>
    </>,
  )
  screen.getByRole('button').focus()
  await userEvent.keyboard(' {Enter}')
  expect(press).toHaveBeenCalledTimes(2)
  expect(play).not.toHaveBeenCalled()
  screen.getByRole('button').blur()
  await userEvent.keyboard(' ')
  expect(play).toHaveBeenCalledOnce()
})

test('a held key starts once and is let go once, also when the window loses the focus', () => {
  const start = vi.fn()
  const stop = vi.fn()
  draw(<Hears hotkeys={[key('h', start, { release: stop })]} />)
  fireEvent.keyDown(window, { key: 'h' })
  fireEvent.keyDown(window, { key: 'h', repeat: true })
  expect([start.mock.calls.length, stop.mock.calls.length]).toEqual([1, 0])
  fireEvent.keyUp(window, { key: 'h' })
  expect(stop).toHaveBeenCalledTimes(1)
  fireEvent.keyDown(window, { key: 'h' })
  fireEvent.blur(window)
  fireEvent.keyUp(window, { key: 'h' })
  expect(stop).toHaveBeenCalledTimes(2)
})

test('Shift and a digit are heard whatever character they make, unless that is a key itself', () => {
  const phone = vi.fn()
  const quiet = vi.fn()
  const filter = vi.fn()
  draw(<Hears hotkeys={[key('shift+3', phone), key('shift+7', quiet), key('/', filter)]} />)
  fireEvent.keyDown(window, { key: '§', code: 'Digit3', shiftKey: true })
  fireEvent.keyDown(window, { key: '/', code: 'Digit7', shiftKey: true })
  fireEvent.keyDown(window, { key: '3', code: 'Digit3' })
  expect([phone.mock.calls.length, quiet.mock.calls.length, filter.mock.calls.length]).toEqual([1, 0, 1])
})

test('the last one registered wins, and the one below comes back when it leaves', async () => {
  const page = vi.fn()
  const row = vi.fn()
  const { rerender } = draw(
    <>
      <Hears hotkeys={[key('a', page)]} />
      <Hears hotkeys={[key('a', row)]} />
    </>,
  )
  await userEvent.keyboard('a')
  expect([page.mock.calls.length, row.mock.calls.length]).toEqual([0, 1])
  rerender(<Hears hotkeys={[key('a', page)]} />)
  await userEvent.keyboard('a')
  expect([page.mock.calls.length, row.mock.calls.length]).toEqual([1, 1])
})

test('a key that comes with the next sound does not judge the one before', async () => {
  const judged = vi.fn<(cue: string) => void>()
  const Room = ({ cue }: { cue: string }) => <Hears hotkeys={[key('a', () => judged(cue))]} />
  function Page() {
    const [cue, setCue] = useState('first')
    useLayoutEffect(() => {
      if (cue === 'second') fireEvent.keyDown(window, { key: 'a' })
    }, [cue])
    return (
      <>
        <Room key={cue} cue={cue} />
        <button onClick={() => setCue('second')}>Next</button>
      </>
    )
  }
  draw(<Page />)
  await userEvent.click(screen.getByRole('button', { name: 'Next' }))
  expect(judged.mock.calls).toEqual([['second']])
})

test('a dialog hears its own keys only', async () => {
  const page = vi.fn()
  const dialog = vi.fn()
  draw(
    <>
      <Hears hotkeys={[key('a', page), key('b', page)]} />
      <KeyScope>
        <Hears hotkeys={[key('a', dialog)]} />
      </KeyScope>
    </>,
  )
  await userEvent.keyboard('ab')
  expect([page.mock.calls.length, dialog.mock.calls.length]).toEqual([0, 1])
})

function Switched() {
  const [on, setOn] = useKeysSwitch()
  const listed = useListedHotkeys()
  return (
    <label>
      Single keys
      <input type="checkbox" checked={on} onChange={(event) => setOn(event.currentTarget.checked)} />
      {listed.map(({ label }) => label).join(', ')}
    </label>
  )
}

test('single keys can be turned off, and stay off', async () => {
  const run = vi.fn()
  const find = vi.fn()
  const { unmount } = draw(
    <>
      <Hears hotkeys={[key('a', run), key('mod+k', find)]} />
      <Switched />
    </>,
  )
  expect(screen.getByText(/a, mod\+k/)).toBeInTheDocument()
  await userEvent.click(screen.getByRole('checkbox'))
  screen.getByRole('checkbox').blur()
  await userEvent.keyboard('a{Control>}k{/Control}')
  expect([run.mock.calls.length, find.mock.calls.length]).toEqual([0, 1])
  expect(document.documentElement).toHaveAttribute('data-keys', 'off')
  unmount()
  draw(<Switched />)
  expect(screen.getByRole('checkbox')).not.toBeChecked()
})

test('a button answers to the key it shows, unless it is off', async () => {
  const press = vi.fn()
  const { rerender } = draw(
    <HotkeyButton keys="a" keyLabel="Approve" onPress={press}>
      Approve
    </HotkeyButton>,
  )
  await userEvent.keyboard('a')
  await userEvent.click(screen.getByRole('button', { name: 'Approve' }))
  expect(press).toHaveBeenCalledTimes(2)
  rerender(
    <HotkeyButton keys="a" keyLabel="Approve" onPress={press} disabled>
      Approve
    </HotkeyButton>,
  )
  await userEvent.keyboard('a')
  expect(press).toHaveBeenCalledTimes(2)
})
