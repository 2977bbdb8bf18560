import { reasonsText } from '@/verdicts/words'
import { bytes, bytesOf, figure, plural } from '@/ui/format'
import type { StateKind } from '@/ui/StatusBadge'
import type { Upload } from '@/uploads'

import type { Archive, DeliveryDetail, DryStem, Take, TakeAdded } from './api'
import type { RefusedFile } from './refused'

/** One line of the delivery, of any kind. */
export interface DeliveryRow {
  id: string
  name: string
  /** The cue's number, once it is known. */
  label: string
  state: StateKind
  /** The share that is here, while something is on its way. */
  share: number | null
  /** Shown next to the bar, or instead of it. */
  detail: string
  /** What can be done with the row. */
  does: 'stop' | 'dismiss' | 'recheck' | null
  uploadId?: string
  takeId?: string
}

/** The number of the cue that a file on its way is for, as far as its name or its drop says. */
export type LabelOf = (upload: Upload) => string

/** Find the number of the cue that owns a file's name, its version and alternate taken off. */
export function labelsOf(cues: readonly { id: string; label: string; stems: string[] }[]): LabelOf {
  const byId = new Map(cues.map(({ id, label }) => [id, label]))
  const byStem = new Map(cues.flatMap(({ label, stems }) => stems.map((stem) => [stem, label] as const)))
  return ({ cueId, file }) => {
    if (cueId !== null) return byId.get(cueId) ?? ''
    const whole = file.name.normalize('NFC').replace(/\.[^.]+$/, '')
    const bare = whole
      .replace(/__dry$/, '')
      .replace(/_v\d+$/i, '')
      .replace(/(?:__alt\d+|_alt[A-Z])$/, '')
    return byStem.get(whole) ?? byStem.get(bare) ?? ''
  }
}

function wordsOf(upload: Upload): string {
  const { sentBytes, resumedAtBytes, file, state } = upload
  if (state === 'line_lost') {
    return `Connection lost at ${bytesOf(sentBytes, file.size)}. The upload resumes by itself.`
  }
  const share = file.size > 0 ? (sentBytes / file.size) * 100 : 0
  const resumed = resumedAtBytes === null ? ` of ${bytes(file.size)}` : `, resumed at ${bytes(resumedAtBytes)}`
  return sentBytes === 0 ? bytes(file.size) : `${figure(Math.floor(share))} %${resumed}`
}

/** "the same sound as version 2 of radar_ping; nothing to check again". */
const sameAs = ({ cue, number }: TakeAdded): string =>
  cue === null
    ? 'this file was already uploaded; choose its cue'
    : `identical to version ${number} of ${cue.name}; not checked again`

function ofUpload(upload: Upload, labelOf: LabelOf, take: TakeAdded | undefined): DeliveryRow | null {
  const base = {
    id: upload.id,
    uploadId: upload.id,
    name: upload.path,
    label: labelOf(upload),
    share: null,
  }
  switch (upload.state) {
    case 'waiting':
    case 'sending':
    case 'line_lost':
    case 'paused':
      return {
        ...base,
        state: upload.state,
        share: upload.file.size > 0 ? upload.sentBytes / upload.file.size : 0,
        detail: wordsOf(upload),
        does: 'stop',
      }
    case 'not_sent':
      return { ...base, state: 'not_sent', detail: upload.reason ?? 'Refused.', does: 'dismiss' }
    case 'already_here':
      return { ...base, state: 'already_here', detail: 'already in this delivery; skipped', does: 'dismiss' }
    case 'finished':
      if (take === undefined || !take.already_here) return null
      return {
        ...base,
        label: take.cue?.label ?? '',
        state: 'already_here',
        detail: sameAs(take),
        does: 'dismiss',
      }
    case 'stopped':
      return null
  }
}

const TAKE_STATES = {
  received: 'checking',
  conforming: 'conforming',
  returned: 'returned',
  unjudged: 'unjudged',
  approved: 'approved',
  change_requested: 'change_requested',
  set_aside: 'set_aside',
} as const satisfies Record<Take['state'], StateKind>

/** Why it was approved or has to change, after its figures. */
const whySo = ({ verdict_reasons: reasons }: Take): string => (reasons.length === 0 ? '' : `. ${reasonsText(reasons)}`)

function ofTake(take: Take): DeliveryRow {
  const version = take.number === null ? '' : `version ${take.number}, `
  const late = take.late ? ', after the delivery was closed' : ''
  return {
    id: take.id,
    takeId: take.id,
    name: take.file_name,
    label: take.cue?.label ?? '',
    state: take.cue === null && take.state !== 'received' ? 'unmatched' : TAKE_STATES[take.state],
    share: take.state === 'received' ? 1 : null,
    detail:
      take.state === 'unjudged'
        ? 'The check failed three times. That is our fault, not the file’s.'
        : take.state === 'received'
          ? `${bytes(take.master_bytes)}, uploaded${late}`
          : `${version}${bytes(take.master_bytes)}${late}${whySo(take)}`,
    does: take.state === 'unjudged' ? 'recheck' : null,
  }
}

function ofDryStem(stem: DryStem): DeliveryRow {
  const of = `the dry stem of ${stem.stem}`
  return {
    id: stem.id,
    name: stem.file_name,
    label: '',
    state: stem.take_ids.length > 0 ? 'passed' : 'waiting',
    share: null,
    detail:
      stem.take_ids.length > 0
        ? `${of}, ${bytes(stem.file_bytes)}`
        : `${of}, which is missing; add it to this delivery`,
    does: null,
  }
}

const ARCHIVE_STATES = { received: 'checking', refused: 'refused', unpacked: 'passed' } as const

function ofArchive(archive: Archive, takes: readonly Take[]): DeliveryRow[] {
  const taken = archive.entries.filter((entry) => entry.taken).length
  const unmatched = takes.filter(({ id, cue }) => !cue && archive.entries.some(({ take_id }) => take_id === id)).length
  const head: DeliveryRow = {
    id: archive.id,
    name: archive.file_name,
    label: 'ZIP',
    state: archive.state === 'unpacked' && unmatched > 0 ? 'waiting' : ARCHIVE_STATES[archive.state],
    share: archive.state === 'received' ? 1 : null,
    detail:
      archive.state === 'received'
        ? `${bytes(archive.archive_bytes)}, uploaded; unpacking`
        : archive.state === 'refused'
          ? archive.message
          : `${plural(taken, 'file')} unpacked${unmatched > 0 ? `; ${unmatched} without a cue, to be chosen below. Names in a ZIP stay.` : ''}`,
    does: null,
  }
  const left = archive.entries.filter((entry) => !entry.taken || entry.reason !== null)
  return [
    head,
    ...left.map((entry) => ({
      id: `${archive.id} ${entry.path}`,
      name: entry.path,
      label: 'ZIP',
      state: entry.taken ? ('already_here' as const) : ('not_sent' as const),
      share: null,
      detail: entry.reason ?? 'Skipped.',
      does: null,
    })),
  ]
}

const DONE: readonly StateKind[] = ['conforming', 'approved', 'set_aside', 'change_requested', 'passed']

export interface DeliveryRows {
  /** What is on its way, or wants to be seen. */
  open: DeliveryRow[]
  /** Rows that need no action here. */
  done: DeliveryRow[]
}

/** What the server has of a delivery, the newest first. */
export function receivedRows({ archives, dry_stems, takes }: DeliveryDetail): DeliveryRow[] {
  const newest = takes.toSorted((a, b) => Date.parse(b.received_at) - Date.parse(a.received_at))
  const all = [...archives.flatMap((one) => ofArchive(one, takes)), ...dry_stems.map(ofDryStem), ...newest.map(ofTake)]
  return all.filter(({ state }) => state !== 'unmatched')
}

const EARLIER = 'earlier '

/** The name of a file that was refused on an earlier page, by the id of its row; null for other rows. */
export const refusedNameOf = (id: string): string | null => (id.startsWith(EARLIER) ? id.slice(EARLIER.length) : null)

/** What was refused before the page was opened again: its bytes are gone. */
export const refusedRows = (refused: readonly RefusedFile[]): DeliveryRow[] =>
  refused.map(({ name, reason }) => ({
    id: `${EARLIER}${name}`,
    uploadId: `${EARLIER}${name}`,
    name,
    label: '',
    state: 'not_sent',
    share: null,
    detail: `${reason} Refused before this page was opened; drop the file again.`,
    does: 'dismiss',
  }))

/** Everything of a delivery in one list: what the browser sends, then what the server has. */
export function rowsOf(
  uploads: readonly Upload[],
  received: readonly DeliveryRow[],
  takeOf: (uploadId: string) => TakeAdded | undefined,
  labelOf: LabelOf,
): DeliveryRows {
  const sent = uploads.flatMap((upload) => ofUpload(upload, labelOf, takeOf(upload.id)) ?? [])
  const all = [...sent, ...received]
  return {
    open: all.filter(({ state }) => !DONE.includes(state)),
    done: all.filter(({ state }) => DONE.includes(state)),
  }
}
