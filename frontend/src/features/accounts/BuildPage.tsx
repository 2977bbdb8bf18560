import { useQuery } from '@tanstack/react-query'
import { useParams } from '@tanstack/react-router'

import { ApiProblem } from '@/api'
import { ShellLink } from '@/app/shell/ShellLink'
import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ProblemNote } from '@/ui/ProblemNote'

import { ciLinesQuery } from './api'
import classes from './Build.module.css'
import { sentence } from './Form'

/** What the game's CI runs: the same spec and list, the same verdicts, no server at hand. */
export function BuildPage() {
  useTitle('Build')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/build' })
  const { data, error } = useQuery(ciLinesQuery(projectId))
  const script = data?.lines.join('\n') ?? ''
  const copy = async () => {
    await navigator.clipboard.writeText(script)
    showToast('The lines are copied.')
  }
  return (
    <div className="page">
      <h1>What the build runs</h1>
      <p className={`mid ${classes.intro}`}>
        The game’s CI fetches the spec and the sound list, checks the audio in its own checkout, and posts its report to
        this project. It sees no page: these lines are all of it.
      </p>
      {error && (
        <ProblemNote detail={sentence(error instanceof ApiProblem ? error.detail : 'The lines could not be read.')} />
      )}
      {data && (
        <Card aria-labelledby="ci-lines">
          <CardHead
            id="ci-lines"
            title="Shell lines"
            end={
              <Button icon="copy" variant="quiet" onClick={() => void copy()}>
                Copy
              </Button>
            }
          />
          <pre className={classes.lines}>{script}</pre>
        </Card>
      )}
      <dl className={classes.facts}>
        <dt>Token</dt>
        <dd>
          A producer makes one on the{' '}
          <ShellLink className="link" path={`/projects/${projectId}`}>
            project page
          </ShellLink>
          ; it goes into the CI’s secrets as <code className="mono">SOUNDLIST_TOKEN</code>.
        </dd>
        <dt>Exit code</dt>
        <dd>0 all conform, 1 something does not, 2 the tool was asked wrongly or broke.</dd>
        <dt>Report</dt>
        <dd>Every run stands on the project page, and a refused one on Today.</dd>
      </dl>
    </div>
  )
}
