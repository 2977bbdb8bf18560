import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { unwrap, api, del, get, patch, post, put, queryById, useMutation } from '@/api'
import { projectQuery } from '@/api/project'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

import type { Project } from '../api'

type Schemas = components['schemas']
export type Member = Schemas['MemberRead']
export type Engagement = Schemas['EngagementRead']
export type EngagementKind = Schemas['EngagementKind']
export type Invitation = Schemas['InvitationRead']
export type ApproverChange = Schemas['ApproverChangeRead']
export type Deputy = Schemas['DeputyRead']

function useProjectChange<Asked>(projectId: string, change: (asked: Asked) => Promise<Project>) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: change,
    onSuccess: (project) => client.setQueryData(projectQuery(projectId).queryKey, project),
    onSettled: () =>
      invalidate(client, queryKeys.me(), queryKeys.approvers(projectId), queryKeys.projectMembers(projectId)),
  })
}

export const useSetLiaison = (projectId: string) =>
  useProjectChange(projectId, ({ personId, speaks }: { personId: string; speaks: boolean }) => {
    const where = { params: { path: { project_id: projectId, person_id: personId } } }
    const path = '/v1/projects/{project_id}/liaisons/{person_id}'
    return unwrap(speaks ? api.PUT(path, where) : api.DELETE(path, where))
  })

export const useNameApprover = (projectId: string) =>
  useProjectChange(projectId, (body: Schemas['ApproverAdd']) =>
    put('/v1/projects/{project_id}/approver', { project_id: projectId }, body),
  )

/** Give a category an approver of its own, or with null the project's. */
export const useNameCategoryApprover = (projectId: string) =>
  useProjectChange(projectId, (body: Schemas['CategoryApproverName']) =>
    put('/v1/projects/{project_id}/category-approvers', { project_id: projectId }, body),
  )

/** Which members are in the project, and whether the others see it. */
export const projectMembersQuery = queryById('/v1/projects/{project_id}/members', queryKeys.projectMembers)

export function useSetProjectMember(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: ({ personId, isIn }: { personId: string; isIn: boolean }) => {
      const where = { project_id: projectId, person_id: personId }
      const path = '/v1/projects/{project_id}/members/{person_id}'
      return isIn ? put(path, where) : del(path, where)
    },
    onSettled: () => invalidate(client, queryKeys.projectMembers(projectId), queryKeys.me()),
  })
}

/** The checklists of a project, and what blocks approval there. */
export const approvalSettingsQuery = queryById(
  '/v1/projects/{project_id}/approval-settings',
  queryKeys.approvalSettings,
)

function useApprovalSettingsChange<Asked>(
  projectId: string,
  change: (asked: Asked) => Promise<Schemas['ApprovalSettingsRead']>,
) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: change,
    onSuccess: (settings) => client.setQueryData(approvalSettingsQuery(projectId).queryKey, settings),
    onSettled: () => invalidate(client, queryKeys.approvalSettings(projectId), queryKeys.cueReview.all),
  })
}

export const useSetChecklist = (projectId: string) =>
  useApprovalSettingsChange(projectId, (body: Schemas['ChecklistSet']) =>
    put('/v1/projects/{project_id}/checklist', { project_id: projectId }, body),
  )

export const useSetBlockers = (projectId: string) =>
  useApprovalSettingsChange(projectId, (blockers: Schemas['ApprovalBlockers']) =>
    put('/v1/projects/{project_id}/approval-blockers', { project_id: projectId }, { blockers }),
  )

/** The deputies of today and of later days. */
export const deputiesQuery = queryById('/v1/projects/{project_id}/deputies', queryKeys.deputies)

function useDeputyChange<Asked, Answer>(projectId: string, change: (asked: Asked) => Promise<Answer>) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: change,
    onSettled: () => invalidate(client, queryKeys.deputies(projectId), queryKeys.me(), queryKeys.cueReview.all),
  })
}

export const useNameDeputy = (projectId: string) =>
  useDeputyChange(projectId, (body: Schemas['DeputyAdd']) =>
    post('/v1/projects/{project_id}/deputies', { project_id: projectId }, body),
  )

export const useWithdrawDeputy = (projectId: string) =>
  useDeputyChange(projectId, (deputyId: string) =>
    del('/v1/projects/{project_id}/deputies/{deputy_id}', { project_id: projectId, deputy_id: deputyId }),
  )

/** Invite an address as the approver: a member becomes it at once, others when they join. */
export const useInviteApprover = (projectId: string, studioId: string) =>
  useMutation({
    mutationFn: (email: string) =>
      post('/v1/projects/{project_id}/approver-invitations', { project_id: projectId }, { email }),
    affects: [queryKeys.project(projectId), queryKeys.approvers(projectId), queryKeys.studioInvitations(studioId)],
  })

/** Addresses that become the approver of a project when they join. */
export const invitedApproversQuery = (projectId: string, studioId: string) =>
  queryOptions({
    queryKey: queryKeys.studioInvitations(studioId),
    queryFn: () => get('/v1/studios/{studio_id}/invitations', { studio_id: studioId }),
    select: (invitations) => invitations.filter(({ approves_project_id: id }) => id === projectId),
  })

export const approverHistoryQuery = queryById('/v1/projects/{project_id}/approver-history', queryKeys.approvers)

export const invitationsQuery = queryById('/v1/projects/{project_id}/invitations', queryKeys.projectInvitations)

export const useInviteDesigner = (projectId: string) =>
  useMutation({
    mutationFn: (body: Schemas['InvitationAdd']) =>
      post('/v1/projects/{project_id}/invitations', { project_id: projectId }, body),
    affects: [queryKeys.projectInvitations(projectId), queryKeys.outbox.all],
  })

export function useRevokeInvitation(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (invitationId: string) =>
      del('/v1/projects/{project_id}/invitations/{invitation_id}', {
        project_id: projectId,
        invitation_id: invitationId,
      }),
    onSettled: () => invalidate(client, queryKeys.projectInvitations(projectId)),
  })
}

export function useChangeEngagement(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: ({ id, ...body }: { id: string } & Schemas['EngagementChange']) =>
      patch(
        '/v1/projects/{project_id}/engagements/{engagement_id}',
        { project_id: projectId, engagement_id: id },
        body,
      ),
    onSettled: () => invalidate(client, queryKeys.project(projectId), queryKeys.projectInvitations(projectId)),
  })
}
