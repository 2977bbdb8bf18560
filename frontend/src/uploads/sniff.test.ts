import { describe, expect, test } from 'vitest'

import { bytes } from '@/test/upload'

import { judge, kindOf } from './sniff'

describe('what a file is, by its first bytes', () => {
  test.each([
    ['RIFF\x24\x00\x00\x00WAVEfmt ', 'wav'],
    ['RF64\xff\xff\xff\xffWAVEds64', 'rf64'],
    ['RIFF\x24\x00\x00\x00AVI LIST', 'unknown'],
    ['PK\x03\x04', 'zip'],
    ['ID3\x04', 'mp3'],
    ['\xff\xfb\x90\x64', 'mp3'],
    ['\xff\xff\xff\xff', 'mp3'],
    ['\xff\xf1\x50\x80', 'unknown'],
    ['fLaC', 'flac'],
    ['FORM\x00\x00\x00\x00AIFC', 'aiff'],
    ['OggS', 'ogg'],
    ['\x00\x00\x00\x20ftypM4A ', 'mp4'],
    ['version https://git-lfs.github.com/spec/v1\n', 'lfs-pointer'],
    ['hello', 'unknown'],
    ['', 'unknown'],
  ])('%j is %s', (first, kind) => {
    expect(kindOf(bytes(first))).toBe(kind)
  })
})

describe('what goes on its way', () => {
  test.each([
    ['laser.wav', 'wav', { send: 'sound' }],
    ['long.wav', 'rf64', { send: 'sound' }],
    ['all.zip', 'zip', { send: 'archive' }],
    // A damaged WAV is the worker's to judge: it says which rule it breaks.
    ['broken.wav', 'unknown', { send: 'sound' }],
  ] as const)('%s, which is %s', (name, kind, judged) => {
    expect(judge(name, 100, kind)).toEqual(judged)
  })

  test.each([
    ['vo_oath.wav', 100, 'mp3', 'This is an MP3 named .wav. Export a WAV. Nothing was uploaded.'],
    ['vo_oath.mp3', 100, 'mp3', 'This is an MP3. Export a WAV. Nothing was uploaded.'],
    ['laser.wav', 0, 'unknown', 'The file is empty (0 bytes). Export it again. Nothing was uploaded.'],
    ['laser.wav', 100, 'zip', 'This is a ZIP named .wav. Rename it to .zip. Nothing was uploaded.'],
    ['notes.txt', 100, 'unknown', 'Not an audio file or ZIP. Nothing was uploaded.'],
  ] as const)('%s of %s bytes, which is %s, is stopped in words', (name, size, kind, refused) => {
    expect(judge(name, size, kind)).toEqual({ refused })
  })

  test.each([
    [{ kinds: ['wav', 'rf64'], sampleRatesHz: [44_100], bitDepths: [16] }, 'a WAV, 44.1 kHz, 16 bit'],
    [
      { kinds: ['wav', 'rf64', 'flac'], sampleRatesHz: [44_100, 48_000, 96_000], bitDepths: [16, 24] },
      'a WAV or FLAC, 44.1, 48 or 96 kHz, 16 or 24 bit',
    ],
  ] as const)('a refused file is answered by the spec of its project', (accepts, wanted) => {
    expect(judge('vo_oath.mp3', 100, 'mp3', accepts)).toEqual({
      refused: `This is an MP3. Export ${wanted}. Nothing was uploaded.`,
    })
  })

  test('a FLAC goes where the project takes FLAC', () => {
    const accepts = { kinds: ['wav', 'flac'], sampleRatesHz: null, bitDepths: null } as const
    expect(judge('laser.flac', 100, 'flac', accepts)).toEqual({ send: 'sound' })
  })
})
