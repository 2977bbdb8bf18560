import { NumberInput } from '@mantine/core'
import { useRef, useState } from 'react'

import { ButtonLink, Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { length, plural } from '@/ui/format'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { Segmented } from '@/ui/Segmented'

import { type Reel as Made, type ReelAdd, useReel } from '../api'
import classes from './Cue.module.css'

const SLATES = {
  spoken: 'The version number is spoken before each.',
  beeped: 'Beeps before each give its version number.',
  none: '',
} as const satisfies Record<Made['slates'], string>
const MAX_S = 5

/** All versions of a cue in a row, made when asked for; to be listened to, never for what ships. */
export function Reel({ cueId, cueName }: { cueId: string; cueName: string }) {
  const { ask, made: reel, making, error } = useReel(cueId)
  const [how, setHow] = useState<Required<ReelAdd>>({ gap_ms: 500, crossfade_ms: 0, slates: 'spoken', order: 'oldest' })
  return (
    <div className="grid gap-3 p-3-inset-4">
      <div className="row wrap">
        <Button icon="headphones" disabled={making} onClick={() => ask.mutate(how)}>
          Play all versions
        </Button>
        {reel?.file_url && (
          <ButtonLink href={reel.file_url} download={reel.file_name} icon="download">
            Download reel
          </ButtonLink>
        )}
      </div>
      <How how={how} onChange={setHow} />
      <p className="small dim" role="status">
        {making && `Building a reel of ${reel ? plural(reel.takes.length, 'version') : 'all versions'} …`}
        {reel?.file_url &&
          !making &&
          `${reel.takes.length === 1 ? 'One version' : `${reel.takes.length} versions`}, ${length(reel.duration_s ?? 0)}. ${SLATES[reel.slates]} For listening only: reels are not part of packs.`}
      </p>
      {reel?.file_url && !making && <Player key={reel.id} reel={reel} fileUrl={reel.file_url} cueName={cueName} />}
      {reel?.refusal && <ErrorBanner detail={reel.refusal} />}
      <Refusal error={error} />
    </div>
  )
}

interface HowProps {
  how: Required<ReelAdd>
  onChange: (how: Required<ReelAdd>) => void
}

/** What lies between the versions, what is said before each, and which comes first. */
function How({ how, onChange }: HowProps) {
  const join = how.crossfade_ms > 0 ? 'crossfade' : 'gap'
  const joined = (by: string, ms: number) =>
    onChange({ ...how, gap_ms: by === 'gap' ? ms : 0, crossfade_ms: by === 'gap' ? 0 : Math.max(ms, 1) })
  const ms = join === 'gap' ? how.gap_ms : how.crossfade_ms
  return (
    <details className="small">
      <summary className="pointer min-h-24px pt-3px">Playback options</summary>
      <div className={`row wrap ${classes.howFields}`}>
        <Segmented
          label="Between versions"
          options={[
            { value: 'gap', label: 'Gap' },
            { value: 'crossfade', label: 'Crossfade' },
          ]}
          value={join}
          onChange={(by) => joined(by, ms || 500)}
        />
        <NumberInput
          aria-label={join === 'gap' ? 'Gap length' : 'Crossfade length'}
          suffix=" s"
          min={join === 'gap' ? 0 : 0.1}
          max={MAX_S}
          step={0.1}
          decimalScale={2}
          clampBehavior="strict"
          w={92}
          value={ms / 1000}
          onChange={(value) => typeof value === 'number' && joined(join, Math.round(value * 1000))}
        />
        <Segmented
          label="Announce versions by"
          options={[
            { value: 'spoken', label: 'Spoken number' },
            { value: 'beeped', label: 'Beeps' },
            { value: 'none', label: 'Nothing' },
          ]}
          value={how.slates}
          onChange={(slates) => onChange({ ...how, slates })}
        />
        <Segmented
          label="Order"
          options={[
            { value: 'oldest', label: 'Oldest first' },
            { value: 'newest', label: 'Newest first' },
          ]}
          value={how.order}
          onChange={(order) => onChange({ ...how, order })}
        />
      </div>
    </details>
  )
}

/** The reel, and where each version begins in it. */
function Player({ reel, fileUrl, cueName }: { reel: Made; fileUrl: string; cueName: string }) {
  const audio = useRef<HTMLAudioElement>(null)
  const ofSet = new Set(reel.takes.map(({ variation }) => variation)).size > 1
  const playFrom = (startS: number) => {
    if (audio.current === null) return
    audio.current.currentTime = startS
    void audio.current.play()
  }
  return (
    <>
      {/* eslint-disable-next-line jsx-a11y/media-has-caption -- all that is said in it are numbers, which are on the page */}
      <audio ref={audio} className="w-full" src={fileUrl} controls autoPlay aria-label={`All versions of ${cueName}`} />
      <ol className="row wrap" aria-label="Versions in the reel">
        {reel.takes.map(({ take_id, variation, number, start_s }) => (
          <li key={take_id}>
            <Button variant="quiet" onClick={() => playFrom(start_s ?? 0)}>
              {ofSet && `_${String(variation).padStart(2, '0')} `}version {number}
              <span className="small dim">{length(start_s ?? 0)}</span>
            </Button>
          </li>
        ))}
      </ol>
    </>
  )
}
