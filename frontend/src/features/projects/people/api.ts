import { queryOptions, useMutation, useQuery, useQueryClient } from '@tanstack/react-query'

import { answered, api } from '@/api'
import { meQuery } from '@/api/me'
import type { components } from '@/api/schema.gen'

import { type Project, projectQuery } from '../api'

type Schemas = components['schemas']
export type Member = Schemas['MemberRead']
export type Engagement = Schemas['EngagementRead']
export type EngagementKind = Schemas['EngagementKind']
export type Invitation = Schemas['InvitationRead']
export type ApproverChange = Schemas['ApproverChangeRead']

const inProject = (projectId: string) => ({ params: { path: { project_id: projectId } } })

const keys = {
  invitations: (projectId: string) => ['project-invitations', projectId] as const,
  approvers: (projectId: string) => ['approvers', projectId] as const,
  studioInvitations: (studioId: string) => ['studio-invitations', studioId] as const,
}

export const membersQuery = (studioId: string) =>
  queryOptions({
    queryKey: ['studio-people', studioId],
    queryFn: () => answered(api.GET('/v1/studios/{studio_id}/people', { params: { path: { studio_id: studioId } } })),
  })

/** The newest link that was written to each address and not sent: what to copy where no mail leaves. */
export const useInvitationLinks = (studioId: string, enabled: boolean) =>
  useQuery({
    queryKey: ['outbox', studioId],
    queryFn: () => answered(api.GET('/v1/studios/{studio_id}/outbox', { params: { path: { studio_id: studioId } } })),
    enabled,
    // The worker writes the mail a moment after the invitation.
    refetchInterval: 2_000,
    select: ({ can_send, mails }) => {
      const links = new Map<string, string>()
      for (const { recipient, link, sent_at } of mails) {
        if (link?.includes('/invitation/') && sent_at === null && !links.has(recipient)) links.set(recipient, link)
      }
      return { canSend: can_send, links }
    },
  })

function useProjectChange<Asked>(projectId: string, change: (asked: Asked) => Promise<Project>) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: change,
    onSuccess: (project) => client.setQueryData(projectQuery(projectId).queryKey, project),
    onSettled: () =>
      Promise.all([
        client.invalidateQueries({ queryKey: meQuery.queryKey }),
        client.invalidateQueries({ queryKey: keys.approvers(projectId) }),
      ]),
  })
}

export const useSetLiaison = (projectId: string) =>
  useProjectChange(projectId, ({ personId, speaks }: { personId: string; speaks: boolean }) => {
    const where = { params: { path: { project_id: projectId, person_id: personId } } }
    const path = '/v1/projects/{project_id}/liaisons/{person_id}'
    return answered(speaks ? api.PUT(path, where) : api.DELETE(path, where))
  })

export const useNameApprover = (projectId: string) =>
  useProjectChange(projectId, (body: Schemas['ApproverAdd']) =>
    answered(api.PUT('/v1/projects/{project_id}/approver', { ...inProject(projectId), body })),
  )

/** Invite an address as the approver: a member becomes it at once, others when they join. */
export function useInviteApprover(projectId: string, studioId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (email: string) =>
      answered(
        api.POST('/v1/projects/{project_id}/approver-invitations', { ...inProject(projectId), body: { email } }),
      ),
    onSuccess: () =>
      Promise.all([
        client.invalidateQueries({ queryKey: projectQuery(projectId).queryKey }),
        client.invalidateQueries({ queryKey: keys.approvers(projectId) }),
        client.invalidateQueries({ queryKey: keys.studioInvitations(studioId) }),
      ]),
  })
}

/** Addresses that become the approver of a project when they join. */
export const invitedApproversQuery = (projectId: string, studioId: string) =>
  queryOptions({
    queryKey: keys.studioInvitations(studioId),
    queryFn: () =>
      answered(api.GET('/v1/studios/{studio_id}/invitations', { params: { path: { studio_id: studioId } } })),
    select: (invitations) => invitations.filter(({ approves_project_id: id }) => id === projectId),
  })

export const approverHistoryQuery = (projectId: string) =>
  queryOptions({
    queryKey: keys.approvers(projectId),
    queryFn: () => answered(api.GET('/v1/projects/{project_id}/approver-history', inProject(projectId))),
  })

export const invitationsQuery = (projectId: string) =>
  queryOptions({
    queryKey: keys.invitations(projectId),
    queryFn: () => answered(api.GET('/v1/projects/{project_id}/invitations', inProject(projectId))),
  })

export function useInviteDesigner(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Schemas['InvitationAdd']) =>
      answered(api.POST('/v1/projects/{project_id}/invitations', { ...inProject(projectId), body })),
    onSuccess: () =>
      Promise.all([
        client.invalidateQueries({ queryKey: keys.invitations(projectId) }),
        client.invalidateQueries({ queryKey: ['outbox'] }),
      ]),
  })
}

export function useRevokeInvitation(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (invitationId: string) =>
      answered(
        api.DELETE('/v1/projects/{project_id}/invitations/{invitation_id}', {
          params: { path: { project_id: projectId, invitation_id: invitationId } },
        }),
      ),
    onSettled: () => client.invalidateQueries({ queryKey: keys.invitations(projectId) }),
  })
}

export function useChangeEngagement(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: ({ id, ...body }: { id: string } & Schemas['EngagementChange']) =>
      answered(
        api.PATCH('/v1/projects/{project_id}/engagements/{engagement_id}', {
          params: { path: { project_id: projectId, engagement_id: id } },
          body,
        }),
      ),
    onSettled: () =>
      Promise.all([
        client.invalidateQueries({ queryKey: projectQuery(projectId).queryKey }),
        client.invalidateQueries({ queryKey: keys.invitations(projectId) }),
      ]),
  })
}
