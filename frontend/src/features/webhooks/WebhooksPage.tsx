import { useQuery } from '@tanstack/react-query'
import { useNavigate, useSearch } from '@tanstack/react-router'
import { useState } from 'react'

import { useTitle } from '@/app/title'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ConfirmInline } from '@/ui/ConfirmInline'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { ago } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { Row, Rows } from '@/ui/Rows'
import { Segmented } from '@/ui/Segmented'
import { PageSkeleton } from '@/ui/Skeleton'

import { AddWebhook } from './AddWebhook'
import { useDelete, useEnable, useOwnStudios, useRotate, useTest, type Webhook, webhooksQuery } from './api'
import { CallsLog } from './CallsLog'
import { SecretNote } from './SecretNote'
import classes from './Webhooks.module.css'
import { EVENTS, EVENT_WORDS, FORM_WORDS } from './words'

/** The addresses that a studio has called for what happens in its projects. */
export function WebhooksPage() {
  useTitle('Webhooks')
  const studios = useOwnStudios()
  const { studio: studioId } = useSearch({ from: '/shell/webhooks' })
  const navigate = useNavigate({ from: '/webhooks' })
  if (studios === undefined) return <PageSkeleton />
  const studio = studios.find(({ id }) => id === studioId) ?? studios[0]
  if (studio === undefined) {
    return (
      <div className="page page-narrow">
        <EmptyState level={1} head="Webhooks are for producers">
          They call a program or a chat when something happens in a studio’s projects.
        </EmptyState>
      </div>
    )
  }
  return (
    <div className="page page-narrow stack">
      <PageHead
        title="Webhooks"
        actions={
          studios.length > 1 && (
            <Segmented
              label="Studio"
              options={studios.map(({ id, name }) => ({ value: id, label: name }))}
              value={studio.id}
              onChange={(id) => void navigate({ search: { studio: id } })}
            />
          )
        }
      >
        A program or a chat is called when something happens in the projects of {studio.name}.
      </PageHead>
      <Webhooks key={studio.id} studioId={studio.id} />
    </div>
  )
}

function Webhooks({ studioId }: { studioId: string }) {
  const { data, error } = useQuery(webhooksQuery(studioId))
  return (
    <>
      <Refusal error={error} />
      {data && (
        <>
          {data.items.length > 0 && (
            <Card aria-labelledby="webhooks">
              <CardHead id="webhooks" title="Addresses" count={data.items.length} />
              <Rows>
                {data.items.map((webhook) => (
                  <WebhookRow key={webhook.id} webhook={webhook} />
                ))}
              </Rows>
            </Card>
          )}
          <AddWebhook studioId={studioId} projects={data.projects} mayBeLocalhost={data.may_be_localhost} />
        </>
      )}
    </>
  )
}

function WebhookRow({ webhook }: { webhook: Webhook }) {
  const { url, form, events, project, failing_since: failing, disabled_at: disabled } = webhook
  const [isOpen, setOpen] = useState(false)
  const enable = useEnable()
  const rotate = useRotate()
  const test = useTest()
  const remove = useDelete()
  const host = new URL(url).host
  const chosen = EVENTS.filter((event) => events.includes(event))
  return (
    <Row className={classes.webhook}>
      <p className="row wrap">
        <span className="strong">{host}</span>
        <span className="small mid">{`${FORM_WORDS[form]}, ${project ? project.name : 'every project'}`}</span>
        {disabled && <span className="small strong end">{`Disabled ${ago(disabled)}`}</span>}
        {!disabled && failing && <span className="small end">{`Failing since ${ago(failing)}`}</span>}
      </p>
      <p className="small mid wrap-anywhere">{url}</p>
      <p className="small mid">
        {chosen.length === EVENTS.length
          ? 'Every event'
          : chosen.length === 0
            ? 'Tests only'
            : chosen.map((event) => EVENT_WORDS[event]).join('; ')}
      </p>
      {webhook.old_secret_until && !rotate.data && (
        <p className="small mid">Messages are signed by the old secret too, for a day after it was replaced.</p>
      )}
      {rotate.data && <SecretNote webhook={rotate.data} onDone={() => rotate.reset()} />}
      <p className="row wrap">
        <Button aria-expanded={isOpen} onClick={() => setOpen(!isOpen)}>
          Log<span className="visually-hidden"> of {host}</span>
        </Button>
        {disabled === null && (
          <Button onClick={() => test.mutate(webhook, { onSuccess: () => setOpen(true) })}>
            Send a test<span className="visually-hidden"> to {host}</span>
          </Button>
        )}
        <Button onClick={() => enable.mutate({ id: webhook.id, enabled: disabled !== null })}>
          {disabled ? 'Enable' : 'Disable'}
          <span className="visually-hidden"> {host}</span>
        </Button>
        <Button onClick={() => rotate.mutate(webhook)}>
          New secret<span className="visually-hidden"> for {host}</span>
        </Button>
        <ConfirmInline
          variant="quiet"
          aria-label={`Delete ${host}`}
          action="Delete it and its log"
          onConfirm={() => remove.mutate(webhook)}
        >
          Delete
        </ConfirmInline>
      </p>
      <Refusal error={enable.error ?? rotate.error ?? test.error ?? remove.error} />
      {isOpen && <CallsLog webhook={webhook} />}
    </Row>
  )
}
