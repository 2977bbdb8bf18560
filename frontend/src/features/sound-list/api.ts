import { infiniteQueryOptions, type QueryClient, queryOptions, useQueryClient } from '@tanstack/react-query'

import { unwrap, api, ApiProblem, everyPage, get, patch, post, queryById, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import { useMyProject } from '@/api/me'
import type { components } from '@/api/schema.gen'
import { CUES_A_PAGE, readAll } from '@/api/soundList'
import { useAsyncJob } from '@/api/useAsyncJob'

type Schemas = components['schemas']
export type Cue = Schemas['CueRead']
export type CueDetail = Schemas['CueDetail']
export type CueAdd = Schemas['CueAdd']
export type CueStatus = Schemas['CueStatus']
export type CueProgress = Schemas['CueProgress']
export type Handoff = Schemas['HandoffRead']
export type Question = Schemas['QuestionRead']
export type Take = Schemas['TakeRead']
export type Reel = Schemas['ReelRead']
export type ReelAdd = Schemas['ReelAdd']
export type Finding = Schemas['FindingRead']
export type Revision = Schemas['RevisionRead']
export type Comparison = Schemas['ListComparison']
export type Difference = Schemas['CueDifference']
export type FieldChange = Schemas['FieldChange']

/** The hand-offs of a cue between makers; a designer's from or to them. */
export const handoffsQuery = queryById('/v1/cues/{cue_id}/handoffs', queryKeys.handoffs)

const SOON_MS = 3000

/** Where every cue stands; asked again soon while something is being checked, the longer the list the later. */
export const progressQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.progress(projectId, 'cues'),
    queryFn: ({ client, queryKey }) =>
      readAll(
        client,
        queryKey,
        (page) => get('/v1/projects/{project_id}/sound-list/progress', { project_id: projectId, ...page }),
        (pages) => pages.flatMap(({ cues }) => cues),
      ),
    refetchInterval: ({ state: { data } }) =>
      data?.some(({ status }) => status === 'checking') ? SOON_MS * Math.ceil(data.length / CUES_A_PAGE) : false,
  })

/** How many cues stand where, in the whole list. */
export const countsQuery = queryById('/v1/projects/{project_id}/sound-list/counts', (projectId) =>
  queryKeys.progress(projectId, 'counts'),
)

export const openQuestionsQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.soundList(projectId, 'open questions'),
    queryFn: () =>
      everyPage((cursor) =>
        get('/v1/projects/{project_id}/questions', { project_id: projectId, only_open: true, cursor }),
      ).then((pages) => pages.flatMap(({ items }) => items)),
  })

/** Files that no cue owns yet; each names the cues it may be for. */
export const unmatchedQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.soundList(projectId, 'unmatched'),
    queryFn: async () =>
      (await get('/v1/projects/{project_id}/takes', { project_id: projectId, unmatched: true })).items,
  })

export const revisionsQuery = (projectId: string) =>
  infiniteQueryOptions({
    queryKey: queryKeys.soundList(projectId, 'revisions'),
    queryFn: ({ pageParam }) => readRevisions(projectId, pageParam),
    initialPageParam: undefined as number | undefined,
    getNextPageParam: ({ next }) => (next ? Number(next) : undefined),
  })

const readRevisions = (projectId: string, before?: number) =>
  get('/v1/projects/{project_id}/sound-list/revisions', { project_id: projectId, cursor: before })

/** What happened between two revisions; both are kept as they were, so it never changes. */
export const compareQuery = (projectId: string, from: number, to: number) =>
  queryOptions({
    queryKey: queryKeys.comparedRevisions(projectId, from, to),
    queryFn: () => get('/v1/projects/{project_id}/sound-list/revisions/compare', { project_id: projectId, from, to }),
    staleTime: Infinity,
  })

/** What one revision did to one cue. */
export interface CueChanged {
  revision: Revision
  kind: 'added' | 'changed' | 'cut'
  changes: FieldChange[]
}

const BACK = 10

/** The changes of one cue, from the newest revision back, a few revisions at a time. */
export const cueChangesQuery = (projectId: string, cue: Pick<Cue, 'id' | 'label' | 'edition'>) =>
  infiniteQueryOptions({
    queryKey: queryKeys.soundList(projectId, 'changes', cue.id, cue.edition),
    queryFn: async ({ pageParam, client }) => {
      const page = await readRevisions(projectId, pageParam)
      const looked = page.items.slice(0, BACK)
      const changes = await Promise.all(
        looked
          .filter(({ summary }) => !summary.endsWith(' cut') || summary === `${cue.label} cut`)
          .map(async (revision): Promise<CueChanged | null> => {
            const compared = await client.ensureQueryData(compareQuery(projectId, revision.number - 1, revision.number))
            for (const kind of ['added', 'changed', 'cut'] as const) {
              const difference = compared[kind].find(({ id }) => id === cue.id)
              if (difference) return { revision, kind, changes: difference.changes }
            }
            return null
          }),
      )
      const oldest = looked.at(-1)?.number ?? 1
      return { found: changes.filter((change) => change !== null), next: oldest > 1 ? oldest : undefined }
    },
    initialPageParam: undefined as number | undefined,
    // A cue's edition counts its changes, so one knows when the last of them is found.
    getNextPageParam: ({ next }, pages) =>
      pages.some(({ found }) => found.some(({ kind }) => kind === 'added')) ||
      pages.reduce((sum, { found }) => sum + found.length, 0) >= cue.edition
        ? undefined
        : next,
  })

export const cueQuery = queryById('/v1/cues/{cue_id}', queryKeys.cue)

/** One delivered version with what is needed to hear and to read it. */
export interface Version {
  take: Take
  thumb: Schemas['ThumbRead'] | null
  previewUrl: string | null
  durationS: number | null
  findings: Finding[]
}

/** Every version of a cue that the person may see, the newest first. */
export const versionsQuery = (projectId: string, cueId: string) =>
  queryOptions({
    queryKey: queryKeys.cueTakes(cueId),
    queryFn: async (): Promise<Version[]> => {
      const pages = await everyPage((cursor) =>
        get('/v1/projects/{project_id}/takes', { project_id: projectId, cue_id: cueId, cursor }),
      )
      return Promise.all(
        pages
          .flatMap(({ items }) => items)
          .map(async (take) => {
            const ofTake = { params: { path: { take_id: take.id } } }
            const [sounds, check] = await Promise.all([
              orNothing(unwrap(api.GET('/v1/takes/{take_id}/sounds', ofTake))),
              orNothing(unwrap(api.GET('/v1/takes/{take_id}/check', ofTake))),
            ])
            return {
              take,
              thumb: sounds?.master.thumb ?? null,
              previewUrl: sounds?.master.preview_url ?? null,
              durationS: sounds?.master.duration_s ?? null,
              findings: check?.findings ?? [],
            }
          }),
      )
    },
  })

/** A take that is still being checked has no findings yet, and that is not a fault. */
async function orNothing<T>(asking: Promise<T>): Promise<T | null> {
  try {
    return await asking
  } catch (error) {
    if (error instanceof ApiProblem && error.status === 404) return null
    throw error
  }
}

export interface Rights {
  /** Producers, liaisons and the approver change the list; everyone else reads it and asks. */
  edits: boolean
  cuts: boolean
  reviews: boolean
  known: boolean
}

export function useRights(projectId: string): Rights {
  const project = useMyProject(projectId)
  const isProducer = project?.is_producer ?? false
  const isApprover = project?.is_approver ?? false
  return {
    edits: isProducer || isApprover || (project?.is_liaison ?? false),
    cuts: isProducer || isApprover,
    reviews: project?.part === 'team',
    known: project !== undefined,
  }
}

/** Refetch everything that a change of the list affects, on any page. */
export const refreshList = (client: QueryClient, projectId: string) =>
  invalidate(
    client,
    queryKeys.soundList(projectId),
    queryKeys.coverage(projectId),
    queryKeys.progress(projectId),
    queryKeys.cue.all,
    queryKeys.cueReview.all,
    queryKeys.reviewQueue(projectId),
    queryKeys.desk(projectId),
    queryKeys.today.all,
    queryKeys.overview.all,
  )

export function useAddCues(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (cues: CueAdd[]) => post('/v1/projects/{project_id}/cues', { project_id: projectId }, { cues }),
    onSuccess: () => refreshList(client, projectId),
  })
}

/** Some facts of a cue, by their names. */
export type CueFacts = Partial<CueAdd>

/** Change facts of a cue that was read at `edition`. What is left out stays as it is. */
export function useChangeCue(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: ({ cueId, edition, facts }: { cueId: string; edition: number; facts: CueFacts }) =>
      patch('/v1/cues/{cue_id}', { cue_id: cueId }, { edition, ...facts } as Schemas['CuePatch']),
    onSuccess: () => refreshList(client, projectId),
  })
}

export function useCut(projectId: string, cueId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (reason: string) => post('/v1/cues/{cue_id}/cut', { cue_id: cueId }, { reason }),
    onSuccess: () => refreshList(client, projectId),
  })
}

export function useAsk(projectId: string, cueId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Schemas['QuestionAdd']) => post('/v1/cues/{cue_id}/questions', { cue_id: cueId }, body),
    onSuccess: () => refreshList(client, projectId),
  })
}

/** Say who answers a question, by when, and whether work waits for it. */
export function useQuestionChange(projectId: string, questionId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Schemas['QuestionPatch']) =>
      patch('/v1/questions/{question_id}', { question_id: questionId }, body),
    onSuccess: () => refreshList(client, projectId),
  })
}

export function useAnswer(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: ({ questionId, text, joins }: { questionId: string; text: string; joins: boolean }) =>
      post('/v1/questions/{question_id}/answer', { question_id: questionId }, { text, joins }),
    onSuccess: () => refreshList(client, projectId),
  })
}

/** What a query or a mutation was refused, if it was. */
export const problemIn = (error: unknown): ApiProblem | null => (error instanceof ApiProblem ? error : null)

/** The cue as it stands now, whatever is kept here. */
export async function readAgain(client: QueryClient, projectId: string, cueId: string): Promise<CueDetail> {
  void invalidate(client, queryKeys.soundList(projectId, 'list'))
  return client.fetchQuery({ ...cueQuery(cueId), staleTime: 0 })
}

/** Ask for all takes of a cue in a row. */
export const useReel = (cueId: string) =>
  useAsyncJob<ReelAdd, Reel>(
    'reel',
    (body) => post('/v1/cues/{cue_id}/reels', { cue_id: cueId }, body),
    (id) => get('/v1/reels/{reel_id}', { reel_id: id }),
  )
