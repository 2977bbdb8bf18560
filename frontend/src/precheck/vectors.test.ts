import { File as NodeFile } from 'node:buffer'

import { expect, test } from 'vitest'

import { CHECKED_HERE } from './checks'
import type { CueLength, Finding, SpecView } from './findings'
import { judgeFile } from './judge'
import { fixed, general } from './numbers'
import { peaksOf, wavSlices } from './peaks'
import { readLayout } from './wav'
import vectors from './vectors.json'

/** What only the server says. */
const LEFT_TO_SERVER = ['bytes after the end', 'not a number']

const bytesOf = (base64: string) => Uint8Array.from(atob(base64), (one) => one.charCodeAt(0))
/** The last digits of a logarithm depend on the machine; no sentence does. */
const near = (findings: readonly Finding[]) =>
  findings.map((one) => ({ ...one, measured: one.measured === null ? null : Number(one.measured.toFixed(9)) }))

test.each(vectors)('$name: what the server finds', async ({ name, fileName, bytes, spec, length, expected }) => {
  const file = new NodeFile([bytesOf(bytes)], fileName) as unknown as File
  const judgement = await judgeFile({ file, spec: spec as SpecView, length: length as CueLength })
  if (LEFT_TO_SERVER.includes(name)) {
    expect(judgement).toBeNull()
    return
  }
  expect(judgement?.isUnreadable).toBe(expected.isUnreadable)
  expect(near(judgement?.findings ?? [])).toEqual(near(expected.findings as Finding[]))
})

test('every check that is made here finds something in some vector', () => {
  const codes = vectors.flatMap(({ expected }) => expected.findings.map(({ code }) => code.split(':')[0]))
  expect(CHECKED_HERE.filter((name) => !codes.includes(name))).toEqual([])
})

test('a long file is read in slices', async () => {
  const data = 24 * 2 ** 20
  const head = new Uint8Array(44)
  const view = new DataView(head.buffer)
  const write = (at: number, text: string) =>
    head.set(
      [...text].map((one) => one.charCodeAt(0)),
      at,
    )
  write(0, 'RIFF')
  view.setUint32(4, 36 + data, true)
  write(8, 'WAVEfmt ')
  view.setUint32(16, 16, true)
  ;[1, 2].forEach((value, index) => view.setUint16(20 + 2 * index, value, true))
  view.setUint32(24, 48_000, true)
  view.setUint32(28, 288_000, true)
  ;[6, 24].forEach((value, index) => view.setUint16(32 + 2 * index, value, true))
  write(36, 'data')
  view.setUint32(40, data, true)
  const last = 44 + data - 3
  const sizes: number[] = []
  const read = (offset: number, count: number) => {
    sizes.push(count)
    const bytes = new Uint8Array(Math.min(count, 44 + data - offset))
    if (offset === 0) bytes.set(head.subarray(0, bytes.length))
    else if (offset < 44) bytes.set(head.subarray(offset, offset + bytes.length))
    if (last >= offset && last < offset + bytes.length) bytes[last - offset + 2] = 0xc0 // half of full scale, below zero
    return Promise.resolve(bytes)
  }
  const layout = await readLayout(read, 44 + data)
  const peaks = await peaksOf(layout, wavSlices(layout, read))
  expect([...peaks.channels]).toEqual([0, 0.5])
  expect(peaks.frame).toBe(layout.frames - 1)
  expect(Math.max(...sizes)).toBeLessThanOrEqual(4 * 2 ** 20)
})

test.each([
  [0.0625, 3, '0.062'],
  [0.1875, 3, '0.188'],
  [2.5, 0, '2'],
  [-0.001, 2, '0.00'],
  [-1.005, 2, '-1.00'],
  [1234.5678, 1, '1234.6'],
])('%d with %d decimals is %s, as the server writes it', (value, decimals, text) => {
  expect(fixed(value, decimals)).toBe(text)
})

test.each([
  [0.1, '0.1'],
  [60, '60'],
  [1234567, '1.23457e+06'],
  [0.00001, '1e-05'],
  [-12.345678, '-12.3457'],
])('%d in six digits is %s', (value, text) => {
  expect(general(value)).toBe(text)
})
