import { useQuery } from '@tanstack/react-query'
import { useNavigate } from '@tanstack/react-router'
import { useState } from 'react'

import { categoriesQuery, projectQuery } from '@/api/project'
import { useHotkeys } from '@/app/keys'
import { filterOf, isFiltered, type QueueFilter } from '@/verdicts/queueFilter'
import { Views } from '@/shares'
import { Button } from '@/ui/Button'
import { Select } from '@/ui/Select'
import { useFocusOnMount } from '@/ui/useFocusOnMount'

import classes from './QueueFilters.module.css'

interface QueueFiltersProps {
  projectId: string
  cueId: string
  filter: QueueFilter
  onClose: () => void
}

const NEEDS = { must: 'Must', should: 'Should', wish: 'Wish' }
const KINDS = { single: 'One version', alternates: 'Alternates', set: 'A set' }
const HEARD = { no: 'Not heard by you' }
const VERSIONS = { first: 'First version', new: 'New version after a change' }

/** What of the queue is shown; it stands in the address, and the team shares what it saves as views. */
export function QueueFilters({ projectId, cueId, filter, onClose }: QueueFiltersProps) {
  const navigate = useNavigate()
  const { data: categories = [] } = useQuery(categoriesQuery(projectId))
  const { data: project } = useQuery(projectQuery(projectId))
  const [words, setWords] = useState(filter.q ?? '')
  const first = useFocusOnMount<HTMLInputElement>()
  const show = (search: QueueFilter) =>
    void navigate({ to: '/projects/$projectId/review/$cueId', params: { projectId, cueId }, search, replace: true })
  const change = (part: Record<string, string>) => show(filterOf({ ...filter, ...part }))
  useHotkeys([{ keys: 'Escape', label: 'Close', group: 'Review', unlisted: true, run: onClose }])
  const designers = project?.engagements ?? []
  const choice = (
    name: 'category' | 'designer' | 'need' | 'kind' | 'version' | 'heard',
    label: string,
    of: Choices,
  ) => (
    <Select
      label={label}
      value={filter[name] ?? ''}
      onChange={({ currentTarget }) => change({ [name]: currentTarget.value })}
    >
      <option value="">Any</option>
      {Object.entries(of).map(([value, word]) => (
        <option key={value} value={value}>
          {word}
        </option>
      ))}
    </Select>
  )
  return (
    <form
      aria-label="Filter the queue"
      className={`grid grid-cols-2 gap-2 border-b bg-surface ${classes.filters}`}
      onSubmit={(event) => {
        event.preventDefault()
        change({ q: words.trim() })
      }}
    >
      <p className={`small dim grid gap-2px ${classes.words}`}>Urgent first, then by need, priority and age.</p>
      <label className={`grid gap-2px ${classes.words}`}>
        <span className="small mid">Words in name, description or use</span>
        <input
          ref={first}
          value={words}
          maxLength={200}
          onChange={(event) => setWords(event.currentTarget.value)}
          onBlur={() => words.trim() !== (filter.q ?? '') && change({ q: words.trim() })}
        />
      </label>
      {choice(
        'category',
        'Category',
        Object.fromEntries(categories.filter((row) => row.category).map((row) => [row.category, row.category])),
      )}
      {choice(
        'designer',
        'Designer',
        Object.fromEntries(designers.map(({ designer }) => [designer.id, designer.name])),
      )}
      {choice('need', 'Need', NEEDS)}
      {choice('kind', 'Waiting', KINDS)}
      {choice('version', 'Version', VERSIONS)}
      {choice('heard', 'Heard', HEARD)}
      <label className={`grid gap-2px ${classes.words}`}>
        <span className="small mid">Due by</span>
        <input type="date" value={filter.due ?? ''} onChange={(event) => change({ due: event.currentTarget.value })} />
      </label>
      <p className="flex wrap gap-6px col-span-full">
        <Button type="submit" variant="primary">
          Find
        </Button>
        <Views
          projectId={projectId}
          page="review_queue"
          search={filter}
          onOpen={(search) => {
            const opened = filterOf(search)
            setWords(opened.q ?? '')
            show(opened)
          }}
        />
        <Button
          disabled={!isFiltered(filter)}
          onClick={() => {
            setWords('')
            show({})
          }}
        >
          Show all
        </Button>
        <Button variant="quiet" keys="Escape" onClick={onClose}>
          Close
        </Button>
      </p>
    </form>
  )
}

type Choices = Readonly<Record<string, string>>
