import { useMemo, useState } from 'react'

import { useMyProject } from '@/api/me'
import { useDraft } from '@/app/drafts'
import { HotkeyButton, useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import { type Peaks, Waveform } from '@/audio'
import { useTakePlayer } from '@/heard/useTakePlayer'
import { usePeaks } from '@/verdicts/peaks'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { plural, shortDay } from '@/ui/format'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { StatusBadge } from '@/ui/StatusBadge'

import { type AuditedSound, type AuditSummary, useAcceptDrift, useSendBack, useSoundHistory, useWithdraw } from './api'
import classes from './Drift.module.css'
import type { DriftGroup } from './groups'
import { louder } from './louder'
import { faceOf, isAudibleHere, signed, unheardOf, describeChange } from './words'

interface SoundDetailProps {
  group: DriftGroup
  audit: AuditSummary
  projectId: string
}

/** Before and after, what changed it, its history, and the decision. */
export function SoundDetail({ group, audit, projectId }: SoundDetailProps) {
  const { first, sounds } = group
  const project = useMyProject(projectId)
  const maySpeak = (project?.is_producer || project?.is_liaison || project?.is_approver) ?? false
  return (
    <div className={`grid gap-3 p-3 border-line-2 rounded bg-raised ${classes.detail}`}>
      {first.sound?.preview_url && <Pair sound={first} audit={audit} projectId={projectId} />}
      <p>{sentenceOf(first.message)}</p>
      <Parts sound={first} />
      {first.accepted && (
        <Accepted
          ids={sounds.flatMap(({ accepted }) => accepted?.id ?? [])}
          projectId={projectId}
          {...{ first, maySpeak }}
        />
      )}
      {first.task_id !== null && <p className="small mid">It was sent back: the task is with the implementers.</p>}
      {first.has_drifted && !first.accepted && maySpeak && (
        <Decision group={group} audit={audit} projectId={projectId} />
      )}
      <History projectId={projectId} path={first.path} />
    </div>
  )
}

const sentenceOf = (text: string): string =>
  text === '' ? '' : `${text.charAt(0).toUpperCase()}${text.slice(1)}${/[.?!]$/.test(text) ? '' : '.'}`

function Pair({ sound, audit, projectId }: { sound: AuditedSound; audit: AuditSummary; projectId: string }) {
  const [player, state] = useTakePlayer(projectId)
  const peaks = usePeaks(sound.sound?.peaks_url)
  const gainDb = sound.gain_db ?? 0
  const isAudible = isAudibleHere(sound)
  const now = useMemo<Peaks | null | undefined>(() => peaks && louder(peaks, gainDb), [peaks, gainDb])
  const heard = { url: sound.sound?.preview_url ?? '', takeId: sound.sound?.take_id }
  const durationS = sound.sound?.duration_s ?? 1
  const sources = {
    approved: { id: 'approved', ...heard, matchGainDb: 0 },
    built: { id: 'built', ...heard, matchGainDb: gainDb },
  }
  const isPlaying = (id: string) => state.status === 'playing' && state.sourceId === id
  const press = async (which: 'approved' | 'built') => {
    if (isPlaying(which)) return player.pause()
    await player.select(sources[which])
    if (!player.isPlaying()) await player.play()
  }
  useHotkeys([
    {
      keys: 'Space',
      label: 'Play or pause',
      group: 'Drift',
      run: () => void (state.status === 'playing' ? player.pause() : press(isAudible ? 'built' : 'approved')),
    },
    {
      keys: 'b',
      label: 'Approved, or as it plays',
      group: 'Drift',
      run: () => void press(state.sourceId === 'built' || !isAudible ? 'approved' : 'built'),
    },
  ])
  const rows = [
    { id: 'approved' as const, label: 'Approved', peaks, db: '+0.0 dB', shown: true },
    { id: 'built' as const, label: `Build ${audit.label}`, peaks: now, db: signed(gainDb), shown: isAudible },
  ]
  return (
    <>
      {rows
        .filter(({ shown }) => shown)
        .map((row) => (
          <div key={row.id} className={`grid items-center gap-3 ${classes.heard}`}>
            <Button
              square
              icon={isPlaying(row.id) ? 'pause' : 'play'}
              aria-label={`${isPlaying(row.id) ? 'Pause' : 'Play'} ${row.label}`}
              onClick={() => void press(row.id)}
            />
            <span className={row.id === 'built' ? 'strong' : undefined}>{row.label}</span>
            <div className={`min-w-0 ${classes.wave}`}>
              <Waveform
                plain
                still={state.sourceId !== row.id}
                clock={state.sourceId === row.id ? player : undefined}
                label={row.label}
                peaks={row.peaks}
                durationS={durationS}
                heightPx={44}
              />
            </div>
            <span className={`num ${row.id === 'built' ? 'strong' : 'mid'}`}>{row.db}</span>
          </div>
        ))}
      {state.error && <ErrorBanner detail={state.error} />}
      {unheardOf(sound) && <p className="small mid">{unheardOf(sound)}</p>}
    </>
  )
}

function Parts({ sound }: { sound: AuditedSound }) {
  const { file_db: fileDb, property_db: propertyDb, moves, events, depends } = sound
  return (
    <dl className={`small grid ${classes.facts}`}>
      {fileDb !== null && (
        <>
          <dt>File</dt>
          <dd>{signed(fileDb)}</dd>
        </>
      )}
      {propertyDb !== null && (
        <>
          <dt>Properties</dt>
          <dd>{signed(propertyDb)}</dd>
        </>
      )}
      {moves.map((move) => (
        <div key={`${move.object} ${move.property}`} className={classes.fact}>
          <dt>{move.property}</dt>
          <dd>
            <span className="mono">{move.object}</span>
            {`, ${signed(move.approved_db)} to ${signed(move.gain_db)}`}
            {move.changelist &&
              `, ${[
                move.changelist.id && `change ${move.changelist.id}`,
                move.changelist.on && shortDay(move.changelist.on),
                move.changelist.subject,
              ]
                .filter(Boolean)
                .join(', ')}`}
          </dd>
        </div>
      ))}
      {events.length > 0 && (
        <>
          <dt>Played by</dt>
          <dd className="mono">{events.join(', ')}</dd>
        </>
      )}
      {depends.length > 0 && (
        <>
          <dt>Depends on</dt>
          <dd>{depends.join(', ')}</dd>
        </>
      )}
    </dl>
  )
}

function Decision({ group, audit, projectId }: SoundDetailProps) {
  const { first, sounds } = group
  const [reason, setReason, draft] = useDraft(`drift:${audit.id}:${group.key}`, '')
  const accept = useAcceptDrift(projectId, audit.id)
  const sendBack = useSendBack(projectId, audit.id)
  const [isAsked, setAsked] = useState(false)
  const paths = sounds.map(({ path }) => path)
  const isBusy = accept.isPending || sendBack.isPending
  const gain = first.gain_db !== null && Math.abs(first.gain_db) >= 0.1 ? ` ${signed(first.gain_db)}` : ''
  const onAccept = () => {
    if (reason.trim() === '') {
      setAsked(true)
      document.getElementById('drift-reason')?.focus()
      return
    }
    accept.mutate(
      { paths, reason: reason.trim() },
      {
        onSuccess: () => {
          draft.discard()
          showToast(`${group.name}: accepted. It is asked again once it changes.`)
        },
      },
    )
  }
  const onSendBack = () =>
    sendBack.mutate(
      { paths, text: reason.trim() },
      {
        onSuccess: () => {
          draft.discard()
          showToast(`${group.name}: ${plural(paths.length, 'task')} for the implementers.`)
        },
      },
    )
  const error = accept.error ?? sendBack.error
  return (
    <>
      <div className={`grid items-center gap-2 ${classes.decision}`}>
        <label htmlFor="drift-reason" className="small">
          Reason, or what to do
        </label>
        <input
          id="drift-reason"
          className={`bg-raised w-full border-edge rounded ink font-inherit ${classes.text}`}
          value={reason}
          maxLength={1_000}
          aria-invalid={isAsked && reason.trim() === ''}
          aria-describedby={isAsked && reason.trim() === '' ? 'drift-reason-asked' : undefined}
          onChange={({ target }) => setReason(target.value)}
        />
        <HotkeyButton
          icon="tick"
          keys="a"
          keyLabel="Accept the drift"
          keyGroup="Drift"
          disabled={isBusy}
          onPress={onAccept}
        >
          {`Accept${gain}`}
        </HotkeyButton>
        <HotkeyButton
          variant="primary"
          icon="back"
          keys="s"
          keyLabel="Send back to the implementers"
          keyGroup="Drift"
          disabled={isBusy || first.task_id !== null}
          onPress={onSendBack}
        >
          Send back
        </HotkeyButton>
      </div>
      {isAsked && reason.trim() === '' && (
        <p id="drift-reason-asked" role="alert" className="small">
          An accepted drift needs a reason; your name and the date are saved with it.
        </p>
      )}
      <Refusal error={error} />
    </>
  )
}

interface AcceptedProps {
  first: AuditedSound
  ids: readonly string[]
  projectId: string
  maySpeak: boolean
}

function Accepted({ first, ids, projectId, maySpeak }: AcceptedProps) {
  const withdraw = useWithdraw(projectId)
  if (!first.accepted) return null
  const { reason, accepted_by: by, accepted_at: at } = first.accepted
  return (
    <div className="flex wrap items-center between gap-2-3">
      <p>
        <StatusBadge kind="waived">Accepted</StatusBadge> {reason}
        <span className="small dim">{` ${by.name}, ${shortDay(at)}`}</span>
      </p>
      {maySpeak && (
        <Button aria-busy={withdraw.isPending} onClick={() => withdraw.mutate(ids)}>
          Withdraw acceptance
        </Button>
      )}
      <Refusal error={withdraw.error} />
    </div>
  )
}

function History({ projectId, path }: { projectId: string; path: string }) {
  const { data } = useSoundHistory(projectId, path)
  if (data === undefined || data.length < 2) return null
  return (
    <details className="small">
      <summary className="pointer min-h-24px">{`In the last ${data.length} builds`}</summary>
      <ol className={classes.history}>
        {data.map((build) => (
          <li key={build.audit_id}>
            <span className="strong">{build.label}</span>
            <StatusBadge kind={faceOf(build)}>{describeChange(build)}</StatusBadge>
            <span className="num">{build.gain_db === null ? '' : signed(build.gain_db)}</span>
            <span className="dim">{shortDay(build.created_at)}</span>
          </li>
        ))}
      </ol>
    </details>
  )
}
