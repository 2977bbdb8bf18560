import { expect, test } from 'vitest'

import { type Chunk, MOST_BYTES, pageSizes, tooLarge } from '../../scripts/pageSizes'

const page = (name: string, imports: string[], css: string[] = []): Chunk => ({
  type: 'chunk',
  fileName: `${name}.js`,
  imports,
  isDynamicEntry: true,
  facadeModuleId: `/frontend/src/features/${name}.tsx`,
  viteMetadata: { importedCss: new Set(css) },
})
const chunk = (fileName: string, imports: string[] = []): Chunk => ({ type: 'chunk', fileName, imports })

const BUNDLE = Object.fromEntries(
  [
    chunk('index.js', ['base.js']),
    chunk('base.js'),
    chunk('shared.js', ['base.js']),
    page('today/TodayPage', ['shared.js', 'base.js'], ['today.css']),
    page('desk/DeskPage', ['shared.js']),
    { ...page('desk/Menu', []), facadeModuleId: '/frontend/src/features/desk/Menu.tsx' },
  ].map((one) => [one.fileName, one]),
)
const BYTES: Record<string, number> = {
  'early.js': 1,
  'index.js': 10,
  'base.js': 100,
  'shared.js': 1_000,
  'today/TodayPage.js': 10_000,
  'desk/DeskPage.js': 20_000,
  'base.css': 5,
  'today.css': 50,
}

test('a page loads what every page has, its own chunk and what that imports, each once', () => {
  const sizes = pageSizes(['early.js', 'index.js', 'base.css'], BUNDLE, (file) => BYTES[file] ?? NaN)
  expect(sizes).toEqual([
    { page: 'today/TodayPage', script: 11_111, style: 55 },
    { page: 'desk/DeskPage', script: 21_111, style: 5 },
  ])
})

test('a page over its limit is named with both figures, and one at the limit passes', () => {
  const at = { page: 'today/TodayPage', ...MOST_BYTES.arrival }
  const over = { ...at, script: at.script + 1 }
  expect(tooLarge([at], ['today/TodayPage'])).toEqual([])
  expect(tooLarge([over], ['today/TodayPage'])).toEqual([
    'today/TodayPage loads 204801 bytes of script, compressed; the limit is 204800',
  ])
  expect(tooLarge([over], [])).toEqual([]) // where people come from another page
  expect(tooLarge([{ ...at, script: 262_145, style: 30_001 }], [])).toEqual([
    'today/TodayPage loads 262145 bytes of script, compressed; the limit is 262144',
    'today/TodayPage loads 30001 bytes of style, compressed; the limit is 30000',
  ])
})
