import { useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams, useSearch } from '@tanstack/react-router'
import { useState } from 'react'

import { contractQuery } from '@/api/project'
import { DraftNote } from '@/app/drafts'
import { useHotkeys } from '@/app/keys'
import { useTitle } from '@/app/title'
import { Button, ButtonLink } from '@/ui/Button'
import { PageHead } from '@/ui/PageHead'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { Refusal } from '@/ui/Refusal'
import { Segmented } from '@/ui/Segmented'

import type { Contract } from './api'
import { Questions } from './Questions'
import { useDrafting } from './useDrafting'
import { WholeText } from './WholeText'

const FROM = '/shell/projects/$projectId/contracts/$contractId/draft'

/** A draft, written from five questions beside its text; every clause of it can be edited under Whole text. */
export function DraftPage() {
  const { projectId, contractId } = useParams({ from: FROM })
  const { data: contract, error } = useQuery(contractQuery(contractId))
  const [saves, setSaves] = useState(0)
  useTitle(contract ? `Draft: ${contract.title}` : 'Draft')
  const back = `/projects/${projectId}/contracts/${contractId}`
  if (!contract || !contract.may.change) {
    return (
      <div className="page stack" aria-busy={!contract && error === null}>
        <h1>{contract?.title ?? 'Draft'}</h1>
        <Refusal error={error} />
        {contract && (
          <ErrorBanner
            detail="You can’t edit this contract."
            fix="Only the studio’s producers edit drafts. Recall a sent contract before editing it."
          />
        )}
        <div>
          <ButtonLink component={Link} to={back}>
            Back to contract
          </ButtonLink>
        </div>
      </div>
    )
  }
  // A version that was saved is begun from anew; one that somebody else saves waits until this page is left.
  return <Editor key={`${contractId} ${saves}`} contract={contract} back={back} onSaved={() => setSaves(saves + 1)} />
}

function Editor({ contract: newest, back, onSaved }: { contract: Contract; back: string; onSaved: () => void }) {
  const { view = 'answers' } = useSearch({ from: FROM })
  const navigate = useNavigate()
  const drafting = useDrafting(newest, onSaved)
  const { contract, isChanged, kept, save, saveError, canSave } = drafting
  useHotkeys([
    { keys: 'mod+s', label: 'Save draft', group: 'Draft', run: () => canSave && void save(), disabled: !canSave },
  ])
  return (
    <div className="page stack">
      <PageHead
        title={`Draft: ${contract.title}`}
        actions={
          <>
            <Segmented
              label="Show"
              options={[
                { value: 'answers', label: 'Your answers' },
                { value: 'text', label: 'Whole text' },
              ]}
              value={view}
              onChange={(next) =>
                void navigate({ to: '.', search: next === 'text' ? { view: next } : {}, replace: true })
              }
            />
            <ButtonLink component={Link} to={back} onClick={isChanged ? kept.discard : undefined}>
              {isChanged ? 'Discard changes' : 'Back to contract'}
            </ButtonLink>
            {(isChanged || view === 'text') && (
              <Button disabled={!canSave} onClick={() => void save()}>
                Save version
              </Button>
            )}
          </>
        }
      >
        Five answers write the text. Only the studio sees it until you send it. A starting point for both parties’
        lawyers, not legal advice.
      </PageHead>
      <DraftNote draft={kept} />
      <Refusal error={saveError} />
      {view === 'text' ? <WholeText drafting={drafting} /> : <Questions drafting={drafting} back={back} />}
    </div>
  )
}
