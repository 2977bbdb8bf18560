import { Checkbox, NativeSelect } from '@mantine/core'

import { DraftForm } from '@/app/drafts/DraftForm'
import { Card, CardHead } from '@/ui/Card'
import { Field, Submit } from '@/ui/Form'

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
  const add = useAddWebhook(studioId)
  return (
    <Card aria-labelledby="add-webhook">
      <CardHead id="add-webhook" title="Add an address" />
      {add.data ? (
        <div className="grid gap-3 p-3-inset-4">
          <SecretNote webhook={add.data} onDone={() => add.reset()} />
        </div>
      ) : (
        <DraftForm
          className="grid gap-3 p-3-inset-4"
          aria-label="Add an address"
          draftKey={`webhook:${studioId}`}
          initialValues={EMPTY}
          mutation={add}
          onSubmit={({ url, form, projectId, events }, onSuccess) =>
            add.mutate({ url: url.trim(), form, events: [...events], project_id: projectId || null }, { onSuccess })
          }
        >
          {({ events }, change) => (
            <>
              <Field
                name="url"
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
                maxLength={2_000}
              />
              <div className={classes.pair}>
                <Field
                  as={NativeSelect}
                  name="form"
                  label="Message"
                  data={Object.entries(FORM_WORDS).map(([value, label]) => ({ value, label }))}
                />
                <Field
                  as={NativeSelect}
                  optional
                  name="projectId"
                  label="Project"
                  data={[
                    { value: '', label: 'Every project' },
                    ...projects.map(({ id, name }) => ({ value: id, label: name })),
                  ]}
                />
              </div>
              <fieldset className={`m-0 p-0 border-0 ${classes.events}`}>
                <legend className="small strong">Events</legend>
                {EVENTS.map((event) => (
                  <Checkbox
                    key={event}
                    label={EVENT_WORDS[event]}
                    checked={events.includes(event)}
                    onChange={() =>
                      change({
                        events: EVENTS.filter((other) => (other === event) !== events.includes(other)),
                      })
                    }
                  />
                ))}
              </fieldset>
              {events.length === 0 && <p className="small">Choose at least one event.</p>}
              <Submit disabled={events.length === 0}>Add the address</Submit>
            </>
          )}
        </DraftForm>
      )}
    </Card>
  )
}
