import { useQueryClient } from '@tanstack/react-query'
import { useCallback, useRef } from 'react'

import { invalidate, queryKeys } from '@/api/queryKeys'
import { ended } from '@/verdicts/findings'
import { Button, ButtonLink } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { ago, bytes, figure } from '@/ui/format'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { type Accepts, filesOfField, isGoing, type Picked, usePageDrop } from '@/uploads'

import { type Check, giveDryStem, isComparing, hasNoVerdict, type Take, useWithdrawDryStem } from './api'
import type { ReverbStem } from './reverb'
import classes from './Take.module.css'
import { UploadProgress, useTakeUploads } from './takeUploads'

const STEMS: Accepts = { kinds: ['wav', 'rf64', 'flac'], sampleRatesHz: null, bitDepths: null }

interface DryStemProps {
  take: Take
  check: Check
  found: ReverbStem | null
  mayGive: boolean
}

/** The dry stem, with which reverb is measured and not estimated: the result, or how to add one. */
export function DryStem({ take, check, found, mayGive }: DryStemProps) {
  const { dry_stem: stem } = check
  const gives = mayGive && hasNoVerdict(take)
  if (!stem && !gives && !isComparing(check)) return null
  return (
    <section className={`stack ${classes.stem}`} aria-labelledby="dry-stem">
      <h3 id="dry-stem" className="strong">
        Comparison with the dry stem
      </h3>
      <p className="small" role="status">
        {describeComparison(check, found)}
      </p>
      {stem && (
        <div className="row wrap small">
          <span className="mid">
            <span className="mono">{stem.file_name}</span>, {bytes(stem.file_bytes)}, {ago(stem.received_at)}
          </span>
          <ButtonLink variant="quiet" href={`/v1/takes/${take.id}/dry-stem`} download icon="download">
            Download stem
          </ButtonLink>
          {gives && <Withdraw takeId={take.id} />}
        </div>
      )}
      {gives && <Give take={take} isFirst={!stem} />}
    </section>
  )
}

/** What was found, in a sentence or two; whose turn it is where nothing was found yet. */
function describeComparison(check: Check, stem: ReverbStem | null): string {
  if (isComparing(check)) return check.dry_stem ? 'Comparing with the stem…' : 'Checking again without the stem…'
  if (!check.dry_stem) return 'Add the same sound without reverb, and the check can measure the reverb exactly.'
  if (!check.is_newest_stem) return 'It arrived after the decision, which was made without it.'
  if (stem === null) return 'It can’t be compared with this version.'
  if (stem.verdict === 'dry') return 'No reverb was added, down to 30 dB below the sound.'
  if (stem.verdict === 'reverb') return `Reverb was added${tailOf(stem)}.`
  const why = `${stem.why.charAt(0).toUpperCase()}${stem.why.slice(1)}`
  if (stem.verdict === 'unreadable') return `The stem could not be read. ${ended(why)}`
  if (stem.verdict === 'failed') return `${ended(why)} That is our fault. Run the check again.`
  return `${why}, so the result without the stem is kept.`
}

const tailOf = ({ wetDb, rt60S }: ReverbStem): string =>
  wetDb === null || rt60S === null
    ? ''
    : `: its tail is ${figure(Math.abs(wetDb), 1)} dB ${wetDb < 0 ? 'under' : 'over'} the sound and falls by 60 dB in ${figure(rt60S, 2)} s`

function Withdraw({ takeId }: { takeId: string }) {
  const { mutate, isPending, error } = useWithdrawDryStem(takeId)
  return (
    <>
      <Button variant="quiet" icon="cross" disabled={isPending} onClick={() => mutate()}>
        Remove stem
      </Button>
      <Refusal error={error} />
    </>
  )
}

/** Takes a file by choice or by drop, and carries it whatever the line does. */
function Give({ take, isFirst }: { take: Take; isFirst: boolean }) {
  const client = useQueryClient()
  const field = useRef<HTMLInputElement>(null)
  const { queue, uploads } = useTakeUploads(take, STEMS, async (uploadId) => {
    await giveDryStem(take.id, uploadId)
    await invalidate(client, queryKeys.take(take.id))
  })
  const newest = uploads.at(-1)
  const going = newest !== undefined && isGoing(newest)
  const add = useCallback(
    (picked: readonly Picked[]) => {
      const first = picked[0]
      if (first === undefined || queue.get().some(isGoing)) return
      for (const { id } of queue.get()) queue.dismiss(id)
      void queue.add([first])
    },
    [queue],
  )
  const over = usePageDrop(add)
  return (
    <div className={`flex wrap items-center gap-2-3 p-3 rounded ${classes.stemDrop}`} data-over={over || undefined}>
      <input
        ref={field}
        type="file"
        hidden
        aria-label="File of the dry stem"
        accept=".wav,.wave,.flac,audio/*"
        onChange={({ currentTarget }) => {
          add(filesOfField(currentTarget.files ?? []))
          currentTarget.value = ''
        }}
      />
      {going ? (
        <UploadProgress upload={newest} onStop={() => queue.stop(newest.id)} />
      ) : (
        <>
          <Button icon="upload" onClick={() => field.current?.click()}>
            {isFirst ? 'Add dry stem' : 'Replace stem'}
          </Button>
          <span className="small mid">
            or drop it anywhere on this page. In a delivery, a file named <span className="mono">…__dry.wav</span> does
            the same.
          </span>
        </>
      )}
      {newest?.state === 'not_sent' && newest.reason !== null && <ErrorBanner detail={ended(newest.reason)} />}
    </div>
  )
}
