import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { del, get, post, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'

import { sessionQuery } from './api'

/** Whether this browser makes and asks for passkeys here: over TLS or on this machine, under a name. */
export const hasPasskeys = (): boolean =>
  globalThis.isSecureContext &&
  'PublicKeyCredential' in globalThis &&
  'parseRequestOptionsFromJSON' in PublicKeyCredential &&
  !/^[\d.]+$|^\[/.test(globalThis.location.hostname)

/** Whether the person, or the browser, has declined; nothing was sent. */
export const isCancelled = (error: unknown): boolean => error instanceof DOMException

const jsonOf = (credential: Credential | null): Record<string, unknown> => {
  if (!(credential instanceof PublicKeyCredential)) throw new Error('The browser gave no passkey.')
  const json: unknown = credential.toJSON()
  return json as Record<string, unknown>
}

export const passkeysQuery = queryOptions({
  queryKey: queryKeys.passkeys(),
  queryFn: () => get('/v1/me/passkeys'),
})

/** Have the browser make a passkey, and keep it under a name. */
export function useAddPasskey() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: async (name: string) => {
      const { public_key } = await post('/v1/me/passkeys/options')
      const publicKey = PublicKeyCredential.parseCreationOptionsFromJSON(
        public_key as unknown as PublicKeyCredentialCreationOptionsJSON,
      )
      const credential = jsonOf(await navigator.credentials.create({ publicKey }))
      return post('/v1/me/passkeys', {}, { name, credential })
    },
    onSettled: () =>
      invalidate(client, queryKeys.passkeys(), queryKeys.secondFactors(), queryKeys.signIns(), queryKeys.me()),
  })
}

export function useRemovePasskey() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (id: string) => del('/v1/me/passkeys/{passkey_id}', { passkey_id: id }),
    onSettled: () => invalidate(client, queryKeys.passkeys(), queryKeys.secondFactors(), queryKeys.me()),
  })
}

/** Sign in with any passkey of this server that the browser has. */
export function usePasskeySignIn() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: async () => {
      await client.ensureQueryData(sessionQuery) // the first write of a page needs its token too
      const { public_key } = await post('/v1/passkeys/options')
      const publicKey = PublicKeyCredential.parseRequestOptionsFromJSON(
        public_key as unknown as PublicKeyCredentialRequestOptionsJSON,
      )
      const credential = jsonOf(await navigator.credentials.get({ publicKey }))
      return post('/v1/passkeys/sign-in', {}, { credential })
    },
  })
}
