import { useCallback } from 'react'

import { useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import type { Player, PlayerState } from '@/audio'

import { type Fix, type SoundBrief, useAskForFix, useFix, useSounds, useUseFix } from './api'

/** The take that a fix is of, as far as its player and its words need it. */
export interface FixedTake {
  id: string
  /** What sounds: its cue's name, or the file's. */
  name: string
  number: number | null
  previewUrl: string | null
}

export interface Fixing {
  fix: Fix | undefined
  /** The fixed copy, once it can be seen and heard. */
  sound: SoundBrief | null
  /** Which of the two is selected. */
  side: 'before' | 'fixed'
  isPlaying: boolean
  isAsking: boolean
  isUsing: boolean
  error: unknown
  ask: () => void
  use: () => void
  /** Hear one of them, from a place by its own time. */
  hear: (side: 'before' | 'fixed', fromS?: number) => void
  toggle: () => void
  /** The other one at the same position. */
  flip: () => void
}

/** A take and its fixed copy: what is known of them, what can be heard of them, and the consent. */
export function useFixing(
  take: FixedTake,
  player: Player,
  playing: PlayerState,
  { mayUse, group }: { mayUse: boolean; group: string },
): Fixing {
  const { data: fix } = useFix(take.id)
  const { data: sounds } = useSounds(take.id, fix)
  const asking = useAskForFix(take.id)
  const using = useUseFix(take.id, ({ number, already_here }) =>
    showToast(
      already_here
        ? `${take.name} version ${number} already has this sound.`
        : `${take.name} version ${number} is the fixed copy. It is being checked.`,
    ),
  )
  const use = () => using.mutate()
  const fixedId = `${take.id} fixed`
  const sound = fix?.state === 'made' || fix?.state === 'used' ? (sounds?.fix ?? null) : null
  const side = playing.sourceId === fixedId ? 'fixed' : 'before'
  const isPlaying = playing.status === 'playing' && (playing.sourceId === fixedId || playing.sourceId === take.id)
  const cutHeadS = fix?.cut_head_s ?? 0

  const sourceOf = useCallback(
    (version: 'before' | 'fixed') => {
      const url = version === 'fixed' ? sound?.preview_url : take.previewUrl
      if (!url) return null
      return version === 'fixed' ? { id: fixedId, url } : { id: take.id, takeId: take.id, url }
    },
    [sound, take.previewUrl, take.id, fixedId],
  )
  const hear = useCallback(
    (version: 'before' | 'fixed', fromS?: number) => {
      const source = sourceOf(version)
      if (source === null) return
      void player.select(source)
      void player.play(fromS)
    },
    [player, sourceOf],
  )
  const flip = () => {
    const otherSide = side === 'fixed' ? 'before' : 'fixed'
    const source = sourceOf(otherSide)
    if (source === null) return
    const laterS = otherSide === 'fixed' ? -cutHeadS : cutHeadS
    if (player.isPlaying()) void player.select(source, laterS)
    else hear(otherSide, Math.max(0, player.positionS() + laterS))
  }
  const isMade = fix?.state === 'made'
  const canAsk = mayUse && (fix?.state === 'offered' || fix?.is_our_fault === true)
  useHotkeys([
    {
      keys: 't',
      label: isMade ? 'Use auto-fix' : 'Make auto-fix',
      group,
      run: isMade ? use : () => asking.mutate(),
      disabled: !mayUse || using.isPending || asking.isPending || !(isMade || canAsk),
    },
    { keys: 'b', label: 'Original, fixed', group, run: flip, disabled: sound === null },
  ])
  return {
    fix,
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
