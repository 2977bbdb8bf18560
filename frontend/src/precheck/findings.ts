import type { components } from '@/api/schema.gen'

import type { Peaks } from './peaks'
import type { Layout } from './wav'

type Schemas = components['schemas']
export type SpecView = Schemas['SpecView']
export type CueLength = Schemas['CueLength']
export type Finding = Pick<
  Schemas['FindingRead'],
  'code' | 'severity' | 'message' | 'fix' | 'measured' | 'limit' | 'unit' | 'start_s' | 'end_s' | 'auto_fix'
>

/** A sound that is judged, with the spec and what the list says of its length. */
export interface Subject {
  layout: Layout
  peaks: Peaks
  spec: SpecView
  length: CueLength | null
}
