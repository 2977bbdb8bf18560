import { Link } from '@tanstack/react-router'
import { useState } from 'react'

import { useRoles } from '@/api/roles'
import { HotkeyButton, useHotkeys } from '@/app/keys'
import {
  type FindingMark,
  type Peaks,
  type Player,
  type PlayerState,
  spotOf as playFrom,
  Waveform,
  WaveThumb,
} from '@/audio'
import { spotOf, wordsOf, worstFirst } from '@/verdicts/findings'
import { MentionedText } from '@/verdicts/MentionedText'
import { usePeaks } from '@/verdicts/peaks'
import { FixPanel, type Fixing, useFixing } from '@/fixing'
import { ReferencesWhereAny } from '@/references/ReferencesWhereAny'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Avatar } from '@/ui/Avatar'
import { Refusal } from '@/ui/Refusal'
import { ago, length } from '@/ui/format'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { StatusBadge } from '@/ui/StatusBadge'

import { type CameBack, type Change, type Finding, useRecheck } from './api'
import { Conversation } from './Conversation'
import { FixAll } from './FixAll'
import classes from './CameBack.module.css'
import { FindingRow } from './FindingRow'
import type { DeskList } from './pages'

interface CameBackProps {
  projectId: string
  back: DeskList<CameBack>
  count: number
  player: Player
  playing: PlayerState
  /** Choose a file that goes to this cue. */
  onSendOwn: (cueId: string) => void
}

const changesOf = (item: CameBack) => item.changes as unknown as Change[]
const findingsOf = (item: CameBack) => worstFirst(item.findings as unknown as Finding[])
const thumbOf = ({ thumb }: CameBack): Peaks | null => thumb as unknown as Peaks | null

/** Hear a take, from a place in it where one is given. */
export function hear(player: Player, id: string, url: string, fromS?: number): void {
  void player.select({ id, url })
  void player.play(fromS)
}

/** What is with the designer again: one open with its marks, the others a line each. */
export function ReturnedTakesCard({ projectId, back, count, player, playing, onSendOwn }: CameBackProps) {
  const { items, hasMore, isFetching, showMore } = back
  const [openId, setOpenId] = useState<string | null>(null)
  const index = Math.max(
    0,
    items.findIndex(({ take_id }) => take_id === openId),
  )
  const open = items[index]
  const move = (by: number) => {
    if (hasMore && index + by === items.length) return showMore()
    const next = items[(index + by + items.length) % items.length]
    if (next) setOpenId(next.take_id)
  }
  const several = items.length > 1 || hasMore
  useHotkeys([
    { keys: 'j', label: 'Next returned version', group: 'Desk', run: () => move(1), disabled: !several },
    { keys: 'k', label: 'Previous returned version', group: 'Desk', run: () => move(-1), disabled: !several },
  ])
  return (
    <Card aria-labelledby="came-back">
      <CardHead
        id="came-back"
        title="Needs your fix"
        count={count > 0 ? count : undefined}
        end={<FixAll projectId={projectId} />}
      />
      {open !== undefined && (
        <p className={`${classes.roundNote} small dim wide-only`}>Automatic returns don’t count as revision rounds.</p>
      )}
      {open === undefined && (
        <div className="p-inset">
          <EmptyState head="Nothing to fix." level={3}>
            Versions returned by the automatic check, and changes the approver asks for, appear here.
          </EmptyState>
        </div>
      )}
      {items.map((item) =>
        item === open ? (
          <OpenTake
            key={item.take_id}
            projectId={projectId}
            item={item}
            player={player}
            playing={playing}
            onSendOwn={onSendOwn}
          />
        ) : (
          <ClosedTake key={item.take_id} item={item} onOpen={() => setOpenId(item.take_id)} />
        ),
      )}
      {hasMore && (
        <div className="p-inset">
          <Button aria-busy={isFetching} onClick={showMore}>
            More to fix
          </Button>
        </div>
      )}
    </Card>
  )
}

function Name({ item }: { item: CameBack }) {
  return <>{item.cue?.name ?? item.file_name}</>
}

interface OpenTakeProps extends Omit<CameBackProps, 'back' | 'count'> {
  item: CameBack
}

function OpenTake({ projectId, item, player, playing, onSendOwn }: OpenTakeProps) {
  const { cue, number, variation, since, status, preview_url: url, take_id: id } = item
  const findings = findingsOf(item)
  const changes = changesOf(item)
  const advice = item.comments.filter((one) => one.reply_to_id === null && one.change_request_id === null)
  const recheck = useRecheck(projectId)
  const roleOf = useRoles(projectId)
  const take = { id, name: cue?.name ?? item.file_name, number, previewUrl: url }
  const fixing = useFixing(take, player, playing, { mayUse: true, group: 'Desk' })
  const isMade = fixing.fix?.state === 'made'
  useHotkeys([{ keys: 'Space', label: 'Play, pause', group: 'Desk', run: fixing.toggle, disabled: url === null }])
  const marks = findings
    .filter(({ start_s }) => start_s !== null)
    .map((finding, index) => ({
      id: `${finding.code} ${index}`,
      severity: finding.severity,
      label: wordsOf(finding).head,
      startS: finding.start_s ?? 0,
      endS: finding.end_s ?? undefined,
    }))
  return (
    <article className={classes.open} aria-labelledby={`back-${id}`}>
      <div className={`flex wrap items-center ${classes.head}`}>
        <h3 id={`back-${id}`} className="title">
          <Name item={item} />
        </h3>
        <StatusBadge kind={status} pill />
        <span className="small dim">
          {cue && <span className="mono">{cue.label}</span>}
          {variation > 1 && `, _${String(variation).padStart(2, '0')}`}
          {number !== null && `, version ${number}`}, {ago(since)}
        </span>
      </div>
      {cue && <ReferencesWhereAny projectId={projectId} cueId={cue.id} />}
      {changes.length > 0 && (
        <ol className={`mt-6px ${classes.changes}`} aria-label="Requested changes">
          {changes.map((change, index) => (
            <li key={change.id}>
              <span className={`tone-change grid toned flex-none text-small ${classes.pin}`} aria-hidden="true">
                {index + 1}
              </span>
              <div className="grow">
                <p className="lead">“{change.text}”</p>
                <Conversation
                  projectId={projectId}
                  takeId={id}
                  noteId={change.id}
                  kind="change"
                  to="the approver"
                  replies={item.comments.filter((one) => one.change_request_id === change.id)}
                />
              </div>
              {change.start_s !== null && (
                <button
                  type="button"
                  className="link mono small mid nowrap"
                  disabled={url === null}
                  onClick={() => url !== null && hear(player, id, url, playFrom(change.start_s ?? 0))}
                >
                  {spotOf(change.start_s, change.end_s)}
                </button>
              )}
            </li>
          ))}
        </ol>
      )}
      {advice.length > 0 && (
        <ul className={`mt-6px ${classes.changes}`} aria-label="Comments">
          {advice.map((one) => (
            <li key={one.id}>
              <Avatar name={one.author.name} picture={one.author.picture} />
              <div className="grow">
                <p>
                  <span className="strong">{one.author.name}</span>{' '}
                  <span className="small dim">{roleOf(one.author.id)}</span>{' '}
                  <span className="small dim">{ago(one.created_at)}</span>
                </p>
                <p>
                  <MentionedText text={one.text} mentions={one.mentions} />
                </p>
                <Conversation
                  projectId={projectId}
                  takeId={id}
                  noteId={one.id}
                  kind="comment"
                  to={one.author.name}
                  comment={one}
                  replies={item.comments.filter((other) => other.reply_to_id === one.id)}
                />
              </div>
            </li>
          ))}
        </ul>
      )}
      {findings.length > 0 && (
        <ul className={`grid mt-6px ${classes.findings}`} aria-label="Check results">
          {findings.map((finding) => (
            <FindingRow
              key={`${finding.code} ${finding.start_s}`}
              finding={finding}
              onHear={
                url === null || finding.start_s === null
                  ? undefined
                  : () => hear(player, id, url, playFrom(finding.start_s ?? 0))
              }
            />
          ))}
        </ul>
      )}
      {item.round !== null && <p className="small mid">Round {item.round}.</p>}
      {status === 'unjudged' && (
        <p className="mt-6px">
          The check failed three times. That is our fault, not your file’s, and no round is counted.
        </p>
      )}
      <FixPanel
        take={take}
        durationS={item.duration_s}
        peaksUrl={item.peaks_url}
        fixing={fixing}
        player={player}
        findings={marks}
        limitDbfs={item.limit_dbfs ?? undefined}
        mayUse
        actions={
          <>
            {status === 'unjudged' && (
              <Button variant="primary" icon="turn" onClick={() => recheck.mutate(id)} disabled={recheck.isPending}>
                Run the check again
              </Button>
            )}
            {cue && (
              <HotkeyButton
                variant={status === 'unjudged' || isFixable(fixing) ? 'plain' : 'primary'}
                icon="upload"
                keys="s"
                keyLabel="Upload a new version of the selected one"
                keyGroup="Desk"
                onPress={() => onSendOwn(cue.id)}
              >
                Upload new version
              </HotkeyButton>
            )}
            {url !== null && (
              <Button icon={fixing.isPlaying ? 'pause' : 'play'} keys="Space" onClick={fixing.toggle}>
                {fixing.isPlaying ? 'Pause' : 'Play'}
              </Button>
            )}
            <Link className="link small" to="/takes/$takeId" params={{ takeId: id }}>
              All figures
            </Link>
          </>
        }
        follows={
          number !== null && `Your file becomes version ${number + 1}, whatever its name. Version ${number} is kept.`
        }
      >
        <Wave item={item} marks={marks} changes={changes} player={player} isHeard={playing.sourceId === id} />
      </FixPanel>
      {playing.error !== null && (playing.sourceId === id || isMade) && (
        <ErrorBanner detail="The sound could not be played." fix="Check your connection and try again." />
      )}
      <Refusal error={recheck.error} />
    </article>
  )
}

const isFixable = ({ fix }: Fixing): boolean => fix?.state === 'made' || fix?.state === 'offered'

interface WaveProps {
  item: CameBack
  marks: readonly FindingMark[]
  changes: readonly Change[]
  player: Player
  isHeard: boolean
}

function Wave({ item, marks, changes, player, isHeard }: WaveProps) {
  const { take_id: id, duration_s: durationS, preview_url: url } = item
  const peaks = usePeaks(item.peaks_url)
  if (durationS === null || url === null) {
    return (
      <p className="small mid">No waveform: the file could not be read as audio, or the waveform is being drawn.</p>
    )
  }
  const from = (s: number) => hear(player, id, url, s)
  return (
    <div className={classes.wave}>
      <Waveform
        label={item.cue?.name ?? item.file_name}
        peaks={peaks}
        durationS={durationS}
        heightPx={104}
        limitDbfs={item.limit_dbfs ?? undefined}
        clock={isHeard ? player : undefined}
        playheadS={0}
        onSeek={(s) => {
          void player.select({ id, url })
          player.seek(s)
        }}
        onMark={(fromS) => from(fromS)}
        findings={marks}
        comments={changes.flatMap(({ start_s, end_s }, index) =>
          start_s === null
            ? []
            : [{ id: String(index), number: index + 1, startS: start_s, endS: end_s === null ? undefined : end_s }],
        )}
      />
    </div>
  )
}

function ClosedTake({ item, onOpen }: { item: CameBack; onOpen: () => void }) {
  const changes = changesOf(item)
  const [first] = findingsOf(item)
  return (
    <article className={`grid items-center gap-4 ${classes.mini}`} aria-label={item.cue?.name ?? item.file_name}>
      <div>
        <p className="strong">
          <Name item={item} />
        </p>
        <StatusBadge kind={item.status} />
      </div>
      <div className={`flex items-center gap-14px min-w-0 ${classes.said}`}>
        <span className={`block bg-well flex-none relative border rounded narrow-w-full ${classes.thumb}`}>
          <WaveThumb peaks={thumbOf(item)} heightPx={32} />
          {item.duration_s !== null &&
            changes.map(
              ({ start_s }, index) =>
                start_s !== null && (
                  <i
                    key={index}
                    className={`absolute ${classes.note}`}
                    style={{ left: `${(start_s / (item.duration_s ?? 1)) * 100}%` }}
                  />
                ),
            )}
        </span>
        <p className="mid grow">
          {changes[0] ? `“${changes[0].text}”` : first ? `${wordsOf(first).head}. ${wordsOf(first).rest}` : ''}{' '}
          {item.duration_s !== null && <span className="small dim nowrap">{length(item.duration_s)}</span>}
        </p>
      </div>
      <Button onClick={onOpen}>
        Open <span className="visually-hidden">{item.cue?.name ?? item.file_name}</span>
      </Button>
    </article>
  )
}
