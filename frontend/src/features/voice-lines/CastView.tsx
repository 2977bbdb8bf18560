import { NativeSelect, NumberInput } from '@mantine/core'
import { useQuery, useQueryClient } from '@tanstack/react-query'
import { useMemo } from 'react'

import { meQuery } from '@/api/me'
import { DraftForm } from '@/app/drafts/DraftForm'
import { showToast } from '@/app/toast'
import { Card, CardHead } from '@/ui/Card'
import { Field, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { day, plural } from '@/ui/format'
import { languageName } from '@/voice-lines'

import {
  type Casting,
  type Character,
  type Performer,
  releasesQuery,
  type Script,
  useCast,
  useChangeSettings,
  useRemoveRelease,
} from './api'
import { AddRelease } from './AddRelease'
import { releaseUploadsOf } from './releaseUploads'
import classes from './VoiceLines.module.css'

const SYNTHETIC = { yes: 'Synthetic use agreed', no: 'No synthetic use', not_asked: 'Synthetic use not asked' }

/** Who speaks, directs and casts in each language, and the releases of performers. */
export function CastView({ projectId, script }: { projectId: string; script: Script }) {
  const releases = useQuery(releasesQuery(projectId))
  const { data: me } = useQuery(meQuery)
  const client = useQueryClient()
  const remove = useRemoveRelease(projectId)
  const uploads = useMemo(
    () => (me?.person ? releaseUploadsOf(client, projectId, me.person.id) : null),
    [client, projectId, me?.person],
  )
  const listing = releases.data
  return (
    <>
      <Card aria-labelledby="cast">
        <CardHead id="cast" title="Cast" note="Each language has its own performer and director" />
        <ul className="grid gap-3 p-3-inset-4">
          {script.characters.map((character) => (
            <CharacterCast key={character.id} projectId={projectId} script={script} character={character} />
          ))}
        </ul>
      </Card>
      <Card aria-labelledby="releases">
        <CardHead
          id="releases"
          title="Releases"
          count={listing?.performers.flatMap((performer) => performer.releases).length}
        />
        <div className="grid gap-3 p-3-inset-4">
          <Refusal error={releases.error ?? remove.error} />
          {listing && listing.lines_without_performer > 0 && (
            <p className="tone-warn toned">
              {plural(listing.lines_without_performer, 'approved line')} of characters for whom no performer is named.
            </p>
          )}
          {listing?.performers.length === 0 && (
            <p className="small dim">
              No performer is named yet. A release is a signed file with its dates, and says whether a synthetic copy of
              the voice may be used.
            </p>
          )}
          <ul>
            {listing?.performers.map((performer) => (
              <PerformerLine
                key={performer.name}
                performer={performer}
                onRemove={listing.may_change ? (id) => remove.mutate(id) : undefined}
              />
            ))}
          </ul>
          {listing?.may_change && uploads && (
            <AddRelease
              projectId={projectId}
              performers={listing.performers.map(({ name }) => name)}
              uploads={uploads}
            />
          )}
        </div>
      </Card>
      {script.may_change && <Settings projectId={projectId} script={script} />}
    </>
  )
}

function PerformerLine({
  performer,
  onRemove,
}: {
  performer: Performer
  onRemove: ((id: string) => void) | undefined
}) {
  return (
    <li className={`grid gap-1 ${classes.performer}`}>
      <p>
        <span className="strong">{performer.name}</span>{' '}
        <span className="small dim">
          {performer.parts.join(' · ')}
          {performer.approved_lines > 0 && ` · ${plural(performer.approved_lines, 'approved line')}`}
        </span>
      </p>
      {performer.warning && <p className="small tone-warn toned">{performer.warning}</p>}
      <ul>
        {performer.releases.map((release) => (
          <li key={release.id} className="flex wrap items-center gap-1-3 wrap-anywhere">
            <a className="link" href={`/v1/voice-releases/${release.id}/file`}>
              {release.file_name}
            </a>
            <span className={`small ${release.is_valid ? 'mid' : 'tone-warn toned'}`}>
              {`valid from ${day(release.valid_from)}`}
              {release.valid_until && ` until ${day(release.valid_until)}`}
            </span>
            <span className={`small ${release.synthetic_use === 'not_asked' ? 'tone-warn toned' : 'mid'}`}>
              {SYNTHETIC[release.synthetic_use]}
            </span>
            {release.note && <span className="small dim">{release.note}</span>}
            {onRemove && (
              <button type="button" className="link small end" onClick={() => onRemove(release.id)}>
                Remove <span className="visually-hidden">{release.file_name}</span>
              </button>
            )}
          </li>
        ))}
      </ul>
    </li>
  )
}

function CharacterCast({ projectId, script, character }: { projectId: string; script: Script; character: Character }) {
  return (
    <li className={`grid gap-2 ${classes.character}`}>
      <h3>
        {character.name} <span className="small dim">{plural(character.lines, 'line')}</span>
      </h3>
      {character.notes && <p className="small mid">{character.notes}</p>}
      <ul>
        {script.languages.map((language) => {
          const casting = character.castings.find((candidate) => candidate.language === language)
          return (
            <li key={language}>
              {script.may_change ? (
                <EditCasting
                  projectId={projectId}
                  character={character}
                  language={language}
                  casting={casting ?? { language, performer: null, directed_by: '', cast_by: '' }}
                />
              ) : (
                <p className="small">
                  {languageName(language)}: {casting?.performer ?? 'no performer named'}
                  {casting?.directed_by && `, directed by ${casting.directed_by}`}
                  {casting?.cast_by && `, cast by ${casting.cast_by}`}
                </p>
              )}
            </li>
          )
        })}
      </ul>
    </li>
  )
}

interface EditCastingProps {
  projectId: string
  character: Character
  language: string
  casting: Casting
}

function EditCasting({ projectId, character, language, casting }: EditCastingProps) {
  const cast = useCast(projectId, character.id, language)
  const begun = {
    performer: casting.performer ?? '',
    directed_by: casting.directed_by,
    cast_by: casting.cast_by,
  }
  return (
    <DraftForm
      draftKey={`casting:${character.id}:${language}`}
      className={`grid items-end gap-2-3 ${classes.casting}`}
      aria-label={`${character.name}, ${languageName(language)}`}
      initialValues={begun}
      mutation={cast}
      onSubmit={(typed, onSent) =>
        cast.mutate(typed, {
          onSuccess: () => {
            onSent()
            showToast(`${character.name}, ${languageName(language)}: saved.`)
          },
        })
      }
    >
      {(typed) => (
        <>
          <span className={`small mid ${classes.language}`}>{languageName(language)}</span>
          <Field optional name="performer" label="Performer" maxLength={120} />
          <Field optional name="directed_by" label="Directed by" maxLength={120} />
          <Field optional name="cast_by" label="Cast by" maxLength={120} />
          {JSON.stringify(typed) !== JSON.stringify(begun) && <Submit variant="plain">Save</Submit>}
        </>
      )}
    </DraftForm>
  )
}

function Settings({ projectId, script }: { projectId: string; script: Script }) {
  const change = useChangeSettings(projectId)
  const { original_language: original, length_tolerance_percent: tolerance, languages } = script
  return (
    <Card aria-labelledby="voice-settings">
      <CardHead id="voice-settings" title="Settings" />
      <DraftForm
        draftKey={`voice-settings:${projectId}`}
        className={`grid items-end gap-2-3 ${classes.casting}`}
        initialValues={{ original, tolerance }}
        mutation={change}
        onSubmit={(typed, onSent) =>
          change.mutate(
            { original_language: typed.original, length_tolerance_percent: typed.tolerance },
            {
              onSuccess: () => {
                onSent()
                showToast('Settings saved.')
              },
            },
          )
        }
      >
        <Field
          as={NativeSelect}
          name="original"
          label="Original language"
          data={[...new Set([...languages, original])].map((value) => ({ value, label: languageName(value) }))}
        />
        <Field
          as={NumberInput}
          name="tolerance"
          label="Length tolerance, percent"
          min={1}
          max={100}
          allowDecimal={false}
        />
        <Submit variant="plain">Save</Submit>
      </DraftForm>
    </Card>
  )
}
