import { TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Row, Rows } from '@/ui/Rows'
import { Select } from '@/ui/Select'

import classes from './Account.module.css'
import { type Cadence, type MailPreferences, mailPreferencesQuery, type News, useSaveMailPreferences } from './api'
import { CADENCE_WORDS, cadencesOf, NEWS_WORDS } from './mailWords'
import { CardProblem } from './CardProblem'
import { TimeZoneSelect, ZONES } from './TimeZoneSelect'

const KINDS = Object.keys(NEWS_WORDS) as News[]

/** What the person is mailed, how often, and when nothing is sent. */
export function MailCard() {
  const { data: wishes, error } = useQuery(mailPreferencesQuery)
  const save = useSaveMailPreferences()
  return (
    <Card aria-labelledby="mail-card">
      <CardHead id="mail-card" title="Emails" note={save.isPending ? 'saving' : save.isSuccess ? 'saved' : undefined} />
      <CardProblem error={error ?? save.error} />
      {wishes && <Fields wishes={wishes} onSave={(changed) => save.mutate({ ...wishes, ...changed })} />}
    </Card>
  )
}

interface FieldsProps {
  wishes: MailPreferences
  onSave: (changed: Partial<MailPreferences>) => void
}

function Fields({ wishes, onSave }: FieldsProps) {
  const { cadences, time_zone: zone } = wishes
  const ownZone = Intl.DateTimeFormat().resolvedOptions().timeZone
  const isDaily = Object.values(cadences).includes('daily')
  return (
    <>
      <Rows aria-label="How often each kind is sent">
        {KINDS.map((news) => (
          <Row key={news} className={classes.news}>
            <span className="grow">
              {NEWS_WORDS[news].label} <span className="small mid block">{NEWS_WORDS[news].hint}</span>
            </span>
            <Select
              aria-label={NEWS_WORDS[news].label}
              value={cadences[news]}
              onChange={({ currentTarget }) =>
                onSave({ cadences: { ...cadences, [news]: currentTarget.value as Cadence } })
              }
            >
              {cadencesOf(news !== 'contracts').map((cadence) => (
                <option key={cadence} value={cadence}>
                  {CADENCE_WORDS[cadence]}
                </option>
              ))}
            </Select>
          </Row>
        ))}
      </Rows>
      <div className="flex wrap items-end gap-3 p-3-inset">
        <TimeZoneSelect zone={zone} onChoose={(chosen) => onSave({ time_zone: chosen })} />
        {zone !== ownZone && ZONES.includes(ownZone) && (
          <Button onClick={() => onSave({ time_zone: ownZone })}>Use {ownZone}</Button>
        )}
        {isDaily && (
          <TextInput
            key={wishes.daily_at}
            type="time"
            label="The day’s email at"
            defaultValue={wishes.daily_at.slice(0, 5)}
            onBlur={({ currentTarget: { value } }) => {
              if (value && value !== wishes.daily_at.slice(0, 5)) onSave({ daily_at: value })
            }}
          />
        )}
        <QuietHours key={`${wishes.quiet_from ?? ''}-${wishes.quiet_until ?? ''}`} wishes={wishes} onSave={onSave} />
      </div>
      <p className={`small mid ${classes.inside}`}>
        Emails about your account are always sent. Those about contracts come once a day or more often, because they
        name days to keep.
      </p>
    </>
  )
}

/** Both ends are given before anything is saved. */
function QuietHours({ wishes, onSave }: FieldsProps) {
  const [from, setFrom] = useState(wishes.quiet_from?.slice(0, 5) ?? '')
  const [until, setUntil] = useState(wishes.quiet_until?.slice(0, 5) ?? '')
  const isWhole = from !== '' && until !== '' && from !== until
  const isChanged = from !== (wishes.quiet_from?.slice(0, 5) ?? '') || until !== (wishes.quiet_until?.slice(0, 5) ?? '')
  return (
    <form
      className="flex wrap items-end gap-3"
      onSubmit={(event) => {
        event.preventDefault()
        if (isWhole) onSave({ quiet_from: from, quiet_until: until })
      }}
    >
      <TextInput
        type="time"
        label="Send nothing from"
        value={from}
        onChange={({ currentTarget }) => setFrom(currentTarget.value)}
      />
      <TextInput
        type="time"
        label="until"
        value={until}
        error={from !== '' && from === until ? 'The same time: give another one.' : undefined}
        onChange={({ currentTarget }) => setUntil(currentTarget.value)}
      />
      {isChanged && (
        <Button type="submit" variant="primary" disabled={!isWhole}>
          Save quiet hours
        </Button>
      )}
      {!isChanged && wishes.quiet_from != null && (
        <Button onClick={() => onSave({ quiet_from: null, quiet_until: null })}>No quiet hours</Button>
      )}
    </form>
  )
}
