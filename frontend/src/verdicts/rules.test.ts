import { describe, expect, test } from 'vitest'

import { aCue, aDraft, aFinding, anItem, aTake } from '@/test/review'

import { isNoted, nextAfter, withoutVerdict } from './afterVerdict'
import { isWholeSet, pickedOfSet } from './choice'
import { asked, asks, measuredPart, namesOf, sentence, spot, takeName, historyText, describeWaiting } from './words'

const noted = (id: string, variation = 1) => {
  const take = aTake(id, { variation })
  return { ...take, draft_change: aDraft(take, aCue(), 'Too loud.') }
}
const one = anItem({ id: 'one', name: 'one' }, [aTake('1')])
const two = anItem({ id: 'two', name: 'two' }, [noted('2')])
const three = anItem({ id: 'three', name: 'three' }, [aTake('3')])

describe('the queue after a verdict', () => {
  test('the picked alternate takes the others of its variation with it', () => {
    const item = anItem({}, [aTake('a'), aTake('b', { number: 2 })])
    expect(withoutVerdict([item, three], { cueId: 'cue-1', takeIds: ['a'], picked: true })).toEqual([three])
  })

  test('other variations of a set stay', () => {
    const set = anItem({ variations: 2 }, [aTake('v1'), aTake('v2', { variation: 2 })])
    const [left] = withoutVerdict([set], { cueId: 'cue-1', takeIds: ['v1'], picked: true })
    expect(left?.takes.map(({ id }) => id)).toEqual(['v2'])
  })

  test('the next is the one after it, then the first again; noted ones are passed over', () => {
    expect(nextAfter([one, two, three], 'one')).toBe(three)
    expect(nextAfter([one, two, three], 'three')).toBe(one)
    expect(nextAfter([one, two], 'one')).toBeUndefined()
    expect(isNoted(two)).toBe(true)
  })

  test('what was judged since the page was drawn does not come again', () => {
    expect(nextAfter([one, three], 'three', [])).toBeUndefined()
    const four = anItem({ id: 'four', name: 'four' }, [aTake('4')])
    expect(nextAfter([one, three, four], 'four', [three])).toBe(three)
  })
})

describe('a set', () => {
  const cue = aCue({ variations: 2 })

  test('is whole when every variation waits or is approved', () => {
    expect(isWholeSet(cue, [aTake('v1'), aTake('v2', { variation: 2 })], [])).toBe(true)
    expect(isWholeSet(cue, [aTake('v1')], [2])).toBe(true)
    expect(isWholeSet(cue, [aTake('v1')], [])).toBe(false)
    expect(isWholeSet(cue, [], [1, 2])).toBe(false)
  })

  test('is not whole while a variation is noted for a change', () => {
    expect(isWholeSet(cue, [aTake('v1'), noted('v2', 2)], [])).toBe(false)
  })

  test('is accepted with the chosen alternate of a variation, else the newest', () => {
    const takes = [aTake('a', { number: 1 }), aTake('b', { number: 2 }), aTake('v2', { variation: 2 })]
    expect(pickedOfSet(takes, new Map()).map(({ id }) => id)).toEqual(['b', 'v2'])
    expect(pickedOfSet(takes, new Map([[1, 'a']])).map(({ id }) => id)).toEqual(['a', 'v2'])
  })
})

describe('words', () => {
  test('what waits names the odd one with its figure', () => {
    const findings = [aFinding({ check: 'variation-set', code: 'variation-set:level' })]
    const set = anItem(
      { variations: 4 },
      [1, 2, 3, 4].map((variation) =>
        aTake(String(variation), { variation, ...(variation === 3 && { findings, away_from_set_lu: 4 }) }),
      ),
    )
    expect(describeWaiting(set)).toEqual({
      before: 'Set of 4: ',
      odd: '_03 is 4.0 dB louder',
      after: ' than the others',
    })
  })

  test('what waits colours a finding up to its comma', () => {
    const item = anItem({}, [aTake('a', { findings: [aFinding()] })])
    expect(describeWaiting(item)).toEqual({
      before: 'First version: ',
      odd: 'True peak −0.60 dBTP',
      after: ', limit −1 dBTP',
    })
  })

  test('a part of a set says how much of it is here', () => {
    const again = anItem({}, [aTake('a', { number: 2 })])
    expect(describeWaiting({ ...again, last_change: 'add a dull metallic clank' }).before).toBe(
      'Version 2, after “add a dull metallic clank”',
    )
    expect(describeWaiting(anItem({ variations: 6 }, [aTake('v1'), aTake('v2', { variation: 2 })])).before).toBe(
      '2 of a set of 6, all conforming',
    )
  })

  test('a checker’s minus becomes a true one, a hyphen stays', () => {
    expect(sentence('head-silence -3 dB (-1)')).toBe('Head-silence −3 dB (−1)')
    expect(measuredPart(aFinding({ message: 'no comma' }))).toEqual(['No comma', ''])
  })

  test('names of files and words of people stay as they were written', () => {
    expect(historyText({ kind: 'received', text: 'laser_01.wav, delivery 2' })).toBe('laser_01.wav, delivery 2')
    expect(historyText({ kind: 'comment', text: 'laser_01 is too loud' })).toBe('laser_01 is too loud')
    expect(historyText({ kind: 'checked', text: 'returned: DC -3 %' })).toBe('Returned: DC −3 %')
    expect(historyText({ kind: 'approve', text: '', reasons: ['Best timing'] })).toBe('Best timing.')
  })

  test('a cue asks for what can be done with it', () => {
    expect(asks(anItem({}, [aTake('a'), aTake('b'), aTake('c')]))).toBe('Pick one of three for shield_hit')
    expect(asks(anItem({ variations: 6 }, [aTake('a')]))).toBe('Listen to the set of six for shield_hit')
    expect(asks(anItem({}, [aTake('a', { number: 2 })]))).toBe('Review version 2 of shield_hit')
    expect(asked(aCue({ variations: 4, loop: true }))).toBe('Weapon, loop, set of 4, target 0.80 s, dry')
  })

  test('a take is called by its letter, its variation, or its version', () => {
    const alternates = [aTake('a'), aTake('b', { number: 2 })]
    expect(takeName(alternates[1]!, aCue(), alternates)).toBe('B')
    expect(takeName(aTake('v3', { variation: 3 }), aCue({ variations: 4 }), [aTake('v3', { variation: 3 })])).toBe(
      '_03',
    )
    expect(takeName(aTake('old', { number: 4, state: 'returned' }), aCue(), alternates)).toBe('version 4')
  })

  test('places and names read as a person would write them', () => {
    expect(spot(0.307, 0.462)).toBe('0.307–0.462 s')
    expect(spot(0.044, null)).toBe('0.044 s')
    expect(spot(null, null)).toBeUndefined()
    expect(namesOf(['a', 'b', 'b'])).toBe('a and b')
    expect(namesOf(['a', 'b', 'c', 'd', 'e'])).toBe('a, b and 3 more')
  })
})
