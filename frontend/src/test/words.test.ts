import { readdirSync, readFileSync } from 'node:fs'

import ts from 'typescript'
import { expect, test } from 'vitest'

/** Idioms of our own, where the field or the web has a word. */
const ODD = [
  ...['silence first', 'silence last', 'lost in mono', 'flat tops', 'soft plateaus', 'padded depth', 'mono in stereo'],
  ...['stand-in', 'stand-ins', 'mend', 'mends', 'mended', 'anew', 'last word', 'decider', 'decides from now on'],
  ...['not said', 'it is kept', 'it may stay empty', 'waits for your yes', 'give it up', 'take it back', 'taken back'],
  ...['put away', 'take up again', 'worthless', 'gave up', 'let it through', 'let through', 'came back', 'went back'],
  ...['mail address', 'look into your mail', 'line lost', 'line is back', 'line dropped', 'server did not answer'],
  ...['in the hand', 'one’s own', 'whoever', 'nothing waits', 'fold them', 'what stands', 'still to come'],
  ...['rounds too many', 'bring in', 'speaks for the team', 'liaison', 'liaisons', 'accepted by silence', 'says so'],
  ...[
    'not a day that is to come',
    'leave it out',
    'drop what',
    'say it',
    'page itself broke',
    'all keys',
    'without tax',
  ],
]
const PHRASE = new RegExp(String.raw`(?<![\w-])(${ODD.join('|')})(?![\w-])`, 'i')

/** Texts of a component, and the strings that read as words: several of them, or one with a capital. */
function shown(name: string, source: string): string[] {
  const found: string[] = []
  const visit = (node: ts.Node) => {
    if (ts.isImportDeclaration(node) || ts.isTypeNode(node)) return
    if (ts.isJsxText(node)) found.push(node.text)
    if (ts.isStringLiteralLike(node) && /\w\s+\w|^[A-Z]/.test(node.text)) found.push(node.text)
    if (ts.isTemplateExpression(node)) {
      const text = [node.head.text, ...node.templateSpans.map(({ literal }) => literal.text)].join(' … ')
      if (/\w\s+\w|^[A-Z]/.test(text)) found.push(text)
    }
    ts.forEachChild(node, visit)
  }
  visit(ts.createSourceFile(name, source, ts.ScriptTarget.Latest, false))
  return found
}

const odd = (name: string, source: string) =>
  shown(name, source)
    .map((text) => text.replace(/\s+/g, ' ').trim())
    .filter((text) => PHRASE.test(text))

test('screens use the words of the field', () => {
  const files = readdirSync('src', { recursive: true, encoding: 'utf8' })
    .filter((path) => /\.tsx?$/.test(path) && !/\.test\.|^test\/|schema\.gen/.test(path))
    .map((path) => `src/${path}`)
  expect(files.length).toBeGreaterThan(200)
  expect(files.flatMap((path) => odd(path, readFileSync(path, 'utf8')).map((text) => `${path}: ${text}`))).toEqual([])
})

test('odd words would be found', () => {
  const page =
    "const a = <p>Silence\n first</p> // mended\nconst b = 'Decider'\nconst key = 'mended'\nconst c = `${key} was made anew`"
  expect(odd('page.tsx', page)).toEqual(['Silence first', 'Decider', '… was made anew'])
})
