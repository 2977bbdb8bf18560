import { describe, expect, test } from 'vitest'

import { gridStepS, stack, ticksOf } from './axis'

describe('grid', () => {
  test.each([
    [0.84, 786, 0.1],
    [0.84, 350, 0.2],
    [24, 800, 5],
    [300, 800, 50],
    [0.12, 800, 0.02],
  ])('%s s on %s px have lines every %s s', (durationS, widthPx, stepS) => {
    expect(gridStepS(durationS, widthPx)).toBe(stepS)
  })

  test('lines are never closer than asked', () => {
    for (let durationS = 0.05; durationS < 400; durationS *= 1.37) {
      const stepS = gridStepS(durationS, 700, 72)
      expect((stepS / durationS) * 700).toBeGreaterThanOrEqual(72 * (1 - 1e-9))
    }
  })
})

test('the ruler begins at nought and ends with the length and its unit, nothing under it', () => {
  const texts = ticksOf(0.84, 0.1, 786).map(({ text }) => text)
  expect(texts).toEqual(['0.0', '0.1', '0.2', '0.3', '0.4', '0.5', '0.6', '0.7', '0.84 s'])
  expect(ticksOf(24, 5, 800).map(({ text }) => text)).toEqual(['0', '5', '10', '15', '20', '24.00 s'])
})

describe('markers', () => {
  const box = (item: { x: number; w: number }) => ({ leftPx: item.x, widthPx: item.w })

  test('what does not overlap shares a lane', () => {
    const layout = stack(
      [
        { x: 0, w: 50 },
        { x: 60, w: 50 },
      ],
      400,
      box,
    )
    expect(layout.placed.map(({ lane }) => lane)).toEqual([0, 0])
    expect(layout.lanes).toBe(1)
  })

  test('what overlaps is stacked, three high, and the rest is one "+4"', () => {
    const seven = Array.from({ length: 7 }, (_, index) => ({ x: 100 + index, w: 80 }))
    const layout = stack(seven, 400, box)
    expect(layout.placed.map(({ lane }) => lane)).toEqual([0, 1, 2])
    expect(layout.hidden).toEqual(seven.slice(3))
    expect(layout.moreAt?.leftPx).toBeGreaterThanOrEqual(180)
    expect(layout.lanes).toBe(3)
  })

  test('nothing leaves the right edge', () => {
    const layout = stack([{ x: 390, w: 120 }], 400, box)
    expect(layout.placed[0]?.leftPx).toBe(280)
  })

  test('nothing on one lane overlaps, whatever comes', () => {
    const items = Array.from({ length: 40 }, (_, index) => ({ x: (index * 37) % 380, w: 20 + ((index * 13) % 60) }))
    const { placed, hidden } = stack(items, 400, box, 3)
    expect(placed.length + hidden.length).toBe(40)
    for (const lane of [0, 1, 2]) {
      const boxes = placed.filter((one) => one.lane === lane).sort((a, b) => a.leftPx - b.leftPx)
      for (let index = 1; index < boxes.length; index += 1) {
        const left = boxes[index - 1]
        const right = boxes[index]
        if (left && right) expect(right.leftPx).toBeGreaterThan(left.leftPx + left.item.w)
      }
    }
  })
})
