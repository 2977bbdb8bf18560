import type { ReactNode } from 'react'

import { answered, api } from '@/api'
import type { components } from '@/api/schema.gen'
import { STATE_OF_TAKE } from '@/judging/stateOfTake'
import { State } from '@/ui/State'

import { type Found, useSearchProvider } from '../palette'

type Hit = components['schemas']['Found']

const CUT_AT = 70

let asked: { key: string; hits: Promise<Hit[]> } | undefined

/** The hits for what is typed; the sections of the palette share one request. */
function hitsFor(projectId: string, typed: string, signal: AbortSignal): Promise<Hit[]> {
  const key = `${projectId} ${typed}`
  if (asked?.key !== key) {
    const path = { project_id: projectId }
    const answer = answered(
      api.GET('/v1/projects/{project_id}/find', { params: { path, query: { q: typed.slice(0, 100) } }, signal }),
    )
    const hits = answer.then((found) => found.hits)
    asked = { key, hits }
    hits.catch(() => {
      if (asked?.hits === hits) asked = undefined
    })
  }
  return asked.hits
}

function addressOf(hit: Hit, project: string): string {
  const at = hit.start_s ? `&at=${hit.start_s}` : ''
  switch (hit.kind) {
    case 'file':
      return `/takes/${hit.take_id}`
    case 'person':
      return `${project}/people`
    case 'contract':
      return `${project}/contracts/${hit.contract_id}`
    case 'comment':
      return `${project}/review/${hit.cue?.id}?take="${hit.take_id}"${at}`
    default:
      return `${project}/sound-list/cues/${hit.cue?.id}`
  }
}

/** The part of a text round the typed words. */
function around(text: string, typed: string): string {
  const at = Math.max(0, text.toLowerCase().indexOf(typed.toLowerCase()) - CUT_AT / 3)
  const from = text.length <= CUT_AT ? 0 : Math.floor(at)
  return `${from > 0 ? '…' : ''}${text.slice(from, from + CUT_AT)}${from + CUT_AT < text.length ? '…' : ''}`
}

function shown(hit: Hit, typed: string): Pick<Found, 'title' | 'number' | 'detail'> {
  const quiet = (words: ReactNode) => <span className="small dim cut-text">{words}</span>
  switch (hit.kind) {
    case 'file': {
      const state = hit.cue ? STATE_OF_TAKE[hit.text as keyof typeof STATE_OF_TAKE] : 'unmatched'
      return { title: hit.title, number: hit.cue?.label, detail: state && <State kind={state} /> }
    }
    case 'comment':
    case 'question':
      return { title: `“${around(hit.text, typed)}”`, number: hit.cue?.label, detail: quiet(hit.title) }
    default:
      return { title: hit.title, number: hit.cue?.label, detail: quiet(around(hit.text, typed)) }
  }
}

/** Let the palette find cues, files, people, contracts and what was said in a project, and cues and files in all others. */
export function useFinding(projectId: string | undefined, designs: boolean, go: (path: string) => void): void {
  const search =
    (...kinds: Hit['kind'][]) =>
    async (typed: string, signal: AbortSignal): Promise<Found[]> => {
      if (projectId === undefined) return []
      const project = `/projects/${projectId}`
      const hits = await hitsFor(projectId, typed, signal)
      return hits
        .filter(({ kind }) => kinds.includes(kind))
        .map((hit, index) => {
          // Review is the team's: a designer reads what was said on the page of the version.
          const path = hit.kind === 'comment' && designs ? `/takes/${hit.take_id}` : addressOf(hit, project)
          return { id: `${hit.kind}-${index}`, ...shown(hit, typed), open: () => go(path) }
        })
    }
  useSearchProvider({ id: 'sounds', title: 'Sounds', search: search('cue') })
  useSearchProvider({ id: 'files', title: 'Files', search: search('file') })
  useSearchProvider({ id: 'people', title: 'People and contracts', search: search('person', 'contract') })
  const elsewhere = async (typed: string, signal: AbortSignal): Promise<Found[]> => {
    const query = { q: typed.slice(0, 100), except_in: projectId }
    const { hits } = await answered(api.GET('/v1/find', { params: { query }, signal }))
    return hits.map((hit) => ({
      id: hit.take_id ?? hit.cue?.id ?? hit.title,
      title: hit.title,
      number: hit.cue?.label,
      detail: <span className="small dim cut-text">{hit.project_name}</span>,
      open: () => go(addressOf(hit, `/projects/${hit.project_id}`)),
    }))
  }
  const title = projectId === undefined ? 'In your projects' : 'In other projects'
  useSearchProvider({ id: 'elsewhere', title, search: elsewhere, last: true })
  useSearchProvider({ id: 'said', title: 'Comments and questions', search: search('comment', 'question'), last: true })
}
