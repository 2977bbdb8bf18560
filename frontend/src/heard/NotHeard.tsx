import classes from './NotHeard.module.css'

/** Marks what the current person has not heard: by a dot, or by a dot and its words. */
export function NotHeard({ inWords = false }: { inWords?: boolean }) {
  return (
    <span className={`inline-flex items-center nowrap ${classes.mark}`} title="You have not heard it yet">
      <span className={`flex-none ${classes.dot}`} />
      <span className={inWords ? 'small mid' : 'visually-hidden'}>not heard yet</span>
    </span>
  )
}
