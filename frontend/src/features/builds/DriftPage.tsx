import { useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams, useSearch } from '@tanstack/react-router'
import { type ReactNode, useMemo, useState } from 'react'

import { useHotkeys } from '@/app/keys'
import { useTitle } from '@/app/title'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { ago, countOf, plural } from '@/ui/format'
import { KeysLine } from '@/ui/KeysLine'
import { Segmented } from '@/ui/Segmented'
import { StatusBadge } from '@/ui/StatusBadge'

import { type AuditSummary, auditsQuery, useAudit, useAuditedSounds } from './api'
import { CiCommands } from './CiCommands'
import classes from './Drift.module.css'
import { groupsOf } from './groups'
import { InGameCard } from './InGameCard'
import { SoundRow } from './SoundRow'
import { TasksCard } from './TasksCard'
import { auditInWords, OUTCOME_STATES, outcomeOf } from './words'

type Shown = 'drift' | 'accepted' | 'all'
const GROUP = 'Drift'

/** How a build plays the approved sounds: what drifted, what changed it, and what to do about it. */
export function DriftPage(): ReactNode {
  const { projectId = '' } = useParams({ strict: false })
  const { audit: auditId } = useSearch({ from: '/shell/projects/$projectId/drift' })
  const { data, error, isPending } = useQuery(auditsQuery(projectId))
  const audits = data?.items
  const audit = audits?.find(({ id }) => id === auditId) ?? audits?.[0]
  const navigate = useNavigate()
  useTitle(audit ? `Build ${audit.label}` : 'In-game levels')
  useHotkeys([
    {
      keys: 'g h',
      label: 'Listening pass',
      group: GROUP,
      run: () => void navigate({ to: '/projects/$projectId/listening', params: { projectId } }),
    },
  ])
  return (
    <div className="page stack" aria-busy={isPending}>
      <Refusal error={error} />
      {audit === undefined ? <h1>In-game levels</h1> : <Head audit={audit} projectId={projectId} />}
      {audits?.length === 0 && <NoAudit projectId={projectId} />}
      {audit && audits && (
        <div className={`columns ${classes.columns}`}>
          <div className="stack">
            <HistoryCard audits={audits} current={audit} projectId={projectId} />
            <DriftCard key={audit.id} audit={audit} projectId={projectId} />
          </div>
          <div className="stack">
            <InGameCard projectId={projectId} />
            <TasksCard projectId={projectId} most={5} />
            <BuildsCard audits={audits} current={audit} projectId={projectId} />
            <CiCommands projectId={projectId} />
          </div>
        </div>
      )}
    </div>
  )
}

function Head({ audit, projectId }: { audit: AuditSummary; projectId: string }) {
  const { data } = useAudit(projectId, audit.id)
  const asApproved = audit.sounds - audit.drifted - (data?.depends ?? 0)
  const words = [
    `${countOf(asApproved, audit.sounds)} ${audit.sounds === 1 ? 'sound plays' : 'sounds play'} as approved`,
    audit.drifted > 0 ? `${plural(audit.drifted, 'sound')} drifted` : '',
    data && data.depends > 0 ? `${plural(data.depends, 'level depends', 'levels depend')} on the game’s state` : '',
  ].filter(Boolean)
  return (
    <header className="flex wrap items-end between gap-2-4">
      <div>
        <h1>Build {audit.label}</h1>
        <p className="mid">{`Audited ${ago(audit.created_at)}. ${words.join('; ')}.`}</p>
        {audit.engine === '' && (
          <p className="small mid">Only files were compared: run the audit with --project to compare levels too.</p>
        )}
        {data?.unread.map(({ file, line, message }) => (
          <p key={`${file}:${line}`} className="small">
            <StatusBadge kind="warning">Not read</StatusBadge>{' '}
            <span className="mono">{line > 0 ? `${file}:${line}` : file}</span>
            {`: ${message}. The rest was compared.`}
          </p>
        ))}
      </div>
      <KeysLine
        keys={[
          { keys: ['j', 'k'], label: 'sounds' },
          { keys: ['b'], label: 'approved, as it plays' },
          { keys: ['a'], label: 'accept drift' },
          { keys: ['s'], label: 'send back' },
          { keys: ['g h'], label: 'listen' },
        ]}
      />
    </header>
  )
}

function NoAudit({ projectId }: { projectId: string }) {
  return (
    <>
      <EmptyState head="No build was audited yet">
        The game’s CI compares its sounds with the approved ones and posts what it finds. It needs a token in its
        secrets as SOUNDLIST_TOKEN, which a producer creates on the page of builds, and these commands.
      </EmptyState>
      <CiCommands projectId={projectId} />
    </>
  )
}

interface OfAudits {
  audits: readonly AuditSummary[]
  current: AuditSummary
  projectId: string
}

/** One bar a build, the oldest first: height and colour say how it went, and words for those who listen. */
function HistoryCard({ audits, current, projectId }: OfAudits) {
  const counts = { passed: 0, warned: 0, refused: 0 }
  for (const audit of audits) counts[outcomeOf(audit)] += 1
  return (
    <Card aria-labelledby="history">
      <CardHead
        id="history"
        title="History"
        note={`last ${audits.length}: ${counts.passed} as approved, ${counts.warned} with known drift, ${counts.refused} with new drift`}
      />
      <ul className={`flex items-end gap-3px p-3-4 ${classes.bars}`}>
        {audits.toReversed().map((audit) => (
          <li key={audit.id}>
            <Link
              to="/projects/$projectId/drift"
              params={{ projectId }}
              search={{ audit: audit.id }}
              resetScroll={false}
              className={`block rounded-2px ${classes.bar}`}
              data-outcome={outcomeOf(audit)}
              aria-current={audit.id === current.id || undefined}
              title={`${audit.label}: ${auditInWords(audit)}`}
            >
              <span className="visually-hidden">{`Build ${audit.label}: ${auditInWords(audit)}`}</span>
            </Link>
          </li>
        ))}
      </ul>
    </Card>
  )
}

function BuildsCard({ audits, current, projectId }: OfAudits) {
  return (
    <Card aria-labelledby="audited">
      <CardHead
        id="audited"
        title="Builds"
        end={
          <Link className="link" to="/projects/$projectId/builds" params={{ projectId }}>
            All builds
          </Link>
        }
      />
      <ul>
        {audits.slice(0, 8).map((audit) => (
          <li key={audit.id}>
            <Link
              to="/projects/$projectId/drift"
              params={{ projectId }}
              search={{ audit: audit.id }}
              className={`grid items-center gap-3 hover p-2-inset border-b ${classes.build}`}
              aria-current={audit.id === current.id || undefined}
            >
              <span className="strong cut-text">{audit.label}</span>
              <StatusBadge kind={OUTCOME_STATES[outcomeOf(audit)]}>{auditInWords(audit)}</StatusBadge>
              <span className="small dim">{ago(audit.created_at)}</span>
            </Link>
          </li>
        ))}
      </ul>
    </Card>
  )
}

function DriftCard({ audit, projectId }: { audit: AuditSummary; projectId: string }) {
  const [shown, setShown] = useState<Shown>('drift')
  const [selected, setSelected] = useState(0)
  const { data: drifted } = useAuditedSounds(projectId, audit.id, true)
  const { data: all } = useAuditedSounds(projectId, shown === 'all' ? audit.id : undefined, false)
  const groups = useMemo(() => {
    const sounds =
      shown === 'all' ? all : drifted?.filter(({ accepted }) => (accepted !== null) === (shown === 'accepted'))
    return sounds && groupsOf(sounds)
  }, [shown, all, drifted])
  const accepted = drifted?.filter((sound) => sound.accepted !== null).length ?? 0
  const last = (groups?.length ?? 0) - 1
  const at = Math.min(selected, Math.max(0, last))
  useHotkeys([
    { keys: 'j', label: 'Next sound', group: GROUP, run: () => setSelected(Math.min(last, at + 1)), repeats: true },
    { keys: 'k', label: 'Previous sound', group: GROUP, run: () => setSelected(Math.max(0, at - 1)), repeats: true },
  ])
  return (
    <Card aria-labelledby="drift" aria-busy={groups === undefined}>
      <CardHead
        id="drift"
        title="Drift"
        note="where it differs from the approved sounds"
        end={
          <Segmented
            label="Shown"
            value={shown}
            onChange={(value) => {
              setShown(value)
              setSelected(0)
            }}
            options={[
              { value: 'drift', label: `Drift ${(drifted?.length ?? audit.drifted) - accepted}` },
              { value: 'accepted', label: `Accepted ${accepted}` },
              { value: 'all', label: `All ${audit.sounds}` },
            ]}
          />
        }
      />
      {groups?.length === 0 && (
        <div className="grid gap-2 p-3-inset">
          <EmptyState head={shown === 'accepted' ? 'No drift is accepted' : nothingDrifted(audit)} level={3}>
            {shown === 'accepted'
              ? 'What is accepted stands here with its reason, and is asked again once it changes.'
              : 'A sound that changes its level or its file will be listed here with what changed it.'}
          </EmptyState>
        </div>
      )}
      {groups && groups.length > 0 && (
        <>
          <div className={`wide-only micro dim border-b ${classes.columnsHead}`} aria-hidden="true">
            <span>Sound</span>
            <span>What</span>
            <span>Where</span>
            <span>Changelist</span>
            <span className="num">Plays at</span>
          </div>
          <ol>
            {groups.map((group, index) => (
              <SoundRow
                key={group.key}
                group={group}
                audit={audit}
                projectId={projectId}
                isOpen={index === at}
                onOpen={() => setSelected(index)}
              />
            ))}
          </ol>
        </>
      )}
    </Card>
  )
}

const nothingDrifted = ({ sounds, drifted }: AuditSummary): string =>
  drifted > 0
    ? 'All drift is accepted'
    : sounds === 0
      ? 'This build has no sounds'
      : `No drift in ${plural(sounds, 'sound')}`
