import { describe, expect, test } from 'vitest'

import checks from '@/test/checks.json'

import type { Check, Spec } from '../api'
import { categorySentence, changeSentence, expertSettings, sentencesOf } from './sentences'
import type { Tables } from './tables'

const CHECKS = checks as unknown as Check[]
const NO_TARGETS = { resolved: { targets: {} } } as unknown as Spec

const said = (tables: Tables, key: string, read = NO_TARGETS): string =>
  sentencesOf(tables, read, CHECKS)
    .find((sentence) => sentence.key === key)
    ?.text.replaceAll('**', '') ?? ''
const note = (tables: Tables, key: string): string =>
  sentencesOf(tables, NO_TARGETS, CHECKS).find((sentence) => sentence.key === key)?.note ?? ''

describe('masters', () => {
  const accept = {
    containers: ['wav'],
    encodings: ['pcm'],
    bit_depths: [24],
    sample_rates_hz: [48_000, 96_000],
    channels: [1, 2],
    duration_s: { min: 0.01, max: 30 },
  }

  test('all that is accepted, and that anything else comes back', () => {
    expect(said({ accept }, 'masters')).toBe(
      'Masters are WAV, PCM, 24 bit, 48 kHz or 96 kHz, mono or stereo, 0.01–30 s. Anything else is sent back.',
    )
  })

  test('what is not limited is any, and nothing follows from it', () => {
    expect(said({}, 'masters')).toBe(
      'Masters are any container, any bit depth, any sample rate, any number of channels, any length.',
    )
    expect(said({ accept: { channels: 'any', containers: ['flac'] } }, 'masters')).toBe(
      'Masters are FLAC, any bit depth, any sample rate, any number of channels, any length. Anything else is sent back.',
    )
  })

  test('each severity has its own consequence', () => {
    expect(said({ accept, checks: { duration: 'warning', channels: 'off' } }, 'masters')).toMatch(
      /Another container, encoding, sample rate or bit depth is sent back\. Another length gives a warning\. Another number of channels is not checked\.$/,
    )
  })
})

describe('levels', () => {
  test('each limit with what breaks it, and what is off is named', () => {
    const limits = { sample_peak_dbfs: -0.1, true_peak_dbtp: -1, loudness_lufs: { min: -30, max: -16 } }
    expect(said({ limits, checks: { 'true-peak': 'warning', clipping: 'off' } }, 'levels')).toBe(
      'A sample peak above −0.1 dBFS or a loudness below −30.0 LUFS or above −16.0 LUFS is sent back. ' +
        'A true peak above −1.0 dBTP or low level gives a warning. Not checked: clipping.',
    )
    expect(note({ limits }, 'levels')).toBe(
      '0.05 dB more passes, for rounding. A low level is judged by the check’s own limit.',
    )
    expect(note({ limits: { tolerance_db: 0.5, low_level_dbfs: -50 } }, 'levels')).toBe(
      '0.5 dB more passes, for rounding.',
    )
  })

  test('what the spec does not limit is no sentence, but for a check with a limit of its own', () => {
    expect(said({}, 'levels')).toBe('Low level or clipping gives a warning.')
    expect(said({ checks: { 'low-level': 'off', clipping: 'off' } }, 'levels')).toBe(
      'No level is limited. Not checked: low level and clipping.',
    )
    expect(said({ limits: { silence_below_dbfs: -60, dc_offset_percent: 0.5 } }, 'levels')).toMatch(
      /^A DC offset over 0\.5 % or a file or channel that stays below −60\.0 dBFS is sent back\./,
    )
  })
})

describe('start and end', () => {
  test('times are exact, and the level of silence is said', () => {
    const limits = { head_silence_ms: 5, tail_silence_ms: 100 }
    expect(said({ limits, checks: { 'tail-silence': 'warning' } }, 'edges')).toBe(
      'More than 5 ms of silence in front is sent back. More than 100 ms of silence at the end, internal silence, ' +
        'abrupt start or abrupt end gives a warning.',
    )
    expect(note({ limits }, 'edges')).toBe('Silence is what stays below −60 dBFS. Loops are left alone.')
    expect(note({ limits: { edge_silence_below_dbfs: -50 } }, 'edges')).toMatch(/below −50 dBFS/)
  })
})

describe('dryness', () => {
  test.each([
    [{}, 'The game adds no reverb, so only sounds that the list calls dry are checked for it.'],
    [
      { engine: { adds: ['reverb'] } },
      'Sounds come dry, because the game adds the reverb. Reverb in the file gives a warning.',
    ],
    [
      { engine: { adds: ['reverb'] }, checks: { 'baked-reverb': 'error' } },
      'Sounds come dry, because the game adds the reverb. Reverb in the file is sent back.',
    ],
    [{ checks: { 'baked-reverb': 'warning' } }, 'Sounds come dry. Reverb in the file gives a warning.'],
    [
      { engine: { adds: ['reverb'] }, checks: { 'baked-reverb': 'off' } },
      'Sounds come dry, because the game adds the reverb. Reverb in the file is not checked.',
    ],
  ])('%j', (tables: Tables, sentence) => {
    expect(said(tables, 'dryness')).toBe(sentence)
  })

  test('other effects are named', () => {
    expect(note({ engine: { adds: ['reverb', 'pitch'] } }, 'dryness')).toMatch(/^The game also adds pitch\./)
  })
})

describe('names', () => {
  test.each([
    [{}, 'Files have any name; they are matched by the sound list.'],
    [{ naming: { pattern: 'any' } }, 'Files have any name; they are matched by the sound list.'],
    [{ naming: { extension: '.wav' } }, 'Files have any name that ends in .wav. Another name is sent back.'],
    [
      { naming: { pattern: '[a-z0-9]+(_[a-z0-9]+)*', extension: '.wav' } },
      'Files are named like weapon_shield_hit_01.wav. Another name is sent back.',
    ],
    [
      { naming: { pattern: 'SFX_\\d+' }, checks: { naming: 'warning' } },
      'File names follow the pattern SFX_\\d+. Another name gives a warning.',
    ],
    [
      { naming: { tokens: [{ name: 'category' }, { name: 'what' }], separator: '-', extension: '.wav' } },
      'Files are named by parts: category-what.wav. Another name is sent back.',
    ],
    [{ naming: { grammar: 'ucs' } }, 'Files are named by the Universal Category System. Another name is sent back.'],
  ])('%j', (tables: Tables, sentence) => {
    expect(said(tables, 'names')).toBe(sentence)
  })
})

test('game files: how many, which, and what happens to a peak', () => {
  const target = { name: 'game', sample_rate_hz: 48_000, bit_depth: 16, encoding: 'pcm', channels: 'master' }
  const read = { resolved: { targets: { game: { ...target, over_peak: 'attenuate' } } } } as unknown as Spec
  expect(said({}, 'targets', read)).toMatch(/^From each master we make 1 game file: game at 48 kHz, 16 bit/)
  expect(said({}, 'targets')).toBe('No game file is made from a master.')
})

test('faults: every check of the server stands in one sentence, a new one too', () => {
  const added = { ...CHECKS.find(({ name }) => name === 'hum'), name: 'buzz', label: 'Buzz' } as Check
  const all = [...CHECKS, added]
  const texts = sentencesOf({}, NO_TARGETS, all).map(({ text, note: more = '' }) => `${text} ${more}`.toLowerCase())
  const faults = texts.at(-1) ?? ''
  expect(faults).toContain('file structure is sent back')
  expect(faults).toContain('buzz')
  for (const { label, limits } of all.filter((check) => check.limits.length === 0)) {
    expect(limits).toEqual([])
    const about = texts.filter((text) => text.includes(label.toLowerCase())).length
    const isAccepted = ['Container', 'Encoding', 'Sample rate', 'Bit depth', 'Channels', 'Length', 'Name']
    if (!isAccepted.includes(label) && label !== 'Baked-in reverb') expect([label, about]).toEqual([label, 1])
  }
  expect(said({ limits: { noise_floor_dbfs: -60, mono_loss_db: 6, variation_level_lu: 3 } }, 'faults')).toMatch(
    /background noise above −60\.0 dBFS is sent back.*losing more than 6\.0 dB in mono.*a variation more than 3\.0 LU from its set/,
  )
})

test('a category says only what differs', () => {
  const tables = { categories: { music: { kind: 'music', accept: { duration_s: { max: 300 } } }, ui: {} } }
  expect(categorySentence(tables, 'music', CHECKS).text).toBe('Sounds are music; up to 300 s.')
  expect(categorySentence(tables, 'ui', CHECKS).text).toBe('As every sound.')
})

test('a setting without a sentence is named as one', () => {
  const tables = {
    format: 1,
    accept: { channels: [1], channel_layouts: ['5.1'] },
    limits: { true_peak_dbtp: -1, crest_db: 12 },
    naming: { pattern: 'any', portable: true },
    metadata: { required: ['ICMT', 'IART'] },
    checks: { 'true-peak': 'warning', 'not-here': 'error' },
    targets: { game: { bit_depth: 16 } },
  }
  expect(expertSettings(tables, CHECKS).map(({ text }) => text.replaceAll('**', ''))).toEqual([
    'accept.channel_layouts is 5.1.',
    'limits.crest_db is 12.',
    'naming.portable is true.',
    'metadata.required is ICMT, IART.',
    'checks.not-here is error.',
  ])
})

test.each([
  [
    'targets.handheld',
    { sample_rate_hz: 22_050, bit_depth: 16, channels: 1 },
    'Game files for handheld are made, at 22.05 kHz, 16 bit, mono.',
  ],
  ['targets.handheld', null, 'Game files for handheld are no longer made.'],
  ['targets.switch.budget_bytes', 48_000_000, 'The game files of switch may have up to 48.0 MB together.'],
  ['naming.separator', '-', 'The separator becomes -.'],
  ['naming.ucs_ids', null, 'The ucs ids is left out.'],
])('the change of %s to %j is a sentence', (place, after, text) => {
  expect(changeSentence(place, after, {}, CHECKS).text).toBe(text)
})

test('the change of a category reads as its sentence', () => {
  const tables = { categories: { music: { kind: 'music' } } }
  expect(changeSentence('categories.music', { kind: 'music' }, tables, CHECKS).text).toBe('Sounds are music.')
})
