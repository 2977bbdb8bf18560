import { DraftForm } from '@/app/drafts/DraftForm'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ConfirmInline } from '@/ui/ConfirmInline'
import { Field, Submit } from '@/ui/Form'
import { shortDay, today } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'

import forms from '../Hiring.module.css'
import { type Entry, type Loan, useSetLoans } from './api'
import classes from './Roster.module.css'

/** The equipment that the studio lends to a designer, and when it goes back. */
export function LoansCard({ entry }: { entry: Entry }) {
  const save = useSetLoans(entry.id)
  const markReturned = (returned: Loan) =>
    save.mutate(entry.loans.map((loan) => (loan === returned ? { ...loan, returned_on: today() } : loan)))
  const remove = (removed: Loan) => save.mutate(entry.loans.filter((loan) => loan !== removed))
  return (
    <Card aria-labelledby="loans">
      <CardHead id="loans" title="Equipment on loan" count={entry.loans.filter(isLent).length || undefined} />
      <Rows>
        {entry.loans.map((loan, index) => (
          <Row key={index} className={classes.posting}>
            <div className="grow">
              <p>{loan.item}</p>
              <p className="small mid">
                lent {shortDay(loan.lent_on)}
                {loan.due_on && isLent(loan) && `, due back ${shortDay(loan.due_on)}`}
                {loan.returned_on && `, returned ${shortDay(loan.returned_on)}`}
              </p>
              {isOverdue(loan) && (
                <p className="small tone-warn">
                  <span className="toned">Overdue</span>
                </p>
              )}
            </div>
            {isLent(loan) ? (
              <Button
                aria-label={`Record that ${loan.item} is returned`}
                aria-busy={save.isPending}
                onClick={() => markReturned(loan)}
              >
                Returned
              </Button>
            ) : (
              <ConfirmInline
                key={entry.loans.length} // the rows below a removed one move up
                variant="quiet"
                action="Remove loan"
                about={loan.item}
                aria-label={`Remove ${loan.item}`}
                aria-busy={save.isPending}
                onConfirm={() => remove(loan)}
              >
                Remove
              </ConfirmInline>
            )}
          </Row>
        ))}
      </Rows>
      <div className={forms.body}>
        <AddLoan entry={entry} save={save} />
      </div>
    </Card>
  )
}

const isLent = ({ returned_on: returnedOn }: Loan) => !returnedOn
const isOverdue = (loan: Loan) => isLent(loan) && loan.due_on != null && loan.due_on < today()

function AddLoan({ entry, save }: { entry: Entry; save: ReturnType<typeof useSetLoans> }) {
  return (
    <DraftForm
      className={`grid items-end gap-3 ${classes.loan}`}
      aria-label="Lend equipment"
      draftKey={`roster-loan:${entry.id}`}
      initialValues={{ item: '', lent_on: today(), due_on: '' }}
      mutation={save}
      onSubmit={(loan, onSent) =>
        save.mutate([...entry.loans, { ...loan, due_on: loan.due_on || null, returned_on: null }], {
          onSuccess: () => {
            onSent()
            showToast('Loan recorded.')
          },
        })
      }
    >
      <Field name="item" label="Item" maxLength={120} />
      <Field name="lent_on" label="Lent on" type="date" />
      <Field optional name="due_on" label="Due back" type="date" />
      <Submit variant="plain" icon="plus">
        Lend
      </Submit>
    </DraftForm>
  )
}
