import { money } from '@/money/words'
import { EmptyState } from '@/ui/EmptyState'
import { day } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'

import type { PostingPreview } from './api'
import { AskedCard } from './AskedCard'
import classes from './Hiring.module.css'
import { period } from './words'

type Shown = Pick<
  PostingPreview,
  | 'title'
  | 'studio_name'
  | 'project_name'
  | 'text'
  | 'phase'
  | 'takes_bids'
  | 'bids_until_on'
  | 'work_from_on'
  | 'work_to_on'
  | 'currency'
  | 'price_minor'
  | 'budget_minor'
  | 'lines'
>

interface PostingFactsProps {
  posting: Shown
  ndaOpen: boolean
  /** Whose cues are shown with the lines; the page of a link, which anyone may open, shows counts only. */
  postingId?: string
}

/** What a posting offers, as a designer reads it; behind an NDA only title, dates and studio. */
export function PostingFacts({ posting, ndaOpen, postingId }: PostingFactsProps) {
  const { title, studio_name: studio, project_name: project, text, currency } = posting
  const until = posting.bids_until_on ? ` until ${day(posting.bids_until_on)}` : ''
  return (
    <>
      <PageHead title={title}>
        {project ? `${studio}, ${project}. ` : `${studio}. `}
        {posting.takes_bids ? `Bids are taken${until}. ` : 'No bids are taken now. '}
        {`Work: ${period(posting.work_from_on, posting.work_to_on)}.`}
      </PageHead>
      {ndaOpen ? (
        <EmptyState head="An NDA comes first">
          The studio shows what it asks for once you have signed its NDA. It invites you to the project and sends the
          NDA; you then find it under Contract & money.
        </EmptyState>
      ) : (
        <>
          {text && <p className={`pre-line ${classes.text}`}>{text}</p>}
          {posting.phase === 'advisory' && (
            <p>
              {posting.price_minor === null
                ? 'This is advice before production.'
                : `This is advice before production, for ${money(posting.price_minor, currency)}.`}
            </p>
          )}
          {posting.budget_minor !== null && <p>{`Budget: ${money(posting.budget_minor, currency)}.`}</p>}
          {posting.lines.length > 0 && <AskedCard lines={posting.lines} postingId={postingId} />}
        </>
      )}
    </>
  )
}
