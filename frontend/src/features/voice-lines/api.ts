import { infiniteQueryOptions, queryOptions } from '@tanstack/react-query'

import { unwrap, api, del, patch, put, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

import type { LinesSearch } from './search'

type Schemas = components['schemas']
export type Script = Schemas['VoiceScriptRead']
export type Character = Schemas['CharacterRead']
export type Casting = Schemas['CastingRead']
export type Performer = Schemas['PerformerRead']
export type ScriptAsk = Schemas['ScriptAsk']
export type ScriptRead = Schemas['ScriptRead']
export type ReleaseAdd = Schemas['ReleaseAdd']

const of = (projectId: string) => ({ path: { project_id: projectId } })

/** Languages, characters and settings of the script. */
export const scriptQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.voiceLines(projectId, 'script'),
    queryFn: () => unwrap(api.GET('/v1/projects/{project_id}/voice-script', { params: of(projectId) })),
  })

/** The lines of one language, page by page. */
export const linesQuery = (projectId: string, { language, state, character, search }: LinesSearch) =>
  infiniteQueryOptions({
    queryKey: queryKeys.voiceLines(projectId, 'lines', language, state, character, search),
    queryFn: ({ pageParam: start }) =>
      unwrap(
        api.GET('/v1/projects/{project_id}/voice-lines', {
          params: { ...of(projectId), query: { language, state, character, search, start } },
        }),
      ),
    initialPageParam: 0,
    getNextPageParam: ({ next }) => next ?? undefined,
  })

/** What the next session records. */
export const pickUpsQuery = (projectId: string, { language, character }: LinesSearch) =>
  queryOptions({
    queryKey: queryKeys.voiceLines(projectId, 'pick-ups', language, character),
    queryFn: () =>
      unwrap(
        api.GET('/v1/projects/{project_id}/pick-ups', {
          params: { ...of(projectId), query: { language, character } },
        }),
      ),
  })

/** Performers with their releases. */
export const releasesQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.voiceLines(projectId, 'releases'),
    queryFn: () => unwrap(api.GET('/v1/projects/{project_id}/voice-releases', { params: of(projectId) })),
  })

export const sendScript = (projectId: string, body: ScriptAsk): Promise<ScriptRead> =>
  unwrap(api.POST('/v1/projects/{project_id}/voice-lines/import', { params: of(projectId), body }))

/** A change of the script, after which all that is shown of it is read again. */
const useChange = <Given, Answer>(projectId: string, change: (given: Given) => Promise<Answer>) =>
  useMutation({
    mutationFn: change,
    affects: [queryKeys.voiceLines(projectId)],
  })

export const useImportScript = (projectId: string) =>
  useChange(projectId, (body: Omit<ScriptAsk, 'dry_run'>) => sendScript(projectId, { ...body, dry_run: false }))

export const useChangeText = (projectId: string, lineId: string, language: string) =>
  useChange(projectId, (body: Schemas['VoiceTextChange']) =>
    put('/v1/voice-lines/{voice_line_id}/texts/{language}', { voice_line_id: lineId, language }, body),
  )

export const useChangeLine = (projectId: string, lineId: string) =>
  useChange(projectId, (body: { scene: string; direction: string }) =>
    patch('/v1/voice-lines/{voice_line_id}', { voice_line_id: lineId }, body),
  )

export const useChangeSettings = (projectId: string) =>
  useChange(projectId, (body: Schemas['VoiceSettingsChange']) =>
    unwrap(api.PUT('/v1/projects/{project_id}/voice-settings', { params: of(projectId), body })),
  )

export const useCast = (projectId: string, characterId: string, language: string) =>
  useChange(projectId, (body: Schemas['CastingChange']) =>
    put(
      '/v1/voice-characters/{voice_character_id}/castings/{language}',
      { voice_character_id: characterId, language },
      body,
    ),
  )

export const useRemoveRelease = (projectId: string) =>
  useChange(projectId, (releaseId: string) =>
    del('/v1/voice-releases/{voice_release_id}', { voice_release_id: releaseId }),
  )
