import { useNavigate, useParams, useSearch } from '@tanstack/react-router'

import { useTitle } from '@/app/title'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { countOf, plural } from '@/ui/format'
import { Meter } from '@/ui/Meter'
import { Segmented } from '@/ui/Segmented'
import { State } from '@/ui/State'

import { type Placeholder, useMakeStandIns, useRegister } from './api'
import classes from './Files.module.css'
import { Refused } from './Refused'
import { sentence } from './words'

const WORDS: Record<Placeholder['state'], string> = {
  missing: 'no stand-in',
  made: 'stand-in',
  outdated: 'stand-in of before',
  refused: 'no stand-in',
}

/** What the game still plays a stand-in for, counted down as sounds are accepted. */
export function PlaceholdersPage() {
  useTitle('Placeholders')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/placeholders' })
  const { target } = useSearch({ from: '/shell/projects/$projectId/placeholders' })
  const navigate = useNavigate()
  const make = useMakeStandIns(projectId)
  const { data: register, error } = useRegister(projectId, target, make.isSuccess)
  const choose = (chosen: string) =>
    void navigate({ to: '/projects/$projectId/placeholders', params: { projectId }, search: { target: chosen } })
  const lacking = register?.toMake ?? 0
  return (
    <div className="page stack">
      <div>
        <h1>Placeholders</h1>
        <p className="mid">
          Every file that the game has no accepted sound for. A stand-in has its name, length and format, says its name
          or plays a pattern of its own, and is marked, so that no build ships it unnoticed.
        </p>
      </div>
      <Refused error={error ?? make.error} />
      {register && (
        <Card aria-labelledby="register">
          <CardHead
            id="register"
            title={register.left === 0 ? 'None left' : `${plural(register.left, 'file')} left`}
            note={`${countOf(register.replaced, register.files)} replaced by accepted sounds`}
            end={
              register.left > 0 && (
                <Button disabled={make.isPending || lacking === 0} onClick={() => make.mutate(register.target)}>
                  {lacking === 0 ? 'Nothing to make' : `Make ${plural(lacking, 'stand-in')}`}
                </Button>
              )
            }
          />
          <div className={`${classes.inside} stack`}>
            {register.targets.length > 1 && (
              <Segmented
                label="Target"
                options={register.targets.map((one) => ({ value: one, label: one }))}
                value={register.target}
                onChange={choose}
              />
            )}
            <Meter
              label={`${countOf(register.replaced, register.files)} files have an accepted sound`}
              whole={register.files}
              parts={[{ value: register.replaced, tone: 'ok' }, { value: register.made }]}
            />
          </div>
          {register.left === 0 && (
            <div className={classes.inside}>
              <EmptyState
                head={register.files === 0 ? 'The list asks for nothing yet.' : 'Nothing is a placeholder.'}
                level={3}
              >
                {register.files === 0
                  ? 'Add cues to the sound list.'
                  : 'Every file that the list asks for has its accepted sound.'}
              </EmptyState>
            </div>
          )}
          <ul aria-label="Placeholders">
            {register.items.map((one) => (
              <li key={one.path} className={classes.stand}>
                <span className="mono small dim">{one.cue}</span>
                <span>
                  {one.name} <span className="mono small mid">{one.path}</span>
                  {one.refusal && <span className="small mid"> {sentence(one.refusal)}</span>}
                </span>
                <span className="small">
                  {one.state === 'refused' ? (
                    <State kind="refused" />
                  ) : (
                    <State kind={one.state === 'made' ? 'placeholder' : 'to_make'}>
                      {one.spoken && one.state === 'made' ? 'spoken stand-in' : WORDS[one.state]}
                    </State>
                  )}
                </span>
              </li>
            ))}
          </ul>
        </Card>
      )}
    </div>
  )
}
