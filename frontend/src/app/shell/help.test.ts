import { existsSync } from 'node:fs'
import { join } from 'node:path'

import { expect, test } from 'vitest'

import { HOMES } from './areas'
import { helpFor } from './help'

const DOCS = join(import.meta.dirname, '../../../../docs')

test.each([
  ['/projects/1/sound-list/cues/2', '/help/how-to/sound-list.html'],
  ['/projects/1/review/2', '/help/how-to/review.html'],
  ['/projects/1/contracts/2/changes', '/help/how-to/contracts.html'],
  ['/projects/new', '/help/tutorials/first-project.html'],
  ['/projects/1', '/help/'],
])('the guide to %s is %s', (pathname, guide) => {
  expect(helpFor(pathname)).toBe(guide)
})

test('every page of the areas leads to a guide that exists', () => {
  for (const route of HOMES.flatMap(({ routes }) => routes)) {
    const path = helpFor(route.replace(/^P/, '/projects/1'))
    const page = path === '/help/' ? 'README.md' : path.replace('/help/', '').replace('.html', '.md')
    expect(existsSync(join(DOCS, page)), `${route}: ${page}`).toBe(true)
  }
})
