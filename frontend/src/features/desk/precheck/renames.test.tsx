import { File as NodeFile } from 'node:buffer'

import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { expect, test } from 'vitest'

import { draw } from '@/test/draw'
import { refusal, serve } from '@/test/server'
import type { Picked } from '@/uploads'

import { HeldFiles } from './HeldFiles'
import { judgeFile } from '@/precheck/judge'
import { Precheck } from './precheck'
import vectors from '@/precheck/vectors.json'

/** What the list calls files, by the names that they were dropped with. */
const LIST_NAMES: Record<string, string> = {
  'big laser.wav': 'laser.wav',
  'my shield.wav': 'shield.wav',
  'shield nearly.wav': 'shield.wav',
}
const PREVIEW = 'POST /v1/projects/p1/check-preview'
const CUES = ['laser.wav', 'shield.wav', 'shield_02.wav']

const pick = (path: string, of = 'conforms'): Picked => {
  const bytes = Uint8Array.from(atob(vectors.find(({ name }) => name === of)!.bytes), (one) => one.charCodeAt(0))
  return { file: new NodeFile([bytes], path.split('/').at(-1)!) as unknown as File, path }
}

/** A server that knows the names of CUES, as the one of the product does. */
async function drop(...picked: Picked[]) {
  const sent: string[] = []
  const answer = ({ body }: { body: unknown }) => ({
    checks: [{ name: 'sample-peak', label: 'Sample peak' }],
    specs: [vectors.find(({ name }) => name === 'conforms')!.spec],
    files: (body as { files: { file_name: string }[] }).files.map(({ file_name: name }) => ({
      cue: CUES.includes(name) ? { id: name, label: 'SW-001', name: name.replace('.wav', '') } : null,
      variation: null,
      length: null,
      spec: 0,
      is_dry_stem: false,
      list_name: LIST_NAMES[name] ?? null,
      findings: [],
    })),
  })
  const server = serve({ [PREVIEW]: answer })
  const made = new Precheck({
    projectId: 'p1',
    isSound: () => Promise.resolve(true),
    send: (files) => {
      sent.push(...files.map(({ path }) => path))
      return Promise.resolve()
    },
    judge: judgeFile,
  })
  draw(<HeldFiles precheck={made} />)
  await made.add(picked, null)
  return { made, sent, server }
}

const field = (name: string) => screen.findByRole('textbox', { name: `New name of ${name}` })
const names = (made: Precheck) => made.get().held.map(({ picked: { path } }) => path)
const press = async (name: RegExp | string) => userEvent.click(await screen.findByRole('button', { name }))
const RENAME_ALL = 'Rename all to the list’s names'

test('a name that no cue has waits with the list’s name; names without a likely cue go on their way', async () => {
  const { sent } = await drop(pick('big laser.wav'), pick('laser.wav'), pick('who knows.wav'))
  expect(await field('big laser.wav')).toHaveValue('laser.wav')
  expect(screen.getByText('1 file without a cue')).toBeVisible()
  expect(screen.getByRole('listitem')).toHaveTextContent('The name does not say which cue it is for.')
  expect(sent).toEqual(['laser.wav', 'who knows.wav'])
})

test('all are renamed at once, checked by their new names, and sent with them', async () => {
  const { sent, server } = await drop(pick('big laser.wav'), pick('my shield.wav'))
  await press(RENAME_ALL)
  expect(await screen.findByText('2 renamed files ready')).toBeVisible()
  expect(server.asked.at(-1)?.body).toEqual({
    files: ['laser.wav', 'shield.wav'].map((name) => ({ file_name: name, cue_id: null })),
    proposed: [],
  })
  expect(screen.getAllByRole('listitem')[0]).toHaveTextContent('laser.wav SW-001 laserRenamed from big laser.wav')
  expect(screen.getByRole('button', { name: 'Undo renaming' })).toHaveFocus()
  await press('Upload 2 renamed files')
  await waitFor(() => expect(sent).toEqual(['laser.wav', 'shield.wav']))
  expect(screen.queryByRole('list')).toBeNull()
})

test('all are renamed by a key, but not while a name is typed', async () => {
  const { made } = await drop(pick('big laser.wav'), pick('my shield.wav'))
  await userEvent.type(await field('big laser.wav'), '{Shift>}R{/Shift}')
  expect(names(made)).toEqual(['big laser.wav', 'my shield.wav'])
  await userEvent.type(await field('big laser.wav'), '{Backspace}')
  await userEvent.tab()
  await userEvent.keyboard('{Shift>}R{/Shift}')
  await waitFor(() => expect(names(made)).toEqual(['laser.wav', 'shield.wav']))
})

test('names that wait already are not proposed for another file', async () => {
  const { made, server } = await drop(pick('big laser.wav'))
  await field('big laser.wav')
  await made.add([pick('my shield.wav')], null)
  expect(server.asked.at(-1)?.body).toEqual({
    files: [{ file_name: 'my shield.wav', cue_id: null }],
    proposed: ['laser.wav'],
  })
  await press('Rename my shield.wav')
  await waitFor(() => expect(names(made)).toEqual(['big laser.wav', 'shield.wav']))
  expect(server.asked.at(-1)?.body).toMatchObject({ proposed: ['laser.wav'] })
})

test('undo puts the names back, one step after the other', async () => {
  const { made } = await drop(pick('big laser.wav'), pick('my shield.wav'))
  await userEvent.type(await field('my shield.wav'), '{Enter}')
  await waitFor(() => expect(names(made)).toEqual(['big laser.wav', 'shield.wav']))
  await press(RENAME_ALL)
  await waitFor(() => expect(names(made)).toEqual(['laser.wav', 'shield.wav']))
  await press('Undo renaming')
  expect(names(made)).toEqual(['big laser.wav', 'shield.wav'])
  await press('Undo renaming')
  expect(names(made)).toEqual(['big laser.wav', 'my shield.wav'])
  expect(await field('my shield.wav')).toHaveValue('shield.wav')
  expect(screen.queryByRole('button', { name: 'Undo renaming' })).toBeNull()
})

test('two files do not get one name: both fields say so, and another name is typed', async () => {
  const { made } = await drop(pick('big laser.wav'), pick('my shield.wav'), pick('shield nearly.wav'))
  expect(await field('my shield.wav')).toHaveAccessibleDescription(/Another file here has the name shield.wav too/)
  expect(await field('shield nearly.wav')).toBeInvalid()
  await press(RENAME_ALL)
  await waitFor(() => expect(names(made)).toEqual(['laser.wav', 'my shield.wav', 'shield nearly.wav']))
  const other = await field('shield nearly.wav')
  await userEvent.clear(other)
  await userEvent.type(other, 'shield_02.wav')
  expect(other).toBeValid()
  await press(RENAME_ALL)
  await waitFor(() => expect(names(made)).toEqual(['laser.wav', 'shield.wav', 'shield_02.wav']))
  expect(await screen.findByText('3 renamed files ready')).toBeVisible()
})

test.each([
  ['', 'The name is empty. Type a name.'],
  ['a/laser.wav', 'The name has a slash. Type a name without one.'],
  ['laser.flac', 'The name must end in .wav.'],
])('the name "%s" is not taken', async (name, problem) => {
  const { made } = await drop(pick('big laser.wav'))
  const of = await field('big laser.wav')
  await userEvent.clear(of)
  await userEvent.type(of, `${name}{Enter}`)
  expect(of).toHaveAccessibleDescription(problem)
  expect(names(made)).toEqual(['big laser.wav'])
})

test('a file of another sample rate is still held under its new name', async () => {
  const { sent } = await drop(pick('big laser.wav', '44100 Hz'))
  await press(RENAME_ALL)
  const row = within(await screen.findByRole('listitem'))
  expect(await row.findByText(/Renamed from/)).toBeVisible()
  expect(row.getByRole('button', { name: 'Upload anyway: laser.wav' })).toBeVisible()
  expect(screen.getByText('1 file would come back')).toBeVisible()
  expect(sent).toEqual([])
})

test('names stay where the server does not answer', async () => {
  const { made, server } = await drop(pick('big laser.wav'))
  server.answers[PREVIEW] = refusal(503, 'busy', 'The server is busy.')
  await press(RENAME_ALL)
  expect(await screen.findByRole('alert')).toHaveTextContent('The server is busy.')
  expect(names(made)).toEqual(['big laser.wav'])
})
