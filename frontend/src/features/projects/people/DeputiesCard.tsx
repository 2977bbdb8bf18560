import { Select, TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'
import type { FormEvent } from 'react'

import { ApiProblem } from '@/api'
import { DraftNote, useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Avatar } from '@/ui/Avatar'
import { Refusal } from '@/ui/Refusal'
import { day } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'
import { StatusBadge } from '@/ui/StatusBadge'

import { type Project } from '../api'
import { deputiesQuery, type Deputy, type Member, useNameDeputy, useWithdrawDeputy } from './api'
import { against } from '../words'
import { candidatesOf } from './candidates'
import classes from './People.module.css'

/** Who approves in place of whom while they are away, and naming another. */
export function DeputiesCard({ project, members = [] }: { project: Project; members: readonly Member[] | undefined }) {
  const { data, error } = useQuery(deputiesQuery(project.id))
  const withdraw = useWithdrawDeputy(project.id)
  return (
    <Card aria-labelledby="deputies">
      <CardHead id="deputies" title="Deputies" note="approve while an approver is away" />
      <Refusal inset error={error ?? withdraw.error} />
      {data?.deputies.length === 0 && (
        <div className="p-inset">
          <EmptyState head="No deputies named" level={3}>
            A deputy approves from the first day to the last, and receives the emails. The right ends by itself.
          </EmptyState>
        </div>
      )}
      <Rows aria-label="Deputies">
        {data?.deputies.map((row) => (
          <Row key={row.id} className={classes.person}>
            <Avatar name={row.deputy.name} picture={row.deputy.picture} />
            <div className="grow">
              <p className="strong">{`${row.deputy.name} for ${row.person.name}`}</p>
              <p className="small mid">{spanOf(row)}</p>
            </div>
            {row.from_on <= data.today && <StatusBadge kind="approved">Approves today</StatusBadge>}
            {project.mine.is_producer && (
              <Button
                variant="quiet"
                aria-busy={withdraw.isPending}
                aria-label={`Withdraw ${row.deputy.name} for ${row.person.name}`}
                onClick={() =>
                  withdraw.mutate(row.id, {
                    onSuccess: () => showToast(`${row.deputy.name} is no longer a deputy for ${row.person.name}.`),
                  })
                }
              >
                Withdraw
              </Button>
            )}
          </Row>
        ))}
      </Rows>
      {project.mine.is_producer && data && (
        <NameDeputy project={project} members={members} today={data.today} timeZone={data.time_zone} />
      )}
    </Card>
  )
}

const spanOf = ({ from_on: from, until_on: until }: Deputy): string =>
  from === until ? day(from) : `${day(from)} to ${day(until)}`

interface NameDeputyProps {
  project: Project
  members: readonly Member[]
  today: string
  timeZone: string
}

function NameDeputy({ project, members, today, timeZone }: NameDeputyProps) {
  const name = useNameDeputy(project.id)
  const [typed, setTyped, draft] = useDraft(`deputy:${project.id}`, {
    person_id: project.approver.id,
    deputy_id: '',
    from_on: '',
    until_on: '',
  })
  const people = candidatesOf(project, members).map(({ person }) => ({ value: person.id, label: person.name }))
  const change = (field: Partial<typeof typed>) => setTyped((now) => ({ ...now, ...field }))
  const isComplete = Object.values(typed).every(Boolean)
  const send = (event: FormEvent) => {
    event.preventDefault()
    if (name.isPending || !isComplete) return
    name.mutate(typed, {
      onSuccess: (saved) => {
        showToast(`${saved.deputy.name} approves for ${saved.person.name}, ${spanOf(saved)}.`)
        draft.discard()
      },
    })
  }
  const isAtField = name.error instanceof ApiProblem && name.error.errors.length > 0
  return (
    <>
      <h3 className={classes.part}>Name a deputy</h3>
      <form onSubmit={send} noValidate className="grid gap-3 p-3-inset-4" aria-label="Name a deputy">
        <Select
          label="In place of"
          data={people}
          value={typed.person_id}
          allowDeselect={false}
          onChange={(id) => id && change({ person_id: id })}
          error={against(name.error, 'person_id')}
        />
        <Select
          label="Deputy"
          placeholder="Choose a person"
          data={people.filter(({ value }) => value !== typed.person_id)}
          value={typed.deputy_id === '' ? null : typed.deputy_id}
          allowDeselect={false}
          onChange={(id) => id && change({ deputy_id: id })}
          error={against(name.error, 'deputy_id')}
        />
        <div className="grid grid-cols-2 gap-3">
          <TextInput
            label="First day"
            type="date"
            value={typed.from_on}
            onChange={({ currentTarget }) => change({ from_on: currentTarget.value })}
            error={against(name.error, 'from_on')}
          />
          <TextInput
            label="Last day"
            type="date"
            min={typed.from_on > today ? typed.from_on : today}
            value={typed.until_on}
            onChange={({ currentTarget }) => change({ until_on: currentTarget.value })}
            error={against(name.error, 'until_on')}
          />
        </div>
        <p className="small mid">
          Both days count, in the time zone of the studio: {timeZone}.{' '}
          <Link className="link" to="/studio">
            Change it
          </Link>
        </p>
        <DraftNote draft={draft} />
        {!isAtField && <Refusal inset error={name.error} />}
        <div className="row wrap">
          <Button type="submit" aria-busy={name.isPending} disabled={!isComplete}>
            Name deputy
          </Button>
          {!isComplete && <span className="small mid">Choose both people and both days.</span>}
        </div>
      </form>
    </>
  )
}
