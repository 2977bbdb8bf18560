import { Form, type FormProps } from '@/ui/Form'

import { DraftNote } from './DraftNote'
import { useDraft } from './useDraft'

interface DraftFormProps<V> extends Omit<FormProps<V>, 'values' | 'onValuesChange' | 'onSubmit' | 'resets'> {
  /** What the form is about: under it what was typed is kept until it is sent. */
  draftKey: string
  /** `onSent` forgets what was typed. */
  onSubmit: (values: V, onSent: () => void) => void
}

/** A form that keeps what was typed in this browser until it is sent. */
export function DraftForm<V extends object>({
  draftKey,
  initialValues,
  onSubmit,
  children,
  ...rest
}: DraftFormProps<V>) {
  const [values, setValues, draft] = useDraft(draftKey, initialValues)
  return (
    <Form
      {...rest}
      initialValues={initialValues}
      values={{ ...initialValues, ...values }}
      onValuesChange={setValues}
      onSubmit={(typed) => onSubmit(typed, draft.discard)}
    >
      {(typed, change) => (
        <>
          {draft.isRestored && (
            <div className="col-span-full">
              <DraftNote draft={draft} />
            </div>
          )}
          {typeof children === 'function' ? children(typed, change) : children}
        </>
      )}
    </Form>
  )
}
