import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { ciQuery } from '@/api/project'
import { Card, CardHead } from '@/ui/Card'
import { CopyButton } from '@/ui/CopyButton'

/** The command by which a build audits its sounds and posts what it found. */
export function CiCommands({ projectId }: { projectId: string }) {
  const { data } = useQuery(ciQuery(projectId))
  if (data === undefined) return null
  const text = data.command
  return (
    <Card aria-labelledby="ci-commands">
      <CardHead
        id="ci-commands"
        title="CI command"
        end={<CopyButton text={text} what="Command" variant="quiet" square aria-label="Copy the command" />}
      />
      {/* A long line scrolls, so the keyboard must reach it. */}
      {/* eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex */}
      <pre className="code-lines border-b" tabIndex={0} role="region" aria-label="Command to copy">
        {text}
      </pre>
      <p className="small mid p-2-inset-3">
        For levels, give <code className="mono">--project</code> with the project of Wwise, FMOD, Unity, Unreal or Godot
        to <code className="mono">audio-checks audit</code>. Its steps are on the page of{' '}
        <Link className="link" to="/projects/$projectId/builds" params={{ projectId }}>
          builds
        </Link>
        .
      </p>
    </Card>
  )
}
