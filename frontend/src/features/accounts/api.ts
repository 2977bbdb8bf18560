import { queryOptions, useQuery, useQueryClient } from '@tanstack/react-query'

import { unwrap, api, del, get, post, put, queryById, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type MyStudio = Schemas['MyStudio']
export type Member = Schemas['MemberRead']
export type Role = Schemas['Role']
export type AccessKind = Schemas['AccessKind']
export type DepartureItem = Schemas['DepartureItem']
export type StudioInvitation = Schemas['StudioInvitationRead']
export type Mail = Schemas['MailRead']
export type Quota = Schemas['QuotaRead']
export type InvoiceDetails = Required<Schemas['InvoiceDetailsSave']>
export type StudioCalendar = Schemas['CalendarSave'] & { holidays: Schemas['HolidayAdd'][] }

const MINUTE_MS = 60_000

/** Whether the person is signed in; the request also fetches the token that this page's writes must carry. */
export const sessionQuery = queryOptions({
  queryKey: queryKeys.session(),
  queryFn: () => get('/v1/session'),
  staleTime: MINUTE_MS,
})

/** A sign-in makes a new session, whose token the next write must carry. */
function useEntrance<Body, Answer>(enter: (body: Body) => Promise<Answer>) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: async (body: Body) => {
      // The first write of a page needs its token too.
      await client.ensureQueryData(sessionQuery)
      const answer = await enter(body)
      client.clear()
      return answer
    },
  })
}

export const useSignIn = () => useEntrance((body: Schemas['SignInAdd']) => post('/v1/sign-in', {}, body))

export const useSignUp = () => useEntrance((body: Schemas['SignUpAdd']) => post('/v1/sign-up', {}, body))

/** Whether anyone may open an account here, and whether a link is mailed first. */
export const signUpQuery = queryOptions({
  queryKey: queryKeys.signUp(),
  queryFn: () => get('/v1/sign-up'),
})

export const useAskSignUp = () =>
  useMutation({
    mutationFn: (body: Schemas['SignUpRequest']) => post('/v1/sign-ups', {}, body),
  })

export const signUpLinkQuery = queryById('/v1/sign-ups/{secret}', queryKeys.signUpLink, {
  retry: false,
})

export const useFinishSignUp = (secret: string) =>
  useEntrance((body: Schemas['SignUpFinish']) => post('/v1/sign-ups/{secret}', { secret }, body))

export const useAskVerification = () => useMutation({ mutationFn: () => post('/v1/me/email-verifications') })

export const useVerifyEmail = (secret: string) =>
  useMutation({
    mutationFn: () => post('/v1/email-verifications/{secret}', { secret }),
    affects: [queryKeys.me()],
  })

export type SignIn = Schemas['SignInRead']

export const signInsQuery = queryOptions({
  queryKey: queryKeys.signIns(),
  queryFn: () => get('/v1/me/sign-ins'),
})

export function useEndSignIn() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (id: string) => del('/v1/me/sign-ins/{sign_in_id}', { sign_in_id: id }),
    onSettled: () => invalidate(client, queryKeys.signIns()),
  })
}

export function useEndOtherSignIns() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () => del('/v1/me/sign-ins'),
    onSettled: () => invalidate(client, queryKeys.signIns()),
  })
}

export type DeskTokenMade = Schemas['DeskTokenMade']

export const deskTokensQuery = queryOptions({
  queryKey: queryKeys.deskTokens(),
  queryFn: () => get('/v1/me/desk-tokens'),
})

export function useCreateDeskToken() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Schemas['DeskTokenAdd']) => post('/v1/me/desk-tokens', {}, body),
    onSettled: () => invalidate(client, queryKeys.deskTokens()),
  })
}

export function useRevokeDeskToken() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (id: string) => del('/v1/me/desk-tokens/{desk_token_id}', { desk_token_id: id }),
    onSettled: () => invalidate(client, queryKeys.deskTokens()),
  })
}

export type MailPreferences = Schemas['MailPreferencesRead']
export type News = Schemas['News']
export type Cadence = Schemas['Cadence']

export const mailPreferencesQuery = queryOptions({
  queryKey: queryKeys.mailPreferences(),
  queryFn: () => get('/v1/me/mail-preferences'),
})

export function useSaveMailPreferences() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: MailPreferences) => put('/v1/me/mail-preferences', {}, body),
    onSuccess: (saved) => client.setQueryData(queryKeys.mailPreferences(), saved),
  })
}

/** What the link at the end of a mail changes. */
export const mailChoiceQuery = queryById('/v1/mail-choices/{secret}', queryKeys.mailChoice, {
  retry: false,
})

export function useChooseMail(secret: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: async (cadence: Cadence) => {
      await client.ensureQueryData(sessionQuery) // the first write of a page needs its token too
      return put('/v1/mail-choices/{secret}', { secret }, { cadence })
    },
    onSuccess: (saved) => {
      client.setQueryData(queryKeys.mailChoice(secret), saved)
      return invalidate(client, queryKeys.mailPreferences())
    },
  })
}

export const useNewPassword = (secret: string) =>
  useEntrance((password: string) => post('/v1/password-resets/{secret}', { secret }, { password }))

export const useJoinStudio = (secret: string) =>
  useEntrance((body: Schemas['InvitationAccept']) => post('/v1/studio-invitations/{secret}/accept', { secret }, body))

export const useAskReset = () =>
  useMutation({
    mutationFn: (email: string) => post('/v1/password-resets', {}, { email }),
  })

export const studioInvitationQuery = queryById('/v1/studio-invitations/{secret}', queryKeys.studioInvitation)

export const useRename = () =>
  useMutation({
    mutationFn: (name: string) => put('/v1/me', {}, { name }),
    affects: [queryKeys.me()],
  })

/** Choose a picture, or with null take it away. */
export function useSavePicture() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (file: Blob | null) =>
      file === null
        ? del('/v1/me/picture')
        : unwrap(
            api.PUT('/v1/me/picture', {
              headers: { 'Content-Type': 'application/octet-stream' },
              body: file as unknown as string, // how OpenAPI's `binary` is typed
              bodySerializer: (body: unknown) => body as BodyInit,
            }),
          ),
    onSuccess: () => client.invalidateQueries(),
  })
}

export const useChangePassword = () =>
  useMutation({
    mutationFn: (body: Schemas['PasswordChange']) => put('/v1/me/password', {}, body),
    affects: [queryKeys.deskTokens()],
  })

export const useOpenStudio = () =>
  useMutation({
    mutationFn: (name: string) => post('/v1/studios', {}, { name }),
    affects: [queryKeys.me()],
  })

export const useRenameStudio = (studioId: string) =>
  useMutation({
    mutationFn: (body: Schemas['StudioChange']) => put('/v1/studios/{studio_id}', { studio_id: studioId }, body),
    affects: [queryKeys.me()],
  })

export const usePeople = (studioId: string) =>
  useQuery({
    queryKey: queryKeys.studioPeople(studioId),
    queryFn: () => get('/v1/studios/{studio_id}/people', { studio_id: studioId }),
  })

export const useInvitations = (studioId: string, enabled: boolean) =>
  useQuery({
    queryKey: queryKeys.studioInvitations(studioId),
    queryFn: () => get('/v1/studios/{studio_id}/invitations', { studio_id: studioId }),
    enabled,
  })

export const useOutbox = (studioId: string, enabled: boolean) =>
  useQuery({
    queryKey: queryKeys.outbox(studioId),
    queryFn: () => get('/v1/studios/{studio_id}/outbox', { studio_id: studioId }),
    enabled,
    // The worker writes and sends mails a moment after their event.
    refetchInterval: 2_000,
  })

export const useQuotas = (studioId: string) =>
  useQuery({
    queryKey: queryKeys.quotas(studioId),
    queryFn: () => get('/v1/studios/{studio_id}/quotas', { studio_id: studioId }),
  })

export function useSetRoles(studioId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: ({ personId, roles, handOverTo }: { personId: string; roles: Role[]; handOverTo?: string | null }) =>
      put(
        '/v1/studios/{studio_id}/people/{person_id}',
        { studio_id: studioId, person_id: personId },
        handOverTo ? { roles, hand_over_to: handOverTo } : { roles },
      ),
    onSettled: () => invalidate(client, queryKeys.studioPeople(studioId)),
  })
}

const departureQuery = (studioId: string, personId: string, roles: Role[]) =>
  queryOptions({
    queryKey: queryKeys.departure(studioId, personId, roles),
    queryFn: () =>
      get('/v1/studios/{studio_id}/people/{person_id}/departure', { studio_id: studioId, person_id: personId, roles }),
    staleTime: 0,
  })

/** What would end if a member had these roles alone, or with none left the studio. */
export const useDeparture = (studioId: string, personId: string, roles: Role[]) =>
  useQuery(departureQuery(studioId, personId, roles))

export function useFetchDeparture(studioId: string) {
  const client = useQueryClient()
  return (personId: string, roles: Role[]) => client.fetchQuery(departureQuery(studioId, personId, roles))
}

export function useRemoveMember(studioId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: ({ personId, handOverTo, keep }: { personId: string; handOverTo: string | null; keep: AccessKind[] }) =>
      del('/v1/studios/{studio_id}/people/{person_id}', {
        studio_id: studioId,
        person_id: personId,
        keep,
        ...(handOverTo && { hand_over_to: handOverTo }),
      }),
    onSettled: () => invalidate(client, queryKeys.studioPeople(studioId)),
  })
}

export const useInvite = (studioId: string) =>
  useMutation({
    mutationFn: (body: Schemas['StudioInvitationAdd']) =>
      post('/v1/studios/{studio_id}/invitations', { studio_id: studioId }, body),
    affects: [queryKeys.studioInvitations(studioId), queryKeys.outbox(studioId)],
  })

export function useWithdraw(studioId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (invitationId: string) =>
      del('/v1/studios/{studio_id}/invitations/{studio_invitation_id}', {
        studio_id: studioId,
        studio_invitation_id: invitationId,
      }),
    onSettled: () => invalidate(client, queryKeys.studioInvitations(studioId)),
  })
}

export function useSendMail(studioId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (mailId: string) => post('/v1/mails/{mail_id}/send', { mail_id: mailId }),
    onSettled: () => invalidate(client, queryKeys.outbox(studioId)),
  })
}

export const useStudioCalendar = (studioId: string) =>
  useQuery({
    queryKey: queryKeys.studioCalendar(studioId),
    queryFn: () => get('/v1/studios/{studio_id}/calendar', { studio_id: studioId }),
  })

export function useSaveStudioCalendar(studioId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: ({ time_zone, holidays }: StudioCalendar) =>
      put(
        '/v1/studios/{studio_id}/calendar',
        { studio_id: studioId },
        { time_zone, holidays: holidays.map(({ day, name }) => ({ day, name })) },
      ),
    onSuccess: (saved) => client.setQueryData(queryKeys.studioCalendar(studioId), saved),
  })
}

const DETAILS_OF_STUDIO = '/v1/studios/{studio_id}/invoice-details'
const DETAILS_OF_ME = '/v1/me/invoice-details'

/** What electronic invoices say of a studio, or of the caller where none is named. */
export const useInvoiceDetails = (studioId?: string) =>
  useQuery({
    queryKey: queryKeys.invoiceDetails(studioId ?? 'me'),
    queryFn: (): Promise<InvoiceDetails> =>
      studioId === undefined ? get(DETAILS_OF_ME) : get(DETAILS_OF_STUDIO, { studio_id: studioId }),
  })

export function useSaveInvoiceDetails(studioId?: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: InvoiceDetails): Promise<InvoiceDetails> =>
      studioId === undefined ? put(DETAILS_OF_ME, {}, body) : put(DETAILS_OF_STUDIO, { studio_id: studioId }, body),
    onSuccess: (saved) => client.setQueryData(queryKeys.invoiceDetails(studioId ?? 'me'), saved),
  })
}
