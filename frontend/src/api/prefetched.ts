/** So long an answer that was asked for before the page's script ran is taken for a new one. */
const FRESH_MS = 10_000

interface Prefetched {
  answers: Map<string, Promise<Response>>
  atMs: number
}

/** The answer to what was asked for while the page's script was on its way (scripts/preload.ts); it is taken once. */
export function prefetchedAnswer({ method, url }: Request): Promise<Response> | undefined {
  const { soundlistPrefetched: prefetched } = globalThis as { soundlistPrefetched?: Prefetched }
  if (prefetched === undefined || method !== 'GET' || performance.now() - prefetched.atMs > FRESH_MS) return undefined
  const answer = prefetched.answers.get(url)
  prefetched.answers.delete(url)
  return answer
}
