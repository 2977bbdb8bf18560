import { Checkbox, TextInput } from '@mantine/core'
import { useDebouncedValue } from '@mantine/hooks'
import { keepPreviousData, useInfiniteQuery, useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'
import { useState } from 'react'

import { meQuery } from '@/api/me'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'

import type { Posting } from '../api'
import forms from '../Hiring.module.css'
import { rosterQuery, useAskForBids, useRosterStudios } from './api'
import classes from './Roster.module.css'
import { Weeks } from './Weeks'
import { busyInWords } from './words'

const TYPING_MS = 200
const SHOWN = 8

/** People on file, with what is taken of a posting's days, chosen to be asked for a bid. */
export function ChooseFromRoster({ posting }: { posting: Posting }) {
  const { data: me } = useQuery(meQuery)
  const studioId = me?.projects.find(({ id }) => id === posting.project_id)?.studio_id
  const studio = useRosterStudios()?.find(({ id }) => id === studioId)
  if (studio === undefined) return null
  return <Choose posting={posting} studioId={studio.id} />
}

function Choose({ posting, studioId }: { posting: Posting; studioId: string }) {
  const [typed, setTyped] = useState('')
  const [chosen, setChosen] = useState<ReadonlySet<string>>(new Set())
  const [q] = useDebouncedValue(typed.trim(), TYPING_MS)
  const { work_from_on: from, work_to_on: to } = posting
  const { data, error } = useInfiniteQuery({
    ...rosterQuery(studioId, { q: q || undefined, from: from ?? undefined, to: to ?? undefined }),
    placeholderData: keepPreviousData,
  })
  const ask = useAskForBids(posting.id)
  const page = data?.pages[0]
  const asked = new Set(posting.candidates.map(({ email }) => email))
  const people = page?.items.filter(({ email }) => !asked.has(email)) ?? []
  const hasDays = Boolean(from && to)
  const free = people.filter(({ clashes }) => clashes.length === 0).length
  const put = (id: string, on: boolean) =>
    setChosen((before) => new Set(on ? [...before, id] : [...before].filter((other) => other !== id)))
  const send = () => {
    if (ask.isPending || chosen.size === 0) return
    ask.mutate([...chosen], {
      onSuccess: () => {
        showToast(
          posting.state === 'draft'
            ? `${plural(chosen.size, 'designer')} will be asked when the posting opens.`
            : `${plural(chosen.size, 'designer')} asked. Who is asked says how each email stands.`,
        )
        setChosen(new Set())
      },
    })
  }
  return (
    <Card aria-labelledby="on-file">
      <CardHead
        id="on-file"
        title="Roster"
        count={page?.total}
        note={hasDays && people.length > 0 ? `${free} of ${people.length} shown could make these dates` : undefined}
        end={
          <Link className="link" to="/roster" search={{ from: from ?? undefined, to: to ?? undefined }}>
            Open the roster
          </Link>
        }
      />
      {page?.total === 0 ? (
        <p className={`mid grid gap-3 ${forms.body}`}>
          Nobody is on the roster yet. Designers you keep there can be chosen here.
        </p>
      ) : (
        <>
          <div className={`grid gap-3 ${forms.body}`}>
            <TextInput
              label="Search the roster"
              type="search"
              value={typed}
              maxLength={200}
              onChange={({ currentTarget: { value } }) => setTyped(value)}
            />
            <Refusal error={error ?? ask.error} />
          </div>
          <Rows>
            {people.slice(0, SHOWN).map((person) => {
              const clash = person.clashes[0]
              return (
                <Row key={person.id} className={classes.person}>
                  <Checkbox
                    aria-label={`Choose ${person.name}`}
                    checked={chosen.has(person.id)}
                    onChange={({ currentTarget: { checked } }) => put(person.id, checked)}
                  />
                  <Link className="link cut-text" to="/roster/$entryId" params={{ entryId: person.id }}>
                    {person.name}
                  </Link>
                  <span className="small mid">{person.specialities.join(', ')}</span>
                  <Weeks weeks={person.weeks} firstOn={page?.first_week_on ?? ''} />
                  <span className={clash ? 'small tone-warn' : 'small mid'}>
                    <span className="toned">
                      {clash ? `busy ${busyInWords(clash)}` : hasDays ? 'free in these days' : ''}
                    </span>
                  </span>
                </Row>
              )
            })}
          </Rows>
          <div className={`flex wrap items-center gap-3 ${classes.foot}`}>
            <Button icon="mail" disabled={chosen.size === 0} aria-busy={ask.isPending} onClick={send}>
              {chosen.size === 0 ? 'Ask for bids' : `Ask ${plural(chosen.size, 'designer')} for bids`}
            </Button>
            {people.length > SHOWN && (
              <span className="small dim">{`${plural(people.length - SHOWN, 'more matches', 'more match')}; search to see ${people.length - SHOWN === 1 ? 'it' : 'them'}.`}</span>
            )}
          </div>
        </>
      )}
    </Card>
  )
}
