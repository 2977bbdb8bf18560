import { TextInput } from '@mantine/core'
import { type FormEvent, useState } from 'react'

import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Row, Rows } from '@/ui/Rows'
import { State } from '@/ui/State'

import { type Scope, type Token, type TokenMade, useMakeToken, useRevokeToken, useTokens } from './api'
import classes from './Builds.module.css'
import { Refusal } from './Refusal'
import { ago } from '@/ui/format'

import { against, listed } from './words'

const SCOPE_WORDS: Record<Scope, string> = {
  'spec:read': 'reads the spec',
  'list:read': 'reads the list and waivers',
  'checks:write': 'posts reports',
  'manifest:read': 'fetches the pack and what it is compared by',
  'deliveries:write': 'delivers files',
}
/** What the lines for CI need, and the pack that a build may fetch. */
const FOR_CI: Scope[] = ['spec:read', 'list:read', 'checks:write', 'manifest:read']

/** Make a key for the game's CI. Its secret is shown once, here. */
export function TokenMaker({ projectId }: { projectId: string }) {
  const make = useMakeToken(projectId)
  const [asking, setAsking] = useState(false)
  const [made, setMade] = useState<TokenMade | null>(null)
  const send = (event: FormEvent<HTMLFormElement>) => {
    event.preventDefault()
    const name = new FormData(event.currentTarget).get('name')
    make.mutate(
      { name: typeof name === 'string' ? name : '', scopes: FOR_CI },
      {
        onSuccess: (token) => {
          setMade(token)
          setAsking(false)
        },
      },
    )
  }
  if (made) return <Secret token={made} onDone={() => setMade(null)} />
  if (!asking) {
    return (
      <Button icon="plus" onClick={() => setAsking(true)}>
        Make a token
      </Button>
    )
  }
  return (
    <form onSubmit={send} noValidate className={classes.maker} aria-label="Make a token">
      <TextInput
        name="name"
        label="What the token is for"
        defaultValue="The game’s CI"
        error={against(make.error, 'name')}
        description={`It ${listed(FOR_CI.map((scope) => SCOPE_WORDS[scope]))}, of this project alone.`}
      />
      <div className="row wrap">
        <Button type="submit" variant="primary" aria-busy={make.isPending}>
          Make the token
        </Button>
        <Button variant="quiet" onClick={() => setAsking(false)}>
          Leave it
        </Button>
      </div>
      <Refusal error={make.error} />
    </form>
  )
}

function Secret({ token: { name, secret }, onDone }: { token: TokenMade; onDone: () => void }) {
  const copy = async () => {
    await navigator.clipboard.writeText(secret)
    showToast('The token is copied.')
  }
  return (
    <div className={classes.maker} role="status">
      <p>
        <span className="strong">{`The secret of “${name}” is shown this once.`}</span>{' '}
        <span className="mid">
          Put it into the CI’s secrets as <code className="mono">SOUNDLIST_TOKEN</code>. Lost, it is made anew.
        </span>
      </p>
      <div className={classes.secret}>
        <code className="mono">{secret}</code>
        <Button variant="quiet" square icon="copy" aria-label="Copy the secret" onClick={() => void copy()} />
      </div>
      <div>
        <Button onClick={onDone}>It is kept</Button>
      </div>
    </div>
  )
}

/** Every key of the project's builds, without its secret. */
export function TokensCard({ projectId }: { projectId: string }) {
  const { data: tokens, error } = useTokens(projectId, true)
  const revoke = useRevokeToken(projectId)
  return (
    <Card aria-labelledby="tokens">
      <CardHead id="tokens" title="Tokens" note="for builds; they open no page" />
      <Refusal error={error ?? revoke.error} />
      {tokens?.length === 0 && (
        <div className={classes.inside}>
          <EmptyState head="No token yet." level={3}>
            A build needs one to read the spec and to post what it found.
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
  const { name, scopes, creator, created_at, last_used_at, revoked_at } = token
  const [sure, setSure] = useState(false)
  return (
    <Row className={classes.token}>
      <div className="grow">
        <p className={revoked_at ? 'struck' : 'strong'}>{name}</p>
        <p className="small mid">{listed(scopes.map((scope) => SCOPE_WORDS[scope]))}</p>
        <p className="small dim">
          {`made by ${creator.name} ${ago(created_at)}; ${last_used_at ? `used ${ago(last_used_at)}` : 'never used'}`}
        </p>
      </div>
      {revoked_at !== null && <State kind="cut">Worthless</State>}
      {revoked_at === null && !sure && (
        <Button variant="quiet" aria-label={`Revoke ${name}`} onClick={() => setSure(true)}>
          Revoke
        </Button>
      )}
      {revoked_at === null && sure && (
        <div className="row wrap">
          <span className="small">Builds that use it are turned away at once.</span>
          <Button onClick={onRevoke}>{`Revoke “${name}”`}</Button>
          <Button variant="quiet" onClick={() => setSure(false)}>
            Keep it
          </Button>
        </div>
      )}
    </Row>
  )
}
