import { useDebouncedValue } from '@mantine/hooks'
import { useQuery } from '@tanstack/react-query'
import { useEffect, useRef, useState } from 'react'

import { ApiProblem } from '@/api'
import { useHotkeys } from '@/app/keys'
import { type Player, type Source, useAt } from '@/audio'
import type { Placing } from '@/verdicts/useHearing'
import { Button } from '@/ui/Button'
import { figure, plural } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'

import { AddBed } from './AddBed'
import { maskingQuery, type Scene, type SceneLane, sceneQuery, useBeds } from './api'
import { ClipView } from './ClipView'
import { LaneAxis, LaneRow } from './LaneRow'
import { MaskingPlot } from './MaskingPlot'
import classes from './Scene.module.css'
import { type LaneLevel, levelOf, type Moved, useLanes } from './useLanes'

const RESTS_MS = 250
const LEAST_SHOWN_DB = 0.05 // less reads 0.0

export interface SceneStageProps {
  takeId: string
  projectId: string
  player: Player
  looping: boolean
  /** The versions that are switched between, and whether at one loudness. */
  sources: readonly Source[]
  matched: boolean
  onPlacing: (placing: Placing | null) => void
}

/** A version as the game plays it: over its clip, among its neighbours, on its beds. */
export function SceneStage(props: SceneStageProps) {
  const { takeId, projectId, player, looping, sources, matched, onPlacing } = props
  const { data: scene, error } = useQuery(sceneQuery(takeId))
  const [moved, setMoved] = useState<Moved>(new Map())
  const [isAdding, setAdding] = useState(false)
  const { trouble, loweredDb } = useLanes({ player, scene, moved, sources, matched, onPlacing })
  useLooping(player, looping)
  useHotkeys([
    {
      keys: 'w',
      label: 'Hold to hear the scene without it',
      group: 'Review',
      run: () => player.setSoloMuted(true),
      release: () => player.setSoloMuted(false),
    },
  ])
  if (error instanceof ApiProblem) return <Refusal error={error} />
  if (scene === undefined) return <p className={`small mid ${classes.waits}`}>The scene is loading.</p>
  return (
    <section className={`grid gap-3 ${classes.scene}`} aria-label="Scene">
      <div className={`grid items-start gap-3 mid-grid-cols-1 ${classes.top}`}>
        <ClipView clips={scene.clips} projectId={projectId} player={player} />
        <WillItBeHeard scene={scene} moved={moved} />
      </div>
      <Lanes scene={scene} moved={moved} onMoved={setMoved} projectId={projectId} player={player} />
      <div className={`flex wrap items-center gap-2-4 ${classes.under}`}>
        {scene.may_change &&
          (isAdding ? (
            <AddBed projectId={projectId} category={scene.category} onDone={() => setAdding(false)} />
          ) : (
            <Button icon="plus" onClick={() => setAdding(true)}>
              Add a bed
            </Button>
          ))}
        <p className="small dim">
          {scene.audit_label
            ? `Levels of neighbours are those of ${scene.audit_label}.`
            : 'No build was audited yet: neighbours play at the level at which they were approved.'}{' '}
          Hold <kbd>w</kbd> to hear the scene without it.
        </p>
        {loweredDb >= LEAST_SHOWN_DB && (
          <p role="status" className="small mid">
            All of it plays {figure(loweredDb, 1)} dB lower, so that the mix does not clip.
          </p>
        )}
        {trouble && (
          <p role="status" className="small mid">
            {trouble}
          </p>
        )}
      </div>
    </section>
  )
}

/** A scene goes round until it is left; then looping is what it was before. */
function useLooping(player: Player, looping: boolean): void {
  const before = useRef(looping)
  useEffect(() => {
    const was = before.current
    player.setRange(null)
    player.setLooping(true)
    return () => player.setLooping(was)
  }, [player])
}

function WillItBeHeard({ scene, moved }: { scene: Scene; moved: Moved }) {
  const heard = scene.lanes.filter((lane) => levelOf(lane, moved).isOn)
  const [lanes] = useDebouncedValue(
    heard.map((lane) => `${lane.id}:${levelOf(lane, moved).levelDb}`).join(' '),
    RESTS_MS,
  )
  const { data: masking } = useQuery(maskingQuery(scene.take_id, lanes.split(' ').filter(Boolean), scene.is_ready))
  const names = new Map(scene.lanes.map(({ id, name }) => [id, name]))
  return (
    <section className="grid gap-6px" aria-label="Will it be heard?">
      <p className="row between">
        <span className="strong">Will it be heard?</span>
        {masking?.is_measured && masking.is_compared && (
          <span className="small mid">
            {masking.heard_bands} of {plural(masking.part_bands, 'band')}, {figure(100 * masking.energy_share)} % of its
            energy
          </span>
        )}
      </p>
      {masking?.is_measured && masking.is_compared ? (
        <MaskingPlot masking={masking} names={names} name={scene.lanes[0]?.name ?? ''} />
      ) : (
        <p className="small mid">
          {masking?.is_measured ? masking.in_words : 'The sounds of the scene are being measured.'}
        </p>
      )}
    </section>
  )
}

interface LanesProps {
  scene: Scene
  moved: Moved
  onMoved: (moved: Moved) => void
  projectId: string
  player: Player
}

function Lanes({ scene, moved, onMoved, projectId, player }: LanesProps) {
  const { change, remove } = useBeds(projectId)
  const ref = useRef<HTMLDivElement>(null)
  useAt(ref, scene.length_s, undefined, player)
  const move = (lane: SceneLane, to: LaneLevel) => {
    onMoved(new Map(moved).set(lane.id, to))
    if (lane.bed && scene.may_change && to.isOn !== levelOf(lane, moved).isOn) {
      change.mutate({ id: lane.bed.id, is_on: to.isOn })
    }
  }
  const rest = (lane: SceneLane) => {
    const to = moved.get(lane.id)
    if (!lane.bed || !scene.may_change || to === undefined || to.levelDb === lane.bed.level_db) return
    change.mutate({ id: lane.bed.id, level_db: to.levelDb })
  }
  return (
    <div className={`relative border rounded ${classes.lanes}`} ref={ref}>
      <div className={classes.lanesHead}>
        <span className="small dim">Bed and neighbours</span>
        <LaneAxis lengthS={scene.length_s} player={player} />
        <span className="small dim">Level in the game</span>
      </div>
      <ul aria-label="Lanes">
        {scene.lanes.map((lane) => (
          <LaneRow
            key={lane.id}
            lane={lane}
            lengthS={scene.length_s}
            now={levelOf(lane, moved)}
            hasSpots={scene.has_spots}
            onLevel={(to) => move(lane, to)}
            onRest={() => rest(lane)}
            onRemove={lane.bed && scene.may_change ? () => remove.mutate(lane.bed?.id ?? '') : undefined}
          />
        ))}
      </ul>
      <i className={`absolute ${classes.head}`} aria-hidden="true" />
    </div>
  )
}
