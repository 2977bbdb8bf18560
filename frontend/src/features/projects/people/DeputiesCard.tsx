import { Select } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { DraftForm } from '@/app/drafts/DraftForm'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Avatar } from '@/ui/Avatar'
import { Field, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { day } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'
import { StatusBadge } from '@/ui/StatusBadge'

import { type Project } from '../api'
import { deputiesQuery, type Deputy, type Member, useNameDeputy, useWithdrawDeputy } from './api'
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
  const people = candidatesOf(project, members).map(({ person }) => ({ value: person.id, label: person.name }))
  return (
    <>
      <h3 className={`bg-surface mid text-small leading-small ${classes.part}`}>Name a deputy</h3>
      <DraftForm
        className="grid gap-3 p-3-inset-4"
        aria-label="Name a deputy"
        draftKey={`deputy:${project.id}`}
        initialValues={{ person_id: project.approver.id, deputy_id: '', from_on: '', until_on: '' }}
        mutation={name}
        onSubmit={(typed, onSent) =>
          name.mutate(typed, {
            onSuccess: (saved) => {
              showToast(`${saved.deputy.name} approves for ${saved.person.name}, ${spanOf(saved)}.`)
              onSent()
            },
          })
        }
      >
        {(typed) => (
          <>
            <Field as={Select} name="person_id" label="In place of" data={people} allowDeselect={false} />
            <Field
              as={Select}
              name="deputy_id"
              label="Deputy"
              placeholder="Choose a person"
              data={people.filter(({ value }) => value !== typed.person_id)}
              allowDeselect={false}
            />
            <div className="grid grid-cols-2 gap-3">
              <Field name="from_on" label="First day" type="date" />
              <Field name="until_on" label="Last day" type="date" min={typed.from_on > today ? typed.from_on : today} />
            </div>
            <p className="small mid">
              Both days count, in the time zone of the studio: {timeZone}.{' '}
              <Link className="link" to="/studio">
                Change it
              </Link>
            </p>
            <Submit variant="plain">Name deputy</Submit>
          </>
        )}
      </DraftForm>
    </>
  )
}
