import type { components } from '@/api/schema.gen'

import { type Answers, type Asked, serve } from './server'

type Schemas = components['schemas']
type Cue = Schemas['CueRead']
type CueProgress = Schemas['CueProgress']

const AT = '2026-11-20T10:00:00Z'

export function aCue(number: number, name: string, cue: Partial<Cue> = {}): Cue {
  return {
    id: `cue-${number}`,
    number,
    label: `SW-${String(number).padStart(3, '0')}`,
    position: number,
    name,
    file_name: '',
    stems: [name],
    category: 'weapon',
    description: '',
    use: '',
    trigger: '',
    duration_s: 0.8,
    duration_min_s: null,
    duration_max_s: null,
    length_locked: false,
    frame_rate_fps: null,
    loop: false,
    reverb: null,
    channels: null,
    phase: null,
    variations: 1,
    state: 'locked',
    need: 'must',
    playback_priority: null,
    due_on: null,
    placeholder: false,
    palette: false,
    implementer_id: null,
    recorder_id: null,
    extra: {},
    edition: 1,
    cut_reason: null,
    cut_at: null,
    open_questions: 0,
    ...cue,
  }
}

export function aProgress(cue: Cue, progress: Partial<CueProgress> = {}): CueProgress {
  return {
    cue_id: cue.id,
    status: cue.state === 'cut' ? 'cut' : 'to_make',
    since: null,
    accepted: 0,
    wanted: cue.variations,
    alternates: 0,
    versions: 0,
    rounds: 0,
    variations: [],
    newest_take: null,
    worst_finding: null,
    open_question: null,
    waived: false,
    not_to_spec: false,
    unheard_take_ids: [],
    ...progress,
  }
}

export function aNewestTake(id: string): NonNullable<CueProgress['newest_take']> {
  return {
    id,
    number: 1,
    variation: 1,
    state: 'conforming',
    file_name: `${id}.wav`,
    received_at: AT,
    duration_s: 0.8,
    thumb: { points: 2, min: [-90, -20], max: [90, 20], rms: [40, 8] },
    preview_url: `/v1/sounds/${id}/preview`,
  }
}

/** A list in a project of its own, so that what one test leaves typed is not found by the next. */
export class ListServer {
  static #projects = 0
  readonly projectId = `list-project-${(ListServer.#projects += 1)}`
  readonly at = `/v1/projects/${this.projectId}`
  readonly asked: Asked[]
  readonly answers: Answers
  cues: Cue[]
  revision = 2

  constructor(
    cues: Cue[],
    progressList: Partial<Record<string, Partial<CueProgress>>> = {},
    part: 'team' | 'designer' = 'team',
  ) {
    // Drafts are kept by cue: ids are of one test alone.
    this.cues = cues.map((cue) => ({ ...cue, id: `${this.projectId}-${cue.id}` }))
    const person = { id: 'someone', name: part === 'team' ? 'Producer' : 'Sound designer' }
    const answers: Answers = {
      'GET /v1/session': { signed_in: true, demo: false, person },
      'GET /v1/me': {
        person,
        email: 'someone@studio.example',
        studios: [],
        projects: [
          {
            id: this.projectId,
            name: 'Shield Wing',
            studio_id: 's1',
            studio_name: 'Shield Wing studio',
            cue_prefix: 'SW',
            part,
            is_producer: part === 'team',
            is_liaison: false,
            is_approver: false,
            approves_all: false,
            engagement_kind: part === 'team' ? null : 'contract',
          },
        ],
      },
      'GET /v1/review-queue/count': { cues: 0, is_all: true },
      [`GET ${this.at}/sound-list`]: () => ({ revision: this.revision, cues: this.cues, next: null }),
      [`GET ${this.at}/sound-list/progress`]: () => ({
        cues: this.cues.map((cue) => aProgress(cue, progressList[cue.name])),
        next: null,
      }),
      [`GET ${this.at}/sound-list/counts`]: { counts: {}, files_to_review: 3 },
      [`GET ${this.at}/sound-list/columns`]: { columns: [], edition: 'none' },
      [`GET ${this.at}/cue-people`]: [],
      [`GET ${this.at}/questions`]: { items: [], next: null },
      [`GET ${this.at}/clarity`]: { unclear: [] },
      [`GET ${this.at}/takes`]: { items: [], next: null },
      [`GET ${this.at}/sound-list/revisions/compare`]: ({ query }: Asked) => ({
        from_revision: Number(query.get('from')),
        to_revision: Number(query.get('to')),
        added: [],
        changed: [],
        cut: [],
      }),
      [`GET ${this.at}/sound-list/revisions`]: { items: [], next: null },
    }
    this.answers = answers
    for (const cue of this.cues) {
      answers[`GET /v1/cues/${cue.id}`] = () => ({ ...this.cue(cue.name), project_id: this.projectId, questions: [] })
    }
    this.asked = serve(answers).asked
  }

  cue(name: string): Cue {
    const found = this.cues.find((cue) => cue.name === name)
    if (found === undefined) throw new Error(`the list has no ${name}`)
    return found
  }

  /** Every request of one kind, in order. */
  sent(method: string, path: string): Asked[] {
    return this.asked.filter((one) => one.method === method && one.path === path)
  }

  get path(): string {
    return `/projects/${this.projectId}/sound-list`
  }
}
