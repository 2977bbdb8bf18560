import { measuredPart, spelled } from '@/verdicts/words'
import { age, plural, shortDay } from '@/ui/format'
import { SEVERITY_LOOK } from '@/ui/severity'
import type { Tone } from '@/ui/StatusBadge'

import type { Cue, Finding, CueProgress } from './api'

/** What stands of a cue, in one line of which one part may be coloured. */
export interface Stands {
  before: string
  marked: string
  tone: Tone
  after: string
}

/** The facts of a cue besides its progress. */
export interface Beside {
  /** When its oldest open question was asked. */
  askedAt?: string
  /** A file without a cue that may be this one. */
  guessedFile?: string
  /** What its words leave open. */
  unclear?: readonly { question: string }[]
}

const plain = (before: string): Stands => ({ before, marked: '', tone: 'idle', after: '' })

function ofFinding(finding: Finding, before = ''): Stands {
  const [marked, after] = measuredPart(finding)
  return { before, marked, tone: SEVERITY_LOOK[finding.severity].tone, after }
}

const isOld = (at: string, now: Date) => age(at, now) !== 'now'

/** The line of a row: the worst finding first, then what is asked, awaited or unsettled. */
export function standsOf(cue: Cue, progress: CueProgress | undefined, beside: Beside = {}, now = new Date()): Stands {
  if (cue.state === 'cut') {
    const on = cue.cut_at === null ? '' : ` on ${shortDay(cue.cut_at)}`
    return plain(`Cut${on}${cue.cut_reason ? `, “${cue.cut_reason}”` : ''}`)
  }
  const finding = progress?.worst_finding as Finding | null | undefined
  const pick =
    progress?.status === 'to_review' && progress.alternates > 1 ? `Pick one of ${spelled(progress.alternates)}` : ''
  if (finding) return ofFinding(finding, pick && `${pick}. `)
  if (progress?.status === 'question' && progress.open_question) {
    const asked = beside.askedAt
    const since = asked === undefined ? '' : isOld(asked, now) ? ` Asked ${age(asked, now)} ago` : ' Asked just now'
    return plain(`${progress.open_question}${since}`)
  }
  if (pick) return plain(pick)
  const line = ofStatus(cue, progress, now)
  const unsettled = cue.state === 'concept' && progress?.status !== 'accepted'
  if (unsettled && line === '') {
    return { before: '', marked: 'Concept', tone: 'warn', after: ': not final, the work may be discarded' }
  }
  if (unsettled) return { before: `${line}. `, marked: 'Concept', tone: 'warn', after: ': may be discarded' }
  if (line !== '') return toned(line, progress)
  if (beside.guessedFile !== undefined) return plain(`${beside.guessedFile} may be for this cue; not matched yet`)
  const open = beside.unclear?.map(({ question }) => question).join(' ')
  return open ? { before: '', marked: 'Unclear', tone: 'warn', after: `: ${open}` } : plain('')
}

function toned(line: string, progress: CueProgress | undefined): Stands {
  if (progress?.status === 'change_requested') {
    return { before: '', marked: line, tone: 'change', after: ' is with the designer' }
  }
  return plain(line)
}

function ofStatus(cue: Cue, progress: CueProgress | undefined, now: Date): string {
  if (progress === undefined) return ''
  const { status, newest_take: newest, rounds, accepted, wanted, versions } = progress
  switch (status) {
    case 'to_review': {
      const here = progress.variations.filter(
        (variation) => variation.status === 'to_review' || variation.status === 'accepted',
      ).length
      if (cue.variations > 1) return here === wanted ? `All ${wanted} conforming` : `${here} of ${wanted} here`
      return versions > 1 && rounds > 0 ? `Conforming, after ${plural(rounds, 'round')}` : 'Conforming'
    }
    case 'change_requested':
      return rounds > 0 ? `Round ${rounds}` : 'A change'
    case 'checking':
      if (newest === null) return ''
      return isOld(newest.received_at, now) ? `Received ${age(newest.received_at, now)} ago` : 'Received just now'
    case 'unjudged':
      return 'The check failed. That is our fault; no round is counted'
    case 'returned':
      return 'Returned to the designer'
    case 'placeholder':
      return 'Placeholder in the build; it must not ship'
    case 'partly_accepted':
      return `${plural(wanted - accepted, 'variation')} missing`
    case 'accepted':
      if (progress.not_to_spec) return 'Accepted under an earlier spec'
      return progress.waived ? 'Waived' : ''
    default:
      return ''
  }
}
