import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'

import { ciQuery } from './api'
import classes from './Drift.module.css'

/** The commands by which a build audits its sounds and posts what it found. */
export function CiCommands({ projectId }: { projectId: string }) {
  const { data } = useQuery(ciQuery(projectId))
  if (data === undefined) return null
  const text = data.lines.join('\n')
  const copy = async () => {
    await navigator.clipboard.writeText(text)
    showToast('Commands copied.')
  }
  return (
    <Card aria-labelledby="ci-commands">
      <CardHead
        id="ci-commands"
        title="CI commands"
        end={<Button variant="quiet" square icon="copy" aria-label="Copy the commands" onClick={() => void copy()} />}
      />
      {/* A long line scrolls, so the keyboard must reach it. */}
      {/* eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex */}
      <pre className={classes.script} tabIndex={0} role="region" aria-label="Commands to copy">
        {text}
      </pre>
      <p className={`small mid ${classes.foot}`}>
        For levels, add <code className="mono">--project</code> with the project of Wwise, FMOD, Unity, Unreal or Godot
        to <code className="mono">audio-checks audit</code>. Tokens are on the page of{' '}
        <Link className="link" to="/projects/$projectId/builds" params={{ projectId }}>
          builds
        </Link>
        .
      </p>
    </Card>
  )
}
