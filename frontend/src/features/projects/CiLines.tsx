import { useQuery } from '@tanstack/react-query'

import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { plural } from '@/ui/format'

import { ciQuery } from './api'
import classes from './Builds.module.css'
import { Refusal } from './Refusal'

export function CopyLines({ lines }: { lines: readonly string[] }) {
  const copy = async () => {
    await navigator.clipboard.writeText(lines.join('\n'))
    showToast(`${plural(lines.length, 'line')} copied.`)
  }
  return <Button variant="quiet" square icon="copy" aria-label="Copy all CI commands" onClick={() => void copy()} />
}

/** Everything that the game's CI runs, and what it needs and answers. */
export function CiCard({ projectId }: { projectId: string }) {
  const { data, error } = useQuery(ciQuery(projectId))
  return (
    <Card aria-labelledby="runs">
      <CardHead id="runs" title="CI commands" end={data && <CopyLines lines={data.lines} />} />
      <Refusal error={error} />
      {data && (
        // A long line scrolls, so the keyboard must reach it.
        // eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex
        <pre className={classes.script} tabIndex={0} role="region" aria-label="Commands to copy">
          {data.lines.join('\n')}
        </pre>
      )}
      <dl className={`small ${classes.facts}`}>
        <dt>Token</dt>
        <dd>
          Add it to the CI’s secrets as <code className="mono">SOUNDLIST_TOKEN</code>. Producers create it.
        </dd>
        <dt>Label</dt>
        <dd>
          <code className="mono">BUILD</code> and <code className="mono">COMMIT</code> name the build here.
        </dd>
        <dt>Exit code</dt>
        <dd>0: all files conform. 1: some don’t. 2: wrong usage or an internal error.</dd>
      </dl>
    </Card>
  )
}
