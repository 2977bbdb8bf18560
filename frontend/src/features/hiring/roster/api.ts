import { infiniteQueryOptions, queryOptions, useQuery, useQueryClient } from '@tanstack/react-query'

import { unwrap, api, del, get, post, put, queryById, useMutation } from '@/api'
import { type Me, meQuery } from '@/api/me'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

import { postingQuery } from '../api'
import type { RosterSearch } from './words'

type Schemas = components['schemas']
export type Loan = Schemas['LoanFacts']
export type OwnProject = Schemas['OwnProject']
export type Roster = Schemas['RosterRead']
export type RosterRow = Schemas['RosterRow']
export type Entry = Schemas['RosterEntryRead']
export type EntryWrite = Schemas['RosterEntryWrite']
export type Figures = Schemas['WorkFigures']
export type RosterImport = Schemas['RosterImportRead']
export type RosterImportAsk = Schemas['RosterImportAsk']
export type PostingChoice = Schemas['PostingChoice']
export type ReelSound = Schemas['ReelSoundRead']

const of = (studioId: string) => ({ path: { studio_id: studioId } })

type MyStudio = Me['studios'][number]

/** The studios whose roster the current person sees; undefined until it is known. */
export function useRosterStudios(): MyStudio[] | undefined {
  const { data } = useQuery(meQuery)
  return data?.studios.filter(({ roles }) => roles.includes('producer') || roles.includes('liaison'))
}

const asked = ({ q, speciality, service, language, from, to }: RosterSearch) => ({
  q,
  speciality,
  service,
  language,
  ...(from && to ? { free_from: from, free_to: to } : {}),
})

export const rosterQuery = (studioId: string, search: RosterSearch) =>
  infiniteQueryOptions({
    queryKey: queryKeys.roster(studioId, asked(search)),
    queryFn: ({ pageParam }) =>
      unwrap(
        api.GET('/v1/studios/{studio_id}/roster', {
          params: { ...of(studioId), query: { ...asked(search), cursor: pageParam } },
        }),
      ),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: (page: Roster) => page.next ?? undefined,
  })

export const entryQuery = queryById('/v1/roster/{roster_entry_id}', queryKeys.rosterEntry)

export const workQuery = queryById('/v1/roster/{roster_entry_id}/work', (entryId) =>
  queryKeys.rosterEntry(entryId, 'work'),
)

/** The projects that the current person is engaged on as a designer. */
export const ownProjectsQuery = queryOptions({
  queryKey: queryKeys.ownWork('projects'),
  queryFn: () => get('/v1/me/own-projects'),
})

export const ownWorkQuery = queryOptions({
  queryKey: queryKeys.ownWork(),
  queryFn: () => get('/v1/me/work'),
})

export const postingsToAskQuery = queryById('/v1/roster/{roster_entry_id}/postings', (entryId) =>
  queryKeys.rosterEntry(entryId, 'postings'),
)

export function useAddEntry(studioId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: EntryWrite) =>
      unwrap(api.POST('/v1/studios/{studio_id}/roster', { params: of(studioId), body })),
    onSuccess: (entry) => {
      client.setQueryData(entryQuery(entry.id).queryKey, entry)
      return invalidate(client, queryKeys.roster.all)
    },
  })
}

/** A change of one entry, whose answer is the entry as it stands. */
function useEntryChange<T>(entryId: string, change: (value: T) => Promise<Entry>) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: change,
    onSuccess: (entry) => {
      client.setQueryData(entryQuery(entryId).queryKey, entry)
      return invalidate(client, queryKeys.roster.all, queryKeys.rosterEntry(entryId, 'postings'))
    },
  })
}

export const useSaveEntry = (entryId: string) =>
  useEntryChange(entryId, (body: EntryWrite & { revision: number }) =>
    put('/v1/roster/{roster_entry_id}', { roster_entry_id: entryId }, body),
  )

export const useSetBusy = (entryId: string) =>
  useEntryChange(entryId, (ranges: Schemas['BusyRangesWrite']['ranges']) =>
    put('/v1/roster/{roster_entry_id}/busy', { roster_entry_id: entryId }, { ranges }),
  )

export const useSetLoans = (entryId: string) =>
  useEntryChange(entryId, (loans: Schemas['LoansWrite']['loans']) =>
    put('/v1/roster/{roster_entry_id}/loans', { roster_entry_id: entryId }, { loans }),
  )

export const useReadCalendar = (entryId: string) =>
  useEntryChange(entryId, (body: Schemas['CalendarFile']) =>
    put('/v1/roster/{roster_entry_id}/calendar', { roster_entry_id: entryId }, body),
  )

export const useDropCalendar = (entryId: string) =>
  useEntryChange<undefined>(entryId, () => del('/v1/roster/{roster_entry_id}/calendar', { roster_entry_id: entryId }))

export const useRemoveSound = (entryId: string) =>
  useEntryChange(entryId, (soundId: string) => del('/v1/reel-sounds/{reel_sound_id}', { reel_sound_id: soundId }))

export const addSound = (entryId: string, uploadId: string, title: string): Promise<Entry> =>
  post('/v1/roster/{roster_entry_id}/reel', { roster_entry_id: entryId }, { upload_id: uploadId, title })

export function useRemoveEntry(entryId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => del('/v1/roster/{roster_entry_id}', { roster_entry_id: entryId }),
    onSuccess: () => {
      client.removeQueries({ queryKey: queryKeys.rosterEntry(entryId) })
      return invalidate(client, queryKeys.roster.all)
    },
  })
}

/** Asks people on file for a bid on one posting. */
export function useAskForBids(postingId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (entryIds: readonly string[]) =>
      post('/v1/postings/{posting_id}/roster-candidates', { posting_id: postingId }, { entry_ids: [...entryIds] }),
    onSuccess: (posting) => {
      client.setQueryData(postingQuery(postingId).queryKey, posting)
      return invalidate(client, queryKeys.rosterEntry.all)
    },
  })
}

export const importRoster = (studioId: string, body: RosterImportAsk): Promise<RosterImport> =>
  unwrap(api.POST('/v1/studios/{studio_id}/roster/import', { params: of(studioId), body }))

/** Import a sheet for good. */
export function useImportRoster(studioId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Omit<RosterImportAsk, 'dry_run'>) => importRoster(studioId, { ...body, dry_run: false }),
    onSuccess: ({ imported }) =>
      imported ? invalidate(client, queryKeys.roster.all, queryKeys.rosterEntry.all) : undefined,
  })
}
