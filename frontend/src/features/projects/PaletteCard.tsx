import { Link, type LinkProps } from '@tanstack/react-router'
import { useEffect, useRef, useState } from 'react'

import { useHotkeys } from '@/app/keys'
import { WaveThumb } from '@/audio'
import { useTakePlayer } from '@/heard/useTakePlayer'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { level } from '@/ui/format'
import { Icon } from '@/ui/Icon'

import type { PaletteSound } from './api'
import classes from './Palette.module.css'

type Peaks = React.ComponentProps<typeof WaveThumb>['peaks']

interface PaletteCardProps {
  projectId: string
  palette: readonly PaletteSound[]
  /** How many cues the list has. */
  cues: number
}

/** The sounds that set the tone, each to hear alone or all of them one after another. */
export function PaletteCard({ projectId, palette, cues }: PaletteCardProps) {
  const { playing, goesOn, error, play, stop } = useOneAfterAnother(projectId, palette)
  const heard = palette.filter(({ preview_url }) => preview_url !== null)
  const all = () => (goesOn ? stop() : play(heard[0]?.cue.id, true))
  useHotkeys([
    { keys: 'Space', label: 'Play the palette, pause', group: 'Project', run: all, disabled: heard.length === 0 },
  ])
  if (cues === 0) return null
  const list = `/projects/${projectId}/sound-list`
  return (
    <Card aria-labelledby="palette">
      <CardHead
        id="palette"
        title="Palette"
        note="reference sounds for the project"
        end={
          heard.length > 0 && (
            <Button variant="quiet" icon={goesOn ? 'pause' : 'play'} keys="Space" onClick={all}>
              {goesOn ? 'Pause' : 'Play all'}
            </Button>
          )
        }
      />
      {palette.length === 0 && (
        <div className="p-inset">
          <EmptyState
            head="No reference sounds yet"
            level={3}
            action={
              <Link className="link" to={list as LinkProps['to']}>
                Sound list
              </Link>
            }
          >
            Mark a few cues as palette in the sound list. Once delivered, they appear here as a reference for new
            sounds.
          </EmptyState>
        </div>
      )}
      <ul className={`grid overflow-hidden rounded-b-l ${classes.sounds}`}>
        {palette.map(({ cue, thumb, loudness_lufs, preview_url }) => (
          <li key={cue.id} className={`min-w-0 ${classes.sound}`} data-playing={playing === cue.id || undefined}>
            <Link className={`strong cut-text block ${classes.name}`} to={`${list}/cues/${cue.id}` as LinkProps['to']}>
              {cue.name}
            </Link>
            <button
              type="button"
              className={`block pointer w-full p-1-0 border-0 bg-none ${classes.play}`}
              aria-label={playing === cue.id ? `Pause ${cue.name}` : `Play ${cue.name}`}
              disabled={preview_url === null}
              onClick={() => (playing === cue.id ? stop() : play(cue.id, false))}
            >
              <WaveThumb peaks={thumb as Peaks} highlighted heightPx={44} />
            </button>
            <p className="row between small dim">
              {loudness_lufs === null ? 'too short to measure' : level(loudness_lufs, 'LUFS')}
              {playing === cue.id && <Icon name="play" />}
            </p>
          </li>
        ))}
      </ul>
      {error !== null && (
        <p role="alert" className="small p-2-inset">
          {error}
        </p>
      )}
    </Card>
  )
}

function useOneAfterAnother(projectId: string, palette: readonly PaletteSound[]) {
  const [player, { status, sourceId, error }] = useTakePlayer(projectId)
  const [goesOn, setGoesOn] = useState(false)
  const before = useRef(status)

  const play = (id: string | undefined, onwards: boolean) => {
    const sound = palette.find(({ cue }) => cue.id === id)
    if (!sound?.preview_url) return
    setGoesOn(onwards)
    player.pause()
    void player.select({ id: sound.cue.id, takeId: sound.take_id, url: sound.preview_url })
    void player.play(0)
  }
  const stop = () => {
    setGoesOn(false)
    player.pause()
  }
  const next = useRef(play)
  next.current = (_, onwards) => {
    const heard = palette.filter(({ preview_url }) => preview_url !== null)
    const at = heard.findIndex(({ cue }) => cue.id === sourceId)
    const after = heard[at + 1]
    if (after && onwards) play(after.cue.id, true)
    else setGoesOn(false)
  }

  // A sound that was not stopped has ended.
  useEffect(() => {
    const ended = before.current === 'playing' && status === 'paused'
    before.current = status
    if (ended && goesOn) next.current(undefined, true)
  }, [status, goesOn])

  const sounds = status === 'playing' || status === 'loading'
  return { playing: sounds ? sourceId : null, goesOn: goesOn && sounds, error, play, stop }
}
