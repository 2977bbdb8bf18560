import { keepPreviousData, queryOptions, useQueryClient } from '@tanstack/react-query'

import { unwrap, api, get, post, put, queryById, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
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
export type Payment = Schemas['PaymentRead']
export type PaymentAdd = Schemas['PaymentAdd']
export type MilestoneSheet = Schemas['MilestoneSheet']
export type MilestoneCue = Schemas['MilestoneCue']
export type Slip = Schemas['MilestoneSlip']
export type Estimates = Schemas['EstimatesRead']
export type LedgerLine = Schemas['LedgerLineRead']
export type Plan = Schemas['PlanRead']
export type PlanSet = Schemas['PlanSet']
export type PlanProposal = Schemas['PlanProposal']
export type PlanChecked = Schemas['PlanChecked']
export type Contract = Schemas['ContractRead']
export type ListedCue = Schemas['CueRead']
export type Bonus = Schemas['BonusRead']
export type WorkedDay = Schemas['WorkedDayRead']
export type WorkedDayAdd = Schemas['WorkedDayAdd']
export type Hours = Schemas['HoursRead']
export type WorkLogAdd = Schemas['WorkLogAdd']
export type Effort = Schemas['Effort']

interface EffortOf {
  posting_id?: string
  contract_id?: string
  begin_on?: string
  due_on?: string
  weekly_hours?: number
}

/** Hours of the cues of a posting or a contract, and the days on which they can be done. */
export const effortQuery = (projectId: string, query: EffortOf) =>
  queryOptions({
    queryKey: queryKeys.effort(projectId, query),
    queryFn: () => get('/v1/projects/{project_id}/effort', { project_id: projectId, ...query }),
    placeholderData: keepPreviousData,
  })

export const moneyQuery = queryById('/v1/projects/{project_id}/money', queryKeys.money)

export const cueMoneyQuery = queryById('/v1/cues/{cue_id}/money', (cueId) => queryKeys.money('cue', cueId))

export const ledgerQuery = queryById('/v1/contracts/{contract_id}/ledger', (contractId) =>
  queryKeys.money('ledger', contractId),
)

/** An invoice as PDF with its XML inside. */
export const electronicInvoice = (invoiceId: string): Promise<Blob> =>
  unwrap(
    api.GET('/v1/invoices/{invoice_id}/electronic-invoice.pdf', {
      params: { path: { invoice_id: invoiceId } },
      parseAs: 'blob',
    }),
  )

/** Say on which day the game shipped: the bonus that waits for it is due. */
export function useSayShipped(contractId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (shippedOn: string) =>
      post('/v1/contracts/{contract_id}/shipped', { contract_id: contractId }, { shipped_on: shippedOn }),
    onSuccess: (ledger) => client.setQueryData(ledgerQuery(contractId).queryKey, ledger),
    onSettled: () => invalidate(client, queryKeys.money.all, queryKeys.nextSteps.all),
  })
}

export const invoicesQuery = queryById('/v1/contracts/{contract_id}/invoices', (contractId) =>
  queryKeys.money('invoices', contractId),
)

/** The next invoice, under the number that was typed or, without one, the number after the last. */
export const invoiceDraftQuery = (contractId: string, fullNumber = '') =>
  queryOptions({
    queryKey: queryKeys.money('invoice-draft', contractId, fullNumber),
    queryFn: () =>
      unwrap(
        api.GET('/v1/contracts/{contract_id}/invoice-draft', {
          params: { path: { contract_id: contractId }, query: fullNumber === '' ? {} : { full_number: fullNumber } },
        }),
      ),
    retry: false,
    placeholderData: keepPreviousData,
  })

export const estimatesQuery = queryById(
  '/v1/contracts/{contract_id}/estimates',
  (contractId) => queryKeys.money('estimates', contractId),
  {
    retry: false,
  },
)

/** Milestones by the due dates and categories of the list, to begin a plan from. */
export const proposedPlan = (contractId: string, totalMinor: number | null) =>
  unwrap(
    api.GET('/v1/contracts/{contract_id}/milestones/proposal', {
      params: { path: { contract_id: contractId }, query: totalMinor === null ? {} : { total_minor: totalMinor } },
    }),
  )

export const proposedPlanQuery = (contractId: string, totalMinor: number | null) =>
  queryOptions({
    queryKey: queryKeys.money('plan-proposal', contractId, totalMinor),
    queryFn: () => proposedPlan(contractId, totalMinor),
  })

export const milestoneQuery = queryById('/v1/milestones/{milestone_id}', (milestoneId) =>
  queryKeys.money('milestone', milestoneId),
)

export const planQuery = queryById('/v1/contracts/{contract_id}/milestones', (contractId) =>
  queryKeys.money('plan', contractId),
)

/** The errors and warnings of a plan as it is typed. */
export const planCheckQuery = (contractId: string, plan: PlanSet) =>
  queryOptions({
    queryKey: queryKeys.money('plan-check', contractId, plan),
    queryFn: () => post('/v1/contracts/{contract_id}/plan-check', { contract_id: contractId }, plan),
    staleTime: Infinity,
    gcTime: 60_000,
  })

export const daysQuery = queryById('/v1/contracts/{contract_id}/worked-days', (contractId) =>
  queryKeys.money('days', contractId),
)

function useMoneyChange<Given, Answer>(change: (given: Given) => Promise<Answer>) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: change,
    onSettled: () => void invalidate(client, queryKeys.money.all),
  })
}

export const useIssueInvoice = (contractId: string) =>
  useMoneyChange((body: InvoiceIssue) =>
    post('/v1/contracts/{contract_id}/invoices', { contract_id: contractId }, body),
  )

export const useRecordPayment = (invoiceId: string) =>
  useMoneyChange((body: PaymentAdd) => post('/v1/invoices/{invoice_id}/payments', { invoice_id: invoiceId }, body))

export const useChargeInterest = ({ id }: Invoice) =>
  useMoneyChange(() => post('/v1/invoices/{invoice_id}/late-interest', { invoice_id: id }))

export const useRefund = (paymentId: string) =>
  useMoneyChange((body: PaymentAdd) => post('/v1/payments/{payment_id}/refunds', { payment_id: paymentId }, body))

export const useSavePlan = (contractId: string) =>
  useMoneyChange((body: PlanSet) => put('/v1/contracts/{contract_id}/milestones', { contract_id: contractId }, body))

export const useLogDay = (contractId: string) =>
  useMoneyChange((body: WorkedDayAdd) =>
    post('/v1/contracts/{contract_id}/worked-days', { contract_id: contractId }, body),
  )

/** Logs hours, or corrects those of an entry and sends them again. */
export const useLogHours = (contractId: string, correctedId?: string) =>
  useMoneyChange((body: WorkedDayAdd) => {
    if (correctedId === undefined)
      return post('/v1/contracts/{contract_id}/worked-days', { contract_id: contractId }, body)
    const params = { params: { path: { worked_day_id: correctedId } } }
    return unwrap(api.PUT('/v1/worked-days/{worked_day_id}', { ...params, body }))
  })

export const useRefuseDay = (workedDayId: string) =>
  useMoneyChange((body: Schemas['WorkRefusal']) =>
    post('/v1/worked-days/{worked_day_id}/refuse', { worked_day_id: workedDayId }, body),
  )

export const useSettleDay = (workedDayId: string) =>
  useMoneyChange(async (how: 'agree' | 'take back') => {
    const params = { params: { path: { worked_day_id: workedDayId } } }
    if (how === 'agree') await unwrap(api.POST('/v1/worked-days/{worked_day_id}/agree', params))
    else await unwrap(api.DELETE('/v1/worked-days/{worked_day_id}', params))
  })

export const useLogWork = (contractId: string) =>
  useMoneyChange((body: WorkLogAdd) => post('/v1/contracts/{contract_id}/work-logs', { contract_id: contractId }, body))

export const useSettleRound = (extraRoundId: string) =>
  useMoneyChange((how: 'agree' | 'drop') => {
    const params = { params: { path: { extra_round_id: extraRoundId } } }
    return unwrap(
      how === 'agree'
        ? api.POST('/v1/extra-rounds/{extra_round_id}/agree', params)
        : api.POST('/v1/extra-rounds/{extra_round_id}/drop', params),
    )
  })

export const useMakeCalendar = (projectId: string) =>
  useMutation({
    mutationFn: () => post('/v1/projects/{project_id}/calendar', { project_id: projectId }),
  })

export type OwnTimes = Schemas['OwnTimes']
export type OwnTimeAdd = Schemas['OwnTimeAdd']

/** The caller's time in a project without a contract; a bidder names the posting. */
export const ownTimeQuery = (projectId: string, postingId?: string) =>
  queryOptions({
    queryKey: queryKeys.money('own-time', projectId, postingId),
    queryFn: () => get('/v1/projects/{project_id}/own-time', { project_id: projectId, posting_id: postingId }),
  })

export const useLogOwnTime = (projectId: string) =>
  useMoneyChange((body: OwnTimeAdd) => post('/v1/projects/{project_id}/own-time', { project_id: projectId }, body))

export const useDropOwnTime = () =>
  useMoneyChange((ownTimeId: string) =>
    unwrap(api.DELETE('/v1/own-time/{own_time_id}', { params: { path: { own_time_id: ownTimeId } } })),
  )
