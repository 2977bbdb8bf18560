const LEAST_LEAD_S = 0.015

/** The next time at which the device begins a sound to the sample: what should begin sooner begins late. */
export function soonS(context: AudioContext): number {
  const latencyS = context.baseLatency as number | undefined // rendered by itself, a context has none
  return context.currentTime + (latencyS === undefined ? 0 : Math.max(LEAST_LEAD_S, 2 * latencyS))
}

/** Whether a start comes too late to the device: it renders one buffer ahead of the time that the page sees. */
export function isLate(context: AudioContext, atS: number): boolean {
  return atS - context.currentTime < ((context.baseLatency as number | undefined) ?? 0)
}

/** Farther apart, the clock of the device and the latency that it states contradict each other: it has just begun. */
const MOST_APART_S = 0.1

/** The time of a context that is heard now. Its own time goes ahead of the device, in steps of what it renders at once. */
export function heardTimeS(context: BaseAudioContext): number {
  const { currentTime, outputLatency = 0, getOutputTimestamp } = context as BaseAudioContext & Partial<AudioContext>
  const statedS = currentTime - outputLatency
  const { contextTime = 0, performanceTime = 0 } = getOutputTimestamp?.call(context) ?? {}
  const heardS = contextTime + (performance.now() - performanceTime) / 1_000
  return contextTime > 0 && Math.abs(heardS - statedS) < MOST_APART_S ? Math.min(heardS, currentTime) : statedS
}
