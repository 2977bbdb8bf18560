import type { Accepts, FileKind } from '@/uploads'

const READABLE: readonly FileKind[] = ['wav', 'rf64', 'flac']

const isTable = (value: unknown): value is Record<string, unknown> => typeof value === 'object' && value !== null

/** What a key of the accept tables allows, in the base tables or any category; null for anything. */
function allowed(tables: Record<string, unknown>, key: string): unknown[] | null {
  const categories = isTable(tables.categories) ? Object.values(tables.categories) : []
  const stated = [tables, ...categories].flatMap((table) => {
    const accept = isTable(table) ? table.accept : undefined
    return isTable(accept) && accept[key] !== undefined ? [accept[key]] : []
  })
  return stated.length === 0 || stated.includes('any') ? null : stated.flat()
}

const numbers = (values: unknown[] | null) =>
  values && [...new Set(values.filter((value) => typeof value === 'number'))].sort((one, other) => one - other)

/** The files that a spec takes: its base tables, or those of any category. */
export function acceptedFiles(tables: Record<string, unknown>): Accepts {
  const named = allowed(tables, 'containers')
  return {
    kinds: READABLE.filter((kind) => named === null || kind === 'wav' || kind === 'rf64' || named.includes(kind)),
    sampleRatesHz: numbers(allowed(tables, 'sample_rates_hz')),
    bitDepths: numbers(allowed(tables, 'bit_depths')),
  }
}
