import type { ReactNode } from 'react'

import { Button } from '@/ui/Button'

import { type Sample, verdictOf } from './samples'

interface SampleLineProps {
  sample: Sample
  playingId: string | null
  failedId: string | null
  onToggle: (id: string) => void
  /** Beside the sample: its removal. */
  children?: ReactNode
}

/** A sample of a bid: played here, with what the check said. */
export function SampleLine({ sample, playingId, failedId, onToggle, children }: SampleLineProps) {
  const isPlaying = playingId === sample.id
  const { words, tone } = verdictOf(sample)
  return (
    <div className="row">
      {sample.is_open && (
        <Button
          square
          icon={isPlaying ? 'pause' : 'play'}
          aria-label={`${isPlaying ? 'Pause' : 'Play'} ${sample.file_name}`}
          onClick={() => onToggle(sample.id)}
        />
      )}
      <span className="grow">
        <span className="mono small">{sample.file_name}</span>{' '}
        <span className={tone ? `small tone-${tone}` : 'small dim'}>
          <span className={tone ? 'toned' : undefined}>{words}</span>
        </span>
        {!sample.is_open && <span className="small dim"> no longer kept</span>}
        {failedId === sample.id && <span className="small tone-bad toned"> This browser cannot play it.</span>}
      </span>
      {children}
    </div>
  )
}
