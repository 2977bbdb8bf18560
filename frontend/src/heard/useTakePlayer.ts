import { useQuery, useQueryClient } from '@tanstack/react-query'
import { useEffect, useState } from 'react'

import { meQuery } from '@/api/me'
// eslint-disable-next-line no-restricted-imports -- what it hands out records
import { type Player, type PlayerState, usePlayer } from '@/audio'

import { meterHeard } from './heardMeter'

const load = () => import('./heardTakes')
const NONE: ReadonlySet<string> = new Set()

/**
 * A player for a page of a project, and the takes that were heard on it. What a person of its team hears of its takes
 * is recorded.
 */
export function useTakePlayer(
  projectId: string,
  how?: Parameters<typeof usePlayer>[0],
): [Player, PlayerState, ReadonlySet<string>] {
  const [player, state] = usePlayer(how)
  const [heardHere, setHeardHere] = useState(NONE)
  const client = useQueryClient()
  const { data: me } = useQuery(meQuery)
  const part = me?.projects.find(({ id }) => id === projectId)?.part
  const personId = part === 'team' ? me?.person.id : undefined
  useEffect(
    () => meterHeard(player, (takeId) => setHeardHere((before) => new Set(before).add(takeId))),
    [player, projectId],
  )
  useEffect(() => {
    if (personId === undefined) return undefined
    let stop: (() => void) | null = null
    let isLeft = false
    const begin = async () => {
      const { HeardTakes, markHeard } = await load()
      if (isLeft) return
      const heard = new HeardTakes(personId, projectId, (sent) => markHeard(client, projectId, sent))
      const stopMeter = meterHeard(player, (takeId) => {
        markHeard(client, projectId, [takeId])
        heard.add(takeId)
      })
      const onHidden = () => {
        if (document.visibilityState === 'hidden') void heard.send()
      }
      document.addEventListener('visibilitychange', onHidden)
      stop = () => {
        document.removeEventListener('visibilitychange', onHidden)
        stopMeter()
        void heard.send()
      }
    }
    void begin().catch(() => undefined) // without it everything is played all the same
    return () => {
      isLeft = true
      stop?.()
    }
  }, [client, player, personId, projectId])
  return [player, state, heardHere]
}
