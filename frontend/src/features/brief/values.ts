/** Values of answers, read from what the server or the browser kept: of another shape is none. */
const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value)

export const EVERYTHING = 'everything'

/** Rows that the table of effects offers where the list has no categories yet. */
export const EFFECTS_ROWS = ['ui', 'vehicle', 'vo', 'ambience', 'weapon']

export interface Scene {
  scene: string
  ambience: string
  music: boolean
}

export const textsOf = (value: unknown): string[] =>
  Array.isArray(value) ? value.filter((item): item is string => typeof item === 'string') : []

export function tableOf(value: unknown): Record<string, string[]> {
  if (!isRecord(value)) return {}
  return Object.fromEntries(Object.entries(value).map(([key, picked]) => [key, textsOf(picked)]))
}

const text = (value: unknown): string => (typeof value === 'string' ? value : '')

export function scenesOf(value: unknown): Scene[] {
  if (!Array.isArray(value)) return []
  return value
    .filter(isRecord)
    .map(({ scene, ambience, music }) => ({ scene: text(scene), ambience: text(ambience), music: music === true }))
}
