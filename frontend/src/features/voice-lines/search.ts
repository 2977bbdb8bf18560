/** What the address of the page says: the view, and what it is narrowed to. */
export interface LinesSearch {
  view?: View
  language?: string
  state?: LineStateName
  character?: string
  search?: string
}

export const VIEWS = ['lines', 'pick-ups', 'cast'] as const
export type View = (typeof VIEWS)[number]
export const STATES = [
  'no_text',
  'no_take',
  'stale',
  'returned',
  'change_requested',
  'in_review',
  'approved',
  'cut',
] as const
export type LineStateName = (typeof STATES)[number]
