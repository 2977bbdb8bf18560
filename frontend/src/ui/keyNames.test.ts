import { describe, expect, test } from 'vitest'

import { ariaKeys, capsOf, keyOf } from './keyNames'

const press = (key: string, held: Partial<Record<'ctrlKey' | 'metaKey' | 'altKey' | 'shiftKey', boolean>> = {}) =>
  keyOf({ key, ctrlKey: false, metaKey: false, altKey: false, shiftKey: false, ...held })

describe('what a press is called', () => {
  test.each([
    [press('a'), 'a'],
    [press(' '), 'Space'],
    [press('?', { shiftKey: true }), '?'],
    [press('X', { shiftKey: true }), 'shift+x'],
    [press('K', { ctrlKey: true }), 'mod+k'],
    [press('k', { metaKey: true }), 'mod+k'],
    [press('ArrowLeft', { shiftKey: true }), 'shift+ArrowLeft'],
  ])('%s is %s', (is, wanted) => {
    expect(is).toBe(wanted)
  })
})

test('caps follow the machine', () => {
  expect(capsOf('mod+k', false)).toEqual(['Ctrl K'])
  expect(capsOf('mod+k', true)).toEqual(['⌘ K'])
  expect(capsOf('g t', false)).toEqual(['g', 't'])
  expect(capsOf('Escape', false)).toEqual(['Esc'])
})

test('ARIA has no word for a sequence', () => {
  expect(ariaKeys('g t')).toBeUndefined()
  expect(ariaKeys('mod+k')).toBe('Control+k')
})
