import { Checkbox, NativeSelect } from '@mantine/core'
import { useState } from 'react'

import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Field, Form, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { Row, Rows } from '@/ui/Rows'
import { SecretOnce } from '@/ui/SecretOnce'
import { StatusBadge } from '@/ui/StatusBadge'

import { type Scope, type Token, type TokenMade, useMakeToken, useRevokeToken, useTokens } from './api'
import classes from './Builds.module.css'
import { ago, day } from '@/ui/format'
import { TOKEN_LIFETIMES } from '@/ui/tokenLifetimes'

import { listed } from './words'

const SCOPE_WORDS: Record<Scope, string> = {
  'spec:read': 'reads the spec',
  'list:read': 'reads the list and waivers',
  'checks:write': 'posts reports',
  'manifest:read': 'downloads packs and their manifest',
  'deliveries:write': 'delivers files',
  'rights:read': 'reads contracts and sources of approved sounds',
}
/** What the lines for CI need, and the pack that a build may fetch. */
const FOR_CI: Scope[] = ['spec:read', 'list:read', 'checks:write', 'manifest:read']

/** Make a key for the game's CI. Its secret is shown once, here. */
export function TokenMaker({ projectId }: { projectId: string }) {
  const make = useMakeToken(projectId)
  const [asking, setAsking] = useState(false)
  const [token, setToken] = useState<TokenMade | null>(null)
  if (token) return <Secret token={token} onDone={() => setToken(null)} />
  if (!asking) {
    return (
      <Button icon="plus" onClick={() => setAsking(true)}>
        Create token
      </Button>
    )
  }
  return (
    <Form
      className="grid gap-3"
      aria-label="Create token"
      initialValues={{ name: 'Game CI', rights: false, days: '365' }}
      mutation={make}
      onSubmit={({ name, rights, days }) =>
        make.mutate(
          { name, scopes: rights ? [...FOR_CI, 'rights:read'] : FOR_CI, days: Number(days) },
          {
            onSuccess: (created) => {
              setToken(created)
              setAsking(false)
            },
          },
        )
      }
    >
      <Field
        name="name"
        label="Token name"
        description={`It ${listed(FOR_CI.map((scope) => SCOPE_WORDS[scope]))}, of this project alone.`}
      />
      <Field
        as={Checkbox}
        name="rights"
        label="Also reads contracts and sources of approved sounds"
        description="For soundlist why; CI does not need it."
      />
      <Field
        as={NativeSelect}
        name="days"
        label="Works for"
        data={TOKEN_LIFETIMES}
        description="The producers are told two weeks before it ends."
      />
      <Submit onCancel={() => setAsking(false)}>Create token</Submit>
    </Form>
  )
}

function Secret({ token: { name, secret }, onDone }: { token: TokenMade; onDone: () => void }) {
  return (
    <div className="grid gap-3">
      <SecretOnce secret={secret} what="Token" name={name} onDone={onDone}>
        Add it to the CI’s secrets as <code className="mono">SOUNDLIST_TOKEN</code>. If you lose it, create a new token.
      </SecretOnce>
    </div>
  )
}

/** Every key of the project's builds, without its secret. */
export function TokensCard({ projectId }: { projectId: string }) {
  const { data: tokens, error } = useTokens(projectId, true)
  const revoke = useRevokeToken(projectId)
  return (
    <Card aria-labelledby="tokens">
      <CardHead id="tokens" title="Tokens" note="access for builds" />
      <Refusal inset error={error ?? revoke.error} />
      {tokens?.length === 0 && (
        <div className={classes.inside}>
          <EmptyState head="No tokens yet" level={3}>
            A build needs a token to read the spec and report its results.
          </EmptyState>
        </div>
      )}
      <Rows aria-label="Tokens">
        {tokens?.map((token) => (
          <TokenRow key={token.id} token={token} onRevoke={() => revoke.mutate(token.id)} />
        ))}
      </Rows>
      <div className={classes.inside}>
        <TokenMaker projectId={projectId} />
      </div>
    </Card>
  )
}

function TokenRow({ token, onRevoke }: { token: Token; onRevoke: () => void }) {
  const { name, scopes, creator, created_at, last_used_at, expires_at, revoked_at } = token
  const isOver = new Date(expires_at) <= new Date()
  const works = revoked_at === null && !isOver
  const [sure, setSure] = useState(false)
  return (
    <Row className={classes.token}>
      <div className="grow">
        <p className={works ? 'strong' : 'struck'}>{name}</p>
        <p className="small mid">{listed(scopes.map((scope) => SCOPE_WORDS[scope]))}</p>
        <p className="small dim">
          {`created by ${creator.name} ${ago(created_at)}; ${last_used_at ? `used ${ago(last_used_at)}` : 'never used'}; ${isOver ? 'ended' : 'ends'} ${day(expires_at)}`}
        </p>
      </div>
      {!works && <StatusBadge kind="cut">{revoked_at === null ? 'Ended' : 'Revoked'}</StatusBadge>}
      {works && !sure && (
        <Button variant="quiet" aria-label={`Revoke ${name}`} onClick={() => setSure(true)}>
          Revoke
        </Button>
      )}
      {works && sure && (
        <div className="row wrap">
          <span className="small">Builds that use it stop working immediately.</span>
          <Button onClick={onRevoke}>{`Revoke “${name}”`}</Button>
          <Button variant="quiet" onClick={() => setSure(false)}>
            Cancel
          </Button>
        </div>
      )}
    </Row>
  )
}
