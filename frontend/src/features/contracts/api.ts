import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { unwrap, api, del, get, patch, post, put, queryById, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

import type { Strokes } from './strokes'

type Schemas = components['schemas']
export type Project = Schemas['ProjectRead']
export type Contract = Schemas['ContractRead']
export type ContractBrief = Schemas['ContractBrief']
export type ContractKind = Schemas['ContractKind']
export type Version = Schemas['VersionRead']
export type VersionBrief = Schemas['VersionBrief']
export type Block = Schemas['BlockRead']
export type Span = Schemas['SpanRead']
export type Clause = Schemas['ClauseRow']
export type Draft = Schemas['DraftChange']
export type LibraryClause = Schemas['LibraryClauseRead']
export type Compared = Schemas['ComparedRead']
export type Entry = Schemas['RecordEntryRead']
export type ChangeOrders = Schemas['ChangeOrdersRead']
export type ChangeOrder = Schemas['ChangeOrderRead']
export type Difference = Schemas['DifferenceRead']
export type ChangeOffer = Schemas['ChangeOfferRead']
export type Change = Schemas['ChangeOrderAdd']['changes'][number]
export type Ending = Schemas['EndingRead']
export type StatedCue = Schemas['StatedCueRead']
export type Verified = Schemas['VerifiedRead']
export type MasterRetention = Schemas['MasterRetentionRead']
export type Template = Schemas['TemplateBrief']

export const versionsQuery = queryById('/v1/contracts/{contract_id}/versions', (contractId) =>
  queryKeys.contract(contractId, 'versions'),
)

export const versionQuery = (contractId: string, version: number) =>
  queryOptions({
    queryKey: queryKeys.contract(contractId, 'versions', version),
    queryFn: () => get('/v1/contracts/{contract_id}/versions/{version}', { contract_id: contractId, version }),
    staleTime: Infinity,
  })

export const masterRetentionQuery = queryById('/v1/contracts/{contract_id}/master-retention', (contractId) =>
  queryKeys.contract(contractId, 'masters'),
)

/** Keep masters longer than the contract asks, or no longer. */
export function useKeepMasters(contractId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (keep: boolean) =>
      put('/v1/contracts/{contract_id}/master-retention', { contract_id: contractId }, { keep }),
    onSuccess: (retention) => {
      client.setQueryData(queryKeys.contract(contractId, 'masters'), retention)
      return invalidate(client, queryKeys.contract(contractId, 'record'))
    },
  })
}

export const comparisonQuery = (contractId: string, from: number, to: number) =>
  queryOptions({
    queryKey: queryKeys.contract(contractId, 'comparison', from, to),
    queryFn: () =>
      get('/v1/contracts/{contract_id}/comparison', { contract_id: contractId, from_version: from, to_version: to }),
  })

export const recordQuery = queryById('/v1/contracts/{contract_id}/record', (contractId) =>
  queryKeys.contract(contractId, 'record'),
)

export const endingQuery = queryById('/v1/contracts/{contract_id}/ending', (contractId) =>
  queryKeys.contract(contractId, 'ending'),
)

export const changeOrdersQuery = queryById('/v1/contracts/{contract_id}/change-orders', (contractId) =>
  queryKeys.contract(contractId, 'change-orders'),
)

export const changePreviewQuery = (contractId: string, changes: Change[]) =>
  queryOptions({
    queryKey: queryKeys.contract(contractId, 'change-orders', 'preview', changes),
    queryFn: () => post('/v1/contracts/{contract_id}/change-order-preview', { contract_id: contractId }, { changes }),
    enabled: changes.length > 0,
  })

export const libraryQuery = (kind: ContractKind) =>
  queryOptions({
    queryKey: queryKeys.contractLibrary(kind),
    queryFn: () => get('/v1/contract-library/{kind}', { kind }),
    staleTime: Infinity,
  })

export const templatesQuery = queryById('/v1/studios/{studio_id}/contract-templates', queryKeys.contractTemplates)

/** The contract that a new one can begin like: the last of its kind with this designer, else the studio's last. */
export const lastContractQuery = (projectId: string, engagementId: string, kind: ContractKind) =>
  queryOptions({
    queryKey: queryKeys.contracts(projectId, 'last', engagementId, kind),
    queryFn: async () => {
      const { contract } = await get('/v1/projects/{project_id}/last-contract', {
        project_id: projectId,
        engagement_id: engagementId,
        kind,
      })
      return contract
    },
  })

export const previewQuery = (contractId: string, draft: Draft) =>
  queryOptions({
    queryKey: queryKeys.contract(contractId, 'preview', draft),
    queryFn: () => post('/v1/contracts/{contract_id}/preview', { contract_id: contractId }, draft),
    staleTime: Infinity,
    gcTime: 60_000,
  })

export const useBeginContract = (projectId: string) =>
  useMutation({
    mutationFn: (body: Schemas['ContractAdd']) =>
      post('/v1/projects/{project_id}/contracts', { project_id: projectId }, body),
    affects: [queryKeys.contracts(projectId)],
  })

export function useAskForNda(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (needed: boolean) =>
      patch('/v1/projects/{project_id}', { project_id: projectId }, { nda_needed: needed }),
    onSuccess: (project) => client.setQueryData(queryKeys.project(projectId), project),
  })
}

/** A name under a text, and the code that was mailed for it where the server mails one. */
interface Signature {
  name: string
  textSha256: string
  code: string | null
  drawing: Strokes | null
}

const signatureOf = ({ name, textSha256, code, drawing }: Signature) => ({
  name,
  text_sha256: textSha256,
  ...(code === null ? {} : { code }),
  ...(drawing === null ? {} : { drawing }),
})

/** Have a code mailed to the person who is about to sign a text. */
export const useSigningCode = (contractId: string) =>
  useMutation({
    mutationFn: (textSha256: string) =>
      post('/v1/contracts/{contract_id}/signing-codes', { contract_id: contractId }, { text_sha256: textSha256 }),
  })

/** Compare a PDF with the contracts that were sealed here. */
export const verifyPdf = (file: File) =>
  unwrap(
    api.POST('/v1/verify', {
      headers: { 'Content-Type': 'application/pdf' },
      body: file as unknown as string, // how OpenAPI's `binary` is typed
      bodySerializer: (body: unknown) => body as BodyInit,
    }),
  )

/** What a party does with a contract; each answers the contract as it is then. */
export type ContractAction =
  | { does: 'save'; body: Schemas['DraftSave'] }
  | { does: 'send'; note: string }
  | { does: 'take back'; reason: string }
  | { does: 'ask for a change'; text: string; clause: string | null }
  | ({ does: 'accept' } & Signature)
  | { does: 'sign order'; body: Schemas['SignersSet'] }
  | { does: 'end'; reason: string }
  | { does: 'divide'; body: Schemas['JointAdd'] }
  | { does: 'split'; body: Schemas['ShareSet'] }

function done(contractId: string, deed: ContractAction): Promise<Contract> {
  const it = { contract_id: contractId }
  switch (deed.does) {
    case 'save':
      return put('/v1/contracts/{contract_id}/draft', it, deed.body)
    case 'send':
      return post('/v1/contracts/{contract_id}/send', it, { note: deed.note })
    case 'take back':
      return post('/v1/contracts/{contract_id}/recall', it, { reason: deed.reason })
    case 'ask for a change': {
      const body = { text: deed.text, clause_key: deed.clause }
      return post('/v1/contracts/{contract_id}/ask-change', it, body)
    }
    case 'accept': {
      const body = signatureOf(deed)
      return post('/v1/contracts/{contract_id}/accept', it, body)
    }
    case 'sign order':
      return put('/v1/contracts/{contract_id}/signers', it, deed.body)
    case 'end':
      return post('/v1/contracts/{contract_id}/end', it, { reason: deed.reason })
    case 'divide':
      return post('/v1/contracts/{contract_id}/joint', it, deed.body)
    case 'split':
      return put('/v1/contracts/{contract_id}/joint', it, deed.body)
  }
}

export function useContractAction(contractId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (deed: ContractAction) => done(contractId, deed),
    onSuccess: async (contract) => {
      const before = client.getQueryData<Contract>(queryKeys.contract(contractId))
      const parts = [...contract.joint, ...(before?.joint ?? [])]
      const others = parts.flatMap(({ contract_id: id, is_own: isOwn }) => (id === null || isOwn ? [] : [id]))
      client.setQueryData(queryKeys.contract(contractId), contract)
      await invalidate(
        client,
        // The two contracts of joint work move together.
        ...others.flatMap((id) => [queryKeys.contract(id), queryKeys.money('plan', id)]),
        ...(others.length > 0 ? [queryKeys.money('plan', contractId)] : []),
        queryKeys.contract(contractId, 'versions'),
        queryKeys.contract(contractId, 'record'),
        queryKeys.contracts(contract.project_id),
        queryKeys.project(contract.project_id),
        // An NDA that is agreed opens the project.
        queryKeys.me(),
      )
    },
  })
}

/** What a party does about an early end; each answers the ending as it is then. */
export type EndingAction =
  | { does: 'give notice'; reason: string; endsOn: string | null }
  | { does: 'withdraw' }
  | ({ does: 'agree' } & Signature)

function doneToEnd(contractId: string, deed: EndingAction): Promise<Ending> {
  const it = { contract_id: contractId }
  switch (deed.does) {
    case 'give notice': {
      const body = { reason: deed.reason, ends_on: deed.endsOn }
      return post('/v1/contracts/{contract_id}/ending/notice', it, body)
    }
    case 'withdraw':
      return post('/v1/contracts/{contract_id}/ending/withdraw', it)
    case 'agree': {
      const body = signatureOf(deed)
      return post('/v1/contracts/{contract_id}/ending/agree', it, body)
    }
  }
}

export function useEnding(contractId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (deed: EndingAction) => doneToEnd(contractId, deed),
    onSuccess: async (ending) => {
      client.setQueryData(queryKeys.contract(contractId, 'ending'), ending)
      await invalidate(
        client,
        queryKeys.contract(contractId),
        queryKeys.contracts(ending.project_id),
        queryKeys.project(ending.project_id),
      )
    },
  })
}

/** What a party does with a change order; each answers all of them as they are then. */
export type ChangeOrderAction =
  | { does: 'propose'; reason: string; beginsAtOnce: boolean; changes: Change[]; offers: string[] }
  | { does: 'dismiss'; offer: string; reason: string }
  | ({ does: 'accept'; number: number } & Signature)
  | { does: 'refuse' | 'withdraw'; number: number; reason: string }

function doneToChange(contractId: string, deed: ChangeOrderAction): Promise<ChangeOrders> {
  if (deed.does === 'propose') {
    const { reason, beginsAtOnce, changes, offers } = deed
    const body = { reason, begins_at_once: beginsAtOnce, changes, offers }
    return post('/v1/contracts/{contract_id}/change-orders', { contract_id: contractId }, body)
  }
  if (deed.does === 'dismiss') {
    const body = { offer: deed.offer, reason: deed.reason }
    return post('/v1/contracts/{contract_id}/change-offers/dismiss', { contract_id: contractId }, body)
  }
  const it = { contract_id: contractId, change_order_number: deed.number }
  const path = '/v1/contracts/{contract_id}/change-orders/{change_order_number}'
  switch (deed.does) {
    case 'accept': {
      const body = signatureOf(deed)
      return post(`${path}/accept`, it, body)
    }
    case 'refuse':
      return post(`${path}/refuse`, it, { reason: deed.reason })
    case 'withdraw':
      return post(`${path}/withdraw`, it, { reason: deed.reason })
  }
}

export function useChangeOrder(contractId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (deed: ChangeOrderAction) => doneToChange(contractId, deed),
    onSuccess: async (orders) => {
      client.setQueryData(queryKeys.contract(contractId, 'change-orders'), orders)
      await invalidate(
        client,
        queryKeys.contract(contractId, 'record'),
        queryKeys.contract(contractId, 'ending'),
        queryKeys.project(orders.project_id),
      )
    },
  })
}

export const useKeepAsTemplate = (contractId: string) =>
  useMutation({
    mutationFn: (name: string) => post('/v1/contracts/{contract_id}/template', { contract_id: contractId }, { name }),
    affects: [queryKeys.contractTemplates.all],
  })

export const useImportTemplate = (studioId: string) =>
  useMutation({
    mutationFn: (toml: string) =>
      post('/v1/studios/{studio_id}/contract-templates/import', { studio_id: studioId }, { toml }),
    affects: [queryKeys.contractTemplates(studioId)],
  })

export const useDropTemplate = (studioId: string) =>
  useMutation({
    mutationFn: (templateId: string) =>
      del('/v1/studios/{studio_id}/contract-templates/{template_id}', { studio_id: studioId, template_id: templateId }),
    affects: [queryKeys.contractTemplates(studioId)],
  })
