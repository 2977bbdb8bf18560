import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'

import { expect, type Page } from '@playwright/test'

const source = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8')

interface Violation {
  id: string
  help: string
  nodes: { target: string[]; failureSummary?: string }[]
}

const EVERYTHING = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice']

const RUN = {
  everything: { runOnly: EVERYTHING },
  /** Of a page seen already, in other colours. */
  contrast: { runOnly: ['color-contrast'] },
  /** All but contrast, which takes most of the time. */
  structure: { runOnly: EVERYTHING, rules: { 'color-contrast': { enabled: false } } },
}

/** Expect that axe finds nothing on the page as it stands. */
export async function expectAccessible(
  page: Page,
  where = page.url(),
  which: keyof typeof RUN = 'everything',
): Promise<void> {
  const asked = { ...RUN[which], resultTypes: ['violations'] }
  if (await page.evaluate('typeof axe === "undefined"')) await page.evaluate(source)
  const violations = await page.evaluate<Violation[]>(
    `axe.run(document, ${JSON.stringify(asked)}).then((found) => found.violations)`,
  )
  const reported = violations.map(
    ({ id, help, nodes }) => `${id}: ${help}\n  ${nodes.map(({ target }) => target.join(' ')).join('\n  ')}`,
  )
  expect.soft(reported, `axe on ${where}`).toEqual([])
}
