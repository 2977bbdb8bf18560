import type { FileKind } from '@/uploads'

const READABLE: readonly FileKind[] = ['wav', 'rf64', 'flac']

const isTable = (value: unknown): value is Record<string, unknown> => typeof value === 'object' && value !== null

/** The kinds of file that the base tables of a spec, or those of any category, take. */
export function acceptedKinds(tables: Record<string, unknown>): FileKind[] {
  const categories = isTable(tables.categories) ? Object.values(tables.categories) : []
  const stated = [tables, ...categories].flatMap((table) => {
    const accept = isTable(table) ? table.accept : undefined
    return isTable(accept) && accept.containers !== undefined ? [accept.containers] : []
  })
  if (stated.length === 0 || stated.includes('any')) return [...READABLE]
  const named = stated.flat()
  return READABLE.filter((kind) => kind === 'wav' || kind === 'rf64' || named.includes(kind))
}
