import { Textarea, TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { DraftNote, useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { Skeleton } from '@/ui/Skeleton'
import { plural } from '@/ui/format'
import { useDebounced } from '@/ui/useDebounced'
import { sentence } from '@/ui/sentence'

import type { Contract } from './api'
import classes from './Contracts.module.css'
import { MarkedLine } from './MarkedLine'
import {
  begunDraft,
  nextNewId,
  proposedOf,
  type RedlineDraft,
  withChanged,
  withEdit,
  withInsert,
  withoutChange,
  withStrike,
  type Written,
} from './redlineDraft'
import { type Marked, redlinePreviewQuery, useProposeRedlines } from './redlines'
import styles from './Redlines.module.css'
import { Warning } from './Warning'
import { WordingFields } from './WordingFields'
import { WordUpload } from './WordUpload'

const undoId = (key: string) => `undo-${key}`
const editId = (key: string) => `edit-${key}`
const addId = (key: string) => `add-after-${key}`
/** The browser lets go of a button that is replaced. */
const focusOn = (id: string) => requestAnimationFrame(() => document.getElementById(id)?.focus())

/** The text that was sent, clause by clause, for its designer to edit, strike and add to; all changes are sent together. */
export function ProposeRedlines({ contract }: { contract: Contract }) {
  const propose = useProposeRedlines(contract.id)
  const version = contract.version.number
  const [draft, setDraft, kept] = useDraft(`redlines:${contract.id}`, () => begunDraft(version))
  const [opened, setOpened] = useState<string | null>(null)
  const settled = useDebounced(draft.changes)
  const shown = useQuery(redlinePreviewQuery(contract.id, version, proposedOf(settled)))
  const problems = shown.data?.problems ?? []
  const count = draft.changes.length
  const open = (id: string, next: (now: RedlineDraft) => RedlineDraft) => {
    setOpened(id)
    setDraft(next)
  }
  const drop = (id: string, focusedNext: string) => {
    setDraft((now) => withoutChange(now, id))
    focusOn(focusedNext)
  }
  const send = () => {
    if (propose.isPending || count === 0) return
    propose.mutate(
      { version, changes: proposedOf(draft.changes), note: draft.note },
      {
        onSuccess: () => {
          kept.discard()
          showToast(`${plural(count, 'change')} sent to ${contract.studio_name}.`)
        },
      },
    )
  }
  const added = (after: string | null, title: string) =>
    draft.changes
      .filter(({ kind, after_key }) => kind === 'insert' && (after_key ?? null) === after)
      .map((change) => {
        const place = after === null ? 'New clause before all others' : `New clause after ${title}`
        return (
          <section
            key={change.id}
            className={`grid grid-cols-1 gap-2 relative ${styles.clause}`}
            aria-label={change.title === '' ? place : `New clause: ${change.title}`}
          >
            <h3>{place}</h3>
            <Editor
              contract={contract}
              draft={draft}
              change={change}
              problems={problems}
              opened={opened}
              onDraft={setDraft}
            />
            <div>
              <Button
                variant="quiet"
                icon="cross"
                onClick={() => drop(change.id, addId(after ?? contract.version.clauses[0]?.key ?? ''))}
              >
                Remove this clause
              </Button>
            </div>
          </section>
        )
      })
  const head = <CardHead id="propose" title="Propose changes" note={`to version ${version}`} />
  // The text comes with the first preview: what is pressed below it must not move away.
  if (shown.isPending)
    return (
      <Card aria-labelledby="propose">
        {head}
        <Skeleton rows={24} />
      </Card>
    )
  return (
    <Card aria-labelledby="propose">
      {head}
      <div className={classes.form}>
        <p className="mid">Edit or strike clauses and add your own. The studio answers each change.</p>
        <DraftNote draft={kept} />
        {count > 0 && draft.version !== version && (
          <Warning>{`Version ${version} was sent after you began. Your changes are shown against it.`}</Warning>
        )}
        <Refusal error={shown.error} />
        <WordUpload contract={contract} draft={draft} onDraft={setDraft} />
      </div>
      <div className="grid grid-cols-1 border-t" aria-busy={shown.isFetching}>
        {added(null, '')}
        {contract.version.clauses.map((clause) => {
          const change = draft.changes.find(({ id }) => id === clause.key)
          return (
            <div key={clause.key}>
              <section className={`grid grid-cols-1 gap-2 relative ${styles.clause}`} aria-label={clause.title}>
                <Lines marked={shown.data?.clauses.find(({ key }) => key === clause.key)} title={clause.title} />
                <div className={classes.buttons}>
                  {change ? (
                    <Button
                      id={undoId(clause.key)}
                      variant="quiet"
                      icon="back"
                      onClick={() => drop(clause.key, editId(clause.key))}
                    >
                      {`Undo the change of ${clause.title}`}
                    </Button>
                  ) : (
                    <>
                      <Button
                        id={editId(clause.key)}
                        variant="quiet"
                        icon="pencil"
                        aria-label={`Edit ${clause.title}`}
                        onClick={() => open(clause.key, (now) => withEdit(now, clause))}
                      >
                        Edit
                      </Button>
                      <Button
                        variant="quiet"
                        icon="cross"
                        aria-label={`Strike ${clause.title}`}
                        onClick={() => {
                          setDraft((now) => withStrike(now, clause.key))
                          focusOn(undoId(clause.key))
                        }}
                      >
                        Strike
                      </Button>
                    </>
                  )}
                  <Button
                    id={addId(clause.key)}
                    variant="quiet"
                    icon="plus"
                    aria-label={`Add a clause after ${clause.title}`}
                    onClick={() => open(nextNewId(draft), (now) => withInsert(now, clause.key))}
                  >
                    Add after
                  </Button>
                </div>
                {change && (
                  <Editor
                    contract={contract}
                    draft={draft}
                    change={change}
                    problems={problems}
                    opened={opened}
                    onDraft={setDraft}
                  />
                )}
              </section>
              {added(clause.key, clause.title)}
            </div>
          )
        })}
      </div>
      <div className={`${classes.form} border-t`}>
        <Textarea
          label="Note to the studio (optional)"
          rows={2}
          resize="vertical"
          value={draft.note}
          maxLength={5000}
          onChange={({ currentTarget: { value } }) => setDraft((now) => ({ ...now, note: value }))}
        />
        {problems
          .filter(({ where }) => where === 'changes')
          .map(({ message }) => (
            <Warning key={message}>{sentence(message)}</Warning>
          ))}
        <Refusal error={propose.error} />
        <p role="status" className="small mid">
          {count === 0
            ? 'No change yet.'
            : problems.length > 0
              ? `${plural(count, 'change')}; fix what is named above to send them.`
              : `${plural(count, 'change')} ready to send.`}
        </p>
        <Button
          variant="primary"
          disabled={count === 0 || problems.length > 0}
          aria-busy={propose.isPending}
          onClick={send}
        >
          {count === 0 ? 'Send changes' : `Send ${plural(count, 'change')} to ${contract.studio_name}`}
        </Button>
      </div>
    </Card>
  )
}

/** A clause as it reads with its marks; its title alone until the server has answered. */
function Lines({ marked, title }: { marked: Marked | undefined; title: string }) {
  if (!marked) return <h3>{title}</h3>
  return (
    <div className={`wrap-anywhere ${classes.text}`}>
      {marked.lines.map((line, index) => (
        <MarkedLine key={index} line={line} />
      ))}
    </div>
  )
}

interface EditorProps {
  contract: Contract
  draft: RedlineDraft
  change: Written
  problems: readonly { where: string; message: string }[]
  opened: string | null
  onDraft: (next: (now: RedlineDraft) => RedlineDraft) => void
}

function Editor({ contract, draft, change, problems, opened, onDraft }: EditorProps) {
  const set = (changes: Partial<Written>) => onDraft((now) => withChanged(now, change.id, changes))
  const own = problems.filter(({ where }) => where === `changes.${draft.changes.indexOf(change)}`)
  return (
    <div className={classes.inner}>
      {change.kind !== 'strike' && (
        <WordingFields
          contract={contract}
          clauseKey={change.clause_key ?? null}
          wording={{ title: change.title, text: change.text, terms: change.terms }}
          takesFocus={opened === change.id}
          onChange={set}
        />
      )}
      <TextInput
        label="Comment (optional)"
        value={change.comment}
        maxLength={5000}
        onChange={({ currentTarget: { value } }) => set({ comment: value })}
      />
      {own.map(({ message }) => (
        <Warning key={message}>{sentence(message)}</Warning>
      ))}
    </div>
  )
}
