/** A drawn name: strokes of points in a box of fixed size, as the server keeps it. */
export type Strokes = number[][][]
type Point = [x: number, y: number]

export const WIDTH = 1000
export const HEIGHT = 300
/** What the server keeps at most. */
const MAX_STROKES = 100
const MAX_POINTS = 3000
/** Points that are nearer than this to the one before are left out. */
const STEP = 4

const within = (value: number, limit: number) => Math.min(limit, Math.max(0, Math.round(value)))

/** The place of a pointer in the box of a drawing, from its place on the screen. */
export function pointAt(event: { clientX: number; clientY: number }, box: DOMRect): Point {
  return [
    within(((event.clientX - box.left) / box.width) * WIDTH, WIDTH),
    within(((event.clientY - box.top) / box.height) * HEIGHT, HEIGHT),
  ]
}

/** The strokes with a point added to the last one; unchanged if it is too near, or the drawing is full. */
export function extended(strokes: Strokes, point: Point): Strokes {
  const last = strokes.at(-1)
  const before = last?.at(-1)
  if (!last || !before) return strokes
  const [x = 0, y = 0] = before
  const isNear = Math.hypot(point[0] - x, point[1] - y) < STEP
  return isNear || countOf(strokes) >= MAX_POINTS ? strokes : [...strokes.slice(0, -1), [...last, point]]
}

/** The strokes with a new one that begins at a point; unchanged if the drawing is full. */
export const begun = (strokes: Strokes, point: Point): Strokes =>
  strokes.length >= MAX_STROKES || countOf(strokes) >= MAX_POINTS ? strokes : [...strokes, [point]]

const countOf = (strokes: Strokes): number => strokes.reduce((sum, stroke) => sum + stroke.length, 0)

/** The strokes as the data of an SVG path; a single point is a dot. */
export const pathOf = (strokes: Strokes): string =>
  strokes
    .map(
      (stroke) => `M ${(stroke.length === 1 ? [...stroke, ...stroke] : stroke).map((at) => at.join(' ')).join(' L ')}`,
    )
    .join(' ')
