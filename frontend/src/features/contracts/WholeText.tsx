import { Select, TextInput } from '@mantine/core'
import { useState } from 'react'

import { showToast } from '@/app/toast'
import { Card, CardHead } from '@/ui/Card'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { Refusal } from '@/ui/Refusal'
import { sentence } from '@/ui/sentence'

import { AddClause } from './AddClause'
import { AmountsAgain } from './AmountsAgain'
import type { Clause } from './api'
import { ClauseFields, Percent } from './ClauseFields'
import { moveButtonId, movedClause, withClauseBack, withoutClause } from './clauses'
import classes from './Contracts.module.css'
import { Text } from './Text'
import type { Drafting } from './useDrafting'

const RELEASES = [
  { value: 'per_cue', label: 'When each cue is accepted' },
  { value: 'on_completion', label: 'When a milestone’s last cue is accepted' },
]

/** Every clause of a draft to strike, edit, move and add to, next to the text that they make. */
export function WholeText({ drafting }: { drafting: Drafting }) {
  const { contract, draft, setDraft, note, setNote, shown, library, problems, again, setAgain, isOtherCurrency } =
    drafting
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
  return (
    <>
      {problems.length > 0 && (
        <ErrorBanner
          detail={problems.map(({ message }) => sentence(message)).join(' ')}
          fix="Fix this to save the draft."
        />
      )}
      <div className={`grid items-start gap-4 mid-grid-cols-1 ${classes.editor}`}>
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
                known={library.find(({ key }) => key === clause.key)}
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
            <AddClause library={library} draft={draft} onAdd={(next) => setDraft(() => next)} />
          </Card>
        </div>
        <Card aria-label="The text" className={`${classes.sheet} ${classes.live}`} aria-busy={shown.isFetching}>
          <Refusal error={shown.error} />
          {shown.data ? <Text blocks={shown.data.blocks} /> : <Text blocks={contract.version.blocks} />}
        </Card>
      </div>
    </>
  )
}
