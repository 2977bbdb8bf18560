import { keepPreviousData, queryOptions, useQueryClient } from '@tanstack/react-query'

import { unwrap, api, post, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Redlines = Schemas['RedlinesRead']
export type Round = Schemas['RedlineRoundRead']
export type Marked = Schemas['MarkedClauseRead']
export type Redline = Schemas['RedlineRead']
export type Wording = Schemas['WordingRead']
export type WordChanges = Schemas['WordChangesRead']
export type Proposed = Schemas['RedlineAdd']
export type Answer = Pick<Schemas['RedlineAnswerAdd'], 'answer'> & Partial<Schemas['RedlineAnswerAdd']>

/** What a change, or an answer, has to begin with. */
export const NOTHING = { title: '', text: '', terms: {}, comment: '' }

/** A round of redlines in the text that it is about; the last one, unless another is named. */
export const redlinesQuery = (contractId: string, round?: number) =>
  queryOptions({
    queryKey: queryKeys.contract(contractId, 'redlines', round ?? 'last'),
    queryFn: () =>
      unwrap(
        api.GET('/v1/contracts/{contract_id}/redlines', {
          params: { path: { contract_id: contractId }, query: round === undefined ? {} : { round } },
        }),
      ),
  })

/** The text as changes would mark it, and what is wrong with them. */
export const redlinePreviewQuery = (contractId: string, version: number, changes: Proposed[]) =>
  queryOptions({
    queryKey: queryKeys.contract(contractId, 'redline-preview', version, changes),
    queryFn: () => post('/v1/contracts/{contract_id}/redline-preview', { contract_id: contractId }, { changes }),
    placeholderData: keepPreviousData,
    staleTime: Infinity,
    gcTime: 60_000,
  })

function useRedlines<T>(contractId: string, send: (body: T) => Promise<Redlines>) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: send,
    onSuccess: async (redlines) => {
      client.setQueryData(redlinesQuery(contractId).queryKey, redlines)
      await invalidate(
        client,
        queryKeys.contract(contractId),
        queryKeys.contracts(redlines.project_id),
        queryKeys.nextSteps(redlines.project_id),
        queryKeys.today(redlines.project_id),
      )
    },
  })
}

export const useProposeRedlines = (contractId: string) =>
  useRedlines(contractId, (body: Schemas['RedlinesAdd']) =>
    post('/v1/contracts/{contract_id}/redlines', { contract_id: contractId }, body),
  )

export const useAnswerRedline = (contractId: string) =>
  useRedlines(contractId, ({ number, body }: { number: number; body: Answer }) =>
    post(
      '/v1/contracts/{contract_id}/redlines/{redline_number}/answer',
      { contract_id: contractId, redline_number: number },
      { ...NOTHING, ...body },
    ),
  )

/** Reads a Word document, given in Base64; nothing is saved. */
export const useReadWord = (contractId: string) =>
  useMutation({
    mutationFn: (contentBase64: string) =>
      post('/v1/contracts/{contract_id}/redlines/word', { contract_id: contractId }, { content_base64: contentBase64 }),
  })
