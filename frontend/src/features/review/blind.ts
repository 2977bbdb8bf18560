/** The same things in another order, each order as likely as the others. */
export function shuffled<T>(items: readonly T[], random: () => number = Math.random): T[] {
  const order = [...items]
  for (let last = order.length - 1; last > 0; last -= 1) {
    const index = Math.floor(random() * (last + 1))
    const held = order[last] as T
    order[last] = order[index] as T
    order[index] = held
  }
  return order
}
