import type { ReactNode } from 'react'

import { unwrap, api } from '@/api'
import type { components } from '@/api/schema.gen'
import { comparedBlind } from '@/verdicts/comparedBlind'
import { variationName } from '@/verdicts/hearing'
import { STATE_OF_TAKE } from '@/verdicts/stateOfTake'
import { byWhom } from '@/verdicts/words'
import { StatusBadge } from '@/ui/StatusBadge'

import type { Found } from '../palette'

export type Hit = components['schemas']['Found']
type HitElsewhere = components['schemas']['FoundElsewhere']
type Go = (path: string) => void

/** Whose search it is, in which project, if one is open, and how a page is opened. */
export interface Search {
  projectId: string | undefined
  designs: boolean
  go: Go
}

const CUT_AT = 70
const FEEDBACK_KINDS: readonly Hit['kind'][] = ['change_reason', 'pick_reason', 'label']
const KIND_LABELS: Partial<Record<Hit['kind'], string>> = {
  change_reason: 'change requested',
  pick_reason: 'approved',
  label: 'labelled',
}

/** Ask once for what several sections of the palette show; each search has a signal of its own. */
function shared<T>(ask: (projectId: string | undefined, typed: string, signal: AbortSignal) => Promise<T[]>) {
  const asked = new WeakMap<AbortSignal, Promise<T[]>>()
  return (projectId: string | undefined, typed: string, signal: AbortSignal): Promise<T[]> => {
    const hits = asked.get(signal) ?? ask(projectId, typed.slice(0, 100), signal)
    asked.set(signal, hits)
    return hits
  }
}

const hitsHere = shared<Hit>(async (projectId, q, signal) => {
  if (projectId === undefined) return []
  const params = { path: { project_id: projectId }, query: { q } }
  return (await unwrap(api.GET('/v1/projects/{project_id}/find', { params, signal }))).hits
})

const hitsElsewhere = shared<HitElsewhere>(async (projectId, q, signal) => {
  const query = { q, except_in: projectId }
  return (await unwrap(api.GET('/v1/find', { params: { query }, signal }))).hits
})

function addressOf(hit: Hit, project: string): string {
  const at = hit.start_s ? `&at=${hit.start_s}` : ''
  switch (hit.kind) {
    case 'file':
    case 'label':
      return `/takes/${hit.take_id}`
    case 'change_reason':
    case 'pick_reason':
      return `/takes/${hit.take_id}${hit.start_s ? `?at=${hit.start_s}` : ''}`
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

/** Of which version something was said, and by whom: "shield_hit version 2, approved by Ada". */
function describeFeedback(hit: Hit | HitElsewhere): string {
  const { kind, title, said } = hit
  if (!said) return title
  const project = 'project_name' in hit ? `${hit.project_name}: ` : ''
  const variation = said.variation > 1 ? ` ${variationName(said.variation)}` : ''
  const version = said.number === null ? '' : ` version ${said.number}`
  const who = byWhom(said)
  return `${project}${title}${variation}${version}, ${KIND_LABELS[kind]}${who && ` by ${who}`}`
}

function shown(hit: Hit, typed: string): Pick<Found, 'title' | 'number' | 'detail'> {
  const quiet = (words: ReactNode) => <span className="small dim cut-text">{words}</span>
  switch (hit.kind) {
    case 'file': {
      const state = hit.cue ? STATE_OF_TAKE[hit.text as keyof typeof STATE_OF_TAKE] : 'unmatched'
      return { title: hit.title, number: hit.cue?.label, detail: state && <StatusBadge kind={state} /> }
    }
    case 'comment':
    case 'question':
      return { title: `“${around(hit.text, typed)}”`, number: hit.cue?.label, detail: quiet(hit.title) }
    case 'change_reason':
    case 'pick_reason':
    case 'label':
      return { title: hit.text, number: hit.cue?.label, detail: quiet(describeFeedback(hit)) }
    default:
      return { title: hit.title, number: hit.cue?.label, detail: quiet(around(hit.text, typed)) }
  }
}

/** Hits of some kinds in the open project. */
export async function findHere(kinds: readonly Hit['kind'][], search: Search, typed: string, signal: AbortSignal) {
  const { projectId, designs, go } = search
  const hits = await hitsHere(projectId, typed, signal)
  return hits
    .filter(({ kind }) => kinds.includes(kind))
    .map((hit, index): Found => {
      // Review is the team's: a designer reads what was said on the page of the version.
      const path =
        hit.kind === 'comment' && designs ? `/takes/${hit.take_id}` : addressOf(hit, `/projects/${projectId}`)
      return { id: `${hit.kind}-${index}`, ...shown(hit, typed), open: () => go(path) }
    })
}

/** Cues and files of all projects but the open one, with the name of their project. */
export async function findElsewhere({ projectId, go }: Search, typed: string, signal: AbortSignal): Promise<Found[]> {
  const hits = await hitsElsewhere(projectId, typed, signal)
  return hits
    .filter(({ kind }) => !FEEDBACK_KINDS.includes(kind))
    .map((hit) => ({
      id: hit.take_id ?? hit.cue?.id ?? hit.title,
      title: hit.title,
      number: hit.cue?.label,
      detail: <span className="small dim cut-text">{hit.project_name}</span>,
      open: () => go(addressOf(hit, `/projects/${hit.project_id}`)),
    }))
}

/** Versions by their reasons and labels, of the open project first; none of a cue whose versions are compared blind. */
export async function findSaid(search: Search, typed: string, signal: AbortSignal): Promise<Found[]> {
  const { projectId, go } = search
  const [here, elsewhere] = await Promise.all([
    hitsHere(projectId, typed, signal),
    hitsElsewhere(projectId, typed, signal),
  ])
  return [...here, ...elsewhere]
    .filter((hit) => FEEDBACK_KINDS.includes(hit.kind) && hit.cue?.id !== comparedBlind())
    .map((hit, index) => ({
      id: `${hit.kind}-${index}`,
      ...shown(hit, typed),
      open: () => go(addressOf(hit, `/projects/${projectId}`)),
    }))
}
