import { useQuery } from '@tanstack/react-query'
import { specQuery } from '@/api/project'
import { cuesQuery } from '@/api/soundList'
import { Link } from '@tanstack/react-router'

import { ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { CopyButton } from '@/ui/CopyButton'
import { Refusal } from '@/ui/Refusal'
import { countOf, figure, shortDay } from '@/ui/format'
import { Icon } from '@/ui/Icon'
import { Table } from '@/ui/Table'

import { packsQuery, type Pack, type Project, type Spec } from '../api'
import { listed, canActForStudio } from '../words'
import { useChecks } from './checks'
import { targetLines, acceptLines, differences, kindOf, type Line, limitLines } from './say'
import classes from './SpecCard.module.css'
import { tableIn } from './tables'

/** What a file must be, in words: what a master may be, its limits, what is made from it. */
export function SpecCard({ project }: { project: Project }) {
  const { id: projectId, mine } = project
  const { data: spec, error } = useQuery(specQuery(projectId))
  const checks = useChecks()
  const { data: packs } = useQuery({ ...packsQuery(projectId), enabled: mine.is_team })
  return (
    <Card aria-labelledby="spec">
      <CardHead
        id="spec"
        title="Delivery spec"
        note={spec && `version ${spec.version}, ${shortDay(spec.created_at)}`}
        end={
          spec && (
            <>
              <Link
                className={`link ${classes.versions}`}
                to="/projects/$projectId/spec/versions"
                params={{ projectId }}
                search={{}}
              >
                Versions
              </Link>
              <CopyButton text={spec.toml} what="TOML" variant="quiet" aria-label="Copy TOML">
                TOML
              </CopyButton>
              <ButtonLink
                variant="quiet"
                square
                icon="download"
                aria-label="Download TOML"
                href={`/v1/projects/${projectId}/spec.toml`}
                download="spec.toml"
              />
              {canActForStudio(project) && (
                <ButtonLink component={Link} keys="e" to={`/projects/${projectId}/spec`}>
                  Change
                </ButtonLink>
              )}
            </>
          )
        }
      />
      <Refusal inset error={error} />
      {spec && (
        <>
          <div className={`grid narrow-grid-cols-1 ${classes.parts}`}>
            <Part head="Accepted masters" lines={acceptLines(spec)} />
            <Part head="Limits" lines={limitLines(spec, checks)} legend />
            <Part head="Game files, rendered from each master" lines={[...targetLines(spec), ...madeLine(packs)]} />
          </div>
          <Categories spec={spec} projectId={projectId} />
          {spec.warnings.map((warning) => (
            <p key={warning} className={`row small mid tone-warn border-t p-2-inset ${classes.warning}`}>
              <Icon name="triangle" />
              {warning}
            </p>
          ))}
        </>
      )}
    </Card>
  )
}

/** How many of the accepted sounds have their game files. */
function madeLine(packs: readonly Pack[] | undefined): Line[] {
  if (packs === undefined || packs.every(({ files, missing }) => files + missing.length === 0)) return []
  const rendered = packs.reduce((sum, { files }) => sum + files, 0)
  const whole = packs.reduce((sum, { files, missing }) => sum + files + missing.length, 0)
  return [
    {
      word: 'Rendered',
      value: `${countOf(rendered, whole)}${packs.length > 1 ? `, ${figure(packs.length)} targets` : ''}`,
    },
  ]
}

function Part({ head, lines, legend = false }: { head: string; lines: readonly Line[]; legend?: boolean }) {
  return (
    <section>
      <h3 className={`row between text-small leading-small dim ${classes.partHead}`}>
        {head}
        {legend && (
          <span className="row" aria-hidden="true">
            <span className="tone-bad toned inline-flex items-center gap-1">
              <Icon name="back" /> returns
            </span>
            <span className="tone-warn toned inline-flex items-center gap-1">
              <Icon name="triangle" /> warns
            </span>
          </span>
        )}
      </h3>
      <dl className={`grid gap-3px ${classes.pairs}`}>
        {lines.map(({ word, value, severity }) => (
          <div key={word}>
            <dt>{word}</dt>
            <dd>
              {value}
              {severity && (
                <span className={`${severity === 'error' ? 'tone-bad' : 'tone-warn'} ${classes.mark}`}>
                  <Icon name={severity === 'error' ? 'back' : 'triangle'} />
                  <span className="visually-hidden">{severity === 'error' ? ', returns' : ', warns'}</span>
                </span>
              )}
            </dd>
          </div>
        ))}
      </dl>
    </section>
  )
}

function Categories({ spec, projectId }: { spec: Spec; projectId: string }) {
  const { data: cues = [] } = useQuery(cuesQuery(projectId))
  const checks = useChecks()
  const counts = new Map<string, number>()
  for (const { category, state } of cues)
    if (category && state !== 'cut') counts.set(category, (counts.get(category) ?? 0) + 1)
  const named = Object.keys(tableIn(spec.tables.categories))
  const rows = [...new Set([...named, ...counts.keys()])].map((name) => ({
    name,
    cues: counts.get(name) ?? 0,
    kind: kindOf(spec.tables, name),
    differs: differences(spec.tables, name, checks),
  }))
  const isUsed = (row: { cues: number }) => counts.size === 0 || row.cues > 0
  const shown = rows.filter((row) => row.differs.length > 0 && isUsed(row))
  const plain = rows.filter((row) => row.differs.length === 0 && isUsed(row))
  const unused = rows.filter((row) => !isUsed(row))
  return (
    <>
      {shown.length > 0 && (
        <Table
          label="Rules by category"
          rows={shown}
          keyOf={({ name }) => name}
          columns={[
            { head: 'Category', rowHead: true, cell: ({ name }) => name },
            { head: 'Cues', numeric: true, cell: ({ cues: count }) => figure(count) },
            { head: 'Sounds are', wideOnly: true, cell: ({ kind }) => kind },
            { head: 'Differs in', cell: ({ differs }) => differs.join('; ') },
          ]}
        />
      )}
      {rows.length > 0 && (
        <p className="small mid border-t p-2-inset">
          {plain.length > 0 &&
            `General rules: ${listed(plain.map(({ name, cues: count }) => (count > 0 ? `${name} (${figure(count)})` : name)))}. `}
          {unused.length > 0 && `Not in the sound list: ${listed(unused.map(({ name }) => name))}.`}
        </p>
      )}
    </>
  )
}
