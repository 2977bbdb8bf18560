/** One sound as a line of text says it. */
export interface SoundLine {
  name: string
  description: string
  durationS: number | null
  variations: number
}

const VARIATIONS = /\s*[x×]\s*(\d{1,3})$/i
const DURATION = /,?\s*(\d+(?:[.,]\d+)?)\s*(ms|min|s|sec)$/i
const FACTORS: Record<string, number> = { ms: 0.001, s: 1, sec: 1, min: 60 }

/** Read one sound a line, such as "Airlock cycle: door of the ship, 3 s" or "Footsteps on deck x6". */
export function readSoundLines(text: string): SoundLine[] {
  return text
    .split(/\r?\n/)
    .map((line) => line.trim())
    .filter(Boolean)
    .map(readSoundLine)
}

function readSoundLine(line: string): SoundLine {
  const counted = VARIATIONS.exec(line)
  const beforeCount = counted ? line.slice(0, counted.index) : line
  const timed = DURATION.exec(beforeCount)
  const rest = timed && timed.index > 0 ? beforeCount.slice(0, timed.index) : beforeCount
  const [name = '', ...description] = rest.split(':')
  const isTimed = rest !== beforeCount
  return {
    name: name.trim(),
    description: description.join(':').trim(),
    durationS:
      isTimed && timed ? Number(timed[1]?.replace(',', '.')) * (FACTORS[timed[2]?.toLowerCase() ?? ''] ?? 1) : null,
    variations: counted ? Number(counted[1]) : 1,
  }
}

/** Whether a text has several columns, as cells copied from a spreadsheet do. */
export const isTable = (text: string): boolean => text.includes('\t')

const quoted = (text: string): string => `"${text.replaceAll('"', '""')}"`

/** The columns of the sheet that the lines make, each read as the field of its name. */
export const LINE_COLUMNS = {
  name: 'name',
  description: 'description',
  duration_s: 'duration_s',
  variations: 'variations',
} as const

/** Return the lines as a sheet that an import reads; its first row is the head, so line n is row n + 2. */
export const sheetOfLines = (lines: readonly SoundLine[]): string =>
  [
    Object.keys(LINE_COLUMNS).join(','),
    ...lines.map(({ name, description, durationS, variations }) =>
      [quoted(name), quoted(description), durationS ?? '', variations].join(','),
    ),
  ].join('\n')
