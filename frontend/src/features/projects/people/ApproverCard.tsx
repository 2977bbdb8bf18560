import { Select, TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { type FormEvent, useState } from 'react'

import { ApiProblem } from '@/api'
import { showToast } from '@/app/toast'
import { meQuery } from '@/judging/api'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Face } from '@/ui/Face'
import { shortDay } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'

import { deciderHistoryQuery, type Member, type Project, useNameDecider } from '../api'
import { Refusal } from '../Refusal'
import { against, sentence } from '../words'
import classes from './People.module.css'

/** Who has the last word, why, and who had it before. */
export function ApproverCard({ project, members = [] }: { project: Project; members: readonly Member[] | undefined }) {
  const { data: me } = useQuery(meQuery)
  const { data: history, error } = useQuery(deciderHistoryQuery(project.id))
  const [naming, setNaming] = useState(false)
  const [personId, setPersonId] = useState<string | null>(null)
  const [reason, setReason] = useState('')
  const name = useNameDecider(project.id)
  const { decider, liaisons, mine } = project
  const candidates = members
    .filter(({ person, roles }) => liaisons.some(({ id }) => id === person.id) || roles.includes('producer'))
    .filter(({ person }) => person.id !== decider.id)
  const own = candidates.find(({ person }) => person.id === me?.person.id)
  const begin = (id: string | null) => {
    setPersonId(id)
    setNaming(true)
  }
  const send = (event: FormEvent) => {
    event.preventDefault()
    if (personId === null || name.isPending) return
    name.mutate(
      { person_id: personId, reason },
      {
        onSuccess: (changed) => {
          showToast(`${changed.decider.name} has the last word.`)
          setNaming(false)
          setReason('')
        },
      },
    )
  }
  const fields = name.error instanceof ApiProblem && name.error.errors.length > 0
  return (
    <Card aria-labelledby="approver">
      <CardHead id="approver" title="Approver" note="has the last word on every sound" />
      <div className={classes.decider}>
        <Face name={decider.name} filled />
        <div className="grow">
          <p className="strong">{decider.name}</p>
          {history?.[0] && (
            <p className="small mid">{`since ${shortDay(history[0].created_at)}: ${sentence(history[0].reason)}`}</p>
          )}
        </div>
      </div>
      {mine.is_producer && !naming && (
        <div className={`row wrap ${classes.acts}`}>
          <Button onClick={() => begin(candidates[0]?.person.id ?? null)}>Name another</Button>
          {own && (
            <Button variant="quiet" onClick={() => begin(own.person.id)}>
              Take it over
            </Button>
          )}
        </div>
      )}
      {naming && candidates.length === 0 && (
        <p className={classes.acts}>Nobody else can decide: make a member a liaison first.</p>
      )}
      {naming && candidates.length > 0 && (
        <form onSubmit={send} noValidate className={classes.form} aria-label="Name the approver">
          <Select
            label="Who decides from now on"
            data={candidates.map(({ person }) => ({
              value: person.id,
              label: person.id === me?.person.id ? `${person.name} (you)` : person.name,
            }))}
            value={personId}
            onChange={setPersonId}
            allowDeselect={false}
            error={against(name.error, 'person_id')}
          />
          <TextInput
            label="Why; it is kept"
            value={reason}
            onChange={({ currentTarget }) => setReason(currentTarget.value)}
            error={against(name.error, 'reason')}
          />
          {!fields && <Refusal error={name.error} />}
          <div className="row wrap">
            <Button type="submit" variant="primary" aria-busy={name.isPending}>
              Give the last word
            </Button>
            <Button variant="quiet" onClick={() => setNaming(false)}>
              Leave it
            </Button>
          </div>
        </form>
      )}
      <Refusal error={error} />
      {history && history.length > 0 && (
        <>
          <h3 className={classes.part}>Who had it</h3>
          <Rows aria-label="Who had the last word">
            {history.map(({ person, changer, reason: why, created_at }) => (
              <Row key={created_at} className={classes.had}>
                <span className="small dim nowrap">{shortDay(created_at)}</span>
                <p className="small grow">
                  <span className="strong">{person.name}</span>{' '}
                  <span className="mid">{`${person.id === changer.id ? 'took it over' : `named by ${changer.name}`}: ${sentence(why)}`}</span>
                </p>
              </Row>
            ))}
          </Rows>
        </>
      )}
    </Card>
  )
}
