import { Avatar } from './Avatar'
import classes from './Person.module.css'

interface PersonProps {
  name: string
  picture?: string | null
  /** What they are here: "approver", "designer". */
  role?: string
}

/** A person as they are named everywhere: their picture, their name, and what they are. */
export function Person({ name, picture, role }: PersonProps) {
  return (
    <span className={`inline-flex items-center gap-2 min-w-0 ${classes.person}`}>
      <Avatar name={name} picture={picture} />
      <span className={`flex wrap items-baseline min-w-0 ${classes.words}`}>
        <span className="cut-text">{name}</span>
        {role && <span className="small dim nowrap">{role}</span>}
      </span>
    </span>
  )
}
