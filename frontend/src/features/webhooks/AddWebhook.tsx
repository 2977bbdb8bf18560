import { Checkbox, TextInput } from '@mantine/core'
import { type FormEvent } from 'react'

import { ApiProblem } from '@/api'
import { DraftNote, useDraft } from '@/app/drafts'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { Select } from '@/ui/Select'

import { useAddWebhook, type WebhookForm } from './api'
import { SecretNote } from './SecretNote'
import classes from './Webhooks.module.css'
import { EVENTS, EVENT_WORDS, FORM_WORDS } from './words'

type Chosen = (typeof EVENTS)[number]

interface AddWebhookProps {
  studioId: string
  projects: readonly { id: string; name: string }[]
  mayBeLocalhost: boolean
}

const EMPTY = { url: '', form: 'json' as WebhookForm, projectId: '', events: EVENTS as readonly Chosen[] }

/** An address to call, for which events, and how the message is written. */
export function AddWebhook({ studioId, projects, mayBeLocalhost }: AddWebhookProps) {
  const [{ url, form, projectId, events }, setTyped, draft] = useDraft(`webhook:${studioId}`, EMPTY)
  const add = useAddWebhook(studioId)
  const problem = add.error instanceof ApiProblem ? add.error : null
  const change = (part: Partial<typeof EMPTY>) => setTyped((now) => ({ ...now, ...part }))
  const toggle = (event: Chosen) =>
    change({
      events: EVENTS.filter((candidate) =>
        candidate === event ? !events.includes(candidate) : events.includes(candidate),
      ),
    })
  const send = (event: FormEvent) => {
    event.preventDefault()
    if (add.isPending || url.trim() === '' || events.length === 0) return
    add.mutate(
      { url: url.trim(), form, events: [...events], project_id: projectId === '' ? null : projectId },
      { onSuccess: () => draft.discard() },
    )
  }
  return (
    <Card aria-labelledby="add-webhook">
      <CardHead id="add-webhook" title="Add an address" />
      {add.data ? (
        <div className="grid gap-3 p-3-inset-4">
          <SecretNote webhook={add.data} onDone={() => add.reset()} />
        </div>
      ) : (
        <form className="grid gap-3 p-3-inset-4" aria-label="Add an address" onSubmit={send} noValidate>
          <TextInput
            label="Address"
            type="url"
            inputMode="url"
            spellCheck={false}
            placeholder="https://"
            description={
              mayBeLocalhost
                ? 'A public host by https, or localhost: this server lets webhooks call its own machine.'
                : 'A public host by https. For a chat, its incoming webhook.'
            }
            value={url}
            maxLength={2_000}
            error={problem?.of('url')?.message}
            onChange={(event) => change({ url: event.currentTarget.value })}
          />
          <div className={classes.pair}>
            <Select
              label="Message"
              value={form}
              onChange={(event) => change({ form: event.currentTarget.value as WebhookForm })}
            >
              {Object.entries(FORM_WORDS).map(([value, label]) => (
                <option key={value} value={value}>
                  {label}
                </option>
              ))}
            </Select>
            <Select
              label="Project"
              value={projectId}
              onChange={(event) => change({ projectId: event.currentTarget.value })}
            >
              <option value="">Every project</option>
              {projects.map(({ id, name }) => (
                <option key={id} value={id}>
                  {name}
                </option>
              ))}
            </Select>
          </div>
          <fieldset className={classes.events}>
            <legend className="small strong">Events</legend>
            {EVENTS.map((event) => (
              <Checkbox
                key={event}
                label={EVENT_WORDS[event]}
                checked={events.includes(event)}
                onChange={() => toggle(event)}
              />
            ))}
          </fieldset>
          {events.length === 0 && <p className="small">Choose at least one event.</p>}
          <DraftNote draft={draft} />
          {problem && problem.errors.length === 0 && <ErrorBanner detail={problem.detail} fix={problem.fix} />}
          <div>
            <Button
              type="submit"
              variant="primary"
              aria-busy={add.isPending}
              disabled={url.trim() === '' || events.length === 0}
            >
              Add the address
            </Button>
          </div>
        </form>
      )}
    </Card>
  )
}
