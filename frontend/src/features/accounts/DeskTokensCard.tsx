import { NativeSelect } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Field, Form, Submit } from '@/ui/Form'
import { ago, day } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'
import { SecretOnce } from '@/ui/SecretOnce'
import { TOKEN_LIFETIMES } from '@/ui/tokenLifetimes'

import classes from './Account.module.css'
import { type DeskTokenMade, deskTokensQuery, useCreateDeskToken, useRevokeDeskToken } from './api'
import { CardProblem } from './CardProblem'

/** Keys with which `soundlist desk` on one's own machine reads what one owes. */
export function DeskTokensCard() {
  const { data: tokens, error } = useQuery(deskTokensQuery)
  const create = useCreateDeskToken()
  const revoke = useRevokeDeskToken()
  const [token, setToken] = useState<DeskTokenMade | null>(null)
  return (
    <Card aria-labelledby="desk-tokens">
      <CardHead id="desk-tokens" title="Desk tokens" note="for soundlist desk" />
      <CardProblem error={error ?? revoke.error} />
      <Rows aria-label="Desk tokens">
        {tokens?.map(({ id, name, created_at, last_used_at, expires_at }) => (
          <Row key={id}>
            <div className="grow">
              <p className="strong">{name}</p>
              <p className="small mid">
                {`created ${day(created_at)}, ${last_used_at ? `last used ${ago(last_used_at)}` : 'never used'}, ends ${day(expires_at)}`}
              </p>
            </div>
            <Button
              variant="quiet"
              aria-label={`Revoke ${name}`}
              onClick={() => revoke.mutate(id, { onSuccess: () => showToast(`“${name}” is revoked.`) })}
            >
              Revoke
            </Button>
          </Row>
        ))}
      </Rows>
      <div className={`${classes.inside} ${classes.note}`}>
        {token ? (
          <Secret token={token} onDone={() => setToken(null)} />
        ) : (
          <Form
            className="stack"
            aria-label="Create desk token"
            initialValues={{ name: 'My computer', days: '365' }}
            mutation={create}
            onSubmit={({ name, days }) => create.mutate({ name, days: Number(days) }, { onSuccess: setToken })}
          >
            <Field
              name="name"
              label="Token name"
              description="It reads what you owe in all projects, and nothing else."
            />
            <Field
              as={NativeSelect}
              name="days"
              label="Works for"
              data={TOKEN_LIFETIMES}
              description="You are told two weeks before it ends."
            />
            <Submit
              variant="plain"
              className="row wrap"
              beside={
                <a href="/v1/me/soundlist.pyz" download>
                  Download soundlist.pyz
                </a>
              }
            >
              Create token
            </Submit>
          </Form>
        )}
      </div>
    </Card>
  )
}

function Secret({ token: { name, secret }, onDone }: { token: DeskTokenMade; onDone: () => void }) {
  return (
    <SecretOnce secret={secret} what="Token" name={name} onDone={onDone}>
      Paste it when <code className="mono">{`python3 soundlist.pyz desk add ${window.location.origin}`}</code> asks for
      it.
    </SecretOnce>
  )
}
