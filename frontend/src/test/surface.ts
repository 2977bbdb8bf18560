import type { Surface } from '@/audio/draw'

export interface Rect {
  fill: string
  x: number
  y: number
  w: number
  h: number
}

/** A surface that remembers its rectangles; a colour is its token's name. */
export function rememberingSurface(width: number, height: number): { surface: Surface; rects: Rect[] } {
  const rects: Rect[] = []
  const pen = {
    fillStyle: '',
    fillRect(x: number, y: number, w: number, h: number) {
      rects.push({ fill: pen.fillStyle, x, y, w, h })
    },
  }
  return {
    rects,
    surface: { context: pen as unknown as CanvasRenderingContext2D, width, height, scale: 1, colour: (token) => token },
  }
}
