import { type Player, type PlayerState, WaveThumb } from '@/audio'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { StatusBadge } from '@/ui/StatusBadge'

import { type OtherSound, useOtherSounds } from './otherSounds'
import classes from './Side.module.css'

export type Playing = [Player, PlayerState]

/** The sounds of other designers that this one may play. */
export function OtherSounds({ projectId, player }: { projectId: string; player: Playing }) {
  const { data, error, hasNextPage, isFetching, fetchNextPage } = useOtherSounds(projectId)
  const sounds = data?.pages.flatMap(({ items }) => items) ?? []
  if (error) return <Refusal error={error} />
  if (data && sounds.length === 0) {
    return (
      <p className="mid p-10px-inset">
        No sounds to hear. The studio decides which sounds of other designers you can play.
      </p>
    )
  }
  return (
    <>
      <ul aria-labelledby="other-sounds">
        {sounds.map((sound) => (
          <Sound key={sound.id} sound={sound} player={player} />
        ))}
      </ul>
      {hasNextPage && (
        <p className="p-10px-inset">
          <button type="button" className="link small" aria-busy={isFetching} onClick={() => void fetchNextPage()}>
            Show more
          </button>
        </p>
      )}
    </>
  )
}

function Sound({ sound, player: [player, { status, sourceId }] }: { sound: OtherSound; player: Playing }) {
  const { id, cue, preview_url: url } = sound
  const name = sound.variations > 1 ? `${cue.name}, variation ${sound.variation}` : cue.name
  const isPlaying = sourceId === id && (status === 'playing' || status === 'loading')
  const play = () => {
    player.pause()
    if (isPlaying || url === null) return
    void player.select({ id, url })
    void player.play(0)
  }
  return (
    <li className={`grid items-center border-b ${classes.other}`}>
      <Button
        square
        variant="quiet"
        icon={isPlaying ? 'pause' : 'play'}
        aria-label={`${isPlaying ? 'Pause' : 'Play'} ${name}`}
        disabled={url === null}
        onClick={play}
      />
      <div>
        <p className={`strong ${classes.cue}`}>{name}</p>
        <p className="small dim">{[sound.category, sound.is_palette ? 'palette' : ''].filter(Boolean).join(', ')}</p>
      </div>
      <WaveThumb peaks={sound.thumb} heightPx={28} />
      <StatusBadge kind={sound.is_approved ? 'approved' : 'to_review'} />
    </li>
  )
}
