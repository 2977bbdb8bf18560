import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { aPreview } from '@/test/review'
import { answer, type Asked, refusal } from '@/test/server'
import { aCue, aProgress, ListServer } from '@/test/soundList'

const AT = '2026-11-20T10:00:00Z'
const PRODUCER = { id: 'someone', name: 'Producer' }
const DESIGNER = { id: 'designer', name: 'Sound designer' }

const aQuestion = (id: string, cueId: string, more = {}) => ({
  id,
  cue_id: cueId,
  cue_label: 'SW-001',
  cue_name: 'coolant_splash',
  text: 'What falls in?',
  asked_by: DESIGNER,
  asked_at: AT,
  answer: null,
  answered_by: null,
  answered_at: null,
  owner: null,
  due_on: null,
  blocks: false,
  ...more,
})

function opened(part: 'team' | 'designer' = 'team') {
  const server = new ListServer(
    [aCue(1, 'coolant_splash', { description: 'A splash in the tank.', edition: 2 }), aCue(2, 'suit_hit')],
    { coolant_splash: { status: 'question', open_question: 'What falls in?' } },
    part,
  )
  const { id } = server.cue('coolant_splash')
  server.answers[`GET /v1/cues/${id}/handoffs`] = []
  let question = aQuestion('q1', id)
  server.answers[`GET ${server.at}/desk`] = { came_back: [], unmatched: 0, checking: 0 }
  server.answers[`GET /v1/cues/${id}`] = () => ({
    ...server.cue('coolant_splash'),
    project_id: server.projectId,
    questions: [question],
  })
  server.answers['POST /v1/questions/q1/answer'] = ({ body }: Asked) => {
    const { text } = body as { text: string }
    question = aQuestion('q1', id, { answer: text, answered_by: PRODUCER, answered_at: AT })
    Object.assign(server.cue('coolant_splash'), { description: `A splash in the tank.\n\nWhat falls in? ${text}` })
    return question
  }
  server.answers[`GET ${server.at}/sound-list/revisions`] = {
    items: [
      { number: 3, summary: 'SW-002 cut', author: PRODUCER, created_at: AT },
      { number: 2, summary: '1 cue changed', author: PRODUCER, created_at: AT },
      { number: 1, summary: '2 cues added', author: PRODUCER, created_at: AT },
    ],
    next: null,
  }
  const difference = { id, number: 1, label: 'SW-001', name: 'coolant_splash', cut_reason: null }
  server.answers[`GET ${server.at}/sound-list/revisions/compare`] = ({ query }: Asked) => ({
    from_revision: Number(query.get('from')),
    to_revision: Number(query.get('to')),
    added: query.get('to') === '1' ? [{ ...difference, changes: [] }] : [],
    changed:
      query.get('to') === '2' ? [{ ...difference, changes: [{ field: 'duration_s', before: 0.7, after: 0.8 }] }] : [],
    cut: [],
  })
  server.answers[`GET ${server.at}/takes`] = ({ query }: Asked) => ({
    items:
      query.get('cue_id') === id
        ? [
            {
              id: 't1',
              designer: DESIGNER,
              variation: 1,
              number: 1,
              alternate: null,
              label: null,
              verdict_reasons: [],
              state: 'returned',
              file_name: 'coolant_splash.wav',
              note: '',
              received_at: AT,
              discarded_at: null,
              sure: null,
              guesses: [],
            },
          ]
        : [],
    next: null,
  })
  server.answers['GET /v1/takes/t1/sounds'] = {
    take_id: 't1',
    master: { thumb: null, preview_url: '/v1/sounds/t1/preview', duration_s: 0.7 },
    renders: [],
  }
  server.answers['GET /v1/takes/t1/check'] = {
    findings: [
      {
        check: 'sample-peak',
        code: 'sample-peak:over',
        severity: 'error',
        message: 'sample peak 0.00 dBFS, limit -0.1 dBFS',
        fix: 'lower the level by 0.10 dB or more',
        start_s: 0.4,
        waived: false,
      },
    ],
  }
  const app = openApp(`${server.path}/cues/${id}`)
  return { server, app, id }
}

test('a version says beside its verdict why it was given', async () => {
  const { server, id } = opened()
  const listed = server.answers[`GET ${server.at}/takes`] as (of: Asked) => { items: object[] }
  const [first] = listed({ query: new URLSearchParams({ cue_id: id }) } as Asked).items
  const because = (state: string, ...verdict_reasons: string[]) => ({ ...first, id: state, state, verdict_reasons })
  const items = [because('approved', 'Fits the scene', 'Best timing'), because('change_requested', 'Too loud')]
  server.answers[`GET ${server.at}/takes`] = { items, next: null }
  expect(await screen.findByText('Approved: Fits the scene. Best timing.')).toBeVisible()
  expect(screen.getByText('Change requested: Too loud.')).toBeVisible()
})

test('the cue, its versions with findings, and its history stand on one page', async () => {
  const { server, id } = opened()
  expect(await screen.findByRole('heading', { level: 1, name: 'coolant_splash' })).toBeInTheDocument()
  expect(screen.getByText('A splash in the tank.')).toBeInTheDocument()
  const finding = await screen.findByRole('article', { name: 'Sample peak 0.00 dBFS, limit −0.1 dBFS' })
  expect(finding).toHaveTextContent('Lower the level by 0.10 dB or more.')
  expect(screen.getByRole('button', { name: 'Play version 1' })).toBeInTheDocument()
  const [review] = screen.getAllByRole('link', { name: 'Open in review' })
  expect(review).toHaveAttribute('href', `/projects/${server.projectId}/review/${id}`)
  const history = await screen.findByRole('region', { name: 'History' })
  await waitFor(() => expect(history).toHaveTextContent(/Length was 0.70 s.*0.80 s/))
  expect(history).toHaveTextContent('Added to the list')
  expect(history).toHaveTextContent('Delivered coolant_splash.wav')
  expect(history).toHaveTextContent('Asked: What falls in?')
  // A revision that cut another cue is not asked about.
  expect(server.asked.some(({ query }) => query.get('from') === '2' && query.get('to') === '3')).toBe(false)
})

test('a version that was not heard says so, until it is played for long enough', { tags: ['slow'] }, async () => {
  vi.stubGlobal('AudioContext', HandContext)
  const { server, id } = opened()
  const unheard = aProgress(server.cue('coolant_splash'), { unheard_take_ids: ['t1'] })
  server.answers[`GET ${server.at}/sound-list/progress`] = { cues: [unheard], next: null }
  server.answers['GET /v1/sounds/t1/preview'] = { ...aPreview, durationS: 0.2 }
  server.answers[`POST ${server.at}/heard-takes`] = answer(null, 204)
  const versions = await screen.findByRole('region', { name: 'Versions' })
  expect(await within(versions).findByText('not heard yet')).toBeVisible()
  await userEvent.click(screen.getByRole('button', { name: 'Play version 1' }))
  await waitFor(() => expect(within(versions).queryByText('not heard yet')).toBeNull())
  await waitFor(() => expect(server.sent('POST', `${server.at}/heard-takes`)[0]?.body).toEqual({ take_ids: ['t1'] }))
  expect(id).toBe(unheard.cue_id)
})

test('an answer joins what the cue says', { tags: ['slow'] }, async () => {
  const { server } = opened()
  await userEvent.type(await screen.findByRole('textbox', { name: 'Your answer' }), 'A spanner.')
  await userEvent.click(screen.getByRole('button', { name: 'Answer' }))
  expect(await screen.findByText('A spanner.')).toBeInTheDocument()
  expect(await screen.findByText(/What falls in\? A spanner\./)).toBeInTheDocument()
  expect(server.sent('POST', '/v1/questions/q1/answer')[0]?.body).toEqual({ text: 'A spanner.', joins: true })
})

test('an answer that came too late says so, and keeps its text', async () => {
  const { server } = opened()
  server.answers['POST /v1/questions/q1/answer'] = refusal(
    409,
    'question-answered',
    'this question was answered already',
  )
  const field = await screen.findByRole('textbox', { name: 'Your answer' })
  await userEvent.type(field, 'A drop.')
  await userEvent.click(screen.getByRole('checkbox', { name: 'Add it to the cue’s description' }))
  await userEvent.click(screen.getByRole('button', { name: 'Answer' }))
  expect(await screen.findByRole('alert')).toHaveTextContent('This question was answered already.')
  expect(field).toHaveValue('A drop.')
  expect(server.sent('POST', '/v1/questions/q1/answer')[0]?.body).toEqual({ text: 'A drop.', joins: false })
})

test('j goes to the next cue, e edits, Escape closes and then leads back', { tags: ['slow'] }, async () => {
  const { server, app } = opened()
  await screen.findByRole('heading', { level: 1, name: 'coolant_splash' })
  await userEvent.keyboard('e')
  expect(await screen.findByRole('form', { name: 'Edit coolant_splash' })).toBeInTheDocument()
  await userEvent.keyboard('{Escape}')
  expect(screen.queryByRole('form', { name: /^Edit/ })).not.toBeInTheDocument()
  await screen.findByText('Question', { selector: 'h1 ~ * *' })
  await userEvent.keyboard('j')
  expect(await screen.findByRole('heading', { level: 1, name: 'suit_hit' })).toBeInTheDocument()
  await userEvent.keyboard('{Escape}')
  await waitFor(() => expect(app.at()).toBe(server.path))
})

test('all takes are heard in a row, once they are put together', async () => {
  const { server, id } = opened()
  const reel = {
    id: 'r1',
    cue_id: id,
    state: 'making',
    refusal: null,
    gap_ms: 500,
    crossfade_ms: 0,
    slates: 'beeped',
    takes: [
      { take_id: 't1', variation: 1, number: 1, start_s: 0.42 },
      { take_id: 't2', variation: 1, number: 2, start_s: 1.53 },
    ],
    duration_s: null,
    file_bytes: null,
    file_name: 'coolant_splash_reel.wav',
    file_url: null,
  }
  server.answers[`POST /v1/cues/${id}/reels`] = reel
  server.answers['GET /v1/reels/r1'] = { ...reel, state: 'made', duration_s: 1.12, file_url: '/v1/reels/r1/file' }
  await userEvent.click(await screen.findByText('Playback options'))
  await userEvent.click(screen.getByRole('button', { name: 'Crossfade' }))
  const seconds = screen.getByRole('textbox', { name: 'Crossfade length' })
  await userEvent.clear(seconds)
  await userEvent.type(seconds, '0.25')
  await userEvent.click(screen.getByRole('button', { name: 'Beeps' }))
  await userEvent.click(screen.getByRole('button', { name: 'Newest first' }))
  await userEvent.click(await screen.findByRole('button', { name: 'Play all versions' }))
  const audio = await screen.findByLabelText<HTMLAudioElement>('All versions of coolant_splash')
  expect(server.sent('POST', `/v1/cues/${id}/reels`)[0]?.body).toEqual({
    gap_ms: 0,
    crossfade_ms: 250,
    slates: 'beeped',
    order: 'newest',
  })
  expect(audio).toHaveAttribute('src', '/v1/reels/r1/file')
  const play = vi.spyOn(audio, 'play').mockResolvedValue()
  await userEvent.click(screen.getByRole('button', { name: /^version 2/ }))
  expect([audio.currentTime, play.mock.calls.length]).toEqual([1.53, 1])
  const download = screen.getByRole('link', { name: 'Download reel' })
  expect(download).toHaveAttribute('href', '/v1/reels/r1/file')
  expect(download).toHaveAttribute('download', 'coolant_splash_reel.wav')
  expect(screen.getByText(/2 versions, 1.12 s. Beeps before each give its version number./)).toBeInTheDocument()
})

test('a reel that is refused says why', async () => {
  const { server, id } = opened()
  server.answers[`POST /v1/cues/${id}/reels`] = refusal(409, 'takes-being-drawn', 'a take is still being drawn')
  await userEvent.click(await screen.findByRole('button', { name: 'Play all versions' }))
  expect(await screen.findByRole('alert')).toHaveTextContent('A take is still being drawn.')
  expect(screen.queryByRole('link', { name: 'Download reel' })).not.toBeInTheDocument()
})

test('a designer sees the cue and asks; who answers is said', async () => {
  opened('designer')
  const question = await screen.findByRole('article', { name: 'Question: What falls in?' })
  expect(within(question).getByText('Waiting for the team’s answer.')).toBeInTheDocument()
  expect(screen.queryByRole('button', { name: /Edit/ })).not.toBeInTheDocument()
  expect(screen.queryByRole('link', { name: /review/ })).not.toBeInTheDocument()
  expect(screen.getByRole('textbox', { name: 'Your question about coolant_splash' })).toBeInTheDocument()
})

test('a cue that is not there says so and leads back', async () => {
  const server = new ListServer([])
  server.answers['GET /v1/cues/nowhere'] = refusal(404, 'cue-not-found', 'no cue nowhere')
  openApp(`${server.path}/cues/nowhere`)
  expect(await screen.findByRole('heading', { level: 1, name: 'Cue not found' })).toBeInTheDocument()
  expect(screen.getByRole('alert')).toHaveTextContent('No cue nowhere.')
  expect(screen.getByRole('link', { name: 'Go to the sound list' })).toHaveAttribute('href', server.path)
})
