import { Textarea } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { Fragment } from 'react'

import { DraftForm } from '@/app/drafts/DraftForm'
import { Button } from '@/ui/Button'
import { Field, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { day } from '@/ui/format'
import { StatusBadge, type StateKind } from '@/ui/StatusBadge'
import { useFocusOnMount } from '@/ui/useFocusOnMount'

import { type Contract, libraryQuery } from './api'
import classes from './Contracts.module.css'
import type { Answer, Redline } from './redlines'
import styles from './Redlines.module.css'
import { figureInWords, inWords } from './words'
import { WordingFields } from './WordingFields'

/** The form that is open under a change. */
export interface Opened {
  number: number
  does: 'refused' | 'countered'
}

type SendAnswer = (body: Answer, onDone?: () => void) => void

interface RedlineNoteProps {
  contract: Contract
  /** Who proposed it. */
  by: string
  redline: Redline
  mayAnswer: boolean
  opened: Opened | null
  onOpen: (opened: Opened | null) => void
  isPending: boolean
  error: unknown
  onAnswer: SendAnswer
}

const DOES: Record<Redline['kind'], string> = {
  replace: 'changes this clause',
  strike: 'strikes this clause',
  insert: 'adds this clause',
}
const ANSWERS: Record<NonNullable<Redline['answer']>['kind'], { kind: StateKind; word: string }> = {
  accepted: { kind: 'accepted', word: 'Accepted' },
  refused: { kind: 'refused', word: 'Refused' },
  countered: { kind: 'change_requested', word: 'Countered' },
}

/** Whose change it is, what they say of it, what the studio answered, and the answers to choose from. */
export function RedlineNote(props: RedlineNoteProps) {
  const { contract, by, redline, mayAnswer, opened, onOpen, isPending, error, onAnswer } = props
  const { number, answer } = redline
  return (
    <div className={`grid grid-cols-1 gap-2 ${styles.note}`}>
      <p>
        <strong>{`Change ${number}`}</strong> <span className="mid">{`${by} ${DOES[redline.kind]}.`}</span>
      </p>
      <ChangedFigures contract={contract} redline={redline} />
      {redline.comment !== '' && <p className={`pre-wrap wrap-anywhere ${styles.said}`}>{redline.comment}</p>}
      {answer ? (
        <>
          <p>
            <StatusBadge kind={ANSWERS[answer.kind].kind}>{ANSWERS[answer.kind].word}</StatusBadge>{' '}
            <span className="small mid">{`by ${answer.by}, ${day(answer.at)}`}</span>
          </p>
          {answer.comment !== '' && <p className={`pre-wrap wrap-anywhere ${styles.said}`}>{answer.comment}</p>}
        </>
      ) : (
        <StatusBadge kind="waiting">Waiting for the studio’s answer</StatusBadge>
      )}
      {mayAnswer && (
        <div className={classes.buttons}>
          <Button
            icon="tick"
            keys="y"
            aria-label={`Accept change ${number}`}
            aria-busy={isPending}
            onClick={() => onAnswer({ answer: 'accepted' })}
          >
            Accept
          </Button>
          <Button
            icon="cross"
            keys="s"
            aria-label={`Keep as it was, change ${number}`}
            aria-expanded={opened?.does === 'refused'}
            onClick={() => onOpen({ number, does: 'refused' })}
          >
            Keep as it was
          </Button>
          <Button
            icon="pencil"
            keys="e"
            aria-label={`Counter-propose to change ${number}`}
            aria-expanded={opened?.does === 'countered'}
            onClick={() => onOpen({ number, does: 'countered' })}
          >
            Counter-propose
          </Button>
        </div>
      )}
      {mayAnswer && opened?.does === 'refused' && <Refuse {...props} />}
      {mayAnswer && opened?.does === 'countered' && <Counter {...props} />}
      <Refusal error={error} />
    </div>
  )
}

/** The figures that a change sets, as they are and as they would be. */
function ChangedFigures({ contract, redline }: { contract: Contract; redline: Redline }) {
  const { data: library } = useQuery(libraryQuery(contract.kind))
  const terms = library?.clauses.flatMap((clause) => clause.terms) ?? []
  const figures = Object.entries(redline.wording.terms).filter(
    ([name, value]) => contract.version.terms[name] !== undefined && contract.version.terms[name] !== value,
  )
  if (figures.length === 0) return null
  const shown = (name: string, value: number | string) =>
    figureInWords(name, value, contract.currency, terms.find((term) => term.name === name)?.choices)
  return (
    <dl className={`grid gap-2px-4 ${classes.ba}`}>
      {figures.map(([name, value]) => (
        <Fragment key={name}>
          <dt>{terms.find((term) => term.name === name)?.label ?? inWords(name)}</dt>
          <dd>
            <s>{shown(name, contract.version.terms[name] ?? '')}</s> → <strong>{shown(name, value)}</strong>
          </dd>
        </Fragment>
      ))}
    </dl>
  )
}

function Refuse({ contract, redline: { number }, isPending, onOpen, onAnswer }: RedlineNoteProps) {
  const field = useFocusOnMount<HTMLTextAreaElement>()
  return (
    <DraftForm
      className={classes.inner}
      aria-label={`Refuse change ${number}`}
      draftKey={`redline-refusal:${contract.id}:${number}`}
      initialValues={{ comment: '' }}
      mutation={{ isPending, error: null }}
      onSubmit={({ comment }, onSent) => onAnswer({ answer: 'refused', comment: comment.trim() }, onSent)}
    >
      <Field
        as={Textarea}
        ref={field}
        name="comment"
        label="Why it is refused"
        rows={2}
        resize="vertical"
        maxLength={5000}
      />
      <Send onOpen={onOpen}>Refuse the change</Send>
    </DraftForm>
  )
}

function Counter({ contract, redline, isPending, onOpen, onAnswer }: RedlineNoteProps) {
  const clause = contract.version.clauses.find(({ key }) => key === redline.clause_key)
  const wording =
    redline.answer?.wording ??
    (redline.kind === 'strike' ? { title: clause?.title ?? '', text: clause?.text ?? '', terms: {} } : redline.wording)
  return (
    <DraftForm
      className={classes.inner}
      aria-label={`Counter change ${redline.number}`}
      draftKey={`redline-counter:${contract.id}:${redline.number}`}
      initialValues={{ wording, comment: '' }}
      mutation={{ isPending, error: null }}
      onSubmit={(typed, onSent) =>
        onAnswer({ answer: 'countered', ...typed.wording, comment: typed.comment.trim() }, onSent)
      }
    >
      {(typed, change) => (
        <>
          <WordingFields
            contract={contract}
            clauseKey={redline.clause_key}
            wording={typed.wording}
            takesFocus
            onChange={(changes) => change({ wording: { ...typed.wording, ...changes } })}
          />
          <Field
            as={Textarea}
            optional
            name="comment"
            label="Comment (optional)"
            rows={2}
            resize="vertical"
            maxLength={5000}
          />
          <Send onOpen={onOpen}>Send the counter</Send>
        </>
      )}
    </DraftForm>
  )
}

function Send({ onOpen, children }: { onOpen: (opened: null) => void; children: string }) {
  const close = (
    <Button variant="quiet" onClick={() => onOpen(null)}>
      Close
    </Button>
  )
  return (
    <Submit className={classes.buttons} beside={close}>
      {children}
    </Submit>
  )
}
