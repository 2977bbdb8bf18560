import { showToast } from '@/app/toast'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'

import { type Project, useChangeProject } from '../api'
import classes from './People.module.css'

type Choice = Project['designers_hear']

const CHOICES: readonly { value: Choice; label: string; says: string }[] = [
  { value: 'own', label: 'Only their own sounds', says: 'Designers hear nothing of each other.' },
  {
    value: 'approved',
    label: 'Approved sounds and the palette',
    says: 'Designers can play the approved sounds of the project, to match them.',
  },
  {
    value: 'waiting',
    label: 'Approved sounds and those in review',
    says: 'Designers can also play what waits for approval.',
  },
]

/** What one designer may hear of another's sounds. */
export function HearingCard({ project }: { project: Project }) {
  const change = useChangeProject(project.id)
  const before = project.designers_hear
  const choose = (choice: Choice) =>
    change.mutate(
      { designers_hear: choice },
      {
        onSuccess: () =>
          showToast(`Designers hear: ${labelOf(choice)}.`, () => change.mutate({ designers_hear: before })),
      },
    )
  return (
    <Card aria-labelledby="hearing">
      <CardHead id="hearing" title="What designers hear of each other" />
      <p className="small mid p-2-inset">
        They only play these sounds, without the designer’s name. Masters, game files, findings, comments and returned
        sounds are shown to the studio and to the sound’s own designer.
      </p>
      <Refusal inset error={change.error} />
      {project.mine.is_producer ? (
        <fieldset className={`grid gap-2 m-0 border-0 ${classes.choices}`}>
          <legend className="small mid">Designers can play</legend>
          {CHOICES.map(({ value, label, says }) => (
            <label key={value} className={`flex items-start gap-2 pointer ${classes.choice}`}>
              <input
                type="radio"
                name="hearing"
                checked={value === before}
                disabled={change.isPending}
                aria-label={label}
                aria-describedby={`hearing-${value}`}
                onChange={() => choose(value)}
              />
              <span>
                <span className="strong">{label}</span>
                <span id={`hearing-${value}`} className="small mid block">
                  {says}
                </span>
              </span>
            </label>
          ))}
        </fieldset>
      ) : (
        <p className={classes.acts}>{labelOf(before)}</p>
      )}
    </Card>
  )
}

const labelOf = (choice: Choice): string => CHOICES.find(({ value }) => value === choice)?.label ?? choice
