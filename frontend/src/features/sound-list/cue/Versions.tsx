import { Link } from '@tanstack/react-router'

import { WaveThumb } from '@/audio'
import { NotHeard } from '@/heard/NotHeard'
import { reasonsText, sentence } from '@/verdicts/words'
import { Card, CardHead } from '@/ui/Card'
import { Finding } from '@/ui/Finding'
import { Refusal } from '@/ui/Refusal'
import { ago, length, place } from '@/ui/format'
import { StatusBadge, type StateKind } from '@/ui/StatusBadge'

import type { CueDetail, Take, Version } from '../api'
import classes from './Cue.module.css'
import { Reel } from './Reel'

const KIND_OF_TAKE = {
  received: 'checking',
  conforming: 'conforming',
  returned: 'returned',
  unjudged: 'unjudged',
  approved: 'approved',
  change_requested: 'change_requested',
  set_aside: 'set_aside',
} as const satisfies Record<Take['state'], StateKind>

interface VersionsProps {
  cue: CueDetail
  projectId: string
  versions: readonly Version[] | undefined
  /** The takes among them that the current person has not heard. */
  unheardIds: readonly string[]
  error: unknown
  playingId: string | null
  reviews: boolean
  onPlay: (version: Version) => void
}

/** Everything that was delivered for a cue, the newest first, with what the checker found. */
export function Versions({ cue, projectId, versions, unheardIds, error, playingId, reviews, onPlay }: VersionsProps) {
  return (
    <Card aria-labelledby="versions">
      <CardHead id="versions" title="Versions" count={versions?.length} end="newest first" />
      <Refusal error={error} />
      {versions?.length === 0 && <p className="small dim grid gap-3 p-3-inset-4">No versions yet.</p>}
      <ul>
        {versions?.map((version) => (
          <li key={version.take.id} className={`grid gap-6px border-b p-3-inset ${classes.version}`}>
            <Line
              cue={cue}
              projectId={projectId}
              version={version}
              unheard={unheardIds.includes(version.take.id)}
              playing={version.take.id === playingId}
              reviews={reviews}
              onPlay={onPlay}
            />
          </li>
        ))}
      </ul>
      {versions?.some(({ previewUrl }) => previewUrl !== null) && <Reel cueId={cue.id} cueName={cue.name} />}
    </Card>
  )
}

interface LineProps {
  cue: CueDetail
  projectId: string
  version: Version
  unheard: boolean
  playing: boolean
  reviews: boolean
  onPlay: (version: Version) => void
}

function Line({ cue, projectId, version, unheard, playing, reviews, onPlay }: LineProps) {
  const { take, thumb, previewUrl, durationS, findings } = version
  const variation = cue.variations > 1 ? `_${String(take.variation).padStart(2, '0')} ` : ''
  const name = `${variation}version ${take.number ?? ''}${
    take.alternate === null ? '' : ` ${String.fromCharCode(64 + take.alternate)}`
  }`
  const wave = <WaveThumb peaks={thumb} highlighted={playing} faded={take.state === 'set_aside'} heightPx={36} />
  return (
    <>
      <div className={`grid items-center gap-3 narrow-grid-cols-1-auto ${classes.versionHead}`}>
        <span>
          <span className="strong">{name.charAt(0).toUpperCase() + name.slice(1)}</span>{' '}
          {take.label !== null && <span className="small">{take.label} </span>}
          <span className="mono small dim">{take.file_name}</span> {unheard && <NotHeard inWords />}
        </span>
        <StatusBadge kind={KIND_OF_TAKE[take.state]} />
        <span className="small dim nowrap num">
          {durationS === null ? '' : `${length(durationS)}, `}
          {ago(take.received_at)}
        </span>
      </div>
      {take.verdict_reasons.length > 0 && (
        <p className="small mid">
          {take.state === 'approved' ? 'Approved' : 'Change requested'}: {reasonsText(take.verdict_reasons)}
        </p>
      )}
      {previewUrl === null ? (
        wave
      ) : (
        <button
          type="button"
          className="block pointer w-full p-0 border-0 bg-none"
          aria-label={`${playing ? 'Pause' : 'Play'} ${name}`}
          onClick={() => onPlay(version)}
        >
          {wave}
        </button>
      )}
      {take.note && <p className="small mid">{take.note}</p>}
      {findings.map((finding, at) => (
        <Finding
          key={`${finding.code} ${at}`}
          severity={finding.severity}
          head={sentence(finding.message)}
          where={finding.start_s === null ? undefined : place(finding.start_s)}
        >
          {finding.waived ? 'Waived by the approver. ' : ''}
          {sentence(finding.fix)}
          {finding.fix && !finding.fix.endsWith('.') ? '.' : ''}
        </Finding>
      ))}
      <Link className="link small" to="/takes/$takeId" params={{ takeId: take.id }}>
        All measurements<span className="visually-hidden"> of {name}</span>
      </Link>{' '}
      {reviews && (
        <Link
          className="link small"
          to="/projects/$projectId/review/$cueId"
          params={{ projectId, cueId: cue.id }}
          search={{ take: take.id }}
        >
          {take.state === 'conforming' ? 'Review' : 'Open in review'}
        </Link>
      )}
    </>
  )
}
