import { Link } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { ago, plural } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'
import { StatusBadge } from '@/ui/StatusBadge'

import { type Build, type BuildBrief, useBuildReport } from './api'
import classes from './Builds.module.css'
import { OUTCOME_STATES, outcomeInWords, outcomeOf, type RefusedFile, refusedFiles, warnedFiles } from './reports'

/** One build: its label, how it ended, when and what for. */
export function BuildLine({ build, children }: { build: Build | BuildBrief; children?: ReactNode }) {
  return (
    <div className={`grid items-center border-b ${classes.line}`}>
      <span className="strong cut-text">{build.label}</span>
      <StatusBadge kind={OUTCOME_STATES[outcomeOf(build)]}>{outcomeInWords(build)}</StatusBadge>
      <span className="small dim num">
        {[ago(build.created_at), build.target, build.commit.slice(0, 8)].filter(Boolean).join(', ')}
      </span>
      {children}
    </div>
  )
}

interface BuildReasonsProps {
  build: Build | BuildBrief
  projectId: string
  /** How many files are named before the rest is a number. */
  most?: number
}

/** The files a build was refused for, with every reason; of one that passed, what it warns of. */
export function BuildReasons({ build, projectId, most = 1000 }: BuildReasonsProps) {
  const { data: report, error, isPending } = useBuildReport(build.id)
  if (isPending) return <p className={`small dim ${classes.pending}`}>Reading the report…</p>
  if (error) return <Refusal error={error} />
  const refused = refusedFiles(report)
  const warned = warnedFiles(report)
  return (
    <>
      <Files files={refused.slice(0, most)} tone="bad" />
      {refused.length > most && (
        <Link className="link small" to="/projects/$projectId/builds" params={{ projectId }}>
          {`and ${plural(refused.length - most, 'file')} more`}
        </Link>
      )}
      {refused.length < most && <Files files={warned.slice(0, most - refused.length)} tone="warn" />}
      {refused.length + warned.length === 0 && (
        <p className="small mid">{`${plural(build.files, 'file')} checked, all conforming.`}</p>
      )}
    </>
  )
}

function Files({ files, tone }: { files: readonly RefusedFile[]; tone: 'bad' | 'warn' }) {
  if (files.length === 0) return null
  return (
    <ul
      className={`small grid gap-6px ${classes.files} tone-${tone}`}
      aria-label={tone === 'bad' ? 'Refused files' : 'Files with warnings'}
    >
      {files.map(({ path, reasons }) => (
        <li key={path}>
          <span className="mono wrap-anywhere">{path}</span>
          {reasons.map(({ odd, rest }) => (
            <p key={odd + rest}>
              <span className="toned">{odd}</span>
              <span className="mid">{rest}</span>
            </p>
          ))}
        </li>
      ))}
    </ul>
  )
}
