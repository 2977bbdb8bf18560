import { Link } from '@tanstack/react-router'
import { type ReactNode, useState } from 'react'

import { Button } from '@/ui/Button'
import { Icon } from '@/ui/Icon'
import { Refusal } from '@/ui/Refusal'
import { Skeleton } from '@/ui/Skeleton'

import type { Version } from './api'
import { withStanding } from './clauses'
import classes from './Draft.module.css'
import { FigureField } from './FigureField'
import { ANSWERED_BY, isChanged, type Question } from './questions'
import { Figures, Text } from './Text'
import type { Drafting } from './useDrafting'

interface DraftTextProps {
  drafting: Drafting
  /** The text that the draft was begun with: what differs from it somebody changed. */
  begun: Version
  current: Question | null
  /** Figures of the plan that are typed and not saved yet. */
  figures: Readonly<Record<string, string>>
  onPlan: () => void
}

/** The text that the answers make: their clauses and those that somebody changed; the usual ones are folded. */
export function DraftText({ drafting, begun, current, figures, onPlan }: DraftTextProps) {
  const { contract, draft, setDraft, shown, library } = drafting
  const [isUsualOpen, setUsualOpen] = useState(false)
  const [isAdding, setAdding] = useState(false)
  const preview = shown.data
  const terms = library.flatMap((clause) => clause.terms)
  const figure = (name: string, text: string): ReactNode => {
    const value = draft.terms[name]
    if (value === undefined) {
      return (
        <button type="button" className={classes.figure} onClick={onPlan}>
          {figures[name] ?? text}
        </button>
      )
    }
    return (
      <FigureField
        name={name}
        text={text}
        value={value}
        known={terms.find((term) => term.name === name)}
        currency={draft.currency}
        onChange={(next) => setDraft((now) => ({ ...now, terms: { ...now.terms, [name]: next } }))}
      />
    )
  }
  const answering = Object.values(ANSWERED_BY).flat()
  const isOpen = (key: string) => {
    const clause = draft.clauses.find((each) => each.key === key)
    const known = library.find((each) => each.key === key)
    return answering.includes(key) || (clause !== undefined && isChanged(clause, begun, draft, known))
  }
  const usual = (preview?.clauses ?? []).filter(({ key }) => !isOpen(key))
  const left = [
    ...draft.clauses.filter(({ stands }) => !stands),
    ...library.filter(({ key }) => draft.clauses.every((clause) => clause.key !== key)),
  ]
  const clauseOf = ({ key, number, title, first_block: first, block_count: count }: (typeof usual)[number]) => (
    <section
      key={key}
      className={`grid gap-0-2 rounded-s ${classes.clause}`}
      data-current={(current !== null && ANSWERED_BY[current].includes(key)) || undefined}
      aria-label={title}
    >
      <span className={`mono dim ${classes.clauseNumber}`}>{number}</span>
      <div>
        <h3>{title}</h3>
        <Text blocks={preview?.blocks.slice(first, first + count) ?? []} folds={12} />
      </div>
    </section>
  )
  return (
    <section className={`min-w-0 ${classes.text}`} aria-label="The text" aria-busy={shown.isFetching}>
      <h2>{draft.title}</h2>
      <Refusal error={shown.error} />
      {!preview && !shown.error && <Skeleton rows={14} />}
      {preview && (
        <Figures value={figure}>
          {preview.clauses.filter(({ key }) => isOpen(key)).map(clauseOf)}
          <button
            type="button"
            className={`row hover mt-2 nowrap pointer w-full border rounded ${classes.usual}`}
            aria-expanded={isUsualOpen}
            onClick={() => setUsualOpen(!isUsualOpen)}
          >
            <Icon name={isUsualOpen ? 'chevron' : 'right'} />
            <span className="strong">{`${usual.length} usual ${usual.length === 1 ? 'clause' : 'clauses'}`}</span>
            <span className="small mid overflow-hidden text-ellipsis">
              {usual.map(({ title }) => title).join(', ')}
            </span>
          </button>
          {isUsualOpen && usual.map(clauseOf)}
        </Figures>
      )}
      <button
        type="button"
        className={`row hover mt-2 nowrap pointer w-full border rounded ${classes.usual}`}
        aria-expanded={isAdding}
        onClick={() => setAdding(!isAdding)}
      >
        <Icon name="plus" />
        <span>Add a clause</span>
        <span className="small mid overflow-hidden text-ellipsis">
          {`${left.length} more to choose from: ${left.map(({ title }) => title).join(', ')}`}
        </span>
      </button>
      {isAdding && (
        <ul className={` ${classes.left}`}>
          {left.map(({ key, title }) => (
            <li key={key}>
              <span className="grow">
                {title}
                <span className="small mid">{library.find((each) => each.key === key)?.why}</span>
              </span>
              <Button
                aria-label={`Add ${title}`}
                onClick={() => setDraft((now) => withStanding(now, library, key, true))}
              >
                Add
              </Button>
            </li>
          ))}
          <li>
            <span className="grow">A clause of your own, or other words for one of these</span>
            <Link
              className="link"
              to="/projects/$projectId/contracts/$contractId/draft"
              params={{ projectId: contract.project_id, contractId: contract.id }}
              search={{ view: 'text' }}
            >
              Whole text
            </Link>
          </li>
        </ul>
      )}
      <p className="small mid">
        A boxed figure is one value: here, in the plan, in the invoices. Type over it anywhere.
      </p>
    </section>
  )
}
