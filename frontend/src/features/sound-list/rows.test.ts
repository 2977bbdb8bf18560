import { expect, test } from 'vitest'

import { aCue, aNewestTake, aProgress } from '@/test/soundList'

import type { Cue, Question, CueProgress, Take } from './api'
import { blocksOf, groupsOf, matching, rowsOf, sumsOf } from './rows'
import { standsOf } from './stands'

const NOW = new Date('2026-11-21T10:00:00Z')
const said = ({ before, marked, after }: ReturnType<typeof standsOf>) => [before, marked, after]

const OVER = {
  check: 'sample-peak',
  code: 'sample-peak:over',
  severity: 'error',
  message: 'sample peak 0.00 dBFS, limit -0.1 dBFS',
  fix: '',
}

test('the worst finding stands first and is coloured up to its comma', () => {
  const cue = aCue(9, 'airlock_cycle')
  const stands = standsOf(cue, aProgress(cue, { status: 'returned', worst_finding: OVER }), {}, NOW)
  expect(said(stands)).toEqual(['', 'Sample peak 0.00 dBFS', ', limit −0.1 dBFS'])
  expect(stands.tone).toBe('bad')
})

test('a pick among alternates is said before a warning', () => {
  const cue = aCue(7, 'shield_hit')
  const warning = { ...OVER, severity: 'warning', message: 'true peak -0.60 dBTP, limit -1 dBTP' }
  const stands = standsOf(cue, aProgress(cue, { status: 'to_review', alternates: 3, worst_finding: warning }), {}, NOW)
  expect(said(stands)).toEqual(['Pick one of three. ', 'True peak −0.60 dBTP', ', limit −1 dBTP'])
  expect(stands.tone).toBe('warn')
})

test.each<[string, Partial<Cue>, Partial<CueProgress>, string]>([
  [
    'a cut',
    { state: 'cut', cut_reason: 'mines left', cut_at: '2026-11-09T12:00:00Z' },
    {},
    'Cut on 9 November, “mines left”',
  ],
  [
    'a whole set',
    { variations: 2 },
    { status: 'to_review', variations: [1, 2].map((variation) => ({ variation, stem: 's', status: 'to_review' })) },
    'All 2 conforming',
  ],
  [
    'a set with one missing',
    { variations: 2 },
    { status: 'to_review', variations: [{ variation: 1, stem: 's', status: 'to_review' }] },
    '1 of 2 here',
  ],
  ['a placeholder-file', {}, { status: 'placeholder' }, 'Placeholder in the build; it must not ship'],
  ['a concept', { state: 'concept' }, {}, 'Concept: not final, the work may be discarded'],
  ['a concept under review', { state: 'concept' }, { status: 'to_review' }, 'Conforming. Concept: may be discarded'],
  ['a broken check', {}, { status: 'unjudged' }, 'The check failed. That is our fault; no round is counted'],
  ['a change', {}, { status: 'change_requested', rounds: 2 }, 'Round 2 is with the designer'],
  ['part of a set', { variations: 8 }, { status: 'partly_accepted', accepted: 5 }, '3 variations missing'],
  ['a waiver', {}, { status: 'accepted', waived: true }, 'Waived'],
  ['an older spec', {}, { status: 'accepted', not_to_spec: true }, 'Accepted under an earlier spec'],
  ['nothing yet', {}, {}, ''],
])('%s', (_what, facts, progress, line) => {
  const cue = aCue(1, 'a', facts)
  expect(said(standsOf(cue, aProgress(cue, progress), {}, NOW)).join('')).toBe(line)
})

test('a question says when it was asked, and a file that may be the cue is named', () => {
  const asked = aCue(1, 'coolant_splash')
  const waits = aCue(2, 'victory_sting')
  const rows = rowsOf(
    [asked, waits],
    {
      progressList: [aProgress(asked, { status: 'question', open_question: 'What falls in?' }), aProgress(waits)],
      questions: [{ cue_id: asked.id, asked_at: '2026-11-16T10:00:00Z' } as Question],
      unmatched: [{ file_name: 'final_FINAL_sting2.wav', guesses: [{ cue_id: waits.id }] } as unknown as Take],
    },
    NOW,
  )
  expect(rows.map(({ stands }) => said(stands).join(''))).toEqual([
    'What falls in? Asked 5 days ago',
    'final_FINAL_sting2.wav may be for this cue; not matched yet',
  ])
})

const CUES = [
  aCue(1, 'ui_confirm', { category: 'ui' }),
  aCue(2, 'engine_idle', { category: 'vehicle', palette: true, loop: true }),
  aCue(3, 'mine_arm', { state: 'cut', cut_reason: 'gone' }),
]
const ROWS = rowsOf(
  CUES,
  {
    progressList: CUES.map((cue) =>
      aProgress(cue, cue.palette ? { status: 'accepted', newest_take: aNewestTake('t') } : {}),
    ),
  },
  NOW,
)

test('the palette comes first in list order; headings count what is accepted and what is cut', () => {
  expect(groupsOf(ROWS, 'list').map(({ name, note, rows }) => [name, note, rows.length])).toEqual([
    ['Palette', '1 of 1 accepted', 1],
    ['The rest', '0 of 1 accepted, 1 cut', 2],
  ])
  expect(groupsOf(ROWS, 'category').map(({ name }) => name)).toEqual(['ui', 'vehicle', 'weapon'])
  expect(groupsOf(ROWS, 'state').map(({ name }) => name)).toEqual(['To do', 'Accepted', 'Cut'])
  expect(sumsOf(ROWS, 14)).toBe('1 of 2 accepted; 1 cut; 14 files to review')
})

test('by playback priority 0 comes first, and cues without one are a group of their own', () => {
  const ranked = rowsOf(
    [null, 7, 0].map((priority, at) => aCue(at + 1, `cue_${at + 1}`, { playback_priority: priority })),
    {},
    NOW,
  )
  const groups = groupsOf(ranked, 'priority').map(({ note, rows }) => [note, rows.map(({ cue }) => cue.name)])
  expect(groups).toEqual([
    ['2 cues', ['cue_3', 'cue_2']],
    ['1 cue', ['cue_1']],
  ])
})

test('the filter wants every word, somewhere in the row', () => {
  const names = (words: string, rest = {}) => matching(ROWS, { words, ...rest }).map(({ cue }) => cue.name)
  expect(names('ENGINE vehicle')).toEqual(['engine_idle'])
  expect(names('sw-001')).toEqual(['ui_confirm'])
  expect(names('engine weapon')).toEqual([])
  expect(names('', { state: 'cut' })).toEqual(['mine_arm'])
  expect(names('', { category: 'ui' })).toEqual(['ui_confirm'])
})

test('who needs nobody is not bold; a set has one block a variation', () => {
  expect(ROWS.map(({ needsSomeone }) => needsSomeone)).toEqual([false, false, false])
  const set = aCue(4, 'step', { variations: 3 })
  const progress = aProgress(set, {
    status: 'returned',
    variations: [
      { variation: 1, stem: 'step_01', status: 'accepted' },
      { variation: 2, stem: 'step_02', status: 'returned' },
      { variation: 3, stem: 'step_03', status: 'to_make' },
    ],
  })
  const [row] = rowsOf([set], { progressList: [progress] }, NOW)
  expect(row?.needsSomeone).toBe(true)
  expect(row && blocksOf(row).map(({ tone }) => tone)).toEqual(['ok', 'bad', 'idle'])
})
