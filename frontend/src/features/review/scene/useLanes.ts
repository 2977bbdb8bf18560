import { useEffect, useMemo, useState } from 'react'

import type { Player, Source } from '@/audio'
import type { Placing } from '@/verdicts/useHearing'

import { recordOpening, type Scene, type SceneLane } from './api'
import { gainOf, type HeardLane, placed, placingOf, SceneLanes } from './lanes'
import { loweringDb } from './mixPeak'

/** The lane of the version itself. */
export const SOUND = 'sound'

export interface LaneLevel {
  levelDb: number
  isOn: boolean
}

/** What was moved on this page, by lane; all else is as the server says. */
export type Moved = ReadonlyMap<string, LaneLevel>

export const levelOf = (lane: SceneLane, moved: Moved): LaneLevel =>
  moved.get(lane.id) ?? { levelDb: lane.level_db, isOn: lane.is_on }

/** Fetch, decode and place the sounds beside a version; which of them could not be fetched is said. */
function useBuffers(player: Player, scene: Scene | undefined): [ReadonlyMap<string, AudioBuffer>, string | null] {
  const [buffers, setBuffers] = useState<ReadonlyMap<string, AudioBuffer>>(new Map())
  const [trouble, setTrouble] = useState<string | null>(null)
  const beside = scene?.lanes.filter(({ id }) => id !== SOUND) ?? []
  const lanesJson = JSON.stringify(
    beside.map(({ id, name, preview_url, reference_version_id, starts_s, loops }) => ({
      ...{ id, name, url: preview_url, versionId: reference_version_id },
      places: { startsS: starts_s, loops, lengthS: scene?.length_s ?? 0 },
    })),
  )
  useEffect(() => {
    let isWanted = true
    const lanes = JSON.parse(lanesJson) as {
      id: string
      name: string
      url: string | null
      versionId: string | null
      places: Parameters<typeof placed>[2]
    }[]
    const read = async ({ id, name, url, versionId, places }: (typeof lanes)[number]) => {
      if (url === null) return
      try {
        if (versionId !== null) await recordOpening(versionId)
        const sound = await player.previews.get(url)
        if (isWanted) setBuffers((now) => new Map(now).set(id, placed(sound, player.context(), places)))
      } catch {
        if (isWanted) setTrouble(`${name} could not be loaded.`)
      }
    }
    void (async () => {
      for (const lane of lanes) if (isWanted) await read(lane)
    })()
    return () => {
      isWanted = false
    }
  }, [player, lanesJson])
  return [buffers, trouble]
}

/** The versions that are switched between, each at its places in the scene and at its gain, once it is decoded. */
function useVersions(player: Player, sources: readonly Source[], placing: Placing | null, matched: boolean) {
  const [buffers, setBuffers] = useState<ReadonlyMap<string, AudioBuffer>>(new Map())
  const urls = sources.map(({ url }) => url).join('\n')
  useEffect(() => {
    let isWanted = true
    for (const url of urls.split('\n').filter(Boolean)) {
      player.previews.get(url).then(
        (buffer) => isWanted && setBuffers((now) => new Map(now).set(url, buffer)),
        () => undefined, // the player says that it could not be loaded
      )
    }
    return () => {
      isWanted = false
    }
  }, [player, urls])
  return useMemo(
    () =>
      sources.flatMap(({ url, matchGainDb }) => {
        const sound = buffers.get(url)
        const buffer = sound && placing?.place(sound, player.context())
        return buffer ? [{ buffer, gain: matched ? 10 ** ((matchGainDb ?? 0) / 20) : 1 }] : []
      }),
    [player, sources, buffers, placing, matched],
  )
}

interface LanesGiven {
  player: Player
  scene: Scene | undefined
  moved: Moved
  /** The versions that are switched between. */
  sources: readonly Source[]
  matched: boolean
  onPlacing: (to: Placing | null) => void
}

/** Let a version be heard among the other sounds of its scene, and never clip, for as long as the scene is open. */
export function useLanes({ player, scene, moved, sources, matched, onPlacing }: LanesGiven) {
  const [lanes] = useState(() => new SceneLanes())
  const [buffers, trouble] = useBuffers(player, scene)
  const heard = useMemo(
    () =>
      (scene?.lanes ?? []).flatMap((lane): HeardLane[] => {
        const buffer = buffers.get(lane.id)
        return buffer ? [{ id: lane.id, buffer, ...levelOf(lane, moved) }] : []
      }),
    [scene, buffers, moved],
  )

  const own = scene?.lanes.find(({ id }) => id === SOUND)
  const level = own && levelOf(own, moved)
  const hushed = level?.isOn === false
  const places =
    scene &&
    own &&
    JSON.stringify({ startsS: own.starts_s, loops: own.loops, lengthS: scene.length_s, db: level?.levelDb })
  const placing = useMemo(() => {
    if (places === undefined) return null
    const { db, ...where } = JSON.parse(places) as Parameters<typeof placingOf>[0] & { db: number }
    return placingOf(where, db)
  }, [places])
  const versions = useVersions(player, sources, placing, matched)
  // One gain for all of them: a switch between alternates leaves the rest of the scene as loud as it was.
  const loweredDb = useMemo(() => {
    const beside = heard.map((lane) => ({ buffer: lane.buffer, gain: gainOf(lane) }))
    return loweringDb([beside, ...(hushed ? [] : versions).map((version) => [...beside, version])])
  }, [heard, versions, hushed])

  useEffect(() => {
    player.setMixGain(-loweredDb)
    return () => player.setMixGain(0)
  }, [player, loweredDb])
  useEffect(() => lanes.set(heard), [lanes, heard])
  useEffect(() => {
    player.setBackingTracks(lanes)
    return () => player.setBackingTracks(null)
  }, [player, lanes])
  useEffect(() => {
    player.setSoloMuted(hushed)
    return () => player.setSoloMuted(false)
  }, [player, hushed])
  useEffect(() => {
    if (placing) onPlacing(placing)
  }, [placing, onPlacing])
  useEffect(() => () => onPlacing(null), [onPlacing])
  return { trouble, loweredDb }
}
