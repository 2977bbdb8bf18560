import { Textarea } from '@mantine/core'
import { useDebouncedValue } from '@mantine/hooks'
import { keepPreviousData, useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams } from '@tanstack/react-router'
import { type ReactNode, useEffect, useEffectEvent, useRef, useState } from 'react'

import { DraftNote } from '@/app/drafts'
import { base64Of } from '@/api/base64'
import { queryKeys } from '@/api/queryKeys'
import { useHotkeys } from '@/app/keys'
import { RefusedNamesList } from '@/app/RefusedNames'
import { showToast } from '@/app/toast'
import { useTitle } from '@/app/title'
import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { FieldError } from '@/ui/FieldError'
import { bytes, figure, plural } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'
import { PageHead } from '@/ui/PageHead'
import { Segmented } from '@/ui/Segmented'
import { Select } from '@/ui/Select'

import { useRights } from '../api'
import { columnsQuery, type OwnColumn } from '../columns/api'
import { type ImportField, type ImportRead, importSheet, useImport } from './api'
import classes from './Import.module.css'
import { ImportRows, isFillDown } from './ImportRows'
import { ReadNotes } from './ReadNotes'
import { EMPTY_SHEET, keepSheet, keptSheet, mappingFor, type SheetDraft } from './pasted'
import { IMPORT_FIELDS } from '../words'

const LARGEST_BYTES = 5_000_000
const TYPING_MS = 300

const bodyOf = ({ text, file, mapping, match, read }: SheetDraft) => ({
  ...(file ? { format: file.format, content_base64: file.contentBase64 } : { format: 'paste' as const, text }),
  mapping,
  match,
  ...read,
})

const isGiven = ({ text, file }: SheetDraft): boolean => file !== null || text.trim() !== ''

/** A spreadsheet becomes cues: what would happen is shown row by row, with every guess; rows with errors stay out. */
export function ImportPage(): ReactNode {
  const { projectId = '' } = useParams({ strict: false })
  const navigate = useNavigate()
  const rights = useRights(projectId)
  useTitle('Import')
  const [sheet, setSheetOnly] = useState<SheetDraft>(() => keptSheet(projectId) ?? EMPTY_SHEET)
  const [wasKept, setWasKept] = useState(() => keptSheet(projectId) !== null)
  const outlives = useRef(true)
  const [unread, setUnread] = useState<string | null>(null)
  const [over, setOver] = useState(false)
  const [asked] = useDebouncedValue(sheet, sheet.text === '' ? 0 : TYPING_MS)
  const picker = useRef<HTMLInputElement>(null)
  const plan = useQuery({
    queryKey: queryKeys.importPlan(projectId, bodyOf(asked)),
    queryFn: () => importSheet(projectId, { ...bodyOf(asked), dry_run: true }),
    enabled: rights.edits && isGiven(asked),
    placeholderData: keepPreviousData,
    gcTime: 0,
    retry: false,
  })
  const send = useImport(projectId)
  const { data: own } = useQuery(columnsQuery(projectId))

  const setSheet = (next: SheetDraft) => {
    setSheetOnly(next)
    outlives.current = keepSheet(projectId, isGiven(next) ? next : null)
    send.reset()
  }
  const toList = () => void navigate({ to: '/projects/$projectId/sound-list', params: { projectId } })

  const take = async (file: File | undefined) => {
    if (file === undefined) return
    setUnread(null)
    const format = /\.xlsx$/i.test(file.name) ? 'xlsx' : 'csv'
    if (file.size > LARGEST_BYTES) {
      setUnread(`${file.name} has ${bytes(file.size)}; the limit is ${bytes(LARGEST_BYTES)}. Nothing was uploaded.`)
      return
    }
    try {
      setSheet({
        ...sheet,
        mapping: {},
        read: {},
        file: { name: file.name, format, contentBase64: await base64Of(file) },
      })
    } catch {
      setUnread(`${file.name} could not be read from your disk. Choose it again.`)
    }
  }
  const takeDropped = useEffectEvent((file: File | undefined) => void take(file))
  useEffect(() => {
    const warn = (event: BeforeUnloadEvent) => {
      if (!outlives.current) event.preventDefault()
    }
    window.addEventListener('beforeunload', warn)
    return () => window.removeEventListener('beforeunload', warn)
  }, [])
  useEffect(() => {
    const enter = (event: DragEvent) => {
      event.preventDefault()
      setOver(true)
    }
    const leave = (event: DragEvent) => {
      if (event.relatedTarget === null) setOver(false)
    }
    const drop = (event: DragEvent) => {
      event.preventDefault()
      setOver(false)
      takeDropped(event.dataTransfer?.files[0])
    }
    window.addEventListener('dragover', enter)
    window.addEventListener('dragleave', leave)
    window.addEventListener('drop', drop)
    return () => {
      window.removeEventListener('dragover', enter)
      window.removeEventListener('dragleave', leave)
      window.removeEventListener('drop', drop)
    }
  }, [])

  const given = isGiven(sheet)
  const read = given ? plan.data : undefined
  const isStale = plan.isPlaceholderData || plan.isFetching || asked !== sheet
  const put = () => {
    if (read === undefined || isStale) return
    send.mutate(bodyOf(sheet), {
      onSuccess: (done) => {
        if (!done.imported) {
          void plan.refetch()
          return
        }
        if (done.left_out.length > 0) {
          const imported = done.rows.map(({ row }) => row)
          setSheet({ ...sheet, read: { ...sheet.read, skip_rows: [...(sheet.read.skip_rows ?? []), ...imported] } })
          showToast(`${whatBecame(done)}. ${plural(done.left_out.length, 'row')} left out: fix them below.`)
          return
        }
        outlives.current = true
        keepSheet(projectId, null)
        showToast(`${whatBecame(done)}. The list is at revision ${done.revision}.`)
        toList()
      },
    })
  }

  const skip = (row: number) =>
    setSheet({ ...sheet, read: { ...sheet.read, skip_rows: [...(sheet.read.skip_rows ?? []), row] } })
  const keep = ({ row, kind }: ImportRead['skipped'][number]) => {
    const { keep_rows: kept = [], skip_rows: skipped = [] } = sheet.read
    const change =
      kind === 'hidden'
        ? { keep_hidden: true }
        : kind === 'asked'
          ? { skip_rows: skipped.filter((other) => other !== row) }
          : { keep_rows: [...kept, row] }
    setSheet({ ...sheet, read: { ...sheet.read, ...change } })
  }
  const edit = (row: number, column: string, text: string) => {
    const others = (sheet.read.edits ?? []).filter((earlier) => earlier.row !== row || earlier.column !== column)
    setSheet({ ...sheet, read: { ...sheet.read, edits: [...others, { row, column, text }] } })
  }
  const fillDown = (column: string) => {
    const filled = sheet.read.fill_down_columns ?? []
    const next = filled.includes(column) ? filled.filter((name) => name !== column) : [...filled, column]
    setSheet({ ...sheet, read: { ...sheet.read, fill_down_columns: next } })
  }
  useHotkeys([
    { keys: 'Escape', label: 'Back to the list', group: 'Import', run: toList },
    { keys: 'mod+Enter', label: 'Import the rows without errors', group: 'Import', run: put },
  ])

  if (rights.known && !rights.edits) {
    return (
      <div className="page">
        <h1>Import</h1>
        <EmptyState
          head="Only producers and audio leads can edit the list"
          action={
            <Link className="link" to="/projects/$projectId/sound-list" params={{ projectId }}>
              Go to the sound list
            </Link>
          }
        >
          You can read it and ask questions.
        </EmptyState>
      </div>
    )
  }

  return (
    <div className="page stack content-start">
      <PageHead
        title="Paste or import"
        actions={
          <ButtonLink component={Link} to={`/projects/${projectId}/sound-list`} keys="Escape">
            Back to the list
          </ButtonLink>
        }
      >
        Turn the rows of a spreadsheet into cues. Rows with an error are left out until you fix them.
      </PageHead>

      <Card aria-labelledby="sheet">
        <CardHead
          id="sheet"
          title="Spreadsheet"
          note={sheet.file ? undefined : 'CSV, XLSX, or rows copied from a spreadsheet'}
        />
        <div className={`p-3-4-4 rounded-b-l ${classes.source}`} data-over={over || undefined}>
          {sheet.file ? (
            <p className="flex wrap items-center gap-2-3">
              <span className="mono">{sheet.file.name}</span>
              <Button onClick={() => setSheet({ ...sheet, mapping: {}, read: {}, file: null })}>Remove file</Button>
            </p>
          ) : (
            <Textarea
              label="Pasted rows"
              placeholder={'name\tcategory\tlength\nshield_hit\tweapon\t0.8'}
              rows={5}
              classNames={{ input: classes.text }}
              value={sheet.text}
              onChange={(event) => {
                const text = event.currentTarget.value
                setSheet({ ...sheet, mapping: mappingFor(text, sheet, plan.data?.header_row !== null), text })
              }}
            />
          )}
          <DraftNote
            draft={{
              isRestored: wasKept && given,
              discard: () => {
                setWasKept(false)
                setSheet(EMPTY_SHEET)
              },
            }}
          />
          <div className="flex wrap items-center gap-2-3 mt-3">
            <Button icon="upload" onClick={() => picker.current?.click()}>
              {sheet.file ? 'Choose another file' : 'Choose file'}
            </Button>
            <span className="small dim">or drop it anywhere on this page</span>
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
          </div>
          {unread && <FieldError>{unread}</FieldError>}
          <Refusal error={given ? plan.error : null} />
        </div>
      </Card>

      {read && (
        <>
          <ReadNotes read={read} reading={sheet.read} onRead={(reading) => setSheet({ ...sheet, read: reading })} />
          <RefusedNamesList refused={read.refused_names} />
          <ImportRows
            read={read}
            head={(column) => (
              <ColumnHead
                column={column}
                own={own?.columns ?? []}
                isFilledDown={sheet.read.fill_down_columns?.includes(column.name) ?? false}
                onMap={(field) => setSheet({ ...sheet, mapping: mapped(sheet.mapping, column.name, field) })}
                onFillDown={() => fillDown(column.name)}
              />
            )}
            match={
              <Segmented
                label="Match rows to cues"
                value={sheet.match}
                onChange={(match) => setSheet({ ...sheet, match })}
                options={[
                  { value: 'number', label: 'By ID' },
                  { value: 'name', label: 'By name' },
                  { value: 'add', label: 'Add all as new' },
                ]}
              />
            }
            onKeep={keep}
            onSkip={skip}
            onEdit={edit}
            onFillDown={fillDown}
          />
          <footer
            className={`flex wrap items-center gap-2-4 sticky bottom-0 bg-surface narrow-p-3 ${classes.bar}`}
            aria-label="Import"
          >
            <div className={`flex-1 ${classes.says}`} role="status">
              <p className="strong">{isStale ? 'Reading the spreadsheet' : whatWould(read)}</p>
              {read.errors.length > 0 && (
                <p className="small tone-bad toned">
                  {`${plural(read.errors.length, 'error')}: ${plural(read.left_out.length, 'row')} will be left out. Fix the rows, or map the columns differently.`}
                </p>
              )}
            </div>
            <Refusal error={send.error} />
            <Button
              variant="primary"
              keys="mod+Enter"
              disabled={read.added + read.changed === 0 || isStale || send.isPending}
              onClick={put}
            >
              {read.added + read.changed === 0
                ? 'Nothing to import'
                : `Import ${plural(read.added + read.changed, 'cue')}`}
            </Button>
          </footer>
        </>
      )}
      {!given && (
        <p className="small dim">
          The first row can hold column names, in any order. Unknown columns are kept as custom columns. You can also
          re-import a CSV or XLSX file exported from the list.{' '}
          <button type="button" className="link" onClick={() => setSheet({ ...EMPTY_SHEET, text: EXAMPLE })}>
            Use an example
          </button>
        </p>
      )}
    </div>
  )
}

const EXAMPLE =
  'name\tcategory\tuse in the game\tlength\tvariations\tloop\n' +
  'door_open\tfoley\tEvery cabin door\t1.2\t3\tno\n' +
  'reactor_hum\tambience\tUnder the engine room\t20\t1\tyes\n'

/** A field is read from one column: choosing it again elsewhere moves it. */
function mapped(mapping: Record<string, ImportField>, name: string, field: ImportField): Record<string, ImportField> {
  const others = Object.entries(mapping).filter(
    ([column, given]) => column !== name && (given !== field || field === 'extra' || field === 'ignore'),
  )
  return { ...Object.fromEntries(others), [name]: field }
}

function whatBecame({ added, changed }: ImportRead): string {
  const parts = [added > 0 ? `${plural(added, 'cue')} added` : '', changed > 0 ? `${figure(changed)} changed` : '']
  return parts.filter(Boolean).join(', ')
}

function whatWould({ added, changed, same }: ImportRead): string {
  return `${plural(added, 'cue')} to add, ${figure(changed)} to change, ${figure(same)} the same`
}

interface ColumnHeadProps {
  column: ImportRead['columns'][number]
  /** The project's own columns, in order. */
  own: readonly OwnColumn[]
  isFilledDown: boolean
  onMap: (field: ImportField) => void
  /** Give the empty cells of the column the value of the cell above, or no longer. */
  onFillDown: () => void
}

/** A column by its own name, and what it is read as: guessed from its head and its cells, and changed by the person. */
function ColumnHead({ column: { name, field, why }, own, isFilledDown, onMap, onFillDown }: ColumnHeadProps) {
  return (
    <>
      <span className="mono cut-text" title={[name, why].filter(Boolean).join('\n')}>
        {name}
        {isFilledDown && ' (filled down)'}
      </span>
      <Select
        aria-label={`Map ${name} to`}
        value={field}
        aria-keyshortcuts="Control+D Meta+D"
        onChange={(event) => onMap(event.currentTarget.value)}
        onKeyDown={(event) => {
          if (!isFillDown(event)) return
          event.preventDefault()
          onFillDown()
        }}
      >
        {own.length > 0 && (
          <optgroup label="Columns of this list">
            {own.map(({ id, name: ownName }) => (
              <option key={id} value={`own:${ownName}`}>
                {ownName}
              </option>
            ))}
          </optgroup>
        )}
        {IMPORT_FIELDS.map(({ value, label }) => (
          <option key={value} value={value}>
            {label}
          </option>
        ))}
      </Select>
    </>
  )
}
