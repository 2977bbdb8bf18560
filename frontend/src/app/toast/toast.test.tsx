import { act, fireEvent, screen } from '@testing-library/react'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'

import { draw } from '@/test/draw'

import { dismissToast, showToast, StatusSlot } from './index'

beforeEach(() => vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'performance'] }))
afterEach(() => {
  act(() => {
    dismissToast()
  })
  vi.useRealTimers()
})

const pass = (ms: number) =>
  act(() => {
    vi.advanceTimersByTime(ms)
  })

test('what was done can be taken back by its key for ten seconds', () => {
  const undo = vi.fn()
  draw(<StatusSlot />)
  act(() => {
    showToast('shield_hit A approved.', undo)
  })
  expect(screen.getByRole('status')).toHaveTextContent('shield_hit A approved.')
  pass(9_999)
  fireEvent.keyDown(window, { key: 'u' })
  expect(undo).toHaveBeenCalledOnce()
  expect(screen.getByRole('status')).toBeEmptyDOMElement()
  fireEvent.keyDown(window, { key: 'u' })
  expect(undo).toHaveBeenCalledOnce()
})

test('after ten seconds it leaves', () => {
  const undo = vi.fn()
  draw(<StatusSlot />)
  act(() => {
    showToast('shield_hit A approved.', undo)
  })
  pass(10_000)
  expect(screen.getByRole('status')).toBeEmptyDOMElement()
  fireEvent.keyDown(window, { key: 'u' })
  expect(undo).not.toHaveBeenCalled()
})

test('its clock stops while one points at it', () => {
  draw(<StatusSlot />)
  act(() => {
    showToast('Cut.', vi.fn())
  })
  pass(6_000)
  fireEvent.mouseEnter(screen.getByText('Cut.'))
  pass(60_000)
  expect(screen.getByText('Cut.')).toBeInTheDocument()
  fireEvent.mouseLeave(screen.getByText('Cut.'))
  pass(3_999)
  expect(screen.getByText('Cut.')).toBeInTheDocument()
  pass(1)
  expect(screen.queryByText('Cut.')).not.toBeInTheDocument()
})

test('there is one at a time, and the newer one has its own ten seconds', () => {
  draw(<StatusSlot />)
  act(() => {
    showToast('First.')
  })
  pass(9_000)
  act(() => {
    showToast('Second.')
  })
  pass(9_000)
  expect(screen.queryByText('First.')).not.toBeInTheDocument()
  expect(screen.getByText('Second.')).toBeInTheDocument()
  expect(screen.queryByRole('button', { name: 'Undo' })).not.toBeInTheDocument()
})
