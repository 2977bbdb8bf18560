import { Link } from '@tanstack/react-router'
import { type RefObject } from 'react'

import { Views } from '@/shares'
import { Button, ButtonLink } from '@/ui/Button'
import { Count } from '@/ui/Count'
import { FilterChip } from '@/ui/FilterChip'
import { Icon } from '@/ui/Icon'
import { Key } from '@/ui/Key'
import { Segmented } from '@/ui/Segmented'

import type { CueStatus } from '../api'
import { type CuePerson, readPersonFilter, TASKS } from '../people'
import { type CueRow, type Grouping, kindOf, type ListSearch } from '../rows'
import classes from './SoundList.module.css'
import { ToolSelect } from './ToolSelect'
import { PHASES } from '@/phases'
import { NEEDS, STATUS_ORDER, STATUS_WORDS } from '../words'

const GROUPINGS: readonly { value: Grouping; label: string }[] = [
  { value: 'list', label: 'List order' },
  { value: 'category', label: 'By category' },
  { value: 'state', label: 'By state' },
  { value: 'priority', label: 'By playback priority' },
]

export type ToolsPanel = 'filter' | 'display' | 'more'

interface ListToolsProps {
  projectId: string
  rows: readonly CueRow[]
  categories: readonly string[]
  people: readonly CuePerson[]
  search: ListSearch
  words: string
  chips: RefObject<HTMLDivElement | null>
  filter: RefObject<HTMLInputElement | null>
  onSearch: (change: ListSearch) => void
  onWords: (words: string) => void
  mayEdit: boolean
  /** The line that is open below the first one. */
  shown: ToolsPanel | null
  onShown: (panel: ToolsPanel | null) => void
  onAdd: () => void
  onImport: () => void
  /** Show the list by a filter that was kept, and by nothing else. */
  onView: (search: ListSearch) => void
}

/** One line: search, Filter, Display, More, Add; what a button holds opens below it. */
export function ListTools({
  projectId,
  rows,
  categories,
  people,
  search,
  words,
  chips,
  filter,
  onSearch,
  onWords,
  mayEdit,
  shown,
  onShown,
  onAdd,
  onImport,
  onView,
}: ListToolsProps) {
  const counts = new Map<CueStatus, number>()
  for (const { status } of rows) counts.set(status, (counts.get(status) ?? 0) + 1)
  const unclear = rows.filter((row) => row.unclear.length > 0).length
  const unheard = rows.filter(({ isUnheard }) => isUnheard).length
  const filters = [
    search.state,
    search.category,
    search.need,
    search.phase,
    search.person,
    search.unclear,
    search.heard,
  ].filter(Boolean).length
  const toggle = (panel: ToolsPanel) => onShown(shown === panel ? null : panel)
  const list = `/projects/${projectId}/sound-list`
  return (
    <>
      <div className={`row ${classes.tools}`}>
        <label
          className={`inline-flex items-center gap-6px bg-raised mid min-h-28px border-edge rounded narrow-min-h-44px ${classes.find}`}
        >
          <Icon name="search" />
          <span className="visually-hidden">Search the list</span>
          <input
            ref={filter}
            type="search"
            placeholder="Search"
            aria-keyshortcuts="/"
            value={words}
            onChange={(event) => onWords(event.currentTarget.value)}
          />
          {words === '' && <Key keys="/" />}
        </label>
        <Button
          aria-expanded={shown === 'filter'}
          aria-label={filters > 0 ? `Filter, ${filters} on` : undefined}
          onClick={() => toggle('filter')}
        >
          Filter {filters > 0 && <Count of={filters} />}
        </Button>
        <Button aria-expanded={shown === 'display'} onClick={() => toggle('display')}>
          Display
        </Button>
        <Button className="end" icon="more" aria-expanded={shown === 'more'} onClick={() => toggle('more')}>
          More
        </Button>
        {mayEdit && (
          <Button variant="primary" icon="plus" keys="n" onClick={onAdd}>
            Add a cue
          </Button>
        )}
      </div>
      {shown === 'filter' && (
        <div className={`row ${classes.tools}`} role="group" aria-label="Filter">
          <div
            className={`flex flex-1 min-w-0 overflow-x-auto ${classes.chips}`}
            role="group"
            aria-label="Filter by state"
            ref={chips}
          >
            <FilterChip
              count={rows.length}
              pressed={search.state === undefined}
              onPress={() => onSearch({ state: undefined })}
            >
              All
            </FilterChip>
            {(unheard > 0 || search.heard) && (
              <FilterChip
                count={unheard}
                pressed={search.heard === 'no'}
                onPress={() => onSearch({ heard: search.heard ? undefined : 'no' })}
              >
                Not heard yet
              </FilterChip>
            )}
            {STATUS_ORDER.filter((status) => counts.has(status) || search.state === status).map((status) => (
              <FilterChip
                key={status}
                kind={kindOf(status)}
                count={counts.get(status) ?? 0}
                pressed={search.state === status}
                onPress={() => onSearch({ state: search.state === status ? undefined : status })}
              >
                {STATUS_WORDS[status]}
              </FilterChip>
            ))}
            {(unclear > 0 || search.unclear) && (
              <FilterChip
                kind="question"
                count={unclear}
                pressed={search.unclear === true}
                onPress={() => onSearch({ unclear: search.unclear ? undefined : true })}
              >
                Unclear
              </FilterChip>
            )}
          </div>
          <div className={`row flex-none narrow-w-full ${classes.ends}`}>
            <ToolSelect
              label="Category"
              value={search.category ?? ''}
              blank="All categories"
              options={categories.map((category) => ({ value: category, label: category }))}
              onChoose={(value) => onSearch({ category: value || undefined })}
            />
            <ToolSelect
              label="Need"
              value={search.need ?? ''}
              blank="Any need"
              options={NEEDS}
              onChoose={(chosen) => onSearch({ need: NEEDS.find(({ value }) => value === chosen)?.value })}
            />
            {(search.phase !== undefined || rows.some(({ cue }) => cue.phase !== null)) && (
              <ToolSelect
                label="Phase"
                value={search.phase ?? ''}
                blank="Any phase"
                options={PHASES}
                onChoose={(chosen) => onSearch({ phase: PHASES.find(({ value }) => value === chosen)?.value })}
              />
            )}
            {(search.person !== undefined ||
              rows.some(({ cue }) => cue.implementer_id !== null || cue.recorder_id !== null)) && (
              <ToolSelect
                label="Person"
                value={search.person ?? ''}
                blank="Any person"
                onChoose={(value) => onSearch({ person: readPersonFilter(value) })}
              >
                {TASKS.map(({ task, label }) => (
                  <optgroup key={task} label={label}>
                    {people.map(({ id, name }) => (
                      <option key={id} value={`${task}:${id}`}>
                        {name}
                      </option>
                    ))}
                    <option value={`${task}:none`}>No one</option>
                  </optgroup>
                ))}
              </ToolSelect>
            )}
          </div>
        </div>
      )}
      {shown === 'display' && (
        <div className={`row ${classes.tools}`} role="group" aria-label="Display">
          <Segmented
            label="Columns shown"
            value={search.view ?? 'state'}
            onChange={(view) => onSearch({ view: view === 'content' ? view : undefined })}
            options={[
              { value: 'state', label: 'State' },
              { value: 'content', label: 'Content' },
            ]}
          />
          <ToolSelect
            label="Group by"
            value={search.by ?? 'list'}
            options={GROUPINGS}
            onChoose={(value) => onSearch({ by: value === 'list' ? undefined : (value as Grouping) })}
          />
          <Views projectId={projectId} search={search} onOpen={(view) => onView(view)} />
          {mayEdit && (
            <ButtonLink component={Link} to={`${list}/columns`}>
              Columns
            </ButtonLink>
          )}
        </div>
      )}
      {shown === 'more' && (
        <div className={`row ${classes.tools} wrap`} role="group" aria-label="More">
          {mayEdit && (
            <>
              <Button keys="i" onClick={onImport}>
                Paste or import
              </Button>
              <ButtonLink component={Link} to={`${list}/kits`}>
                Start from a kit
              </ButtonLink>
              <ButtonLink component={Link} to={`${list}/adopt`}>
                Import existing game audio
              </ButtonLink>
            </>
          )}
          <ButtonLink component={Link} to={`${list}/compare`}>
            Compare revisions
          </ButtonLink>
          <ButtonLink icon="download" href={`/v1${list}.csv`}>
            CSV
          </ButtonLink>
          <ButtonLink icon="download" href={`/v1${list}.xlsx`}>
            XLSX
          </ButtonLink>
        </div>
      )}
    </>
  )
}
