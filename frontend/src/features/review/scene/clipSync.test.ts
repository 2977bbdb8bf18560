import { expect, test, vi } from 'vitest'

import { type Picture, syncPicture } from './clipSync'

const picture = (state: Partial<Picture> = {}): Picture => ({
  currentTime: 10,
  playbackRate: 1,
  paused: false,
  seeking: false,
  play: vi.fn(() => Promise.resolve()),
  pause: vi.fn(),
  ...state,
})

test('a picture that stands still is put where the listener is', () => {
  const still = picture({ paused: true })
  syncPicture(still, 12.5, false)
  expect(still.currentTime).toBe(12.5)
  const running = picture()
  syncPicture(running, 10, false)
  expect(running.pause).toHaveBeenCalledOnce()
})

test('a picture far off jumps, and one that is near runs faster or slower until it is there', () => {
  const far = picture({ currentTime: 9 })
  syncPicture(far, 10, true)
  expect(far).toMatchObject({ currentTime: 10, playbackRate: 1 })
  const late = picture({ currentTime: 9.97 })
  syncPicture(late, 10, true)
  expect(late.currentTime).toBe(9.97)
  expect(late.playbackRate).toBeCloseTo(1.09)
  const early = picture({ currentTime: 10.1 })
  syncPicture(early, 10, true)
  expect(early.playbackRate).toBeCloseTo(0.88)
  const there = picture({ currentTime: 10.003, playbackRate: 1.1 })
  syncPicture(there, 10, true)
  expect(there.playbackRate).toBe(1)
})

test('it comes within 20 ms in less than a second, and stays', () => {
  const run = picture({ currentTime: 9.86 })
  let wantedS = 10
  const awaysMs: number[] = []
  for (let frame = 0; frame < 180; frame += 1) {
    syncPicture(run, wantedS, true)
    wantedS += 1 / 60
    run.currentTime += run.playbackRate / 60
    awaysMs.push(Math.abs(run.currentTime - wantedS) * 1000)
  }
  expect(Math.max(...awaysMs.slice(80))).toBeLessThan(20)
})

test('a paused picture is started, and one that is seeking is left alone', () => {
  const paused = picture({ paused: true })
  syncPicture(paused, 10, true)
  expect(paused.play).toHaveBeenCalledOnce()
  const seeking = picture({ seeking: true, currentTime: 3 })
  syncPicture(seeking, 10, true)
  expect(seeking.currentTime).toBe(3)
})
