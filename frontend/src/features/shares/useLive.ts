import { useQuery, useQueryClient } from '@tanstack/react-query'
import { useEffect, useEffectEvent, useRef, useState } from 'react'

import { ApiProblem } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { Player } from '@/audio'

import { type Live, movePlayhead, passKeys, readLive, reportPresence } from './api'
import { Drift, DRIFT_S, type Exchange, expectedS, offsetMs, thereMs } from './live'
import type { Playthrough } from './usePlaythrough'

const REPORT_MS = 3_000 // presence ends 10 s after the last report
const FOLLOW_MS = 250
const KEPT = 8 // exchanges of which the shortest counts

interface Move {
  takeId: string
  isPlaying: boolean
  positionS: number
  /** When the holder heard it there, or will, by our clock. */
  atMs: number
}

export interface LiveHand {
  live: Live | undefined
  isIn: boolean
  problem: string
  join: () => void
  leave: () => void
  take: () => void
  /** Go on with the session here; the other page of the same person falls silent. */
  takeOver: () => void
  drop: () => void
  give: (personId: string) => void
  /** What the holder did just now, for all; nothing for anyone else. */
  lead: (takeId: string, isPlaying: boolean, positionS: number) => void
}

/** The session of a playlist: who is in it, who has control, and a page that follows the playhead of all. */
export function useLive(playlistId: string, mayJoin: boolean, player: Player, playthrough: Playthrough): LiveHand {
  const client = useQueryClient()
  const queryKey = queryKeys.playlist(playlistId, 'live')
  const [isIn, setIsIn] = useState(false)
  const [problem, setProblem] = useState('')
  const [pageId] = useState(() => crypto.randomUUID())
  const exchanges = useRef<Exchange[]>([])
  const [drift] = useState(() => new Drift())

  const exchange = async (send: () => Promise<Live>): Promise<Live> => {
    const sentMs = Date.now()
    const live = await send()
    exchanges.current = [
      ...exchanges.current.slice(1 - KEPT),
      { sentMs, answeredMs: Date.now(), serverMs: live.server_ms },
    ]
    return live
  }
  const { data: live } = useQuery({
    queryKey,
    queryFn: () => exchange(() => readLive(playlistId, pageId)),
    enabled: mayJoin,
    structuralSharing: false, // each answer has its own instant
  })
  const send = async (act: () => Promise<Live>) => {
    try {
      client.setQueryData(queryKey, await exchange(act))
      setProblem('')
    } catch (error) {
      if (!(error instanceof ApiProblem)) return
      setProblem([error.detail, error.fix].filter(Boolean).join('; '))
      void invalidate(client, queryKey)
    }
  }

  /** Whether this page took over from another of the same person, and is not yet where all are. */
  const isCatchingUp = useRef(false)

  // One after the other, each with the sequence of the one before; of those that wait only the last one counts.
  const waiting = useRef<Move | null>(null)
  const isSending = useRef(false)
  /** Where the playhead is when the server has what is sent now. */
  const whereMs = ({ isPlaying, positionS, atMs }: Move): number =>
    1000 * positionS + (isPlaying ? Date.now() - atMs + thereMs(exchanges.current) : 0)
  const sendMoves = async () => {
    if (isSending.current) return
    isSending.current = true
    while (waiting.current !== null) {
      // Nobody can be where a sound has not begun: all begin with the one who has control.
      const earlyMs = -whereMs(waiting.current)
      if (earlyMs > 0) await new Promise((resolve) => setTimeout(resolve, earlyMs))
      const sent: Move = waiting.current
      waiting.current = null
      await send(() =>
        movePlayhead(playlistId, {
          sequence: client.getQueryData<Live>(queryKey)?.sequence ?? 0,
          take_id: sent.takeId,
          is_playing: sent.isPlaying,
          position_s: Math.max(0, whereMs(sent) / 1000),
          page_id: pageId,
        }),
      )
    }
    isSending.current = false
  }

  const move = (to: Move) => {
    if (!isIn || !client.getQueryData<Live>(queryKey)?.is_holder) return
    isCatchingUp.current = false
    waiting.current = to
    void sendMoves()
  }
  const lead: LiveHand['lead'] = (takeId, isPlaying, positionS) =>
    move({ takeId, isPlaying, positionS, atMs: Date.now() + (isPlaying ? 1000 * player.leadS() : 0) })

  const report = useEffectEvent(
    () => void send(() => reportPresence(playlistId, { leaves: false, takes_over: false, page_id: pageId })),
  )
  useEffect(() => {
    if (!isIn) return
    report()
    const timer = setInterval(() => report(), REPORT_MS)
    return () => {
      clearInterval(timer)
      void reportPresence(playlistId, { leaves: true, takes_over: false, page_id: pageId }).catch(() => undefined)
    }
  }, [isIn, playlistId, pageId])

  const follow = useEffectEvent(() => {
    if (live?.is_elsewhere && player.isPlaying()) player.pause()
    if (!live || live.is_elsewhere || live.take_id === null) return
    const wantedS = expectedS(live, offsetMs(exchanges.current), Date.now())
    if (live.is_holder && !isCatchingUp.current) {
      // What the holder hears is what counts: a sound that began late is set right for all.
      const isHeard = player.isHeard() && playthrough.current?.take_id === live.take_id && live.is_playing
      const heardS = player.heardS()
      const isOutOfSync = Math.abs(wantedS - heardS) > DRIFT_S
      if (isHeard && isOutOfSync && waiting.current === null && !isSending.current) {
        move({ takeId: live.take_id, isPlaying: true, positionS: heardS, atMs: Date.now() })
      }
      return
    }
    if (playthrough.current?.take_id !== live.take_id) {
      void playthrough.open(live.take_id, { plays: live.is_playing, fromS: wantedS })
      return
    }
    const { status, durationS } = player.getState()
    if (status === 'loading' || durationS === 0) return
    if (!live.is_playing && player.isPlaying()) player.pause()
    const jumpS = drift.correction(wantedS, player.heardS(), durationS)
    if (live.is_playing && !player.isPlaying() && wantedS < durationS) void player.play(wantedS + player.leadS())
    else if (jumpS !== null) player.align(jumpS)
    else isCatchingUp.current = false
  })
  useEffect(() => {
    if (!isIn) return
    const timer = setInterval(() => follow(), FOLLOW_MS)
    return () => clearInterval(timer)
  }, [isIn])

  return {
    live,
    isIn,
    problem,
    join: () => setIsIn(true),
    leave: () => setIsIn(false),
    take: () => {
      isCatchingUp.current = live?.is_elsewhere ?? false
      void send(() => passKeys(playlistId, { act: 'take', page_id: pageId }))
    },
    takeOver: () => void send(() => reportPresence(playlistId, { leaves: false, takes_over: true, page_id: pageId })),
    drop: () => void send(() => passKeys(playlistId, { act: 'drop', page_id: pageId })),
    give: (personId) => void send(() => passKeys(playlistId, { act: 'give', person_id: personId, page_id: pageId })),
    lead,
  }
}
