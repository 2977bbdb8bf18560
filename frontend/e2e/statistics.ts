/** How measured times are distributed, and a line that says so. */
export function distribution(valuesMs: readonly number[]): { median: number; text: string } {
  const sorted = [...valuesMs].sort((a, b) => a - b)
  const at = (share: number) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? NaN
  const median = at(0.5)
  const figures = [median, at(0.95), at(1)].map((value) => value.toFixed(1))
  return { median, text: `median ${figures[0]}, p95 ${figures[1]}, max ${figures[2]} ms, of ${sorted.length}` }
}
