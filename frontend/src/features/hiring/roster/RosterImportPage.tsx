import { Textarea } from '@mantine/core'
import { useDebouncedValue } from '@mantine/hooks'
import { keepPreviousData, useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useSearch } from '@tanstack/react-router'
import { type ReactNode, useRef, useState } from 'react'

import { base64Of } from '@/api/base64'
import { queryKeys } from '@/api/queryKeys'
import { DraftNote, useDraft } from '@/app/drafts'
import { useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import { useTitle } from '@/app/title'
import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { FieldError } from '@/ui/FieldError'
import { Refusal } from '@/ui/Refusal'
import { bytes, figure, plural } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { Select } from '@/ui/Select'
import { PageSkeleton } from '@/ui/Skeleton'
import { Table } from '@/ui/Table'

import forms from '../Hiring.module.css'
import { importRoster, type RosterImport, useImportRoster, useRosterStudios } from './api'
import classes from './Roster.module.css'
import { FIELD_WORDS } from './words'

type Field = RosterImport['columns'][number]['field']

const LARGEST_BYTES = 5_000_000
const TYPING_MS = 300
const SHOWN_ROWS = 200
const FIELDS = Object.entries(FIELD_WORDS) as [Field, string][]
const TOGETHER: readonly Field[] = ['notes', 'ignore']
const EXAMPLE =
  'name\temail\tspecialities\tservices\trate\tavailable from\n' +
  'A sound designer\tdesigner@studio.example\tweapons, creatures\tcomposes\t45 USD/hour\t2027-01-11\n'

interface SheetFile {
  name: string
  format: 'csv' | 'xlsx'
  contentBase64: string
}

/** A sheet of designers becomes people on file, matched by address: shown first, and all of it or nothing. */
export function RosterImportPage() {
  useTitle('Import into the roster')
  const studios = useRosterStudios()
  const { studio: studioId } = useSearch({ from: '/shell/roster/import' })
  const navigate = useNavigate()
  useHotkeys([
    { keys: 'Escape', label: 'Back to the roster', group: 'Import', run: () => void navigate({ to: '/roster' }) },
  ])
  if (studios === undefined) return <PageSkeleton />
  const studio = studios.find(({ id }) => id === studioId) ?? studios[0]
  return (
    <div className="page stack">
      <PageHead
        title="Import into the roster"
        actions={
          <ButtonLink component={Link} to="/roster" keys="Escape">
            Back to the roster
          </ButtonLink>
        }
      >
        Rows are matched by email: people on file are changed where a cell is filled, others are added. Nothing is
        imported while any row has an error, and nobody is mailed.
      </PageHead>
      {studio ? (
        <Sheet key={studio.id} studioId={studio.id} />
      ) : (
        <EmptyState head="The roster is for producers and audio leads">Ask a producer of your studio.</EmptyState>
      )}
    </div>
  )
}

function Sheet({ studioId }: { studioId: string }) {
  const [text, setText, draft] = useDraft(`roster-import:${studioId}`, '')
  const [file, setFile] = useState<SheetFile | null>(null)
  const [mapping, setMapping] = useState<Record<string, Field>>({})
  const [unread, setUnread] = useState<string | null>(null)
  const [asked] = useDebouncedValue(text, text === '' ? 0 : TYPING_MS)
  const picker = useRef<HTMLInputElement>(null)
  const navigate = useNavigate()
  const send = useImportRoster(studioId)
  const bodyOf = (typed: string) => ({
    ...(file ? { format: file.format, content_base64: file.contentBase64 } : { format: 'paste' as const, text: typed }),
    mapping,
  })
  const isGiven = file !== null || asked.trim() !== ''
  const plan = useQuery({
    queryKey: queryKeys.rosterImport(studioId, bodyOf(asked)),
    queryFn: () => importRoster(studioId, { ...bodyOf(asked), dry_run: true }),
    enabled: isGiven,
    placeholderData: keepPreviousData,
    gcTime: 0,
    retry: false,
  })
  const take = async (chosen: File | undefined) => {
    if (chosen === undefined) return
    setUnread(null)
    if (chosen.size > LARGEST_BYTES) {
      setUnread(`${chosen.name} has ${bytes(chosen.size)}; the limit is ${bytes(LARGEST_BYTES)}.`)
      return
    }
    try {
      const format = /\.xlsx$/i.test(chosen.name) ? 'xlsx' : 'csv'
      setFile({ name: chosen.name, format, contentBase64: await base64Of(chosen) })
      setMapping({})
    } catch {
      setUnread(`${chosen.name} could not be read from your disk. Choose it again.`)
    }
  }
  const read = isGiven ? plan.data : undefined
  const isStale = plan.isPlaceholderData || plan.isFetching || asked !== text
  const put = () => {
    if (read === undefined || isStale || read.errors.length > 0) return
    send.mutate(bodyOf(text), {
      onSuccess: (done) => {
        if (!done.imported) return void plan.refetch()
        draft.discard()
        showToast(`${plural(done.added, 'person', 'people')} added, ${figure(done.changed)} changed.`)
        return void navigate({ to: '/roster' })
      },
    })
  }
  return (
    <>
      <Card aria-labelledby="sheet">
        <CardHead id="sheet" title="Spreadsheet" note="CSV, XLSX, or rows copied from a spreadsheet" />
        <div className={`grid gap-3 ${forms.body}`}>
          {file ? (
            <div className="row wrap">
              <span className="mono">{file.name}</span>
              <Button onClick={() => setFile(null)}>Remove file</Button>
            </div>
          ) : (
            <Textarea
              label="Pasted rows"
              placeholder={EXAMPLE.split('\n')[0]}
              rows={5}
              classNames={{ input: classes.input }}
              value={text}
              onChange={({ currentTarget: { value } }) => setText(value)}
            />
          )}
          <DraftNote draft={draft} />
          <div className="row wrap">
            <Button icon="upload" onClick={() => picker.current?.click()}>
              Choose file
            </Button>
            {!isGiven && (
              <button type="button" className="link small" onClick={() => setText(EXAMPLE)}>
                Use an example
              </button>
            )}
          </div>
          <input
            ref={picker}
            type="file"
            hidden
            aria-label="File to import"
            accept=".csv,.tsv,.txt,.xlsx"
            onChange={(event) => {
              void take(event.currentTarget.files?.[0])
              event.currentTarget.value = ''
            }}
          />
          {unread && <FieldError>{unread}</FieldError>}
          <Refusal error={isGiven ? plan.error : null} />
        </div>
      </Card>
      {read && (
        <>
          <Columns read={read} onMap={(name, field) => setMapping((now) => mapped(now, name, field))} />
          <Plan read={read} />
          <div className={`flex wrap items-center gap-3 ${classes.foot}`}>
            <span className="grow strong" role="status">
              {isStale
                ? 'Reading the spreadsheet'
                : `${plural(read.added, 'person', 'people')} to add, ${figure(read.changed)} to change, ${figure(read.same)} the same`}
            </span>
            <Refusal error={send.error} />
            <Button
              variant="primary"
              disabled={read.errors.length > 0 || read.added + read.changed === 0 || isStale}
              aria-busy={send.isPending}
              onClick={put}
            >
              {`Import ${plural(read.added + read.changed, 'person', 'people')}`}
            </Button>
          </div>
        </>
      )}
    </>
  )
}

/** A field is read from one column: choosing it again elsewhere moves it. */
function mapped(mapping: Record<string, Field>, name: string, field: Field): Record<string, Field> {
  const others = Object.entries(mapping).filter(
    ([column, given]) => column !== name && (given !== field || TOGETHER.includes(field)),
  )
  return { ...Object.fromEntries(others), [name]: field }
}

function Columns({ read, onMap }: { read: RosterImport; onMap: (name: string, field: Field) => void }) {
  return (
    <Card aria-labelledby="columns">
      <CardHead id="columns" title="Columns" count={read.columns.length} />
      <ul className={`grid gap-3 grid-cols-fill-180px p-14px ${classes.columns}`}>
        {read.columns.map(({ name, field, samples }) => (
          <li key={name}>
            <span className="strong cut-text" title={name}>
              {name}
            </span>
            <Select
              aria-label={`Map ${name} to`}
              value={field}
              onChange={({ currentTarget: { value } }) => onMap(name, value as Field)}
            >
              {FIELDS.map(([value, words]) => (
                <option key={value} value={value}>
                  {words}
                </option>
              ))}
            </Select>
            <span className="small dim cut-text" title={samples.join('\n')}>
              {samples.join(', ') || 'empty'}
            </span>
          </li>
        ))}
      </ul>
    </Card>
  )
}

const ACTION_WORDS = { add: 'Add', change: 'Change', same: 'Same' } as const

function Plan({ read }: { read: RosterImport }) {
  const rows: { row: number; happens: ReactNode; name?: string; email?: string }[] = [
    ...read.errors.map(({ row, column, message }) => ({
      row,
      happens: <span className="tone-bad toned">{`Error. ${column ? `${column}: ` : ''}${message}`}</span>,
    })),
    ...read.rows.slice(0, SHOWN_ROWS).map(({ row, action, name, email, changed }) => ({
      row,
      happens: `${ACTION_WORDS[action]} ${changed.map((field) => FIELD_WORDS[field].toLowerCase()).join(', ')}`,
      name,
      email,
    })),
  ]
  return (
    <Card aria-labelledby="rows">
      <CardHead id="rows" title="Rows" count={read.rows.length + read.errors.length} />
      <Table
        label="Rows of the spreadsheet"
        columns={[
          { head: 'Row', cell: ({ row }) => row },
          { head: 'What happens', cell: ({ happens }) => happens },
          { head: 'Name', cell: ({ name }) => name },
          { head: 'Email', cell: ({ email }) => email },
        ]}
        rows={rows.map((row, at) => ({ ...row, at }))}
        keyOf={({ at }) => at}
      />
      {read.rows.length > SHOWN_ROWS && (
        <p
          className={`small dim flex wrap items-center gap-3 ${classes.foot}`}
        >{`And ${plural(read.rows.length - SHOWN_ROWS, 'more row')}.`}</p>
      )}
    </Card>
  )
}
