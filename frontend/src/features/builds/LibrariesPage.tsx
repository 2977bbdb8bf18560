import { VisuallyHidden } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { useParams } from '@tanstack/react-router'
import { useId, useRef, useState } from 'react'

import { base64Of } from '@/api/base64'
import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { Card, CardHead } from '@/ui/Card'
import { ConfirmInline } from '@/ui/ConfirmInline'
import { EmptyState } from '@/ui/EmptyState'
import { Field, Form, Submit } from '@/ui/Form'
import { bytes, day, figure, plural } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { Refusal } from '@/ui/Refusal'
import { Table } from '@/ui/Table'

import classes from './Libraries.module.css'
import { librariesQuery, MAX_SHEET_BYTES, type SoundLibrary, useAddLibrary, useRemoveLibrary } from './libraries'

/** The sound libraries that versions are compared with, and a sheet of fingerprints for another one. */
export function LibrariesPage() {
  const { projectId = '' } = useParams({ strict: false })
  const { data: libraries, error } = useQuery(librariesQuery(projectId))
  useTitle('Sound libraries')
  return (
    <div className="page stack">
      <PageHead title="Sound libraries">
        Versions are compared with these libraries. The page of a version names the files that it equals.
      </PageHead>
      <Refusal error={error} />
      {libraries?.length === 0 && (
        <EmptyState head="No sound library yet">
          Register one below: its fingerprints are made on your machine, and no sound leaves it.
        </EmptyState>
      )}
      {libraries !== undefined && libraries.length > 0 && <Libraries libraries={libraries} />}
      <AddLibrary projectId={projectId} />
    </div>
  )
}

function Libraries({ libraries }: { libraries: SoundLibrary[] }) {
  const remove = useRemoveLibrary()
  return (
    <Card aria-labelledby="known">
      <CardHead id="known" title="Known libraries" count={libraries.length} />
      <Refusal error={remove.error} />
      <Table
        label="Registered libraries"
        rows={libraries}
        keyOf={({ id }) => id}
        columns={[
          { head: 'Library', rowHead: true, cell: ({ name }) => name },
          { head: 'Licence', cell: ({ licence }) => licence || 'not named' },
          { head: 'Sounds', numeric: true, cell: ({ sounds }) => figure(sounds) },
          { head: 'Registered by', cell: ({ person }) => person.name },
          { head: 'Newest sheet', cell: ({ added_at: at }) => day(at) },
          {
            head: <VisuallyHidden>Remove</VisuallyHidden>,
            cell: ({ id, name, may_remove: mayRemove }) =>
              mayRemove && (
                <ConfirmInline
                  variant="quiet"
                  aria-label={`Remove ${name}`}
                  action={`Remove ${name} and what was found`}
                  onConfirm={() => remove.mutate(id)}
                >
                  Remove
                </ConfirmInline>
              ),
          },
        ]}
      />
    </Card>
  )
}

function AddLibrary({ projectId }: { projectId: string }) {
  const add = useAddLibrary(projectId)
  const fileId = useId()
  const picker = useRef<HTMLInputElement>(null)
  const [file, setFile] = useState<File | null>(null)
  const isTooLarge = file !== null && file.size > MAX_SHEET_BYTES
  return (
    <Card aria-labelledby="register">
      <CardHead id="register" title="Register a library" />
      <Form
        className={classes.form}
        aria-labelledby="register"
        initialValues={{ name: '', licence: '' }}
        mutation={add}
        resets
        onSubmit={({ name, licence }) => {
          if (file === null) return
          void base64Of(file).then((content_base64) =>
            add.mutate(
              { name: name.trim(), licence: licence.trim(), content_base64 },
              {
                onSuccess: ({ name: added, sounds }) => {
                  setFile(null)
                  if (picker.current) picker.current.value = ''
                  showToast(`${added} has ${plural(sounds, 'sound')}. Versions are compared with the library now.`)
                },
              },
            ),
          )
        }}
      >
        <p>Run this on the folder of the library. The sheet holds fingerprints and file names, and no sound:</p>
        <code className="wrap-anywhere">audio-checks manifest FOLDER --out library.json</code>
        <Field
          name="name"
          label="Name"
          description="As sources declare it. A second sheet of that name adds to the library."
          maxLength={200}
        />
        <Field optional name="licence" label="Licence" maxLength={500} />
        <label htmlFor={fileId}>Sheet of fingerprints</label>
        <input
          ref={picker}
          id={fileId}
          type="file"
          accept=".json,application/json"
          onChange={({ currentTarget }) => setFile(currentTarget.files?.[0] ?? null)}
        />
        {isTooLarge && (
          <p role="alert">
            {`${file.name} has ${bytes(file.size)}; a sheet may have ${bytes(MAX_SHEET_BYTES)}. Write one for each of its folders.`}
          </p>
        )}
        <Submit disabled={file === null || isTooLarge}>Register</Submit>
      </Form>
    </Card>
  )
}
