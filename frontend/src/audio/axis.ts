/** Seconds between lines of the grid: 1, 2 or 5 of a power of ten, at least so many pixels apart. */
export function gridStepS(durationS: number, widthPx: number, apartPx = 72): number {
  if (!(durationS > 0) || !(widthPx > 0)) return 1
  const least = (durationS * apartPx) / widthPx
  const power = 10 ** Math.floor(Math.log10(least))
  const step = [1, 2, 5, 10].find((factor) => factor * power >= least * (1 - 1e-9)) ?? 10
  return Number((step * power).toPrecision(1))
}

export interface Tick {
  atS: number
  text: string
}

/** Figures of the ruler: round times, and at the end the length with its unit. */
export function ticksOf(durationS: number, stepS: number, widthPx: number): Tick[] {
  const decimals = Math.min(3, Math.max(0, Math.ceil(-Math.log10(stepS) - 1e-9)))
  const end = `${durationS.toFixed(2)} s`
  const endPx = (end.length + 2) * 7 + 14
  const ticks: Tick[] = []
  for (let index = 0; ; index += 1) {
    const atS = index * stepS
    if (atS > durationS || widthPx * (1 - atS / durationS) < endPx) break
    ticks.push({ atS, text: atS.toFixed(decimals) })
  }
  return [...ticks, { atS: durationS, text: end }]
}

export interface Placed<T> {
  item: T
  leftPx: number
  lane: number
}

export interface Layout<T> {
  placed: Placed<T>[]
  /** How many lanes are used. */
  lanes: number
  /** Labels without room, and the position of the "+4" in their place. */
  hidden: T[]
  moreAt: { leftPx: number; lane: number } | null
}

const GAP_PX = 6
const MORE_PX = 34

/** Stack what overlaps, three high at most; the rest becomes one "+4". Nothing leaves the right edge. */
export function stack<T>(
  items: readonly T[],
  widthPx: number,
  boxOf: (item: T) => { leftPx: number; widthPx: number },
  maxLanes = 3,
): Layout<T> {
  const rights: number[] = []
  const placed: Placed<T>[] = []
  const hidden: T[] = []
  const boxes = items.map((item) => ({ item, ...boxOf(item) })).sort((a, b) => a.leftPx - b.leftPx)
  let firstHiddenPx = 0
  for (const box of boxes) {
    const leftPx = Math.max(0, Math.min(box.leftPx, widthPx - box.widthPx))
    const free = rights.findIndex((right) => right + GAP_PX <= leftPx)
    const lane = free >= 0 ? free : rights.length
    if (lane >= maxLanes) {
      if (hidden.length === 0) firstHiddenPx = leftPx
      hidden.push(box.item)
      continue
    }
    rights[lane] = leftPx + box.widthPx
    placed.push({ item: box.item, leftPx, lane })
  }
  if (hidden.length === 0) return { placed, lanes: rights.length, hidden, moreAt: null }
  const shortest = rights.indexOf(Math.min(...rights))
  const leftPx = Math.min(Math.max(firstHiddenPx, (rights[shortest] ?? 0) + GAP_PX), Math.max(0, widthPx - MORE_PX))
  return { placed, lanes: rights.length, hidden, moreAt: { leftPx, lane: shortest } }
}
