import { age, ago, bytes, plural } from '@/ui/format'
import type { StateKind } from '@/ui/StatusBadge'

import type { JobCount, JobState, Lane, Scope, Scrub } from './api'

/** What each job does, for people; one without words here is called by its own name. */
const JOBS: Partial<Record<string, string>> = {
  'operations.scrub_blobs': 'Read stored files and compare them with their hashes',
  'operations.carry_out_erasures': 'Erase projects and studios whose days of grace are over',
  'operations.end_masters': 'Announce and delete masters whose contract’s years are over',
  'agreements.seal_contract': 'Seal the PDF of a signed contract',
  'agreements.seal_unsealed': 'Seal signed contracts that have no seal yet',
  'notifications.delete_old_notices': 'Delete old notices',
  'notifications.mail_heads': 'Mail the signed heads of audit trails',
  'money.charge_retainers': 'Charge the months of retainers',
  'notifications.notify_work_logged': 'Notify about logged work',
  'notifications.notify_work_refused': 'Notify about refused work',
  'amendments.settle_ended': 'Settle contracts whose notice is over',
  'builds.compare_take': 'Compare a version with other projects',
  'builds.compare_library': 'Compare a sound library with versions',
  'builds.fingerprint_pack': 'Analyse sounds missing from a manifest',
  'builds.fingerprint_take': 'Analyse an approved version',
  'builds.make_spoken_placeholders': 'Make placeholders of what was said for a cue',
  'builds.seal_pack': 'Seal a pack',
  'conformance.recheck_takes': 'Recheck versions affected by a change',
  'conformance.make_fix': 'Make a fixed copy',
  'deliveries.unpack_archive': 'Unpack a ZIP',
  'notifications.mail_link': 'Write an email with a link',
  'notifications.remind_of_days': 'Remind of days that contracts name',
  'notifications.warn_of_token_ends': 'Announce tokens that end soon',
  'notifications.send_mail': 'Send an email',
  'notifications.notify_answer': 'Notify about an answer',
  'notifications.notify_approval': 'Notify about an approval',
  'notifications.notify_build': 'Notify about a refused build',
  'notifications.notify_changes': 'Notify about requested changes',
  'notifications.notify_checks': 'Notify about checks',
  'notifications.notify_contract': 'Notify about a contract',
  'notifications.notify_cut': 'Notify about a cut cue',
  'notifications.notify_list_revised': 'Notify about a list revision',
  'notifications.notify_invoice': 'Notify about an invoice',
  'notifications.notify_joined': 'Notify about a designer who joined',
  'notifications.notify_mention': 'Notify about a mention',
  'notifications.notify_reply': 'Notify about a reply',
  'notifications.notify_signature': 'Notify about a signature',
  'notifications.notify_question': 'Notify about a question',
  'notifications.notify_overdue_checks': 'Send pending notifications',
  'projects.name_invited_approver': 'Name an invited approver',
  'hiring.check_sample': 'Check a sample of a bid',
  'renders.draw_fix': 'Draw the waveform of a fixed copy',
  'renders.measure_palette': 'Queue sound comparisons',
  'renders.measure_timbre': 'Measure timbre',
  'renders.export_master': 'Write provenance into a copy of a master',
  'renders.render_next_of_batch': 'Render the next game files of a batch',
  'renders.make_reel': 'Build a reel of versions',
  'shares.make_guest_copy': 'Copy a preview for guests',
  'renders.make_renders': 'Draw the waveform and render game files',
  'renders.prepare_take': 'Check a version, draw its waveform and render game files',
  'renders.plan_batch': 'Plan a batch of game files',
  'renders.update_renders': 'Queue new game files',
  'scenes.compare_sounds': 'Compare two sounds',
  'scenes.measure_sound': 'Measure a sound for its scene',
  'server.delete_finished_jobs': 'Delete old jobs',
  'money.add_accepted_cues': 'Add earlier acceptances to a contract',
  'agreements.apply_deemed_acceptance': 'Send review reminders and auto-accept overdue cues',
  'webhooks.delete_old_calls': 'Delete old webhook calls',
  'webhooks.send_call': 'Call a webhook',
  'webhooks.write_calls': 'Write webhook messages',
  'server.send_pending': 'Send queued emails',
  'server.sweep_uploads': 'Delete unfinished uploads',
  'server.delete_expired_rate_limits': 'Delete old rate-limit counters',
  'server.delete_old_security_events': 'Delete old lines of security logs',
}

export function jobWords(job: string): string {
  const verb = job.slice(job.indexOf('.') + 1).replaceAll('_', ' ')
  return JOBS[job] ?? verb.charAt(0).toUpperCase() + verb.slice(1)
}

/** In the order of need: who looks here looks for what gave up. */
export const STATES_SHOWN: readonly JobState[] = ['parked', 'broken', 'running', 'waiting', 'delayed']

export const STATE_FACES: Record<JobState, { kind: StateKind; word: string }> = {
  parked: { kind: 'refused', word: 'Failed' },
  broken: { kind: 'unjudged', word: 'Retrying' },
  running: { kind: 'checking', word: 'Running' },
  waiting: { kind: 'waiting', word: 'Waiting' },
  delayed: { kind: 'paused', word: 'Scheduled' },
}

export const jobsIn = (counts: readonly JobCount[], state: JobState): number =>
  counts.filter((count) => count.state === state).reduce((sum, { jobs }) => sum + jobs, 0)

/** Jobs without a studio are the server's own. */
export const SERVER_ITSELF = 'the server'

const URGENCIES: Record<Lane['urgency'], string> = {
  urgent: 'interactive',
  normal: 'normal',
  bulk: 'bulk',
}

export const laneKey = ({ studio_id, urgency }: Lane): string => `${studio_id ?? ''}:${urgency}`

export const laneWords = ({ studio_name, urgency }: Lane, scope: Scope): string => {
  const how = URGENCIES[urgency]
  return scope === 'server' ? `${studio_name ?? SERVER_ITSELF}, ${how}` : how.charAt(0).toUpperCase() + how.slice(1)
}

/** "2 run, 40 wait, the oldest for 5 min, 1 later". */
export function laneLine({ waiting, running, delayed, oldest_at }: Lane, now = new Date()): string {
  const oldest = oldest_at === null ? 'now' : age(oldest_at, now)
  return [
    running > 0 && `${running} running`,
    waiting > 0 && `${waiting} waiting${oldest === 'now' ? '' : `, the oldest for ${oldest}`}`,
    delayed > 0 && `${delayed} scheduled`,
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
  const waits = oldest === undefined ? 'No jobs are waiting.' : `${plural(waiting, 'job')} waiting`
  const since = oldest === undefined ? '' : age(oldest, now) === 'now' ? '.' : `, the oldest for ${age(oldest, now)}.`
  return [
    gaveUp === 0 ? 'None failed.' : `${plural(gaveUp, 'job')} failed.`,
    `${waits}${since}`,
    alive === 0
      ? 'No worker is running. Deliveries are checked once one starts.'
      : `${plural(alive, 'worker')} running.`,
  ].join(' ')
}

/** Whether a pass over all stored files has found one missing or altered. */
export const isDamaged = ({ missing, altered }: Scrub): boolean => missing + altered > 0

/** The newest pass over all stored files in one line. */
export function scrubLine(scrub: Scrub | null, now: Date = new Date()): string {
  if (scrub === null) return 'No stored file has been verified yet.'
  const { files, missing, altered, orphaned, orphaned_bytes, finished_at } = scrub
  const when = finished_at === null ? 'so far' : ago(finished_at, now)
  const verified = `${plural(files, 'file')} verified ${when}`
  if (isDamaged(scrub)) {
    return `${verified}: ${plural(missing, 'file')} missing, ${altered} altered. Run soundlist scrub for their names.`
  }
  const unused = orphaned === 0 ? '' : `, ${plural(orphaned, 'unused file')} of ${bytes(orphaned_bytes)}`
  return `${verified}: none missing or altered${unused}.`
}
