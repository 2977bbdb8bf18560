import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { Field, Form, Submit } from '@/ui/Form'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { CopyButton } from '@/ui/CopyButton'
import { day } from '@/ui/format'
import { StatusBadge } from '@/ui/StatusBadge'

import classes from './Account.module.css'
import { CardProblem } from './CardProblem'
import { passkeysQuery } from './passkeyApi'
import {
  secondFactorsQuery,
  type TotpSetup,
  useBeginTotp,
  useConfirmTotp,
  useEndTotp,
  useRenewRecoveryCodes,
} from './secondFactorApi'

/** The authenticator app and the recovery codes that a sign-in asks for besides the password. */
export function SecondFactorCard() {
  const { data: factors, error } = useQuery(secondFactorsQuery)
  const { data: passkeys } = useQuery(passkeysQuery)
  const begin = useBeginTotp()
  const end = useEndTotp()
  const renew = useRenewRecoveryCodes()
  const [setup, setSetup] = useState<TotpSetup | null>(null)
  const [codes, setCodes] = useState<readonly string[] | null>(null)
  const isOn = factors !== undefined && factors.totp_since !== null
  const hasPasskey = (passkeys?.length ?? 0) > 0
  const codesLeft = factors?.recovery_codes_left ?? 0
  const recovery = (
    <p className="small mid">
      {codesLeft === 0
        ? 'No recovery codes are left: create new ones before you lose your device.'
        : `Recovery codes left: ${codesLeft}. Each signs in once, after your password.`}
    </p>
  )
  const renewal = (
    <Button
      aria-busy={renew.isPending}
      onClick={() => renew.mutate(undefined, { onSuccess: ({ recovery_codes }) => setCodes(recovery_codes) })}
    >
      Create new recovery codes
    </Button>
  )
  return (
    <Card aria-labelledby="second-factor">
      <CardHead id="second-factor" title="Second factor" note="asked for when you sign in, besides your password" />
      <CardProblem error={error ?? begin.error ?? end.error ?? renew.error} />
      <div className={`${classes.inside} ${classes.note} stack`}>
        {codes !== null ? (
          <RecoveryCodes codes={codes} onDone={() => setCodes(null)} />
        ) : setup !== null ? (
          <Setup
            setup={setup}
            onCancel={() => setSetup(null)}
            onConfirmed={(recoveryCodes) => {
              setSetup(null)
              setCodes(recoveryCodes)
            }}
          />
        ) : isOn ? (
          <>
            <p className="flex wrap between gap-2 pt-3 wrap-anywhere">
              <span>Authenticator app, since {day(factors.totp_since ?? '')}</span>
              <StatusBadge kind="passed">On</StatusBadge>
            </p>
            {recovery}
            <div className="row wrap">
              {renewal}
              <Button
                variant="quiet"
                aria-busy={end.isPending}
                onClick={() =>
                  end.mutate(undefined, { onSuccess: () => showToast('The authenticator app was removed.') })
                }
              >
                Remove authenticator app
              </Button>
            </div>
          </>
        ) : (
          factors !== undefined && (
            <>
              <p className="flex wrap between gap-2 pt-3 wrap-anywhere">
                <span>Authenticator app</span>
                <StatusBadge kind="warning">Off</StatusBadge>
              </p>
              <p className="small mid">
                With an app such as Aegis, 1Password or Google Authenticator, a stolen password alone does not sign in.
              </p>
              {hasPasskey && recovery}
              <div className="row wrap">
                {hasPasskey && renewal}
                <Button aria-busy={begin.isPending} onClick={() => begin.mutate(undefined, { onSuccess: setSetup })}>
                  Set up authenticator app
                </Button>
              </div>
            </>
          )
        )}
      </div>
    </Card>
  )
}

interface SetupProps {
  setup: TotpSetup
  onCancel: () => void
  onConfirmed: (recoveryCodes: readonly string[]) => void
}

function Setup({ setup: { secret, qr_svg }, onCancel, onConfirmed }: SetupProps) {
  const confirm = useConfirmTotp()
  return (
    <>
      <p>Scan this with your authenticator app, or type the key into it.</p>
      <img
        className={classes.qrCode}
        src={`data:image/svg+xml;charset=utf-8,${encodeURIComponent(qr_svg)}`}
        alt="QR code for the authenticator app; the key below says the same"
      />
      <p>
        <span className="small mid">Key</span>{' '}
        <code className="mono wrap-anywhere">{secret.match(/.{1,4}/g)?.join(' ')}</code>{' '}
        <CopyButton text={secret} what="Key">
          Copy key
        </CopyButton>
      </p>
      <Form
        initialValues={{ code: '' }}
        mutation={confirm}
        onSubmit={({ code }) =>
          confirm.mutate(code, { onSuccess: ({ recovery_codes }) => onConfirmed(recovery_codes) })
        }
      >
        <Field
          name="code"
          label="Code"
          autoComplete="one-time-code"
          description="The six digits that the app shows now. Your other browsers are signed out."
        />
        <Submit
          beside={
            <Button variant="quiet" onClick={onCancel}>
              Cancel
            </Button>
          }
        >
          Turn on
        </Submit>
      </Form>
    </>
  )
}

/** Recovery codes, shown once. */
export function RecoveryCodes({ codes, onDone }: { codes: readonly string[]; onDone: () => void }) {
  return (
    <div className="stack" role="status">
      <p>
        <span className="strong">Save these recovery codes now. They are not shown again.</span>{' '}
        <span className="mid">Each signs in once in place of the app. Earlier codes no longer work.</span>
      </p>
      <ul className={`mono grid gap-1-4 ${classes.recoveryCodes}`} aria-label="Recovery codes">
        {codes.map((code) => (
          <li key={code}>{code}</li>
        ))}
      </ul>
      <div className="row wrap">
        <CopyButton text={codes.join('\n')} what="Recovery codes">
          Copy codes
        </CopyButton>
        <Button variant="quiet" onClick={onDone}>
          I’ve saved them
        </Button>
      </div>
    </div>
  )
}
