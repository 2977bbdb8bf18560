import { Switch } from '@mantine/core'
import { useLocation } from '@tanstack/react-router'

import { Key } from '@/ui/Key'

import { Dialog } from '../Dialog'
import { useKeysSwitch, useListedHotkeys } from '../keys'
import { helpFor } from './help'
import classes from './KeysSheet.module.css'

/** Every key that works on this page, and the switch that turns single keys off. */
export function KeysSheet({ opened, onClose }: { opened: boolean; onClose: () => void }) {
  const hotkeys = useListedHotkeys().filter(({ unlisted, disabled }) => !unlisted && !disabled)
  const [on, setOn] = useKeysSwitch()
  const { pathname } = useLocation()
  const groups = new Map<string, typeof hotkeys>()
  for (const hotkey of hotkeys) {
    const group = hotkey.group ?? 'This page'
    groups.set(group, [...(groups.get(group) ?? []), hotkey])
  }
  return (
    <Dialog title="Keyboard shortcuts" opened={opened} onClose={onClose} size={620}>
      <div className={`grid ${classes.groups}`}>
        {[...groups].map(([group, keys]) => (
          <section key={group} aria-label={group}>
            <h3>{group}</h3>
            <dl className="mt-2">
              {keys.map(({ keys: key, label }) => (
                <div key={`${key} ${label}`} className={`grid items-center gap-2 ${classes.line}`}>
                  <dt>
                    <span className="visually-hidden">{key}</span>
                    <span className={`flex gap-1 ${classes.caps}`}>
                      <Key keys={key} />
                    </span>
                  </dt>
                  <dd>{label}</dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
      </div>
      <a className="link" href={helpFor(pathname)} target="_blank">
        Help on this page
      </a>
      <Switch
        mt="lg"
        checked={on}
        onChange={(event) => setOn(event.currentTarget.checked)}
        label="Single-key shortcuts"
        description="When off, only Escape and shortcuts with Ctrl or Cmd work."
      />
    </Dialog>
  )
}
