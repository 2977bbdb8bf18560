import type { Live } from './api'

/** What a page may be away from the playhead that all hear, by the middle of several readings. */
export const DRIFT_S = 0.02
/** Farther away it jumps at once. */
const FAR_S = 0.15
/** The clock of a device moves in steps of up to 40 ms: no single reading counts. */
const READINGS = 5

/** One exchange with the server: when it was sent and answered by our clock, and the server's clock in between. */
export interface Exchange {
  sentMs: number
  answeredMs: number
  serverMs: number
}

const NONE: Exchange = { sentMs: 0, answeredMs: 0, serverMs: 0 }
const tookMs = ({ sentMs, answeredMs }: Exchange): number => answeredMs - sentMs

/** The exchange that took least time: it knows best when the server's clock was read. */
const shortest = (exchanges: readonly Exchange[]): Exchange =>
  exchanges.reduce(
    (fastest, exchange) => (tookMs(exchange) < tookMs(fastest) ? exchange : fastest),
    exchanges[0] ?? NONE,
  )

/** How far the server's clock is ahead of ours: it was read in the middle of an exchange. */
export function offsetMs(exchanges: readonly Exchange[]): number {
  const { sentMs, answeredMs, serverMs } = shortest(exchanges)
  return serverMs - (sentMs + answeredMs) / 2
}

/** How long a request takes until the server has it. */
export const thereMs = (exchanges: readonly Exchange[]): number => tookMs(shortest(exchanges)) / 2

/** Where the playhead of a session stands at a moment of our clock. */
export function expectedS(live: Pick<Live, 'position_s' | 'server_ms' | 'is_playing'>, aheadMs: number, nowMs: number) {
  if (!live.is_playing) return live.position_s
  return Math.max(0, live.position_s + (nowMs + aheadMs - live.server_ms) / 1000)
}

/** How far a page is from the playhead that all hear, and when it jumps there. */
export class Drift {
  #awayS: number[] = []

  /** Where to jump, so that a page hears what all hear; null while it is near enough. */
  correction(wantedS: number, actualS: number, durationS: number): number | null {
    const soughtS = Math.min(wantedS, durationS)
    const awayS = soughtS - actualS
    this.#awayS = [...this.#awayS.slice(1 - READINGS), awayS]
    const middleS = [...this.#awayS].sort((a, b) => a - b)[(READINGS - 1) / 2] ?? 0
    const isOutOfSync = this.#awayS.length === READINGS && Math.abs(middleS) > DRIFT_S
    if (!isOutOfSync && Math.abs(awayS) <= FAR_S) return null
    this.#awayS = []
    return soughtS
  }
}
