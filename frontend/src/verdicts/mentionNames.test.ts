import { expect, test } from 'vitest'

import { mentionedIn, offered, typedName } from './mentionNames'

const ANN = { id: 'ann', name: 'Ann' }
const ANNA = { id: 'anna', name: 'Anna Mills' }
const BEN = { id: 'ben', name: 'Ben' }
const PEOPLE = [ANN, ANNA, BEN]

test.each([
  ['no one', []],
  ['Ann and Ben', []],
  ['@Ann, look', ['ann']],
  ['@Anna Mills, look', ['anna']],
  ['@Anna Mills and @Ann', ['anna', 'ann']],
  ['@Ben@Ann', ['ann', 'ben']],
])('in %j the longest name is meant', (text, wanted) => {
  expect(mentionedIn(text, PEOPLE)).toEqual(wanted)
})

test.each([
  ['@', { from: 0, query: '' }],
  ['ask @an', { from: 4, query: 'an' }],
  ['ask @Anna M', { from: 4, query: 'Anna M' }],
  ['a@studio', null],
  ['@Ann\nthen', null],
  ['none', null],
])('before the caret of %j stands %j', (text, wanted) => {
  expect(typedName(text, text.length)).toEqual(wanted)
})

test('a name is offered by the beginning of any of its words', () => {
  expect(offered(PEOPLE, 'an')).toEqual([ANN, ANNA])
  expect(offered(PEOPLE, 'mi')).toEqual([ANNA])
  expect(offered(PEOPLE, 'nn')).toEqual([])
  expect(offered(PEOPLE, '')).toEqual(PEOPLE)
})
