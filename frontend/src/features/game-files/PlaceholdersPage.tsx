import { useNavigate, useParams, useSearch } from '@tanstack/react-router'

import { useTitle } from '@/app/title'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { countOf, figure, plural } from '@/ui/format'
import { Meter } from '@/ui/Meter'
import { PageHead } from '@/ui/PageHead'
import { Segmented } from '@/ui/Segmented'
import { StatusBadge } from '@/ui/StatusBadge'
import { sentence } from '@/ui/sentence'

import { type Placeholder, useMakePlaceholders, useRegister } from './api'
import classes from './Files.module.css'

const WORDS: Record<Placeholder['state'], string> = {
  missing: 'no placeholder file',
  made: 'placeholder file',
  outdated: 'outdated placeholder',
  refused: 'no placeholder file',
}

/** What the game still plays a placeholder-file for, counted down as sounds are accepted. */
export function PlaceholdersPage() {
  useTitle('Placeholders')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/placeholders' })
  const { target } = useSearch({ from: '/shell/projects/$projectId/placeholders' })
  const navigate = useNavigate()
  const make = useMakePlaceholders(projectId)
  const { data: register, error } = useRegister(projectId, target, make.isSuccess)
  const choose = (chosen: string) =>
    void navigate({ to: '/projects/$projectId/placeholders', params: { projectId }, search: { target: chosen } })
  const lacking = register?.toMake ?? 0
  return (
    <div className="page stack">
      <PageHead title="Placeholders">
        Files without an accepted sound. A placeholder has the right name, length and format, speaks its name or plays a
        tone pattern, and is marked so that it never ships unnoticed.
      </PageHead>
      <Refusal inset error={error ?? make.error} />
      {register && (
        <Card aria-labelledby="register">
          <CardHead
            id="register"
            title={register.left === 0 ? 'No placeholders left' : `${plural(register.left, 'file')} left`}
            note={`${countOf(register.replaced, register.files)} replaced by accepted sounds`}
            end={
              register.left > 0 && (
                <Button disabled={make.isPending || lacking === 0} onClick={() => make.mutate(register.target)}>
                  {lacking === 0 ? 'Nothing to generate' : `Generate ${plural(lacking, 'placeholder')}`}
                </Button>
              )
            }
          />
          <div className="stack p-3-inset">
            {register.targets.length > 1 && (
              <Segmented
                label="Target"
                options={register.targets.map((option) => ({ value: option, label: option }))}
                value={register.target}
                onChange={choose}
              />
            )}
            <Meter
              label={`${figure(register.replaced)} of ${plural(register.files, 'file')} ${register.replaced === 1 ? 'has' : 'have'} an accepted sound`}
              whole={register.files}
              parts={[{ value: register.replaced, tone: 'ok' }, { value: register.made }]}
            />
          </div>
          {register.left === 0 && (
            <div className="p-3-inset">
              <EmptyState head={register.files === 0 ? 'The sound list is empty' : 'No placeholders'} level={3}>
                {register.files === 0 ? 'Add cues to the sound list.' : 'Every file on the list has an accepted sound.'}
              </EmptyState>
            </div>
          )}
          <ul aria-label="Placeholders">
            {register.items.map((item) => (
              <li key={item.path} className={`grid wrap-anywhere border-b ${classes.stand}`}>
                <span className="mono small dim">{item.cue}</span>
                <span>
                  {item.name} <span className="mono small mid">{item.path}</span>
                  {item.trigger !== '' && <span className="small mid"> {`on ${item.trigger}`}</span>}
                  {item.refusal && <span className="small mid"> {sentence(item.refusal)}</span>}
                </span>
                <span className="small">
                  {item.state === 'refused' ? (
                    <StatusBadge kind="refused" />
                  ) : (
                    <StatusBadge kind={item.state === 'made' ? 'placeholder' : 'to_make'}>
                      {item.spoken && item.state === 'made' ? 'spoken placeholder' : WORDS[item.state]}
                    </StatusBadge>
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
