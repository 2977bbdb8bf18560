import { describe, expect, test } from 'vitest'

import { groupsOf, inGeneral, judgementsOf, textsOf } from './figures'

const said = (facts: object, measurements: object) =>
  Object.fromEntries(
    groupsOf({ ...facts }, { ...measurements }).flatMap(({ lines }) =>
      lines.map(({ what, said: words }) => [what, words]),
    ),
  )

describe('figures in words', () => {
  test('have a unit, a true minus, and silence in words of its own', () => {
    expect(
      said(
        {
          container: 'wav',
          encoding: 'pcm',
          sample_rate_hz: 96_000,
          bit_depth: 24,
          channels: 2,
          chunks: ['fmt ', 'data'],
        },
        { sample_peak_dbfs: -1.25, true_peak_dbtp: null, loudness_range_lu: 3.24, head_silence_ms: 412, crest_db: 9 },
      ),
    ).toEqual({
      Container: 'WAV',
      Encoding: 'integer (PCM)',
      'Sample rate': '96 kHz',
      'Bit depth': '24 bit',
      Channels: 'stereo',
      Chunks: 'fmt, data',
      'Sample peak': '−1.3 dBFS',
      'True peak': '−∞ dBTP',
      'Loudness range': '3.2 LU',
      'Leading silence': '412 ms',
      'Crest factor': '9.0 dB',
    })
  })

  test('loudness that is not defined says why', () => {
    expect(said({}, { integrated_lufs: null, short_loudness_lufs: -17.7 })).toEqual({
      Integrated: 'not defined below 0.4 s',
      'Loudest 400 ms': '−17.7 LUFS',
    })
  })

  test('what two channels are to each other is not said of one', () => {
    expect(said({ channels: 1 }, { channel_correlation: null, mono_loss_db: null })).toEqual({ Channels: 'mono' })
    expect(said({ channels: 2 }, { channel_correlation: null })).toMatchObject({
      'Channel correlation': 'only one channel has sound',
    })
  })

  test('a figure of a check that is newer than this page is named and given its unit by its name', () => {
    const [group] = groupsOf(
      {},
      { noise_slope_db: -3.21, wow_percent: 0.5, grain_hz: 1_250, odd_frames: 7, is_odd: true },
    )
    expect(group?.title).toBe('More measurements')
    expect(group?.lines.map(({ what, said: words }) => `${what}: ${words}`)).toEqual([
      'Noise slope: −3.2 dB',
      'Wow: 0.50 %',
      'Grain: 1.3 kHz',
      'Odd frames: 7',
      'Is odd: yes',
    ])
    expect(inGeneral('echo_s', null)?.said).toBe('not measured')
    expect(inGeneral('table', { deep: 1 })).toBeNull()
  })

  test('none of a fault is not marked, though its check found another', () => {
    const lines = groupsOf({}, { clipped_runs: 84, soft_tops: 0 }).flatMap((group) => group.lines)
    expect(lines.map(({ said: words, check }) => [words, check])).toEqual([
      ['84', 'clipping'],
      ['none', undefined],
    ])
  })
})

test('texts of the file keep the names of chunk and field', () => {
  expect(textsOf({ metadata: { fields: { 'bext.Originator': 'Recorder', 'INFO.ISFT': 'Editor' } } })).toEqual([
    { name: 'bext.Originator', what: 'bext.Originator', said: 'Recorder' },
    { name: 'INFO.ISFT', what: 'INFO.ISFT', said: 'Editor' },
  ])
  expect(textsOf({})).toEqual([])
})

test('a judgement asks, and answers with its score', () => {
  expect(judgementsOf({ reverb: { verdict: 'undecided', score: 0.48 }, novel: { verdict: 'dry' } })).toEqual([
    { name: 'reverb', what: 'Reverb?', said: 'undecided, score 0.48' },
    { name: 'novel', what: 'Novel?', said: 'dry' },
  ])
})
