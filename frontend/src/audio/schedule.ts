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
