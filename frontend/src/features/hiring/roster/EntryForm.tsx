import { Checkbox, Textarea, TextInput } from '@mantine/core'
import { type FormEvent, useState } from 'react'

import { DraftNote, useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { amount, minorOf } from '@/money/words'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { Select } from '@/ui/Select'

import forms from '../Hiring.module.css'
import { type Entry, type EntryWrite, useSaveEntry } from './api'
import { EXCLUSIVITY_WORDS, listed, SERVICE_WORDS, SERVICES } from './words'

const typedEntry = (entry: Entry) => ({
  name: entry.name,
  email: entry.email,
  specialities: entry.specialities.join(', '),
  services: entry.services,
  languages: entry.languages.join(', '),
  equipment: entry.equipment,
  credits: entry.credits,
  referees: entry.referees,
  links: entry.links.map(({ title, url }) => (title ? `${title} ${url}` : url)).join('\n'),
  exclusivity: entry.exclusivity,
  hours: entry.weekly_hours === null ? '' : String(entry.weekly_hours),
  availableFrom: entry.available_from_on ?? '',
  notes: entry.notes,
  rate: entry.rate ? amount(entry.rate.amount_minor, entry.rate.currency) : '',
  currency: entry.rate?.currency ?? 'USD',
  unit: entry.rate?.unit ?? 'hour',
})
type Typed = ReturnType<typeof typedEntry>

/** "Reel https://…": each line ends with the address. */
const linksOf = (typed: string) =>
  typed
    .split('\n')
    .map((line) => line.trim())
    .filter(Boolean)
    .map((line) => {
      const at = line.lastIndexOf(' ')
      return { title: line.slice(0, Math.max(0, at)).trim(), url: line.slice(at + 1) }
    })

/** What is to be saved, or what cannot be read. */
function written(typed: Typed): { body: EntryWrite } | { wrong: string } {
  const hours = typed.hours.trim() === '' ? null : Number(typed.hours)
  if (hours !== null && !(Number.isInteger(hours) && hours >= 1 && hours <= 168)) {
    return { wrong: 'Enter hours a week from 1 to 168, such as 30.' }
  }
  const currency = typed.currency.trim().toUpperCase()
  if (typed.rate.trim() !== '' && !/^[A-Z]{3}$/.test(currency)) {
    return { wrong: 'Enter a currency of three letters, such as USD.' }
  }
  const minor = typed.rate.trim() === '' ? null : minorOf(typed.rate, currency)
  if (typed.rate.trim() !== '' && (minor === null || minor < 0)) {
    return { wrong: `Enter a rate in ${currency}, such as 45.00.` }
  }
  return {
    body: {
      name: typed.name,
      email: typed.email,
      specialities: listed(typed.specialities),
      services: typed.services,
      languages: listed(typed.languages),
      equipment: typed.equipment,
      credits: typed.credits,
      referees: typed.referees,
      links: linksOf(typed.links),
      exclusivity: typed.exclusivity,
      weekly_hours: hours,
      available_from_on: typed.availableFrom || null,
      notes: typed.notes,
      rate: minor === null ? null : { amount_minor: minor, currency, unit: typed.unit },
    },
  }
}

/** Everything that people write about a designer on file. */
export function EntryForm({ entry }: { entry: Entry }) {
  const [now, set, draft] = useDraft(`roster:${entry.id}`, () => typedEntry(entry))
  const save = useSaveEntry(entry.id)
  const [wrong, setWrong] = useState<string | null>(null)
  const put = (changes: Partial<Typed>) => set((before) => ({ ...before, ...changes }))
  const send = (event: FormEvent) => {
    event.preventDefault()
    if (save.isPending) return
    const result = written(now)
    setWrong('wrong' in result ? result.wrong : null)
    if ('wrong' in result) return
    save.mutate(
      { ...result.body, revision: entry.revision },
      {
        onSuccess: () => {
          draft.discard()
          showToast('Saved.')
        },
      },
    )
  }
  const text = (name: 'specialities' | 'languages' | 'email' | 'name', label: string, description?: string) => (
    <TextInput
      label={label}
      description={description}
      value={now[name]}
      onChange={({ currentTarget: { value } }) => put({ [name]: value })}
    />
  )
  const prose = (name: 'equipment' | 'credits' | 'referees' | 'notes', label: string, description?: string) => (
    <Textarea
      className={forms.wide}
      label={label}
      description={description}
      rows={3}
      maxLength={5000}
      value={now[name]}
      onChange={({ currentTarget: { value } }) => put({ [name]: value })}
    />
  )
  return (
    <Card aria-labelledby="facts">
      <CardHead id="facts" title="On file" note="seen by the studio’s producers and audio leads" />
      <form onSubmit={send} noValidate className={`grid gap-4 ${forms.form} items-end`} aria-label="On file">
        <div className={forms.wide}>
          <DraftNote draft={draft} />
        </div>
        {text('name', 'Name')}
        {text('email', 'Email')}
        {text('specialities', 'Specialities', 'Separated by commas')}
        {text('languages', 'Languages', 'Separated by commas')}
        <fieldset className={forms.wide} style={{ border: 0, padding: 0, margin: 0 }}>
          <legend className="small mid">Also</legend>
          <div className="flex wrap gap-2-4">
            {SERVICES.map((service) => (
              <Checkbox
                key={service}
                label={SERVICE_WORDS[service]}
                checked={now.services.includes(service)}
                onChange={({ currentTarget: { checked } }) =>
                  put({
                    services: checked ? [...now.services, service] : now.services.filter((other) => other !== service),
                  })
                }
              />
            ))}
          </div>
        </fieldset>
        <Select
          label="Works on"
          value={now.exclusivity}
          onChange={({ currentTarget: { value } }) => put({ exclusivity: value as Typed['exclusivity'] })}
        >
          {Object.entries(EXCLUSIVITY_WORDS).map(([value, words]) => (
            <option key={value} value={value}>
              {words}
            </option>
          ))}
        </Select>
        <TextInput
          label="Stated hours per week"
          inputMode="numeric"
          value={now.hours}
          onChange={({ currentTarget: { value } }) => put({ hours: value })}
        />
        <TextInput
          label="Available from"
          type="date"
          value={now.availableFrom}
          onChange={({ currentTarget: { value } }) => put({ availableFrom: value })}
        />
        {entry.may_see_rate && <RateFields now={now} put={put} />}
        <Textarea
          className={forms.wide}
          label="Links"
          description="One a line, a title before the address: Reel https://…"
          rows={3}
          value={now.links}
          onChange={({ currentTarget: { value } }) => put({ links: value })}
        />
        {prose('credits', 'Credits')}
        {prose('equipment', 'Equipment')}
        {prose('referees', 'References', 'People who can recommend them')}
        {prose('notes', 'Notes', 'Never shown to the designer')}
        <div className={forms.wide}>
          {wrong && <p role="alert">{wrong}</p>}
          <Refusal error={save.error} />
          <Button type="submit" variant="primary" aria-busy={save.isPending}>
            Save
          </Button>
        </div>
      </form>
    </Card>
  )
}

function RateFields({ now, put }: { now: Typed; put: (changes: Partial<Typed>) => void }) {
  return (
    <>
      <TextInput
        label="Rate, seen by producers only"
        inputMode="decimal"
        value={now.rate}
        onChange={({ currentTarget: { value } }) => put({ rate: value })}
      />
      <TextInput
        label="Currency"
        maxLength={3}
        value={now.currency}
        onChange={({ currentTarget: { value } }) => put({ currency: value })}
      />
      <Select
        label="For"
        value={now.unit}
        onChange={({ currentTarget: { value } }) => put({ unit: value === 'day' ? 'day' : 'hour' })}
      >
        <option value="hour">an hour</option>
        <option value="day">a day</option>
      </Select>
    </>
  )
}
