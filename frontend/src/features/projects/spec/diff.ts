export interface DiffLine {
  kind: 'same' | 'gone' | 'new'
  text: string
  /** Line numbers, counted from 1. */
  before: number | null
  after: number | null
}

// Beyond it, everything between the first and the last change counts as changed.
const MAX_CELLS = 4_000_000

/** The lines of two texts, what went and what came in the order of the text. */
export function diffLines(before: string, after: string): DiffLine[] {
  const old = before.split('\n')
  const now = after.split('\n')
  let start = 0
  while (start < old.length && start < now.length && old[start] === now[start]) start += 1
  let end = 0
  while (end < old.length - start && end < now.length - start && old.at(-1 - end) === now.at(-1 - end)) end += 1
  const middle = between(old.slice(start, old.length - end), now.slice(start, now.length - end))
  const kept = (texts: string[]) => texts.map((text) => ({ kind: 'same' as const, text }))
  let atOld = 0
  let atNow = 0
  return [...kept(old.slice(0, start)), ...middle, ...kept(old.slice(old.length - end))].map(({ kind, text }) => ({
    kind,
    text,
    before: kind === 'new' ? null : ++atOld,
    after: kind === 'gone' ? null : ++atNow,
  }))
}

/** The longest common lines stay, everything else went or came. */
function between(old: readonly string[], now: readonly string[]): { kind: DiffLine['kind']; text: string }[] {
  const gone = (text: string) => ({ kind: 'gone' as const, text })
  const come = (text: string) => ({ kind: 'new' as const, text })
  if (old.length * now.length > MAX_CELLS) return [...old.map(gone), ...now.map(come)]
  const width = now.length + 1
  const common = new Uint32Array((old.length + 1) * width)
  for (let i = old.length - 1; i >= 0; i -= 1) {
    for (let j = now.length - 1; j >= 0; j -= 1) {
      common[i * width + j] =
        old[i] === now[j]
          ? (common[(i + 1) * width + j + 1] ?? 0) + 1
          : Math.max(common[(i + 1) * width + j] ?? 0, common[i * width + j + 1] ?? 0)
    }
  }
  const lines: { kind: DiffLine['kind']; text: string }[] = []
  let i = 0
  let j = 0
  while (i < old.length || j < now.length) {
    if (i < old.length && j < now.length && old[i] === now[j]) {
      lines.push({ kind: 'same', text: old[i] ?? '' })
      i += 1
      j += 1
    } else if (
      i < old.length &&
      (j === now.length || (common[(i + 1) * width + j] ?? 0) >= (common[i * width + j + 1] ?? 0))
    ) {
      lines.push(gone(old[i] ?? ''))
      i += 1
    } else {
      lines.push(come(now[j] ?? ''))
      j += 1
    }
  }
  return lines
}

export type DiffPart = DiffLine | { kind: 'skipped'; count: number }

/** Only what changed, with a few lines around it; the number of omitted lines is shown. */
export function folded(lines: readonly DiffLine[], round = 3): DiffPart[] {
  const near = lines.map((_, index) =>
    lines.slice(Math.max(0, index - round), index + round + 1).some(({ kind }) => kind !== 'same'),
  )
  const parts: DiffPart[] = []
  lines.forEach((line, index) => {
    const last = parts.at(-1)
    if (near[index]) parts.push(line)
    else if (last?.kind === 'skipped') last.count += 1
    else parts.push({ kind: 'skipped', count: 1 })
  })
  return parts
}
