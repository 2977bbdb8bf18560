import { Select } from '@mantine/core'
import { Link } from '@tanstack/react-router'
import { useState } from 'react'

import { ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { CopyButton } from '@/ui/CopyButton'

import classes from './Files.module.css'
import { pullCommands } from './pullCommands'

/** The commands that write the approved sounds into the game's source tree. */
export function PullCard({ projectId, targets }: { projectId: string; targets: readonly string[] }) {
  const [target, setTarget] = useState(targets[0] ?? '')
  const commands = pullCommands(window.location.origin, projectId, target).join('\n')
  return (
    <Card aria-labelledby="pull">
      <CardHead
        id="pull"
        title="Pull into your game"
        end={<CopyButton text={commands} what="Commands" variant="quiet" square aria-label="Copy the pull commands" />}
      />
      <div className="grid gap-3 p-inset">
        <p className="small mid">
          Run at the top of the game’s source tree. Only files whose sound changed are written, and{' '}
          <code className="mono">soundlist.lock</code> records them for version control.
        </p>
        {targets.length > 1 && (
          <Select
            label="Target to pull"
            data={[...targets]}
            value={target}
            onChange={(chosen) => chosen && setTarget(chosen)}
            allowDeselect={false}
          />
        )}
        {/* A long line scrolls, so the keyboard must reach it. */}
        {/* eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex */}
        <pre className={`${classes.preset} ${classes.commands}`} tabIndex={0} role="region" aria-label="Pull commands">
          {commands}
        </pre>
        <p className="small mid">
          Set <code className="mono">SOUNDLIST_TOKEN</code> to a token from{' '}
          <Link className="link" to="/projects/$projectId/tokens" params={{ projectId }}>
            Tokens
          </Link>
          . Add <code className="mono nowrap">--no-placeholders</code> as the release gate, and{' '}
          <code className="mono nowrap">--p4</code> or <code className="mono nowrap">--lfs-lock</code> for version
          control.
        </p>
        <div>
          <ButtonLink href={`/v1/projects/${projectId}/soundlist.pyz`} download>
            Download soundlist.pyz
          </ButtonLink>
        </div>
      </div>
    </Card>
  )
}
