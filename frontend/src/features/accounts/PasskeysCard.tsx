import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ago, day } from '@/ui/format'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { Field, Form, Submit } from '@/ui/Form'
import { Row, Rows } from '@/ui/Rows'

import classes from './Account.module.css'
import { CardProblem } from './CardProblem'
import { hasPasskeys, isCancelled, passkeysQuery, useAddPasskey, useRemovePasskey } from './passkeyApi'
import { RecoveryCodes } from './SecondFactorCard'

/** Keys on one's devices that sign in without password and code. */
export function PasskeysCard() {
  const { data: passkeys, error } = useQuery(passkeysQuery)
  const add = useAddPasskey()
  const remove = useRemovePasskey()
  const [codes, setCodes] = useState<readonly string[]>([])
  return (
    <Card aria-labelledby="passkeys">
      <CardHead id="passkeys" title="Passkeys" note="sign in without password and code" />
      <CardProblem error={error ?? remove.error} />
      {isCancelled(add.error) && (
        <div className={`${classes.inside} ${classes.note}`}>
          <ErrorBanner detail="No passkey was added: the browser was not allowed to make one." />
        </div>
      )}
      <Rows aria-label="Passkeys">
        {passkeys?.map(({ id, name, created_at, last_used_at }) => (
          <Row key={id}>
            <div className="grow">
              <p className="strong">{name}</p>
              <p className="small mid">
                {`added ${day(created_at)}, ${last_used_at ? `last used ${ago(last_used_at)}` : 'never used'}`}
              </p>
            </div>
            <Button
              variant="quiet"
              aria-label={`Remove ${name}`}
              onClick={() => remove.mutate(id, { onSuccess: () => showToast(`“${name}” was removed.`) })}
            >
              Remove
            </Button>
          </Row>
        ))}
      </Rows>
      <div className={`${classes.inside} ${classes.note}`}>
        {codes.length > 0 ? (
          <RecoveryCodes codes={codes} onDone={() => setCodes([])} />
        ) : hasPasskeys() ? (
          <Form
            className="stack"
            aria-label="Add passkey"
            initialValues={{ name: 'My device' }}
            mutation={{ ...add, error: isCancelled(add.error) ? null : add.error }}
            onSubmit={({ name }) =>
              add.mutate(name, {
                onSuccess: (passkey) => {
                  setCodes(passkey.recovery_codes)
                  showToast(`“${passkey.name}” was added. Your other browsers are signed out.`)
                },
              })
            }
          >
            <Field name="name" label="Passkey name" description="Your password alone then no longer signs in." />
            <Submit variant="plain">Add passkey</Submit>
          </Form>
        ) : (
          <p className="small mid">This browser makes no passkeys here: they need HTTPS and a host name.</p>
        )}
      </div>
    </Card>
  )
}
