import { Link } from '@tanstack/react-router'
import { useEffect, useRef, useState } from 'react'

import type { Player } from '@/audio'
import { figure } from '@/ui/format'
import { Select } from '@/ui/Select'

import { recordOpening, type SceneClip } from './api'
import { syncPicture } from './clipSync'
import classes from './Scene.module.css'

interface ClipViewProps {
  clips: readonly SceneClip[]
  projectId: string
  player: Player
}

/** The clip of the game, in time with what is heard; its own sound is off. */
export function ClipView({ clips, projectId, player }: ClipViewProps) {
  const [at, setAt] = useState(0)
  const clip = clips[at] ?? clips[0]
  if (clip === undefined) {
    return (
      <div className={classes.noClip}>
        <p>No clip of the game is pinned to this cue.</p>
        <Link className="link" to="/projects/$projectId/references" params={{ projectId }}>
          Add a clip
        </Link>
      </div>
    )
  }
  return (
    <div className={`grid gap-2 relative ${classes.clip}`}>
      <Picture key={clip.reference_version_id} clip={clip} player={player} />
      {clips.length > 1 && (
        <Select aria-label="Clip" value={at} onChange={(event) => setAt(Number(event.currentTarget.value))}>
          {clips.map((item, index) => (
            <option key={item.reference_id} value={index}>
              {nameOf(item)}
            </option>
          ))}
        </Select>
      )}
    </div>
  )
}

const nameOf = ({ caption, file_name }: SceneClip): string => caption || file_name

function Picture({ clip, player }: { clip: SceneClip; player: Player }) {
  const ref = useRef<HTMLVideoElement>(null)
  const timeRef = useRef<HTMLSpanElement>(null)
  const [state, setState] = useState<'waits' | 'open' | 'unplayable'>('waits')
  const { reference_version_id: versionId, start_s } = clip
  useEffect(() => {
    let isWanted = true
    recordOpening(versionId).then(
      () => isWanted && setState('open'),
      () => isWanted && setState('unplayable'),
    )
    return () => {
      isWanted = false
    }
  }, [versionId])
  useEffect(() => {
    const step = () => {
      const heardS = start_s + player.heardS()
      if (timeRef.current) timeRef.current.textContent = `${figure(heardS, 2)} s`
      if (ref.current && ref.current.readyState > 0) syncPicture(ref.current, heardS, player.isHeard())
    }
    step()
    const leave = [player.subscribe(step), player.subscribeState(step)]
    return () => leave.forEach((stop) => stop())
  }, [player, start_s, state])
  return (
    <>
      {state === 'unplayable' ? (
        <p className={classes.noPicture}>This browser can’t play {nameOf(clip)}. The sound plays without it.</p>
      ) : (
        <video
          ref={ref}
          src={state === 'open' ? `/v1/reference-versions/${versionId}/file` : undefined}
          muted
          playsInline
          preload="auto"
          aria-label={nameOf(clip)}
          onError={() => setState('unplayable')}
        />
      )}
      <span ref={timeRef} className={`mono small absolute rounded-s bg-raised ink ${classes.clipTime}`} />
    </>
  )
}
