import { useQuery } from '@tanstack/react-query'

import { ciQuery } from '@/api/project'
import { Card, CardHead } from '@/ui/Card'
import { CopyButton } from '@/ui/CopyButton'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'

import classes from './Builds.module.css'

export function CopyLines({ lines, label }: { lines: readonly string[]; label: string }) {
  return (
    <CopyButton text={lines.join('\n')} what={plural(lines.length, 'line')} variant="quiet" square aria-label={label} />
  )
}

/** The one line that the game's CI runs, its steps by hand, and what they need and answer. */
export function CiCard({ projectId }: { projectId: string }) {
  const { data, error } = useQuery(ciQuery(projectId))
  return (
    <Card aria-labelledby="runs">
      <CardHead
        id="runs"
        title="CI command"
        end={data && <CopyLines lines={[data.command]} label="Copy the CI command" />}
      />
      <Refusal inset error={error} />
      {data && (
        <>
          {/* A long line scrolls, so the keyboard must reach it. */}
          {/* eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex */}
          <pre className="code-lines border-b" tabIndex={0} role="region" aria-label="Command to copy">
            {data.command}
          </pre>
          <p className={`small mid border-b p-3-4 m-0 ${classes.steps}`}>
            It fetches spec, list and baseline, checks, audits and posts the build.{' '}
            <code className="mono">audio-checks</code> must be installed.
          </p>
          <details className={`border-b p-3-4 m-0 ${classes.steps}`}>
            <summary className="small">The same steps with curl</summary>
            <CopyLines lines={data.lines} label="Copy all steps" />
            {/* eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex */}
            <pre className="code-lines border-b" tabIndex={0} role="region" aria-label="Steps to copy">
              {data.lines.join('\n')}
            </pre>
          </details>
        </>
      )}
      <dl className={`small grid gap-1-3 p-3-4 ${classes.facts}`}>
        <dt>Token</dt>
        <dd>
          Add it to the CI’s secrets as <code className="mono">SOUNDLIST_TOKEN</code>. Producers create it.
        </dd>
        <dt>Label</dt>
        <dd>
          <code className="mono">BUILD</code> and <code className="mono">COMMIT</code>, or the numbers of the CI, name
          the build here.
        </dd>
        <dt>Exit code</dt>
        <dd>0: all files conform. 1: some don’t. 2: wrong usage or an internal error.</dd>
      </dl>
    </Card>
  )
}
