import { queryById } from '@/api'

import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

/** A designer's work in one project: the desk shows it, and its tab counts what came back. */
export const deskQuery = queryById('/v1/projects/{project_id}/desk', queryKeys.desk)

type Desk = components['schemas']['Desk']

/** How much came back: takes where all of them are here, else cues. */
export const cameBack = ({ came_back: takes, came_back_next: next, came_back_cues: cues }: Desk): number =>
  next ? cues : takes.length
