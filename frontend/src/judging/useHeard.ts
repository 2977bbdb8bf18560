import { useQuery, useQueryClient } from '@tanstack/react-query'
import { useEffect, useEffectEvent } from 'react'

import { meQuery } from '@/api/me'
import type { Player } from '@/audio'

const load = () => Promise.all([import('./heardMeter'), import('./heardTakes')])

/** Record what a person of the team hears of a page's takes; a source's id begins with that of its take. */
export function useHeard(player: Player, projectId: string, takeIds: readonly string[]): void {
  const client = useQueryClient()
  const { data: me } = useQuery(meQuery)
  const part = me?.projects.find(({ id }) => id === projectId)?.part
  const personId = part === 'team' ? me?.person.id : undefined
  const takeOf = useEffectEvent((sourceId: string) => takeIds.find((id) => id === sourceId.split(' ')[0]))
  useEffect(() => {
    if (personId === undefined) return undefined
    let stop: (() => void) | null = null
    let isLeft = false
    const begin = async () => {
      const [{ meterHeard }, { HeardTakes, markHeard }] = await load()
      if (isLeft) return
      const heard = new HeardTakes(personId, projectId, (sent) => markHeard(client, projectId, sent))
      const stopMeter = meterHeard(player, (sourceId) => {
        const takeId = takeOf(sourceId)
        if (takeId === undefined) return
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
}
