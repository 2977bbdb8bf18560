import { expect, test } from 'vitest'

import { everyPage } from './pages'

test('pages are read one after another, each reported as it comes, until none follows', async () => {
  const asked: (string | undefined)[] = []
  const reported: number[] = []
  const pages = await everyPage(
    (cursor) => {
      asked.push(cursor)
      const next = { first: 'second', second: undefined }[cursor ?? ''] ?? (cursor === undefined ? 'first' : null)
      return Promise.resolve({ items: [cursor ?? 'begin'], next })
    },
    (sofar) => reported.push(sofar.length),
  )
  expect(asked).toEqual([undefined, 'first', 'second'])
  expect(pages.flatMap(({ items }) => items)).toEqual(['begin', 'first', 'second'])
  expect(reported).toEqual([1, 2, 3])
})

test('a refused page refuses the whole', async () => {
  const read = (cursor: string | undefined) =>
    cursor === undefined ? Promise.resolve({ next: 'more' }) : Promise.reject(new Error('refused'))
  await expect(everyPage(read)).rejects.toThrow('refused')
})
