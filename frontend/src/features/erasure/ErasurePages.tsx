import { useQuery } from '@tanstack/react-query'
import { useParams } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { ApiProblem } from '@/api'
import { Field, Form, Submit } from '@/ui/Form'
import { sentence } from '@/ui/sentence'
import { NotFoundPage } from '@/app/NotFoundPage'
import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { day, days } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'
import { Row, Rows } from '@/ui/Rows'

import { type Erasure, erasureQuery, type Subject, useCancelErasure, useEraseAccount, useRequestErasure } from './api'
import classes from './Erasure.module.css'

type Thing = Exclude<Subject, { kind: 'account' }>

/** The person's own account: what goes, what stays and why, and the address typed to confirm. */
export function EraseAccountPage() {
  return (
    <ErasurePage subject={{ kind: 'account' }} title="Erase your account">
      {(erasure) => <EraseAccount erasure={erasure} />}
    </ErasurePage>
  )
}

export function EraseProjectPage() {
  const { id } = useParams({ from: '/shell/erase/projects/$id' })
  const subject = { kind: 'project', id } as const
  return (
    <ErasurePage subject={subject} title="Erase a project">
      {(erasure) => <EraseThing subject={subject} erasure={erasure} />}
    </ErasurePage>
  )
}

export function EraseStudioPage() {
  const { id } = useParams({ from: '/shell/erase/studios/$id' })
  const subject = { kind: 'studio', id } as const
  return (
    <ErasurePage subject={subject} title="Erase a studio">
      {(erasure) => <EraseThing subject={subject} erasure={erasure} />}
    </ErasurePage>
  )
}

interface ErasurePageProps {
  subject: Subject
  title: string
  children: (erasure: Erasure) => ReactNode
}

/** What is deleted and what stays, side by side, before anything is done. */
function ErasurePage({ subject, title, children }: ErasurePageProps) {
  useTitle(title)
  const { data: erasure, error } = useQuery(erasureQuery(subject))
  if (error instanceof ApiProblem && error.status === 404) return <NotFoundPage />
  return (
    <div className="page">
      <h1>{erasure && subject.kind !== 'account' ? `Erase ${erasure.name}` : title}</h1>
      <Refusal error={error} />
      {erasure && (
        <>
          <div className={`grid items-start gap-4 wrap-anywhere ${classes.lists}`}>
            <Card aria-labelledby="deleted">
              <CardHead id="deleted" title="Deleted" />
              <Rows>
                {erasure.deleted.map((name) => (
                  <Row key={name}>{name}</Row>
                ))}
                {subject.kind !== 'account' && <Row>everything else in it, with all its files</Row>}
              </Rows>
            </Card>
            <Card aria-labelledby="kept">
              <CardHead id="kept" title="Kept" />
              <Rows>
                {erasure.kept.map(({ name, reason }) => (
                  <Row key={name}>
                    <span>
                      {name} <span className="small mid">{reason}</span>
                    </span>
                  </Row>
                ))}
              </Rows>
            </Card>
          </div>
          {children(erasure)}
        </>
      )}
    </div>
  )
}

/** What must end before it can be erased, in place of the form. */
function Obstacles({ of }: { of: string[] }) {
  return (
    <Card aria-labelledby="obstacles">
      <CardHead id="obstacles" title="Cannot be erased yet" />
      <Rows>
        {of.map((obstacle) => (
          <Row key={obstacle}>{sentence(obstacle)}</Row>
        ))}
      </Rows>
    </Card>
  )
}

function EraseAccount({ erasure }: { erasure: Erasure }) {
  const erase = useEraseAccount()
  if (erasure.obstacles.length > 0) return <Obstacles of={erasure.obstacles} />
  return (
    <Card aria-labelledby="confirm" className={classes.confirm}>
      <CardHead id="confirm" title="Confirm" note="at once, and for good" />
      <div className={`grid gap-3 wrap-anywhere justify-items-start p-3-4-4 ${classes.inside}`}>
        <p className="mid">What stays names you as a former user, except where a contract or an invoice names you.</p>
        <Form
          initialValues={{ confirmation: '' }}
          mutation={erase}
          onSubmit={({ confirmation }) =>
            erase.mutate(confirmation, { onSuccess: () => globalThis.location.assign('/sign-in') })
          }
        >
          <Field
            name="confirmation"
            label={`Type ${erasure.confirmation} to confirm`}
            type="email"
            autoComplete="off"
          />
          <Submit>Erase account</Submit>
        </Form>
      </div>
    </Card>
  )
}

function EraseThing({ subject, erasure }: { subject: Thing; erasure: Erasure }) {
  const request = useRequestErasure(subject)
  const cancel = useCancelErasure(subject)
  if (erasure.due_at !== null) {
    return (
      <Card aria-labelledby="due">
        <CardHead id="due" title={`Will be erased on ${day(erasure.due_at)}`} />
        <div className={`grid gap-3 wrap-anywhere justify-items-start p-3-4-4 ${classes.inside}`}>
          <p>Requested by {erasure.requested_by}. Nothing changes before that day.</p>
          <Button
            onClick={() => cancel.mutate(undefined, { onSuccess: () => showToast(`${erasure.name} is kept.`) })}
            aria-busy={cancel.isPending}
          >
            Keep {erasure.name}
          </Button>
          <Refusal error={cancel.error} />
        </div>
      </Card>
    )
  }
  if (erasure.obstacles.length > 0) return <Obstacles of={erasure.obstacles} />
  return (
    <Card aria-labelledby="confirm" className={classes.confirm}>
      <CardHead id="confirm" title="Confirm" note={`carried out after ${days(erasure.grace_days)}`} />
      <div className={`grid gap-3 wrap-anywhere justify-items-start p-3-4-4 ${classes.inside}`}>
        <p className="mid">
          Everyone in it gets an email with the day. Until then nothing changes, and a producer can cancel it here.
        </p>
        <Form
          initialValues={{ confirmation: '' }}
          mutation={request}
          onSubmit={({ confirmation }) => request.mutate(confirmation)}
        >
          <Field name="confirmation" label={`Type ${erasure.confirmation} to confirm`} autoComplete="off" />
          <Submit>Erase {subject.kind}</Submit>
        </Form>
      </div>
    </Card>
  )
}
