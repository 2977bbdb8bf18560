/** A list with one of its ids at another place; a place beyond either end is the end. */
export function moved(order: readonly string[], id: string, to: number): string[] {
  const others = order.filter((other) => other !== id)
  if (others.length === order.length) return [...order]
  const place = Math.min(others.length, Math.max(0, to))
  return [...others.slice(0, place), id, ...others.slice(place)]
}
