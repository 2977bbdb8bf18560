import { ApiProblem } from '@/api'

/** What is wrong with a spec, and where: "limits.true_peak_dbtp", or nowhere in particular. */
export interface Trouble {
  place: string
  message: string
}

/** What a refusal says of the spec itself; any other refusal is none. */
export function troubleOf(error: unknown): Trouble | null {
  if (!(error instanceof ApiProblem) || error.code !== 'bad-spec') return null
  const [first] = error.errors
  return first ? { place: first.field, message: first.message } : { place: '', message: error.detail }
}

/** Whether a trouble stands at a field or within it. */
export const isAt = (trouble: Trouble | null, place: readonly string[]): boolean => {
  if (trouble === null || trouble.place === '') return false
  const own = place.join('.')
  return trouble.place === own || trouble.place.startsWith(`${own}.`) || trouble.place.startsWith(`${own}[`)
}
