import { TextInput } from '@mantine/core'
import { useDebouncedCallback } from '@mantine/hooks'
import { keepPreviousData, useInfiniteQuery } from '@tanstack/react-query'
import { Link, useNavigate, useSearch } from '@tanstack/react-router'
import { useRef, useState } from 'react'

import { DraftForm } from '@/app/drafts/DraftForm'
import { useHotkeys } from '@/app/keys'
import { useTitle } from '@/app/title'
import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Field, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { countOf, plural, shortDay, today } from '@/ui/format'
import { KeysLine } from '@/ui/KeysLine'
import { PageHead } from '@/ui/PageHead'
import { Row, Rows } from '@/ui/Rows'
import { Segmented } from '@/ui/Segmented'
import { Select } from '@/ui/Select'
import { ShowMore } from '@/ui/ShowMore'
import { PageSkeleton } from '@/ui/Skeleton'

import forms from '../Hiring.module.css'
import { rosterQuery, type Roster, type RosterRow, useAddEntry, useRosterStudios } from './api'
import { type FilePlayer, useReelPlayer } from '../player'
import classes from './Roster.module.css'
import { Weeks } from './Weeks'
import { busyInWords, type RosterSearch, type Service, SERVICE_WORDS, SERVICES } from './words'

const GROUP = 'Roster'
const TYPING_MS = 200
const NEW_ENTRY = { equipment: '', credits: '', referees: '', notes: '', exclusivity: 'unknown' } as const

/** The designers whom a studio has on file: searched, filtered by the days that have to be free, and added. */
export function RosterPage() {
  useTitle('Roster')
  const studios = useRosterStudios()
  const search = useSearch({ from: '/shell/roster' })
  const navigate = useNavigate({ from: '/roster' })
  if (studios === undefined) return <PageSkeleton />
  const studio = studios.find(({ id }) => id === search.studio) ?? studios[0]
  if (studio === undefined) {
    return (
      <div className="page">
        <EmptyState level={1} head="The roster is for producers and audio leads">
          It lists the sound designers that a studio has on file. What studios know of your own work is under{' '}
          <Link className="link" to="/work">
            Your work
          </Link>
          .
        </EmptyState>
      </div>
    )
  }
  return (
    <div className="page stack">
      <PageHead
        title="Roster"
        actions={
          <>
            {studios.length > 1 && (
              <Segmented
                label="Studio"
                options={studios.map(({ id, name }) => ({ value: id, label: name }))}
                value={studio.id}
                onChange={(id) => void navigate({ search: { studio: id } })}
              />
            )}
            <ButtonLink component={Link} to={`/roster/import?studio=${studio.id}`} icon="upload">
              Import a sheet
            </ButtonLink>
          </>
        }
      >
        Sound designers on file at {studio.name}. They are not informed, and do not see this page.
      </PageHead>
      <Found key={studio.id} studioId={studio.id} search={search} />
    </div>
  )
}

function Found({ studioId, search }: { studioId: string; search: RosterSearch }) {
  const pages = useInfiniteQuery({
    ...rosterQuery(studioId, search),
    placeholderData: keepPreviousData,
  })
  const { data, error } = pages
  const first = data?.pages[0]
  if (first === undefined) return <Refusal error={error} />
  const people = data?.pages.flatMap(({ items }) => items) ?? []
  if (first.total === 0) {
    return (
      <>
        <EmptyState
          head="Nobody on file yet"
          action={
            <ButtonLink component={Link} to={`/roster/import?studio=${studioId}`} icon="upload">
              Import a sheet
            </ButtonLink>
          }
        >
          Keep the designers you meet before you need them: what they are good at, when they are free, how to reach
          them. Add the first one below, or import a list from a spreadsheet.
        </EmptyState>
        <AddCard studioId={studioId} />
      </>
    )
  }
  return (
    <>
      <Refusal error={error} />
      <Card aria-labelledby="people">
        <CardHead
          id="people"
          title="People"
          count={first.found === first.total ? first.total : countOf(first.found, first.total)}
          end={
            <KeysLine
              keys={[
                { keys: ['/'], label: 'search' },
                { keys: ['j', 'k'], label: 'move' },
                { keys: ['Enter'], label: 'open' },
                { keys: ['Space'], label: 'play' },
                { keys: ['n'], label: 'add' },
              ]}
            />
          }
        />
        <Filters roster={first} search={search} />
        <People people={people} roster={first} search={search} />
        {pages.hasNextPage && (
          <div className={`flex wrap items-center gap-3 ${classes.foot}`}>
            <ShowMore list={pages}>{`Show more, ${first.found - people.length} left`}</ShowMore>
          </div>
        )}
      </Card>
      <AddCard studioId={studioId} />
    </>
  )
}

function Filters({ roster, search }: { roster: Roster; search: RosterSearch }) {
  const navigate = useNavigate({ from: '/roster' })
  const [typed, setTyped] = useState(search.q ?? '')
  const field = useRef<HTMLInputElement>(null)
  const put = (changes: RosterSearch) => void navigate({ search: { ...search, ...changes }, replace: true })
  const putWords = useDebouncedCallback((q: string) => put({ q: q.trim() || undefined }), TYPING_MS)
  useHotkeys([{ keys: '/', label: 'Search', group: GROUP, run: () => field.current?.focus() }])
  const isFiltered = [search.q, search.speciality, search.service, search.language, search.from, search.to].some(
    Boolean,
  )
  return (
    <div role="search" className={`grid items-end gap-3 p-14px ${classes.search}`} aria-label="Search the roster">
      <TextInput
        ref={field}
        label="Search"
        type="search"
        placeholder="Name, credit, equipment, note"
        value={typed}
        maxLength={200}
        onChange={({ currentTarget: { value } }) => {
          setTyped(value)
          putWords(value)
        }}
      />
      <Choice
        label="Speciality"
        value={search.speciality}
        options={roster.specialities.map(({ value, count }) => ({ value, label: `${value} (${count})` }))}
        onChoose={(speciality) => put({ speciality })}
      />
      <Choice
        label="Also"
        value={search.service}
        options={SERVICES.map((value) => ({
          value,
          label: `${SERVICE_WORDS[value]} (${roster.services.find((service) => service.value === value)?.count ?? 0})`,
        }))}
        onChoose={(service) => put({ service: service as Service | undefined })}
      />
      <Choice
        label="Language"
        value={search.language}
        options={roster.languages.map(({ value, count }) => ({ value, label: `${value} (${count})` }))}
        onChoose={(language) => put({ language })}
      />
      <TextInput
        label="Work from"
        type="date"
        value={search.from ?? ''}
        onChange={({ currentTarget: { value } }) => put({ from: value || undefined })}
      />
      <TextInput
        label="Work to"
        type="date"
        value={search.to ?? ''}
        onChange={({ currentTarget: { value } }) => put({ to: value || undefined })}
      />
      {isFiltered && (
        <Button
          variant="quiet"
          icon="cross"
          onClick={() => {
            setTyped('')
            void navigate({ search: { studio: search.studio }, replace: true })
          }}
        >
          Clear
        </Button>
      )}
    </div>
  )
}

interface ChoiceProps {
  label: string
  value: string | undefined
  options: readonly { value: string; label: string }[]
  onChoose: (value: string | undefined) => void
}

function Choice({ label, value, options, onChoose }: ChoiceProps) {
  return (
    <Select
      label={label}
      value={value ?? ''}
      onChange={({ currentTarget: { value: chosen } }) => onChoose(chosen || undefined)}
    >
      <option value="">Any</option>
      {options.map((option) => (
        <option key={option.value} value={option.value}>
          {option.label}
        </option>
      ))}
    </Select>
  )
}

interface PeopleProps {
  people: readonly RosterRow[]
  roster: Roster
  search: RosterSearch
}

function People({ people, roster, search }: PeopleProps) {
  const navigate = useNavigate()
  const player = useReelPlayer()
  const [selectedId, setSelected] = useState<string | null>(null)
  const list = useRef<HTMLUListElement>(null)
  const place = people.findIndex(({ id }) => id === selectedId)
  const selected = people[place]
  const move = (by: number) => {
    const next = people[Math.min(people.length - 1, Math.max(0, place + by))]
    if (next === undefined) return
    setSelected(next.id)
    list.current?.querySelector<HTMLElement>(`[data-id="${next.id}"] a`)?.focus()
  }
  useHotkeys([
    { keys: 'j', label: 'Next person', group: GROUP, run: () => move(1) },
    { keys: 'k', label: 'Previous person', group: GROUP, run: () => move(-1) },
    {
      keys: 'Enter',
      label: 'Open',
      group: GROUP,
      disabled: !selected,
      run: () => selected && void navigate({ to: '/roster/$entryId', params: { entryId: selected.id } }),
    },
    {
      keys: 'Space',
      label: 'Play the reel',
      group: GROUP,
      disabled: !selected?.reel[0],
      run: () => selected?.reel[0] && player.toggle(selected.reel[0].id),
    },
  ])
  if (people.length === 0) {
    return (
      <EmptyState head="Nobody on file matches" level={3}>
        Use fewer words, or clear a filter.
      </EmptyState>
    )
  }
  const asksDays = Boolean(search.from && search.to)
  return (
    <Rows ref={list}>
      {people.map((person) => (
        <Row key={person.id} data-id={person.id} selected={person.id === selectedId} className={classes.person}>
          <PlayKey person={person} player={player} />
          <span className="grid">
            <Link
              className="link strong cut-text"
              to="/roster/$entryId"
              params={{ entryId: person.id }}
              onFocus={() => setSelected(person.id)}
            >
              {person.name}
            </Link>
            <span className="small dim cut-text">
              {person.works_here ? `${person.email}, worked here` : person.email}
            </span>
          </span>
          <span className="small mid">
            {[...person.specialities, ...person.services.map((service) => SERVICE_WORDS[service].toLowerCase())].join(
              ', ',
            ) || 'nothing noted yet'}
          </span>
          <Weeks weeks={person.weeks} firstOn={roster.first_week_on} />
          <Free person={person} asksDays={asksDays} />
        </Row>
      ))}
    </Rows>
  )
}

function PlayKey({ person, player }: { person: RosterRow; player: FilePlayer }) {
  const sound = person.reel[0]
  if (sound === undefined) return <span />
  const isPlaying = player.playingId === sound.id
  return (
    <Button
      square
      variant="quiet"
      icon={isPlaying ? 'pause' : 'play'}
      aria-label={`${isPlaying ? 'Pause' : 'Play'} ${sound.title} by ${person.name}`}
      onClick={() => player.toggle(sound.id)}
    />
  )
}

/** Whether the days that were asked about are free; without days, the first free day. */
function Free({ person, asksDays }: { person: RosterRow; asksDays: boolean }) {
  const [first, ...more] = person.clashes
  if (asksDays && first) {
    return (
      <span className="small tone-warn">
        <span className="toned">
          {busyInWords(first)}
          {more.length > 0 && `, and ${plural(more.length, 'more range')}`}
        </span>
      </span>
    )
  }
  if (asksDays) return <span className="small mid">free in these days</span>
  const isFree = person.free_from_on <= today()
  return <span className="small mid">{isFree ? 'free now' : `free from ${shortDay(person.free_from_on)}`}</span>
}

function AddCard({ studioId }: { studioId: string }) {
  const add = useAddEntry(studioId)
  const navigate = useNavigate()
  const name = useRef<HTMLInputElement>(null)
  useHotkeys([{ keys: 'n', label: 'Add a person', group: GROUP, run: () => name.current?.focus() }])
  return (
    <Card aria-labelledby="add">
      <CardHead id="add" title="Add a person" note="nobody is mailed" />
      <DraftForm
        className={`grid gap-4 ${forms.form}`}
        aria-label="Add a person"
        draftKey={`roster-add:${studioId}`}
        initialValues={{ name: '', email: '' }}
        mutation={add}
        onSubmit={(typed, onSent) =>
          add.mutate(
            { ...NEW_ENTRY, ...typed },
            {
              onSuccess: ({ id }) => {
                onSent()
                void navigate({ to: '/roster/$entryId', params: { entryId: id } })
              },
            },
          )
        }
      >
        <Field ref={name} name="name" label="Name" maxLength={120} />
        <Field name="email" label="Email" type="email" />
        <Submit variant="plain" icon="plus" className={forms.wide}>
          Add designer
        </Submit>
      </DraftForm>
    </Card>
  )
}
