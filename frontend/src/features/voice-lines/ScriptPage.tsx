import { Checkbox, Textarea, TextInput } from '@mantine/core'
import { useDebouncedValue } from '@mantine/hooks'
import { keepPreviousData, useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams } from '@tanstack/react-router'
import { type ReactNode, useRef, useState } from 'react'

import { ApiProblem } from '@/api'
import { base64Of } from '@/api/base64'
import { useMyProject } from '@/api/me'
import { queryKeys } from '@/api/queryKeys'
import { DraftNote, useDraft } from '@/app/drafts'
import { useHotkeys } from '@/app/keys'
import { RefusedNamesList } from '@/app/RefusedNames'
import { showToast } from '@/app/toast'
import { useTitle } from '@/app/title'
import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { FieldError } from '@/ui/FieldError'
import { Refusal } from '@/ui/Refusal'
import { bytes, plural } from '@/ui/format'
import { Segmented } from '@/ui/Segmented'
import { Select } from '@/ui/Select'
import { languageName } from '@/voice-lines'

import { type ScriptAsk, type ScriptRead, sendScript, useImportScript } from './api'
import classes from './VoiceLines.module.css'

const LARGEST_BYTES = 5_000_000
const TYPING_MS = 300
const SHOWN = 200
const EMPTY = {
  text: '',
  form: 'paste' as 'paste' | 'script',
  language: 'en',
  speaker: '',
  inKey: false,
  mapping: {} as Record<string, string>,
  tab: null as string | null,
  encoding: null as string | null,
}
const FIELDS = [
  ['key', 'Line ID'],
  ['character', 'Character'],
  ['scene', 'Scene'],
  ['direction', 'Direction'],
  ['file_name', 'File name'],
  ['variations', 'Number of files'],
  ['text', 'Text'],
  ['ignore', 'Leave out'],
] as const

interface PickedFile {
  name: string
  format: ScriptAsk['format']
  content: string
}

/** A script becomes voice lines: what would happen is shown row by row; rows with errors are left out and named. */
export function ScriptPage(): ReactNode {
  const { projectId = '' } = useParams({ strict: false })
  const navigate = useNavigate()
  const project = useMyProject(projectId)
  useTitle('Import a script')
  const [typed, setTyped, draft] = useDraft(`script:${projectId}`, EMPTY)
  const [file, setFile] = useState<PickedFile | null>(null)
  const [unread, setUnread] = useState<string | null>(null)
  const picker = useRef<HTMLInputElement>(null)
  const send = useImportScript(projectId)
  const body = {
    ...(file ? { format: file.format, content_base64: file.content } : { format: typed.form, text: typed.text }),
    language: typed.language.trim() || 'en',
    mapping: typed.mapping,
    speaker: typed.speaker.trim(),
    speaker_in_key: typed.inKey,
    atomic: false,
    keep_hidden: false,
    ...(file && { tab: typed.tab, encoding: typed.encoding }),
  }
  const isGiven = file !== null || typed.text.trim() !== ''
  const [asked] = useDebouncedValue(JSON.stringify(body), TYPING_MS)
  const isSettled = asked === JSON.stringify(body)
  const mayImport = (project?.is_producer || project?.is_liaison || project?.is_approver) ?? false
  const plan = useQuery({
    queryKey: queryKeys.scriptPlan(projectId, asked),
    queryFn: () => sendScript(projectId, { ...(JSON.parse(asked) as typeof body), dry_run: true }),
    enabled: mayImport && isGiven && isSettled,
    placeholderData: keepPreviousData,
    gcTime: 0,
    retry: false,
  })
  const toLines = () => void navigate({ to: '/projects/$projectId/voice-lines', params: { projectId }, search: {} })
  useHotkeys([{ keys: 'Escape', label: 'Back to the voice lines', group: 'Import', run: toLines }])
  const change = (next: Partial<typeof EMPTY>) => {
    setTyped({ ...typed, ...next })
    send.reset()
  }
  const take = async (chosen: File | undefined) => {
    if (chosen === undefined) return
    setUnread(null)
    if (chosen.size > LARGEST_BYTES) {
      setUnread(`${chosen.name} has ${bytes(chosen.size)}; the limit is ${bytes(LARGEST_BYTES)}. Nothing was uploaded.`)
      return
    }
    const format = /\.xlsx$/i.test(chosen.name) ? 'xlsx' : /\.(txt|fountain|md)$/i.test(chosen.name) ? 'script' : 'csv'
    try {
      setFile({ name: chosen.name, format, content: await base64Of(chosen) })
      change({ mapping: {}, tab: null, encoding: null })
    } catch {
      setUnread(`${chosen.name} could not be read from your disk. Choose it again.`)
    }
  }
  if (project && !mayImport)
    return (
      <div className="page">
        <h1>Import a script</h1>
        <EmptyState head="Only producers and audio leads can import a script">You can read the voice lines.</EmptyState>
      </div>
    )
  const read = isGiven ? plan.data : undefined
  const error = isGiven ? plan.error : null
  const isWaiting = plan.isFetching || !isSettled
  const touched = read ? read.added + read.changed : 0
  const put = () =>
    send.mutate(body, {
      onSuccess: (done) => {
        if (!done.imported) {
          void plan.refetch()
          return
        }
        if (done.left_out.length > 0) {
          showToast(`${plural(done.added, 'line')} added, ${plural(done.left_out.length, 'row')} left out.`)
          void plan.refetch()
          return
        }
        draft.discard()
        showToast(`${plural(done.added, 'line')} added, ${done.changed} changed.`)
        toLines()
      },
    })
  return (
    <div className={`page stack content-start ${classes.page}`}>
      <header className="flex wrap items-center gap-2-3">
        <h1>Import a script</h1>
        <span className="end">
          <ButtonLink component={Link} to={`/projects/${projectId}/voice-lines`} keys="Escape">
            Back to the voice lines
          </ButtonLink>
        </span>
      </header>
      <Card aria-labelledby="script">
        <CardHead id="script" title="Script" note="CSV, XLSX, rows copied from a spreadsheet, or plain text" />
        <div className={classes.form}>
          {file ? (
            <p className="flex wrap items-center gap-2-3">
              <span className="mono">{file.name}</span>
              <Button onClick={() => setFile(null)}>Remove file</Button>
            </p>
          ) : (
            <>
              <Segmented
                label="What is pasted"
                options={[
                  { value: 'paste', label: 'Rows of a spreadsheet' },
                  { value: 'script', label: 'Text of a script' },
                ]}
                value={typed.form}
                onChange={(form) => change({ form, mapping: {} })}
              />
              <Textarea
                label={typed.form === 'paste' ? 'Pasted rows' : 'Text'}
                placeholder={
                  typed.form === 'paste'
                    ? 'Line ID\tCharacter\tScene\tEnglish\tGerman'
                    : '# Bridge\n\nCAPTAIN [[captain_010]]\n(quietly)\nBy the light of a hundred suns.'
                }
                rows={6}
                maxLength={LARGEST_BYTES}
                classNames={{ input: classes.pasted }}
                value={typed.text}
                onChange={(event) => change({ text: event.currentTarget.value, mapping: {} })}
              />
            </>
          )}
          <div className={classes.acts}>
            <Button icon="upload" onClick={() => picker.current?.click()}>
              {file ? 'Choose another file' : 'Choose file'}
            </Button>
            <input
              ref={picker}
              type="file"
              hidden
              aria-label="Script to import"
              accept=".csv,.tsv,.xlsx,.txt,.fountain"
              onChange={(event) => {
                void take(event.currentTarget.files?.[0])
                event.currentTarget.value = ''
              }}
            />
            <TextInput
              label="Language of the text"
              description="Where no column names its language"
              maxLength={40}
              value={typed.language}
              onChange={(event) => change({ language: event.currentTarget.value })}
            />
          </div>
          {((error instanceof ApiProblem && error.code === 'speaker-missing') ||
            typed.speaker !== '' ||
            typed.inKey) && (
            <fieldset className={classes.acts}>
              <legend>Who speaks lines that name no one</legend>
              <TextInput
                label="Speaker of the file"
                maxLength={100}
                value={typed.speaker}
                onChange={(event) => change({ speaker: event.currentTarget.value })}
              />
              <Checkbox
                label="The line ID begins with the speaker: anna_010"
                checked={typed.inKey}
                onChange={(event) => change({ inKey: event.currentTarget.checked })}
              />
            </fieldset>
          )}
          <DraftNote draft={draft} />
          {unread && <FieldError>{unread}</FieldError>}
          <Refusal error={error} />
        </div>
      </Card>
      {read && (
        <>
          {(file?.format ?? typed.form) !== 'script' && (
            <Columns
              read={read}
              onMap={(name, meaning) => change({ mapping: { ...typed.mapping, [name]: meaning } })}
            />
          )}
          <HowRead read={read} onTab={(tab) => change({ tab })} onEncoding={(encoding) => change({ encoding })} />
          <RefusedNamesList refused={read.refused_names} />
          <Rows read={read} />
          <footer
            className={`flex wrap items-center between gap-2-4 bg-raised p-3-4 sticky bottom-0 border-line-2 rounded-l ${classes.bar}`}
            aria-label="Import"
          >
            <div role="status">
              <p className="strong">{isWaiting ? 'Reading the script' : whatWould(read)}</p>
              {read.errors.length > 0 && (
                <p className="small tone-bad toned">
                  {`${plural(read.errors.length, 'error')}: ${plural(read.left_out.length, 'row')} will be left out.`}
                </p>
              )}
              {read.not_in_script.length > 0 && (
                <p className="small mid">
                  {plural(read.not_in_script.length, 'line of the project is', 'lines of the project are')} not in this
                  script and {read.not_in_script.length === 1 ? 'stays as it is' : 'stay as they are'}.
                </p>
              )}
            </div>
            <Refusal error={send.error} />
            <Button variant="primary" disabled={touched === 0 || isWaiting || send.isPending} onClick={put}>
              {touched === 0 ? 'Nothing to import' : `Import ${plural(touched, 'line')}`}
            </Button>
          </footer>
        </>
      )}
    </div>
  )
}

function whatWould({ added, changed, same, cues_added: cues, stale }: ScriptRead): string {
  const parts = [`${plural(added, 'line')} to add`, `${changed} to change`, `${same} the same`]
  if (cues > 0) parts.push(`${plural(cues, 'cue')} to add to the sound list`)
  if (stale > 0) parts.push(`takes of ${plural(stale, 'text')} become stale`)
  return parts.join(', ')
}

interface HowReadProps {
  read: ScriptRead
  onTab: (tab: string) => void
  onEncoding: (encoding: string) => void
}

/** The tab and the encoding that were chosen, and the rows that the spreadsheet hides. */
function HowRead({ read: { tabs, encoding, skipped }, onTab, onEncoding }: HowReadProps) {
  if (tabs.length < 2 && !encoding?.is_guess && skipped.length === 0) return null
  return (
    <Card aria-labelledby="how-read">
      <CardHead id="how-read" title="How the script was read" />
      <div className={classes.form}>
        {tabs.length > 1 && (
          <Select
            label="Tab"
            value={tabs.find(({ is_read }) => is_read)?.name ?? ''}
            onChange={(event) => onTab(event.currentTarget.value)}
          >
            {tabs.map(({ name, rows, is_hidden }) => (
              <option key={name} value={name}>
                {`${name} (${plural(rows, 'row')}${is_hidden ? ', hidden' : ''})`}
              </option>
            ))}
          </Select>
        )}
        {encoding?.is_guess && (
          <Select
            label="Encoding, guessed from the letters"
            value={encoding.name}
            onChange={(event) => onEncoding(event.currentTarget.value)}
          >
            {[encoding.name, ...encoding.others].map((name) => (
              <option key={name}>{name}</option>
            ))}
          </Select>
        )}
        {skipped.map(({ row, text, why }) => (
          <p key={row} className="small">
            {`Row ${row} is not read: ${text}. `}
            <span className="mid">{why}</span>
          </p>
        ))}
      </div>
    </Card>
  )
}

function Columns({ read, onMap }: { read: ScriptRead; onMap: (name: string, meaning: string) => void }) {
  const known: readonly string[] = FIELDS.map(([field]) => field)
  const languages = [
    ...new Set(read.columns.map(({ meaning }) => meaning).filter((meaning) => !known.includes(meaning))),
  ]
  return (
    <Card aria-labelledby="columns">
      <CardHead id="columns" title="Columns" count={read.columns.length} />
      <ul className={`grid gap-3 grid-cols-fill-180px p-3-4-4 ${classes.columns}`}>
        {read.columns.map(({ name, meaning, samples }) => (
          <li key={name}>
            <Select label={name} value={meaning} onChange={(event) => onMap(name, event.currentTarget.value)}>
              {FIELDS.map(([field, word]) => (
                <option key={field} value={field}>
                  {word}
                </option>
              ))}
              {languages.map((language) => (
                <option key={language} value={language}>
                  {languageName(language)}
                </option>
              ))}
            </Select>
            <span className="small dim">{samples[0]}</span>
          </li>
        ))}
      </ul>
    </Card>
  )
}

const ACTIONS = { add: 'New', change: 'Changed', same: 'The same' }

function Rows({ read }: { read: ScriptRead }) {
  const shown = read.rows.filter(({ action }) => action !== 'same').slice(0, SHOWN)
  return (
    <>
      {read.errors.length > 0 && (
        <Card aria-labelledby="errors">
          <CardHead id="errors" title="Errors" count={read.errors.length} />
          <ul className={`grid gap-3 ${classes.preview}`}>
            {read.errors.slice(0, SHOWN).map(({ row, column, message }) => (
              <li key={`${row} ${column} ${message}`}>
                <span className="strong">
                  Row {row}
                  {column !== null && `, ${column}`}
                </span>{' '}
                {message}
              </li>
            ))}
          </ul>
        </Card>
      )}
      {shown.length > 0 && (
        <Card aria-labelledby="preview">
          <CardHead
            id="preview"
            title="Lines"
            note={shown.length < read.rows.length ? `${shown.length} of ${read.rows.length} shown` : undefined}
          />
          <ul className={`grid gap-3 ${classes.preview}`}>
            {shown.map((row) => (
              <li key={row.row}>
                <p>
                  <span className="small dim">
                    Row {row.row}, {ACTIONS[row.action]}
                  </span>{' '}
                  <span className="mono">{row.key}</span> <span className="strong">{row.character}</span>{' '}
                  {row.action === 'add' && row.text}
                  {row.files > 1 && <span className="small dim"> {plural(row.files, 'file')} in each language</span>}
                </p>
                {row.action === 'change' &&
                  row.changes.map(({ field, before, after, makes_stale }) => (
                    <p key={field} className="small">
                      <span className="mid">{field}:</span> <del>{before}</del> <ins>{after}</ins>
                      {makes_stale && <span className="tone-warn toned"> Its takes become stale.</span>}
                    </p>
                  ))}
              </li>
            ))}
          </ul>
        </Card>
      )}
    </>
  )
}
