import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'
import { useState } from 'react'

import { meQuery } from '@/api/me'
import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Field, Form, Submit } from '@/ui/Form'
import { Segmented } from '@/ui/Segmented'
import { PageSkeleton } from '@/ui/Skeleton'

import { useRenameStudio } from './api'
import { CalendarCard } from './CalendarCard'
import { EraseCard } from './EraseCard'
import { InvoiceDetailsCard } from './InvoiceDetailsCard'
import { MembersSeeCard } from './MembersSeeCard'
import { OutboxCard } from './OutboxCard'
import { InvitationsCard, PeopleCard } from './PeopleCards'
import { QuotasCard } from './QuotasCard'
import { SecondFactorRequirementCard } from './SecondFactorRequirementCard'
import { SignInProviderCard } from './SignInProviderCard'
import classes from './Studio.module.css'

function StudioNameCard({ studio: { id, name } }: { studio: { id: string; name: string } }) {
  const rename = useRenameStudio(id)
  return (
    <Card aria-labelledby="studio-name">
      <CardHead id="studio-name" title="Studio name" note="as contracts and invoices show it" />
      <div className={classes.inside}>
        <Form
          key={name}
          initialValues={{ name }}
          mutation={rename}
          onSubmit={(values) =>
            rename.mutate(values, { onSuccess: (studio) => showToast(`The studio is now called ${studio.name}.`) })
          }
        >
          <Field name="name" label="Studio name" autoComplete="organization" />
          <Submit>Save studio name</Submit>
        </Form>
      </div>
    </Card>
  )
}

/** Who belongs to the studio, who is invited, the mails that wait, and the limits. */
export function StudioPage() {
  useTitle('Studio')
  const { data: me } = useQuery(meQuery)
  const [chosen, setChosen] = useState<string | null>(null)
  if (me === undefined) return <PageSkeleton />
  const studio = me.studios.find(({ id }) => id === chosen) ?? me.studios[0]
  if (studio === undefined) {
    return (
      <div className="page">
        <EmptyState level={1} head="You are not in a studio.">
          A studio’s producer can invite you by email, or you can create your own studio on the Account page.
        </EmptyState>
      </div>
    )
  }
  const isProducer = studio.roles.includes('producer')
  return (
    <div className="page">
      <div className="flex wrap items-end between gap-2-4 mb-4">
        <div>
          <h1>{studio.name}</h1>
          <p className="mid">
            {isProducer
              ? 'People, invitations, emails, calendar and limits.'
              : 'The people of the studio. Producers manage them.'}
          </p>
          {isProducer && (
            <Link className="link small" to="/studio/$studioId/security-log" params={{ studioId: studio.id }}>
              Security log
            </Link>
          )}
        </div>
        {me.studios.length > 1 && (
          <Segmented
            label="Studio"
            options={me.studios.map(({ id, name }) => ({ value: id, label: name }))}
            value={studio.id}
            onChange={setChosen}
          />
        )}
      </div>
      <div className={isProducer ? 'columns' : undefined}>
        <div className="stack">
          <PeopleCard key={studio.id} studioId={studio.id} meId={me.person.id} isProducer={isProducer} />
          {isProducer && <OutboxCard key={`outbox ${studio.id}`} studioId={studio.id} />}
        </div>
        {isProducer && (
          <div className="stack">
            <StudioNameCard key={studio.id} studio={studio} />
            <InvitationsCard key={`invitations ${studio.id}`} studioId={studio.id} />
            <CalendarCard key={`calendar ${studio.id}`} studioId={studio.id} />
            <InvoiceDetailsCard key={`invoices ${studio.id}`} studioId={studio.id} />
            <SignInProviderCard key={`provider ${studio.id}`} studioId={studio.id} />
            <SecondFactorRequirementCard key={`second factor ${studio.id}`} studioId={studio.id} />
            <MembersSeeCard key={`members see ${studio.id}`} studioId={studio.id} />
            <QuotasCard key={`quotas ${studio.id}`} studioId={studio.id} />
            <EraseCard to={`/erase/studios/${studio.id}`} title="Erase the studio" />
          </div>
        )}
      </div>
    </div>
  )
}
