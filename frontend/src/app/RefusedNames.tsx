import { useQuery, useQueryClient } from '@tanstack/react-query'
import { Link, type LinkProps } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { post, queryById, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'
import { Icon } from '@/ui/Icon'

export type RefusedNames = components['schemas']['RefusedNames']

const SHOWN = 5

const refusedNamesQuery = queryById(
  '/v1/projects/{project_id}/sound-list/refused-names',
  (projectId) => queryKeys.soundList(projectId, 'refused names'),
  {
    retry: false,
  },
)

/** The file names that the delivery spec refuses, each with one that it accepts. */
export function RefusedNamesList({ refused, children }: { refused: RefusedNames; children?: ReactNode }): ReactNode {
  const { names } = refused
  if (names.length === 0) return null
  const isSingle = names.length === 1
  return (
    <section className="grid gap-2 p-3-4 border-line-2 rounded-l" aria-label="File names that the spec refuses">
      <p className="row wrap">
        <span className="tone-warn toned">
          <Icon name="triangle" />
        </span>
        <span className="strong">
          {`The delivery spec refuses ${plural(names.length, 'file name')} of the list: ${isSingle ? 'it' : 'they'} would be delivered under ${isSingle ? 'a name' : 'names'} that the spec does not allow.`}
        </span>
      </p>
      <ul className="grid gap-2px wrap-anywhere small">
        {names.slice(0, SHOWN).map(({ row, label, stem, proposed, message }) => (
          <li key={`${row ?? ''} ${label ?? ''} ${stem}`}>
            <span className="dim">{label ?? (row === null ? '' : `Row ${row}`)} </span>
            <span className="mono">{stem}</span>
            {proposed ? (
              <>
                {' → '}
                <span className="mono">{proposed}</span>
              </>
            ) : (
              <span className="mid">: {message}</span>
            )}
          </li>
        ))}
        {names.length > SHOWN && <li className="dim">and {names.length - SHOWN} more</li>}
      </ul>
      {children}
    </section>
  )
}

interface Props {
  projectId: string
  /** Whether the person may change the list and the spec. */
  edits: boolean
}

/** Where the list contradicts its spec, and the change on either side. */
export function RefusedNamesNote({ projectId, edits }: Props): ReactNode {
  const client = useQueryClient()
  const { data } = useQuery(refusedNamesQuery(projectId))
  const refresh = () => invalidate(client, queryKeys.soundList(projectId), queryKeys.spec(projectId), queryKeys.cue.all)
  const rename = useMutation({
    mutationFn: () => post('/v1/projects/{project_id}/sound-list/refused-names/rename', { project_id: projectId }, {}),
    onSuccess: refresh,
  })
  const admit = useMutation({
    mutationFn: (category: string | null) =>
      post('/v1/projects/{project_id}/sound-list/refused-names/admit', { project_id: projectId }, { category }),
    onSuccess: refresh,
  })
  if (!data || data.names.length === 0) return null
  const proposals = data.names.filter(({ proposed }) => proposed !== null).length
  const problem = rename.error ?? admit.error
  return (
    <RefusedNamesList refused={data}>
      {edits && (
        <div className="row wrap">
          {proposals > 0 && (
            <Button
              disabled={rename.isPending || admit.isPending}
              onClick={() =>
                rename.mutate(undefined, { onSuccess: () => showToast(`${plural(proposals, 'cue')} renamed.`) })
              }
            >
              {`Rename ${plural(proposals, 'cue')}`}
            </Button>
          )}
          {data.patterns.map(({ category, proposed, names }) => (
            <Button
              key={category ?? ''}
              disabled={rename.isPending || admit.isPending}
              onClick={() =>
                admit.mutate(category, { onSuccess: () => showToast('The naming rule was changed in the spec.') })
              }
            >
              {`Change the naming rule${category ? ` of ${category}` : ''} to ${proposed} (admits ${plural(names, 'name')})`}
            </Button>
          ))}
          <Link className="link" to={`/projects/${projectId}/spec` as LinkProps['to']}>
            Delivery spec
          </Link>
        </div>
      )}
      <Refusal error={problem} />
    </RefusedNamesList>
  )
}
