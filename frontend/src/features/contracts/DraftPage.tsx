import { Select, TextInput } from '@mantine/core'
import { keepPreviousData, useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams } from '@tanstack/react-router'
import { useState } from 'react'

import { contractQuery } from '@/api/project'
import { DraftNote, useDraft } from '@/app/drafts'
import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ProblemNote } from '@/ui/ProblemNote'
import { Refusal } from '@/ui/Refusal'
import { useDebounced } from '@/ui/useDebounced'

import { AddClause } from './AddClause'
import { AmountsAgain, amountsOf } from './AmountsAgain'
import { previewQuery, type Clause, type Contract, type Draft, libraryQuery, useDeed } from './api'
import { ClauseFields, Percent } from './ClauseFields'
import { moveButtonId, movedClause, withClauseBack, withoutClause } from './clauses'
import classes from './Contracts.module.css'
import { Text } from './Text'
import { sentence } from './words'

const RELEASES = [
  { value: 'per_cue', label: 'When each cue is accepted' },
  { value: 'on_completion', label: 'When a milestone’s last cue is accepted' },
]

/** The draft of a contract: clauses to strike and edit, next to the text that they make. */
export function DraftPage() {
  const { projectId, contractId } = useParams({ from: '/shell/projects/$projectId/contracts/$contractId/draft' })
  const { data: contract, error } = useQuery(contractQuery(contractId))
  useTitle(contract ? `Draft: ${contract.title}` : 'Draft')
  const back = `/projects/${projectId}/contracts/${contractId}`
  if (!contract || !contract.may.change) {
    return (
      <div className="page stack" aria-busy={!contract && error === null}>
        <h1>{contract?.title ?? 'Draft'}</h1>
        <Refusal error={error} />
        {contract && (
          <ProblemNote
            detail="You can’t edit this contract."
            fix="Only the studio’s producers edit drafts. Recall a sent contract before editing it."
          />
        )}
        <div>
          <ButtonLink component={Link} to={back}>
            Back to contract
          </ButtonLink>
        </div>
      </div>
    )
  }
  return <Editor key={contractId} contract={contract} back={back} />
}

const draftOf = ({ title, currency, release_clause, holdback_bp, version }: Contract): Draft => ({
  title,
  currency,
  release_clause,
  holdback_bp,
  clauses: version.clauses,
  terms: version.terms,
})

function Editor({ contract: newest, back }: { contract: Contract; back: string }) {
  const [contract] = useState(newest) // what is typed stays, and names the version that it began from
  const navigate = useNavigate()
  const [{ draft, note, basedOn }, setTyped, kept] = useDraft(`contract:${contract.id}`, () => ({
    draft: draftOf(contract),
    note: '',
    basedOn: contract.version.number,
  }))
  const setDraft = (next: (now: Draft) => Draft) => setTyped((now) => ({ ...now, draft: next(now.draft) }))
  const setNote = (next: string) => setTyped((now) => ({ ...now, note: next }))
  const settled = useDebounced(draft)
  const shown = useQuery({ ...previewQuery(contract.id, settled), placeholderData: keepPreviousData })
  const { data: library } = useQuery(libraryQuery(contract.kind))
  const save = useDeed(contract.id)
  const isChanged = !save.isSuccess && JSON.stringify(draft) !== JSON.stringify(draftOf(contract))
  const problems = shown.data?.problems ?? []
  const [again, setAgain] = useState<Record<string, string>>({})
  const isOtherCurrency = draft.currency !== contract.currency && /^[A-Z]{3}$/.test(draft.currency)
  const change = (key: string, changes: Partial<Clause>) =>
    setDraft((now) => ({
      ...now,
      clauses: now.clauses.map((clause) => (clause.key === key ? { ...clause, ...changes } : clause)),
    }))
  const standing = draft.clauses.filter(({ stands }) => stands).length
  const [placed, setPlaced] = useState('')
  const move = (clause: Clause, by: -1 | 1) => {
    const changed = movedClause(draft, clause.key, by)
    const place = changed.clauses.findIndex(({ key }) => key === clause.key) + 1
    setDraft(() => changed)
    setPlaced(`${clause.title} is clause ${place} of ${changed.clauses.length}.`)
    // The browser lets go of a button that moves, or that is at the end of its way.
    requestAnimationFrame(() => {
      const isAtEnd = place === (by < 0 ? 1 : changed.clauses.length)
      document.getElementById(moveButtonId(clause.key, isAtEnd ? (by < 0 ? 1 : -1) : by))?.focus()
    })
  }
  const remove = (clause: Clause) => {
    const place = draft.clauses.findIndex(({ key }) => key === clause.key)
    setDraft((now) => withoutClause(now, clause.key))
    showToast(`${clause.title} removed.`, () => setDraft((now) => withClauseBack(now, clause, place)))
  }
  const keep = () =>
    save.mutate(
      {
        does: 'save',
        body: {
          ...draft,
          note,
          based_on_version: basedOn,
          ...(isOtherCurrency ? { amounts: amountsOf(again, draft.currency) } : {}),
        },
      },
      {
        onSuccess: ({ version }) => {
          kept.discard()
          showToast(`Saved as version ${version.number}.`)
          void navigate({ to: back })
        },
      },
    )
  return (
    <div className="page stack">
      <div className={classes.head}>
        <div>
          <h1>{`Draft: ${contract.title}`}</h1>
          <p className="mid">A starting point for both parties’ lawyers, not legal advice.</p>
        </div>
        <div className={classes.buttons}>
          <ButtonLink component={Link} to={back} onClick={isChanged ? kept.discard : undefined}>
            {isChanged ? 'Discard changes' : 'Back to contract'}
          </ButtonLink>
          <Button
            variant="primary"
            aria-busy={save.isPending}
            disabled={!isChanged || problems.length > 0}
            onClick={keep}
          >
            Save version
          </Button>
        </div>
      </div>
      <DraftNote draft={kept} />
      <Refusal error={save.error} />
      {problems.length > 0 && (
        <ProblemNote
          detail={problems.map(({ message }) => sentence(message)).join(' ')}
          fix="Fix this to save the draft."
        />
      )}
      <div className={classes.editor}>
        <div className="stack">
          <Card aria-labelledby="facts">
            <CardHead id="facts" title="Payment terms" />
            <div className={classes.form}>
              <TextInput
                label="Title"
                value={draft.title}
                maxLength={120}
                onChange={({ currentTarget: { value } }) => setDraft((now) => ({ ...now, title: value }))}
              />
              <TextInput
                label="Currency"
                value={draft.currency}
                maxLength={3}
                onChange={({ currentTarget: { value } }) =>
                  setDraft((now) => ({ ...now, currency: value.toUpperCase() }))
                }
              />
              {contract.kind !== 'nda' && (
                <>
                  <Select
                    label="Payment is due"
                    data={RELEASES}
                    value={draft.release_clause}
                    allowDeselect={false}
                    onChange={(value) =>
                      setDraft((now) => ({
                        ...now,
                        release_clause: value === 'on_completion' ? 'on_completion' : 'per_cue',
                      }))
                    }
                  />
                  <Percent
                    label="Retention until all cues are accepted"
                    value={draft.holdback_bp ?? 0}
                    max={10_000}
                    onChange={(holdback_bp) => setDraft((now) => ({ ...now, holdback_bp }))}
                  />
                </>
              )}
              <TextInput
                label="Version note (optional)"
                value={note}
                onChange={({ currentTarget }) => setNote(currentTarget.value)}
              />
            </div>
          </Card>
          {isOtherCurrency && contract.kind !== 'nda' && contract.kind !== 'framework' && (
            <AmountsAgain
              contractId={contract.id}
              before={contract.currency}
              draft={draft}
              typed={again}
              onChange={setAgain}
            />
          )}
          <Card aria-labelledby="clauses">
            <CardHead
              id="clauses"
              title="Clauses"
              count={standing}
              note={standing === 1 ? 'that stands' : 'that stand'}
            />
            <p role="status" className="visually-hidden">
              {placed}
            </p>
            {draft.clauses.map((clause, at) => (
              <ClauseFields
                key={clause.key}
                clause={clause}
                known={library?.clauses.find(({ key }) => key === clause.key)}
                terms={draft.terms}
                currency={draft.currency}
                place={at + 1}
                places={draft.clauses.length}
                onMove={(by) => move(clause, by)}
                onRemove={() => remove(clause)}
                onChange={(changes) => change(clause.key, changes)}
                onTerm={(name, value) => setDraft((now) => ({ ...now, terms: { ...now.terms, [name]: value } }))}
              />
            ))}
            <AddClause library={library?.clauses ?? []} draft={draft} onAdd={(next) => setDraft(() => next)} />
          </Card>
        </div>
        <Card aria-label="The text" className={`${classes.sheet} ${classes.live}`} aria-busy={shown.isFetching}>
          <Refusal error={shown.error} />
          {shown.data ? <Text blocks={shown.data.blocks} /> : <Text blocks={contract.version.blocks} />}
        </Card>
      </div>
    </div>
  )
}
