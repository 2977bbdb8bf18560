import classes from './Face.module.css'

/** Two letters in a circle for a person or a role: "Audio director" gives AD, "Producer" PR. */
export function Face({ name, filled = false }: { name: string; filled?: boolean }) {
  const words = name.trim().split(/\s+/)
  const letters = words.length > 1 ? words.slice(0, 2).map((word) => word.charAt(0)) : [name.trim().slice(0, 2)]
  return (
    <span className={filled ? `${classes.face} ${classes.filled}` : classes.face} aria-hidden="true">
      {letters.join('').toUpperCase()}
    </span>
  )
}
