import type { Browser, Page } from '@playwright/test'

import { FIRST_GAP_MS, GAP_STEP_MS, positionOfClickS } from './clicks'

/** A click that left the page: when it was heard, by the wall clock, and which place of the sound it marks. */
export interface HeardClick {
  heardMs: number
  positionS: number
  /** -1 for a sound that was made upside down. */
  sign: number
}

interface Pulse {
  heardMs: number
  /** When it was, by the device. */
  deviceS: number
  sign: number
}

declare const recorder: { pulses: Pulse[] }

/** A browser of somebody's own whose output can be recorded: the recorder is a script that the server does not know. */
export const visitRecorded = async (browser: Browser): Promise<Page> =>
  (await browser.newContext({ viewport: { width: 1440, height: 900 }, bypassCSP: true })).newPage()

/** Record from now on, in each document of a page, the clicks of what it plays. */
export async function recordOutput(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const detector = `registerProcessor('pulses', class extends AudioWorkletProcessor {
      sum = 0; moment = 0; sign = 0; calm = 0
      process([[samples]]) {
        for (let index = 0; samples && index < samples.length; index += 1) {
          const value = samples[index]
          if (Math.abs(value) > 0.02) {
            if (this.sum === 0) this.sign = Math.sign(value)
            this.sum += Math.abs(value)
            this.moment += Math.abs(value) * (currentFrame + index)
            this.calm = 0
          } else if (this.sum > 0 && ++this.calm === 16) {
            this.port.postMessage({ frame: this.moment / this.sum, sign: this.sign })
            this.sum = this.moment = 0
          }
        }
        return true
      }
    })`
    const module = URL.createObjectURL(new Blob([detector], { type: 'text/javascript' }))
    const pulses: Pulse[] = []
    const taps = new WeakMap<BaseAudioContext, AudioNode>()
    const connect = Reflect.get(AudioNode.prototype, 'connect') as (this: AudioNode, ...to: unknown[]) => AudioNode
    const tapOf = (context: BaseAudioContext): AudioNode => {
      const known = taps.get(context)
      if (known) return known
      const tap = context.createGain()
      taps.set(context, tap)
      connect.call(tap, context.destination)
      void listen(context as AudioContext, tap)
      return tap
    }
    const listen = async (context: AudioContext, tap: AudioNode) => {
      await context.audioWorklet.addModule(module)
      const node = new AudioWorkletNode(context, 'pulses', { outputChannelCount: [1] })
      connect.call(tap, node)
      connect.call(node, context.destination) // it is silent, and runs only where it leads to the device
      // The device's clock beside the page's, at the moment nearest to the pulse.
      node.port.onmessage = ({ data }: MessageEvent<{ frame: number; sign: number }>) => {
        const { contextTime = 0, performanceTime = 0 } = context.getOutputTimestamp()
        const deviceS = data.frame / context.sampleRate
        const atMs = performanceTime + (deviceS - contextTime) * 1_000
        pulses.push({ heardMs: performance.timeOrigin + atMs, deviceS, sign: data.sign })
      }
    }
    // All that is connected to the device is recorded on its way.
    Object.assign(AudioNode.prototype, {
      connect(this: AudioNode, ...[to, ...more]: unknown[]) {
        const isDevice = to instanceof AudioDestinationNode && this.context instanceof AudioContext
        return connect.call(this, isDevice ? tapOf(this.context) : to, ...more)
      },
    })
    Object.assign(globalThis, { recorder: { pulses } })
  })
}

/** The clicks that left a page so far: each a pair of pulses, whose distance is its number. */
export async function clicksOf(page: Page): Promise<HeardClick[]> {
  const pulses = await page.evaluate(() => recorder.pulses)
  return pulses.flatMap(({ heardMs, deviceS, sign }, index) => {
    const second = pulses[index + 1]
    if (second?.sign !== -sign) return []
    const number = Math.round(((second.deviceS - deviceS) * 1_000 - FIRST_GAP_MS) / GAP_STEP_MS)
    return number < 0 || number > 200 ? [] : [{ heardMs, positionS: positionOfClickS(number), sign }]
  })
}
