import { useQuery } from '@tanstack/react-query'

import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { ago, bytes, plural } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'

import { keptQuery, operationsQuery, type Scope, type Storage } from './api'
import classes from './Operations.module.css'
import { isDamaged, laneKey, laneLine, laneWords, scrubLine } from './words'

const NAMES: Record<Storage['kept'][number]['kind'], string> = {
  masters: 'master',
  dry_stems: 'dry stem',
  source_files: 'source file',
  archives: 'ZIP file',
  game_files: 'game file',
  drawings: 'preview',
  fixes: 'fixed file',
  reels: 'reel',
  exports: 'exported master',
  placeholder_files: 'placeholder',
  references: 'reference file',
  guest_copies: 'copy for guests',
  roster_reels: 'reel or bid sound',
  documents: 'document',
  uploads: 'upload',
}
const keptWords = ({ kept }: Storage) =>
  kept.map(({ kind, files, size_bytes }) => `${plural(files, NAMES[kind])} ${bytes(size_bytes)}`).join(', ')

/** What is kept: masters as they came, game files as they were made, and what goes with them. */
export function StorageCard({ scope }: { scope: Scope }) {
  const { data, error } = useQuery(keptQuery(scope))
  const studios = data?.studios ?? []
  const whole = studios.reduce((sum, { size_bytes }) => sum + size_bytes, 0)
  const free = data?.freeBytes ?? null
  return (
    <Card aria-labelledby="storage">
      <CardHead
        id="storage"
        title="Storage"
        note={data && `${bytes(whole)}${free === null ? '' : `, ${bytes(free)} free on the disk`}`}
      />
      {error && (
        <div className="p-inset">
          <Refusal error={error} />
        </div>
      )}
      {data && scope === 'server' && (
        <p className={`${data.scrub && isDamaged(data.scrub) ? 'strong' : 'mid'} p-inset`}>{scrubLine(data.scrub)}</p>
      )}
      <Rows aria-labelledby="storage">
        {studios.map((studio) => (
          <Row key={studio.studio_id} className={classes.kept}>
            <span className="grow">
              <span className="strong">{studio.studio_name}</span>
              <br />
              <span className="small dim">{keptWords(studio) || 'Nothing stored yet.'}</span>
            </span>
            <span className="num">{bytes(studio.size_bytes)}</span>
          </Row>
        ))}
      </Rows>
    </Card>
  )
}

/** Who waits in which lane: studios take turns, and what people wait for goes before thousands of re-renders. */
export function LanesCard({ scope }: { scope: Scope }) {
  const { data } = useQuery(operationsQuery(scope))
  if (data === undefined) return null
  return (
    <Card aria-labelledby="lanes">
      <CardHead id="lanes" title="Queues" count={data.lanes.length} note="served in turn" />
      {data.lanes.length === 0 ? (
        <p className="mid p-inset">No queued jobs.</p>
      ) : (
        <Rows aria-labelledby="lanes">
          {data.lanes.map((lane) => (
            <Row key={laneKey(lane)}>
              <span className="grow">
                <span className="strong">{laneWords(lane, scope)}</span>
                <br />
                <span className="small dim">{laneLine(lane)}</span>
              </span>
            </Row>
          ))}
        </Rows>
      )}
    </Card>
  )
}

/** The processes that do the jobs: each for an operator, their number for a producer. */
export function WorkersCard({ scope }: { scope: Scope }) {
  const { data } = useQuery(operationsQuery(scope))
  if (data === undefined) return null
  return (
    <Card aria-labelledby="workers">
      <CardHead id="workers" title="Workers" count={data.alive} />
      {data.workers.length === 0 ? (
        <p className="mid p-inset">
          {data.alive > 0
            ? 'Workers check, render and send email for all studios.'
            : 'No worker is running: none has reported in the last 20 seconds. The operator can start one with: soundlist worker'}
        </p>
      ) : (
        <Rows aria-labelledby="workers">
          {data.workers.map(({ id, beat_at, is_alive, running }) => (
            <Row key={id} dense>
              <span className="grow font-mono wrap-anywhere">{id}</span>
              <span className="small dim">
                {is_alive ? (running > 0 ? `${plural(running, 'job')} running` : 'free') : `last seen ${ago(beat_at)}`}
              </span>
            </Row>
          ))}
        </Rows>
      )}
    </Card>
  )
}
