import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Avatar } from '@/ui/Avatar'
import { Icon } from '@/ui/Icon'
import { Refusal } from '@/ui/Refusal'
import { Row, Rows } from '@/ui/Rows'

import { type Project } from '../api'
import { type Member, projectMembersQuery, useSetLiaison, useSetProjectMember } from './api'
import classes from './People.module.css'

/** The members of the studio, and which of them act for the team here. */
export function TeamCard({ project, members }: { project: Project; members: readonly Member[] | undefined }) {
  const set = useSetLiaison(project.id)
  const { data: inProject, error: noMembers } = useQuery(projectMembersQuery(project.id))
  const setMember = useSetProjectMember(project.id)
  const isLimited = inProject?.members_see === 'own'
  const inside = new Set(inProject?.members.map(({ person }) => person.id))
  const speaking = new Set(project.liaisons.map(({ id }) => id))
  const change = (member: Member, speaks: boolean) =>
    set.mutate(
      { personId: member.person.id, speaks },
      {
        onSuccess: () =>
          showToast(
            speaks
              ? `${member.person.name} is an audio lead now.`
              : `${member.person.name} is no longer an audio lead.`,
            () => set.mutate({ personId: member.person.id, speaks: !speaks }),
          ),
      },
    )
  return (
    <Card aria-labelledby="team">
      <CardHead
        id="team"
        title="Team"
        note={project.studio.name}
        end={
          <Link className="link" to="/studio">
            Studio
          </Link>
        }
      />
      <p className="small mid p-2-inset">
        Audio leads edit the spec, invite designers, answer questions and can be the approver. Reviewers listen and
        comment.
      </p>
      {isLimited && (
        <p className="small mid p-2-inset">
          Only who is in the project sees it; <Link to="/studio">the studio</Link> has set this.
        </p>
      )}
      {project.audio_leads_warning && (
        <p role="status" className="small tone-warn toned p-2-inset">
          <Icon name="triangle" /> {project.audio_leads_warning}.
        </p>
      )}
      <Refusal inset error={set.error ?? setMember.error ?? noMembers} />
      <Rows aria-label="Members of the studio">
        {members?.map((member) => {
          const { person, roles, email } = member
          const isLiaison = speaking.has(person.id)
          const isOutside = isLimited && !inside.has(person.id)
          const parts = [
            ...roles.filter((role) => role !== 'liaison'),
            ...(isLiaison ? ['audio lead'] : []),
            ...(isOutside ? ['not in the project'] : []),
            ...(person.id === project.approver.id ? ['approver'] : []),
            ...project.category_approvers
              .filter(({ approver }) => approver.id === person.id)
              .map(({ category }) => `approver of ${category}`),
          ]
          return (
            <Row key={person.id} className={classes.person}>
              <Avatar name={person.name} picture={person.picture} />
              <div className="grow">
                <p className="strong">{person.name}</p>
                <p className="small mid wrap-anywhere">{[parts.join(', '), email].filter(Boolean).join(' · ')}</p>
              </div>
              {project.mine.is_producer && isLimited && !isLiaison && (
                <Button
                  variant="quiet"
                  aria-busy={setMember.isPending}
                  aria-label={`${isOutside ? 'Add to the project' : 'Remove from the project'}: ${person.name}`}
                  onClick={() => setMember.mutate({ personId: person.id, isIn: isOutside })}
                >
                  {isOutside ? 'Add' : 'Remove'}
                </Button>
              )}
              {project.mine.is_producer && (
                <Button
                  variant={isLiaison ? 'quiet' : 'plain'}
                  aria-busy={set.isPending}
                  aria-label={`${isLiaison ? 'Remove as audio lead' : 'Make audio lead'}: ${person.name}`}
                  onClick={() => change(member, !isLiaison)}
                >
                  {isLiaison ? 'Remove as audio lead' : 'Make audio lead'}
                </Button>
              )}
            </Row>
          )
        })}
      </Rows>
    </Card>
  )
}
