import { Textarea } from '@mantine/core'
import { useDebouncedValue } from '@mantine/hooks'
import { useQuery, useQueryClient } from '@tanstack/react-query'
import { Link, useNavigate } from '@tanstack/react-router'
import { useEffect, useMemo, useState } from 'react'

import { ApiProblem } from '@/api'
import { useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { shortDay } from '@/ui/format'
import { Icon } from '@/ui/Icon'
import { Segmented } from '@/ui/Segmented'

import { cuesQuery, type Project, type Spec, specQuery, useSaveSpec, useSpecTry } from '../api'
import { Refusal } from '../Refusal'
import { sentence } from '../words'
import { differs, draftOf, keepDraft, keptDraft, type SpecDraft, written } from './draft'
import { Writing } from './fields'
import { LineDiff } from './LineDiff'
import { correctionOf, hasComments, lineOf } from './places'
import classes from './SpecEditor.module.css'
import { SpecForm } from './SpecForm'
import { put, same, type Tables } from './tables'
import { TomlEditor } from './TomlEditor'
import { troubleOf } from './trouble'

const TRY_AFTER_MS = 400
const NO_CUES: never[] = []

/** Opens the field or the line where something is wrong. */
function goTo(place: string) {
  const keys = place.replace(/\[\d+\]/g, '').split('.')
  for (let count = keys.length; count > 0; count -= 1) {
    const field = document.getElementById(`spec-${keys.slice(0, count).join('.')}`)
    if (field) {
      field.scrollIntoView({ block: 'center' })
      const target = field.matches('input, textarea, button')
        ? field
        : field.querySelector<HTMLElement>('button, input')
      target?.focus()
      return
    }
  }
}

/** Takes the caret to a line of the text. */
function goToLine(toml: string, line: number) {
  const field = document.getElementById('spec-toml')
  if (!(field instanceof HTMLTextAreaElement)) return
  const lines = toml.split('\n')
  const start = lines.slice(0, line - 1).reduce((sum, text) => sum + text.length + 1, 0)
  field.focus({ preventScroll: true })
  field.setSelectionRange(start, start + (lines[line - 1]?.length ?? 0))
  const top = field.getBoundingClientRect().top + window.scrollY
  window.scrollTo({ top: top + (line / lines.length) * field.offsetHeight - window.innerHeight / 2 })
}

export function SpecEditor({ project, spec }: { project: Project; spec: Spec }) {
  const { id: projectId } = project
  const client = useQueryClient()
  const navigate = useNavigate()
  const { data: cues = NO_CUES } = useQuery(cuesQuery(projectId))
  const [draft, setDraft] = useState<SpecDraft>(() => keptDraft(projectId) ?? draftOf(spec))
  const [wasKept, setWasKept] = useState(() => keptDraft(projectId) !== null)
  const save = useSaveSpec(projectId)
  const changed = differs(draft, spec)
  const movedOn = spec.version !== draft.basedOn
  useEffect(() => keepDraft(projectId, changed ? draft : null), [projectId, draft, changed])
  // Nothing was written yet: the newer version is simply the one to write on.
  useEffect(() => {
    if (movedOn && !changed) setDraft((old) => ({ ...draftOf(spec, old.mode), note: old.note }))
  }, [movedOn, changed, spec])

  const sent = useMemo(() => written(draft), [draft])
  const [settled] = useDebouncedValue(sent, TRY_AFTER_MS)
  const isOwn = 'toml' in settled && settled.toml === spec.toml
  const tried = useSpecTry(projectId, settled, changed && !isOwn)
  const isCurrent = same(settled, sent) && !tried.isFetching && !tried.isPlaceholderData
  const trouble = troubleOf(changed ? (troubleOf(save.error) && save.error) || (isCurrent ? tried.error : null) : null)
  const result = changed ? (isCurrent && tried.data ? tried.data : null) : spec
  const mine = 'toml' in sent ? sent.toml : (tried.data?.toml ?? draft.from.toml)

  // A form is compared with what a form would write of the spec, or every comment would count as a change.
  const { data: plain } = useSpecTry(projectId, { tables: spec.tables }, changed && 'tables' in sent)
  const theirs = 'tables' in sent ? plain?.toml : spec.toml

  const change = (next: Partial<SpecDraft>) => {
    save.reset()
    setDraft((old) => ({ ...old, ...next }))
  }
  const changeTables = (change: (tables: Tables) => Tables) => {
    save.reset()
    setDraft((old) => ({ ...old, tables: change(old.tables) }))
  }
  const switchTo = (mode: SpecDraft['mode']) => {
    if (mode === draft.mode) return
    if (mode === 'toml') {
      change({ mode, toml: 'toml' in sent ? sent.toml : mine })
      return
    }
    const tables = draft.toml === spec.toml ? spec.tables : result?.tables
    if (tables === undefined) return
    change({ mode, tables, from: { toml: draft.toml, tables } })
  }
  const otherMode = draft.mode === 'form' ? 'TOML' : 'form'
  const maySwitch = !changed || result !== null

  const begin = (from: SpecDraft) => {
    save.reset()
    setWasKept(false)
    setDraft(from)
  }
  const drop = () => {
    const dropped = draft
    begin(draftOf(spec, draft.mode))
    showToast('Your changes were discarded.', () => begin(dropped))
  }
  const send = () => {
    if (!changed || save.isPending) return
    const before = spec
    save.mutate(
      { ...sent, note: draft.note, based_on_version: draft.basedOn },
      {
        onSuccess: (saved) => {
          keepDraft(projectId, null)
          showToast(`Version ${saved.version} of the spec saved. Affected versions are rechecked.`, async () => {
            await save.mutateAsync({
              toml: before.toml,
              note: `As version ${before.version}`,
              based_on_version: saved.version,
            })
          })
          void navigate({ to: '/projects/$projectId', params: { projectId } })
        },
        onError: (error) => {
          if (error instanceof ApiProblem && error.code === 'spec-changed') {
            void client.invalidateQueries({ queryKey: specQuery(projectId).queryKey })
          }
        },
      },
    )
  }
  useHotkeys([{ keys: 'mod+s', label: 'Save spec', group: 'Delivery spec', run: send }])

  const isMovedOn = save.error instanceof ApiProblem && save.error.code === 'spec-changed'
  const correction = trouble && draft.mode === 'toml' ? correctionOf(draft.toml, trouble.place, trouble.message) : null
  const line = trouble && draft.mode === 'toml' ? lineOf(draft.toml, trouble.place, trouble.message) : null
  return (
    <>
      <div className={classes.head}>
        <div>
          <h1>Delivery spec</h1>
          <p className="mid">
            {`Version ${draft.basedOn}${movedOn ? '' : `, ${shortDay(spec.created_at)}`} of `}
            <Link className="link" to="/projects/$projectId" params={{ projectId }}>
              {project.name}
            </Link>
          </p>
        </div>
        <div className="row wrap">
          <Link className="link" to="/projects/$projectId/spec/versions" params={{ projectId }} search={{}}>
            Versions
          </Link>
          <Segmented
            label="Edit as"
            options={[
              { value: 'form', label: 'Form' },
              { value: 'toml', label: 'TOML' },
            ]}
            value={draft.mode}
            onChange={(mode) => maySwitch && switchTo(mode)}
          />
        </div>
      </div>
      {wasKept && changed && (
        <p className={`row wrap ${classes.note}`}>
          Your unsaved changes were restored.
          <Button variant="quiet" onClick={drop}>
            Discard
          </Button>
        </p>
      )}
      {movedOn && changed && (
        <MovedOn
          spec={spec}
          theirs={theirs}
          mine={mine}
          basedOn={draft.basedOn}
          onKeepMine={() => change({ basedOn: spec.version })}
          onTakeTheirs={drop}
        />
      )}
      <div className={`columns ${classes.columns}`}>
        {draft.mode === 'form' ? (
          <Writing
            value={{
              tables: draft.tables,
              set: (place, value) => changeTables((tables) => put(tables, place, value)),
              change: changeTables,
              trouble,
            }}
          >
            <SpecForm cues={cues} />
          </Writing>
        ) : (
          <Card aria-labelledby="as-toml">
            <CardHead id="as-toml" title="spec.toml" note="the file audio-checks reads" />
            <TomlEditor toml={draft.toml} onChange={(toml) => change({ toml })} trouble={trouble} />
          </Card>
        )}
        <Card className={classes.save} aria-labelledby="save">
          <CardHead id="save" title="Save" end={changed ? undefined : 'no changes'} />
          <div className={classes.inside}>
            <div aria-live="polite" className={classes.stands}>
              {changed && !isCurrent && trouble === null && <p className="mid">Validating…</p>}
              {trouble && (
                <div className={`tone-bad ${classes.trouble}`} id="spec-trouble">
                  <Icon name="back" />
                  <div>
                    {trouble.place !== '' && <p className="mono strong toned">{trouble.place}</p>}
                    <p>{sentence(trouble.message)}</p>
                    <p className="row wrap">
                      {line !== null && (
                        <button type="button" className="link small" onClick={() => goToLine(draft.toml, line)}>
                          {`Line ${line}`}
                        </button>
                      )}
                      {draft.mode === 'form' && trouble.place !== '' && (
                        <button type="button" className="link small" onClick={() => goTo(trouble.place)}>
                          Go to line
                        </button>
                      )}
                      {correction && (
                        <button type="button" className="link" onClick={() => change({ toml: correction.toml })}>
                          {correction.label}
                        </button>
                      )}
                    </p>
                  </div>
                </div>
              )}
              {result && trouble === null && changed && (
                <p className={`row tone-ok ${classes.sign}`}>
                  <Icon name="tick" />
                  The spec is valid.
                </p>
              )}
              {result?.warnings.map((warning) => (
                <p key={warning} className={`row top tone-warn ${classes.sign}`}>
                  <Icon name="triangle" />
                  <span>{sentence(warning)}</span>
                </p>
              ))}
              {!maySwitch && trouble && <p className="small dim">{`Fix the error to switch to ${otherMode}.`}</p>}
            </div>
            {draft.mode === 'form' && 'tables' in sent && hasComments(draft.from.toml) && (
              <p className="small mid">The form rewrites the TOML without comments. Edit the TOML to keep them.</p>
            )}
            <Textarea
              label="Version note: what changed and why"
              rows={2}
              resize="vertical"
              value={draft.note}
              onChange={({ currentTarget }) => change({ note: currentTarget.value })}
            />
            {!isMovedOn && troubleOf(save.error) === null && <Refusal error={save.error} />}
            <div className="row wrap">
              <Button
                variant="primary"
                keys="mod+s"
                disabled={!changed || movedOn || save.isPending}
                aria-busy={save.isPending}
                onClick={send}
              >
                {`Save version ${spec.version + 1}`}
              </Button>
              {changed && (
                <Button variant="quiet" onClick={drop}>
                  Discard changes
                </Button>
              )}
            </div>
            {changed && movedOn && <p className="small mid">Choose above which text to keep.</p>}
            <p className="small dim">Affected versions in review are rechecked. Approved versions stay approved.</p>
          </div>
          {changed && result && theirs !== undefined && (
            <details className={classes.diff}>
              <summary>Changes</summary>
              <LineDiff before={theirs} after={mine} label="Changes" />
            </details>
          )}
        </Card>
      </div>
    </>
  )
}

interface MovedOnProps {
  spec: Spec
  /** Undefined while it is on its way. */
  theirs: string | undefined
  mine: string
  basedOn: number
  onKeepMine: () => void
  onTakeTheirs: () => void
}

/** Another person saved meanwhile: both texts are shown until one is chosen. */
function MovedOn({ spec, theirs, mine, basedOn, onKeepMine, onTakeTheirs }: MovedOnProps) {
  return (
    <Card className={classes.moved} aria-labelledby="moved">
      <CardHead id="moved" title={`${spec.author.name} saved version ${spec.version} while you were editing`} />
      <div className={classes.inside}>
        <p>
          {`You started from version ${basedOn}. Nothing you typed is lost.`}{' '}
          {spec.note !== '' && <span className="mid">{`Their note: ${sentence(spec.note)}`}</span>}
        </p>
        <div className="row wrap">
          <Button variant="primary" onClick={onKeepMine}>{`Keep mine and replace version ${spec.version}`}</Button>
          <Button onClick={onTakeTheirs}>{`Use version ${spec.version} and discard mine`}</Button>
        </div>
      </div>
      {theirs !== undefined && (
        <LineDiff before={theirs} after={mine} label={`Version ${spec.version} compared with yours`} />
      )}
    </Card>
  )
}
