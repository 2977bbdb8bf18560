const isWordStart = (text: string, at: number): boolean => at === 0 || /[\s_\-./]/.test(text[at - 1] ?? '')

/**
 * Say how well a query fits a text: higher is better, null when its letters do not all occur in order.
 *
 * Runs of letters and letters that begin a word count most, so that "fdw" finds foot_deck_walk.
 */
export function fit(query: string, text: string): number | null {
  const needle = query.toLowerCase().replaceAll(' ', '')
  const given = text.toLowerCase()
  if (needle === '') return 0
  const whole = given.indexOf(query.toLowerCase().trim())
  if (whole >= 0) return 1000 - whole - given.length / 100 + (isWordStart(given, whole) ? 100 : 0)

  let score = 0
  let at = -1
  let run = 0
  for (const letter of needle) {
    let next = given.indexOf(letter, at + 1)
    if (next < 0) return null
    if (next !== at + 1) {
      for (let start = next; start >= 0; start = given.indexOf(letter, start + 1)) {
        if (isWordStart(given, start)) {
          next = start
          break
        }
      }
    }
    run = next === at + 1 ? run + 1 : 0
    score += 1 + run * 2 + (isWordStart(given, next) ? 8 : 0)
    at = next
  }
  return score - given.length / 100
}

/** The items that fit, best first; with nothing asked, all of them as they came. */
export function fitting<T>(query: string, items: readonly T[], textsOf: (item: T) => string[]): T[] {
  if (query.trim() === '') return [...items]
  return items
    .map((item) => ({ item, score: Math.max(...textsOf(item).map((text) => fit(query, text) ?? -Infinity)) }))
    .filter(({ score }) => score > -Infinity)
    .sort((a, b) => b.score - a.score)
    .map(({ item }) => item)
}
