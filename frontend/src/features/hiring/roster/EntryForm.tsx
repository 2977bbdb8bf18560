import { Checkbox, NativeSelect, Textarea } from '@mantine/core'

import { DraftForm } from '@/app/drafts/DraftForm'
import { showToast } from '@/app/toast'
import { amount, minorOf } from '@/money/words'
import { Card, CardHead } from '@/ui/Card'
import { Field, Submit } from '@/ui/Form'

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

function faultsOf(typed: Typed) {
  const hours = Number(typed.hours)
  const hasRate = typed.rate.trim() !== ''
  const currency = typed.currency.trim().toUpperCase()
  return {
    hours:
      typed.hours.trim() !== '' &&
      !(Number.isInteger(hours) && hours >= 1 && hours <= 168) &&
      'Enter hours a week from 1 to 168, such as 30.',
    currency: hasRate && !/^[A-Z]{3}$/.test(currency) && 'Enter a currency of three letters, such as USD.',
    rate: hasRate && !((minorOf(typed.rate, currency) ?? -1) >= 0) && `Enter a rate in ${currency}, such as 45.00.`,
  }
}

function bodyOf({ hours, rate, currency, unit, availableFrom, ...typed }: Typed): EntryWrite {
  const code = currency.trim().toUpperCase()
  const minor = rate.trim() === '' ? null : minorOf(rate, code)
  return {
    ...typed,
    specialities: listed(typed.specialities),
    languages: listed(typed.languages),
    links: linksOf(typed.links),
    weekly_hours: hours.trim() === '' ? null : Number(hours),
    available_from_on: availableFrom || null,
    rate: minor === null ? null : { amount_minor: minor, currency: code, unit },
  }
}

/** Everything that people write about a designer on file. */
export function EntryForm({ entry }: { entry: Entry }) {
  const save = useSaveEntry(entry.id)
  const prose = (name: 'equipment' | 'credits' | 'referees' | 'notes', label: string, description?: string) => (
    <Field
      as={Textarea}
      optional
      name={name}
      className={forms.wide}
      label={label}
      description={description}
      rows={3}
      maxLength={5000}
    />
  )
  return (
    <Card aria-labelledby="facts">
      <CardHead id="facts" title="Profile" note="seen by the studio’s producers and audio leads" />
      <DraftForm
        className={`grid gap-4 ${forms.form} items-end`}
        aria-label="Profile"
        draftKey={`roster:${entry.id}`}
        initialValues={typedEntry(entry)}
        mutation={save}
        checks={faultsOf}
        onSubmit={(typed, onSent) =>
          save.mutate(
            { ...bodyOf(typed), revision: entry.revision },
            {
              onSuccess: () => {
                onSent()
                showToast('Saved.')
              },
            },
          )
        }
      >
        {({ services }, change) => (
          <>
            <Field name="name" label="Name" />
            <Field name="email" label="Email" />
            <Field optional name="specialities" label="Specialities" description="Separated by commas" />
            <Field optional name="languages" label="Languages" description="Separated by commas" />
            <fieldset className={forms.wide} style={{ border: 0, padding: 0, margin: 0 }}>
              <legend className="small mid">Also</legend>
              <div className="flex wrap gap-2-4">
                {SERVICES.map((service) => (
                  <Checkbox
                    key={service}
                    label={SERVICE_WORDS[service]}
                    checked={services.includes(service)}
                    onChange={({ currentTarget: { checked } }) =>
                      change({
                        services: checked ? [...services, service] : services.filter((other) => other !== service),
                      })
                    }
                  />
                ))}
              </div>
            </fieldset>
            <Field
              as={NativeSelect}
              name="exclusivity"
              label="Works on"
              data={Object.entries(EXCLUSIVITY_WORDS).map(([value, label]) => ({ value, label }))}
            />
            <Field optional name="hours" label="Stated hours per week" inputMode="numeric" />
            <Field optional name="availableFrom" label="Available from" type="date" />
            {entry.may_see_rate && (
              <>
                <Field optional name="rate" label="Rate, seen by producers only" inputMode="decimal" />
                <Field optional name="currency" label="Currency" maxLength={3} />
                <Field
                  as={NativeSelect}
                  name="unit"
                  label="For"
                  data={[
                    { value: 'hour', label: 'an hour' },
                    { value: 'day', label: 'a day' },
                  ]}
                />
              </>
            )}
            <Field
              as={Textarea}
              optional
              name="links"
              className={forms.wide}
              label="Links"
              description="One a line, a title before the address: Reel https://…"
              rows={3}
            />
            {prose('credits', 'Credits')}
            {prose('equipment', 'Equipment')}
            {prose('referees', 'References', 'People who can recommend them')}
            {prose('notes', 'Notes', 'Never shown to the designer')}
            <Submit className={forms.wide}>Save</Submit>
          </>
        )}
      </DraftForm>
    </Card>
  )
}
