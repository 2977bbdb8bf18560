import { TextInput } from '@mantine/core'
import { type FormEvent, useRef, useState } from 'react'

import { base64Of } from '@/api/base64'
import { DraftNote, useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { FieldError } from '@/ui/FieldError'
import { Refusal } from '@/ui/Refusal'
import { ago, bytes, plural, shortDay } from '@/ui/format'
import { Select } from '@/ui/Select'

import forms from '../Hiring.module.css'
import { type Entry, useDropCalendar, useReadCalendar, useSetBusy } from './api'
import classes from './Roster.module.css'
import { LargeWeeks } from './Weeks'
import { busyInWords } from './words'

const LARGEST_BYTES = 2_000_000

interface TypedRange {
  from: string
  to: string
  kind: 'booked' | 'half_days'
  note: string
}
const NEW_RANGE: TypedRange = { from: '', to: '', kind: 'booked', note: '' }

const typedRanges = ({ busy }: Entry): TypedRange[] =>
  busy
    .filter(({ is_from_calendar: isFromCalendar }) => !isFromCalendar)
    .map(({ from_on, to_on, kind, note }) => ({ from: from_on, to: to_on, kind: kind ?? 'booked', note: note ?? '' }))

/** When a designer is busy: typed, and read from the calendar file that they sent. */
export function AvailabilityCard({ entry }: { entry: Entry }) {
  return (
    <Card aria-labelledby="availability">
      <CardHead id="availability" title="Availability" note="the next 12 weeks" />
      <div className={`grid gap-3 ${forms.body}`}>
        <LargeWeeks weeks={entry.weeks} firstOn={entry.first_week_on} />
        <BusyForm entry={entry} />
        <CalendarPart entry={entry} />
      </div>
    </Card>
  )
}

function BusyForm({ entry }: { entry: Entry }) {
  const [ranges, set, draft] = useDraft(`roster-busy:${entry.id}`, () => typedRanges(entry))
  const save = useSetBusy(entry.id)
  const [wrong, setWrong] = useState<string | null>(null)
  const kept = typedRanges(entry)
  const isChanged = JSON.stringify(kept) !== JSON.stringify(ranges)
  const put = (at: number, changes: Partial<TypedRange>) =>
    set((before) => before.map((range, place) => (place === at ? { ...range, ...changes } : range)))
  const send = (event: FormEvent) => {
    event.preventDefault()
    if (save.isPending) return
    const open = ranges.find(({ from, to }) => from === '' || to === '')
    setWrong(open ? 'Enter the first and the last day of every range, or remove it.' : null)
    if (open) return
    save.mutate(
      ranges.map(({ from, to, ...rest }) => ({ from_on: from, to_on: to, ...rest })),
      { onSuccess: () => showToast('Dates saved.') },
    )
  }
  return (
    <form onSubmit={send} noValidate className="stack" aria-label="Busy days">
      <DraftNote draft={draft} />
      {ranges.map((range, at) => (
        <fieldset
          key={at}
          className={`grid items-end gap-3 ${classes.range}`}
          style={{ border: 0, padding: 0, margin: 0 }}
        >
          <legend className="visually-hidden">{`Busy range ${at + 1}`}</legend>
          <TextInput
            label="Busy from"
            type="date"
            value={range.from}
            onChange={({ currentTarget: { value } }) => put(at, { from: value })}
          />
          <TextInput
            label="to"
            type="date"
            value={range.to}
            onChange={({ currentTarget: { value } }) => put(at, { to: value })}
          />
          <Select
            label="How much"
            value={range.kind}
            onChange={({ currentTarget: { value } }) => put(at, { kind: value === 'half_days' ? value : 'booked' })}
          >
            <option value="booked">booked</option>
            <option value="half_days">half days</option>
          </Select>
          <TextInput
            label="Note"
            maxLength={200}
            value={range.note}
            onChange={({ currentTarget: { value } }) => put(at, { note: value })}
          />
          <Button
            square
            variant="quiet"
            icon="cross"
            aria-label={`Remove busy range ${at + 1}`}
            onClick={() => set((before) => before.filter((_, place) => place !== at))}
          />
        </fieldset>
      ))}
      {wrong && <FieldError>{wrong}</FieldError>}
      <Refusal error={save.error} />
      <div className="row wrap">
        <Button icon="plus" onClick={() => set((before) => [...before, NEW_RANGE])}>
          Add busy days
        </Button>
        {isChanged && (
          <Button type="submit" variant="primary" aria-busy={save.isPending}>
            Save dates
          </Button>
        )}
      </div>
    </form>
  )
}

function CalendarPart({ entry }: { entry: Entry }) {
  const read = useReadCalendar(entry.id)
  const drop = useDropCalendar(entry.id)
  const [unread, setUnread] = useState<string | null>(null)
  const picker = useRef<HTMLInputElement>(null)
  const take = async (file: File | undefined) => {
    if (file === undefined) return
    setUnread(null)
    if (file.size > LARGEST_BYTES) {
      setUnread(`${file.name} has ${bytes(file.size)}; the limit is ${bytes(LARGEST_BYTES)}. Export one year only.`)
      return
    }
    try {
      read.mutate({ file_name: file.name, content_base64: await base64Of(file) })
    } catch {
      setUnread(`${file.name} could not be read from your disk. Choose it again.`)
    }
  }
  const imported = entry.busy.filter(({ is_from_calendar: isFromCalendar }) => isFromCalendar)
  return (
    <section className="stack" aria-label="Calendar file">
      {entry.calendar_name && entry.calendar_read_at && (
        <div>
          <p>
            {`${entry.calendar_name}, read ${ago(entry.calendar_read_at)}: ${plural(imported.length, 'busy range')}`}
            {entry.calendar_to_on && ` until ${shortDay(entry.calendar_to_on)}`}
          </p>
          <p className="small mid">
            {imported.slice(0, 6).map(busyInWords).join(' · ')}
            {imported.length > 6 && ` · and ${imported.length - 6} more`}
          </p>
        </div>
      )}
      <p className="small dim">Only days are kept from a calendar file, no titles of events.</p>
      {unread && <FieldError>{unread}</FieldError>}
      <Refusal error={read.error ?? drop.error} />
      <div className="row wrap">
        <Button icon="upload" aria-busy={read.isPending} onClick={() => picker.current?.click()}>
          {entry.calendar_name ? 'Read a newer calendar file' : 'Read a calendar file (.ics)'}
        </Button>
        {entry.calendar_name && (
          <Button variant="quiet" aria-busy={drop.isPending} onClick={() => drop.mutate(undefined)}>
            Remove its days
          </Button>
        )}
      </div>
      <input
        ref={picker}
        type="file"
        hidden
        aria-label="Calendar file"
        accept=".ics,text/calendar"
        onChange={(event) => {
          void take(event.currentTarget.files?.[0])
          event.currentTarget.value = ''
        }}
      />
    </section>
  )
}
