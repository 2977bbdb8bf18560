import { measuredPart, spelled } from '@/judging/words'
import { age, plural, shortDay } from '@/ui/format'
import type { Tone } from '@/ui/State'

import type { Cue, Finding, Standing } from './api'

/** What stands of a cue, in one line of which one part may be coloured. */
export interface Stands {
  before: string
  marked: string
  tone: Tone
  after: string
}

/** What is known of a cue beside its standing. */
export interface Beside {
  /** When its oldest open question was asked. */
  askedAt?: string
  /** A file without a cue that may be this one. */
  guessedFile?: string
}

const plain = (before: string): Stands => ({ before, marked: '', tone: 'idle', after: '' })

function ofFinding(finding: Finding, before = ''): Stands {
  const [marked, after] = measuredPart(finding)
  return { before, marked, tone: finding.severity === 'error' ? 'bad' : 'warn', after }
}

const isOld = (at: string, now: Date) => age(at, now) !== 'now'

/** The line of a row: the worst finding first, then what is asked, awaited or unsettled. */
export function standsOf(cue: Cue, standing: Standing | undefined, beside: Beside = {}, now = new Date()): Stands {
  if (cue.state === 'cut') {
    const on = cue.cut_at === null ? '' : ` on ${shortDay(cue.cut_at)}`
    return plain(`Cut${on}${cue.cut_reason ? `, “${cue.cut_reason}”` : ''}`)
  }
  const finding = standing?.worst_finding as Finding | null | undefined
  const pick =
    standing?.status === 'to_review' && standing.alternates > 1 ? `Pick one of ${spelled(standing.alternates)}` : ''
  if (finding) return ofFinding(finding, pick && `${pick}. `)
  if (standing?.status === 'question' && standing.open_question) {
    const asked = beside.askedAt
    const since = asked === undefined ? '' : isOld(asked, now) ? ` Asked ${age(asked, now)} ago` : ' Asked just now'
    return plain(`${standing.open_question}${since}`)
  }
  if (pick) return plain(pick)
  const line = ofStatus(cue, standing, now)
  const unsettled = cue.state === 'concept' && standing?.status !== 'accepted'
  if (unsettled && line === '') {
    return { before: '', marked: 'Concept', tone: 'warn', after: ': not settled, work on it may be lost' }
  }
  if (unsettled) return { before: `${line}. `, marked: 'Concept', tone: 'warn', after: ': may be lost' }
  if (line !== '' || beside.guessedFile === undefined) return toned(line, standing)
  return plain(`${beside.guessedFile} may be this; not matched yet`)
}

function toned(line: string, standing: Standing | undefined): Stands {
  if (standing?.status === 'change_requested') {
    return { before: '', marked: line, tone: 'change', after: ' is with the designer' }
  }
  return plain(line)
}

function ofStatus(cue: Cue, standing: Standing | undefined, now: Date): string {
  if (standing === undefined) return ''
  const { status, newest_take: newest, rounds, accepted, wanted, versions } = standing
  switch (status) {
    case 'to_review': {
      const here = standing.variations.filter(
        (each) => each.status === 'to_review' || each.status === 'accepted',
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
      return 'The check itself broke; that is our fault, and no round counts'
    case 'returned':
      return 'With the designer to mend'
    case 'placeholder':
      return 'The game plays a stand-in; none may ship'
    case 'partly_accepted':
      return `${plural(wanted - accepted, 'variation')} still to come`
    case 'accepted':
      if (standing.not_to_spec) return 'Accepted to an earlier spec'
      return standing.waived ? 'Let through with a reason' : ''
    default:
      return ''
  }
}
