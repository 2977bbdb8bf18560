import { queryOptions, useMutation, useQueryClient } from '@tanstack/react-query'

import { answered, api } from '@/api'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type ProjectMoney = Schemas['ProjectMoney']
export type ContractMoney = Schemas['ContractMoney']
export type Figures = Schemas['FiguresRead']
export type MilestoneMoney = Schemas['MilestoneRead']
export type CueMoney = Schemas['CueMoneyRead']
export type ExtraRound = Schemas['ExtraRoundRead']
export type Invoice = Schemas['InvoiceRead']
export type InvoiceIssue = Schemas['InvoiceIssue']
export type PaymentAdd = Schemas['PaymentAdd']

/** Whatever is done to money, every screen that sums it up is asked anew. */
const MONEY = 'money'

export const moneyQuery = (projectId: string) =>
  queryOptions({
    queryKey: [MONEY, projectId],
    queryFn: () =>
      answered(api.GET('/v1/projects/{project_id}/money', { params: { path: { project_id: projectId } } })),
  })

export const cueMoneyQuery = (cueId: string) =>
  queryOptions({
    queryKey: [MONEY, 'cue', cueId],
    queryFn: () => answered(api.GET('/v1/cues/{cue_id}/money', { params: { path: { cue_id: cueId } } })),
  })

const of = (contractId: string) => ({ params: { path: { contract_id: contractId } } })

export const ledgerQuery = (contractId: string) =>
  queryOptions({
    queryKey: [MONEY, 'ledger', contractId],
    queryFn: () => answered(api.GET('/v1/contracts/{contract_id}/ledger', of(contractId))),
  })

export const invoicesQuery = (contractId: string) =>
  queryOptions({
    queryKey: [MONEY, 'invoices', contractId],
    queryFn: () => answered(api.GET('/v1/contracts/{contract_id}/invoices', of(contractId))),
  })

export const invoiceDraftQuery = (contractId: string) =>
  queryOptions({
    queryKey: [MONEY, 'invoice-draft', contractId],
    queryFn: () => answered(api.GET('/v1/contracts/{contract_id}/invoice-draft', of(contractId))),
    retry: false,
  })

export const estimatesQuery = (contractId: string) =>
  queryOptions({
    queryKey: [MONEY, 'estimates', contractId],
    queryFn: () => answered(api.GET('/v1/contracts/{contract_id}/estimates', of(contractId))),
    retry: false,
  })

function useMoneyChange<Given, Answer>(change: (given: Given) => Promise<Answer>) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: change,
    onSettled: () => void client.invalidateQueries({ queryKey: [MONEY] }),
  })
}

export const useIssueInvoice = (contractId: string) =>
  useMoneyChange((body: InvoiceIssue) =>
    answered(api.POST('/v1/contracts/{contract_id}/invoices', { ...of(contractId), body })),
  )

export const useRecordPayment = (invoiceId: string) =>
  useMoneyChange((body: PaymentAdd) =>
    answered(api.POST('/v1/invoices/{invoice_id}/payments', { params: { path: { invoice_id: invoiceId } }, body })),
  )

export const useSettleRound = (extraRoundId: string) =>
  useMoneyChange((how: 'agree' | 'drop') => {
    const params = { params: { path: { extra_round_id: extraRoundId } } }
    return answered(
      how === 'agree'
        ? api.POST('/v1/extra-rounds/{extra_round_id}/agree', params)
        : api.POST('/v1/extra-rounds/{extra_round_id}/drop', params),
    )
  })

export const useMakeCalendar = (projectId: string) =>
  useMutation({
    mutationFn: () =>
      answered(api.POST('/v1/projects/{project_id}/calendar', { params: { path: { project_id: projectId } } })),
  })
