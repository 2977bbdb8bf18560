import { figure, plural } from '@/ui/format'
import type { StateKind } from '@/ui/StatusBadge'
import { sentence } from '@/ui/sentence'

import type { Build, BuildBrief, BuildReport, ReportFile } from './api'

export type Outcome = 'passed' | 'warned' | 'refused'

export const outcomeOf = ({ rejected, warnings }: BuildBrief | Build): Outcome =>
  rejected > 0 ? 'refused' : warnings > 0 ? 'warned' : 'passed'

export const OUTCOME_STATES: Record<Outcome, StateKind> = { passed: 'passed', warned: 'warning', refused: 'refused' }

/** "Refused", "Passed, 3 warnings". */
export function outcomeInWords(build: BuildBrief | Build): string {
  const outcome = outcomeOf(build)
  if (outcome === 'refused') return `Refused, ${plural(build.rejected, 'file')}`
  return outcome === 'warned' ? `Passed, ${plural(build.warnings, 'warning')}` : 'Passed'
}

/** "18 passed, 3 with warnings, 3 refused". */
export function outcomesInWords(builds: readonly (BuildBrief | Build)[]): string {
  const count = (outcome: Outcome) => builds.filter((build) => outcomeOf(build) === outcome).length
  const [passed, warned, refused] = [count('passed'), count('warned'), count('refused')]
  return [
    `${figure(passed)} passed`,
    warned > 0 ? `${figure(warned)} with warnings` : '',
    refused > 0 ? `${figure(refused)} refused` : '',
  ]
    .filter(Boolean)
    .join(', ')
}

export interface Reason {
  /** What was measured, up to the limit. */
  odd: string
  /** The limit, and what to do. */
  rest: string
}

export interface RefusedFile {
  path: string
  reasons: Reason[]
}

const UNHEARD: Partial<Record<ReportFile['verdict'], string>> = {
  unreadable: 'Unreadable',
  unjudged: 'Check failed',
}

function reasonOf({ message, fix }: ReportFile['findings'][number]): Reason {
  const text = sentence(message)
  const comma = text.indexOf(', ')
  const advice = fix ? ` ${sentence(fix)}` : ''
  if (comma < 0) return { odd: text, rest: advice }
  return { odd: text.slice(0, comma), rest: text.slice(comma) + advice }
}

/** The files that break a build: by a verdict that no waiver lifts, each with every reason. */
export function refusedFiles({ files }: BuildReport): RefusedFile[] {
  return files.flatMap((file) => {
    const errors = file.findings.filter(({ severity, waived }) => severity === 'error' && waived !== true)
    const unheard = UNHEARD[file.verdict]
    if (unheard === undefined && (file.verdict === 'conforming' || errors.length === 0)) return []
    const reasons = errors.map(reasonOf)
    return [{ path: file.path, reasons: reasons.length > 0 ? reasons : [{ odd: unheard ?? 'Refused', rest: '.' }] }]
  })
}

/** The files that warn and pass. */
export function warnedFiles({ files }: BuildReport): RefusedFile[] {
  return files.flatMap(({ path, verdict, findings }) => {
    const warnings = findings.filter(({ severity }) => severity === 'warning')
    return verdict === 'conforming' && warnings.length > 0 ? [{ path, reasons: warnings.map(reasonOf) }] : []
  })
}
