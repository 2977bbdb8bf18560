const LEAST_LEAD_S = 0.015

/** The next time at which the device begins a sound to the sample: what should begin sooner begins late. */
export function soonS(context: AudioContext): number {
  const latencyS = context.baseLatency as number | undefined // rendered by itself, a context has none
  return context.currentTime + (latencyS === undefined ? 0 : Math.max(LEAST_LEAD_S, 2 * latencyS))
}
