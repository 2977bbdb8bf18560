import { Textarea, TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'

import { useFocusOnMount } from '@/ui/useFocusOnMount'

import { type Contract, libraryQuery } from './api'
import { TermField } from './ClauseFields'
import { termsOf } from './clauses'
import classes from './Contracts.module.css'
import type { Wording } from './redlines'

interface WordingFieldsProps {
  contract: Contract
  clauseKey: string | null
  wording: Wording
  /** It was opened just now, and not brought back by a reload. */
  takesFocus: boolean
  onChange: (changes: Partial<Wording>) => void
}

/** Title, text and values of a clause, for either side: what a designer proposes, or the studio’s counter. */
export function WordingFields({ contract, clauseKey, wording, takesFocus, onChange }: WordingFieldsProps) {
  const text = useFocusOnMount<HTMLTextAreaElement>(takesFocus && clauseKey !== null)
  const title = useFocusOnMount<HTMLInputElement>(takesFocus && clauseKey === null)
  const { data: library } = useQuery(libraryQuery(contract.kind))
  const known = library?.clauses.find(({ key }) => key === clauseKey)
  const values = { ...contract.version.terms, ...wording.terms }
  const clause = { key: clauseKey ?? '', title: wording.title, text: wording.text, stands: true }
  const used = termsOf(clause, known, values)
  return (
    <>
      <TextInput
        ref={title}
        label="Clause title"
        value={wording.title}
        maxLength={120}
        onChange={({ currentTarget: { value } }) => onChange({ title: value })}
      />
      <Textarea
        ref={text}
        label="Text"
        description="Words in braces are filled in: {studio}, {designer}. **Bold**, *italic*, “- ” for a list."
        autosize
        minRows={4}
        value={wording.text}
        maxLength={20_000}
        onChange={({ currentTarget: { value } }) => onChange({ text: value })}
      />
      {used.length > 0 && (
        <div className={`grid items-end gap-2-3 grid-cols-fill-180px ${classes.terms}`}>
          {used.map((name) => (
            <TermField
              key={name}
              name={name}
              known={known?.terms.find((term) => term.name === name)}
              value={values[name] ?? ''}
              currency={contract.currency}
              onChange={(value) => onChange({ terms: { ...wording.terms, [name]: value } })}
            />
          ))}
        </div>
      )}
    </>
  )
}
