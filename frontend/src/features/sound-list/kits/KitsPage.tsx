import { useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams, useSearch } from '@tanstack/react-router'
import { useEffect, useRef } from 'react'

import { kitsQuery } from '@/api/project'
import { DraftNote, useDraft } from '@/app/drafts'
import { useHotkeys } from '@/app/keys'
import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { figure, length, plural } from '@/ui/format'
import { KeysLine } from '@/ui/KeysLine'
import { PageHead } from '@/ui/PageHead'

import { type CueAdd, problemIn, useAddCues, useRights } from '../api'
import { type Kit, kitQuery, type KitRow, useUndoAddition } from './api'
import classes from './Kits.module.css'

const GROUP = 'Kit'

/** A list begun from the cues of a kind of game: strike out what is not wanted, add the rest in one act. */
export function KitsPage() {
  useTitle('Start from a kit')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/sound-list/kits' })
  const { kit: key } = useSearch({ from: '/shell/projects/$projectId/sound-list/kits' })
  const rights = useRights(projectId)
  const { data: kits, error } = useQuery(kitsQuery)
  const kit = kits?.find((candidate) => candidate.key === key)
  if (rights.known && !rights.edits) {
    return (
      <div className="page page-narrow">
        <EmptyState
          head="Only producers and audio leads add cues"
          level={1}
          action={
            <Link className="link" to="/projects/$projectId/sound-list" params={{ projectId }}>
              Back to the sound list
            </Link>
          }
        />
      </div>
    )
  }
  return (
    <div className="page stack" aria-busy={!kits && error === null}>
      <PageHead title={kit ? `${kit.name} kit` : 'Start from a kit'}>
        {kit
          ? 'Strike out what the game does not have. The rest is added at the end of the list.'
          : 'A kit has the cues that a game of its kind usually needs, described so that a designer can make them.'}{' '}
        <Link
          className="link"
          to={kit ? '/projects/$projectId/sound-list/kits' : '/projects/$projectId/sound-list'}
          params={{ projectId }}
          search={{}}
        >
          {kit ? 'All kits' : 'Back to the sound list'}
        </Link>
      </PageHead>
      <Refusal error={error} />
      {kits && !kit && <KitCards kits={kits} projectId={projectId} />}
      {kit && <ChosenKit key={kit.key} kit={kit} projectId={projectId} />}
    </div>
  )
}

const range = ({ low, high }: { low: number; high: number }) => `${figure(low)}–${figure(high)}`

/** A cue as it is added: a concept until the team has settled it. */
const cueOf = ({ name, file_name, category, description, use, duration_s, loop, variations }: KitRow): CueAdd => ({
  name,
  file_name,
  category,
  description,
  use,
  duration_s,
  loop,
  variations,
  trigger: '',
  length_locked: false,
  state: 'concept',
  need: 'must',
  placeholder: false,
  palette: false,
})

function Usual({ kit }: { kit: Kit }) {
  return (
    <p className="small mid">
      {`Usually ${range(kit.usual_cues)} cues, ${range(kit.usual_hours)} hours, ${range(kit.usual_memory_mb)} MB. These are guesses.`}
    </p>
  )
}

function KitCards({ kits, projectId }: { kits: readonly Kit[]; projectId: string }) {
  return (
    <ul className={`grid gap-4 ${classes.kits}`}>
      {kits.map((kit) => (
        <li key={kit.key}>
          <Card aria-labelledby={`kit-${kit.key}`} className={`grid gap-2 ${classes.kit}`}>
            <h2 id={`kit-${kit.key}`}>{kit.name}</h2>
            <p>{kit.about}</p>
            <p className="mid">{`${plural(kit.cues, 'cue')}, ${plural(kit.files, 'file')}`}</p>
            <Usual kit={kit} />
            <div>
              <Link
                className="link"
                to="/projects/$projectId/sound-list/kits"
                params={{ projectId }}
                search={{ kit: kit.key }}
                aria-label={`Look at its cues: ${kit.name}`}
              >
                Look at its cues
              </Link>
            </div>
          </Card>
        </li>
      ))}
    </ul>
  )
}

function ChosenKit({ kit, projectId }: { kit: Kit; projectId: string }) {
  const { data, error } = useQuery(kitQuery(projectId, kit.key))
  const [struck, setStruck, draft] = useDraft<string[]>(`kit:${projectId}:${kit.key}`, [])
  const add = useAddCues(projectId)
  const undo = useUndoAddition(projectId)
  const navigate = useNavigate()
  const table = useRef<HTMLTableElement>(null)
  const rows = data?.rows ?? []
  const isWanted = (row: KitRow) => !row.is_listed && !struck.includes(row.file_name)
  const chosen = rows.filter(isWanted)
  const strike = (names: readonly string[], isStruck: boolean) =>
    setStruck((now) => [...now.filter((name) => !names.includes(name)), ...(isStruck ? names : [])])
  const boxes = () => [...(table.current?.querySelectorAll<HTMLInputElement>('tbody input') ?? [])]
  const step = (by: 1 | -1) => {
    const all = boxes()
    const at = all.findIndex((box) => box === document.activeElement)
    all[at < 0 ? (by > 0 ? 0 : all.length - 1) : Math.min(all.length - 1, Math.max(0, at + by))]?.focus()
  }
  const toggle = () =>
    boxes()
      .find((box) => box === document.activeElement)
      ?.click()
  const { reset } = add
  useEffect(() => reset, [reset])
  const send = async () => {
    if (add.isPending || chosen.length === 0) return
    const added = await add.mutateAsync(chosen.map(cueOf)).catch((failure: unknown) => {
      if (problemIn(failure) === null) throw failure
      return null
    })
    if (added === null) return
    draft.discard()
    showToast(`${plural(added.length, 'cue')} added from the ${kit.name} kit.`, () => undo.mutateAsync(added))
    void navigate({ to: '/projects/$projectId/sound-list', params: { projectId } })
  }
  useHotkeys([
    { keys: 'j', label: 'Next cue', group: GROUP, run: () => step(1), repeats: true },
    { keys: 'k', label: 'Previous cue', group: GROUP, run: () => step(-1), repeats: true },
    { keys: 'x', label: 'Strike out or keep', group: GROUP, run: toggle },
    { keys: 'mod+Enter', label: 'Add the cues', group: GROUP, run: () => void send() },
  ])
  const categories = [...new Set(rows.map(({ category }) => category))]
  return (
    <>
      <Usual kit={kit} />
      <DraftNote draft={draft} />
      <Refusal error={error} />
      <Card aria-labelledby="kit-cues">
        <CardHead id="kit-cues" title="Cues" count={rows.length} note={`${chosen.length} will be added`} />
        <table ref={table} className={classes.table}>
          <thead className="visually-hidden">
            <tr>
              <th scope="col">Keep</th>
              <th scope="col">Cue</th>
              <th scope="col">Description</th>
              <th scope="col">Length and number</th>
            </tr>
          </thead>
          {categories.map((category) => {
            const own = rows.filter((row) => row.category === category)
            const names = own.filter((row) => !row.is_listed).map(({ file_name: name }) => name)
            const kept = own.filter(isWanted).length
            return (
              <tbody key={category}>
                <tr className={classes.group}>
                  <th scope="colgroup" colSpan={4}>
                    <span className="row between">
                      <span>{`${category} ${kept} of ${own.length}`}</span>
                      <button type="button" className="link small" onClick={() => strike(names, kept > 0)}>
                        {kept > 0 ? `Strike out all ${category}` : `Keep all ${category}`}
                      </button>
                    </span>
                  </th>
                </tr>
                {own.map((row) => (
                  <tr key={row.file_name} className={isWanted(row) ? undefined : 'dim'}>
                    <td>
                      <input
                        type="checkbox"
                        className={classes.tick}
                        aria-label={`Keep ${row.name}`}
                        checked={isWanted(row)}
                        disabled={row.is_listed}
                        onChange={({ currentTarget }) => strike([row.file_name], !currentTarget.checked)}
                      />
                    </td>
                    <th scope="row">
                      <span className={isWanted(row) ? undefined : 'struck'}>{row.name}</span>
                      <br />
                      <span className="small mono dim">{row.is_listed ? 'on the list already' : row.file_name}</span>
                    </th>
                    <td className={classes.words}>
                      {row.description} <span className="mid">{row.use}.</span>
                    </td>
                    <td className="small mid nowrap">
                      {`${length(row.duration_s)}${row.loop ? ', loop' : ''}${row.variations > 1 ? ` × ${row.variations}` : ''}`}
                    </td>
                  </tr>
                ))}
              </tbody>
            )
          })}
        </table>
      </Card>
      <div className={`flex wrap items-center gap-3 sticky bottom-0 ${classes.foot}`}>
        <Refusal error={add.error} />
        <span className="wide-only">
          <KeysLine
            keys={[
              { keys: ['j', 'k'], label: 'next cue' },
              { keys: ['x'], label: 'strike out' },
            ]}
          />
        </span>
        <Button
          variant="primary"
          keys="mod+Enter"
          className="end"
          disabled={chosen.length === 0}
          aria-busy={add.isPending}
          onClick={() => void send()}
        >
          {chosen.length === 0 ? 'Add cues' : `Add ${plural(chosen.length, 'cue')}`}
        </Button>
      </div>
    </>
  )
}
