/** What the address of the page of reasons says: a filter, and which reason is open. */
export interface FoundReasons {
  kind?: 'change' | 'pick'
  reason?: string
  designer?: string
  /** Empty for cues without one. */
  category?: string
}

const text = (value: unknown): string | undefined => (typeof value === 'string' ? value : undefined)

export const foundReasonsOf = (search: Record<string, unknown>): FoundReasons => ({
  kind: search.kind === 'change' || search.kind === 'pick' ? search.kind : undefined,
  reason: text(search.reason),
  designer: text(search.designer),
  category: text(search.category),
})
