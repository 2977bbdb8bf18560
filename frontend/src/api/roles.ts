import { useQuery } from '@tanstack/react-query'

import { projectQuery } from './project'

/** What people of a project are in it, in a word beside their name; nothing is said of people it does not name. */
export function useRoles(projectId: string): (personId: string | null | undefined) => string {
  const { data: project } = useQuery({
    ...projectQuery(projectId),
    staleTime: 60_000,
  })
  return (personId) => {
    if (!project || !personId) return ''
    const approvers = [project.approver, ...project.category_approvers.map(({ approver }) => approver)]
    if (approvers.some(({ id }) => id === personId)) return 'approver'
    if (project.liaisons.some(({ id }) => id === personId)) return 'liaison'
    return project.engagements.some(({ designer }) => designer.id === personId) ? 'designer' : ''
  }
}
