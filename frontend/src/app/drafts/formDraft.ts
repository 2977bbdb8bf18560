import { keepDraft, keptDraft } from './store'

/** Return the first values of a form as they were typed before, and what keeps them until they are sent. No password is kept. */
export function formDraft<V extends Record<string, string | number>>(key: string, blank: V) {
  return {
    initialValues: { ...blank, ...keptDraft<Partial<V>>(key) },
    onValuesChange: (values: V) =>
      keepDraft(key, Object.fromEntries(Object.entries(values).filter(([name]) => name !== 'password'))),
  }
}
