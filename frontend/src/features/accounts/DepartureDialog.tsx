import { Checkbox } from '@mantine/core'
import { useState } from 'react'

import { Dialog } from '@/app/Dialog'
import type { OpenedProps } from '@/app/LazyDialog'
import { Button } from '@/ui/Button'
import { Row, Rows } from '@/ui/Rows'
import { Select } from '@/ui/Select'

import { type AccessKind, type DepartureItem, type Member, type Role, useDeparture, usePeople } from './api'
import { CardProblem } from './CardProblem'

const KINDS: Record<DepartureItem['kind'], string> = {
  approver: 'Approver of the project',
  signer: 'Signs for the studio',
  liaison: 'Audio lead of the project',
  category_approver: 'Approver of a category',
  deputy: 'Deputy',
  invitation: 'Invitation not accepted yet',
  token: 'Build token',
  guest_link: 'Guest link',
  posting_link: 'Link of a posting',
  webhook: 'Webhook',
  engagement: 'Engaged as a sound designer',
}

/** What the person made that works without their sign-in, and whether it goes on. */
const KEPT: { access: AccessKind; kind: DepartureItem['kind']; label: string; why: string }[] = [
  { access: 'tokens', kind: 'token', label: 'Keep their build tokens', why: 'they may still know them' },
  { access: 'guest_links', kind: 'guest_link', label: 'Keep their guest links', why: 'they may still know them' },
  {
    access: 'posting_links',
    kind: 'posting_link',
    label: 'Keep their links of postings',
    why: 'they may still know them',
  },
  { access: 'webhooks', kind: 'webhook', label: 'Keep their webhooks', why: 'see that each address is yours' },
]

export interface Departure {
  handOverTo: string | null
  keep: AccessKind[]
}

interface DepartureDialogProps extends OpenedProps {
  studioId: string
  meId: string
  member: Member
  /** The roles that the member keeps; none: they leave. */
  roles: Role[]
  error: unknown
  busy: boolean
  onConfirm: (departure: Departure) => void
}

/** What ends when a member leaves or has a lower role, and who takes over, before it happens. */
export function DepartureDialog(props: DepartureDialogProps) {
  const { studioId, meId, member, roles, error, busy, onConfirm, opened, onClose } = props
  const { data: items, error: unread } = useDeparture(studioId, member.person.id, roles)
  const { data: people = [] } = usePeople(studioId)
  const successors = people.filter(
    (other) =>
      other.person.id !== member.person.id && other.roles.some((role) => role === 'producer' || role === 'liaison'),
  )
  const [chosen, setChosen] = useState<string | null>(null)
  const [keep, setKeep] = useState<string[]>(['webhooks'])
  const successor = chosen ?? (successors.find(({ person }) => person.id === meId) ?? successors[0])?.person.id ?? ''
  const name = member.person.name
  const leaves = roles.length === 0
  const approves = items?.filter(({ kind }) => kind === 'approver') ?? []
  const signs = items?.filter(({ kind }) => kind === 'signer') ?? []
  const ends = items?.filter(({ kind }) => kind !== 'approver' && kind !== 'signer') ?? []
  return (
    <Dialog
      title={leaves ? `Remove ${name} from the studio` : `Change the roles of ${name}`}
      opened={opened}
      onClose={onClose}
    >
      <CardProblem error={unread ?? error} />
      {approves.length > 0 && (
        <>
          <p>
            {name} approves {approves.map((item) => item.name).join(', ')}.
          </p>
          <Select
            label="Who approves from now on"
            value={successor}
            onChange={(event) => setChosen(event.target.value)}
          >
            {successors.map(({ person }) => (
              <option key={person.id} value={person.id}>
                {person.name}
              </option>
            ))}
          </Select>
        </>
      )}
      {signs.length > 0 && (
        <p>
          {name} is named to sign{' '}
          {signs.map(({ name, project_name }) => (project_name ? `${name} of ${project_name}` : name)).join(', ')}.
          Recall each contract, name other signers and send it again first.
        </p>
      )}
      {ends.length > 0 && (
        <>
          <h3 id="departure-ends">{leaves ? 'What this membership gave' : 'What these roles do not allow'}</h3>
          <Rows aria-labelledby="departure-ends">
            {ends.map((item, place) => (
              <Row key={item.id ?? place}>
                <span className="grow">
                  <span className="wrap-anywhere">{item.kind === 'liaison' ? item.project_name : item.name}</span>
                  <br />
                  <span className="small mid">
                    {KINDS[item.kind]}
                    {item.kind !== 'liaison' && item.project_name ? `, ${item.project_name}` : ''}
                  </span>
                </span>
                <span className="small mid">{outcome(item, keep)}</span>
              </Row>
            ))}
          </Rows>
        </>
      )}
      {leaves && (
        <Checkbox.Group value={keep} onChange={setKeep} aria-label="What goes on in your name">
          <div className="grid gap-2 mt-1">
            {KEPT.filter(({ kind }) => ends.some((item) => item.kind === kind)).map(({ access, label, why }) => (
              <Checkbox key={access} value={access} size="sm" label={label} description={why} />
            ))}
          </div>
        </Checkbox.Group>
      )}
      {items !== undefined && ends.length === 0 && approves.length === 0 && signs.length === 0 && (
        <p className="mid">Nothing else ends with it.</p>
      )}
      <Button
        variant="primary"
        disabled={items === undefined || busy || signs.length > 0}
        onClick={() =>
          onConfirm({
            handOverTo: approves.length > 0 ? successor : null,
            keep: KEPT.map(({ access }) => access).filter((access) => keep.includes(access)),
          })
        }
      >
        {leaves ? 'Remove from the studio' : 'Change roles'}
      </Button>
    </Dialog>
  )
}

function outcome(item: DepartureItem, keep: string[]): string {
  if (item.kind === 'engagement') return 'goes on'
  const kept = KEPT.find(({ kind }) => kind === item.kind)
  if (kept === undefined) return 'ends'
  if (keep.includes(kept.access)) return 'goes on in your name'
  return item.kind === 'webhook' ? 'disabled' : 'revoked'
}
