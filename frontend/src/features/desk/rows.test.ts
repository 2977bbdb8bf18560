import { describe, expect, test } from 'vitest'

import { spotOf, wordsOf, worstFirst } from '@/verdicts/findings'
import type { Upload } from '@/uploads'

import { acceptedFiles } from './accepted'
import type { Desk, DeliveryDetail, Finding, Take } from './api'
import { labelsOf, receivedRows, rowsOf } from './rows'
import { deskLine } from './words'

const file = (name: string, size: number) => ({ name, size }) as File
const upload = (more: Partial<Upload> & { name?: string; size?: number }): Upload => ({
  id: 'u1',
  file: file(more.name ?? 'warp_in.wav', more.size ?? 17_300_000),
  path: more.name ?? 'warp_in.wav',
  kind: 'sound',
  state: 'sending',
  sentBytes: 0,
  resumedAtBytes: null,
  reason: null,
  cueId: null,
  ...more,
})
const take = (more: Partial<Take>): Take => ({
  id: 't1',
  project_id: 'p1',
  delivery_id: 'd1',
  designer: { id: 'x3', name: 'Sound designer' },
  cue: { id: 'c18', label: 'SW-018', name: 'warp_in' },
  variation: 1,
  number: 2,
  alternate: null,
  label: null,
  verdict_reasons: [],
  state: 'received',
  late: false,
  file_name: 'warp_in.wav',
  note: '',
  fix_of_id: null,
  master_sha256: 'a',
  master_bytes: 201_600,
  received_at: '2026-11-17T09:00:00Z',
  state_since: '2026-11-17T09:00:00Z',
  discarded_at: null,
  sure: null,
  guesses: [],
  already_here: false,
  ...more,
})
const detail = (more: Partial<DeliveryDetail>): DeliveryDetail => ({
  id: 'd1',
  project_id: 'p1',
  number: 4,
  note: '',
  created_at: '2026-11-17T09:00:00Z',
  closed_at: null,
  designer: { id: 'x3', name: 'Sound designer' },
  takes_count: 1,
  takes: [],
  dry_stems: [],
  archives: [],
  ...more,
})
const rows = (uploads: Upload[], here?: DeliveryDetail, known: Record<string, Take> = {}) =>
  rowsOf(
    uploads,
    here ? receivedRows(here) : [],
    (id) => known[id],
    () => '',
  )

describe('a file on its way', () => {
  test('says its share of the whole', () => {
    const [row] = rows([upload({ sentBytes: 11_764_000 })]).open
    expect(row).toMatchObject({ state: 'sending', detail: '68 % of 17.3 MB', share: 0.68, does: 'stop' })
  })

  test('says from where it went on', () => {
    const [row] = rows([upload({ sentBytes: 11_764_000, resumedAtBytes: 9_100_000 })]).open
    expect(row?.detail).toBe('68 %, resumed at 9.1 MB')
  })

  test('says where the line dropped, and that nothing is to be done', () => {
    const [row] = rows([upload({ state: 'line_lost', sentBytes: 9_100_000 })]).open
    expect(row?.detail).toBe('Connection lost at 9.1 of 17.3 MB. The upload resumes by itself.')
  })

  test('says why it was not sent', () => {
    const [row] = rows([upload({ state: 'not_sent', reason: 'This is an MP3 named .wav.' })]).open
    expect(row).toMatchObject({ state: 'not_sent', detail: 'This is an MP3 named .wav.', does: 'dismiss' })
  })

  test('gives way to its take once it is here', () => {
    const all = rows([upload({ state: 'finished' })], detail({ takes: [take({})] }), { u1: take({}) })
    expect(all.open.map(({ id, state }) => [id, state])).toEqual([['t1', 'checking']])
  })

  test('that was here before names the take it is', () => {
    const known = take({ already_here: true, number: 1, cue: { id: 'c14', label: 'SW-014', name: 'radar_ping' } })
    const [row] = rows([upload({ state: 'finished' })], detail({}), { u1: known }).open
    expect(row).toMatchObject({
      state: 'already_here',
      label: 'SW-014',
      detail: 'identical to version 1 of radar_ping; not checked again',
    })
  })
})

describe('what became of the files', () => {
  test('what needs nobody folds away, what is unmatched has a place of its own', () => {
    const takes = [
      take({ id: 'a', state: 'conforming' }),
      take({ id: 'b', state: 'returned' }),
      take({ id: 'c', state: 'returned', cue: null, number: null }),
      take({ id: 'd', state: 'unjudged' }),
    ]
    const { open, done } = rows([], detail({ takes }))
    expect(open.map(({ id }) => id)).toEqual(['b', 'd'])
    expect(done.map(({ id }) => id)).toEqual(['a'])
    expect(open[1]).toMatchObject({ does: 'recheck', detail: expect.stringContaining('our fault') as string })
  })

  test('of a ZIP, what was left out is said with its reason', () => {
    const entries = [
      { path: 'a.wav', taken: true, take_id: 'a', reason: null },
      { path: 'notes.txt', taken: false, take_id: null, reason: 'no sound' },
    ]
    const archive = {
      id: 'z',
      delivery_id: 'd1',
      file_name: 'all.zip',
      archive_bytes: 10,
      state: 'unpacked' as const,
      message: '',
      entries,
      received_at: '2026-11-17T09:00:00Z',
    }
    const { open, done } = rows([], detail({ archives: [archive] }))
    const a = take({ id: 'a', state: 'received', cue: null, number: null })
    const [unmatched] = rows([], detail({ archives: [archive], takes: [a] })).open
    expect(unmatched).toMatchObject({
      state: 'waiting',
      detail: '1 file unpacked; 1 without a cue, to be chosen below. Names in a ZIP stay.',
    })
    expect(done.map(({ name, detail: said }) => [name, said])).toEqual([['all.zip', '1 file unpacked']])
    expect(open.map(({ name, state, detail: said }) => [name, state, said])).toEqual([
      ['notes.txt', 'not_sent', 'no sound'],
    ])
  })
})

test('a version says why it was approved, or has to change', () => {
  const approved = take({ id: 'a', state: 'approved', verdict_reasons: ['Fits the scene', 'Best timing'] })
  const changed = take({ id: 'b', state: 'change_requested', verdict_reasons: ['Too loud'], late: true })
  const bare = take({ id: 'c', state: 'approved' })
  expect(rows([], detail({ takes: [approved, changed, bare] })).done.map(({ detail: said }) => said)).toEqual([
    'version 2, 201.6 kB. Fits the scene. Best timing.',
    'version 2, 201.6 kB, after the delivery was closed. Too loud.',
    'version 2, 201.6 kB',
  ])
})

test('a dry stem is no version: it stands beside the one it is for, or waits for it', () => {
  const stem = {
    id: 's',
    project_id: 'p1',
    delivery_id: 'd1',
    stem: 'warp_in',
    take_ids: ['t1'],
    file_name: 'warp_in__dry.wav',
    file_bytes: 1_200_000,
    sha256: 's',
    received_at: '2026-11-17T09:00:00Z',
  }
  const beside = rows([], detail({ dry_stems: [stem] }))
  expect(beside.done.map(({ state, detail: said }) => [state, said])).toEqual([
    ['passed', 'the dry stem of warp_in, 1.2 MB'],
  ])
  const waiting = rows([], detail({ dry_stems: [{ ...stem, take_ids: [] }] }))
  expect(waiting.open.map(({ state, detail: said }) => [state, said])).toEqual([
    ['waiting', 'the dry stem of warp_in, which is missing; add it to this delivery'],
  ])
})

test.each([
  ['warp_in.wav', null, 'SW-018'],
  ['warp_in_v03.wav', null, 'SW-018'],
  ['warp_in_altB.wav', null, 'SW-018'],
  ['warp_in__alt2_v1.wav', null, 'SW-018'],
  ['warp_in_v03__dry.wav', null, 'SW-018'],
  ['foot_02.wav', null, 'SW-008'],
  ['warp.wav', null, ''],
  ['warp.wav', 'c8', 'SW-008'],
])('%s dropped on %s goes to %s', (name, cueId, label) => {
  const labelOf = labelsOf([
    { id: 'c18', label: 'SW-018', stems: ['warp_in'] },
    { id: 'c8', label: 'SW-008', stems: ['foot_01', 'foot_02'] },
  ])
  expect(labelOf(upload({ name, cueId }))).toBe(label)
})

test.each([
  [{}, ['wav', 'rf64', 'flac']],
  [{ accept: { containers: ['wav'] } }, ['wav', 'rf64']],
  [
    { accept: { containers: ['wav'] }, categories: { vo: { accept: { containers: ['flac'] } } } },
    ['wav', 'rf64', 'flac'],
  ],
  [{ accept: { containers: 'any' } }, ['wav', 'rf64', 'flac']],
])('a spec of %j lets %j on their way', (tables, kinds) => {
  expect(acceptedFiles(tables).kinds).toEqual(kinds)
})

test('rates and depths are those of the spec and its categories', () => {
  const tables = {
    accept: { sample_rates_hz: [48_000], bit_depths: [24] },
    categories: { vo: { accept: { sample_rates_hz: [44_100], bit_depths: 'any' } } },
  }
  expect(acceptedFiles(tables)).toMatchObject({ sampleRatesHz: [44_100, 48_000], bitDepths: null })
})

const finding = (more: Partial<Finding>): Finding => ({
  check: 'sample-peak',
  code: 'sample-peak:over',
  severity: 'error',
  message: 'sample peak 0.00 dBFS, limit -0.1 dBFS',
  fix: 'lower the level by 0.10 dB or more',
  measured: 0,
  limit: -0.1,
  unit: 'dBFS',
  start_s: 0.418,
  end_s: 0.418,
  waived: false,
  ...more,
})

describe('a finding in words', () => {
  test('the figure first, then the limit, then what to do, with a true minus', () => {
    expect(wordsOf(finding({}))).toEqual({
      head: 'Sample peak 0.00 dBFS',
      rest: 'Limit −0.1 dBFS. Lower the level by 0.10 dB or more.',
      where: '0.418 s',
    })
  })

  test('a bracket of times is left to the place beside it', () => {
    const said = wordsOf(finding({ message: '3 runs of flat tops (0.414 s, 0.5 s, 0.6 s)', fix: 'listen there' }))
    expect(said).toMatchObject({ head: '3 runs of flat tops', rest: 'Listen there.' })
  })

  test('errors before warnings, then as the sound goes', () => {
    const order = worstFirst([
      finding({ code: 'late warning', severity: 'warning', start_s: 2 }),
      finding({ code: 'early warning', severity: 'warning', start_s: 0 }),
      finding({ code: 'error', start_s: 3 }),
      finding({ code: 'whole file', severity: 'warning', start_s: null }),
    ])
    expect(order.map(({ code }) => code)).toEqual(['error', 'early warning', 'late warning', 'whole file'])
  })

  test.each([
    [null, null, ''],
    [0.5, null, '0.500 s'],
    [0, 0.412, '0.000–0.412 s'],
  ])('from %s to %s is "%s"', (from, to, said) => {
    expect(spotOf(from, to)).toBe(said)
  })
})

describe('the line below the head', () => {
  const desk = (more: Partial<Desk>): Desk => ({
    came_back: [],
    came_back_next: null,
    came_back_cues: 0,
    to_make: [],
    to_make_next: null,
    to_make_cues: 0,
    with_approver: [],
    with_approver_next: null,
    with_approver_cues: 0,
    with_approver_files: 0,
    accepted: 6,
    cues: 23,
    unmatched: 0,
    checking: 0,
    questions: [],
    ...more,
  })
  test.each([
    [desk({}), 'Nothing to do: 6 of 23 cues accepted.'],
    [desk({ cues: 0 }), 'The sound list is empty. You get an email when there is something to do.'],
    [
      desk({ came_back_next: 'further', came_back_cues: 900, to_make_cues: 5000 }),
      '900 cues to fix, 5,000 cues to do.',
    ],
    [desk({ unmatched: 1, checking: 2 }), 'One file has no cue yet, two are being checked.'],
  ])('says what waits', (given, line) => {
    expect(deskLine(given)).toBe(line)
  })
})
