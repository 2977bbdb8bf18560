import { useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams, useSearch } from '@tanstack/react-router'
import { useState } from 'react'

import { projectQuery } from '@/api/project'
import { useHotkeys } from '@/app/keys'
import { useTitle } from '@/app/title'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { day } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { Row, Rows } from '@/ui/Rows'
import { Segmented } from '@/ui/Segmented'
import { Select } from '@/ui/Select'
import { ShowMore } from '@/ui/ShowMore'

import { specVersionQuery, useSpecTry, useSpecVersions } from '../api'
import { canActForStudio } from '../words'
import { draftOf, keepDraft } from './draft'
import { LineDiff } from './LineDiff'
import classes from './VersionsPage.module.css'

/** Every version of the spec: its text, and what it changed against another. */
export function VersionsPage() {
  useTitle('Versions of the spec')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/spec/versions' })
  const search = useSearch({ from: '/shell/projects/$projectId/spec/versions' })
  const navigate = useNavigate()
  const { data: project } = useQuery(projectQuery(projectId))
  const list = useSpecVersions(projectId)
  const { data, error } = list
  const versions = data?.pages.flatMap(({ items }) => items) ?? []
  const newest = versions[0]?.version
  const version = search.version ?? newest
  const against = search.against ?? (version !== undefined && version > 1 ? version - 1 : undefined)
  const show = (next: { version?: number; against?: number }) =>
    void navigate({ to: '/projects/$projectId/spec/versions', params: { projectId }, search: next, replace: true })
  const at = versions.findIndex((entry) => entry.version === version)
  const step = (by: number) => {
    const next = versions[at + by]
    if (next) show({ version: next.version })
  }
  useHotkeys([
    { keys: 'j', label: 'Next version', group: 'Versions', run: () => step(1) },
    { keys: 'k', label: 'Previous version', group: 'Versions', run: () => step(-1) },
  ])
  const takeUp = () => void navigate({ to: '/projects/$projectId/spec', params: { projectId } })
  return (
    <div className="page">
      <PageHead title="Versions of the delivery spec">
        <Link className="link" to="/projects/$projectId" params={{ projectId }}>
          {project?.name ?? 'Project'}
        </Link>
      </PageHead>
      <Refusal inset error={error} />
      <div className={`grid items-start gap-4 mid-grid-cols-1 ${classes.columns}`}>
        <Card aria-label="Versions">
          <Rows aria-label="Versions">
            {versions.map((entry) => (
              <Row key={entry.version} selected={entry.version === version} className={classes.version}>
                <button
                  type="button"
                  className={`grid wrap-anywhere flex-1 pointer p-2-4 border-0 bg-none ${classes.pick}`}
                  onClick={() => show({ version: entry.version })}
                >
                  <span className="strong">{`Version ${entry.version}`}</span>
                  <span className="small mid">{entry.note || 'No note.'}</span>
                  <span className="small dim">{`${entry.author.name}, ${day(entry.created_at)}`}</span>
                </button>
              </Row>
            ))}
          </Rows>
          {list.hasNextPage && (
            <div className="p-3-inset">
              <ShowMore list={list}>Earlier versions</ShowMore>
            </div>
          )}
        </Card>
        {version !== undefined && (
          <OneVersion
            key={version}
            projectId={projectId}
            version={version}
            against={against}
            numbers={Array.from({ length: newest ?? version }, (_, index) => (newest ?? version) - index)}
            onAgainst={(other) => show({ version, against: other })}
            newest={newest ?? version}
            onTakeUp={project && canActForStudio(project) ? takeUp : undefined}
          />
        )}
      </div>
    </div>
  )
}

interface OneVersionProps {
  projectId: string
  version: number
  against: number | undefined
  newest: number
  numbers: readonly number[]
  onAgainst: (version: number) => void
  onTakeUp?: () => void
}

function OneVersion({ projectId, version, against, newest, numbers, onAgainst, onTakeUp }: OneVersionProps) {
  const { data: spec, error } = useQuery(specVersionQuery(projectId, version))
  const { data: baseSpec, error: noOther } = useQuery({
    ...specVersionQuery(projectId, against ?? version),
    enabled: against !== undefined,
  })
  const { data: held } = useQuery({ ...specVersionQuery(projectId, newest), enabled: version !== newest })
  const [chosen, setChosen] = useState<'rules' | 'letters' | 'text'>('rules')
  const view = against === undefined ? 'text' : chosen
  // Serialised from their content, two texts differ only in content.
  const rules = useSpecTry(projectId, { tables: spec?.tables ?? {} }, spec !== undefined && view === 'rules').data
  const before = useSpecTry(
    projectId,
    { tables: baseSpec?.tables ?? {} },
    baseSpec !== undefined && view === 'rules',
  ).data
  const takeUp = () => {
    if (!spec || !held || !onTakeUp) return
    keepDraft(projectId, { ...draftOf(spec, 'toml'), basedOn: held.version, note: `As version ${version}` }, true)
    onTakeUp()
  }
  return (
    <Card aria-labelledby="version" className={classes.one}>
      <CardHead
        id="version"
        title={`Version ${version}`}
        note={version === newest ? 'current' : undefined}
        end={
          <>
            {against !== undefined && (
              <Segmented
                label="View"
                options={[
                  { value: 'rules', label: 'Changes' },
                  { value: 'letters', label: 'Line by line' },
                  { value: 'text', label: 'Text' },
                ]}
                value={view}
                onChange={setChosen}
              />
            )}
            {onTakeUp && held && version !== newest && <Button onClick={takeUp}>Restore this version</Button>}
          </>
        }
      />
      <Refusal inset error={error ?? noOther} />
      {view !== 'text' && numbers.length > 1 && (
        <p className="row wrap small mid p-2-inset">
          <label htmlFor="against">Compare with version</label>
          <Select id="against" value={against} onChange={({ currentTarget }) => onAgainst(Number(currentTarget.value))}>
            {numbers
              .filter((number) => number !== version)
              .map((number) => (
                <option key={number} value={number}>
                  {number}
                </option>
              ))}
          </Select>
        </p>
      )}
      {view === 'rules' && rules && before && (
        <LineDiff
          before={before.toml}
          after={rules.toml}
          label={`What version ${version} changed`}
          same="No rule changed; only comments and layout differ."
        />
      )}
      {view === 'letters' && spec && baseSpec && (
        <LineDiff
          before={baseSpec.toml}
          after={spec.toml}
          label={`Version ${baseSpec.version} compared with ${spec.version}`}
        />
      )}
      {view === 'text' && spec && (
        // A long line scrolls, so the keyboard must reach it.
        // eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex
        <pre className="code-lines" tabIndex={0} role="region" aria-label={`Text of version ${version}`}>
          {spec.toml}
        </pre>
      )}
    </Card>
  )
}
