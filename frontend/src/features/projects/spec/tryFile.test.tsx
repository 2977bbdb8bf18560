import { File as NodeFile } from 'node:buffer'

import { QueryClientProvider } from '@tanstack/react-query'
import { screen } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { expect, test } from 'vitest'

import { queryClient } from '@/api/queryClient'
import { judgeFile } from '@/precheck/judge'
import vectors from '@/precheck/vectors.json'
import { draw } from '@/test/draw'
import { refusal, serve } from '@/test/server'

import { TryFile } from './TryFile'

const vector = (name: string) => vectors.find((sound) => sound.name === name)!
const fileOf = (name: string, of: string) =>
  new NodeFile([Uint8Array.from(atob(vector(of).bytes), (byte) => byte.charCodeAt(0))], name) as unknown as File
const PREVIEW = { cue: null, variation: null, length: null, spec: 0, is_dry_stem: false, list_name: null, findings: [] }
const PATH = 'POST /v1/projects/p1/check-preview'

async function tried(name: string, of: string, answer: unknown) {
  const { asked } = serve({ [PATH]: answer })
  draw(
    <QueryClientProvider client={queryClient}>
      <TryFile projectId="p1" makeJudge={() => judgeFile} />
    </QueryClientProvider>,
  )
  await userEvent.upload(screen.getByLabelText('File to try'), fileOf(name, of))
  return asked
}
const previewed = (preview: object = {}) => ({
  checks: [],
  specs: [vector('conforms').spec],
  files: [{ ...PREVIEW, ...preview }],
})

test('a file that would be sent back says why and how to fix it, and nothing is delivered', async () => {
  const asked = await tried('laser.wav', '44100 Hz', previewed())
  expect(await screen.findByText('Would be sent back')).toBeVisible()
  expect(screen.getByText('Sample rate 44100 Hz.', { exact: false })).toBeVisible()
  expect(screen.getByText(/Export the session at 48000 Hz/)).toBeVisible()
  expect(asked.map(({ method, path }) => `${method} ${path}`)).toEqual([PATH])
})

test('a file that conforms is accepted, and a fault of its name is said with it', async () => {
  const fault = {
    ...vector('44100 Hz').expected.findings[0],
    code: 'naming:pattern',
    message: 'the name is not as the spec asks',
    fix: 'rename it',
  }
  await tried('laser.wav', 'conforms', previewed())
  expect(await screen.findByText('Accepted')).toBeVisible()
  serve({ [PATH]: previewed({ findings: [fault] }) })
  await userEvent.upload(screen.getByLabelText('File to try'), fileOf('LASER.wav', 'conforms'))
  expect(await screen.findByText('Would be sent back')).toBeVisible()
  expect(screen.getByText(/Rename it/)).toBeVisible()
})

test('what cannot be asked or judged here says so', async () => {
  await tried('odd.wav', 'bytes after the end', previewed())
  expect(await screen.findByText(/cannot be judged in the browser/)).toBeVisible()
  serve({ [PATH]: refusal(404, 'project-not-found', 'no project of that id') })
  await userEvent.upload(screen.getByLabelText('File to try'), fileOf('laser.wav', 'conforms'))
  expect(await screen.findByRole('alert')).toHaveTextContent('No project of that id.')
})
