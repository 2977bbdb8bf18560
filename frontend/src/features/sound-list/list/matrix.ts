import { queryOptions } from '@tanstack/react-query'

import { get } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

export type MatrixRow = components['schemas']['MatrixRow']

/** Whether a typed name makes several cues; an x between words does so only in a line with a list. */
export const isMatrix = (name: string): boolean => /[×✕*]/.test(name) || (/\sx\s/i.test(name) && /[,;]/.test(name))

/** The cues that a line makes under the project's names; nothing is added. */
export const matrixQuery = (projectId: string, line: string, category: string) =>
  queryOptions({
    queryKey: queryKeys.soundList(projectId, 'matrix', line, category),
    queryFn: () => get('/v1/projects/{project_id}/cue-matrix', { project_id: projectId, line, category }),
    retry: false,
  })
