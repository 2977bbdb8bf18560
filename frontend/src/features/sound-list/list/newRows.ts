import { type CueDraft, type DraftField, EMPTY_DRAFT, type Faults } from '../cue/draft'

/** One typed row before it is saved. */
export interface NewRow {
  key: number
  draft: CueDraft
  faults: Faults
  whole: string[]
}

/** The fields of a typed row, in the order of the columns. */
export const NEW_FIELDS = [
  'name',
  'category',
  'use',
  'description',
  'duration_s',
  'variations',
  'loop',
  'state',
  'need',
] as const satisfies readonly DraftField[]

let nextKey = 1

export const blankRow = (name = ''): NewRow => ({
  key: nextKey++,
  draft: { ...EMPTY_DRAFT, name },
  faults: {},
  whole: [],
})

export const isBlank = ({ draft }: NewRow): boolean =>
  [draft.name, draft.category, draft.use, draft.description, draft.duration_s].every((text) => text.trim() === '')

/** Rows with one blank row at their end, where typing goes on. */
export function ensureTrailingBlankRow(rows: readonly NewRow[]): NewRow[] {
  const last = rows.at(-1)
  return last && isBlank(last) ? [...rows] : [...rows, blankRow()]
}

const YES = ['yes', 'y', 'true', '1', 'x', 'loop', 'ja']

function read(field: (typeof NEW_FIELDS)[number], cell: string): string | boolean {
  if (field === 'loop') return YES.includes(cell.toLowerCase())
  if (field === 'state') return ['prototype', 'locked'].includes(cell.toLowerCase()) ? cell.toLowerCase() : 'concept'
  if (field === 'need') return ['should', 'wish'].includes(cell.toLowerCase()) ? cell.toLowerCase() : 'must'
  if (field === 'variations') return cell === '' ? '1' : cell
  return cell
}

/** Lay a pasted block of cells over the rows, from one cell to the right and down. */
export function withPasted(
  rows: readonly NewRow[],
  rowAt: number,
  field: (typeof NEW_FIELDS)[number],
  text: string,
): NewRow[] {
  const block = text
    .replace(/\r\n?/g, '\n')
    .replace(/\n$/, '')
    .split('\n')
    .map((line) => line.split('\t'))
  const columnAt = NEW_FIELDS.indexOf(field)
  const grown = [...rows]
  while (grown.length < rowAt + block.length) grown.push(blankRow())
  return ensureTrailingBlankRow(
    grown.map((row, at) => {
      const cells = block[at - rowAt]
      if (cells === undefined) return row
      const given = NEW_FIELDS.slice(columnAt)
        .slice(0, cells.length)
        .map((column, place) => [column, read(column, (cells[place] ?? '').trim())] as const)
      return { ...row, draft: { ...row.draft, ...Object.fromEntries(given) }, faults: {}, whole: [] }
    }),
  )
}

export const isBlock = (text: string): boolean => /[\t\n]/.test(text.replace(/\r?\n$/, ''))
