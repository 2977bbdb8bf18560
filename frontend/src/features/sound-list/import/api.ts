import { useQueryClient } from '@tanstack/react-query'

import { ApiProblem, post, useMutation } from '@/api'
import type { components } from '@/api/schema.gen'

import { type Cue, refreshList } from '../api'

type Schemas = components['schemas']
type Told = Schemas['ImportAsk']
type Switch = 'atomic' | 'fill_down' | 'keep_hidden' | 'sample_rate_hz' | 'use_proposed_names'
export type ImportAsk = Omit<Told, Switch> & Partial<Pick<Told, Switch>>
export type ImportRead = Schemas['ImportRead']
export type ImportField = ImportRead['columns'][number]['field']

const SWITCHES = {
  atomic: false,
  fill_down: true,
  keep_hidden: false,
  sample_rate_hz: 48_000,
  use_proposed_names: false,
}

export const importSheet = (projectId: string, body: ImportAsk): Promise<ImportRead> =>
  post('/v1/projects/{project_id}/sound-list/import', { project_id: projectId }, { ...SWITCHES, ...body })

/** Import a sheet for good. */
export function useImport(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Omit<ImportAsk, 'dry_run'>) => importSheet(projectId, { ...body, dry_run: false }),
    onSuccess: ({ imported }) => (imported ? refreshList(client, projectId) : undefined),
  })
}

export type SharedField = 'category' | 'state' | 'need' | 'placeholder' | 'palette' | 'implementer' | 'recorder'

const quoted = (text: string): string => `"${text.replaceAll('"', '""')}"`
const written = (value: string | boolean): string => (typeof value === 'boolean' ? (value ? 'yes' : 'no') : value)

/** Set one fact of several cues: all of them as one revision, or none. */
export function useSetForSeveral(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: async ({
      field,
      values,
    }: {
      field: SharedField
      values: readonly { cue: Cue; value: string | boolean }[]
    }) => {
      const lines = values.map(({ cue, value }) => `${cue.number},${quoted(written(value))}`)
      const answer = await importSheet(projectId, {
        format: 'csv',
        text: ['number,' + field, ...lines].join('\n'),
        mapping: { number: 'number', [field]: field },
        match: 'number',
        dry_run: false,
        atomic: true,
      })
      const fault = answer.errors[0]
      if (fault) {
        const label = values[fault.row - 2]?.cue.label
        throw new ApiProblem(422, {
          code: 'rows-invalid',
          detail: `Nothing was changed. ${label ? `${label}: ` : ''}${fault.message}.`,
        })
      }
      return answer
    },
    onSuccess: () => refreshList(client, projectId),
  })
}
