import { Link } from '@tanstack/react-router'
import { useEffect, useRef } from 'react'

import { ended, spotOf, wordsOf } from '@/verdicts/findings'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ago } from '@/ui/format'
import { Finding } from '@/ui/Finding'
import { Icon } from '@/ui/Icon'

import type { Check, Finding as Found, Take } from './api'
import classes from './Take.module.css'

interface FindingsCardProps {
  take: Take
  check: Check | null | undefined
  /** The worst first. */
  findings: readonly Found[]
  openAt: number | null
  onSpot: (at: number) => void
}

/** What the checker found, worst first: figure, limit, where, what to do, and what a fix does about it. */
export function FindingsCard({ take, check, findings, openAt, onSpot }: FindingsCardProps) {
  const list = useRef<HTMLUListElement>(null)
  useEffect(() => {
    if (openAt !== null) list.current?.children[openAt]?.scrollIntoView({ block: 'nearest' })
  }, [openAt])
  return (
    <Card aria-labelledby="findings">
      <CardHead
        id="findings"
        title="Check results"
        count={findings.length > 0 ? findings.length : undefined}
        end={
          check && (
            <span className="wide-only">
              spec version {check.spec_version}
              {check.is_newest_spec ? '' : ', not the newest'}, {ago(check.created_at)}
            </span>
          )
        }
      />
      {findings.length === 0 && (
        <p className="mid p-3-inset-14px">
          {check === undefined || take.state === 'received'
            ? 'Being checked…'
            : check === null
              ? 'Not checked yet.'
              : 'All checks passed.'}
        </p>
      )}
      <ul ref={list} className={classes.findings} aria-label="Findings">
        {findings.map((finding, at) => (
          <li
            key={`${finding.code} ${at}`}
            data-open={at === openAt || undefined}
            aria-current={at === openAt || undefined}
          >
            <Line finding={finding} onSpot={() => onSpot(at)} />
          </li>
        ))}
      </ul>
    </Card>
  )
}

function Line({ finding, onSpot }: { finding: Found; onSpot: () => void }) {
  const { head, rest } = wordsOf(finding)
  return (
    <Finding
      severity={finding.severity}
      head={head}
      where={spotOf(finding.start_s, finding.end_s) || undefined}
      actions={
        <>
          {finding.start_s !== null && (
            <Button icon="play" onClick={onSpot}>
              Go to position<span className="visually-hidden"> of {head}</span>
            </Button>
          )}
          <Link className="link small" to="/checks/$check" params={{ check: finding.check }}>
            {finding.check}
            <span className="visually-hidden">, about this check</span>
          </Link>
        </>
      }
    >
      {finding.waived && 'Waived by the approver. '}
      {rest}{' '}
      {finding.auto_fix && (
        <span className={`inline-flex items-baseline gap-1 strong ${classes.fixes}`}>
          <Icon name="spanner" size={14} /> A fix {finding.auto_fix}.
        </span>
      )}
      {finding.no_auto_fix && <span className="dim">{ended(finding.no_auto_fix)}</span>}
    </Finding>
  )
}
