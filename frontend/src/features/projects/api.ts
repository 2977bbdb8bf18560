import { keepPreviousData, queryOptions, useInfiniteQuery, useQuery, useQueryClient } from '@tanstack/react-query'

import { del, get, patch, post, put, queryById, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'
import type { Severity } from '@/ui/severity'

type Schemas = components['schemas']
export type Project = Schemas['ProjectRead']
export type Overview = Schemas['Overview']
export type Step = Schemas['Step']
export type PaletteSound = Schemas['PaletteSound']
export type Happening = Schemas['Activity']
export type Build = Schemas['BuildSummary']
export type BuildBrief = Schemas['BuildBrief']
export type Pack = Schemas['PackRead']
export type Countdown = Schemas['PlaceholderCountdown']
export type Token = Schemas['TokenRead']
export type TokenMade = Schemas['TokenMade']
export type Scope = Schemas['Scope']
export type Spec = Schemas['SpecRead']
export type Check = Schemas['CheckDescription']
export type CheckLimit = Schemas['CheckLimitDescription']
export type SpecBrief = Schemas['SpecBrief']
export type SpecDraftChecked = Schemas['SpecDraftChecked']
export type Cue = Schemas['CueRead']

/** A report of a build, as far as a page shows it. */
export interface BuildReport {
  spec?: { name: string; sha256: string } | null
  files: ReportFile[]
}
export interface ReportFile {
  path: string
  verdict: 'conforming' | 'rejected' | 'unreadable' | 'unjudged'
  findings: { code: string; severity: Severity; message: string; fix?: string | null; waived?: boolean }[]
}

// Projects

export const useProjects = (archived: boolean) =>
  useInfiniteQuery({
    queryKey: queryKeys.projects({ archived }),
    queryFn: ({ pageParam: cursor }) => get('/v1/projects', { cursor, archived }),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
  })

/** What the server checks: it stays the same as long as the page is open. */
export const checksQuery = queryOptions({
  queryKey: queryKeys.checks(),
  queryFn: () => get('/v1/checks'),
  staleTime: Infinity,
})

export const useOpenProject = () =>
  useMutation({
    mutationFn: (body: Schemas['ProjectAdd']) => post('/v1/projects', {}, body),
    affects: [queryKeys.me(), queryKeys.projects.all],
  })

export function useChangeProject(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Schemas['ProjectChange']) => patch('/v1/projects/{project_id}', { project_id: projectId }, body),
    onSuccess: (project) => {
      client.setQueryData(queryKeys.project(projectId), project)
      return invalidate(client, queryKeys.me(), queryKeys.projects.all, queryKeys.overview(projectId))
    },
  })
}

// Spec

export const specVersionQuery = (projectId: string, version: number) =>
  queryOptions({
    queryKey: queryKeys.specVersion(projectId, version),
    queryFn: () => get('/v1/projects/{project_id}/spec/versions/{version}', { project_id: projectId, version }),
    staleTime: Infinity,
  })

export const useSpecVersions = (projectId: string) =>
  useInfiniteQuery({
    queryKey: queryKeys.specVersions(projectId),
    queryFn: ({ pageParam: cursor }) =>
      get('/v1/projects/{project_id}/spec/versions', { project_id: projectId, cursor }),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
  })

/** A spec as it is being written: its text, or the tables of the form. */
export type Written = { toml: string } | { tables: Record<string, unknown> }

/** What a text or a form's tables come to; nothing is saved. */
export const useSpecTry = (projectId: string, written: Written, enabled: boolean) =>
  useQuery({
    queryKey: queryKeys.specDraftCheck(projectId, written),
    queryFn: () => post('/v1/projects/{project_id}/spec/check-toml', { project_id: projectId }, written),
    enabled,
    placeholderData: keepPreviousData,
    staleTime: Infinity,
    gcTime: 60_000,
  })

export type SpecToSave = Written & { note: string; based_on_version: number }

export function useSaveSpec(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: SpecToSave) =>
      'toml' in body
        ? put('/v1/projects/{project_id}/spec', { project_id: projectId }, body)
        : post('/v1/projects/{project_id}/spec/form', { project_id: projectId }, body),
    onSuccess: (spec) => {
      client.setQueryData(queryKeys.spec(projectId), spec)
      return invalidate(
        client,
        queryKeys.specVersions(projectId),
        queryKeys.project(projectId),
        queryKeys.overview(projectId),
        queryKeys.packs(projectId),
        queryKeys.acceptedFiles(projectId),
      )
    },
  })
}

// Builds, tokens, packs

export const useBuilds = (projectId: string) =>
  useInfiniteQuery({
    queryKey: queryKeys.builds(projectId),
    queryFn: ({ pageParam: cursor }) => get('/v1/projects/{project_id}/builds', { project_id: projectId, cursor }),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
  })

export const useBuildReport = (buildId: string) =>
  useQuery({
    queryKey: queryKeys.build(buildId),
    queryFn: async () => {
      const { report } = await get('/v1/builds/{build_id}', { build_id: buildId })
      return report as unknown as BuildReport
    },
    staleTime: Infinity,
  })

export const useTokens = (projectId: string, enabled: boolean) =>
  useQuery({
    queryKey: queryKeys.tokens(projectId),
    queryFn: () => get('/v1/projects/{project_id}/tokens', { project_id: projectId }),
    enabled,
  })

export const useMakeToken = (projectId: string) =>
  useMutation({
    mutationFn: (body: Schemas['TokenAdd']) =>
      post('/v1/projects/{project_id}/tokens', { project_id: projectId }, body),
    affects: [queryKeys.tokens(projectId)],
  })

export function useRevokeToken(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (tokenId: string) =>
      del('/v1/projects/{project_id}/tokens/{token_id}', { project_id: projectId, token_id: tokenId }),
    onSettled: () => invalidate(client, queryKeys.tokens(projectId)),
  })
}

/** How much is still a placeholder for the spec's first target. */
export const countdownQuery = queryById('/v1/projects/{project_id}/placeholders/countdown', (projectId) =>
  queryKeys.placeholders(projectId, 'countdown'),
)

/** The approved pack of every target, in the order of the spec. */
export const packsQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.packs(projectId),
    queryFn: async (): Promise<Pack[]> => {
      const read = (target?: string) => get('/v1/projects/{project_id}/pack', { project_id: projectId, target })
      const first = await read()
      return [first, ...(await Promise.all(first.targets.slice(1).map(read)))]
    },
  })

const versioned = (projectId: string, file: string, query: Record<string, string>) =>
  `/v1/projects/${projectId}/${file}?${new URLSearchParams(query).toString()}`

/** Where a browser fetches a pack, and what says what its files are. */
export const packUrl = (projectId: string, target: string, how: { masters: boolean; allowMissing: boolean }): string =>
  versioned(projectId, 'pack.zip', {
    target,
    ...(how.masters ? { masters: 'true' } : {}),
    ...(how.allowMissing ? { allow_missing: 'true' } : {}),
  })
export const keyUrl = (projectId: string, target: string, kind: 'csv' | 'xlsx' | 'pdf'): string =>
  versioned(projectId, `documentation-key.${kind}`, { target })
