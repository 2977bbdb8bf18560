import { useQuery } from '@tanstack/react-query'

import { checksQuery, type Check, type CheckLimit } from '../api'

/** The effect of a broken rule of the spec: the take is returned, a warning is shown, or nothing happens. */
export type Severity = 'error' | 'warning' | 'off'

/** The checks as the server describes them, in the order of reports; none until they are there. */
export function useChecks(): readonly Check[] {
  return useQuery(checksQuery).data ?? []
}

/** A limit with the check that holds files to it. */
export interface HeldLimit extends CheckLimit {
  check: Check
}

const limitsOf = (checks: readonly Check[]): HeldLimit[] =>
  checks.flatMap((check) => check.limits.map((limit) => ({ ...limit, check })))

/** The limits of sounds: none holds unless the spec states it. */
export const statedLimits = (checks: readonly Check[]) => limitsOf(checks).filter(({ usual }) => usual === null)

/** The limits that hold though the spec is silent: they tune how others are kept. */
export const tuningLimits = (checks: readonly Check[]) => limitsOf(checks).filter(({ usual }) => usual !== null)

/** The checks that no limit names. */
export const checksWithoutLimit = (checks: readonly Check[]) => checks.filter(({ limits }) => limits.length === 0)

/** How severe a check is by what the tables say. */
export function severityOf(checks: Record<string, unknown>, name: string, usual: Severity = 'error'): Severity {
  const severity = checks[name]
  return severity === 'error' || severity === 'warning' || severity === 'off' ? severity : usual
}
