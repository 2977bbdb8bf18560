/** So long an answer that was asked for before the page's script ran is taken for a new one. */
const FRESH_MS = 10_000

interface Early {
  answers: Map<string, Promise<Response>>
  atMs: number
}

/** The answer to what was asked for while the page's script was on its way (scripts/early.ts); it is taken once. */
export function prefetchedAnswer({ method, url }: Request): Promise<Response> | undefined {
  const { soundlistEarly: early } = globalThis as { soundlistEarly?: Early }
  if (early === undefined || method !== 'GET' || performance.now() - early.atMs > FRESH_MS) return undefined
  const answer = early.answers.get(url)
  early.answers.delete(url)
  return answer
}
