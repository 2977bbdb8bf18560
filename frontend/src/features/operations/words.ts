import { age, plural } from '@/ui/format'
import type { StateKind } from '@/ui/State'

import type { JobCount, JobState, Lane, Scope } from './api'

/** What each job does, for people; one without words here is called by its own name. */
const JOBS: Partial<Record<string, string>> = {
  'builds.hear_pack': 'Listen to what a manifest lacks',
  'builds.hear_take': 'Listen to an approved version',
  'builds.seal_pack': 'Seal a pack',
  'conformance.check_take': 'Check a version',
  'conformance.recheck_takes': 'Check again what a change touches',
  'conformance.make_mend': 'Make a mended copy',
  'deliveries.unpack_archive': 'Unpack a ZIP',
  'notifications.mail_link': 'Write a mail with a link',
  'notifications.send_mail': 'Send a mail',
  'notifications.tell_answer': 'Tell an answer',
  'notifications.tell_approval': 'Tell an approval',
  'notifications.tell_build': 'Tell what a build refused',
  'notifications.tell_changes': 'Tell requested changes',
  'notifications.tell_check': 'Tell what a check said',
  'notifications.tell_checks': 'Tell what checks said',
  'notifications.tell_contract': 'Tell what became of a contract',
  'notifications.tell_cut': 'Tell of a cut',
  'notifications.tell_list_revised': 'Tell a new revision',
  'notifications.tell_question': 'Tell a question',
  'notifications.tell_untold': 'Tell what was left untold',
  'renders.draw_mend': 'Draw a mended copy',
  'renders.draw_take': 'Draw a sound',
  'renders.hear_palette': 'Ask for what compares sounds',
  'renders.hear_take': 'Measure the timbre of a sound',
  'renders.export_master': 'Write provenance into a copy of a master',
  'renders.make_next_of_batch': 'Make the next game files of a batch',
  'renders.make_reel': 'Put versions in a row',
  'renders.make_renders': 'Draw a sound and make its game files',
  'renders.prepare_take': 'Check a version, draw it and make its game files',
  'renders.plan_batch': 'Plan a batch of game files',
  'renders.renew_renders': 'Ask for new game files',
  'server.forget_done_jobs': 'Clear away old jobs',
  'reviews.adopt_accepted': 'Take what was accepted before into its contract',
  'reviews.mind_silence': 'Remind of waiting verdicts, and accept by silence',
  'server.send_waiting': 'Send mails that wait',
  'server.sweep_uploads': 'Clear away unfinished uploads',
  'server.forget_rate_limits': 'Clear away old counts of attempts',
}

export function jobWords(job: string): string {
  const verb = job.slice(job.indexOf('.') + 1).replaceAll('_', ' ')
  return JOBS[job] ?? verb.charAt(0).toUpperCase() + verb.slice(1)
}

/** In the order of need: who looks here looks for what gave up. */
export const STATES_SHOWN: readonly JobState[] = ['parked', 'broken', 'running', 'waiting', 'delayed']

export const STATE_FACES: Record<JobState, { kind: StateKind; word: string }> = {
  parked: { kind: 'refused', word: 'Gave up' },
  broken: { kind: 'unjudged', word: 'Broke' },
  running: { kind: 'checking', word: 'Running' },
  waiting: { kind: 'waiting', word: 'Waiting' },
  delayed: { kind: 'paused', word: 'Later' },
}

export const jobsIn = (counts: readonly JobCount[], state: JobState): number =>
  counts.filter((count) => count.state === state).reduce((sum, { jobs }) => sum + jobs, 0)

/** What nobody's studio asked for, the server did. */
export const NOBODYS = 'the server itself'

const URGENCIES: Record<Lane['urgency'], string> = {
  urgent: 'what people wait for',
  normal: 'as it comes',
  bulk: 'in bulk',
}

export const laneKey = ({ studio_id, urgency }: Lane): string => `${studio_id ?? ''}:${urgency}`

export const laneWords = ({ studio_name, urgency }: Lane, scope: Scope): string => {
  const how = URGENCIES[urgency]
  return scope === 'server' ? `${studio_name ?? NOBODYS}, ${how}` : how.charAt(0).toUpperCase() + how.slice(1)
}

/** "2 run, 40 wait, the oldest for 5 min, 1 later". */
export function laneLine({ waiting, running, delayed, oldest_at }: Lane, now = new Date()): string {
  const oldest = oldest_at === null ? 'now' : age(oldest_at, now)
  return [
    running > 0 && `${running} ${running === 1 ? 'runs' : 'run'}`,
    waiting > 0 &&
      `${waiting} ${waiting === 1 ? 'waits' : 'wait'}${oldest === 'now' ? '' : `, the oldest for ${oldest}`}`,
    delayed > 0 && `${delayed} later`,
  ]
    .filter(Boolean)
    .join(', ')
}

/** The answer to "is all well?", in one line. */
export function inOneLine(counts: readonly JobCount[], alive: number, now = new Date()): string {
  const gaveUp = jobsIn(counts, 'parked') + jobsIn(counts, 'broken')
  const waiting = jobsIn(counts, 'waiting')
  const oldest = counts
    .filter(({ state }) => state === 'waiting')
    .map(({ oldest_at }) => oldest_at)
    .sort()[0]
  const waits =
    oldest === undefined ? 'Nothing waits.' : `${plural(waiting, 'job')} ${waiting === 1 ? 'waits' : 'wait'}`
  const since = oldest === undefined ? '' : age(oldest, now) === 'now' ? '.' : `, the oldest for ${age(oldest, now)}.`
  return [
    gaveUp === 0 ? 'Nothing gave up.' : `${plural(gaveUp, 'job')} gave up.`,
    `${waits}${since}`,
    alive === 0
      ? 'No worker lives: what is delivered waits.'
      : `${plural(alive, 'worker')} ${alive === 1 ? 'works' : 'work'}.`,
  ].join(' ')
}
