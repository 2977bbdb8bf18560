import { useState } from 'react'

import { Button } from '@/ui/Button'
import { Field, Form, Submit } from '@/ui/Form'
import { Select } from '@/ui/Select'

import type { Draft, LibraryClause } from './api'
import { withLibraryClause, withOwnClause } from './clauses'
import classes from './Contracts.module.css'

interface AddClauseProps {
  library: readonly LibraryClause[]
  draft: Draft
  onAdd: (draft: Draft) => void
}

/** Adds a clause to a draft: one of the library that it lacks, or one of the studio's own. */
export function AddClause({ library, draft, onAdd }: AddClauseProps) {
  const [chosen, setChosen] = useState('')
  const [added, setAdded] = useState(0)
  const missing = library.filter(({ key }) => draft.clauses.every((clause) => clause.key !== key))
  const key = missing.some((each) => each.key === chosen) ? chosen : (missing[0]?.key ?? '')
  return (
    <div className={classes.form}>
      {missing.length > 0 && (
        <div className="grid gap-1">
          <Select
            label="Clause from the library"
            value={key}
            onChange={({ currentTarget }) => setChosen(currentTarget.value)}
          >
            {missing.map((each) => (
              <option key={each.key} value={each.key}>
                {each.title}
              </option>
            ))}
          </Select>
          <p className="small mid">{missing.find((each) => each.key === key)?.why}</p>
          <div>
            <Button icon="plus" onClick={() => onAdd(withLibraryClause(draft, library, key))}>
              Add from the library
            </Button>
          </div>
        </div>
      )}
      <Form
        key={added}
        className={classes.inner}
        aria-label="Custom clause"
        initialValues={{ title: '' }}
        mutation={{ isPending: false, error: null }}
        onSubmit={({ title }) => {
          onAdd(withOwnClause(draft, title.trim()))
          setAdded(added + 1)
        }}
      >
        <Field name="title" label="Title of the custom clause" maxLength={120} />
        <Submit variant="plain" icon="plus">
          Add clause
        </Submit>
      </Form>
    </div>
  )
}
