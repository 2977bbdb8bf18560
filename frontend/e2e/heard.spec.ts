import { expect, type Page, test } from '@playwright/test'

import type { Condition } from '../src/audio/conditions'
import type * as Heard from './heard'
import { heardScript } from './heardScript'

const RATE_HZ = 48_000
/** At the edge of a Butterworth filter the power is half. */
const EDGE_DB = 10 * Math.log10(1 / 2)

declare const heard: typeof Heard
declare const measure: Measure

/** What a page answers about one way of hearing. */
interface Measure {
  render: (id: string, channels: Float32Array[], seconds: number, sounds?: boolean) => Promise<Float32Array[]>
  /** Level and phase of a signal at a frequency, as of its samples from the start. */
  at: (samples: Float32Array, hz: number) => { db: number; phase: number }
  octaves: (samples: Float32Array, middlesHz: number[]) => number[]
}

let script: string

test.beforeAll(async () => {
  script = await heardScript()
})

test.beforeEach(async ({ page }) => {
  await page.addScriptTag({ content: script })
  await page.evaluate(measuring, RATE_HZ)
})

/** Put the measuring into the page. */
function measuring(rateHz: number): void {
  const conditionOf = (id: string) => heard.CONDITIONS.find((one) => one.id === id)
  const transformed = (re: number[], im: number[]): [number[], number[]] => {
    if (re.length === 1) return [re, im]
    const half = re.length / 2
    const pick = (from: number[], odd: number) => from.filter((_, index) => index % 2 === odd)
    const [evenRe, evenIm] = transformed(pick(re, 0), pick(im, 0))
    const [oddRe, oddIm] = transformed(pick(re, 1), pick(im, 1))
    const [outRe, outIm] = [new Array<number>(re.length), new Array<number>(re.length)]
    for (let at = 0; at < half; at += 1) {
      const angle = (-2 * Math.PI * at) / re.length
      const turnedRe = (oddRe[at] ?? 0) * Math.cos(angle) - (oddIm[at] ?? 0) * Math.sin(angle)
      const turnedIm = (oddRe[at] ?? 0) * Math.sin(angle) + (oddIm[at] ?? 0) * Math.cos(angle)
      outRe[at] = (evenRe[at] ?? 0) + turnedRe
      outIm[at] = (evenIm[at] ?? 0) + turnedIm
      outRe[at + half] = (evenRe[at] ?? 0) - turnedRe
      outIm[at + half] = (evenIm[at] ?? 0) - turnedIm
    }
    return [outRe, outIm]
  }
  const measured: Measure = {
    render: async (id, channels, seconds, sounds = false) => {
      const context = new OfflineAudioContext(2, seconds * rateHz, rateHz)
      const condition = conditionOf(id)
      const output = (condition ? heard.outputOf(condition) : heard.direct)(context)
      if (sounds) output.onSounding?.('begins')
      const buffer = context.createBuffer(channels.length, seconds * rateHz, rateHz)
      channels.forEach((samples, channel) => buffer.copyToChannel(new Float32Array(samples), channel))
      const source = context.createBufferSource()
      source.buffer = buffer
      source.connect(output.input)
      source.start()
      const made = await context.startRendering()
      return [made.getChannelData(0), made.getChannelData(1)]
    },
    at: (samples, hz) => {
      let [re, im] = [0, 0]
      samples.forEach((value, frame) => {
        const angle = (2 * Math.PI * hz * frame) / rateHz
        re += value * Math.cos(angle)
        im -= value * Math.sin(angle)
      })
      return { db: 10 * Math.log10(re * re + im * im), phase: Math.atan2(im, re) }
    },
    octaves: (samples, middlesHz) => {
      const [re, im] = transformed([...samples], new Array<number>(samples.length).fill(0))
      return middlesHz.map((middle) => {
        let power = 0
        for (let line = 1; line < samples.length / 2; line += 1) {
          const hz = (line * rateHz) / samples.length
          if (hz >= middle * Math.SQRT1_2 && hz < middle * Math.SQRT2)
            power += (re[line] ?? 0) ** 2 + (im[line] ?? 0) ** 2
        }
        return 10 * Math.log10((2 * power) / samples.length ** 2)
      })
    },
  }
  Object.assign(globalThis, { measure: measured })
}

const conditionsOf = (page: Page): Promise<Condition[]> => page.evaluate(() => [...heard.CONDITIONS])

/** The level of an impulse in the left channel, or in both, at each frequency, in each ear. */
const levelsDb = (page: Page, id: string, hz: number[], channels: number[] = [1, 1]) =>
  page.evaluate(
    async ([id, hz, channels]) => {
      const impulses = channels.map((value) => Float32Array.from([value]))
      const ears = await measure.render(id, impulses, 1)
      return ears.map((ear) => hz.map((one) => measure.at(ear, one).db))
    },
    [id, hz, channels] as const,
  )

test('each edge lies where it is stated, and falls as steeply @slow', async ({ page }) => {
  for (const { id, stages } of await conditionsOf(page)) {
    for (const stage of stages) {
      if (stage.kind !== 'highpass' && stage.kind !== 'lowpass') continue
      const near = Array.from({ length: 31 }, (_, index) => stage.hz * (0.94 + 0.004 * index))
      const octave = stage.kind === 'highpass' ? stage.hz / 2 : stage.hz * 2
      const isMeasurable = octave < RATE_HZ / 4 // near half the sample rate a digital filter falls more steeply
      const [left = []] = await levelsDb(page, id, [...near, octave])
      const edge = near.find((_, index) =>
        stage.kind === 'highpass' ? (left[index] ?? 0) >= EDGE_DB : (left[index] ?? 0) <= EDGE_DB,
      )
      expect.soft(edge, `${id}, ${stage.kind}`).toBeGreaterThan(0.95 * stage.hz)
      expect.soft(edge, `${id}, ${stage.kind}`).toBeLessThan(1.05 * stage.hz)
      const down = -10 * Math.log10(1 + 2 ** (2 * stage.order))
      if (isMeasurable) expect.soft(Math.abs((left.at(-1) ?? 0) - down), `${id}, an octave beyond`).toBeLessThan(0.5)
    }
  }
})

test('mono is half of both: what only one has is 6.02 dB down in both ears, and what is opposite cancels @slow', async ({
  page,
}) => {
  for (const id of ['mono', 'phone', 'small']) {
    const [left, right] = await levelsDb(page, id, [2_000], [1, 0])
    const [both] = await levelsDb(page, id, [2_000], [1, 1])
    expect(left).toEqual(right)
    expect((left?.[0] ?? 0) - (both?.[0] ?? 0)).toBeCloseTo(-6.02, 2)
    const [opposite] = await levelsDb(page, id, [2_000], [1, -1])
    expect(opposite?.[0]).toBeLessThan(-120)
  }
})

test('headphones hear the other side 4.5 dB lower and 0.26 ms later, and the middle as before @slow', async ({
  page,
}) => {
  const [own, other] = await levelsDb(page, 'headphones', [20, 10_000], [1, 0])
  expect(Math.abs((other?.[0] ?? 0) - (own?.[0] ?? 0) + 4.5)).toBeLessThan(0.5)
  expect(own?.[1]).toBeCloseTo(0, 0)
  expect(other?.[1]).toBeLessThan(-25)
  const delayS = await page.evaluate(async () => {
    const [, right] = await measure.render('headphones', [Float32Array.from([1]), Float32Array.from([0])], 1)
    return right ? -measure.at(right, 50).phase / (2 * Math.PI * 50) : NaN
  })
  expect(delayS).toBeGreaterThan(0.95 * 260e-6)
  expect(delayS).toBeLessThan(1.05 * 260e-6)
  const [middle = []] = await levelsDb(page, 'headphones', [30, 300, 1_000, 3_000, 10_000])
  for (const db of middle) expect(Math.abs(db)).toBeLessThan(0.5)
})

test('noise has its octave levels in both ears, differs between them, and leaves room for the sound @slow', async ({
  page,
}) => {
  for (const { id, noise, headroomDb } of await conditionsOf(page)) {
    if (!noise) continue
    const middles = noise.octaves.map(({ hz }) => hz)
    const [ears, peak, likeness] = await page.evaluate(
      async ([id, middles]) => {
        const both = await measure.render(id, [Float32Array.from([0])], 3, true)
        const settled = both.map((ear) => ear.slice(-(2 ** 17)))
        const [left, right] = settled as [Float32Array, Float32Array]
        const sum = (one: Float32Array, other: Float32Array) =>
          one.reduce((total, value, frame) => total + value * (other[frame] ?? 0), 0)
        return [
          settled.map((ear) => measure.octaves(ear, middles)),
          Math.max(...settled.map((ear) => ear.reduce((top, value) => Math.max(top, Math.abs(value)), 0))),
          sum(left, right) / Math.sqrt(sum(left, left) * sum(right, right)),
        ] as const
      },
      [id, middles] as const,
    )
    for (const ear of ears) {
      ear.forEach((db, index) =>
        expect
          .soft(Math.abs(db - (noise.octaves[index]?.dbfs ?? 0) - headroomDb), `${id}, ${middles[index]} Hz`)
          .toBeLessThan(0.5),
      )
    }
    expect.soft(Math.abs(likeness), `${id}, left and right`).toBeLessThan(0.1)
    expect.soft(peak + 10 ** ((headroomDb - 1) / 20), `${id}, with a sound at −1 dBTP`).toBeLessThanOrEqual(1)
  }
})

test('noise is silent until something sounds @slow', async ({ page }) => {
  const top = await page.evaluate(async () => {
    const [left] = await measure.render('train', [Float32Array.from([0])], 1)
    return left?.reduce((most, value) => Math.max(most, Math.abs(value)), 0)
  })
  expect(top).toBe(0)
})

/** So long that the nodes of what was heard before are taken out: a rendered second is over in no time. */
const WAIT = 'wait'

/** Play a tone of 1 kHz by the player itself, and choose ways of hearing at stated times. */
const played = (page: Page, chosen: [number, string | null][]) =>
  page.evaluate(
    async ([chosen, rateHz, WAIT]) => {
      const context = new OfflineAudioContext(2, rateHz, rateHz)
      const goOn = context.resume.bind(context)
      Object.assign(context, { resume: () => Promise.resolve(), close: () => Promise.resolve() })
      const tone = Float32Array.from(
        { length: rateHz },
        (_, frame) => 0.5 * Math.sin((2 * Math.PI * 1000 * frame) / rateHz),
      )
      const buffer = context.createBuffer(2, rateHz, rateHz)
      for (const channel of [0, 1]) buffer.copyToChannel(tone, channel)
      Object.assign(context, { decodeAudioData: () => Promise.resolve(buffer) })
      const player = new heard.Player({ createContext: () => context as unknown as AudioContext })
      await player.select({ id: 'tone', url: 'data:,' })
      await player.play()
      for (const [atS, id] of chosen) {
        void context.suspend(atS).then(async () => {
          if (id === WAIT) await new Promise((resolve) => setTimeout(resolve, 400))
          else {
            const condition = heard.CONDITIONS.find((one) => one.id === id)
            player.setOutput(condition && heard.outputOf(condition))
          }
          await goOn()
        })
      }
      const out = (await context.startRendering()).getChannelData(0)
      return { out: [...out], tone: [...tone] }
    },
    [chosen, RATE_HZ, WAIT] as const,
  )

test('choosing while it plays makes no gap and no click, keeps the place, and full range is bit-equal again @slow', async ({
  page,
}) => {
  const { out, tone } = await played(page, [
    [0.256, 'mono'],
    [0.64, null],
    [0.68, WAIT],
  ])
  // Mono leaves a tone that is the same in both channels as it is: all that could be heard is the switch.
  const away = out.map((value, frame) => Math.abs(value - (tone[frame] ?? 0)))
  expect(Math.max(...away)).toBeLessThan(1e-3)
  const before = Math.round(0.25 * RATE_HZ)
  const after = Math.round(0.7 * RATE_HZ)
  expect(out.slice(0, before)).toEqual(tone.slice(0, before))
  expect(out.slice(after)).toEqual(tone.slice(after))
})

test('from one device to another the tone bends no more sharply than it does by itself @slow', async ({ page }) => {
  const { out, tone } = await played(page, [
    [0.256, 'phone'],
    [0.512, 'television'],
    [0.768, 'small'],
  ])
  const bends = (samples: number[]) =>
    samples.slice(2).map((value, at) => Math.abs(value - 2 * (samples[at + 1] ?? 0) + (samples[at] ?? 0)))
  expect(Math.max(...bends(out))).toBeLessThan(1.2 * Math.max(...bends(tone)))
  const window = RATE_HZ / 200
  for (let start = 0; start + window <= out.length; start += window) {
    const rms = Math.sqrt(out.slice(start, start + window).reduce((sum, value) => sum + value ** 2, 0) / window)
    expect(rms).toBeGreaterThan(0.5 * Math.SQRT1_2 * 0.5)
  }
})
