import { useRef, useState } from 'react'

import { useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import { Card, CardHead } from '@/ui/Card'
import { day, plural } from '@/ui/format'
import { KeysLine } from '@/ui/KeysLine'
import { Segmented } from '@/ui/Segmented'
import { StatusBadge } from '@/ui/StatusBadge'

import type { Contract } from './api'
import classes from './Contracts.module.css'
import { MarkedLine } from './MarkedLine'
import { type Opened, RedlineNote } from './RedlineNote'
import { type Answer, type Redline, type Round, useAnswerRedline } from './redlines'
import styles from './Redlines.module.css'
import { SendVersion } from './SendVersion'

interface RedlineRoundProps {
  contract: Contract
  round: Round
  mayAnswer: boolean
  /** The contract’s page. */
  back: string
}

const KEYS = [
  { keys: ['n', 'p'], label: 'next, previous change' },
  { keys: ['y'], label: 'accept' },
  { keys: ['s'], label: 'keep as it was' },
  { keys: ['e'], label: 'counter-propose' },
]

/** One round of redlines in the text that it is about: marks, comments and answers. */
export function RedlineRound({ contract, round, mayAnswer, back }: RedlineRoundProps) {
  const [shows, setShows] = useState<'changes' | 'text'>(round.sent_version === null ? 'text' : 'changes')
  const [opened, setOpened] = useState<Opened | null>(null)
  const articles = useRef(new Map<number, HTMLElement>())
  const answer = useAnswerRedline(contract.id)
  const redlines = round.clauses.flatMap(({ redline }) => redline ?? [])
  const focused = (): Redline | undefined =>
    redlines.find(({ number }) => articles.current.get(number)?.contains(document.activeElement))
  const focusOn = (redline: Redline | undefined) => redline && articles.current.get(redline.number)?.focus()
  const step = (by: 1 | -1) => {
    const at = redlines.findIndex((one) => one === focused())
    focusOn(redlines[at < 0 ? (by > 0 ? 0 : redlines.length - 1) : at + by])
  }
  const give = (redline: Redline, body: Answer, onDone?: () => void) => {
    if (answer.isPending) return
    answer.mutate(
      { number: redline.number, body },
      {
        onSuccess: ({ round: now }) => {
          onDone?.()
          setOpened(null)
          const left = now?.unanswered ?? 0
          showToast(left === 0 ? 'Every change is answered.' : `${plural(left, 'change')} without an answer.`)
          const open = now?.clauses.flatMap(({ redline: one }) => (one && one.answer === null ? one : []))[0]
          requestAnimationFrame(() => focusOn(open ?? redline))
        },
      },
    )
  }
  const act = (run: (redline: Redline) => void) => () => {
    const redline = focused() ?? redlines.find((each) => each.answer === null)
    if (redline && mayAnswer) run(redline)
  }
  useHotkeys([
    { keys: 'n', label: 'Next change', group: 'Redlines', run: () => step(1) },
    { keys: 'p', label: 'Previous change', group: 'Redlines', run: () => step(-1) },
    {
      keys: 'y',
      label: 'Accept the change',
      group: 'Redlines',
      disabled: !mayAnswer,
      run: act((redline) => give(redline, { answer: 'accepted' })),
    },
    {
      keys: 's',
      label: 'Refuse the change',
      group: 'Redlines',
      disabled: !mayAnswer,
      run: act(({ number }) => setOpened({ number, does: 'refused' })),
    },
    {
      keys: 'e',
      label: 'Counter the change',
      group: 'Redlines',
      disabled: !mayAnswer,
      run: act(({ number }) => setOpened({ number, does: 'countered' })),
    },
  ])
  const clauses = shows === 'text' ? round.clauses : round.clauses.filter(({ redline }) => redline !== null)
  return (
    <>
      {mayAnswer && <NextStep contract={contract} round={round} back={back} />}
      <Card aria-labelledby="round">
        <CardHead
          id="round"
          title={`Round ${round.number}`}
          note={`${plural(redlines.length, 'change')} to version ${round.version} by ${round.by}, ${day(round.at)}`}
          end={<RoundState round={round} />}
        />
        {round.note !== '' && <blockquote className={`m-0 p-3-4 ${classes.asked}`}>{round.note}</blockquote>}
        <div className={`${classes.form} items-center flex wrap gap-2-4`}>
          <Segmented
            label="Show"
            options={[
              { value: 'text', label: 'Whole text' },
              { value: 'changes', label: 'Changes only' },
            ]}
            value={shows}
            onChange={setShows}
          />
          <KeysLine keys={mayAnswer ? KEYS : KEYS.slice(0, 1)} />
        </div>
        <div className="grid grid-cols-1 border-t">
          {clauses.map(({ key, number, lines, counter_lines: counter, redline }) => {
            const text = (
              <div className={`wrap-anywhere ${classes.text}`}>
                {number !== null && <span className={`mono dim ${styles.number}`}>{number}</span>}
                {lines.map((line, index) => (
                  <MarkedLine key={index} line={line} />
                ))}
                {counter.length > 0 && (
                  <div className={styles.counter}>
                    <p className="small mid">Counter of the studio</p>
                    {counter.map((line, index) => (
                      <MarkedLine key={index} line={line} head="h4" />
                    ))}
                  </div>
                )}
              </div>
            )
            if (redline === null) {
              return (
                <div key={key} className={`grid grid-cols-1 gap-2 relative ${styles.clause}`}>
                  {text}
                </div>
              )
            }
            return (
              <article
                key={key}
                ref={(element) => {
                  if (element) articles.current.set(redline.number, element)
                  else articles.current.delete(redline.number)
                }}
                className={`grid grid-cols-1 gap-2 relative ${styles.clause} bg-raised ${styles.redline}`}
                aria-label={`Change ${redline.number}`}
                tabIndex={-1}
              >
                {text}
                <RedlineNote
                  contract={contract}
                  by={round.by}
                  redline={redline}
                  mayAnswer={mayAnswer}
                  opened={opened?.number === redline.number ? opened : null}
                  onOpen={setOpened}
                  isPending={answer.isPending && answer.variables.number === redline.number}
                  error={answer.variables?.number === redline.number ? answer.error : null}
                  onAnswer={(body, onDone) => give(redline, body, onDone)}
                />
              </article>
            )
          })}
        </div>
      </Card>
    </>
  )
}

function RoundState({ round }: { round: Round }) {
  if (round.sent_version !== null)
    return <StatusBadge kind="accepted">{`Version ${round.sent_version} was sent`}</StatusBadge>
  if (round.unanswered === 0) return <StatusBadge kind="to_review">All answered</StatusBadge>
  return <StatusBadge kind="change_requested">{`${round.unanswered} without an answer`}</StatusBadge>
}

function NextStep({ contract, round, back }: { contract: Contract; round: Round; back: string }) {
  return (
    <Card aria-labelledby="next">
      <CardHead id="next" title="Next step" />
      <div className={classes.form}>
        {round.unanswered > 0 ? (
          <p>{`Accept, refuse or counter ${plural(round.unanswered, 'change')}. Then the next version can be sent.`}</p>
        ) : (
          <>
            <p>{`Every change is answered. ${contract.designer.name} receives the next version with your answers.`}</p>
            <SendVersion contract={contract} back={back} />
          </>
        )}
      </div>
    </Card>
  )
}
