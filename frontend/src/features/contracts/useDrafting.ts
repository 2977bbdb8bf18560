import { keepPreviousData, useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { useDebounced } from '@/ui/useDebounced'

import { amountsOf } from './AmountsAgain'
import { type Contract, type Draft, libraryQuery, previewQuery, useContractAction } from './api'

const NO_CLAUSES: never[] = []

const draftOf = ({ title, currency, release_clause, holdback_bp, version }: Contract): Draft => ({
  title,
  currency,
  release_clause,
  holdback_bp,
  clauses: version.clauses,
  terms: version.terms,
})

/** A draft as it is typed, the text that it makes, what is wrong with it, and how it is saved. */
export function useDrafting(newest: Contract, onSaved: () => void) {
  const [contract] = useState(newest) // what is typed stays, and names the version that it began from
  const [{ draft, note, basedOn }, setTyped, kept] = useDraft(`contract:${contract.id}`, () => ({
    draft: draftOf(contract),
    note: '',
    basedOn: contract.version.number,
  }))
  const setDraft = (next: (now: Draft) => Draft) => setTyped((now) => ({ ...now, draft: next(now.draft) }))
  const settled = useDebounced(draft)
  const shown = useQuery({ ...previewQuery(contract.id, settled), placeholderData: keepPreviousData })
  const { data: library } = useQuery(libraryQuery(contract.kind))
  const deed = useContractAction(contract.id)
  const [again, setAgain] = useState<Record<string, string>>({})
  const isOtherCurrency = draft.currency !== contract.currency && /^[A-Z]{3}$/.test(draft.currency)
  const isChanged = !deed.isSuccess && JSON.stringify(draft) !== JSON.stringify(draftOf(contract))
  const problems = shown.data?.problems ?? []

  /** Save what is typed as the next version; whether nothing is left to save. */
  const save = async (amounts = amountsOf(again, draft.currency)): Promise<boolean> => {
    if (!isChanged) return true
    const body = { ...draft, note, based_on_version: basedOn, ...(isOtherCurrency ? { amounts } : {}) }
    const saved = await deed.mutateAsync({ does: 'save', body }).catch(() => null) // said where it is pressed
    if (saved === null) return false
    kept.discard()
    showToast(`Saved as version ${saved.version.number}.`)
    onSaved()
    return true
  }
  return {
    contract,
    draft,
    setDraft,
    note,
    setNote: (next: string) => setTyped((now) => ({ ...now, note: next })),
    kept,
    shown,
    library: library?.clauses ?? NO_CLAUSES,
    problems,
    again,
    setAgain,
    isOtherCurrency,
    isChanged,
    canSave: isChanged && problems.length === 0,
    save,
    saveError: deed.error,
  }
}

export type Drafting = ReturnType<typeof useDrafting>
