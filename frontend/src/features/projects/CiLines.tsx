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
    showToast(`${plural(lines.length, 'line')} for CI copied.`)
  }
  return <Button variant="quiet" square icon="copy" aria-label="Copy all lines for CI" onClick={() => void copy()} />
}

/** Everything that the game's CI runs, and what it needs and answers. */
export function CiCard({ projectId }: { projectId: string }) {
  const { data, error } = useQuery(ciQuery(projectId))
  return (
    <Card aria-labelledby="runs">
      <CardHead id="runs" title="What a build runs" end={data && <CopyLines lines={data.lines} />} />
      <Refusal error={error} />
      {data && (
        // A long line scrolls, so the keyboard must reach it.
        // eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex
        <pre className={classes.script} tabIndex={0} role="region" aria-label="Lines for CI">
          {data.lines.join('\n')}
        </pre>
      )}
      <dl className={`small ${classes.facts}`}>
        <dt>Token</dt>
        <dd>
          In the CI’s secrets, as <code className="mono">SOUNDLIST_TOKEN</code>. A producer makes it.
        </dd>
        <dt>Label</dt>
        <dd>
          <code className="mono">BUILD</code> and <code className="mono">COMMIT</code> name the build here.
        </dd>
        <dt>Exit code</dt>
        <dd>0 all conform, 1 something does not, 2 the tool was asked wrongly or broke.</dd>
      </dl>
    </Card>
  )
}
