import { Refusal } from './Refusal'

interface PageWaitProps {
  title: string
  /** The error of the page's query; while there is none, the page waits. */
  error: unknown
}

/** A page whose first answer is not here: it waits, or says why there is none. */
export function PageWait({ title, error }: PageWaitProps) {
  return (
    <div className="page stack" aria-busy={error === null}>
      <h1>{title}</h1>
      <Refusal error={error} />
    </div>
  )
}
