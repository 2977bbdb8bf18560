import { useQuery } from '@tanstack/react-query'

import { Button } from '@/ui/Button'
import { useDebounced } from '@/ui/useDebounced'

import { CardProblem } from './CardProblem'
import { domainOf, providerOfDomainQuery, useBeginProviderSignIn } from './providerApi'

interface ProviderButtonProps {
  /** "Sign in". */
  verb: string
  email: string
  /** The page to go on to. */
  nextPath: string
}

/** Leads to the sign-in provider of a studio, where an address is of a domain bound to the studio. */
export function ProviderButton({ verb, email, nextPath }: ProviderButtonProps) {
  const { data: provider } = useQuery(providerOfDomainQuery(useDebounced(domainOf(email))))
  const begin = useBeginProviderSignIn()
  const studioId = provider?.studio_id
  if (!studioId) return null
  return (
    <div className="stack justify-items-start mt-4">
      <CardProblem error={begin.error} />
      <Button
        aria-busy={begin.isPending}
        onClick={() =>
          begin.mutate(
            { studio_id: studioId, next_path: nextPath },
            { onSuccess: ({ url }) => globalThis.location.assign(url) },
          )
        }
      >
        {verb} with {provider.studio_name}
      </Button>
    </div>
  )
}
