import type { Player } from '@/audio'

/** A sound counts as heard once all of it was played, or so much of a longer one. */
export const ENOUGH_S = 30
/** A sound that is over was all played, although its clock and that of the page may differ by so much. */
const CLOCKS_APART_MS = 20

const enoughMs = (durationS: number): number => Math.min(ENOUGH_S, durationS) * 1_000

/** Call back once for each take that was played for long enough; the answer stops it. */
export function meterHeard(
  player: Pick<Player, 'getState' | 'subscribeState'>,
  onHeard: (takeId: string) => void,
  now: () => number = () => performance.now(),
): () => void {
  const playedMs = new Map<string, number>()
  const heard = new Set<string>()
  let sounding: { id: string; enoughMs: number; sinceMs: number } | null = null
  let lastId = player.getState().sourceId
  let timer: ReturnType<typeof setTimeout> | undefined

  const count = () => {
    if (sounding === null) return
    const { id, sinceMs } = sounding
    const played = (playedMs.get(id) ?? 0) + now() - sinceMs
    playedMs.set(id, played)
    if (played + CLOCKS_APART_MS < sounding.enoughMs || heard.has(id)) return
    heard.add(id)
    onHeard(id)
  }
  const look = () => {
    clearTimeout(timer)
    count()
    const { status, sourceId, takeId, durationS, isRandomized } = player.getState()
    // One that was just selected sounds only once it is read: until then the one before it goes on.
    const sounds = status === 'playing' && durationS > 0 && (isRandomized || sourceId === lastId)
    lastId = sourceId
    sounding = sounds && takeId !== null ? { id: takeId, enoughMs: enoughMs(durationS), sinceMs: now() } : null
    if (sounding === null || heard.has(sounding.id)) return
    const leftMs = Math.max(0, sounding.enoughMs - (playedMs.get(sounding.id) ?? 0))
    timer = setTimeout(look, Math.ceil(leftMs))
  }
  const unsubscribe = player.subscribeState(look)
  look()
  return () => {
    clearTimeout(timer)
    unsubscribe()
    count()
  }
}
