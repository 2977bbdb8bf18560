import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { projectQuery } from '@/api/project'
import { useTitle } from '@/app/title'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { PageHead } from '@/ui/PageHead'
import { Refusal } from '@/ui/Refusal'

import { type Preset, type Target, targetsQuery } from './api'
import { BatchesCard } from './BatchesCard'
import classes from './Files.module.css'
import { MemoryBars } from './MemoryBars'
import { formatOf, keptAs } from './words'

/** The game files: each target with its memory, and the action that renders everything again. */
export function GameFilesPage() {
  useTitle('Game files')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/game-files' })
  const { data: project } = useQuery(projectQuery(projectId))
  const { data, error } = useQuery(targetsQuery(projectId))
  const mine = project?.mine
  const maySpeak = mine !== undefined && (mine.is_producer || mine.is_liaison || mine.is_approver)
  return (
    <div className="page stack">
      <PageHead title="Game files">
        Rendered from each master for the targets in{' '}
        <Link className="link" to="/projects/$projectId/spec" params={{ projectId }}>
          the spec
        </Link>
        , released as{' '}
        <Link className="link" to="/projects/$projectId/packs" params={{ projectId }}>
          packs
        </Link>
        . Sounds that are not accepted yet are in the{' '}
        <Link className="link" to="/projects/$projectId/placeholders" params={{ projectId }} search={{}}>
          list of placeholders
        </Link>
        .
      </PageHead>
      <Refusal inset error={error} />
      <div className="columns">
        <div className="stack">
          {data && <TargetsCard targets={data.targets} />}
          <BatchesCard projectId={projectId} maySpeak={maySpeak} />
        </div>
        <aside className="stack" aria-label="Engine presets">
          {data && <PresetsCard presets={data.presets} />}
        </aside>
      </div>
    </div>
  )
}

function TargetsCard({ targets }: { targets: readonly Target[] }) {
  return (
    <Card aria-labelledby="targets">
      <CardHead id="targets" title="Targets and memory" count={targets.length} />
      {targets.length === 0 && (
        <div className="p-3-inset">
          <EmptyState head="The spec has no targets" level={3}>
            Game files are rendered for targets. Add one to the spec; start from an engine preset.
          </EmptyState>
        </div>
      )}
      {targets.map((target) => (
        <section
          key={target.name}
          className="grid grid-cols-1 gap-6px border-b p-3-inset"
          aria-label={`Target ${target.name}`}
        >
          <p className="row wrap">
            <span className="strong">{target.name}</span>
            <span className="mid">{formatOf(target)}</span>
            <span className="small dim end">{keptAs(target)}</span>
          </p>
          {target.folder && (
            <p className="small mid">
              Files go in <span className="mono">{target.folder}</span>.
            </p>
          )}
          {target.engine && (
            <p className="small mid">
              {target.engine} accepts {target.accepts}. {target.why}
            </p>
          )}
          <MemoryBars target={target} />
        </section>
      ))}
    </Card>
  )
}

function PresetsCard({ presets }: { presets: readonly Preset[] }) {
  return (
    <Card aria-labelledby="presets">
      <CardHead id="presets" title="Engine presets" note="copy into the spec" />
      <ul>
        {presets.map(({ name, engine, accepts, why, toml }) => (
          <li key={name} className="grid grid-cols-1 gap-6px border-b p-3-inset">
            <p className="strong">{engine}</p>
            <p className="small mid">
              Accepts {accepts}. {why}
            </p>
            <details className="small">
              <summary className="pointer min-h-24px">
                Show TOML<span className="visually-hidden"> for {engine}</span>
              </summary>
              <pre className={classes.preset}>{toml}</pre>
            </details>
          </li>
        ))}
      </ul>
    </Card>
  )
}
