import { act, fireEvent, screen } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeEach, describe, expect, test, vi } from 'vitest'

import { draw } from '@/test/draw'

import type { Clock } from './clock'
import { finePeaks } from './peaks'
import { LevelStrip } from './Strip'
import { spotOf, Waveform, type WaveformProps } from './Waveform'
import { WaveThumb } from './WaveThumb'

const peaks = finePeaks({ points: 2, min: [-1, -0.1], max: [1, 0.1], rms: [0.5, 0.05] })
const base: WaveformProps = { label: 'shield_hit, A', peaks, durationS: 0.84 }

beforeEach(() => {
  vi.spyOn(HTMLElement.prototype, 'clientWidth', 'get').mockReturnValue(840)
  vi.spyOn(HTMLElement.prototype, 'getBoundingClientRect').mockReturnValue(new DOMRect(0, 0, 840, 200))
})

class HandClock implements Clock {
  #listeners = new Set<() => void>()
  atS = 0
  playing = true
  positionS = () => this.atS
  isPlaying = () => this.playing
  subscribe = (listener: () => void) => {
    this.#listeners.add(listener)
    return () => this.#listeners.delete(listener)
  }
  goTo(atS: number) {
    this.atS = atS
    act(() => this.#listeners.forEach((listener) => listener()))
  }
}

describe('the slider', () => {
  test('says its place in words', () => {
    draw(<Waveform {...base} playheadS={0.286} />)
    const slider = screen.getByRole('slider', { name: 'Position in shield_hit, A' })
    expect(slider).toHaveAttribute('aria-valuetext', '0.286 seconds')
    expect(slider).toHaveAttribute('aria-valuemax', '0.84')
    expect(slider).toHaveAttribute('aria-valuenow', '0.286')
  })

  test.each([
    ['{ArrowRight}', 0.51],
    ['{ArrowLeft}', 0.49],
    ['{Shift>}{ArrowRight}{/Shift}', 0.6],
    ['{Shift>}{ArrowLeft}{/Shift}', 0.4],
    ['{Home}', 0],
    ['{End}', 0.84],
    ['{PageUp}', 0.84],
    ['{PageDown}', 0],
  ])('%s goes to %s', async (keys, to) => {
    const seek = vi.fn<(s: number) => void>()
    draw(<Waveform {...base} playheadS={0.5} onSeek={seek} />)
    screen.getByRole('slider').focus()
    await userEvent.keyboard(keys)
    expect(seek.mock.calls[0]?.[0]).toBeCloseTo(to, 9)
  })

  test('a press goes there, a drag picks a range, a press takes the range away', () => {
    const seek = vi.fn<(s: number) => void>()
    const select = vi.fn()
    const { rerender } = draw(<Waveform {...base} onSeek={seek} onSelect={select} />)
    const slider = screen.getByRole('slider')
    fireEvent.pointerDown(slider, { clientX: 210, button: 0 })
    fireEvent.pointerUp(slider, { clientX: 210 })
    expect(seek.mock.calls[0]?.[0]).toBeCloseTo(0.21, 9)

    fireEvent.pointerDown(slider, { clientX: 420, button: 0 })
    fireEvent.pointerMove(slider, { clientX: 105 })
    fireEvent.pointerUp(slider, { clientX: 105 })
    const [range] = select.mock.lastCall as [{ startS: number; endS: number }]
    expect(range.startS).toBeCloseTo(0.105, 9)
    expect(range.endS).toBeCloseTo(0.42, 9)
    expect(seek).toHaveBeenCalledTimes(1)

    rerender(<Waveform {...base} onSeek={seek} onSelect={select} selection={range} />)
    fireEvent.pointerDown(slider, { clientX: 10, button: 0 })
    fireEvent.pointerUp(slider, { clientX: 10 })
    expect(select).toHaveBeenLastCalledWith(null)
  })

  test('follows a clock: the playhead always, the words only when it stands', () => {
    const clock = new HandClock()
    const { container } = draw(<Waveform {...base} clock={clock} />)
    const slider = screen.getByRole('slider')
    clock.goTo(0.42)
    expect((container.querySelector('[style*="--at"]') as HTMLElement).style.getPropertyValue('--at')).toBe('0.5')
    expect(slider).toHaveAttribute('aria-valuetext', '0.000 seconds')
    clock.playing = false
    clock.goTo(0.42)
    expect(slider).toHaveAttribute('aria-valuetext', '0.420 seconds')
  })
})

describe('markers', () => {
  const finding = (id: string, startS: number) => ({ id, severity: 'error' as const, label: `Finding ${id}`, startS })

  test('a finding plays from 0.3 s before it, and never from before the start', async () => {
    const mark = vi.fn<(fromS: number) => void>()
    draw(<Waveform {...base} findings={[finding('1', 0.7)]} onMark={mark} />)
    await userEvent.click(screen.getByRole('button', { name: 'Finding 1, at 0.700 seconds' }))
    expect(mark.mock.calls[0]?.[0]).toBeCloseTo(0.4, 9)
    expect(spotOf(0.1)).toBe(0)
  })

  test('what is stacked too high opens with "+4"', async () => {
    draw(<Waveform {...base} findings={Array.from({ length: 7 }, (_, index) => finding(`${index}`, 0.1))} />)
    expect(screen.getAllByRole('button', { name: /^Finding/ })).toHaveLength(3)
    await userEvent.click(screen.getByRole('button', { name: '+4 more findings' }))
    expect(screen.getAllByRole('button', { name: /^Finding/ })).toHaveLength(7)
  })

  test('comments are pins with their place in words, and the open one is pressed', async () => {
    const mark = vi.fn()
    const comments = [
      { id: 'c1', number: 1, startS: 0.044 },
      { id: 'c2', number: 2, startS: 0.307, endS: 0.462 },
    ]
    draw(<Waveform {...base} comments={comments} openComment="c2" onMark={mark} />)
    expect(screen.getByRole('button', { name: 'Comment 2 from 0.307 s to 0.462 seconds', pressed: true })).toBeVisible()
    await userEvent.click(screen.getByRole('button', { name: 'Comment 1 at 0.044 seconds' }))
    expect(mark).toHaveBeenCalledWith(0, comments[0])
  })
})

test('while the server still draws, it says so, and the axis stands', () => {
  draw(<Waveform {...base} peaks={null} />)
  expect(screen.getByText('The waveform is being drawn. You can play the sound already.')).toBeInTheDocument()
  expect(screen.getByText('0.84 s')).toBeInTheDocument()
})

test('while peaks are on their way, nothing is said', () => {
  draw(<Waveform {...base} peaks={undefined} />)
  expect(screen.queryByText(/still being drawn/)).not.toBeInTheDocument()
})

test('a row without a sound has a dashed frame, one with a sound a canvas', () => {
  const { container, rerender } = draw(<WaveThumb peaks={null} />)
  expect(container.querySelector('canvas')).toBeNull()
  rerender(<WaveThumb peaks={peaks} />)
  expect(container.querySelector('canvas')).toHaveAttribute('aria-hidden', 'true')
})

test('a strip names itself and its window', () => {
  draw(<LevelStrip peaks={peaks} durationS={0.84} />)
  expect(screen.getByText('Level, 20 ms')).toBeInTheDocument()
})
