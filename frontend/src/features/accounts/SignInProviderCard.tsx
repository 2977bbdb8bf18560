import { useQuery } from '@tanstack/react-query'

import { Field, Form, Submit } from '@/ui/Form'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'

import { CardProblem } from './CardProblem'
import { signInProviderQuery, useRemoveSignInProvider, useSetSignInProvider } from './providerApi'

/** The OpenID Connect provider by which the studio's people sign in. */
export function SignInProviderCard({ studioId }: { studioId: string }) {
  const { data: provider, error } = useQuery(signInProviderQuery(studioId))
  const save = useSetSignInProvider(studioId)
  const remove = useRemoveSignInProvider(studioId)
  return (
    <Card aria-labelledby="sign-in-provider">
      <CardHead id="sign-in-provider" title="Sign-in provider" note="OpenID Connect" />
      <CardProblem error={error ?? remove.error} />
      {provider && (
        <div className="p-3-inset">
          <p className="small mid">
            {provider.domains.length > 0
              ? `Signs in addresses of ${provider.domains.join(', ')}.`
              : 'No domain is bound to the studio yet. The server’s administrator binds one.'}{' '}
            Enter this redirect address at the provider: <code className="wrap-anywhere">{provider.redirect_uri}</code>
          </p>
          {provider.issuer === null ? (
            <Form
              initialValues={{ issuer: '', client_id: '', client_secret: '' }}
              mutation={save}
              onSubmit={(values) => save.mutate(values, { onSuccess: () => showToast('Saved.') })}
            >
              <Field
                name="issuer"
                label="Issuer"
                description="As the provider writes it: https://login.studio.example"
              />
              <Field name="client_id" label="Client ID" autoComplete="off" />
              <Field name="client_secret" label="Client secret" type="password" autoComplete="off" />
              <Submit>Save provider</Submit>
            </Form>
          ) : (
            <>
              <p className="wrap-anywhere">
                <span className="strong">{provider.issuer}</span>{' '}
                <span className="small mid">client {provider.client_id}</span>
              </p>
              <Button
                aria-busy={remove.isPending}
                onClick={() => remove.mutate(undefined, { onSuccess: () => showToast('Removed.') })}
              >
                Remove provider
              </Button>
            </>
          )}
        </div>
      )}
    </Card>
  )
}
