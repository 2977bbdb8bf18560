import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'

import { screen } from '@testing-library/react'
import { afterEach, expect, test, vi } from 'vitest'

import { openApp } from '@/test/openApp'
import { serve } from '@/test/server'

import { blocksOf, inlineOf } from './markdown'

afterEach(() => vi.unstubAllGlobals())

test('heads, paragraphs, lists and code are distinguished; comments are left out', () => {
  expect(blocksOf('<!-- made -->\n\n# name\n\nOne\nline of `code`.\n\n- a\n- b\n  goes on\n\n## Why\n')).toEqual([
    { kind: 'head', level: 1, text: 'name' },
    {
      kind: 'text',
      parts: [
        { text: 'One line of ', code: false },
        { text: 'code', code: true },
        { text: '.', code: false },
      ],
    },
    { kind: 'list', items: [[{ text: 'a', code: false }], [{ text: 'b goes on', code: false }]] },
    { kind: 'head', level: 2, text: 'Why' },
  ])
  expect(inlineOf('`[limits]` first')).toEqual([
    { text: '[limits]', code: true },
    { text: ' first', code: false },
  ])
})

const FOLDER = join(import.meta.dirname, '../../../../docs/checks')
const CHECKS = readdirSync(FOLDER).filter((name) => name.endsWith('.md') && name !== 'README.md')

test.each(CHECKS)('%s is written in forms that the page can draw', (name) => {
  const text = readFileSync(join(FOLDER, name), 'utf8')
  const blocks = blocksOf(text)
  expect(blocks[0]).toEqual({ kind: 'head', level: 1, text: name.replace('.md', '') })
  const drawn = blocks.flatMap((block) => (block.kind === 'text' ? block.parts.map((part) => part.text) : []))
  expect(drawn.join(' ')).not.toMatch(/\*\*|\]\(|^\||```/m)
})

test('a check’s page is there for anyone with the link', async () => {
  serve({})
  openApp('/checks/sample-peak')
  expect(await screen.findByRole('heading', { level: 1, name: 'sample-peak' })).toBeInTheDocument()
  expect(screen.getByRole('heading', { name: 'How to fix' })).toBeInTheDocument()
})

test('a check of another version says so', async () => {
  serve({})
  openApp('/checks/unheard-of')
  expect(await screen.findByRole('heading', { name: 'There is no check called unheard-of.' })).toBeInTheDocument()
})
