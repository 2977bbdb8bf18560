import { useCallback } from 'react'

import { useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import type { Player, PlayerState } from '@/audio'

import { type Mend, type SoundBrief, useAskForMend, useMend, useSounds, useUseMend } from './api'

/** The take that a mend is of, as far as its player and its words need it. */
export interface MendedTake {
  id: string
  /** What sounds: its cue's name, or the file's. */
  name: string
  number: number | null
  previewUrl: string | null
}

export interface Mending {
  mend: Mend | undefined
  /** The mended copy, once it can be seen and heard. */
  sound: SoundBrief | null
  /** Which of the two is in the hand. */
  side: 'before' | 'mended'
  isPlaying: boolean
  isAsking: boolean
  isUsing: boolean
  error: unknown
  ask: () => void
  use: () => void
  /** Hear one of them, from a place by its own time. */
  hear: (side: 'before' | 'mended', fromS?: number) => void
  toggle: () => void
  /** The other one at the same position. */
  flip: () => void
}

/** A take and its mended copy: what is known of them, what can be heard of them, and the consent. */
export function useMending(
  take: MendedTake,
  player: Player,
  playing: PlayerState,
  { mayUse, group }: { mayUse: boolean; group: string },
): Mending {
  const { data: mend } = useMend(take.id)
  const { data: sounds } = useSounds(take.id, mend)
  const asking = useAskForMend(take.id)
  const using = useUseMend(take.id, ({ number, already_here }) =>
    showToast(
      already_here
        ? `${take.name} version ${number} has this sound already.`
        : `${take.name} version ${number} is the mend; it is being checked.`,
    ),
  )
  const use = () => using.mutate()
  const mendedId = `${take.id} mended`
  const sound = mend?.state === 'made' || mend?.state === 'used' ? (sounds?.mend ?? null) : null
  const side = playing.sourceId === mendedId ? 'mended' : 'before'
  const isPlaying = playing.status === 'playing' && (playing.sourceId === mendedId || playing.sourceId === take.id)
  const cutHeadS = mend?.cut_head_s ?? 0

  const sourceOf = useCallback(
    (wanted: 'before' | 'mended') => {
      const url = wanted === 'mended' ? sound?.preview_url : take.previewUrl
      return url ? { id: wanted === 'mended' ? mendedId : take.id, url } : null
    },
    [sound, take.previewUrl, take.id, mendedId],
  )
  const hear = useCallback(
    (wanted: 'before' | 'mended', fromS?: number) => {
      const source = sourceOf(wanted)
      if (source === null) return
      void player.select(source)
      void player.play(fromS)
    },
    [player, sourceOf],
  )
  const flip = () => {
    const other = side === 'mended' ? 'before' : 'mended'
    const source = sourceOf(other)
    if (source === null) return
    const laterS = other === 'mended' ? -cutHeadS : cutHeadS
    if (player.isPlaying()) void player.select(source, laterS)
    else hear(other, Math.max(0, player.positionS() + laterS))
  }
  const made = mend?.state === 'made'
  const canAsk = mayUse && (mend?.state === 'offered' || mend?.is_our_fault === true)
  useHotkeys([
    {
      keys: 't',
      label: made ? 'Use the mend' : 'Mend it',
      group,
      run: made ? use : () => asking.mutate(),
      disabled: !mayUse || using.isPending || asking.isPending || !(made || canAsk),
    },
    { keys: 'b', label: 'Before, mended', group, run: flip, disabled: sound === null },
  ])
  return {
    mend,
    sound,
    side,
    isPlaying,
    isAsking: asking.isPending,
    isUsing: using.isPending,
    error: using.error ?? asking.error,
    ask: () => asking.mutate(),
    use,
    hear,
    toggle: () => (isPlaying ? player.pause() : hear(side)),
    flip,
  }
}
