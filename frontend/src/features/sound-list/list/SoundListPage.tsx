import { useQuery } from '@tanstack/react-query'
import { listQuery } from '@/api/soundList'
import { useNavigate, useParams, useSearch } from '@tanstack/react-router'
import { type ReactNode, useCallback, useDeferredValue, useMemo, useRef, useState } from 'react'

import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { useTakePlayer } from '@/heard/useTakePlayer'
import { Button } from '@/ui/Button'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'

import {
  countsQuery,
  type Cue,
  openQuestionsQuery,
  progressQuery,
  unmatchedQuery,
  useChangeCue,
  useRights,
} from '../api'
import { clarityQuery } from '../clarity'
import { columnsQuery, type OwnColumn } from '../columns/api'
import { nextNeed } from '../need'
import { type CuePerson, cuePeopleQuery, namesOf } from '../people'
import { categoriesOf, type CueRow, groupsOf, type ListSearch, matching, needSumsOf, rowsOf, sumsOf } from '../rows'
import { AddCues } from './AddCues'
import { CuePanel, type PanelKind } from './CuePanel'
import { CueTable } from './CueTable'
import { EmptyList } from './EmptyList'
import { ListFoot } from './ListFoot'
import { ListHead } from './ListHead'
import { ListTools, type ToolsPanel } from './ListTools'
import { PickedBar } from './PickedBar'
import classes from './SoundList.module.css'
import { useCueSelection } from './useCueSelection'
import { useListKeys } from './useListKeys'
import { usePastedRows } from './usePastedRows'

const NO_CUES: Cue[] = []
const NO_COLUMNS: OwnColumn[] = []
const NO_PEOPLE: CuePerson[] = []

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
  const { data: unclear } = useQuery(clarityQuery(projectId))
  const { data: own } = useQuery(columnsQuery(projectId))
  const { data: people = NO_PEOPLE } = useQuery(cuePeopleQuery(projectId))
  const change = useChangeCue(projectId)
  const [player, playing] = useTakePlayer(projectId)

  const [adding, setAdding] = useState<{ name?: string } | null>(null)
  const [panel, setPanel] = useState<{ id: string; kind: PanelKind } | null>(null)
  const isFiltered = [
    search.state,
    search.category,
    search.need,
    search.phase,
    search.person,
    search.unclear,
    search.heard,
  ].some(Boolean)
  const [tools, setTools] = useState<ToolsPanel | null>(isFiltered ? 'filter' : null) // a filter that is on is in sight
  const chips = useRef<HTMLDivElement>(null)
  const filter = useRef<HTMLInputElement>(null)

  const cues = list.data?.cues ?? NO_CUES
  const rows = useMemo(
    () => rowsOf(cues, { progressList: progress.data, questions, unmatched, unclear }),
    [cues, progress.data, questions, unmatched, unclear],
  )
  const categories = useMemo(() => categoriesOf(rows), [rows])
  const needs = useMemo(() => needSumsOf(rows), [rows])
  const { state, category, need, phase, person, view, by = 'list', unclear: onlyUnclear, heard, q: words = '' } = search
  const sought = useDeferredValue(words)
  const playedId = heard && playing.takeId
  const groups = useMemo(
    () =>
      groupsOf(
        matching(rows, { state, category, need, phase, person, unclear: onlyUnclear, heard, playedId, words: sought }),
        by,
      ),
    [rows, state, category, need, phase, person, onlyUnclear, heard, playedId, sought, by],
  )
  const shown = useMemo(() => groups.flatMap((group) => group.rows), [groups])
  const { selected, selectedId, select, step, picked, pick, unpick } = useCueSelection(projectId, shown)

  const play = useCallback(
    (row: CueRow) => {
      const take = row.progress?.newest_take
      if (!take || row.previewUrl === null) return
      if (player.getState().sourceId === take.id) {
        void player.toggle()
        return
      }
      player.setLooping(row.cue.loop)
      void player.select({ id: take.id, takeId: take.id, url: row.previewUrl })
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
  const clarify = useCallback((id: string) => {
    setAdding(null)
    setPanel({ id, kind: 'clarify' })
  }, [])
  const changeNeed = ({ cue }: CueRow) => {
    if (change.isPending) return
    const newNeed = nextNeed(cue.need)
    const put = (edition: number, to: Cue['need']) =>
      change.mutateAsync({ cueId: cue.id, edition, facts: { need: to } })
    void put(cue.edition, newNeed).then(
      (saved) =>
        showToast(`${cue.name} is a ${newNeed}.`, async () => {
          await put(saved.edition, cue.need)
        }),
      () => undefined, // the refusal is shown above the list
    )
  }
  const closePanel = useCallback(() => {
    setPanel(null)
    if (selectedId === null) return
    requestAnimationFrame(() =>
      document.querySelector<HTMLElement>(`tr[data-row="${selectedId}"]`)?.focus({ preventScroll: true }),
    )
  }, [selectedId])
  const clear = () => {
    if (
      [state, category, need, phase, person, heard].some((filter) => filter !== undefined) ||
      onlyUnclear ||
      words !== ''
    )
      onSearch({
        state: undefined,
        category: undefined,
        need: undefined,
        phase: undefined,
        person: undefined,
        unclear: undefined,
        heard: undefined,
        q: undefined,
      })
  }
  const escape = () => {
    if (panel) closePanel()
    else if (adding) setAdding(null)
    else if (picked.size > 0) unpick()
    else {
      filter.current?.blur()
      clear()
    }
  }
  useListKeys({
    selected,
    mayEdit: rights.edits,
    add: () => add(),
    addSought: () => add(shown.length === 0 ? words : undefined),
    toImport,
    openCue,
    openPanel,
    changeNeed,
    pick,
    play,
    step,
    toFilter: () => filter.current?.focus(),
    toStates: () => {
      setTools('filter')
      requestAnimationFrame(() => toNextChip(chips.current))
    },
    escape,
  })
  usePastedRows(projectId, rights.edits, toImport)

  const pickedCues = useMemo(() => rows.filter(({ id }) => picked.has(id)).map(({ cue }) => cue), [rows, picked])
  const openRow = panel && rows.find(({ id }) => id === panel.id)
  const playingTake = playing.status === 'playing' || playing.status === 'loading' ? playing.sourceId : null
  const playingId = rows.find(({ progress: of }) => playingTake !== null && of?.newest_take?.id === playingTake)?.id
  const names = useMemo(() => namesOf(people), [people])
  const named = cues.some((cue) => cue.implementer_id !== null || cue.recorder_id !== null)
  const isEmpty = list.isSuccess && cues.length === 0

  return (
    <div className={`page ${classes.page}`}>
      <ListHead projectId={projectId} list={list.data} mayEdit={rights.edits} needs={needs} />
      <Refusal
        error={list.error ?? progress.error ?? change.error}
        action={
          <button
            type="button"
            className="link"
            onClick={() => {
              change.reset()
              void Promise.all([list.refetch(), progress.refetch()])
            }}
          >
            Try again
          </button>
        }
      />
      {picked.size > 0 ? (
        <PickedBar projectId={projectId} cues={pickedCues} categories={categories} people={people} onClear={unpick} />
      ) : (
        cues.length > 0 && (
          <ListTools
            projectId={projectId}
            rows={rows}
            categories={categories}
            people={people}
            search={search}
            words={words}
            chips={chips}
            filter={filter}
            mayEdit={rights.edits}
            shown={tools}
            onShown={setTools}
            onAdd={() => add()}
            onImport={toImport}
            onSearch={onSearch}
            onWords={(typed) => onSearch({ q: typed || undefined })}
            onView={(view) =>
              void navigate({ to: '/projects/$projectId/sound-list', params: { projectId }, search: view })
            }
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
      {isEmpty && !adding && <EmptyList mayEdit={rights.edits} onImport={toImport} />}
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
          people={view === 'content' && named ? names : null}
          columns={view === 'content' ? (own?.columns ?? NO_COLUMNS) : null}
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
                      unclear={openRow.unclear}
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
          onClarify={rights.edits ? clarify : undefined}
        />
      )}
      {cues.length > 0 && (
        <ListFoot mayEdit={rights.edits} error={playing.error} sums={sumsOf(rows, counts?.files_to_review ?? 0)} />
      )}
    </div>
  )
}

/** Focus the next of the buttons that filter by state; from anywhere else, the one that is pressed. */
function toNextChip(chips: HTMLElement | null): void {
  const all = [...(chips?.querySelectorAll<HTMLElement>('button') ?? [])]
  const focused = all.findIndex((chip) => chip === document.activeElement)
  const pressed = all.findIndex((chip) => chip.getAttribute('aria-pressed') === 'true')
  const next = all[focused < 0 ? pressed : (focused + 1) % all.length]
  next?.focus()
  next?.scrollIntoView({ block: 'nearest', inline: 'nearest' })
}
