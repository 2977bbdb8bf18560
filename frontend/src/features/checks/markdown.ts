export interface Inline {
  text: string
  code: boolean
}

export type Block =
  | { kind: 'head'; level: number; text: string }
  | { kind: 'text'; parts: Inline[] }
  | { kind: 'list'; items: Inline[][] }

/** Text and code between backticks. */
export const inlineOf = (line: string): Inline[] =>
  line
    .split('`')
    .map((text, index) => ({ text, code: index % 2 === 1 }))
    .filter(({ text }) => text !== '')

/** The few forms that the checks' pages are written in: heads, paragraphs, lists of one level. */
export function blocksOf(markdown: string): Block[] {
  return markdown
    .replace(/<!--[\s\S]*?-->/g, '')
    .split(/\n{2,}/)
    .map((chunk) => chunk.trim())
    .filter((chunk) => chunk !== '')
    .map((chunk): Block => {
      const head = /^(#+) (.+)$/.exec(chunk)
      if (head) return { kind: 'head', level: head[1]?.length ?? 1, text: head[2] ?? '' }
      if (chunk.startsWith('- ')) {
        const items = chunk.split(/\n(?=- )/).map((item) => inlineOf(item.slice(2).replace(/\s*\n\s*/g, ' ')))
        return { kind: 'list', items }
      }
      return { kind: 'text', parts: inlineOf(chunk.replace(/\s*\n\s*/g, ' ')) }
    })
}
