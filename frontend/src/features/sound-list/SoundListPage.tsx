import { useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams, useSearch } from '@tanstack/react-router'
import { type ReactNode, useCallback, useDeferredValue, useEffect, useMemo, useRef, useState } from 'react'

import { type Hotkey, useHotkeys } from '@/app/keys'
import { useCommands } from '@/app/palette'
import { useTitle } from '@/app/title'
import { usePlayer } from '@/audio'
import { Button, ButtonLink } from '@/ui/Button'
import { EmptyState } from '@/ui/EmptyState'
import { plural } from '@/ui/format'
import { KeysLine } from '@/ui/KeysLine'
import { ProblemNote } from '@/ui/ProblemNote'

import { AddCues } from './AddCues'
import {
  compareQuery,
  countsQuery,
  type Cue,
  listQuery,
  openQuestionsQuery,
  problemIn,
  progressQuery,
  unmatchedQuery,
  useRights,
} from './api'
import { CuePanel, type PanelKind } from './CuePanel'
import { CueTable } from './CueTable'
import { keepLastCue, lastCue } from './lastCue'
import { ListTools } from './ListTools'
import { EMPTY_SHEET, keepSheet } from './pasted'
import { PickedBar } from './PickedBar'
import { categoriesOf, type CueRow, groupsOf, type ListSearch, matching, rowsOf, sumsOf } from './rows'
import classes from './SoundList.module.css'

const NO_CUES: Cue[] = []
const NONE: ReadonlySet<string> = new Set()

const LIST = 'List'

/** The sound list: every cue on one line, and everything that is done to it in place. */
export function SoundListPage(): ReactNode {
  const { projectId = '' } = useParams({ strict: false })
  const search: ListSearch = useSearch({ strict: false })
  const navigate = useNavigate()
  useTitle('Sound list')
  const rights = useRights(projectId)
  const list = useQuery(listQuery(projectId))
  const progress = useQuery(progressQuery(projectId))
  const { data: counts } = useQuery(countsQuery(projectId))
  const { data: questions } = useQuery(openQuestionsQuery(projectId))
  const { data: unmatched } = useQuery(unmatchedQuery(projectId))
  const [player, playing] = usePlayer()

  const [adding, setAdding] = useState<{ name?: string } | null>(null)
  const [panel, setPanel] = useState<{ id: string; kind: PanelKind } | null>(null)
  const [picked, setPicked] = useState<ReadonlySet<string>>(NONE)
  const [anchor, setAnchor] = useState<string | null>(null)
  const [selectedId, setSelectedOnly] = useState(() => lastCue(projectId))
  const chips = useRef<HTMLDivElement>(null)
  const filter = useRef<HTMLInputElement>(null)

  const cues = list.data?.cues ?? NO_CUES
  const rows = useMemo(
    () => rowsOf(cues, { progressList: progress.data, questions, unmatched }),
    [cues, progress.data, questions, unmatched],
  )
  const categories = useMemo(() => categoriesOf(rows), [rows])
  const { state, category, by = 'list', q: words = '' } = search
  const sought = useDeferredValue(words)
  const groups = useMemo(
    () => groupsOf(matching(rows, { state, category, words: sought }), by),
    [rows, state, category, sought, by],
  )
  const shown = useMemo(() => groups.flatMap((group) => group.rows), [groups])
  const at = shown.findIndex(({ id }) => id === selectedId)
  const selected = shown[at]

  const select = useCallback(
    (id: string) => {
      keepLastCue(projectId, id)
      setSelectedOnly(id)
    },
    [projectId],
  )
  const step = (by: 1 | -1) => {
    const to = shown[at < 0 ? (by > 0 ? 0 : shown.length - 1) : Math.min(shown.length - 1, Math.max(0, at + by))]
    if (to) select(to.id)
  }
  const pick = useCallback(
    (id: string, extend: boolean) => {
      select(id)
      const from = extend ? shown.findIndex((row) => row.id === anchor) : -1
      const to = shown.findIndex((row) => row.id === id)
      setPicked((before) => {
        const after = new Set(before)
        if (from >= 0) {
          for (const row of shown.slice(Math.min(from, to), Math.max(from, to) + 1)) after.add(row.id)
        } else if (!after.delete(id)) after.add(id)
        return after
      })
      setAnchor(id)
    },
    [select, shown, anchor],
  )
  const play = useCallback(
    (row: CueRow) => {
      const take = row.progress?.newest_take
      if (!take || row.previewUrl === null) return
      if (player.getState().sourceId === take.id) {
        void player.toggle()
        return
      }
      player.setLooping(row.cue.loop)
      void player.select({ id: take.id, url: row.previewUrl })
      void player.play(0)
    },
    [player],
  )

  const onSearch = (change: ListSearch) =>
    void navigate({
      to: '/projects/$projectId/sound-list',
      params: { projectId },
      search: { ...search, ...change },
      replace: true,
      resetScroll: false,
    })
  const openCue = (row: CueRow) =>
    void navigate({ to: '/projects/$projectId/sound-list/cues/$cueId', params: { projectId, cueId: row.id } })
  const toImport = useCallback(
    () => void navigate({ to: '/projects/$projectId/sound-list/import', params: { projectId } }),
    [navigate, projectId],
  )
  const add = (name?: string) => {
    setPanel(null)
    setAdding({ name })
    window.scrollTo({ top: 0 })
  }
  const openPanel = (kind: PanelKind) => {
    if (selected === undefined) return
    setAdding(null)
    setPanel({ id: selected.id, kind })
  }
  const closePanel = useCallback(() => {
    setPanel(null)
    if (selectedId === null) return
    requestAnimationFrame(() =>
      document.querySelector<HTMLElement>(`tr[data-row="${selectedId}"]`)?.focus({ preventScroll: true }),
    )
  }, [selectedId])
  const clear = () => {
    if (state !== undefined || category !== undefined || words !== '')
      onSearch({ state: undefined, category: undefined, q: undefined })
  }
  const escape = () => {
    if (panel) closePanel()
    else if (adding) setAdding(null)
    else if (picked.size > 0) setPicked(NONE)
    else {
      filter.current?.blur()
      clear()
    }
  }
  const toChips = () => {
    const all = [...(chips.current?.querySelectorAll<HTMLElement>('button') ?? [])]
    const focused = all.findIndex((chip) => chip === document.activeElement)
    const pressed = all.findIndex((chip) => chip.getAttribute('aria-pressed') === 'true')
    const next = all[focused < 0 ? pressed : (focused + 1) % all.length]
    next?.focus()
    next?.scrollIntoView({ block: 'nearest', inline: 'nearest' })
  }

  const isCut = selected?.status === 'cut'
  const editing: Hotkey[] = [
    { keys: 'n', label: 'Add a cue', group: LIST, run: () => add(shown.length === 0 ? words : undefined) },
    { keys: 'e', label: 'Edit', group: LIST, run: () => openPanel('edit'), disabled: !selected || isCut },
    { keys: 'i', label: 'Paste or import', group: LIST, run: toImport },
    { keys: 'x', label: 'Select', group: LIST, run: () => selected && pick(selected.id, false), disabled: !selected },
    {
      keys: 'shift+x',
      label: 'Select range to here',
      group: LIST,
      run: () => selected && pick(selected.id, true),
      disabled: !selected,
    },
  ]
  useHotkeys([
    { keys: 'Escape', label: 'Close or clear filters', group: LIST, run: escape },
    { keys: 'j', label: 'Next', group: LIST, run: () => step(1), repeats: true },
    { keys: 'k', label: 'Previous', group: LIST, run: () => step(-1), repeats: true },
    { keys: 'Enter', label: 'Open', group: LIST, run: () => selected && openCue(selected), disabled: !selected },
    {
      keys: 'Space',
      label: 'Play',
      group: LIST,
      run: () => selected && play(selected),
      disabled: !selected?.previewUrl,
    },
    { keys: '/', label: 'Filter', group: LIST, run: () => filter.current?.focus() },
    { keys: 'f', label: 'Filter by state', group: LIST, run: toChips },
    { keys: 'q', label: 'Ask a question', group: LIST, run: () => openPanel('ask'), disabled: !selected },
    ...(rights.edits ? editing : []),
  ])
  useCommands([
    ...(rights.edits
      ? [
          { id: 'add-cue', label: 'Add a cue', icon: 'plus' as const, keys: 'n', run: () => add() },
          { id: 'import', label: 'Paste or import', icon: 'upload' as const, keys: 'i', run: toImport },
        ]
      : []),
    ...(selected && rights.edits && !isCut
      ? [
          {
            id: 'edit-cue',
            label: `Edit ${selected.cue.name}`,
            icon: 'pencil' as const,
            keys: 'e',
            run: () => openPanel('edit'),
          },
        ]
      : []),
    ...(selected
      ? [
          {
            id: 'ask-cue',
            label: `Ask about ${selected.cue.name}`,
            icon: 'question' as const,
            keys: 'q',
            run: () => openPanel('ask'),
          },
        ]
      : []),
  ])

  useEffect(() => {
    if (!rights.edits) return
    const paste = (event: ClipboardEvent) => {
      if (event.target instanceof HTMLElement && event.target.closest('input, textarea, select, [contenteditable]'))
        return
      const text = event.clipboardData?.getData('text/plain') ?? ''
      if (text.trim() === '') return
      event.preventDefault()
      keepSheet(projectId, { ...EMPTY_SHEET, text }, true)
      toImport()
    }
    window.addEventListener('paste', paste)
    return () => window.removeEventListener('paste', paste)
  }, [rights.edits, projectId, toImport])

  const revision = list.data?.revision ?? 0
  const refused = problemIn(list.error) ?? problemIn(progress.error)
  const pickedCues = useMemo(() => rows.filter(({ id }) => picked.has(id)).map(({ cue }) => cue), [rows, picked])
  const openRow = panel && rows.find(({ id }) => id === panel.id)
  const playingTake = playing.status === 'playing' || playing.status === 'loading' ? playing.sourceId : null
  const playingId = rows.find(({ progress: of }) => playingTake !== null && of?.newest_take?.id === playingTake)?.id
  const csv = `/v1/projects/${projectId}/sound-list.csv`
  const isEmpty = list.isSuccess && cues.length === 0

  return (
    <div className={`page ${classes.page}`}>
      <header className={classes.top}>
        <div className={classes.title}>
          <h1>Sound list</h1>
          {list.data && (
            <span className="mid">
              {plural(cues.length, 'cue')}, revision {revision}
            </span>
          )}
          {revision > 1 && <LastChange projectId={projectId} revision={revision} />}
        </div>
        {!isEmpty && (
          <div className={`${classes.acts} wide-only`}>
            <ButtonLink variant="quiet" icon="download" href={csv}>
              CSV
            </ButtonLink>
            {rights.edits && (
              <Button keys="i" onClick={toImport}>
                Paste or import
              </Button>
            )}
            <CompareLink projectId={projectId} />
            {rights.edits && (
              <Button variant="primary" icon="plus" keys="n" onClick={() => add()}>
                Add a cue
              </Button>
            )}
          </div>
        )}
      </header>
      {refused && (
        <ProblemNote
          detail={refused.detail}
          fix={refused.fix}
          action={
            <button
              type="button"
              className="link"
              onClick={() => void Promise.all([list.refetch(), progress.refetch()])}
            >
              Try again
            </button>
          }
        />
      )}
      {picked.size > 0 ? (
        <PickedBar projectId={projectId} cues={pickedCues} categories={categories} onClear={() => setPicked(NONE)} />
      ) : (
        cues.length > 0 && (
          <ListTools
            rows={rows}
            categories={categories}
            search={search}
            words={words}
            chips={chips}
            filter={filter}
            onSearch={onSearch}
            onWords={(typed) => onSearch({ q: typed || undefined })}
          />
        )
      )}
      {adding && (
        <AddCues
          key={adding.name}
          projectId={projectId}
          categories={categories}
          name={adding.name}
          onAdded={(added) => {
            setAdding(null)
            if (added[0]) select(added[0].id)
          }}
          onClose={() => setAdding(null)}
        />
      )}
      {isEmpty && !adding && (
        <EmptyState
          head="The sound list is empty"
          action={
            rights.edits && (
              <>
                <Button variant="primary" icon="plus" keys="n" onClick={() => add()}>
                  Add a cue
                </Button>
                <Button keys="i" onClick={toImport}>
                  Paste or import
                </Button>
              </>
            )
          }
        >
          {rights.edits
            ? 'Type the first cues (only a name is required), paste rows from a spreadsheet with Ctrl V, or import a CSV or XLSX file.'
            : 'The team has not added any cues yet.'}
        </EmptyState>
      )}
      {cues.length > 0 && shown.length === 0 && (
        <EmptyState
          head={sought ? `No cue matches “${sought}”.` : 'No cue is in this state.'}
          action={
            <>
              <Button keys="Escape" onClick={clear}>
                Show all {cues.length}
              </Button>
              {sought && rights.edits && <Button onClick={() => add(sought)}>Add a cue named {sought}</Button>}
            </>
          }
        />
      )}
      {shown.length > 0 && (
        <CueTable
          groups={groups}
          projectId={projectId}
          selectedId={selectedId}
          picked={picked}
          mayPick={rights.edits}
          playingId={playingId ?? null}
          open={
            openRow && panel
              ? {
                  id: panel.id,
                  inside: (
                    <CuePanel
                      key={`${panel.id} ${panel.kind}`}
                      kind={panel.kind}
                      cue={openRow.cue}
                      projectId={projectId}
                      categories={categories}
                      rights={rights}
                      onKind={(kind) => setPanel({ id: panel.id, kind })}
                      onClose={closePanel}
                    />
                  ),
                }
              : null
          }
          onSelect={select}
          onPick={pick}
          onPlay={play}
        />
      )}
      {cues.length > 0 && (
        <footer className={classes.foot}>
          <KeysLine
            keys={[
              { keys: ['j', 'k'], label: 'move' },
              { keys: ['Space'], label: 'play' },
              { keys: ['Enter'], label: 'open' },
              ...(rights.edits
                ? [
                    { keys: ['e'], label: 'edit' },
                    { keys: ['x'], label: 'select' },
                  ]
                : []),
              { keys: ['q'], label: 'ask a question' },
              { keys: ['f'], label: 'filter by state' },
            ]}
          />
          {playing.error && (
            <p role="alert" className="small tone-bad toned">
              {playing.error}
            </p>
          )}
          <p className="small dim">{sumsOf(rows, counts?.files_to_review ?? 0)}</p>
        </footer>
      )}
      {!isEmpty && (
        <div className="narrow-only">
          <div className={classes.narrowActs}>
            {rights.edits && (
              <>
                <Button variant="primary" icon="plus" onClick={() => add()}>
                  Add a cue
                </Button>
                <Button onClick={toImport}>Paste or import</Button>
              </>
            )}
            <CompareLink projectId={projectId} />
            <ButtonLink icon="download" href={csv}>
              CSV
            </ButtonLink>
          </div>
        </div>
      )}
    </div>
  )
}

function CompareLink({ projectId }: { projectId: string }) {
  return (
    <ButtonLink component={Link} to={`/projects/${projectId}/sound-list/compare`}>
      Compare revisions
    </ButtonLink>
  )
}

function LastChange({ projectId, revision }: { projectId: string; revision: number }) {
  const { data } = useQuery(compareQuery(projectId, revision - 1, revision))
  if (data === undefined) return null
  const lines = data.added.length + data.changed.length + data.cut.length
  return (
    <Link
      className="link mid wide-only"
      to="/projects/$projectId/sound-list/compare"
      params={{ projectId }}
      search={{ from: revision - 1, to: revision }}
    >
      {plural(lines, 'line')} changed since revision {revision - 1}
    </Link>
  )
}
