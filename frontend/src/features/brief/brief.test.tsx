import { fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { describe, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { inProject } from '@/test/project'
import { answer, type Answers, type Asked, refusal, serve, wrote } from '@/test/server'

interface Kept {
  value: unknown
  is_unknown: boolean
  note: string
}

const GENRE = { key: 'genre', kind: 'text', text: 'What kind of game is it?', required: true }
const PLAYBACK = {
  key: 'playback',
  kind: 'choice',
  text: 'On what will most players listen?',
  required: true,
  choices: [
    { key: 'tv', label: 'Television' },
    { key: 'headphones', label: 'Headphones' },
  ],
}
const NAMING = { key: 'naming', kind: 'names', text: 'How is a file named?', required: false }
const TOPICS = [
  { key: 'game', title: 'The game', questions: [GENRE] },
  { key: 'platforms', title: 'Platforms', questions: [PLAYBACK, NAMING] },
]
const PRODUCER = { id: 'x1', name: 'Producer' }
const AT = '2026-11-20T10:00:00Z'

/** Answers as the server would, for three questions in two topics. */
class BriefServer {
  revision = 0
  newest = 0
  kept: Record<string, Kept> = {}
  followUps: Record<string, unknown>[] = []
  decisions: Record<string, unknown>[] = []
  refuseWith: unknown = null
  proposal = {
    based_on_version: 3,
    brief_revision: 0,
    toml: '',
    errors: [] as string[],
    changes: [
      {
        place: 'engine.adds',
        before: [] as string[],
        after: ['reverb'],
        question: 'effects',
        number: 16,
        lines: ['[engine]', 'adds = ["reverb"]'],
      },
    ],
  }
  readonly part: 'producer' | 'designer'
  readonly asked: readonly Asked[]

  constructor(part: 'producer' | 'designer' = 'producer', more: Answers = {}) {
    this.part = part
    const { asked } = serve(
      inProject(part, {
        'GET /v1/projects/p1/size-estimate': { lines: [], unknown: [], low_cues: 0, high_cues: 0, listed_cues: 0 },
        ...more,
        'GET /v1/projects/p1/desk': refusal(403, 'x', 'no desk'),
        'GET /v1/projects/p1/brief': () => this.brief(),
        'PATCH /v1/projects/p1/brief': ({ body }: Asked) => this.save(body),
        'POST /v1/projects/p1/brief/versions': () => {
          this.newest += 1
          return answer(
            { number: this.newest, note: '', publisher: PRODUCER, published_at: AT, answered: 1, total: 3 },
            201,
          )
        },
        'PUT /v1/projects/p1/brief/versions/2/read': answer(null, 204),
        'GET /v1/projects/p1/sound-list/coverage': {
          scenes_without_ambience: ['Harbour'],
          silent_scenes: ['Void'],
          categories_without_cue: [],
          priority_without_cue: ['Shield hit'],
        },
        'GET /v1/projects/p1/decisions': () => this.decisions,
        'POST /v1/projects/p1/decisions': ({ body }: Asked) => answer(body, 201),
        'GET /v1/projects/p1/brief/spec': () => this.proposal,
        'POST /v1/projects/p1/brief/spec': () => {
          this.proposal = { ...this.proposal, based_on_version: 4, changes: [] }
          return { version: 4 }
        },
        'GET /v1/projects/p1/brief/reads': [
          { designer: { id: 'x3', name: 'Sound designer' }, version: 1, read_at: AT, behind: 1 },
        ],
        'POST /v1/projects/p1/brief/follow-ups': ({ body }: Asked) => {
          this.followUps.push({
            id: 'f1',
            asked_by: PRODUCER,
            asked_at: AT,
            answer: null,
            answered_by: null,
            answered_at: null,
            ...(body as object),
          })
          return answer(this.followUps[0], 201)
        },
        'GET /v1/projects/p1/sound-list': {
          revision: 1,
          next: null,
          cues: [
            { stems: ['ui_confirm'], category: 'ui' },
            { stems: ['airlock-cycle'], category: 'foley' },
          ],
        },
      }),
    )
    this.asked = asked
  }

  save(body: unknown) {
    if (this.refuseWith !== null) return this.refuseWith
    const { answers } = body as { answers: Record<string, Kept> }
    this.revision += 1
    for (const [key, one] of Object.entries(answers)) {
      const isEmpty = one.value === null || one.value === '' || (Array.isArray(one.value) && one.value.length === 0)
      if (isEmpty && !one.is_unknown) delete this.kept[key]
      else this.kept[key] = one
    }
    return this.brief()
  }

  brief() {
    const all = [GENRE, PLAYBACK, NAMING]
    const isAnswered = (key: string) => this.kept[key] !== undefined && !this.kept[key].is_unknown
    const open = all.filter(({ key }) => !isAnswered(key))
    return {
      topics: TOPICS.map(({ questions, ...topic }) => ({
        ...topic,
        lead: 'A lead.',
        total: questions.length,
        answered: questions.filter(({ key }) => isAnswered(key)).length,
        questions: questions.map((question) => {
          const kept = this.kept[question.key]
          return {
            why: 'Why it matters.',
            example: 'an example',
            unit: '',
            writes: '',
            applies: true,
            choices: [],
            number: all.findIndex(({ key }) => key === question.key) + 1,
            ...question,
            answer: kept
              ? { ...kept, words: String(kept.value), revision: this.revision, answered_by: PRODUCER, answered_at: AT }
              : null,
          }
        }),
      })),
      answered: all.length - open.length,
      total: all.length,
      open: open.map(({ key }) => key),
      open_required: open.filter(({ required }) => required).map(({ key }) => key),
      revision: this.revision,
      changed_at: AT,
      newest_version: this.newest,
      differs: this.revision > this.newest,
      may_answer: this.part === 'producer',
      may_ask: this.part === 'designer',
      follow_ups: this.followUps,
    }
  }

  get saves() {
    return wrote(this.asked, 'PATCH /v1/projects/p1/brief').map(({ body }) => body)
  }
}

const genre = () => screen.findByRole('textbox', { name: GENRE.text })

describe('answering', () => {
  test('what is typed is saved by itself, once, and the figure follows', async () => {
    const server = new BriefServer()
    openApp('/projects/p1/brief')
    await userEvent.type(await genre(), 'A platformer ')
    await waitFor(() => expect(server.saves).toHaveLength(1))
    expect(server.saves[0]).toEqual({
      revision: 0,
      answers: { genre: { value: 'A platformer ', is_unknown: false, note: '' } },
    })
    expect(await screen.findByText('1 of 3')).toBeVisible()
    expect(await screen.findByText('Saved')).toBeVisible()
    await userEvent.type(await genre(), 'for children')
    expect(await genre()).toHaveValue('A platformer for children')
  })

  test('by keys: next topic, an answer, I don’t know yet', async () => {
    const server = new BriefServer()
    openApp('/projects/p1/brief')
    await genre()
    await userEvent.keyboard('n')
    expect(await screen.findByRole('heading', { level: 1, name: 'Platforms' })).toHaveFocus()
    await userEvent.keyboard('j2')
    expect(screen.getByRole('button', { name: 'Headphones' })).toHaveAttribute('aria-pressed', 'true')
    await userEvent.keyboard('j0')
    const card = screen.getByRole('region', { name: NAMING.text })
    expect(within(card).getByText('Undecided')).toBeVisible()
    await waitFor(() => expect(server.kept.naming?.is_unknown).toBe(true))
    expect(server.kept.playback?.value).toBe('headphones')
    await userEvent.keyboard('p')
    expect(await screen.findByRole('heading', { level: 1, name: 'The game' })).toBeVisible()
  })

  test('an answer that another person changed is shown beside one’s own', async () => {
    const server = new BriefServer()
    openApp('/projects/p1/brief')
    await userEvent.type(await genre(), 'Chess')
    server.kept.genre = { value: 'A racing game', is_unknown: false, note: '' }
    server.revision = 4
    server.refuseWith = refusal(409, 'answer-changed', 'Audio director changed this answer', {
      errors: [{ where: 'genre', message: 'Audio director changed this answer' }],
    })
    const alert = await screen.findByRole('alert')
    expect(alert).toHaveTextContent('Audio director changed this answer.')
    await waitFor(() => expect(screen.getByRole('alert')).toHaveTextContent('Theirs: A racing game'))
    expect(await genre()).toHaveValue('Chess')
    server.refuseWith = null
    await userEvent.click(within(screen.getByRole('alert')).getByRole('button', { name: 'Save mine' }))
    await waitFor(() => expect(server.kept.genre?.value).toBe('Chess'))
    expect(server.saves.at(-1)).toMatchObject({ revision: 4 })
  })

  test('while the server cannot be reached the answer stays and is sent again', async () => {
    const server = new BriefServer()
    server.refuseWith = answer({ detail: 'broken' }, 503)
    openApp('/projects/p1/brief')
    await userEvent.type(await genre(), 'Chess')
    expect(await screen.findByText(/kept here and sent again/)).toBeVisible()
    server.refuseWith = null
    await waitFor(() => expect(server.kept.genre?.value).toBe('Chess'))
    expect(await screen.findByText('Saved')).toBeVisible()
  })

  test('a name is built from its parts, and tried on the list', async () => {
    const server = new BriefServer()
    openApp('/projects/p1/brief?topic=platforms')
    const card = await screen.findByRole('region', { name: NAMING.text })
    await userEvent.click(within(card).getByRole('button', { name: 'what' }))
    await userEvent.click(within(card).getByRole('button', { name: 'detail' }))
    expect(await within(card).findByText('1 of 2 names on the list fits.')).toBeVisible()
    expect(within(card).getByText('does not fit; airlock_cycle.wav would')).toBeVisible()
    await waitFor(() => expect(server.kept.naming?.value).toMatchObject({ separator: '_' }))
    await userEvent.click(within(card).getByRole('button', { name: 'Paste names already in the code' }))
    const names = within(card).getByRole('textbox', { name: 'File names, one a line' })
    fireEvent.change(names, { target: { value: 'Door-Open-1\nGate-Shut-2' } })
    await userEvent.click(within(card).getByRole('button', { name: 'Use this convention' }))
    await waitFor(() => expect(server.kept.naming?.value).toMatchObject({ separator: '-' }))
  })
})

describe('both sides', () => {
  test('the producer publishes a version and sees who read which', async () => {
    const server = new BriefServer()
    server.revision = 1
    server.kept.genre = { value: 'Chess', is_unknown: false, note: '' }
    openApp('/projects/p1/brief')
    expect(await screen.findByText('version 1, 1 version behind')).toBeVisible()
    const [publish] = await screen.findAllByRole('button', { name: 'Publish version 1' })
    if (publish) await userEvent.click(publish)
    expect(await screen.findByText('Version 1 of the brief published.')).toBeVisible()
    expect(wrote(server.asked, 'POST /v1/projects/p1/brief/versions')[0]?.body).toEqual({ revision: 1, note: '' })
  })

  test('what the answers ask of the spec is shown as a difference, and saved in one act', async () => {
    const server = new BriefServer()
    openApp('/projects/p1/brief')
    const changes = await screen.findByRole('list', { name: 'Changes that the answers ask for' })
    expect(within(changes).getByText('question 16')).toBeVisible()
    expect(within(changes).getByText('[]')).toHaveClass('struck')
    expect(changes).toHaveTextContent('adds = ["reverb"]')
    await userEvent.click(screen.getByRole('button', { name: 'Save as version 4 of the spec' }))
    expect(await screen.findByText('The spec has what the answers ask for.')).toBeVisible()
    expect(wrote(server.asked, 'POST /v1/projects/p1/brief/spec')[0]?.body).toEqual({
      based_on_version: 3,
      brief_revision: 0,
    })
  })

  test('a decision before the contract is added, and its cues and questions are links', async () => {
    const decided = { decided_on: '2026-11-02', attended: 'Producer', text: 'SW-001 stays dry; see question 1.' }
    const kept = { ...decided, id: 'd1', author: PRODUCER, created_at: AT, signed_at: null }
    const server = new BriefServer()
    server.decisions = []
    openApp('/projects/p1/brief')
    const card = within(await screen.findByRole('region', { name: 'Kick-off' }))
    await userEvent.click(card.getByRole('button', { name: 'Add decision' }))
    fireEvent.change(card.getByLabelText('Date'), { target: { value: decided.decided_on } })
    await userEvent.type(card.getByLabelText('Attended'), decided.attended)
    await userEvent.type(card.getByLabelText('Decision'), decided.text)
    server.decisions = [kept]
    await userEvent.click(card.getByRole('button', { name: 'Save decision' }))
    expect(await card.findByRole('link', { name: 'SW-001' })).toHaveAttribute(
      'href',
      '/projects/p1/sound-list?q=SW-001',
    )
    expect(card.getByRole('link', { name: 'question 1' })).toBeVisible()
    expect(wrote(server.asked, 'POST /v1/projects/p1/decisions')[0]?.body).toEqual(decided)
  })

  test('what the answers name and the list lacks is said', async () => {
    new BriefServer()
    openApp('/projects/p1/brief')
    const missing = await screen.findByRole('region', { name: 'Missing from the sound list' })
    expect(
      within(missing)
        .getAllByRole('listitem')
        .map((item) => item.textContent),
    ).toEqual([
      'Harbour has no ambience on the list',
      'Void is silent: neither ambience nor music',
      'Shield hit has no cue on the list',
    ])
  })

  test('the answers lead to a number of sounds and hours, by scene and category', async () => {
    const line = (scene: string, category: string, low: number, high: number) => ({
      ...{ scene, category, low_cues: low, high_cues: high, low_h: low * 2, high_h: high * 2 },
    })
    const estimate = {
      ...{ low_cues: 19, high_cues: 53, low_h: 38, high_h: 106, listed_cues: 4, unknown: ['cinematic'] },
      lines: [line('Harbour', 'ambience', 1, 2), line('', 'ui', 18, 51)],
    }
    new BriefServer('producer', { 'GET /v1/projects/p1/size-estimate': estimate })
    openApp('/projects/p1/brief')
    const size = await screen.findByRole('region', { name: 'Size' })
    expect(size).toHaveTextContent('About 19–53 cues, 38–106 h of work. The list has 4.')
    await userEvent.click(within(size).getByText('By scene and category'))
    expect(within(size).getAllByRole('listitem')[0]).toHaveTextContent('Harbour, ambience: 1–2 cues, 2–4 h')
    expect(within(size).getByText('Not counted: cinematic.')).toBeVisible()
  })

  test('a kit that has none of the categories can be left again', async () => {
    const none = { lines: [], unknown: ['ui'], low_cues: 0, high_cues: 0, low_h: 0, high_h: 0, listed_cues: 4 }
    const some = { ...none, lines: [{ scene: '', category: 'ui', low_cues: 1, high_cues: 2, low_h: 1, high_h: 2 }] }
    new BriefServer('producer', {
      'GET /v1/kits': [{ key: 'racing', name: 'Racing game' }],
      'GET /v1/projects/p1/size-estimate': ({ query }: Asked) => (query.get('kit') ? none : some),
    })
    openApp('/projects/p1/brief')
    const kit = await screen.findByLabelText('Compared with')
    await userEvent.selectOptions(kit, 'Racing game')
    expect(await screen.findByText('This kit has none of the categories in the answers.')).toBeVisible()
    await userEvent.selectOptions(kit, 'Small games of all kinds')
    expect(await screen.findByText(/^About 0 cues/)).toBeVisible()
  })

  test('a designer reads, which is recorded, and asks', async () => {
    const server = new BriefServer('designer')
    server.newest = 2
    openApp('/projects/p1/brief')
    expect(await screen.findByText('No answer yet.')).toBeVisible()
    expect(screen.queryByRole('textbox')).not.toBeInTheDocument()
    await waitFor(() => expect(wrote(server.asked, 'PUT /v1/projects/p1/brief/versions/2/read')).toHaveLength(1))
    await userEvent.click(screen.getByRole('button', { name: 'Ask about this' }))
    await userEvent.type(screen.getByRole('textbox', { name: 'Your question' }), 'How long is a level?')
    await userEvent.click(screen.getByRole('button', { name: 'Send question' }))
    expect(await screen.findByText('How long is a level?')).toBeVisible()
    expect(wrote(server.asked, 'POST /v1/projects/p1/brief/follow-ups')[0]?.body).toEqual({
      question: 'genre',
      text: 'How long is a level?',
    })
  })

  test('the page has no fault that a machine can find', { tags: ['slow'] }, async () => {
    const server = new BriefServer()
    server.kept.naming = { value: null, is_unknown: true, note: '' }
    openApp('/projects/p1/brief?topic=platforms')
    await screen.findByRole('region', { name: NAMING.text })
    const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
    expect(violations.map(({ id, nodes }) => `${id}: ${nodes[0]?.html}`)).toEqual([])
  })
})
