import type { Live } from './api'

/** What a page may be away from the playhead that all hear; farther away it jumps there. */
export const DRIFT_S = 0.15

/** One exchange with the server: when it was sent and answered by our clock, and the server's clock in between. */
export interface Exchange {
  sentMs: number
  answeredMs: number
  serverMs: number
}

/** How far the server's clock is ahead of ours, by the exchange that took least time: the clock was read somewhere in it. */
export function offsetMs(exchanges: readonly Exchange[]): number {
  const [first, ...others] = exchanges
  if (first === undefined) return 0
  const tookMs = ({ sentMs, answeredMs }: Exchange) => answeredMs - sentMs
  const best = others.reduce((one, other) => (tookMs(other) < tookMs(one) ? other : one), first)
  return best.serverMs - (best.sentMs + best.answeredMs) / 2
}

/** Where the playhead of a session stands at a moment of our clock. */
export function expectedS(live: Pick<Live, 'position_s' | 'server_ms' | 'is_playing'>, aheadMs: number, nowMs: number) {
  if (!live.is_playing) return live.position_s
  return Math.max(0, live.position_s + (nowMs + aheadMs - live.server_ms) / 1000)
}

/** Where to jump, so that a page hears what all hear; null while it is near enough. */
export function correction(wantedS: number, actualS: number, durationS: number): number | null {
  const soughtS = Math.min(wantedS, durationS)
  return Math.abs(soughtS - actualS) > DRIFT_S ? soughtS : null
}
