import { File as NodeFile } from 'node:buffer'

import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { expect, test, vi } from 'vitest'

import { StatusSlot } from '@/app/toast'
import { draw } from '@/test/draw'
import { serve } from '@/test/server'
import type { Picked } from '@/uploads'

import { HeldFiles } from './HeldFiles'
import { judgeFile } from '@/precheck/judge'
import { Precheck } from './precheck'
import vectors from '@/precheck/vectors.json'

const vector = (name: string) => vectors.find((one) => one.name === name)!
const bytesOf = (base64: string) => Uint8Array.from(atob(base64), (one) => one.charCodeAt(0))
const pick = (path: string, of: string): Picked => ({
  file: new NodeFile([bytesOf(vector(of).bytes)], path) as unknown as File,
  path,
})
const WRONG = pick('laser.wav', '44100 Hz')
const LOUD = pick('laser.wav', 'peak at 0.0 dBFS')
const GOOD = pick('shield.wav', 'conforms')
const ODD = pick('odd.wav', 'bytes after the end')
const CUE = { id: 'c1', label: 'SW-001', name: 'laser' }
const NO_CUE = { cue: null, variation: null, length: null, spec: 0, is_dry_stem: false, list_name: null, findings: [] }

function precheck(files: object[], failing = false, isSound: (file: File) => boolean = () => true) {
  const sent: string[] = []
  const { asked } = serve({
    'POST /v1/projects/p1/check-preview': {
      checks: [{ name: 'sample-peak', label: 'Sample peak' }],
      specs: [vector('conforms').spec],
      files,
    },
  })
  const send = vi.fn((picked: readonly Picked[]) => {
    if (failing) return Promise.reject(new Error('no'))
    sent.push(...picked.map(({ path }) => path))
    return Promise.resolve()
  })
  const made = new Precheck({
    projectId: 'p1',
    isSound: (file) => Promise.resolve(isSound(file)),
    send,
    judge: judgeFile,
  })
  return { made, sent, asked }
}

const held = () => within(screen.getByRole('list', { name: 'Files that wait for your decision' }))

test('what passes is sent at once; what would come back waits, with what is wrong and the fix', async () => {
  const { made, sent, asked } = precheck([{ ...NO_CUE, cue: CUE }, NO_CUE, NO_CUE])
  draw(<HeldFiles precheck={made} />)
  await made.add([WRONG, GOOD, ODD], null)
  expect(sent).toEqual(['shield.wav', 'odd.wav'])
  expect(asked[0]?.body).toEqual({
    files: ['laser.wav', 'shield.wav', 'odd.wav'].map((name) => ({ file_name: name, cue_id: null })),
    proposed: [],
  })
  expect(await screen.findByText('1 file would come back')).toBeVisible()
  expect(held().getByRole('listitem')).toHaveTextContent('laser.wav SW-001 laser')
  expect(held().getByRole('listitem')).toHaveTextContent('Sample rate 44100 Hz. Accepted 48000, 96000 Hz.')
  expect(held().getByRole('listitem')).toHaveTextContent('Export the session at 48000 Hz; do not convert this file up')
  expect(screen.getByText(/2 other files passed and are on the way/)).toHaveTextContent('sample peak')
})

test.each([
  ['peak at 0.0 dBFS', 'A fix lowers the level by 1.00 dB.'],
  ['float of 64 bit over full scale', 'A fix lowers the level by 2.23 dB and brings it to 24 bit.'],
  ['RF64', 'A fix writes it as WAV.'],
  ['sizes left open', 'A fix rewrites the sizes in the header.'],
])('%s is fixable: it says what the fix does, and is sent without "anyway"', async (of, words) => {
  const { made, sent } = precheck([{ ...NO_CUE, cue: CUE }])
  draw(<HeldFiles precheck={made} />)
  await made.add([pick('laser.wav', of)], null)
  expect(await screen.findByText('1 file fixable after the upload')).toBeVisible()
  const row = held().getByRole('listitem')
  expect(row).toHaveTextContent(words)
  expect(row).not.toHaveTextContent(/export|lower the level by/i)
  expect(screen.queryByRole('button', { name: /anyway/ })).toBeNull()
  await userEvent.click(held().getByRole('button', { name: 'Upload laser.wav' }))
  await waitFor(() => expect(sent).toEqual(['laser.wav']))
})

test('tops that are cut off are not brought back by a lower level, and the row says so', async () => {
  const { made } = precheck([{ ...NO_CUE, cue: CUE }])
  draw(<HeldFiles precheck={made} />)
  await made.add([pick('laser.wav', 'tops cut off at 0.0 dBFS')], null)
  const row = (await screen.findAllByRole('listitem'))[0]
  expect(row).toHaveTextContent(/Its tops are cut off flat, and a lower level leaves them so: lower the gain before/)
  expect(row).toHaveTextContent('A fix lowers the level by 1.00 dB, which leaves its cut-off tops flat.')
})

test('what the queue refuses goes to it, and is not said to have passed', async () => {
  const { made, sent } = precheck([{ ...NO_CUE, cue: CUE }, NO_CUE], false, ({ name }) => name.endsWith('.wav'))
  draw(<HeldFiles precheck={made} />)
  await made.add([LOUD, pick('sting.aiff', 'AIFF as sound.aiff'), GOOD], null)
  expect(sent).toEqual(['sting.aiff', 'shield.wav'])
  expect(await screen.findByText(/1 other file passed and is on the way/)).toBeVisible()
})

test('one that waits is sent all the same, by keys', async () => {
  const { made, sent } = precheck([NO_CUE])
  draw(<HeldFiles precheck={made} />)
  await made.add([WRONG], 'c1')
  const anyway = await screen.findByRole('button', { name: 'Upload anyway: laser.wav' })
  anyway.focus()
  await userEvent.keyboard('{Enter}')
  await waitFor(() => expect(sent).toEqual(['laser.wav']))
  expect(screen.queryByRole('list', { name: 'Files that wait for your decision' })).toBeNull()
})

test('what is left out is back with undo', async () => {
  const { made, sent } = precheck([NO_CUE, NO_CUE])
  draw(
    <>
      <HeldFiles precheck={made} />
      <StatusSlot />
    </>,
  )
  await made.add([LOUD, pick('boom.wav', 'peak at -0.9 dBFS')], null)
  await userEvent.click(await screen.findByRole('button', { name: 'Leave out all 2' }))
  expect(await screen.findByText('2 files left out. Nothing was uploaded.')).toBeVisible()
  await waitFor(() => expect(screen.queryByRole('list', { name: 'Files that wait for your decision' })).toBeNull())
  await userEvent.click(screen.getByRole('button', { name: /Undo/ }))
  await waitFor(() => expect(held().getAllByRole('listitem')).toHaveLength(2))
  expect(sent).toEqual([])
})

test('a name that breaks the rules is held in the words of the server', async () => {
  const finding = {
    code: 'naming:pattern',
    check: 'naming',
    severity: 'error',
    message: 'name "Laser", pattern [a-z_]+',
    fix: 'rename it to laser.wav',
    measured: null,
    limit: null,
    unit: null,
    start_s: null,
    end_s: null,
    waived: false,
  }
  const { made, sent } = precheck([{ ...NO_CUE, findings: [finding] }])
  draw(<HeldFiles precheck={made} />)
  await made.add([GOOD], null)
  expect(await screen.findByText(/Rename it to laser.wav/)).toBeVisible()
  expect(sent).toEqual([])
})

test('files go on their way where the server does not say what they are judged by', async () => {
  const { made, sent } = precheck([])
  serve({})
  await made.add([LOUD], null)
  expect(sent).toEqual(['laser.wav'])
})

test('files that could not be sent wait again', async () => {
  const { made } = precheck([NO_CUE], true)
  draw(<HeldFiles precheck={made} />)
  await made.add([WRONG], null)
  await userEvent.click(await screen.findByRole('button', { name: 'Upload all anyway' }))
  await waitFor(() => expect(held().getByRole('listitem')).toHaveTextContent('laser.wav'))
  expect(screen.getByRole('alert')).toBeVisible()
})

test('a thousand files are asked about fifty at a time, and all that pass are sent', async () => {
  const { made, sent, asked } = precheck(Array.from({ length: 50 }, () => NO_CUE))
  await made.add(
    Array.from({ length: 1000 }, (_, index) => pick(`step_${index}.wav`, 'conforms')),
    null,
  )
  expect(sent).toHaveLength(1000)
  expect(asked).toHaveLength(20)
  expect(made.get()).toMatchObject({ held: [], judged: 1000, dropped: 1000, passed: 1000 })
})
