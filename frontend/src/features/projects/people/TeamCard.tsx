import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ConfirmInline } from '@/ui/ConfirmInline'
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
          Only members of the project can see it. This is set in <Link to="/studio">Studio</Link>.
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
              {project.mine.is_producer && (
                <span className="row wrap">
                  {isLimited &&
                    !isLiaison &&
                    (isOutside ? (
                      <Button
                        variant="quiet"
                        aria-busy={isSent(setMember, person.id)}
                        aria-label={`Add to the project: ${person.name}`}
                        onClick={() => setMember.mutate({ personId: person.id, isIn: true })}
                      >
                        Add
                      </Button>
                    ) : (
                      <ConfirmInline
                        variant="quiet"
                        action="Remove from project"
                        about={person.name}
                        consequence="Build tokens that they made for it are revoked."
                        aria-busy={isSent(setMember, person.id)}
                        aria-label={`Remove from the project: ${person.name}`}
                        onConfirm={() => setMember.mutate({ personId: person.id, isIn: false })}
                      >
                        Remove
                      </ConfirmInline>
                    ))}
                  <Button
                    variant={isLiaison ? 'quiet' : 'plain'}
                    aria-busy={isSent(set, person.id)}
                    aria-label={`${isLiaison ? 'Remove as audio lead' : 'Make audio lead'}: ${person.name}`}
                    onClick={() => change(member, !isLiaison)}
                  >
                    {isLiaison ? 'Remove as audio lead' : 'Make audio lead'}
                  </Button>
                </span>
              )}
            </Row>
          )
        })}
      </Rows>
    </Card>
  )
}

/** Whether a change of this person is on its way. */
const isSent = (change: { isPending: boolean; variables?: { personId: string } }, personId: string): boolean =>
  change.isPending && change.variables?.personId === personId
