import { createHash } from 'node:crypto'
import { gunzipSync } from 'node:zlib'

import { fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeEach, expect, test, vi } from 'vitest'

import { openApp } from '@/test/openApp'
import { inProject } from '@/test/project'
import { answer, refusal, serve, wrote } from '@/test/server'

import { formatOf, readFolder, soundsOf } from './folder'
import { packProject, projectIn } from './gameProject'

const AT = '2026-11-26T10:00:00Z'
const PLAN = {
  cues: [
    { name: 'click', file_name: 'click', category: 'ui', paths: ['ui/click.wav'], loop: true, events: ['Play_click'] },
    {
      name: 'grass',
      file_name: 'grass',
      category: 'steps',
      paths: ['steps/grass_01.wav', 'steps/grass_02.wav'],
      loop: false,
      events: [],
    },
  ],
  files: 3,
  sets: 1,
  categories: { steps: 1, ui: 1 },
  duplicates: [['ui/click.wav', 'ui/tap.wav']],
  oddities: [{ path: 'ui/click.wav', code: 'format', message: '22050 Hz, most files have 44100 Hz' }],
  skipped: [{ path: 'theme.wma', code: 'coded', message: 'WAV, FLAC, Ogg, Opus and MP3 are adopted, found wma' }],
  project: null as object | null,
}
const PLAYED = {
  name: 'Game.wproj',
  engine: 'wwise',
  version: '',
  played: 2,
  unread_count: 1,
  unread: ['a.wwu: is not XML'],
}
const ADOPTION = {
  id: 'a1',
  project_id: 'p1',
  folder: 'Sounds',
  created_at: AT,
  adopted_by: null as object | null,
  adopted_at: null as string | null,
  undone_at: null as string | null,
}
const ADOPTED = { ...ADOPTION, adopted_by: { id: 'x1', name: 'Producer' }, adopted_at: AT }
const PROGRESS = {
  ...ADOPTED,
  takes: 3,
  checked: 3,
  conforming: 2,
  rendered: 3,
  odd: [
    {
      cue_id: 'c1',
      take_id: 't1',
      label: 'SW-001',
      file_name: 'click.wav',
      verdict: 'rejected',
      messages: ['true peak 0.1 dBTP, limit −1.0 dBTP'],
    },
  ],
}

function wav(rate: number, bits: number): Uint8Array<ArrayBuffer> {
  const head = new DataView(new ArrayBuffer(44))
  const text = (at: number, word: string) =>
    [...word].forEach((sign, place) => head.setUint8(at + place, sign.charCodeAt(0)))
  text(0, 'RIFF')
  text(8, 'WAVEfmt ')
  head.setUint32(16, 16, true)
  head.setUint32(24, rate, true)
  head.setUint16(34, bits, true)
  text(36, 'data')
  return new Uint8Array(head.buffer)
}

/** WebCrypto of Node takes no buffers of jsdom. */
beforeEach(() => {
  const digest = (_: string, bytes: ArrayBuffer) =>
    Promise.resolve(new Uint8Array(createHash('sha256').update(new Uint8Array(bytes)).digest()).buffer)
  vi.stubGlobal('crypto', { getRandomValues: crypto.getRandomValues.bind(crypto), subtle: { digest } })
})

/** A file as browsers give it; that of jsdom has no bytes. */
function fileOf(bytes: Uint8Array<ArrayBuffer>, name: string): File {
  const file = new File([bytes], name)
  const read = () => Promise.resolve(bytes.buffer.slice(0))
  Object.defineProperty(file, 'arrayBuffer', { value: read })
  Object.defineProperty(file, 'slice', { value: () => ({ arrayBuffer: read }) })
  return file
}

function folderOf(...paths: string[]): File[] {
  return paths.map((path) => {
    const file = fileOf(wav(44_100, 16), path.split('/').at(-1) ?? '')
    Object.defineProperty(file, 'webkitRelativePath', { value: `Sounds/${path}` })
    return file
  })
}

function open(part: 'producer' | 'designer' = 'producer', more: object = {}, path = '') {
  const { asked } = serve(
    inProject(part, {
      'GET /v1/projects/p1/adoptions': part === 'producer' ? [] : refusal(403, 'team-needed', 'only the team'),
      'POST /v1/projects/p1/adoption-plan': answer(PLAN),
      'POST /v1/projects/p1/adoptions': answer({ ...ADOPTION, plan: PLAN, missing: ['ui/click.wav'] }, 201),
      'POST /v1/uploads': answer(null, 201),
      'POST /v1/adoptions/a1/adopt': answer({ ...ADOPTED, cues: 2, takes: 3, skipped: [] }),
      'GET /v1/adoptions/a1': PROGRESS,
      ...more,
    }),
  )
  openApp(`/projects/p1/sound-list/adopt${path}`)
  return asked
}

test('a folder is planned before anything is sent, then sent and adopted', { tags: ['slow'] }, async () => {
  const asked = open()
  const field = await screen.findByLabelText('Folder')
  fireEvent.change(field, { target: { files: folderOf('ui/click.wav', 'ui/tap.wav', 'readme.txt') } })
  const plan = await screen.findByRole('region', { name: 'What happens to each file' })
  expect(within(plan).getByText(/3 files become 2 cues in 2 categories, 1 of them a set/)).toBeVisible()
  expect(within(plan).getByText('22050 Hz, most files have 44100 Hz')).toBeVisible()
  expect(within(plan).getByText('also ui/tap.wav')).toBeVisible()
  expect(within(plan).getByText('WAV, FLAC, Ogg, Opus and MP3 are adopted, found wma')).toBeVisible()
  const [planned] = wrote(asked, 'POST /v1/projects/p1/adoption-plan')
  expect(planned?.body).toMatchObject({
    folder: 'Sounds',
    files: [{ path: 'ui/click.wav', size_bytes: 44, sample_rate_hz: 44_100, bit_depth: 16 }, { path: 'ui/tap.wav' }],
  })
  expect(wrote(asked, 'POST /v1/projects/p1/adoptions')).toEqual([])
  const found = await axe.run(document.body)
  expect(found.violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html}`)).toEqual([])
  await userEvent.click(within(plan).getByRole('button', { name: 'Adopt 3 files' }))
  expect(await screen.findByText('3 of 3 sounds checked, 3 with game files.')).toBeVisible()
  expect(screen.getByText('true peak 0.1 dBTP, limit −1.0 dBTP')).toBeVisible()
  expect(screen.getByText('2 of 3 conform to the delivery spec; these stand out:')).toBeVisible()
})

test('a refused plan says why and keeps the page', async () => {
  open('producer', { 'POST /v1/projects/p1/adoption-plan': refusal(422, 'path-twice', 'a.wav is there twice') })
  const field = await screen.findByLabelText('Folder')
  fireEvent.change(field, { target: { files: folderOf('a.wav') } })
  expect(await screen.findByRole('alert')).toHaveTextContent('a.wav is there twice')
  expect(screen.getByRole('button', { name: /Choose a folder/ })).toBeVisible()
})

test('a folder that the command line sent is adopted with one press, once every file is there', async () => {
  const sent = { ...PROGRESS, ...ADOPTION, takes: 0, checked: 0, rendered: 0, odd: [] }
  open(
    'producer',
    {
      'GET /v1/adoptions/a1': sent,
      'GET /v1/adoptions/a1/plan': { ...ADOPTION, plan: PLAN, missing: ['ui/click.wav', 'ui/tap.wav'] },
    },
    '?adoption=a1',
  )
  const button = await screen.findByRole('button', { name: 'Adopt 3 files of Sounds' })
  expect(button).toBeDisabled()
  expect(screen.getByText('2 files are not uploaded yet.')).toBeVisible()
})

test('an adoption is undone where it stands, or says why not', async () => {
  open(
    'producer',
    { 'POST /v1/adoptions/a1/undo': refusal(409, 'adoption-in-use', 'a verdict was given since') },
    '?adoption=a1',
  )
  await userEvent.click(await screen.findByRole('button', { name: 'Undo the adoption' }))
  expect(await screen.findByRole('alert')).toHaveTextContent('A verdict was given since.')
})

test('who may not adopt reads who may', async () => {
  open('designer')
  expect(await screen.findByRole('heading', { name: /Only a producer or the project’s approver/ })).toBeVisible()
  expect(screen.queryByLabelText('Folder')).toBeNull()
})

test('what is not a sound is left out, and the outermost folder is the name', async () => {
  const picked = [
    { file: fileOf(wav(48_000, 24), 'a.wav'), path: 'Game/ui/a.wav' },
    { file: new File(['x'], 'b.txt'), path: 'Game/b.txt' },
    { file: new File([], 'c.wav'), path: 'Game/c.wav' },
  ]
  const folder = await readFolder(soundsOf(picked), () => undefined)
  expect(folder.name).toBe('Game')
  expect(folder.files.map(({ path, sample_rate_hz: hz, bit_depth: bits }) => [path, hz, bits])).toEqual([
    ['ui/a.wav', 48_000, 24],
  ])
})

test('a header says rate and depth, or nothing', () => {
  const flac = new DataView(new ArrayBuffer(26))
  ;[0x66, 0x4c, 0x61, 0x43].forEach((byte, at) => flac.setUint8(at, byte))
  flac.setUint32(18, (44_100 << 12) | (1 << 9) | (15 << 4)) // two channels, 16 bit
  expect(formatOf(flac)).toEqual({ sample_rate_hz: 44_100, bit_depth: 16 })
  const ogg = (header: string, rate: number) => {
    const head = new DataView(new ArrayBuffer(64))
    ;[...`OggS${'\0'.repeat(24)}${header}`].forEach((sign, at) => head.setUint8(at, sign.charCodeAt(0)))
    head.setUint32(40, rate, true)
    return head
  }
  expect(formatOf(ogg('\u0001vorbis', 22_050))).toEqual({ sample_rate_hz: 22_050, bit_depth: null })
  expect(formatOf(ogg('OpusHead', 0))).toEqual({ sample_rate_hz: 48_000, bit_depth: null })
  expect(formatOf(ogg('Speex   ', 8_000))).toEqual({ sample_rate_hz: null, bit_depth: null })
  expect(formatOf(new DataView(new ArrayBuffer(3)))).toEqual({ sample_rate_hz: null, bit_depth: null })
})

test('the sound list leads to it', async () => {
  serve(
    inProject('producer', {
      'GET /v1/projects/p1/sound-list': { revision: 0, next: null, cues: [] },
    }),
  )
  openApp('/projects/p1/sound-list')
  const link = await screen.findByRole('link', { name: 'Import existing game audio' })
  await waitFor(() => expect(link).toHaveAttribute('href', '/projects/p1/sound-list/adopt'))
})

/** Unpack what was sent, as the server does. */
const unpacked = (content: string): unknown => JSON.parse(gunzipSync(Buffer.from(content, 'base64')).toString())

const textFile = (path: string, text: string) => {
  const file = fileOf(new TextEncoder().encode(text), path.split('/').at(-1) ?? '')
  Object.defineProperty(file, 'webkitRelativePath', { value: path })
  return file
}

test('the project of the game is sent beside the folder, and what it says is shown', async () => {
  const unused = { path: 'ui/tap.wav', code: 'unused', message: 'no event plays it in the project' }
  const asked = open('producer', {
    'POST /v1/projects/p1/adoption-plan': answer({ ...PLAN, oddities: [unused], project: PLAYED }),
  })
  const field = await screen.findByLabelText('Folder')
  fireEvent.change(field, { target: { files: folderOf('ui/click.wav', 'ui/tap.wav') } })
  await screen.findByRole('button', { name: 'Add the game’s project' })
  fireEvent.change(screen.getByLabelText('Project of the game'), {
    target: { files: [textFile('Game/Game.wproj', '<a/>'), textFile('Game/Events/e.wwu', '<b/>')] },
  })
  await screen.findByRole('button', { name: 'Choose another project' })
  const plan = screen.getByRole('region', { name: 'What happens to each file' })
  expect(within(plan).getByText(/Game.wproj plays 2 of these files/)).toBeVisible()
  expect(within(plan).getByText('no event plays it in the project')).toBeVisible()
  expect(within(plan).getByText('a.wwu: is not XML')).toBeVisible()
  expect(within(plan).getByText('ui/click.wav; loops; played by Play_click')).toBeInTheDocument()
  const sent = wrote(asked, 'POST /v1/projects/p1/adoption-plan').at(-1)?.body as {
    project: { path: string; content_base64: string }
  }
  expect(sent.project.path).toBe('Game.wproj')
  expect(unpacked(sent.project.content_base64)).toEqual({ 'Game.wproj': '<a/>', 'Events/e.wwu': '<b/>' })
  await userEvent.keyboard('{Escape}')
  await userEvent.click(within(plan).getByRole('button', { name: 'Adopt 3 files' }))
  await waitFor(() => expect(wrote(asked, 'POST /v1/adoptions/a1/adopt')).toHaveLength(1))
  expect(wrote(asked, 'POST /v1/projects/p1/adoptions')[0]?.body).toMatchObject({ project: { path: 'Game.wproj' } })
})

test('a folder without a project is refused as one, and the plan stays', async () => {
  open()
  const field = await screen.findByLabelText('Folder')
  fireEvent.change(field, { target: { files: folderOf('ui/click.wav') } })
  await screen.findByRole('region', { name: 'What happens to each file' })
  fireEvent.change(screen.getByLabelText('Project of the game'), { target: { files: folderOf('ui/click.wav') } })
  expect(await screen.findByText(/There is no project in what you chose/)).toBeVisible()
  expect(screen.getByRole('region', { name: 'What happens to each file' })).toBeVisible()
})

test.each([
  ['fmod', ['G/a.fspro', 'G/Metadata/e.xml', 'G/other.xml'], 'a.fspro', ['Metadata/e.xml', 'a.fspro']],
  [
    'godot',
    ['G/project.godot', 'G/m.tscn', 'G/x.png', 'G/sub/project.godot'],
    'project.godot',
    ['m.tscn', 'project.godot'],
  ],
  [
    'unity',
    ['G/ProjectSettings/ProjectVersion.txt', 'G/Assets/a.wav.meta', 'G/Assets/t.png.meta', 'G/Library/l.asset'],
    '',
    ['Assets/a.wav.meta', 'ProjectSettings/ProjectVersion.txt'],
  ],
  ['unreal', ['sounds.json'], 'sounds.json', ['sounds.json']],
])('the texts of a project of %s are found among its files', async (_, paths, name, wanted) => {
  const picked = paths.map((path) => ({ path, file: textFile(path, 'text') }))
  const found = projectIn(picked)
  if (found === null) throw new Error('not found')
  const { path, content_base64 } = await packProject(picked, found)
  expect(path).toBe(name)
  expect(Object.keys(unpacked(content_base64) as object).sort()).toEqual(wanted)
})

test('sounds alone are not a project', () => {
  expect(projectIn([{ path: 'Sounds/a.wav', file: textFile('Sounds/a.wav', '') }])).toBeNull()
})
