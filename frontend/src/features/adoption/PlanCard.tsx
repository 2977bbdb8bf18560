import type { ReactNode } from 'react'

import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { plural } from '@/ui/format'

import type { Plan } from './api'
import classes from './Adopt.module.css'

const SHOWN = 200

/** What adopting a folder does, file by file where something is unusual. */
export function PlanCard({
  plan,
  action,
  onAdopt,
  waits,
}: {
  plan: Plan
  action: string
  onAdopt: () => void
  /** Why it cannot be adopted yet. */
  waits?: string
}): ReactNode {
  const categories = Object.entries(plan.categories)
  const unused = plan.oddities.filter(({ code }) => code === 'unused')
  const unusual = plan.oddities.filter(({ code }) => code !== 'unused')
  const nothing = plan.cues.length === 0 ? 'No file of this folder becomes a cue.' : undefined
  const why = waits ?? nothing
  return (
    <Card aria-labelledby="plan">
      <CardHead id="plan" title="What happens to each file" />
      <div className="grid gap-3 p-3-inset-4">
        <p>
          {plural(plan.files, 'file becomes', 'files become')} {plural(plan.cues.length, 'cue')} in{' '}
          {plural(categories.length, 'category', 'categories')}, {plan.sets} of them{' '}
          {plan.sets === 1 ? 'a set' : 'sets'} of variations.
        </p>
        {categories.length > 0 && (
          <ul className="flex wrap gap-1-4" aria-label="Categories">
            {categories.map(([name, count]) => (
              <li key={name}>
                {name === '' ? 'no category' : name} <span className="dim">{count}</span>
              </li>
            ))}
          </ul>
        )}
        {plan.project && (
          <p>
            {plan.project.name} plays {plan.project.played} of these files. The level at which it plays each counts as
            approved.
          </p>
        )}
        <Files
          head="Files of the project that were not read"
          rows={(plan.project?.unread ?? []).map((line) => [line, ''])}
          isOpen
        />
        <Files head="Cues" rows={plan.cues.map((cue) => [cue.name, describe(cue)])} />
        <Files
          head="Not played by the game"
          rows={unused.map(({ path, message }) => [path, message])}
          note="They are adopted as well. Leave them out of the folder if the game no longer needs them."
          isOpen
        />
        <Files
          head="Unusual"
          rows={unusual.map(({ path, message }) => [path, message])}
          note="They are adopted as they are."
          isOpen
        />
        <Files
          head="The same bytes"
          rows={plan.duplicates.map(([first = '', ...more]) => [first, `also ${more.join(', ')}`])}
          note="Each file becomes a cue of its own."
          isOpen
        />
        <Files head="Not adopted" rows={plan.skipped.map(({ path, message }) => [path, message])} isOpen />
        <div className="flex wrap items-center gap-2-3">
          <Button variant="primary" disabled={why !== undefined} onClick={onAdopt}>
            {action}
          </Button>
          <span className="mid">{why ?? 'It can be undone while nothing is built on it.'}</span>
        </div>
      </div>
    </Card>
  )
}

const describe = ({ paths, loop, events }: Plan['cues'][number]): string =>
  [paths.join(', '), ...(loop ? ['loops'] : []), ...(events.length > 0 ? [`played by ${events.join(', ')}`] : [])].join(
    '; ',
  )

interface FilesProps {
  head: string
  note?: string
  rows: readonly (readonly [string, string])[]
  isOpen?: boolean
}

function Files({ head, note, rows, isOpen = false }: FilesProps): ReactNode {
  if (rows.length === 0) return null
  return (
    <details className={classes.files} open={isOpen && rows.length <= 20}>
      <summary>
        {head} <span className="dim">{rows.length}</span>
      </summary>
      {note && <p className="small dim">{note}</p>}
      <ul>
        {rows.slice(0, SHOWN).map(([name, says]) => (
          <li key={name}>
            <span className="mono">{name}</span> <span className="mid">{says}</span>
          </li>
        ))}
        {rows.length > SHOWN && <li className="dim">and {rows.length - SHOWN} more</li>}
      </ul>
    </details>
  )
}
