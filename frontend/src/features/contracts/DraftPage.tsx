import { Checkbox, NumberInput, Select, Textarea, TextInput } from '@mantine/core'
import { keepPreviousData, useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams } from '@tanstack/react-router'
import { useEffect, useState } from 'react'

import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ProblemNote } from '@/ui/ProblemNote'

import {
  type Clause,
  type Contract,
  contractQuery,
  type Draft,
  type LibraryClause,
  libraryQuery,
  previewQuery,
  useDeed,
} from './api'
import classes from './Contracts.module.css'
import { Refusal } from './Refusal'
import { Text } from './Text'
import { inWords, sentence } from './words'

const SETTLED_MS = 400 // after the last key, the text beside is asked for
const RELEASES = [
  { value: 'per_cue', label: 'With each accepted cue' },
  { value: 'on_completion', label: 'With the last cue of a milestone' },
]

/** The draft of a contract: clauses to strike and edit, and beside them the text that they make. */
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
            detail="This contract is no draft that you may change."
            fix="A producer of the studio changes drafts; what was sent is taken back first."
          />
        )}
        <div>
          <ButtonLink component={Link} to={back}>
            Back to the contract
          </ButtonLink>
        </div>
      </div>
    )
  }
  return <Editor key={contract.version.number} contract={contract} back={back} />
}

const draftOf = ({ title, currency, release_clause, holdback_bp, version }: Contract): Draft => ({
  title,
  currency,
  release_clause,
  holdback_bp,
  clauses: version.clauses,
  terms: version.terms,
})

function useSettled<T>(value: T): T {
  const [settled, setSettled] = useState(value)
  useEffect(() => {
    const waiting = setTimeout(() => setSettled(value), SETTLED_MS)
    return () => clearTimeout(waiting)
  }, [value])
  return settled
}

function Editor({ contract, back }: { contract: Contract; back: string }) {
  const navigate = useNavigate()
  const [draft, setDraft] = useState(() => draftOf(contract))
  const [note, setNote] = useState('')
  const settled = useSettled(draft)
  const shown = useQuery({ ...previewQuery(contract.id, settled), placeholderData: keepPreviousData })
  const { data: library } = useQuery(libraryQuery(contract.kind))
  const save = useDeed(contract.id)
  const isChanged = JSON.stringify(draft) !== JSON.stringify(draftOf(contract))
  const problems = shown.data?.problems ?? []
  const change = (key: string, changes: Partial<Clause>) =>
    setDraft((now) => ({
      ...now,
      clauses: now.clauses.map((clause) => (clause.key === key ? { ...clause, ...changes } : clause)),
    }))
  const keep = () =>
    save.mutate(
      { does: 'save', body: { ...draft, note, based_on_version: contract.version.number } },
      {
        onSuccess: ({ version }) => {
          showToast(`Kept as version ${version.number}.`)
          void navigate({ to: back })
        },
      },
    )
  return (
    <div className="page stack">
      <div className={classes.head}>
        <div>
          <h1>{`Draft: ${contract.title}`}</h1>
          <p className="mid">A start for the lawyers of both parties, and no legal advice.</p>
        </div>
        <div className={classes.buttons}>
          <ButtonLink component={Link} to={back}>
            Back without saving
          </ButtonLink>
          <Button
            variant="primary"
            aria-busy={save.isPending}
            disabled={!isChanged || problems.length > 0}
            onClick={keep}
          >
            Save as a version
          </Button>
        </div>
      </div>
      <Refusal error={save.error} />
      {problems.length > 0 && (
        <ProblemNote
          detail={problems.map(({ message }) => sentence(message)).join(' ')}
          fix="Mend it here; the draft is saved once nothing stands against it."
        />
      )}
      <div className={classes.editor}>
        <div className="stack">
          <Card aria-labelledby="facts">
            <CardHead id="facts" title="How it is paid" />
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
                    label="A cue’s share is due"
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
                    label="Held back until all cues are accepted"
                    value={draft.holdback_bp ?? 0}
                    max={10_000}
                    onChange={(holdback_bp) => setDraft((now) => ({ ...now, holdback_bp }))}
                  />
                </>
              )}
              <TextInput
                label="What this version changes; it may stay empty"
                value={note}
                onChange={({ currentTarget }) => setNote(currentTarget.value)}
              />
            </div>
          </Card>
          <Card aria-labelledby="clauses">
            <CardHead
              id="clauses"
              title="Clauses"
              count={draft.clauses.filter(({ stands }) => stands).length}
              note="that stand"
            />
            {draft.clauses.map((clause) => (
              <ClauseFields
                key={clause.key}
                clause={clause}
                known={library?.clauses.find(({ key }) => key === clause.key)}
                terms={draft.terms}
                currency={draft.currency}
                onChange={(changes) => change(clause.key, changes)}
                onTerm={(name, value) => setDraft((now) => ({ ...now, terms: { ...now.terms, [name]: value } }))}
              />
            ))}
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

/** What a clause leaves open: the terms that its text names, and those that the choice taken there names. */
function termsOf(clause: Clause, known: LibraryClause | undefined, terms: Draft['terms']): string[] {
  const chosen = known?.terms.flatMap(({ name, choices }) => choices.filter(({ value }) => value === terms[name])) ?? []
  const said = [clause.text, ...chosen.map(({ words }) => words)].join(' ')
  return Object.keys(terms).filter((name) => said.includes(`{${name}}`))
}

interface ClauseFieldsProps {
  clause: Clause
  known: LibraryClause | undefined
  terms: Draft['terms']
  currency: string
  onChange: (changes: Partial<Clause>) => void
  onTerm: (name: string, value: number | string) => void
}

function ClauseFields({ clause, known, terms, currency, onChange, onTerm }: ClauseFieldsProps) {
  const [open, setOpen] = useState(false)
  const used = termsOf(clause, known, terms)
  return (
    <div className={classes.clause}>
      <div className={classes.clauseHead}>
        <Checkbox
          label={clause.title}
          description={known?.why}
          checked={clause.stands}
          onChange={({ currentTarget: { checked } }) => onChange({ stands: checked })}
        />
        <Button
          variant="quiet"
          icon="pencil"
          aria-expanded={open}
          aria-label={`Edit ${clause.title}`}
          onClick={() => setOpen(!open)}
        >
          Edit
        </Button>
      </div>
      {clause.stands && used.length > 0 && (
        <div className={classes.terms}>
          {used.map((name) => (
            <TermField
              key={name}
              name={name}
              known={known?.terms.find((term) => term.name === name)}
              value={terms[name] ?? ''}
              currency={currency}
              onChange={(value) => onTerm(name, value)}
            />
          ))}
        </div>
      )}
      {open && (
        <div className={classes.inner}>
          <TextInput
            label="Title of the clause"
            value={clause.title}
            maxLength={120}
            onChange={({ currentTarget: { value } }) => onChange({ title: value })}
          />
          <Textarea
            label="Text"
            description="Words in braces are filled in: {studio}, {designer}, {milestones}. **Bold**, *italic*, “- ” for a list."
            autosize
            minRows={4}
            value={clause.text}
            onChange={({ currentTarget: { value } }) => onChange({ text: value })}
          />
        </div>
      )}
    </div>
  )
}

interface TermFieldProps {
  name: string
  known: LibraryClause['terms'][number] | undefined
  value: number | string
  currency: string
  onChange: (value: number | string) => void
}

function TermField({ name, known, value, currency, onChange }: TermFieldProps) {
  const label = known?.label ?? inWords(name)
  const choices = known?.choices ?? []
  if (choices.length > 0) {
    return (
      <Select
        label={label}
        data={choices.map((choice) => ({ value: String(choice.value), label: choice.label }))}
        value={String(value)}
        allowDeselect={false}
        onChange={(taken) => onChange(choices.find((choice) => String(choice.value) === taken)?.value ?? value)}
      />
    )
  }
  if (typeof value === 'string') {
    return <TextInput label={label} value={value} onChange={({ currentTarget }) => onChange(currentTarget.value)} />
  }
  if (name.endsWith('_bp')) return <Percent label={label} value={value} onChange={onChange} />
  if (name.endsWith('_minor')) {
    const digits =
      new Intl.NumberFormat('en', {
        style: 'currency',
        currency: isCurrency(currency) ? currency : 'USD',
      }).resolvedOptions().maximumFractionDigits ?? 2
    const scale = 10 ** digits
    return (
      <NumberInput
        label={`${label}, ${currency}`}
        value={value / scale}
        min={0}
        decimalScale={digits}
        onChange={(given) => onChange(Math.round(Number(given) * scale))}
      />
    )
  }
  return (
    <NumberInput
      label={label}
      value={value}
      min={0}
      allowDecimal={false}
      onChange={(given) => onChange(Math.round(Number(given)))}
    />
  )
}

const isCurrency = (code: string): boolean => /^[A-Z]{3}$/.test(code)

interface PercentProps {
  label: string
  value: number
  max?: number
  onChange: (basisPoints: number) => void
}

function Percent({ label, value, max, onChange }: PercentProps) {
  return (
    <NumberInput
      label={label}
      suffix=" %"
      value={value / 100}
      min={0}
      max={max === undefined ? undefined : max / 100}
      decimalScale={2}
      onChange={(given) => onChange(Math.round(Number.parseFloat(String(given) || '0') * 100))}
    />
  )
}
