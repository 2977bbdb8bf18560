const two = (number: number): string => String(number).padStart(2, '0')

/** The day so many days after a moment, as a field for days has it: "2026-12-10". */
export function dayAfter(now: Date, days: number): string {
  const day = new Date(now.getFullYear(), now.getMonth(), now.getDate() + days)
  return `${day.getFullYear()}-${two(day.getMonth() + 1)}-${two(day.getDate())}`
}

/** The last second of a day here, as the server reads instants. */
export const endOfDay = (day: string): string => new Date(`${day}T23:59:59`).toISOString()
